// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/course.hpp"

#include "verification/campaign/variants.hpp"

#include <algorithm>

namespace counterpoint::campaign
{
namespace
{
void PutNumber(CanFrame& frame, const std::uint64_t number)
{
    for (std::uint32_t byte = 0U; byte < frame.length_bytes && byte < kMaxPayloadBytes; ++byte)
    {
        frame.data[byte] = static_cast<std::uint8_t>(number >> (byte * 8U));
    }
}

bool IsEarlier(const RecordedFrame& left, const RecordedFrame& right)
{
    return left.at < right.at;
}

Nanoseconds OffsetOf(const Experiment& fault)
{
    return kGrid * (Nanoseconds{fault.variant} + 1);
}
} // namespace

std::size_t CycleOf(const Recording& recording, const Nanoseconds at)
{
    const auto cycle =
        std::lower_bound(recording.cycles.begin(), recording.cycles.end(), at,
                         [](const RecordedCycle& each, const Nanoseconds time) { return each.at < time; });
    return static_cast<std::size_t>(cycle - recording.cycles.begin());
}

Course::Course(const Recording& recording) : recording_(recording), counters_(recording.counters)
{
}

void Course::Clear()
{
    instead_.clear();
    from_ = recording_.frames.size();
    to_ = from_;
    timing_ = nullptr;
    if (has_counters_)
    {
        counters_ = recording_.counters;
        has_counters_ = false;
    }
}

void Course::Disturb(const Experiment& fault, const std::size_t end, const std::uint64_t seed)
{
    Clear();
    if (fault.part == Part::kBus)
    {
        Replace(fault, end, seed);
    }
    else if (fault.part == Part::kCounters)
    {
        has_counters_ = true;
        const Nanoseconds at = recording_.cycles[fault.cycle - 1U].at;
        const CounterFault what = CounterFaultOf(fault);
        counters_.Disturb(what.which, at, what.rate_ppm, what.jump_us);
    }
    else if (fault.part == Part::kCycle)
    {
        timing_ = &fault;
    }
    else
    {
        // The device receives what it received.
    }
}

std::size_t Course::FirstFrameOf(const std::size_t cycle) const
{
    return (cycle == 0U) ? 0U : recording_.cycles[cycle - 1U].frames_end;
}

std::optional<RecordedFrame> Course::FrameUntil(const std::size_t position, const Nanoseconds at) const
{
    const bool is_before = position < from_;
    const bool is_instead = !is_before && position - from_ < instead_.size();
    const std::size_t recorded = is_before ? position : position - instead_.size() + (to_ - from_);
    if (!is_instead && recorded >= recording_.frames.size())
    {
        return std::nullopt;
    }
    RecordedFrame frame = is_instead ? instead_[position - from_] : recording_.frames[recorded];
    if (frame.at > at)
    {
        return std::nullopt;
    }
    if (is_instead || has_counters_)
    {
        frame.stamped.stamp = counters_.At(frame.at);
    }
    return frame;
}

/// A call that is late takes the place of those that were due meanwhile, as a task does that is late.
Calls Course::CallsIn(const std::size_t cycle) const
{
    const Nanoseconds due = recording_.cycles[cycle].at;
    if (timing_ == nullptr || cycle < timing_->cycle)
    {
        return {{due, due}, 1U};
    }
    const std::size_t since = cycle - timing_->cycle;
    if (timing_->kind == FaultKind::kSkipped)
    {
        return {{due, due}, (since <= timing_->variant) ? 0U : 1U};
    }
    if (timing_->kind == FaultKind::kDoubled)
    {
        return {{due, due}, (since == 0U) ? 2U : 1U};
    }
    if (timing_->kind == FaultKind::kEarly)
    {
        return {{(since == 0U) ? due - OffsetOf(*timing_) : due, due}, 1U};
    }
    const Nanoseconds late = recording_.cycles[timing_->cycle].at + OffsetOf(*timing_);
    if (late > due)
    {
        return {};
    }
    const bool is_here = cycle > timing_->cycle && late > recording_.cycles[cycle - 1U].at;
    return is_here ? Calls{{late, due}, 2U} : Calls{{due, due}, 1U};
}

bool Course::IsOver(const std::size_t cycle, const std::size_t position) const
{
    if (timing_ != nullptr)
    {
        return recording_.cycles[cycle].at > recording_.cycles[timing_->cycle].at + OffsetOf(*timing_) &&
               cycle > timing_->cycle + kSkippedCycles;
    }
    const bool has_frames = from_ != to_ || !instead_.empty();
    return !has_counters_ && (!has_frames || (position >= from_ + instead_.size() && FirstFrameOf(cycle + 1U) >= to_));
}

void Course::Replace(const Experiment& fault, const std::size_t end, const std::uint64_t seed)
{
    if (fault.kind == FaultKind::kLost)
    {
        Lose(fault, end);
    }
    else if (fault.kind == FaultKind::kRepeated || fault.kind == FaultKind::kDelayed)
    {
        Move(fault.subject, OffsetOf(fault), fault.kind == FaultKind::kRepeated, std::nullopt);
    }
    else if (fault.kind == FaultKind::kInserted)
    {
        Move(fault.subject, OffsetOf(fault), true, DrawnData(seed, fault));
    }
    else if (fault.kind == FaultKind::kWrongOrder)
    {
        Exchange(fault);
    }
    else if (IsOfPair(fault.kind))
    {
        ReplacePair(fault, seed);
    }
    else
    {
        Change(fault);
    }
}

/// So many frames; or all of its identifier, or all of the bus, from then on.
void Course::Lose(const Experiment& fault, const std::size_t end)
{
    const std::size_t last = recording_.cycles[std::min(end, recording_.cycles.size() - 1U)].frames_end;
    const std::uint32_t identifier = recording_.frames[fault.subject].stamped.frame.identifier;
    if (fault.variant == kLosesIdentifier)
    {
        std::copy_if(recording_.frames.begin() + static_cast<std::ptrdiff_t>(fault.subject),
                     recording_.frames.begin() + static_cast<std::ptrdiff_t>(last), std::back_inserter(instead_),
                     [identifier](const RecordedFrame& each) { return each.stamped.frame.identifier != identifier; });
    }
    const bool is_burst = fault.variant < kLosesIdentifier;
    from_ = fault.subject;
    to_ = is_burst ? std::min(from_ + fault.variant + 1U, recording_.frames.size()) : last;
}

/// The contents change places; each comes when the other one was due.
void Course::Exchange(const Experiment& fault)
{
    const std::size_t other = std::min(fault.subject + fault.variant + 1U, recording_.frames.size() - 1U);
    instead_.assign(recording_.frames.begin() + static_cast<std::ptrdiff_t>(fault.subject),
                    recording_.frames.begin() + static_cast<std::ptrdiff_t>(other + 1U));
    std::swap(instead_.front().stamped.frame, instead_.back().stamped.frame);
    from_ = fault.subject;
    to_ = other + 1U;
}

/// Adds the frame, a time later; takes it away at its own time unless it `stays`.
void Course::Move(const std::size_t frame, const Nanoseconds by, const bool stays,
                  const std::optional<std::uint64_t> data)
{
    RecordedFrame moved = recording_.frames[frame];
    moved.at += by;
    if (data)
    {
        PutNumber(moved.stamped.frame, *data);
    }
    const auto behind = std::upper_bound(recording_.frames.begin(), recording_.frames.end(), moved, IsEarlier);
    const auto until = static_cast<std::size_t>(behind - recording_.frames.begin());
    Settle(stays ? until : frame, until);
    if (!stays)
    {
        instead_.erase(instead_.begin());
    }
    instead_.push_back(moved);
}

void Course::Change(const Experiment& fault)
{
    Settle(fault.subject, fault.subject + 1U);
    CanFrame& frame = instead_.front().stamped.frame;
    if (fault.kind == FaultKind::kCorrupted)
    {
        frame.data[fault.variant / 8U] =
            static_cast<std::uint8_t>(frame.data[fault.variant / 8U] ^ (1U << (fault.variant % 8U)));
    }
    else if (fault.kind == FaultKind::kWrongLength)
    {
        const std::uint32_t length = fault.variant + ((fault.variant >= frame.length_bytes) ? 1U : 0U);
        frame.length_bytes = static_cast<std::uint8_t>(length);
    }
    else
    {
        Masquerade(recording_, fault.variant, frame);
    }
}

/// Both frames, at the same distance.
void Course::ReplacePair(const Experiment& fault, const std::uint64_t seed)
{
    const RecordedPair& pair = recording_.pairs[fault.subject];
    std::array<RecordedFrame, 2U> moved{recording_.frames[pair.normal], recording_.frames[pair.inverse]};
    const std::uint64_t forged = DrawnData(seed, fault);
    for (RecordedFrame& each : moved)
    {
        each.at += OffsetOf(fault);
    }
    if (fault.kind == FaultKind::kPairForged)
    {
        PutNumber(moved[0].stamped.frame, forged);
        PutNumber(moved[1].stamped.frame, ~forged);
    }
    const bool is_delayed = fault.kind == FaultKind::kPairDelayed;
    const auto first = std::upper_bound(recording_.frames.begin(), recording_.frames.end(), moved[0], IsEarlier);
    const auto last = std::upper_bound(recording_.frames.begin(), recording_.frames.end(), moved[1], IsEarlier);
    Settle(is_delayed ? pair.normal : static_cast<std::size_t>(first - recording_.frames.begin()),
           static_cast<std::size_t>(last - recording_.frames.begin()));
    if (is_delayed)
    {
        instead_.erase(instead_.begin() + static_cast<std::ptrdiff_t>(pair.inverse - pair.normal));
        instead_.erase(instead_.begin());
    }
    instead_.insert(instead_.end(), moved.begin(), moved.end());
    std::stable_sort(instead_.begin(), instead_.end(), IsEarlier);
}

/// Frames from here to there, as they were, are to be changed.
void Course::Settle(const std::size_t from, const std::size_t to)
{
    from_ = from;
    to_ = to;
    instead_.assign(recording_.frames.begin() + static_cast<std::ptrdiff_t>(from),
                    recording_.frames.begin() + static_cast<std::ptrdiff_t>(to));
}
} // namespace counterpoint::campaign
