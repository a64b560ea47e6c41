// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/steps.hpp"

#include "verification/campaign/variants.hpp"

#include <algorithm>
#include <cstring>

namespace counterpoint::campaign
{
namespace
{
/// Whether the step's mark is left out, made twice or late with its work; otherwise it is as without the fault.
bool TakesMark(const Experiment& fault)
{
    return fault.kind == FaultKind::kLate || (fault.variant & kNothingLeft) != 0U;
}

Phase Beside(const Phase phase, const int distance)
{
    return static_cast<Phase>(static_cast<int>(phase) + distance);
}
} // namespace

StepFaults::StepFaults(Device& device) : device_(device), size_(device.Memory().Size())
{
    const std::vector<Place>& places = device.Places();
    const auto is_flow = [](const Place& place) { return place.part == Part::kFlowMonitor; };
    flows_ = {*std::find_if(places.begin(), places.end(), is_flow),
              *std::find_if(places.rbegin(), places.rend(), is_flow)};
}

void StepFaults::At(const Experiment& fault, const std::size_t cycle, const Phase phase, const void* const frame)
{
    CatchUp();
    const bool is_always = (fault.variant & kAlways) != 0U;
    if (cycle != fault.cycle && !is_always)
    {
        return;
    }
    if (fault.kind == FaultKind::kDoubled)
    {
        RunTwice(fault, phase, frame);
    }
    else if (fault.kind == FaultKind::kReordered)
    {
        RunBehindNext(fault, phase, frame);
    }
    else
    {
        TakeBack(fault, phase);
    }
}

/// All that the step wrote is taken back as soon as it is done; what is late comes behind the next step.
void StepFaults::TakeBack(const Experiment& fault, const Phase phase) noexcept
{
    const std::uint8_t* const bytes = device_.Memory().Bytes();
    if (phase == Beside(fault.phase, -1))
    {
        before_.assign(bytes, bytes + size_);
    }
    else if (phase == fault.phase)
    {
        if (fault.kind == FaultKind::kLate)
        {
            behind_.assign(bytes, bytes + size_);
            is_kept_ = true;
        }
        Restore(fault, TakesMark(fault));
    }
    else
    {
        // Not this one.
    }
}

void StepFaults::CatchUp() noexcept
{
    if (!is_kept_)
    {
        return;
    }
    is_kept_ = false;
    for (std::size_t offset = 0U; offset < size_; ++offset)
    {
        if (behind_[offset] != before_[offset])
        {
            device_.Memory().Bytes()[offset] = behind_[offset];
        }
    }
}

/// before     step     again
/// Take       Resume   goes on; where the mark is made once, as behind the first time
void StepFaults::RunTwice(const Experiment& fault, const Phase phase, const void* const frame)
{
    if (phase == Beside(fault.phase, -1))
    {
        stage_ = (step_.Take(frame) == Continuation::Arrival::kFirst) ? Stage::kWaits : Stage::kAgain;
    }
    else if (phase == fault.phase && stage_ == Stage::kWaits)
    {
        KeepMark(fault);
        step_.Resume();
    }
    else if (phase == fault.phase && stage_ == Stage::kAgain)
    {
        RestoreMark(fault);
        stage_ = Stage::kNothing;
    }
    else
    {
        // Not this one.
    }
}

/// before     step                     next                step again
/// Take       its work is taken back   Take, Resume step   Resume next: goes on behind it
void StepFaults::RunBehindNext(const Experiment& fault, const Phase phase, const void* const frame)
{
    if (phase == Beside(fault.phase, -1))
    {
        before_.assign(device_.Memory().Bytes(), device_.Memory().Bytes() + size_);
        stage_ = (step_.Take(frame) == Continuation::Arrival::kFirst) ? Stage::kWaits : Stage::kAgain;
    }
    else if (phase == fault.phase && stage_ == Stage::kWaits)
    {
        Restore(fault, TakesMark(fault));
        stage_ = Stage::kPassedBy;
    }
    else if (phase == Beside(fault.phase, 1) && stage_ == Stage::kPassedBy)
    {
        if (next_.Take(frame) == Continuation::Arrival::kFirst)
        {
            KeepMark(fault);
            step_.Resume();
        }
        stage_ = Stage::kNothing;
    }
    else if (phase == fault.phase && stage_ == Stage::kAgain)
    {
        RestoreMark(fault);
        next_.Resume();
    }
    else
    {
        // Not this one.
    }
}

/// The memory before the step, with its mark or all but that.
void StepFaults::Restore(const Experiment& fault, const bool with_mark) noexcept
{
    std::uint8_t* const bytes = device_.Memory().Bytes();
    if (with_mark)
    {
        std::memcpy(bytes, before_.data(), size_);
        return;
    }
    const Place& flow = FlowOf(fault);
    const std::size_t end = flow.offset + flow.size;
    std::memcpy(bytes, before_.data(), flow.offset);
    std::memcpy(bytes + end, before_.data() + end, size_ - end);
}

const Place& StepFaults::FlowOf(const Experiment& fault) const noexcept
{
    return (fault.cpu == 1U) ? flows_[1] : flows_[0];
}

void StepFaults::KeepMark(const Experiment& fault)
{
    const Place& flow = FlowOf(fault);
    const std::uint8_t* const marks = device_.Memory().Bytes() + flow.offset;
    mark_.assign(marks, marks + flow.size);
}

void StepFaults::RestoreMark(const Experiment& fault) noexcept
{
    if (!TakesMark(fault))
    {
        const Place& flow = FlowOf(fault);
        std::memcpy(device_.Memory().Bytes() + flow.offset, mark_.data(), flow.size);
    }
}
} // namespace counterpoint::campaign
