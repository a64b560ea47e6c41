// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TARGET_ZYNQMP_HAL_STANDING_TIME_HPP
#define VERIFICATION_TARGET_ZYNQMP_HAL_STANDING_TIME_HPP

namespace counterpoint::target
{

/// @brief From here on both counters read as they do now and are set up as before: their one oscillator stands. For an
/// image with standing_time.cpp, which takes the place of the register accesses.
void LetTimeStand() noexcept;

} // namespace counterpoint::target

#endif
