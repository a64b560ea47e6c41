// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/nmt/heartbeat_producer.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint32_t kUsPerMs = 1000U;

} // namespace

HeartbeatProducer::HeartbeatProducer(const NodeId node) noexcept
    : node_(node), period_ms_(0U), is_running_(false), sent_{0U}
{
}

void HeartbeatProducer::SetPeriod(const std::uint16_t period_ms) noexcept
{
    period_ms_ = period_ms;
    is_running_ = false;
}

std::uint16_t HeartbeatProducer::PeriodMs() const noexcept
{
    return period_ms_;
}

FrameToSend HeartbeatProducer::Poll(const NodeState state, const Instant now) noexcept
{
    const std::uint32_t period_us = period_ms_ * kUsPerMs;
    const std::uint32_t since_us = now.us - sent_.us;
    FrameToSend heartbeat{false, {}};
    if (StateByte(state) == 0U)
    {
        is_running_ = false; // After the boot-up message the period begins anew.
    }
    else if ((period_us > 0U) && (!is_running_ || (since_us >= period_us)))
    {
        heartbeat = FrameToSend{true, ErrorControlFrame(node_, StateByte(state))};
        const bool is_steady = is_running_ && (since_us < (2U * period_us));
        sent_.us = is_steady ? (sent_.us + period_us) : now.us;
        is_running_ = true;
    }
    return heartbeat;
}

} // namespace counterpoint::cia301
