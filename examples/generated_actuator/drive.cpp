// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "examples/generated_actuator/drive.hpp"

#include "actuator/object_dictionary.hpp"

namespace counterpoint::examples
{

// The gate says whether the data may be used at all; a bit that flipped in these variables since is found here.
bool Drive::MayMove(const SrdoMask open) noexcept
{
    const bool is_open = ((open >> actuator::kSrdo1Slot) & 1U) != 0U;
    const bool is_whole = (actuator::CompareReceivedCommandCommand() == PairView::kInverse) &&
                          (actuator::CompareReceivedCommandMode() == PairView::kInverse);
    return is_open && is_whole && (actuator::GetReceivedCommandCommand() == 1U) &&
           (actuator::GetReceivedCommandMode() == 1U);
}

} // namespace counterpoint::examples
