// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_ZYNQMP_OUTPUT_CUT_OFF_HPP
#define HAL_ZYNQMP_OUTPUT_CUT_OFF_HPP

namespace counterpoint::zynqmp
{

/// @brief All pins of the controller low and inputs. Needs nothing but the registers.
void CloseAllPins() noexcept;

/// @brief All pins as above, both CAN controllers off the bus.
void CutOffEverything() noexcept;

} // namespace counterpoint::zynqmp

#endif
