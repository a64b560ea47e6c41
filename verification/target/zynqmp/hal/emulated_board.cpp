// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/target/zynqmp/hal/emulated_board.hpp"

namespace counterpoint::target
{

using zynqmp::Outcome;

namespace
{

constexpr hal::GateLimit kGateLimit{1500U};
constexpr hal::WatchdogWindow kWindow{500U, 1600U};

} // namespace

Outcome EmulatedOutput::Start() noexcept
{
    gate_.Close();
    is_live_ = true;
    outputs = 0U;
    return Outcome::kDone;
}

Outcome EmulatedOutput::Examine() noexcept
{
    return is_live_ ? Outcome::kDone : Outcome::kFailed;
}

SrdoMask EmulatedOutput::Open() noexcept
{
    return is_live_ ? gate_.Open(clocks_.Now().a, kGateLimit) : 0U;
}

std::uint32_t EmulatedOutput::Inputs() noexcept
{
    return inputs;
}

void EmulatedOutput::SetOutputs(const std::uint32_t bits) noexcept
{
    outputs = is_live_ ? bits : 0U;
}

void EmulatedOutput::CutOff() noexcept
{
    is_live_ = false;
    outputs = 0U;
}

std::uint32_t EmulatedOutput::Challenge() noexcept
{
    return gate_.Challenge();
}

void EmulatedOutput::Drive(const hal::PermitSet& permits) noexcept
{
    gate_.Drive(permits, clocks_.Now().a);
}

Outcome EmulatedWatchdog::Start() noexcept
{
    timer_.Start(kWindow, clocks_.Now().a);
    return Outcome::kDone;
}

Outcome EmulatedWatchdog::Examine() noexcept
{
    timer_.Examine(clocks_.Now().a);
    return timer_.IsAlive() ? Outcome::kDone : Outcome::kFailed;
}

hal::WatchdogQuestion EmulatedWatchdog::Question() noexcept
{
    return timer_.Question();
}

void EmulatedWatchdog::Answer(const hal::WatchdogAnswer& answer) noexcept
{
    timer_.Answer(answer, clocks_.Now().a);
}

} // namespace counterpoint::target
