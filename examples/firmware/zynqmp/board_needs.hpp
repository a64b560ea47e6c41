// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_FIRMWARE_ZYNQMP_BOARD_NEEDS_HPP
#define EXAMPLES_FIRMWARE_ZYNQMP_BOARD_NEEDS_HPP

#include "hal/zynqmp/can/can_ports.hpp"
#include "hal/zynqmp/output/gpio_registers.hpp"
#include "safety_core/contract/srdo.hpp"

#include <cstdint>

namespace counterpoint::firmware
{

/// What a device needs of a Zynq UltraScale+: identifiers that each controller receives, and its pins.
struct ZynqmpNeeds
{
    zynqmp::IdentifierList first;
    zynqmp::IdentifierList second; ///< Of a device with two controllers.
    zynqmp::BusLayout layout;
    std::uint32_t outputs; ///< Pins of the second bank that are outputs in series, the lowest for bit 0; the others are
                           ///< inputs.
    SrdoMask gates[zynqmp::gpio::kPins]; ///< By pin of the first bank; 0: no safety output.
};

/// @brief Each device has it in <device>_needs.cpp. The lists begin with NMT and the global fail-safe command.
[[nodiscard]] ZynqmpNeeds DescribeZynqmpNeeds() noexcept;

} // namespace counterpoint::firmware

#endif
