// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/nmt/node_guarding.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint64_t kUsPerMs = 1000U;
constexpr std::uint32_t kErrorControl = 0x700U;
constexpr std::uint8_t kToggle = 0x80U;

} // namespace

NodeGuarding::NodeGuarding(const NodeId node) noexcept
    : node_(node), life_us_(0U), silence_us_(0U), last_{0U}, toggle_(0U), is_guarded_(false), is_lost_(false)
{
}

void NodeGuarding::SetLifeTime(const std::uint16_t guard_time_ms, const std::uint8_t factor) noexcept
{
    life_us_ = (kUsPerMs * guard_time_ms) * factor;
    is_guarded_ = false;
    is_lost_ = false;
}

void NodeGuarding::Reset() noexcept
{
    toggle_ = 0U;
    is_guarded_ = false;
    is_lost_ = false;
}

GuardReply NodeGuarding::OnFrame(const CanFrame& frame, const GuardMoment& moment) noexcept
{
    GuardReply answer{{false, {}}, GuardEvent::kNone};
    const std::uint8_t state = StateByte(moment.state);
    const bool is_request = (frame.kind == FrameKind::kRemote) && (frame.identifier == (kErrorControl + node_.value));
    if (is_request && (moment.heartbeat_ms == 0U) && (state != 0U))
    {
        answer.reply = FrameToSend{true, ErrorControlFrame(node_, static_cast<std::uint8_t>(toggle_ | state))};
        answer.event = is_lost_ ? GuardEvent::kResumed : GuardEvent::kNone;
        toggle_ ^= kToggle;
        silence_us_ = 0U;
        last_ = moment.now;
        is_guarded_ = true;
        is_lost_ = false;
    }
    return answer;
}

GuardEvent NodeGuarding::Poll(const GuardMoment& moment) noexcept
{
    GuardEvent event = GuardEvent::kNone;
    silence_us_ += moment.now.us - last_.us;
    last_ = moment.now;
    if (moment.heartbeat_ms != 0U)
    {
        // Remote frames have no answer now: a master that stops to ask is not lost.
        is_guarded_ = false;
        is_lost_ = false;
    }
    if (is_guarded_ && (life_us_ > 0U) && (silence_us_ > life_us_))
    {
        event = is_lost_ ? GuardEvent::kNone : GuardEvent::kLost;
        is_lost_ = true;
    }
    return event;
}

} // namespace counterpoint::cia301
