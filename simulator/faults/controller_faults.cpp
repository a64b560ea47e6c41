// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/faults/frame_faults.hpp"

#include "hal/host/virtual/frame_bits.hpp"

#include <string>
#include <utility>

namespace counterpoint::simulator
{
namespace
{
/// Far apart from the numbers of the frame faults.
constexpr std::uint64_t kControllerSalt = 0xC0117501U;

/// How long a frame is on the wire is known when it is there: its stuff bits depend on its data. [SRS_SIM_074]
void RequireBit(const FaultSetup& fault, const CanFrame& frame)
{
    const std::uint16_t bits = host::MeasureFrame(frame).OnWire();
    if (fault.bit >= bits)
    {
        throw YamlError(fault.source.file, fault.source.place,
                        "bit " + std::to_string(fault.bit) + " of a frame of " + std::to_string(bits) +
                            " bits on the wire, identifier " + IdentifierText(frame.identifier),
                        "a bit from 0 to " + std::to_string(bits - 1U) + ", or other 'frames'");
    }
}
} // namespace

ControllerFaults::ControllerFaults(const FaultStage& stage, std::vector<FrameSelector> selectors)
    : stage_(stage), teller_(stage.journal, EventKind::kFrameChanged), random_(stage.scenario.seed + kControllerSalt),
      selectors_(std::move(selectors))
{
}

ControllerFaults::Hold ControllerFaults::HoldOf(const FrameSelector& selector)
{
    switch (std::get<ControllerFault>(selector.Fault().kind))
    {
    case ControllerFault::kQueueFull:
        return {Moment::kSubmit, host::SubmitFate::kQueueFull};
    case ControllerFault::kSwallowed:
        return {Moment::kSubmit, host::SubmitFate::kSwallowed};
    case ControllerFault::kWireError:
        return {Moment::kWire, host::SubmitFate::kQueued};
    case ControllerFault::kConfirmation:
        break;
    }
    return {Moment::kConfirmation, host::SubmitFate::kQueued};
}

const FrameSelector* ControllerFaults::Hit(const Moment moment, const CanFrame& frame, const host::NodeIndex sender)
{
    const FrameSelector* hit = nullptr;
    for (FrameSelector& selector : selectors_)
    {
        if (HoldOf(selector).moment != moment)
        {
            continue;
        }
        selector.Examine(frame, stage_.places[sender].node, stage_.bus.Now(), random_);
        hit = (hit == nullptr && selector.IsChosen()) ? &selector : hit;
    }
    if (hit != nullptr)
    {
        teller_.Tell(hit->Index(), stage_.places[sender].node, frame.identifier, stage_.bus.Now());
    }
    return hit;
}

host::SubmitFate ControllerFaults::OnSubmit(CanFrame& frame, const host::NodeIndex sender, const host::BusTime /*now*/)
{
    if (stage_.places[sender].fault != kNoFaultIndex)
    {
        return host::SubmitFate::kQueued;
    }
    const FrameSelector* const hit = Hit(Moment::kSubmit, frame, sender);
    return (hit == nullptr) ? host::SubmitFate::kQueued : HoldOf(*hit).fate;
}

host::WireHit ControllerFaults::OnWire(const host::FrameOnBus& sent)
{
    const FrameSelector* const hit = Hit(Moment::kWire, sent.frame, sent.sender);
    if (hit != nullptr)
    {
        RequireBit(hit->Fault(), sent.frame);
    }
    return host::WireHit{(hit == nullptr) ? host::WireHit::kNone : std::uint16_t{hit->Fault().bit}};
}

void ControllerFaults::OnConfirmation(const host::FrameOnBus& sent, host::ReceptionList& receptions)
{
    const FrameSelector* const hit = Hit(Moment::kConfirmation, sent.frame, sent.sender);
    if (hit == nullptr || receptions.IsEmpty())
    {
        return;
    }
    if (hit->Fault().how == Wrongness::kMissing)
    {
        receptions.Clear();
        return;
    }
    receptions[0U].delay += (hit->Fault().how == Wrongness::kLate) ? hit->Fault().by : 0;
    for (const std::uint8_t bit : hit->Fault().bits)
    {
        std::uint8_t& byte = receptions[0U].frame.data[bit / 8U];
        byte = static_cast<std::uint8_t>(byte ^ (1U << (bit % 8U)));
    }
}
} // namespace counterpoint::simulator
