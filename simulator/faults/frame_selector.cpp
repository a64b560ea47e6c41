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
    ++seen_;
    const bool is_turn = seen_ >= choice.first && (seen_ - choice.first) % choice.every == 0U;
    // The number is drawn in any case, so that one fault does not shift the luck of another.
    const bool is_lucky = random.Below(kMillion) < choice.probability_ppm;
    is_chosen_ = is_turn && is_lucky && done_ < choice.count;
    done_ += is_chosen_ ? 1U : 0U;
}

bool FrameSelector::IsChosen() const noexcept
{
    return is_chosen_;
}

bool FrameSelector::IsFor(const BusPlace& receiver) const noexcept
{
    const FrameChoice& choice = fault_->frames;
    const bool is_node = !choice.receiver || *choice.receiver == receiver.node;
    return is_node && (choice.controller == 0U || choice.controller == receiver.controller);
}

const FaultSetup& FrameSelector::Fault() const noexcept
{
    return *fault_;
}

std::size_t FrameSelector::Index() const noexcept
{
    return index_;
}
} // namespace counterpoint::simulator
