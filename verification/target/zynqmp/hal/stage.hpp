// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TARGET_ZYNQMP_HAL_STAGE_HPP
#define VERIFICATION_TARGET_ZYNQMP_HAL_STAGE_HPP

#include "examples/firmware/common/device.hpp"
#include "verification/target/zynqmp/hal/emulated_board.hpp"

#include <cstdint>

/// What plays the rest of the machine for a device that runs on the emulated controllers. Each scenario is a file that
/// defines kScenario.
namespace counterpoint::target
{

/// The device with everything around it.
struct Stage
{
    zynqmp::Board& board;
    EmulatedOutput& output;
    EmulatedWatchdog& watchdog;
    const firmware::DrivenDevice& driven;
    zynqmp::CanPorts& peer; ///< Controller 1 as another node, where the device does not have it.
    std::uint32_t cycle;    ///< Cycles of 1 ms since the device was switched on.
};

struct Scenario
{
    zynqmp::IdentifierList heard; ///< By the peer; none: the device has both controllers.
    std::uint32_t cycles;
    void (*step)(Stage& stage) noexcept; ///< After each cycle.
};

/// @brief The scenario of this image.
[[nodiscard]] const Scenario& TheScenario() noexcept;

/// A frame of another node.
struct OtherFrame
{
    std::uint32_t identifier;
    std::uint8_t length;
    std::uint8_t data[2];
};

/// @brief Another node sends: the frame goes out by the controller at `base`, past the drivers, which keep their own
/// confirmations.
void SendPast(zynqmp::RegisterBase base, const OtherFrame& frame) noexcept;

/// @brief The state of an SRDO, by its number from 1 on.
[[nodiscard]] SrdoState StateOf(const Stage& stage, std::uint8_t srdo) noexcept;

} // namespace counterpoint::target

#endif
