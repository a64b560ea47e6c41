// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/pins_output.hpp"

#include <cstddef>

namespace counterpoint::campaign
{
namespace
{
using tms570::SafetyPins;

/// The members of the shipped pins, which are private: as in kernel_places.cpp.
struct PinsShape
{
    const void* output_functions;
    const void* cut_off_functions;
    const void* clocks;
    tms570::SafetyPinsSetup setup;
    struct
    {
        std::uint32_t port_address;
        SrdoMask slots[tms570::gio::kPins];
        std::uint32_t limit_us;
    } copy;
    hal::OutputGate gate;
    std::uint32_t driven;
    std::uint32_t driven_copy;
    std::uint32_t live;
};
static_assert(sizeof(PinsShape) == sizeof(SafetyPins), "the members of the pins");

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Winvalid-offsetof"
constexpr PinsMember kMembers[] = {
    {"pins.clocks", offsetof(PinsShape, clocks), sizeof(PinsShape::clocks)},
    {"pins.setup", offsetof(PinsShape, setup), sizeof(PinsShape::setup)},
    {"pins.copy", offsetof(PinsShape, copy), sizeof(PinsShape::copy)},
    {"pins.gate", offsetof(PinsShape, gate), sizeof(PinsShape::gate)},
    {"pins.driven", offsetof(PinsShape, driven), sizeof(PinsShape::driven)},
    {"pins.driven_copy", offsetof(PinsShape, driven_copy), sizeof(PinsShape::driven_copy)},
    {"pins.live", offsetof(PinsShape, live), sizeof(PinsShape::live)},
};
#pragma GCC diagnostic pop
} // namespace

FlatOutput& MakePinsOutput(Region& region, const DeviceConfig& config, std::vector<Place>& places)
{
    return MakePins<SafetyPins>(region, config, kMembers, places);
}
} // namespace counterpoint::campaign
