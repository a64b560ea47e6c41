// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/simulator/output_tap.hpp"

namespace counterpoint::simulator
{
OutputTap::OutputTap(hal::SafetyOutput& real, PartFaults& faults) noexcept : real_(real), faults_(faults)
{
}

std::uint32_t OutputTap::Challenge() noexcept
{
    const std::uint32_t fresh = real_.Challenge();
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
    switch (condition.how)
    {
    case Wrongness::kWrong:
        return {given.mask, given.response ^ 1U};
    case Wrongness::kOld:
        return before;
    default:
        return {0U, 0U};
    }
}

void OutputTap::Drive(const hal::PermitSet& permits) noexcept
{
    const hal::PermitSet before = permits_;
    permits_ = permits;
    real_.Drive({Spoiled(Part::kPermitA, permits.a, before.a), Spoiled(Part::kPermitB, permits.b, before.b),
                 Spoiled(Part::kPermitKernel, permits.kernel, before.kernel)});
}

hal::ProbeAnswer OutputTap::Probe(const hal::PermitSet& permits, const std::uint32_t challenge) const noexcept
{
    return real_.Probe(permits, challenge);
}

const hal::PermitSet& OutputTap::Permits() const noexcept
{
    return permits_;
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
    bool is_served = true;
    bool is_served_again = false;
    if (condition.is_faulty)
    {
        faults_.HasEffect(condition);
        given.value = (condition.how == Wrongness::kOld) ? before_.value : given.value;
        given.value ^= (condition.how == Wrongness::kWrong) ? 1U : 0U;
        is_served = condition.how != Wrongness::kMissing;
        is_served_again = condition.how == Wrongness::kTwice;
    }
    before_ = answer;
    if (is_served)
    {
        real_.Answer(given);
    }
    if (is_served_again)
    {
        real_.Answer(given);
    }
}
} // namespace counterpoint::simulator
