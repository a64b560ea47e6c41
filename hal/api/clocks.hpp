// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_API_CLOCKS_HPP
#define HAL_API_CLOCKS_HPP

#include "safety_core/contract/time.hpp"

namespace counterpoint::hal
{

/// Two counters of microseconds from independent sources, modular. The executive that calls the kernel reads them; the
/// kernel does not.
class Clocks
{
  public:
    /// @brief Both counters, read directly one after the other.
    [[nodiscard]] virtual InstantPair Now() noexcept = 0;

    Clocks(const Clocks&) = delete;
    Clocks(Clocks&&) = delete;
    Clocks& operator=(const Clocks&) = delete;
    Clocks& operator=(Clocks&&) = delete;

  protected:
    Clocks() noexcept = default;
    ~Clocks() noexcept = default;
};

} // namespace counterpoint::hal

#endif
