// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TARGET_ZYNQMP_HAL_BOARD_FAULTS_HPP
#define VERIFICATION_TARGET_ZYNQMP_HAL_BOARD_FAULTS_HPP

#include "hal/zynqmp/board.hpp"

namespace counterpoint::target
{

/// @brief One fault of each driver in turn, with a start before: the board tells it, closes and leaves the bus.
void TestBoardFaults(zynqmp::Counters& counters, const zynqmp::CanPortsSetup& can) noexcept;

} // namespace counterpoint::target

#endif
