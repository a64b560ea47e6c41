// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/surroundings.hpp"

#include <algorithm>

namespace counterpoint::campaign
{
namespace
{
constexpr std::uint32_t kFirstSrdo = 0x1301U;
} // namespace

void TappedFlow::Mark(const FlowStep step, const FlowEvidence& evidence) noexcept
{
    monitor.Mark(step, evidence);
    const std::uint8_t number = static_cast<std::uint8_t>(static_cast<std::uint8_t>(step) - 1U);
    if (hook != nullptr && number < kFlowStepCount)
    {
        hook->At(static_cast<Phase>(static_cast<std::uint8_t>(Phase::kFirstStep) + number));
    }
}

hal::TransmitStatus FlatPorts::DoTransmit(const CanFrame& frame) noexcept
{
    if (count >= kMostOwnFrames)
    {
        return hal::TransmitStatus::kQueueFull;
    }
    frames[count] = OwnFrame{frame, now + frame_ns};
    ++count;
    ++sent;
    return hal::TransmitStatus::kAccepted;
}

void FlatPorts::MoveOn() noexcept
{
    const std::uint32_t waiting = count - std::min(confirmed, count);
    for (std::uint32_t index = 0U; index < waiting; ++index)
    {
        frames[index] = frames[confirmed + index];
    }
    std::fill(frames.begin() + waiting, frames.end(), OwnFrame{});
    count = waiting;
    confirmed = 0U;
}

RefreshAnswer FlatApplication::OnRefresh(const CommunicationIndex /*index*/) noexcept
{
    return RefreshAnswer::kReady;
}

void FlatApplication::OnSrdoEvent(const CommunicationIndex /*index*/) noexcept
{
}

void FlatApplication::OnSrdoError(const CommunicationIndex index, const SrdoCause cause) noexcept
{
    if (cause == SrdoCause::kWaitingPastSct)
    {
        return;
    }
    first_cause = (faulted == 0U) ? cause : first_cause;
    faulted |= SrdoMask{1U} << ((index.value - kFirstSrdo) % kMaxSrdoCount);
}

void FlatApplication::OnConfigurationInvalid(const CommunicationIndex index) noexcept
{
    OnSrdoError(index, SrdoCause::kInvalid);
}

void FlatApplication::OnDeviceFault(const DeviceFaultReport& report) noexcept
{
    device_fault = report.fault;
}
} // namespace counterpoint::campaign
