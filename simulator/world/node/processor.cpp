// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/world/node/processor.hpp"

namespace counterpoint::simulator
{
NodeProcessor::NodeProcessor(const NodePlace& place) noexcept : place_(place), supervisors_(faults_), flow_(faults_)
{
}

void NodeProcessor::PowerOn() noexcept
{
    is_on_ = true;
    is_hung_ = false;
}

void NodeProcessor::PowerOff() noexcept
{
    is_on_ = false;
    is_hung_ = false;
    faults_.PowerOff();
}

void NodeProcessor::StandStill()
{
    is_hung_ = true;
    place_.Note(EventKind::kHung, 0U, 2U, 0U);
}

void NodeProcessor::NoteHung()
{
    is_hung_ = true;
    NoteEffects();
    place_.Note(EventKind::kHung, 0U, faults_.TakeTrap() ? 1U : 0U, 0U);
}

void NodeProcessor::NoteEffects()
{
    for (const std::size_t fault : memory_.TakeEffects())
    {
        place_.Note(EventKind::kFault, 0U, fault, 0U);
    }
    for (const auto& [fault, at] : faults_.TakeEffects())
    {
        place_.journal.Note({at, EventKind::kFault, place_.index, 0U, fault, 0U});
    }
}
} // namespace counterpoint::simulator
