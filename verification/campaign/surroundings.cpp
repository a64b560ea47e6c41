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

RefreshAnswer FlatApplication::OnRefresh(const CommunicationIndex index) noexcept
{
    return (provider == nullptr) ? RefreshAnswer::kSkip : provider->Provide(index);
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
    Told told = Now();
    told.first_cause = (told.faulted == 0U) ? cause : told.first_cause;
    told.faulted |= SrdoMask{1U} << ((index.value - kFirstSrdo) % kMaxSrdoCount);
    Keep(told);
}

void FlatApplication::OnConfigurationInvalid(const CommunicationIndex index) noexcept
{
    OnSrdoError(index, SrdoCause::kInvalid);
}

void FlatApplication::OnDeviceFault(const DeviceFaultReport& report) noexcept
{
    Told told = Now();
    told.device_fault = report.fault;
    Keep(told);
}

void FlatApplication::ForgetErrors() noexcept
{
    Told told = Now();
    told.faulted = 0U;
    told.first_cause = SrdoCause::kNone;
    Keep(told);
}

void FlatApplication::Keep(const Told& told) noexcept
{
    copies.fill(told);
}

bool operator==(const Told& left, const Told& right) noexcept
{
    return left.faulted == right.faulted && left.first_cause == right.first_cause &&
           left.device_fault == right.device_fault;
}

Told MajorityOf(const ToldCopies& copies) noexcept
{
    return (copies[0] == copies[1]) ? copies[0] : copies[2];
}
} // namespace counterpoint::campaign
