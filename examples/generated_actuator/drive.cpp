// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "examples/generated_actuator/drive.hpp"

#include "actuator/object_dictionary.hpp"

namespace counterpoint::examples
{

// The gate says whether the data may be used at all, and a bit that flipped in these variables since is found in the
// functions: elsewhere both answer the safe value, which is not 1.
bool Drive::MayMove(const SrdoMask open) noexcept
{
    return (actuator::GetReceivedCommandCommand(open) == 1U) && (actuator::GetReceivedCommandMode(open) == 1U);
}

} // namespace counterpoint::examples
