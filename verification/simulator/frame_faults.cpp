// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/simulator/frame_faults.hpp"

#include <algorithm>

namespace counterpoint::simulator
{
namespace
{
bool ActsOnFrames(const FaultKind kind)
{
    const bool is_foreign = kind == FaultKind::kInsertion || kind == FaultKind::kMasquerade;
    return IsBusFault(kind) && !is_foreign;
}

/// Whether the frame is another one then: bits behind its last byte are no part of it.
bool Corrupt(const FaultSetup& fault, CanFrame& frame)
{
    const CanFrame sent = frame;
    for (const std::uint8_t bit : fault.bits)
    {
        std::uint8_t& byte = frame.data[bit / 8U];
        byte = static_cast<std::uint8_t>(byte ^ (1U << (bit % 8U)));
    }
    frame.length_bytes = fault.length.value_or(frame.length_bytes);
    const std::size_t length = std::min<std::size_t>(frame.length_bytes, kMaxPayloadBytes);
    return frame.length_bytes != sent.length_bytes || !std::equal(frame.data, frame.data + length, sent.data);
}
} // namespace

FrameFaults::FrameFaults(const Scenario& scenario, const host::VirtualBus& bus, Journal& journal)
    : scenario_(scenario), bus_(bus), journal_(journal), random_(scenario.seed)
{
    for (std::size_t index = 0U; index < scenario.faults.size(); ++index)
    {
        if (ActsOnFrames(scenario.faults[index].kind))
        {
            states_.push_back({index, 0U, 0U, false});
        }
        if (scenario.faults[index].kind == FaultKind::kMasquerade)
        {
            masquerades_.push_back(index);
        }
    }
}

bool FrameFaults::IsEmpty() const noexcept
{
    return states_.empty() && masquerades_.empty();
}

bool FrameFaults::Fits(const FaultSetup& fault, const host::FrameOnBus& sent) const
{
    const FrameChoice& choice = fault.frames;
    const bool is_identifier = !choice.identifier || *choice.identifier == sent.frame.identifier;
    const bool is_sender = !choice.sender || *choice.sender == sent.sender;
    const bool is_in_time = bus_.Now() >= choice.from && bus_.Now() < choice.until;
    return is_identifier && is_sender && is_in_time;
}

// Once for each frame, whoever receives it: which faults hit it.
void FrameFaults::Choose(const host::FrameOnBus& sent)
{
    for (State& state : states_)
    {
        const FaultSetup& fault = scenario_.faults[state.index];
        state.is_chosen = false;
        if (!Fits(fault, sent))
        {
            continue;
        }
        ++state.seen;
        const bool is_wanted = state.seen >= fault.frames.first && state.done < fault.frames.count;
        // The number is drawn in any case, so that one fault does not shift the luck of another.
        const bool is_lucky = random_.Below(1000000U) < fault.frames.probability_ppm;
        state.is_chosen = is_wanted && is_lucky;
        state.done += state.is_chosen ? 1U : 0U;
    }
}

void FrameFaults::OnReception(const host::FrameOnBus& sent, const host::NodeIndex receiver,
                              host::ReceptionList& receptions)
{
    if (sent.start != frame_start_)
    {
        frame_start_ = sent.start;
        Choose(sent);
    }
    ReleaseHeld(receiver, receptions);
    for (const std::size_t index : masquerades_)
    {
        const FaultSetup& fault = scenario_.faults[index];
        if (fault.node == sent.sender && fault.identifier == sent.frame.identifier)
        {
            Tell(index, receiver, sent.frame.identifier, bus_.Now()); // Its effect begins where it arrives.
        }
    }
    for (const State& state : states_)
    {
        const FaultSetup& fault = scenario_.faults[state.index];
        const bool is_here = !fault.frames.receiver || *fault.frames.receiver == receiver;
        if (state.is_chosen && is_here && !receptions.IsEmpty() && Apply(fault, state.index, receiver, receptions))
        {
            Tell(state.index, receiver, sent.frame.identifier, bus_.Now());
        }
    }
}

/// Whether the effect begins now; if not, it is told later.
bool FrameFaults::Apply(const FaultSetup& fault, const std::size_t index, const host::NodeIndex receiver,
                        host::ReceptionList& receptions)
{
    host::Reception& first = receptions[0U];
    if (fault.kind == FaultKind::kRepetition)
    {
        for (std::uint32_t time = 1U; time <= fault.times; ++time)
        {
            static_cast<void>(receptions.Add({first.frame, first.delay + fault.by * time}));
        }
        Tell(index, receiver, first.frame.identifier, bus_.Now() + fault.by);
        return false;
    }
    if (fault.kind == FaultKind::kWrongSequence)
    {
        held_.push_back({receiver, index, first.frame});
        receptions.Clear();
        return false;
    }
    if (fault.kind == FaultKind::kCorruption)
    {
        return Corrupt(fault, first.frame);
    }
    if (fault.kind == FaultKind::kLoss)
    {
        receptions.Clear();
    }
    else if (fault.kind == FaultKind::kDelay)
    {
        first.delay += fault.by;
    }
    else
    {
        const bool is_other = first.frame.identifier != fault.identifier;
        first.frame.identifier = fault.identifier; // Addressing.
        return is_other;
    }
    return true;
}

// The frame that was held back comes behind this one.
void FrameFaults::ReleaseHeld(const host::NodeIndex receiver, host::ReceptionList& receptions)
{
    const auto mine =
        std::find_if(held_.begin(), held_.end(), [receiver](const Held& held) { return held.receiver == receiver; });
    if (mine == held_.end())
    {
        return;
    }
    static_cast<void>(receptions.Add({mine->frame, 0}));
    Tell(mine->fault, receiver, mine->frame.identifier, bus_.Now());
    held_.erase(mine);
}

void FrameFaults::Tell(const std::size_t index, const host::NodeIndex receiver, const std::uint32_t identifier,
                       const Nanoseconds at)
{
    journal_.Tell({at, EventKind::kFrameChanged, receiver, 0U, identifier, index});
    if (std::find(told_.begin(), told_.end(), index) == told_.end())
    {
        told_.push_back(index);
        journal_.Note({at, EventKind::kFault, receiver, 0U, index, 0U});
    }
}
} // namespace counterpoint::simulator
