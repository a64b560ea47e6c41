// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/sdo/server_port.hpp"

#include "canopen/cia301/objects/service_table.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint16_t kFirstObject = 0x1200U;
constexpr std::uint32_t kRequests = 0x600U;
constexpr std::uint32_t kAnswers = 0x580U;
constexpr std::uint8_t kHighestDefaultSub = 2U;
constexpr std::uint32_t kFrameBytes = 8U;

} // namespace

SdoServerPort::SdoServerPort(SdoServer& server, FrameSink& sink, const NodeId node) noexcept
    : server_(server), sink_(sink), number_{0U}, parameters_{kRequests + node.value, kAnswers + node.value, 0U},
      waiting_{SdoPresence::kNothing, {}}
{
}

SdoServerPort::SdoServerPort(SdoServer& server, FrameSink& sink, const SdoServerNumber number) noexcept
    : server_(server), sink_(sink), number_(number), parameters_{}, waiting_{SdoPresence::kNothing, {}}
{
}

bool SdoServerPort::Wants(const std::uint32_t identifier) const noexcept
{
    return IsOn(parameters_) && (identifier == parameters_.request);
}

bool SdoServerPort::Uses(const std::uint32_t identifier) const noexcept
{
    return HasIdentifier(parameters_, identifier);
}

void SdoServerPort::ResetCommunication(const NodeId node) noexcept
{
    static_cast<void>(server_.Close(SdoAbort::kDeviceState));
    waiting_.presence = SdoPresence::kNothing;
    const bool is_default = number_.value == 0U;
    parameters_ = is_default ? SdoParameters{kRequests + node.value, kAnswers + node.value, 0U} : SdoParameters{};
}

void SdoServerPort::OnFrame(const CanFrame& frame, const Moment& moment) noexcept
{
    const bool is_request = (frame.kind == FrameKind::kData) && Wants(frame.identifier);
    if (is_request && IsAllowed(Service::kSdo, moment.state))
    {
        SdoFrame request{};
        for (std::uint32_t i = 0U; i < kFrameBytes; ++i)
        {
            request.bytes[i] = frame.data[i];
        }
        // A client asks again only after an answer or a time-out: what still waits is of no use to it.
        const SdoAnswer answer = server_.OnFrame(request, frame.length_bytes, moment.now);
        if (answer.presence == SdoPresence::kFrame)
        {
            Put(answer);
        }
    }
}

void SdoServerPort::OnCycle(const Moment& moment) noexcept
{
    const bool is_allowed = IsAllowed(Service::kSdo, moment.state);
    if (!is_allowed)
    {
        const SdoAnswer answer = server_.Close(SdoAbort::kDeviceState);
        if (answer.presence == SdoPresence::kFrame)
        {
            Put(answer);
        }
    }
    bool is_going = Flush() && is_allowed;
    for (std::uint8_t i = 0U; is_going && (i < kMaxBlockSize); ++i)
    {
        const SdoAnswer answer = server_.Poll(moment.now);
        is_going = (answer.presence == SdoPresence::kFrame);
        if (is_going)
        {
            Put(answer);
            is_going = (waiting_.presence == SdoPresence::kNothing);
        }
    }
}

void SdoServerPort::Put(const SdoAnswer& answer) noexcept
{
    waiting_ = answer;
    static_cast<void>(Flush());
}

/// Whether nothing waits any more.
bool SdoServerPort::Flush() noexcept
{
    if (waiting_.presence == SdoPresence::kFrame)
    {
        CanFrame frame{parameters_.answer, FrameKind::kData, CanPortId::kFirst, 8U, {}};
        for (std::uint32_t i = 0U; i < kFrameBytes; ++i)
        {
            frame.data[i] = waiting_.frame.bytes[i];
        }
        waiting_.presence = sink_.Send(frame) ? SdoPresence::kNothing : SdoPresence::kFrame;
    }
    return waiting_.presence == SdoPresence::kNothing;
}

ObjectValue SdoServerPort::Fetch(const ObjectAddress& address) noexcept
{
    const bool is_default = number_.value == 0U;
    ObjectValue value{SdoAbort::kObjectUnknown, 0U, 1U};
    if (address.index == (kFirstObject + number_.value))
    {
        value = FetchSdo(parameters_, address.sub);
        value.abort = (is_default && (address.sub > kHighestDefaultSub)) ? SdoAbort::kSubUnknown : value.abort;
        value.value = (is_default && (address.sub == 0U)) ? kHighestDefaultSub : value.value;
    }
    return value;
}

// A transfer that is under way may be the one that carries the value: only a server that rests changes.
SdoAbort SdoServerPort::Store(const ObjectAddress& address, const std::uint32_t value) noexcept
{
    SdoAbort abort = Fetch(address).abort;
    if ((abort == SdoAbort::kNone) && (number_.value == 0U))
    {
        abort = SdoAbort::kReadOnly;
    }
    else if ((abort == SdoAbort::kNone) && server_.IsBusy())
    {
        abort = SdoAbort::kDeviceState;
    }
    else if (abort == SdoAbort::kNone)
    {
        abort = IsConfiguring() ? LoadSdo(parameters_, SdoSide::kServer, address.sub, value)
                                : StoreSdo(parameters_, SdoSide::kServer, address.sub, value);
    }
    else
    {
        // Not of this server.
    }
    return abort;
}

} // namespace counterpoint::cia301
