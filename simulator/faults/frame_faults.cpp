// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/faults/frame_faults.hpp"

#include <algorithm>
#include <utility>

namespace counterpoint::simulator
{
namespace
{
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

FrameFaults::FrameFaults(const FaultStage& stage, std::vector<FrameSelector> selectors)
    : stage_(stage), teller_(stage.journal, EventKind::kFrameChanged), random_(stage.scenario.seed),
      selectors_(std::move(selectors))
{
}

void FrameFaults::OnReception(const host::FrameOnBus& sent, const host::NodeIndex receiver,
                              host::ReceptionList& receptions)
{
    if (sent.start != frame_start_)
    {
        // Once for each frame, whoever receives it: which faults hit it.
        frame_start_ = sent.start;
        for (FrameSelector& selector : selectors_)
        {
            const bool is_own = stage_.places[sent.sender].fault == selector.Index(); // A duplicate has no duplicate.
            if (!is_own)
            {
                selector.Examine(sent.frame, stage_.places[sent.sender].node, stage_.bus.Now(), random_);
            }
        }
    }
    const BusPlace& place = stage_.places[receiver];
    if (place.fault != kNoFaultIndex)
    {
        ForForeign(place, sent, receptions);
        return;
    }
    const std::optional<CanFrame> held = TakeHeld(receiver);
    TellForeign(sent, place.node);
    for (const FrameSelector& selector : selectors_)
    {
        const bool is_here = selector.IsChosen() && selector.IsFor(place);
        if (is_here && !receptions.IsEmpty() && Apply(selector, receiver, receptions))
        {
            teller_.Tell(selector.Index(), place.node, sent.frame.identifier, stage_.bus.Now());
        }
    }
    if (held) // Comes behind this frame, and is not hit by what hits this one.
    {
        static_cast<void>(receptions.Add({*held, 0}));
    }
}

/// The controller of a duplicate hears the frames that it shall send again, and nothing else.
void FrameFaults::ForForeign(const BusPlace& place, const host::FrameOnBus& sent, host::ReceptionList& receptions) const
{
    for (const FrameSelector& selector : selectors_)
    {
        const bool is_mine = selector.Index() == place.fault && stage_.places[sent.sender].fault != place.fault;
        if (is_mine && selector.IsChosen() && !receptions.IsEmpty())
        {
            receptions[0U].delay += selector.Fault().by;
            return;
        }
    }
    receptions.Clear();
}

/// The effect of a frame that a fault sends begins where it arrives.
void FrameFaults::TellForeign(const host::FrameOnBus& sent, const NodeIndex receiver)
{
    const BusPlace& sender = stage_.places[sent.sender];
    if (sender.fault != kNoFaultIndex)
    {
        teller_.Tell(sender.fault, receiver, sent.frame.identifier, stage_.bus.Now());
    }
    for (std::size_t index = 0U; index < stage_.scenario.faults.size(); ++index)
    {
        const FaultSetup& fault = stage_.scenario.faults[index];
        const bool is_masquerade = fault.kind == FaultKind(ForeignFault::kMasquerade) && fault.node == sender.node;
        if (is_masquerade && fault.identifier == sent.frame.identifier)
        {
            teller_.Tell(index, receiver, sent.frame.identifier, stage_.bus.Now());
        }
    }
}

/// Whether the effect begins now; if not, it is told later.
bool FrameFaults::Apply(const FrameSelector& selector, const host::NodeIndex receiver, host::ReceptionList& receptions)
{
    const FaultSetup& fault = selector.Fault();
    host::Reception& first = receptions[0U];
    switch (std::get<FrameFault>(fault.kind))
    {
    case FrameFault::kCorruption:
        return Corrupt(fault, first.frame);
    case FrameFault::kRepetition:
        Repeat(selector, receiver, receptions);
        return false;
    case FrameFault::kWrongSequence:
        held_.push_back({receiver, first.frame});
        receptions.Clear();
        return true;
    case FrameFault::kLoss:
        receptions.Clear();
        return true;
    case FrameFault::kDelay:
        first.delay += fault.by;
        return true;
    case FrameFault::kAddressing:
        return std::exchange(first.frame.identifier, fault.identifier) != fault.identifier;
    case FrameFault::kStoreAndForward:
        Store(selector, receiver, receptions);
        return true;
    case FrameFault::kDuplicate:
        return false; // Sent by a controller of its own.
    }
    return false;
}

void FrameFaults::Repeat(const FrameSelector& selector, const host::NodeIndex receiver, host::ReceptionList& receptions)
{
    const FaultSetup& fault = selector.Fault();
    const host::Reception first = receptions[0U];
    std::uint32_t added = 0U;
    for (std::uint32_t time = 1U; time <= fault.times; ++time)
    {
        const bool fits = receptions.Add({first.frame, first.delay + fault.by * time});
        added += fits ? 1U : 0U;
    }
    if (added != fault.times)
    {
        dropped_[selector.Index()] += fault.times - added;
    }
    if (added != 0U)
    {
        teller_.Tell(selector.Index(), stage_.places[receiver].node, first.frame.identifier,
                     stage_.bus.Now() + fault.by);
    }
}

// Kept for `by`, then let go in order, at least `gap` apart.
void FrameFaults::Store(const FrameSelector& selector, const host::NodeIndex receiver, host::ReceptionList& receptions)
{
    const FaultSetup& fault = selector.Fault();
    const auto known = let_go_.find({selector.Index(), receiver});
    const Nanoseconds earliest = (known == let_go_.end()) ? 0 : known->second + fault.gap;
    const Nanoseconds at = std::max(stage_.bus.Now() + receptions[0U].delay + fault.by, earliest);
    receptions[0U].delay = at - stage_.bus.Now();
    let_go_[{selector.Index(), receiver}] = at;
}

// The frame that was held back for this receiver, if there is one.
std::optional<CanFrame> FrameFaults::TakeHeld(const host::NodeIndex receiver)
{
    const auto mine =
        std::find_if(held_.begin(), held_.end(), [receiver](const Held& held) { return held.receiver == receiver; });
    if (mine == held_.end())
    {
        return std::nullopt;
    }
    const CanFrame frame = mine->frame;
    held_.erase(mine);
    return frame;
}
} // namespace counterpoint::simulator
