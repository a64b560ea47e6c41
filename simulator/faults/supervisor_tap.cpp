// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/faults/supervisor_tap.hpp"

#include <array>

// The linker's --wrap=SYMBOL leads every call of SYMBOL to __wrap_SYMBOL and gives the shipped function the name
// __real_SYMBOL. A member function takes its object as first argument (Itanium C++ ABI), so that plain functions with
// these names can stand in for it.

namespace counterpoint::simulator
{
namespace
{
/// A5h, a valid configuration, in each byte: see CycleInput::guard_token.
constexpr std::uint32_t kValidToken = 0xA5A5A5A5U;

thread_local SupervisorTap* active_tap = nullptr;
thread_local std::array<std::uint64_t, kPartCount> intercepted{};

} // namespace

Verdict RealCompare(Comparator& self, const Comparison& comparison) noexcept
    __asm__("__real__ZN12counterpoint10Comparator7CompareERKNS_10ComparisonE");
void RealFlowBegin(FlowMonitor& self) noexcept __asm__("__real__ZN12counterpoint11FlowMonitor5BeginEv");
void RealFlowMark(FlowMonitor& self, FlowStep step, const FlowEvidence& evidence) noexcept
    __asm__("__real__ZN12counterpoint11FlowMonitor4MarkENS_8FlowStepERKNS_12FlowEvidenceE");
hal::WatchdogAnswer RealFlowEnd(FlowMonitor& self, const hal::WatchdogQuestion& question) noexcept
    __asm__("__real__ZN12counterpoint11FlowMonitor3EndERKNS_3hal16WatchdogQuestionE");
std::uint32_t RealGuardCycle(ConfigurationGuard& self, std::uint32_t challenge, Instant now) noexcept
    __asm__("__real__ZN12counterpoint18ConfigurationGuard5CycleEjNS_7InstantE");

Verdict WrapCompare(Comparator& self, const Comparison& comparison) noexcept
    __asm__("__wrap__ZN12counterpoint10Comparator7CompareERKNS_10ComparisonE");
void WrapFlowBegin(FlowMonitor& self) noexcept __asm__("__wrap__ZN12counterpoint11FlowMonitor5BeginEv");
void WrapFlowMark(FlowMonitor& self, FlowStep step, const FlowEvidence& evidence) noexcept
    __asm__("__wrap__ZN12counterpoint11FlowMonitor4MarkENS_8FlowStepERKNS_12FlowEvidenceE");
hal::WatchdogAnswer WrapFlowEnd(FlowMonitor& self, const hal::WatchdogQuestion& question) noexcept
    __asm__("__wrap__ZN12counterpoint11FlowMonitor3EndERKNS_3hal16WatchdogQuestionE");
std::uint32_t WrapGuardCycle(ConfigurationGuard& self, std::uint32_t challenge, Instant now) noexcept
    __asm__("__wrap__ZN12counterpoint18ConfigurationGuard5CycleEjNS_7InstantE");

Verdict WrapCompare(Comparator& self, const Comparison& comparison) noexcept
{
    SupervisorTap* const tap = active_tap;
    return (tap == nullptr) ? RealCompare(self, comparison) : tap->Compare(self, comparison);
}

void WrapFlowBegin(FlowMonitor& self) noexcept
{
    SupervisorTap* const tap = active_tap;
    if (tap == nullptr)
    {
        RealFlowBegin(self);
        return;
    }
    tap->FlowBegin(self);
}

void WrapFlowMark(FlowMonitor& self, const FlowStep step, const FlowEvidence& evidence) noexcept
{
    SupervisorTap* const tap = active_tap;
    if (tap == nullptr)
    {
        RealFlowMark(self, step, evidence);
        return;
    }
    tap->FlowMark(self, step, evidence);
}

hal::WatchdogAnswer WrapFlowEnd(FlowMonitor& self, const hal::WatchdogQuestion& question) noexcept
{
    SupervisorTap* const tap = active_tap;
    return (tap == nullptr) ? RealFlowEnd(self, question) : tap->FlowEnd(self, question);
}

std::uint32_t WrapGuardCycle(ConfigurationGuard& self, const std::uint32_t challenge, const Instant now) noexcept
{
    SupervisorTap* const tap = active_tap;
    return (tap == nullptr) ? RealGuardCycle(self, challenge, now) : tap->GuardCycle(self, challenge, now);
}

SupervisorTap::SupervisorTap(PartFaults& faults) noexcept : faults_(faults)
{
}

SupervisorTap::Scope::Scope(SupervisorTap* const tap) noexcept
{
    active_tap = tap;
}

SupervisorTap::Scope::~Scope()
{
    active_tap = nullptr;
}

std::uint64_t SupervisorTap::Intercepted(const Part part) noexcept
{
    return intercepted[static_cast<std::size_t>(part)];
}

bool SupervisorTap::IsStill(const Part part) noexcept
{
    ++intercepted[static_cast<std::size_t>(part)];
    const PartCondition& condition = faults_.Condition(part);
    if (!condition.is_faulty)
    {
        return false;
    }
    if (condition.kind == FaultKind::kHung)
    {
        faults_.Hang(condition);
    }
    faults_.HasEffect(condition);
    return true;
}

Verdict SupervisorTap::Compare(Comparator& self, const Comparison& comparison) noexcept
{
    if (!IsStill(Part::kComparator))
    {
        verdict_ = RealCompare(self, comparison);
        return verdict_;
    }
    const FaultKind kind = faults_.Condition(Part::kComparator).kind;
    if (kind == FaultKind::kNotCalled)
    {
        return Verdict{};
    }
    if (kind == FaultKind::kAlwaysGood)
    {
        // Fresh echo and all: whatever channel A releases is agreed and matched.
        Verdict good{};
        good.agreement = {comparison.outcome_a->released, ~SrdoMask{0U}};
        good.start = comparison.outcome_a->due;
        good.newly_matched = comparison.outcome_a->fresh;
        good.echo = comparison.challenge;
        good.fault = DeviceFault::kNone;
        good.slot = kNoSlot;
        return good;
    }
    return verdict_;
}

void SupervisorTap::FlowBegin(FlowMonitor& self) noexcept
{
    if (!IsStill(Part::kFlowMonitor))
    {
        RealFlowBegin(self);
    }
}

void SupervisorTap::FlowMark(FlowMonitor& self, const FlowStep step, const FlowEvidence& evidence) noexcept
{
    if (!IsStill(Part::kFlowMonitor))
    {
        RealFlowMark(self, step, evidence);
    }
}

hal::WatchdogAnswer SupervisorTap::FlowEnd(FlowMonitor& self, const hal::WatchdogQuestion& question) noexcept
{
    if (!IsStill(Part::kFlowMonitor))
    {
        answer_ = RealFlowEnd(self, question);
        return answer_;
    }
    switch (faults_.Condition(Part::kFlowMonitor).kind)
    {
    case FaultKind::kNotCalled:
        return hal::WatchdogAnswer{0U};
    case FaultKind::kAlwaysGood:
        return hal::WatchdogAnswer{(hal::kFlowReference + question.value) * hal::kWatchdogConstant};
    default:
        return answer_;
    }
}

std::uint32_t SupervisorTap::GuardCycle(ConfigurationGuard& self, const std::uint32_t challenge,
                                        const Instant now) noexcept
{
    if (!IsStill(Part::kGuard))
    {
        token_ = RealGuardCycle(self, challenge, now);
        return token_;
    }
    switch (faults_.Condition(Part::kGuard).kind)
    {
    case FaultKind::kNotCalled:
        return 0U;
    case FaultKind::kAlwaysGood:
        return ((challenge << 8U) | (challenge >> 24U)) ^ kValidToken;
    default:
        return token_;
    }
}
} // namespace counterpoint::simulator
