// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/sdo_server_port.hpp"

#include "canopen/cia301/service_table.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint16_t kObject = 0x1200U;
constexpr std::uint32_t kRequests = 0x600U;
constexpr std::uint32_t kAnswers = 0x580U;
constexpr std::uint8_t kHighestSub = 2U;
constexpr std::uint32_t kFrameBytes = 8U;

} // namespace

SdoServerPort::SdoServerPort(SdoServer& server, FrameSink& sink, const NodeId node) noexcept
    : server_(server), sink_(sink), node_(node), waiting_{SdoPresence::kNothing, {}}
{
}

void SdoServerPort::Reset(const NodeId node) noexcept
{
    static_cast<void>(server_.Close(SdoAbort::kDeviceState));
    waiting_.presence = SdoPresence::kNothing;
    node_ = node;
}

void SdoServerPort::OnFrame(const CanFrame& frame, const Moment& moment) noexcept
{
    const bool is_request = (frame.kind == FrameKind::kData) && (frame.identifier == (kRequests + node_.value));
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
    if (!IsAllowed(Service::kSdo, moment.state))
    {
        const SdoAnswer answer = server_.Close(SdoAbort::kDeviceState);
        if (answer.presence == SdoPresence::kFrame)
        {
            Put(answer);
        }
    }
    bool is_going = Flush();
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
        CanFrame frame{kAnswers + node_.value, FrameKind::kData, CanPortId::kFirst, 8U, {}};
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
    ObjectValue value{SdoAbort::kNone, kHighestSub, 1U};
    if (address.index != kObject)
    {
        value.abort = SdoAbort::kObjectUnknown;
    }
    else if (address.sub > kHighestSub)
    {
        value.abort = SdoAbort::kSubUnknown;
    }
    else if (address.sub > 0U)
    {
        value = ObjectValue{SdoAbort::kNone, ((address.sub == 1U) ? kRequests : kAnswers) + node_.value, 4U};
    }
    return value;
}

SdoAbort SdoServerPort::Store(const ObjectAddress& address, std::uint32_t) noexcept
{
    const SdoAbort abort = Fetch(address).abort;
    return (abort == SdoAbort::kNone) ? SdoAbort::kReadOnly : abort;
}

} // namespace counterpoint::cia301
