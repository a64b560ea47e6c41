// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_PORT_SKELETON_CLOCKS_HPP
#define EXAMPLES_PORT_SKELETON_CLOCKS_HPP

#include "hal/api/clocks.hpp"
#include "parts.hpp"
#include "safety_core/contract/time.hpp"

namespace port_skeleton
{

/// The two counters of microseconds.
class Clocks final : public counterpoint::hal::Clocks
{
  public:
    /// @brief CONTRACT. Both counters, read directly one after the other, interrupts off in between; called by the
    /// interrupt for stamps and by the loop for `now`. Each wraps at 2^32 us and nowhere else: divide a wider count,
    /// never a 32-bit one that has wrapped. Two sources: two oscillators, or one and a check of the other (clock
    /// comparator); a counter that is computed from the other one is none. `now` of a cycle is later than every stamp
    /// that was handed over before it.
    [[nodiscard]] counterpoint::InstantPair Now() noexcept override;

    /// @brief Change it to kThere with the body, and not before.
    [[nodiscard]] PartState State() const noexcept;
};

} // namespace port_skeleton

#endif
