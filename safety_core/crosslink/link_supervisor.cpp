// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/crosslink/link_supervisor.hpp"

namespace counterpoint
{
namespace
{

std::uint32_t Apart(const std::uint32_t left, const std::uint32_t right) noexcept
{
    return (left > right) ? (left - right) : (right - left);
}

} // namespace

void LinkSupervisor::Restart(const LinkConfig& config) noexcept
{
    *this = LinkSupervisor{};
    config_ = config;
    window_us_ = (config.clock_interval_us / 2U) - config.timeout_us;
    // The share of the tolerance that belongs to a window. One time-out is as good as `timeouts`-th of the interval,
    // and two of them are no part of a window. CheckLinkConfig has made sure that there are some.
    const std::uint32_t timeouts = config.clock_interval_us / (config.timeout_us + 1U);
    const std::uint32_t left_out_us = ((2U * config.clock_tolerance_us) + (timeouts - 1U)) / timeouts;
    tolerance_us_ = (config.clock_tolerance_us - left_out_us) / 2U;
    state_ = LinkState::kWaiting;
    finding_ = LinkFinding::kNone;
}

void LinkSupervisor::OnCompose(const std::uint32_t sequence) noexcept
{
    composed_sequence_ = sequence;
    composed_count_ += has_cycled_;
}

void LinkSupervisor::CountCorrupt() noexcept
{
    ++counts_.corrupt;
}

void LinkSupervisor::Lose(const LinkFinding finding) noexcept
{
    if (finding_ == LinkFinding::kNone)
    {
        finding_ = finding;
    }
    state_ = LinkState::kLost;
}

bool LinkSupervisor::IsNext(const LinkMessage& message) noexcept
{
    const std::uint32_t ahead = message.sequence - heard_sequence_;
    const bool is_next = ((ahead - 1U) >> 31U) == 0U;
    if (is_next)
    {
        counts_.lost += ahead - 1U;
    }
    else if (ahead == 0U)
    {
        ++counts_.repeated;
    }
    else
    {
        ++counts_.old;
    }
    return is_next;
}

// t (own clock)   echoed stamp        received        The message was composed between echoed stamp + hold and its
//                      |---hold---|....x.....|        reception; more hold than time is impossible, but for the drift.
// The first contact answers a message of this start: what answers an earlier one was said to this CPU as it was before.
bool LinkSupervisor::IsFresh(const LinkMessage& message, const Instant received) const noexcept
{
    const std::uint32_t age_us = received.us - message.echo.stamp.us;
    const bool is_possible = message.echo.hold_us <= (age_us + config_.stamp_tolerance_us);
    const bool is_answer =
        (state_ != LinkState::kWaiting) || ((composed_sequence_ - message.echo.sequence) < composed_count_);
    return (message.echo.heard == kHeard) && is_possible && is_answer && (age_us <= config_.timeout_us);
}

void LinkSupervisor::CompareClocks(const LinkMessage& message, const Instant received) noexcept
{
    const std::uint32_t own_us = received.us - reference_own_.us;
    const std::uint32_t peer_us = message.stamp.us - reference_peer_.us;
    if (Apart(own_us, peer_us) > tolerance_us_)
    {
        Lose(LinkFinding::kClock);
    }
    if (own_us >= window_us_)
    {
        reference_own_ = received;
        reference_peer_ = message.stamp;
    }
}

TakeResult LinkSupervisor::Take(const LinkMessage& message, const Instant received) noexcept
{
    const bool is_contact = state_ != LinkState::kWaiting;
    if (is_contact && (!IsNext(message)))
    {
        return TakeResult::kDiscarded;
    }
    heard_ = kHeard;
    heard_sequence_ = message.sequence;
    heard_stamp_ = message.stamp;
    heard_at_ = received;
    if (!IsFresh(message, received))
    {
        ++counts_.late;
        return TakeResult::kDiscarded;
    }
    if (!is_contact)
    {
        state_ = LinkState::kAlive;
        reference_own_ = received;
        reference_peer_ = message.stamp;
    }
    ++counts_.taken;
    echoed_ = message.echo.stamp;
    acknowledged_ = message.echo.sequence;
    const std::uint32_t age_us = received.us - message.echo.stamp.us;
    const std::uint32_t hold_us = (message.echo.hold_us < age_us) ? message.echo.hold_us : age_us;
    composed_ = Window{Instant{message.echo.stamp.us + hold_us}, received};
    CompareClocks(message, received);
    return TakeResult::kTaken;
}

void LinkSupervisor::Examine(const Instant now) noexcept
{
    has_cycled_ = 1U;
    if (IsAlive() && ((now.us - echoed_.us) > config_.timeout_us))
    {
        Lose(LinkFinding::kTimeout);
    }
}

LinkEcho LinkSupervisor::Echo(const Instant now) const noexcept
{
    return LinkEcho{heard_sequence_, heard_stamp_, now.us - heard_at_.us, heard_};
}

} // namespace counterpoint
