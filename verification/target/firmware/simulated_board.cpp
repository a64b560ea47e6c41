// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/target/firmware/simulated_board.hpp"

namespace counterpoint::target
{
namespace
{

// As the devices of the simulator have them, for a cycle of 1 ms with a tolerance of 0.5 ms.
constexpr hal::GateLimit kGateLimit{1500U};
constexpr hal::WatchdogWindow kWindow{500U, 1600U};

} // namespace

hal::CanGuarantees SimulatedCan::Guarantees() const noexcept
{
    return {hal::Guarantee::kGiven, hal::Guarantee::kGiven, hal::Guarantee::kGiven};
}

hal::TransmitStatus SimulatedCan::DoTransmit(const CanFrame& frame) noexcept
{
    if (is_bus_off_)
    {
        return hal::TransmitStatus::kBusOff;
    }
    if ((written_ - read_) == kPlaces)
    {
        return hal::TransmitStatus::kQueueFull;
    }
    frames_[written_ % kPlaces] = frame;
    last_ = frame;
    ++written_;
    return hal::TransmitStatus::kAccepted;
}

CanFrame SimulatedCan::Waiting() const noexcept
{
    return (read_ == written_) ? CanFrame{} : frames_[read_ % kPlaces];
}

void SimulatedCan::Confirm() noexcept
{
    ++read_;
}

void SimulatedCan::SetBusOff(const bool is_off) noexcept
{
    is_bus_off_ = is_off;
    read_ = written_;
}

std::uint32_t SimulatedCan::Sent() const noexcept
{
    return written_;
}

const CanFrame& SimulatedCan::Last() const noexcept
{
    return last_;
}

std::uint32_t SimulatedOutput::Challenge() noexcept
{
    return gate_.Challenge();
}

void SimulatedOutput::Drive(const hal::PermitSet& permits) noexcept
{
    gate_.Drive(permits, now_);
}

void SimulatedOutput::SetTime(const Instant now) noexcept
{
    now_ = now;
}

SrdoMask SimulatedOutput::Open() noexcept
{
    return gate_.Open(now_, kGateLimit);
}

void SimulatedWatchdog::Start(const Instant now) noexcept
{
    timer_.Start(kWindow, now);
}

void SimulatedWatchdog::SetTime(const Instant now) noexcept
{
    now_ = now;
    timer_.Examine(now);
}

hal::WatchdogQuestion SimulatedWatchdog::Question() noexcept
{
    return timer_.Question();
}

void SimulatedWatchdog::Answer(const hal::WatchdogAnswer& answer) noexcept
{
    timer_.Answer(answer, now_);
}

bool SimulatedWatchdog::IsAlive() const noexcept
{
    return timer_.IsAlive();
}

} // namespace counterpoint::target
