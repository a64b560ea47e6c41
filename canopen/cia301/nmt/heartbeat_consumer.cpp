// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/nmt/heartbeat_consumer.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint32_t kUsPerMs = 1000U;
constexpr std::uint32_t kErrorControl = 0x700U;
constexpr std::uint32_t kReserved = 0xFF000000U;
constexpr std::uint32_t kLastNode = 127U;
constexpr std::uint32_t kLongestUs = 0x20000000U; ///< Without a look at the entries: far from a wrap of the time.

std::uint32_t NodeOf(const std::uint32_t config) noexcept
{
    return (config >> 16U) & 0xFFU;
}

std::uint32_t TimeUsOf(const std::uint32_t config) noexcept
{
    return (config & 0xFFFFU) * kUsPerMs;
}

bool IsActive(const std::uint32_t config) noexcept
{
    return (NodeOf(config) >= 1U) && (NodeOf(config) <= kLastNode) && (TimeUsOf(config) > 0U);
}

bool IsSameNode(const std::uint32_t one, const std::uint32_t other) noexcept
{
    return IsActive(one) && IsActive(other) && (NodeOf(one) == NodeOf(other));
}

bool IsState(const std::uint8_t byte) noexcept
{
    return (byte == 0U) || (byte == 4U) || (byte == 5U) || (byte == 127U);
}

} // namespace

HeartbeatConsumer::HeartbeatConsumer(const SupervisedNodes& room, HeartbeatListener& listener) noexcept
    : room_(room), listener_(listener), looked_{0U}, silent_us_(0U)
{
}

SdoAbort HeartbeatConsumer::Write(const std::uint8_t sub, const std::uint32_t value) noexcept
{
    bool is_twice = false;
    for (std::uint8_t i = 0U; i < room_.count; ++i)
    {
        is_twice = is_twice || ((i != (sub - 1U)) && IsSameNode(room_.nodes[i].config, value));
    }
    const SdoAbort abort = Judge(sub, value);
    return ((abort == SdoAbort::kNone) && is_twice) ? SdoAbort::kIncompatible : Load(sub, value);
}

SdoAbort HeartbeatConsumer::Load(const std::uint8_t sub, const std::uint32_t value) noexcept
{
    const SdoAbort abort = Judge(sub, value);
    if (abort == SdoAbort::kNone)
    {
        room_.nodes[sub - 1U] = SupervisedNode{value, Instant{0U}, 0U, false};
    }
    return abort;
}

void HeartbeatConsumer::EndLoad() noexcept
{
    for (std::uint8_t i = 1U; i < room_.count; ++i)
    {
        bool is_twice = false;
        for (std::uint8_t before = 0U; before < i; ++before)
        {
            is_twice = is_twice || IsSameNode(room_.nodes[before].config, room_.nodes[i].config);
        }
        if (is_twice)
        {
            room_.nodes[i] = SupervisedNode{};
        }
    }
}

/// Whether a value can be had there, whatever the others are.
SdoAbort HeartbeatConsumer::Judge(const std::uint8_t sub, const std::uint32_t value) const noexcept
{
    const bool is_there = (sub > 0U) && (sub <= room_.count);
    const SdoAbort abort = ((value & kReserved) != 0U) ? SdoAbort::kValueRange : SdoAbort::kNone;
    return is_there ? abort : SdoAbort::kSubUnknown;
}

std::uint32_t HeartbeatConsumer::Value(const std::uint8_t sub) const noexcept
{
    const bool is_there = (sub > 0U) && (sub <= room_.count);
    return is_there ? room_.nodes[sub - 1U].config : 0U;
}

void HeartbeatConsumer::OnFrame(const CanFrame& frame, const Instant now) noexcept
{
    const bool is_heartbeat = (frame.kind == FrameKind::kData) && (frame.length_bytes == 1U) && IsState(frame.data[0]);
    for (std::uint8_t i = 0U; is_heartbeat && (i < room_.count); ++i)
    {
        SupervisedNode& node = room_.nodes[i];
        if (IsActive(node.config) && (frame.identifier == (kErrorControl + NodeOf(node.config))))
        {
            Take(node, frame.data[0], now);
        }
    }
}

void HeartbeatConsumer::Take(SupervisedNode& node, const std::uint8_t state, const Instant now) noexcept
{
    HeartbeatEvent event = HeartbeatEvent::kInvalid;
    if (state == 0U)
    {
        event = HeartbeatEvent::kBootUp;
    }
    else if (!node.is_running)
    {
        event = HeartbeatEvent::kStarted;
    }
    else if (node.state != state)
    {
        event = HeartbeatEvent::kChanged;
    }
    node.is_running = (state != 0U);
    node.state = state;
    node.last = now;
    const std::uint32_t until_lost_us = (now.us - looked_.us) + TimeUsOf(node.config);
    silent_us_ = (until_lost_us < silent_us_) ? until_lost_us : silent_us_;
    if (event != HeartbeatEvent::kInvalid)
    {
        listener_.OnHeartbeat(NodeId{static_cast<std::uint8_t>(NodeOf(node.config))}, event, state);
    }
}

void HeartbeatConsumer::Poll(const Instant now) noexcept
{
    if ((now.us - looked_.us) > silent_us_)
    {
        Look(now);
    }
}

void HeartbeatConsumer::Look(const Instant now) noexcept
{
    looked_ = now;
    silent_us_ = kLongestUs;
    for (std::uint8_t i = 0U; i < room_.count; ++i)
    {
        SupervisedNode& node = room_.nodes[i];
        const std::uint32_t since_us = now.us - node.last.us;
        const std::uint32_t time_us = TimeUsOf(node.config);
        if (node.is_running && (since_us > time_us))
        {
            node.is_running = false;
            listener_.OnHeartbeat(NodeId{static_cast<std::uint8_t>(NodeOf(node.config))}, HeartbeatEvent::kLost,
                                  node.state);
        }
        else if (node.is_running && ((time_us - since_us) < silent_us_))
        {
            silent_us_ = time_us - since_us;
        }
        else
        {
            // Another one is lost earlier, or nobody is supervised here.
        }
    }
}

} // namespace counterpoint::cia301
