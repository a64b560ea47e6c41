// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_OUTPUT_CUT_OFF_HPP
#define HAL_TMS570_OUTPUT_CUT_OFF_HPP

namespace counterpoint::tms570
{

/// @brief All pins of both ports low and inputs, so that no later write of an output is seen. Needs no object. A board
/// that uses pins of these ports for anything else loses them as well. [SRS_TMS_026]
void CloseAllPins() noexcept;

/// @brief What an exception does first: all pins of both ports low and inputs, both CAN controllers off the bus, nERROR
/// low. Needs no object, no memory but the stack, no lock. [SRS_TMS_052]
void CutOffEverything() noexcept;

} // namespace counterpoint::tms570

#endif
