// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/faults/output_tap.hpp"

#include "simulator/faults/right_response.hpp"

#include <utility>

namespace counterpoint::simulator
{
OutputTap::OutputTap(hal::SafetyOutput& real, PartFaults& faults) noexcept : real_(real), faults_(faults)
{
}

std::uint32_t OutputTap::Challenge() noexcept
{
    const std::uint32_t fresh = real_.Challenge();
    issued_ = fresh;
    const PartCondition& condition = faults_.Condition(Part::kChallenge);
    if (!condition.is_faulty)
    {
        challenge_ = fresh;
        return fresh;
    }
    faults_.HasEffect(condition);
    return challenge_;
}

Permit OutputTap::Spoiled(const Part part, const Permit& given, const Permit& before) noexcept
{
    const PartCondition& condition = faults_.Condition(part);
    if (!condition.is_faulty)
    {
        return given;
    }
    faults_.HasEffect(condition);
    if (condition.how == Wrongness::kWrong)
    {
        return {given.mask, given.response ^ 1U};
    }
    return (condition.how == Wrongness::kOld) ? before : Permit{0U, 0U};
}

void OutputTap::Drive(const hal::PermitSet& permits) noexcept
{
    const hal::PermitSet before = std::exchange(permits_, permits);
    const hal::PermitSet given{Spoiled(Part::kPermitA, permits.a, before.a),
                               Spoiled(Part::kPermitB, permits.b, before.b),
                               Spoiled(Part::kPermitKernel, permits.kernel, before.kernel)};
    real_.Drive(faults_.Condition(Part::kOutputGate).is_faulty ? Accepted(given) : given);
}

hal::PermitSet OutputTap::Accepted(const hal::PermitSet& given) noexcept
{
    const hal::PermitSet right{{given.a.mask, RightResponse(given.a.mask, issued_, kPermitConstantA)},
                               {given.b.mask, RightResponse(given.b.mask, issued_, kPermitConstantB)},
                               {given.kernel.mask, RightResponse(given.kernel.mask, issued_, kPermitConstantKernel)}};
    const bool differs = right.a.response != given.a.response || right.b.response != given.b.response ||
                         right.kernel.response != given.kernel.response;
    if (differs)
    {
        faults_.HasEffect(faults_.Condition(Part::kOutputGate));
    }
    return right;
}

hal::ProbeAnswer OutputTap::Probe(const hal::PermitSet& permits, const std::uint32_t challenge) const noexcept
{
    const PartCondition& condition = faults_.Condition(Part::kOutputGate);
    const hal::ProbeAnswer answer = real_.Probe(permits, challenge);
    if (!condition.is_faulty || answer == hal::ProbeAnswer::kAccepted)
    {
        return answer;
    }
    faults_.HasEffect(condition);
    return hal::ProbeAnswer::kAccepted;
}

WatchdogTap::WatchdogTap(hal::Watchdog& real, PartFaults& faults) noexcept : real_(real), faults_(faults)
{
}

hal::WatchdogQuestion WatchdogTap::Question() noexcept
{
    const PartCondition& condition = faults_.Condition(Part::kQuestion);
    if (!condition.is_faulty)
    {
        question_ = real_.Question();
        return question_;
    }
    if (real_.Question().value != question_.value)
    {
        faults_.HasEffect(condition);
    }
    return question_;
}

void WatchdogTap::Answer(const hal::WatchdogAnswer& answer) noexcept
{
    const PartCondition& condition = faults_.Condition(Part::kWatchdog);
    hal::WatchdogAnswer given = answer;
    int times = 1;
    if (condition.is_faulty)
    {
        faults_.HasEffect(condition);
        given.value = (condition.how == Wrongness::kOld) ? before_.value : given.value;
        given.value ^= (condition.how == Wrongness::kWrong) ? 1U : 0U;
        times = (condition.how == Wrongness::kMissing) ? 0 : ((condition.how == Wrongness::kTwice) ? 2 : 1);
    }
    before_ = answer;
    for (; times > 0; --times)
    {
        Give(given);
    }
}

hal::WatchdogAnswer WatchdogTap::Right() noexcept
{
    return {(hal::kFlowReference + real_.Question().value) * hal::kWatchdogConstant};
}

void WatchdogTap::Give(const hal::WatchdogAnswer& answer) noexcept
{
    const PartCondition& condition = faults_.Condition(Part::kWatchdogChip);
    answered_ = faults_.Now();
    if (!condition.is_faulty)
    {
        kept_ = answered_;
        real_.Answer(answer);
    }
    else if (answer.value != Right().value)
    {
        faults_.HasEffect(condition);
    }
}

Nanoseconds WatchdogTap::Keep(const Nanoseconds now, const Nanoseconds every) noexcept
{
    const PartCondition& condition = faults_.Condition(Part::kWatchdogChip);
    if (!condition.is_faulty)
    {
        return kNever;
    }
    faults_.SetNow(now);
    if (now - answered_ > 2 * every)
    {
        faults_.HasEffect(condition); // A sound one would have tripped.
    }
    if (now - kept_ >= every)
    {
        kept_ = now;
        real_.Answer(Right());
    }
    return kept_ + every;
}
} // namespace counterpoint::simulator
