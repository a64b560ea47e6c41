// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/faults/part_faults.hpp"

#include <algorithm>
#include <utility>

namespace counterpoint::simulator
{
namespace
{
thread_local std::array<std::uint64_t, kPartCount> asked{};
} // namespace

void PartFaults::Begin(const FaultSetup& fault, const std::size_t index)
{
    PartCondition& condition = Condition(fault.part);
    condition.is_faulty = true;
    condition.kind = std::get<PartFault>(fault.kind);
    condition.call = fault.call;
    condition.how = fault.how;
    condition.remaining = fault.times;
    condition.fault = index;
    if (fault.second_part != Part::kNone)
    {
        Condition(fault.second_part) = condition;
    }
}

void PartFaults::End(const FaultSetup& fault)
{
    Condition(fault.part) = PartCondition{};
    if (fault.second_part != Part::kNone)
    {
        Condition(fault.second_part) = PartCondition{};
    }
}

void PartFaults::PowerOff() noexcept
{
    for (PartCondition& condition : conditions_)
    {
        if (condition.kind == PartFault::kHung)
        {
            condition = PartCondition{};
        }
    }
}

void PartFaults::SetNow(const Nanoseconds now) noexcept
{
    now_ = now;
}

void PartFaults::HasEffect(const PartCondition& condition) noexcept
{
    if (std::find(seen_.begin(), seen_.end(), condition.fault) == seen_.end())
    {
        seen_.push_back(condition.fault);
        effects_.emplace_back(condition.fault, now_);
    }
}

std::uint64_t PartFaults::Asked(const Part part) noexcept
{
    return asked[static_cast<std::size_t>(part)];
}

PartAnswer PartFaults::AnswerOf(const Part part) noexcept
{
    ++asked[static_cast<std::size_t>(part)];
    const PartCondition& condition = Condition(part);
    if (!condition.is_faulty)
    {
        return PartAnswer::kOwn;
    }
    switch (condition.kind)
    {
    case PartFault::kSkipped:
    case PartFault::kDoubled:
        return PartAnswer::kOwn; // Counted where calls can be left out: ChannelTap.
    case PartFault::kFrozenInput:
    case PartFault::kPermit:
    case PartFault::kWatchdog:
        return PartAnswer::kOwn; // Whoever asks such a part looks at its condition.
    case PartFault::kHung:
        HasEffect(condition);
        std::longjmp(way_out_, 1);
    case PartFault::kFrozen:
        HasEffect(condition);
        return PartAnswer::kLast;
    case PartFault::kNotCalled:
        HasEffect(condition);
        return PartAnswer::kZero;
    case PartFault::kAlwaysGood:
        return PartAnswer::kGood;
    }
    return PartAnswer::kOwn;
}

void PartFaults::Trap() noexcept
{
    is_trapped_ = true;
    std::longjmp(way_out_, 1);
}

} // namespace counterpoint::simulator
