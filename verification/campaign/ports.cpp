// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The registers that the safety pins of a TMS570 reach, over plain memory.
#include "hal/tms570/output/gio_registers.hpp"
#include "safety_core/kernel/limits.hpp"
#include "verification/campaign/pins_output.hpp"

#include <stdexcept>

namespace counterpoint
{
namespace campaign
{
namespace
{
FlatPort* used_ports = nullptr;

/// A port by the address of one of its registers; null: no register of a port.
FlatPort* PortOf(const tms570::Register place, std::uint32_t& offset)
{
    constexpr tms570::RegisterBase kBases[] = {tms570::gio::kPortA, tms570::gio::kPortB};
    for (std::size_t port = 0U; port < 2U; ++port)
    {
        offset = place.address - kBases[port].address;
        if (offset <= tms570::gio::kPullDisable)
        {
            return &used_ports[port];
        }
    }
    return nullptr;
}
} // namespace

void UsePorts(FlatPort* const ports) noexcept
{
    used_ports = ports;
}

tms570::SafetyPinsSetup PinsOf(const DeviceConfig& config)
{
    if (config.srdo_count > tms570::gio::kPins)
    {
        throw std::runtime_error("a device with more SRDOs than a port has pins has no output of pins");
    }
    tms570::SafetyPinsSetup setup{tms570::gio::kPortA, {}, {LateCycleUs(config)}};
    for (std::size_t slot = 0U; slot < config.srdo_count; ++slot)
    {
        setup.pins[slot].slots = SrdoMask{1U} << slot;
    }
    return setup;
}

void RequireStarted(const tms570::Outcome outcome)
{
    if (outcome != tms570::Outcome::kDone)
    {
        throw std::runtime_error("the safety pins do not start");
    }
}
} // namespace campaign

namespace tms570
{
std::uint32_t Read(const Register place) noexcept
{
    std::uint32_t offset = 0U;
    const campaign::FlatPort* const port = campaign::PortOf(place, offset);
    if (port == nullptr)
    {
        return (place.address == gio::kBase.address) ? gio::kOutOfReset : 0U;
    }
    if (offset == gio::kDirection)
    {
        return port->direction;
    }
    return (offset == gio::kInput) ? (port->direction & port->output) : 0U;
}

void Write(const Register place, const std::uint32_t value) noexcept
{
    std::uint32_t offset = 0U;
    campaign::FlatPort* const port = campaign::PortOf(place, offset);
    if (port == nullptr)
    {
        return; // nERROR, and the controllers.
    }
    if (offset == gio::kDirection)
    {
        port->direction = value;
    }
    else if (offset == gio::kSet)
    {
        port->output |= value;
    }
    else if (offset == gio::kClear)
    {
        port->output &= ~value;
    }
    else
    {
        // Nothing else is needed.
    }
}
} // namespace tms570
} // namespace counterpoint
