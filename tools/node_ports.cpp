// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/node_ports.hpp"

#include "canopen/device/safety_queue.hpp"

#include <utility>

namespace counterpoint::tools
{
namespace
{
constexpr std::uint32_t kRestartAfterMs = 200U;
constexpr std::uint32_t kOneIdentifier = 0x7FFU;
constexpr std::uint32_t kBlockOf128 = 0x780U;

host::LiveOptions OptionsOfServices()
{
    return {host::RestartPolicy::kTimed, kRestartAfterMs, {}};
}

/// 001h, 100h to 17Fh, 180h: whole powers of two; the device leaves out 100h.
host::LiveOptions OptionsOfSafety()
{
    host::LiveOptions options = OptionsOfServices();
    options.filters = {{kGfcIdentifier, kOneIdentifier, false},
                       {kFirstSrdoIdentifier - 1U, kBlockOf128, false},
                       {kLastSrdoIdentifier, kOneIdentifier, false}};
    return options;
}
} // namespace

NodePorts::NodePorts(const std::string& address)
    : safety_(host::OpenLiveBus(address, OptionsOfSafety())), services_(host::OpenLiveBus(address, OptionsOfServices()))
{
}

NodePorts::NodePorts(std::unique_ptr<host::LiveBus> safety, std::unique_ptr<host::LiveBus> services) noexcept
    : safety_(std::move(safety)), services_(std::move(services))
{
}

hal::CanGuarantees NodePorts::Guarantees() const noexcept
{
    return {hal::Guarantee::kGiven, hal::Guarantee::kGiven, hal::Guarantee::kGiven};
}

hal::TransmitStatus NodePorts::DoTransmit(const CanFrame& frame) noexcept
{
    const bool is_safety = device::IsSafetyIdentifier(frame.identifier);
    if (frame.port != CanPortId::kFirst || (is_safety && has_ended_))
    {
        return hal::TransmitStatus::kRefused;
    }
    switch ((is_safety ? *safety_ : *services_).Send(host::FromCanFrame(frame)))
    {
    case host::SendResult::kSent:
        return hal::TransmitStatus::kAccepted;
    case host::SendResult::kBusOff:
        return hal::TransmitStatus::kBusOff;
    case host::SendResult::kQueueFull:
    case host::SendResult::kDown:
        return hal::TransmitStatus::kQueueFull;
    case host::SendResult::kRefused:
    case host::SendResult::kInvalid:
        break;
    }
    return hal::TransmitStatus::kRefused;
}
} // namespace counterpoint::tools
