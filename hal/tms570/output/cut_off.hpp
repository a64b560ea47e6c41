// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_OUTPUT_CUT_OFF_HPP
#define HAL_TMS570_OUTPUT_CUT_OFF_HPP

namespace counterpoint::tms570
{

/// @brief What an exception does first: all pins of both ports low and inputs, both CAN controllers off the bus, nERROR
/// low. Needs no object, no memory but the stack, no lock. [SRS_TMS_052]
void CutOffEverything() noexcept;

} // namespace counterpoint::tms570

#endif
