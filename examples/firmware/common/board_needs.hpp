// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_FIRMWARE_COMMON_BOARD_NEEDS_HPP
#define EXAMPLES_FIRMWARE_COMMON_BOARD_NEEDS_HPP

#include "hal/tms570/can/can_ports.hpp"
#include "hal/tms570/chip/variant.hpp"
#include "hal/tms570/output/gio_registers.hpp"
#include "safety_core/contract/srdo.hpp"

#include <cstdint>

namespace counterpoint::firmware
{

/// What a device needs of a TMS570: one message object for each identifier, and which slots open which pin of port A.
struct BoardNeeds
{
    const tms570::CanObject* objects;
    std::uint8_t object_count;
    std::uint8_t
        output_pins; ///< Pins of port B that are outputs in series, the lowest for bit 0; the others are inputs.
    SrdoMask gate_pins[tms570::gio::kPins]; ///< By pin of port A; 0: no safety output.
};

/// Identifiers that every device receives: NMT and the global fail-safe command. Two objects for each SRDO follow.
inline constexpr tms570::CanObject kNmtObject{0x000U, tms570::ObjectUse::kReceive};
inline constexpr tms570::CanObject kGfcObject{0x001U, tms570::ObjectUse::kReceive};

/// Pins of a device: outputs on port B in series with the gates on port A.
struct BoardPins
{
    std::uint8_t outputs;
    SrdoMask gates[tms570::gio::kPins];
};

/// @brief The needs of a device with these objects.
template <std::uint8_t kObjects>
[[nodiscard]] BoardNeeds NeedsOf(const tms570::CanObject (&objects)[kObjects], const BoardPins& pins) noexcept
{
    BoardNeeds needs{objects, kObjects, pins.outputs, {}};
    for (std::uint32_t pin = 0U; pin < tms570::gio::kPins; ++pin)
    {
        needs.gate_pins[pin] = pins.gates[pin];
    }
    return needs;
}

/// @brief Each device has it in board_needs.cpp.
[[nodiscard]] BoardNeeds DescribeNeeds() noexcept;

/// @brief The controller that the image is for: chosen by COUNTERPOINT_VARIANT when it is built.
[[nodiscard]] const tms570::Variant& TheVariant() noexcept;

} // namespace counterpoint::firmware

#endif
