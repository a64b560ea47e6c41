// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/bench/surroundings.hpp"

namespace counterpoint::bench
{

hal::CanGuarantees BenchPorts::Guarantees() const noexcept
{
    return {hal::Guarantee::kGiven, hal::Guarantee::kGiven, hal::Guarantee::kGiven};
}

hal::TransmitStatus BenchPorts::DoTransmit(const CanFrame& frame) noexcept
{
    frames_[written_ % kPlaces] = frame;
    ++written_;
    return hal::TransmitStatus::kAccepted;
}

CanFrame BenchPorts::Take() noexcept
{
    CanFrame frame{};
    if (read_ != written_)
    {
        frame = frames_[read_ % kPlaces];
        ++read_;
    }
    return frame;
}

std::uint32_t BenchOutput::Challenge() noexcept
{
    return gate_.Challenge();
}

void BenchOutput::Drive(const hal::PermitSet& permits) noexcept
{
    gate_.Drive(permits, now_);
}

void BenchOutput::Advance(const Instant now) noexcept
{
    now_ = now;
}

SrdoMask BenchOutput::Open() noexcept
{
    return gate_.Open(now_, hal::GateLimit{2U * kCycleUs});
}

hal::WatchdogQuestion BenchWatchdog::Question() noexcept
{
    return {question_};
}

void BenchWatchdog::Answer(const hal::WatchdogAnswer& answer) noexcept
{
    const std::uint32_t right = (hal::kFlowReference + question_) * hal::kWatchdogConstant;
    wrong_ += (answer.value == right) ? 0U : 1U;
    ++question_;
}

std::uint32_t BenchWatchdog::WrongAnswers() const noexcept
{
    return wrong_;
}

RefreshAnswer BenchApplication::OnRefresh(CommunicationIndex /*index*/) noexcept
{
    return RefreshAnswer::kReady;
}

void BenchApplication::OnSrdoEvent(CommunicationIndex /*index*/) noexcept
{
    ++events_;
}

void BenchApplication::OnSrdoError(CommunicationIndex /*index*/, SrdoCause /*cause*/) noexcept
{
    ++errors_;
}

void BenchApplication::OnGfc() noexcept
{
    ++errors_;
}

void BenchApplication::OnGfcNotFollowed() noexcept
{
    ++errors_;
}

void BenchApplication::OnConfigurationInvalid(CommunicationIndex /*index*/) noexcept
{
    ++errors_;
}

void BenchApplication::OnDeviceFault(const DeviceFaultReport& /*report*/) noexcept
{
    ++errors_;
}

void BenchApplication::OnFlow(const FlowCount& /*count*/) noexcept
{
}

std::uint32_t BenchApplication::Events() const noexcept
{
    return events_;
}

std::uint32_t BenchApplication::Errors() const noexcept
{
    return errors_;
}

} // namespace counterpoint::bench
