// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_DIFFERENTIAL_FLAWS_HPP
#define VERIFICATION_DIFFERENTIAL_FLAWS_HPP

#include "verification/differential/device.hpp"
#include "verification/differential/random.hpp"

namespace counterpoint::differential
{

/// @brief Makes wrong in the configuration of one SRDO, sound so far, what the flaw in its plan says.
void Spoil(Random& random, Device& device, SlotIndex slot) noexcept;

} // namespace counterpoint::differential

#endif
