// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/faults/frame_selector.hpp"

#include <algorithm>
#include <utility>

namespace counterpoint::simulator
{
namespace
{
constexpr std::uint32_t kMillion = 1000000U;
} // namespace

bool Turns::Take(const FrameChoice& choice, const bool is_lucky) noexcept
{
    ++seen_;
    const bool is_turn = seen_ >= choice.first && (seen_ - choice.first) % choice.every == 0U;
    const bool is_hit = is_turn && is_lucky && done_ < choice.count;
    done_ += is_hit ? 1U : 0U;
    return is_hit;
}

EffectTeller::EffectTeller(Journal& journal, const EventKind kind) noexcept : journal_(journal), kind_(kind)
{
}

void EffectTeller::Tell(const std::size_t fault, const NodeIndex receiver, const std::uint32_t identifier,
                        const Nanoseconds at)
{
    journal_.Tell({at, kind_, receiver, 0U, identifier, fault});
    if (std::find(told_.begin(), told_.end(), fault) == told_.end())
    {
        told_.push_back(fault);
        journal_.Note({at, EventKind::kFault, receiver, 0U, fault, 0U});
    }
}

FrameSelector::FrameSelector(const FaultSetup& fault, const std::size_t index, std::vector<std::uint32_t> identifiers)
    : fault_(&fault), index_(index), identifiers_(std::move(identifiers))
{
}

bool FrameSelector::Fits(const CanFrame& frame, const NodeIndex sender, const Nanoseconds now) const
{
    const FrameChoice& choice = fault_->frames;
    const bool is_identifier = identifiers_.empty() || std::find(identifiers_.begin(), identifiers_.end(),
                                                                 frame.identifier) != identifiers_.end();
    const bool is_sender = !choice.sender || *choice.sender == sender;
    const bool is_in_time = now >= choice.from && now < choice.until;
    return is_identifier && is_sender && is_in_time && IsOn(now, choice.from, choice.on, choice.off);
}

void FrameSelector::Examine(const CanFrame& frame, const NodeIndex sender, const Nanoseconds now, Random& random)
{
    const FrameChoice& choice = fault_->frames;
    is_chosen_ = false;
    if (!Fits(frame, sender, now))
    {
        return;
    }
    // The number is drawn in any case, so that one fault does not shift the luck of another.
    is_chosen_ = turns_.Take(choice, random.Below(kMillion) < choice.probability_ppm);
}

bool FrameSelector::IsFor(const BusPlace& receiver) const noexcept
{
    const FrameChoice& choice = fault_->frames;
    const bool is_node = !choice.receiver || *choice.receiver == receiver.node;
    return is_node && (choice.controller == 0U || choice.controller == receiver.controller);
}

} // namespace counterpoint::simulator
