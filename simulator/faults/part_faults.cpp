// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/faults/part_faults.hpp"

#include <algorithm>

namespace counterpoint::simulator
{
void PartFaults::Begin(const FaultSetup& fault, const std::size_t index)
{
    PartCondition& condition = Condition(fault.part);
    condition.is_faulty = true;
    condition.kind = fault.kind;
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
        if (condition.kind == FaultKind::kHung)
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

void PartFaults::Hang(const PartCondition& condition) noexcept
{
    HasEffect(condition);
    std::longjmp(way_out_, 1);
}

void PartFaults::Trap() noexcept
{
    is_trapped_ = true;
    std::longjmp(way_out_, 1);
}

bool PartFaults::TakeTrap() noexcept
{
    const bool is_trapped = is_trapped_;
    is_trapped_ = false;
    return is_trapped;
}

std::jmp_buf& PartFaults::WayOut() noexcept
{
    return way_out_;
}

std::vector<std::pair<std::size_t, Nanoseconds>> PartFaults::TakeEffects()
{
    std::vector<std::pair<std::size_t, Nanoseconds>> taken;
    taken.swap(effects_);
    return taken;
}
} // namespace counterpoint::simulator
