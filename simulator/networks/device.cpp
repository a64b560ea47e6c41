// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/networks/device.hpp"

#include "canopen/device/safety_queue.hpp"

#include <memory>

namespace counterpoint::simulator
{
namespace
{
constexpr std::uint64_t kNsPerUs = 1000U;
constexpr ObjectAddress kSerialNumber{0x1018U, 4U};

runtime::NodeSettings SettingsOf(const NodeSetup& setup)
{
    runtime::NodeSettings settings;
    settings.dcf = setup.dcf;
    settings.node_id = setup.node_id;
    return settings;
}

/// Two connections; `kept` leads to the port after its owner has it.
std::unique_ptr<host::LiveBus> PortOf(SimulatedBus& bus, const NodeIndex node, SimulatedPort*& kept)
{
    auto port = std::make_unique<SimulatedPort>(bus, node);
    kept = port.get();
    return port;
}
} // namespace

SimulatedDevice::SimulatedDevice(const NodeIndex node, const NodeSetup& setup, SimulatedBus& bus,
                                 const std::uint64_t now_ns)
    : node_(node), setup_(setup), safety_(nullptr), services_(nullptr),
      ports_(PortOf(bus, node, safety_), PortOf(bus, node, services_)), out_(&nowhere_),
      report_(out_, runtime::ReportForm::kText, now_ns), device_(SettingsOf(setup), ports_, report_), start_ns_(now_ns),
      cycle_ns_(device_.Config().cycle_us * kNsPerUs), next_cycle_ns_(now_ns + cycle_ns_)
{
    static_cast<void>(device_.PowerOn(Now(now_ns), now_ns));
    static_cast<void>(device_.TakeRestart(now_ns));
    SetSerial();
}

/// Counters begin with the supply.
InstantPair SimulatedDevice::Now(const std::uint64_t now_ns) const noexcept
{
    const Instant now{static_cast<std::uint32_t>(((now_ns - start_ns_) / kNsPerUs) & 0xFFFFFFFFU)};
    return {now, now};
}

bool SimulatedDevice::HasFrames() const noexcept
{
    return safety_->HasFrames() || services_->HasFrames();
}

void SimulatedDevice::Take(const std::uint64_t now_ns)
{
    for (SimulatedPort* const port : {safety_, services_})
    {
        host::LiveFrame frame;
        while (port->Receive(frame))
        {
            const bool is_safety = device::IsSafetyIdentifier(frame.identifier);
            if (is_safety == (port == safety_) && frame.time_ns >= start_ns_)
            {
                device_.OnFrame(frame, CanPortId::kFirst, Now(frame.time_ns));
            }
        }
    }
    static_cast<void>(now_ns);
}

void SimulatedDevice::Run(const std::uint64_t now_ns)
{
    Take(now_ns);
    if (now_ns >= next_cycle_ns_)
    {
        device_.Cycle(Now(now_ns), now_ns);
        next_cycle_ns_ += cycle_ns_;
    }
    else
    {
        device_.Serve(Now(now_ns), now_ns);
    }
    if (device_.TakeRestart(now_ns))
    {
        next_cycle_ns_ = now_ns + cycle_ns_;
    }
    SetSerial(); // A reset, of communication too, brought back that of the DCF.
    device_.LookAtOutput(now_ns);
}

void SimulatedDevice::SetSerial()
{
    if (setup_.serial)
    {
        static_cast<void>(device_.Objects().WriteNumber(kSerialNumber, *setup_.serial, sizeof(std::uint32_t)));
    }
}

void SimulatedDevice::Acknowledge(const std::uint8_t srdo, const std::uint64_t now_ns)
{
    static_cast<void>(device_.Acknowledge(srdo, now_ns));
}

void SimulatedDevice::Store(const ObjectAddress& object, const std::uint32_t value)
{
    const cia301::Reading size = device_.Objects().SizeOf(object);
    static_cast<void>(device_.Objects().WriteNumber(object, value, size.size_bytes));
}
} // namespace counterpoint::simulator
