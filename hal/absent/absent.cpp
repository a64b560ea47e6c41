// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/absent/absent.hpp"

namespace counterpoint::hal
{

namespace
{

/// Even: a challenge that starts at 1 stays odd and is therefore never 0.
constexpr std::uint32_t kChallengeStep = 2U;
constexpr std::uint32_t kLowestBit = 1U;

} // namespace

CanGuarantees AbsentCanPorts::Guarantees() const noexcept
{
    return CanGuarantees{Guarantee::kAbsent, Guarantee::kAbsent, Guarantee::kAbsent};
}

TransmitStatus AbsentCanPorts::DoTransmit(const CanFrame& frame) noexcept
{
    static_cast<void>(frame);
    return TransmitStatus::kRefused;
}

std::uint32_t AbsentSafetyOutput::Challenge() noexcept
{
    challenge_ = (challenge_ + kChallengeStep) | kLowestBit;
    return challenge_;
}

void AbsentSafetyOutput::Drive(const PermitSet& permits) noexcept
{
    static_cast<void>(permits);
}

SrdoMask AbsentSafetyOutput::Open() const noexcept
{
    return 0U;
}

WatchdogQuestion AbsentWatchdog::Question() noexcept
{
    return WatchdogQuestion{0U};
}

void AbsentWatchdog::Answer(const WatchdogAnswer& answer) noexcept
{
    static_cast<void>(answer);
}

bool AbsentWatchdog::IsAlive() const noexcept
{
    return false;
}

ProtectStatus AbsentMemoryProtection::Protect(const MemoryRegion& region) noexcept
{
    static_cast<void>(region);
    return ProtectStatus::kAbsent;
}

void AbsentMemoryProtection::Enter(const MemoryOwner owner) noexcept
{
    static_cast<void>(owner);
}

std::uint32_t AbsentParameterMemory::BankBytes() const noexcept
{
    return 0U;
}

MemoryStatus AbsentParameterMemory::Status() noexcept
{
    return MemoryStatus::kFailed;
}

void AbsentParameterMemory::Erase(const MemoryBank /*bank*/) noexcept
{
}

void AbsentParameterMemory::Program(const MemorySection& /*section*/, const std::uint8_t* const /*from*/) noexcept
{
}

bool AbsentParameterMemory::Read(const MemorySection& /*section*/, std::uint8_t* const /*to*/) noexcept
{
    return false;
}

} // namespace counterpoint::hal
