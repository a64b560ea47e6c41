// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_B_ACKNOWLEDGE_HPP
#define CHANNEL_B_ACKNOWLEDGE_HPP

#include "safety_core/contract/srdo.hpp"

namespace counterpoint::channel_b
{

/// The acknowledge inputs of all slots. Their levels are known as high or as low; a slot that is both or neither is
/// corrupted, and nothing rises from there: no single flipped bit is an edge. [SRS_REL_005, SRS_CONS_024]
class Acknowledge
{
  public:
    /// @brief What the inputs read in this call; the slots whose level rises by it.
    [[nodiscard]] SrdoMask Follow(SrdoMask inputs) noexcept
    {
        const SrdoMask both_high = inputs & x_inputs;
        const SrdoMask both_low = ~(inputs | x_inputs);
        const SrdoMask rising = both_high & x_low & ~x_high;
        x_high = (x_high | both_high) & ~both_low;
        x_low = (x_low | both_low) & ~both_high;
        x_inputs = inputs;
        return rising;
    }

  private:
    SrdoMask x_inputs{~SrdoMask{0U}}; ///< Of the call before. What is 1 from the start is no edge.
    SrdoMask x_high{~SrdoMask{0U}};
    SrdoMask x_low{0U};
};

} // namespace counterpoint::channel_b

#endif
