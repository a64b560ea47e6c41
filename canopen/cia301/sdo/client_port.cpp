// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/sdo/client_port.hpp"

#include "canopen/cia301/objects/service_table.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint16_t kFirstObject = 0x1280U;
constexpr std::uint32_t kErrorControl = 0x700U;
constexpr std::uint8_t kBootUp = 0U;

} // namespace

SdoClientPort::SdoClientPort(const SdoClientPortParts& parts) noexcept
    : index_(static_cast<std::uint16_t>(kFirstObject + parts.number)), parameters_{},
      client_(SdoClientParts{parts.sink, NodeId{0U}, parts.time_out_us, parts.block_size})
{
}

bool SdoClientPort::IsConnected() const noexcept
{
    return IsOn(parameters_);
}

NodeId SdoClientPort::Server() const noexcept
{
    return NodeId{parameters_.partner};
}

SdoClient& SdoClientPort::Client() noexcept
{
    return client_;
}

bool SdoClientPort::Wants(const std::uint32_t identifier) const noexcept
{
    return IsOn(parameters_) && (identifier == parameters_.answer);
}

bool SdoClientPort::Uses(const std::uint32_t identifier) const noexcept
{
    return HasIdentifier(parameters_, identifier);
}

void SdoClientPort::ResetCommunication(NodeId) noexcept
{
    client_.OnServerRestart(); // Nothing is sent to a server of before.
    parameters_ = SdoParameters{};
}

void SdoClientPort::OnFrame(const CanFrame& frame, const Moment& moment) noexcept
{
    const bool is_boot_up = (frame.kind == FrameKind::kData) && (parameters_.partner != 0U) &&
                            (frame.identifier == (kErrorControl + parameters_.partner)) && (frame.length_bytes == 1U) &&
                            (frame.data[0] == kBootUp);
    if (is_boot_up)
    {
        client_.OnServerRestart();
    }
    else if (IsOn(parameters_) && IsAllowed(Service::kSdo, moment.state))
    {
        client_.OnFrame(frame, moment.now);
    }
    else
    {
        // No connection, or no SDO in this state.
    }
}

void SdoClientPort::OnCycle(const Moment& moment) noexcept
{
    const bool is_allowed = IsAllowed(Service::kSdo, moment.state);
    client_.Hold(!is_allowed);
    if (!is_allowed)
    {
        client_.Cancel(SdoAbort::kDeviceState);
    }
    client_.OnCycle(moment.now);
}

ObjectValue SdoClientPort::Fetch(const ObjectAddress& address) noexcept
{
    ObjectValue value{SdoAbort::kObjectUnknown, 0U, 1U};
    if (address.index == index_)
    {
        value = FetchSdo(parameters_, address.sub);
    }
    return value;
}

// A transfer that is under way goes on with the server that it has; its object does not change meanwhile.
SdoAbort SdoClientPort::Store(const ObjectAddress& address, const std::uint32_t value) noexcept
{
    SdoAbort abort = Fetch(address).abort;
    if ((abort == SdoAbort::kNone) && (client_.State() == SdoClientState::kBusy))
    {
        abort = SdoAbort::kDeviceState;
    }
    else if (abort == SdoAbort::kNone)
    {
        abort = IsConfiguring() ? LoadSdo(parameters_, SdoSide::kClient, address.sub, value)
                                : StoreSdo(parameters_, SdoSide::kClient, address.sub, value);
        const SdoConnection connection{parameters_.request, parameters_.answer, NodeId{parameters_.partner}};
        static_cast<void>(client_.Connect(connection));
    }
    else
    {
        // Not of this client.
    }
    return abort;
}

} // namespace counterpoint::cia301
