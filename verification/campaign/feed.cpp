// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/feed.hpp"

#include "verification/campaign/calls.hpp"

#include <algorithm>

namespace counterpoint::campaign
{
namespace
{
/// How often a call is made that is not deferred.
int TimesOf(const Turn turn)
{
    if (turn == Turn::kTwice)
    {
        return 2;
    }
    return (turn == Turn::kAsItIs) ? 1 : 0;
}
} // namespace

Feed::Feed(const Recording& recording)
    : recording_(recording), course_(recording), commands_(recording), calls_(std::make_unique<CallFaults>())
{
    handed_.reserve(kMostOwnFrames); // Nothing is allocated while a fault is at work.
    held_back_.reserve(kMostOwnFrames);
    held_confirms_.reserve(kMostOwnFrames);
    Rewind(0U, nullptr, 0U, 0U);
}

Feed::~Feed() = default;

/// Both paths of each acknowledge, each bit of both sides of what is produced.
void Feed::TakeInputs(const std::vector<FlatPair>& pairs)
{
    for (std::size_t index = 0U; index < pairs.size(); ++index)
    {
        for (const bool is_second : {false, true})
        {
            const std::uint8_t bits = pairs[index].is_consumer ? std::uint8_t{1U} : pairs[index].normal.length_bits;
            for (std::uint8_t bit = 0U; bit < bits; ++bit)
            {
                const InputBit input{pairs[index].is_consumer, is_second,
                                     pairs[index].is_consumer ? pairs[index].slot : index, bit};
                const bool is_known = std::any_of(inputs_.begin(), inputs_.end(),
                                                  [&input](const InputBit& each)
                                                  {
                                                      return each.is_acknowledge && input.is_acknowledge &&
                                                             each.is_second == input.is_second &&
                                                             each.index == input.index;
                                                  });
                if (!is_known)
                {
                    inputs_.push_back(input);
                }
            }
        }
    }
}

void Feed::Rewind(const std::size_t cycle, const Experiment* const fault, const std::size_t end,
                  const std::uint64_t seed)
{
    fault_ = fault;
    if (fault == nullptr || IsMemory(fault->part))
    {
        course_.Clear();
        calls_->Set(nullptr);
    }
    else
    {
        course_.Disturb(*fault, end, seed);
        calls_->Set(fault);
    }
    next_frame_ = course_.FirstFrameOf(cycle);
    commands_.Rewind(cycle, fault);
    handed_.clear();
    held_back_.clear();
    held_confirms_.clear();
    held_refresh_ = 0U;
}

bool Feed::IsUndisturbed(const std::size_t cycle) const
{
    if (fault_ == nullptr || IsMemory(fault_->part))
    {
        return true;
    }
    const bool is_for_ever = fault_->part == Part::kInputs || fault_->part == Part::kCounters;
    const bool is_call = fault_->part == Part::kKernelCalls || fault_->part == Part::kCallsOfA ||
                         fault_->part == Part::kCallsOfB || fault_->part == Part::kSteps;
    const bool is_over = !is_call || ((fault_->variant & kAlways) == 0U && cycle > fault_->cycle);
    return !is_for_ever && is_over && commands_.IsOver(cycle) && held_back_.empty() && held_confirms_.empty() &&
           held_refresh_ == 0U && course_.IsOver(cycle, next_frame_);
}

void Feed::BeginCall(const std::size_t cycle, Kernel& kernel)
{
    BeginPeriod(cycle, kernel);
    TellCommands(cycle, kernel);
}

void Feed::BeginPeriod(const std::size_t cycle, Kernel& kernel)
{
    calls_->BeginCycle(cycle);
    CatchUp(kernel);
}

void Feed::TellCommands(const std::size_t cycle, Kernel& kernel)
{
    commands_.TellUntil(cycle, kernel);
}

void Feed::Hand(const RecordedFrame& frame, Kernel& kernel)
{
    ++next_frame_;
    const Turn turn = calls_->Next(Part::kKernelCalls, static_cast<std::uint32_t>(KernelCall::kOnFrame));
    if (turn == Turn::kDefer)
    {
        held_back_.push_back(frame);
        return;
    }
    for (int times = TimesOf(turn); times > 0; --times)
    {
        handed_.push_back(frame);
        kernel.OnFrame(frame.stamped);
    }
    if (!calls_->IsLate())
    {
        CatchUp(kernel);
    }
}

void Feed::Confirm(const StampedFrame& own, Kernel& kernel)
{
    const Turn turn = calls_->Next(Part::kKernelCalls, static_cast<std::uint32_t>(KernelCall::kOnConfirm));
    if (turn == Turn::kDefer)
    {
        held_confirms_.push_back(own);
        return;
    }
    for (int times = TimesOf(turn); times > 0; --times)
    {
        kernel.OnConfirm(own);
    }
    if (!calls_->IsLate())
    {
        CatchUp(kernel);
    }
}

/// Calls that were held back come now.
void Feed::CatchUp(Kernel& kernel)
{
    for (const RecordedFrame& frame : held_back_)
    {
        handed_.push_back(frame);
        kernel.OnFrame(frame.stamped);
    }
    for (const StampedFrame& own : held_confirms_)
    {
        kernel.OnConfirm(own);
    }
    held_back_.clear();
    held_confirms_.clear();
    CatchUpRefresh();
}

void Feed::CatchUpRefresh()
{
    if (held_refresh_ != 0U)
    {
        held_target_.source->WriteInputs(held_target_, held_refresh_);
        held_refresh_ = 0U;
    }
}

RefreshAnswer Feed::Refresh(const InputTarget& target, const CommunicationIndex index)
{
    const Turn turn = calls_->Next(Part::kKernelCalls, static_cast<std::uint32_t>(KernelCall::kOnRefresh));
    if (turn == Turn::kDefer)
    {
        held_refresh_ = index.value;
        held_target_ = target;
        return RefreshAnswer::kReady; // What it answered last.
    }
    for (int times = TimesOf(turn); times > 0; --times)
    {
        target.source->WriteInputs(target, index.value);
    }
    if (!calls_->IsLate())
    {
        CatchUpRefresh();
    }
    return RefreshAnswer::kReady;
}

CycleCall Feed::CallOf(const std::size_t cycle, const Nanoseconds at) const
{
    CycleCall call = recording_.cycles[cycle].call;
    call.now = course_.Stamp(at);
    const InputBit* const stuck = StuckInput(cycle);
    if (stuck != nullptr && stuck->is_acknowledge)
    {
        SrdoMask& side = stuck->is_second ? call.acknowledge_b : call.acknowledge_a;
        const SrdoMask bit = SrdoMask{1U} << stuck->index;
        side = (fault_->kind == FaultKind::kStuckAt1) ? (side | bit) : (side & ~bit);
    }
    return call;
}

/// As an application does it that senses with two paths: each side by itself.
void Feed::WriteInputs(const InputTarget& target, const std::uint16_t index) const
{
    for (std::size_t number = 0U; number < target.pairs->size(); ++number)
    {
        const FlatPair& pair = (*target.pairs)[number];
        if (pair.is_consumer || pair.asked_as != index)
        {
            continue;
        }
        std::uint64_t value = 0U;
        for (const RecordedInput& input : recording_.inputs)
        {
            if (input.cycle <= target.cycle && input.object.index == pair.address.index &&
                input.object.sub == pair.address.sub)
            {
                value = input.value;
            }
        }
        if (target.has_normal)
        {
            WriteVariable(pair.normal, {Written(target.cycle, number, false, value)});
        }
        if (target.has_inverse)
        {
            WriteVariable(pair.inverse, {Written(target.cycle, number, true, ~value)});
        }
    }
}

std::uint64_t Feed::Written(const std::size_t cycle, const std::size_t pair, const bool is_inverse,
                            const std::uint64_t value) const
{
    const InputBit* const stuck = StuckInput(cycle);
    if (stuck == nullptr || stuck->is_acknowledge || stuck->index != pair || stuck->is_second != is_inverse)
    {
        return value;
    }
    const std::uint64_t bit = std::uint64_t{1U} << stuck->bit;
    return (fault_->kind == FaultKind::kStuckAt1) ? (value | bit) : (value & ~bit);
}

const InputBit* Feed::StuckInput(const std::size_t cycle) const
{
    const bool is_stuck = fault_ != nullptr && fault_->part == Part::kInputs && cycle >= fault_->cycle;
    return is_stuck ? &inputs_[fault_->subject] : nullptr;
}
} // namespace counterpoint::campaign
