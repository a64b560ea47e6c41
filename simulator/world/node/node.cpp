// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/world/node/node.hpp"

#include "canopen/cia306/text/input_error.hpp"

namespace counterpoint::simulator
{
namespace
{
runtime::Half HalfOf(const runtime::CpuRole role)
{
    if (role == runtime::CpuRole::kWhole)
    {
        return runtime::Half::kBoth;
    }
    return (role == runtime::CpuRole::kA) ? runtime::Half::kNormal : runtime::Half::kInverse;
}
} // namespace

Node::Node(const NodePlace& place, const NodeSetup& setup, runtime::DeviceModel& model)
    : place_(place), setup_(setup), model_(model), processor_(place_),
      clock_(place.bus, setup, model.Config().cycle_us), pairs_(place_, model), insight_(place_, model, pairs_),
      outputs_(place_, model, pairs_, processor_.Faults()),
      channels_(setup, model, {processor_.Faults(), place.is_tapped ? &insight_ : nullptr}, outputs_.Supervision()),
      application_(place_, model, HalfOf(setup.role), processor_.Faults()),
      self_test_(setup.self_tests ? std::make_unique<NodeSelfTest>(processor_.Memory(), processor_.Image(),
                                                                   outputs_.Output(), processor_.Faults())
                                  : nullptr),
      controllers_(place_, processor_, clock_.Counters(), model, firmware_), firmware_(Inside(), controllers_.Ports()),
      parts_(Inside(), firmware_.Assembly())
{
}

NodeInside Node::Inside() noexcept
{
    return {place_, setup_, model_, processor_, clock_, pairs_, outputs_, channels_, application_, self_test_.get()};
}

void Node::PowerOn()
{
    controllers_.PowerOn();
    if (clock_.NextCycle() == kNever) // Again.
    {
        clock_.RestartCounters();
    }
    StartFresh();
    place_.Tell(EventKind::kPowerOn, 0U, 0U, 0U);
}

void Node::StartFresh()
{
    controllers_.Restart();
    processor_.PowerOn();
    try
    {
        processor_.Run([this]() { Rehearse(); }); // A part that hangs does so at the start, too.
    }
    catch (const cia306::InputError&)
    {
        // The rehearsal went well: a fault has hit the device's tables since.
        processor_.PowerOff();
        clock_.Stop();
        place_.Note(EventKind::kNoStart, 0U, 0U, 0U);
        return;
    }
    Settle();
}

void Node::PowerOff()
{
    processor_.PowerOff();
    firmware_.PowerOff();
    clock_.Stop();
    controllers_.PowerOff();
    outputs_.Close();
    application_.PowerOff();
    place_.Tell(EventKind::kPowerOff, 0U, 0U, 0U);
}

void Node::ResetNode()
{
    if (processor_.IsRunning())
    {
        StartFresh();
        outputs_.Look(clock_.CycleTime());
    }
}

void Node::ResetCommunication()
{
    if (!place_.HasServices())
    {
        for (const NmtState state : {NmtState::kInitialising, NmtState::kPreOperational})
        {
            place_.Tell(EventKind::kNmt, 0U, static_cast<std::uint64_t>(state), 0U);
        }
    }
    Obey(cia301::NmtCommand::kResetCommunication);
}

void Node::SetNmt(const NmtState state)
{
    if (!place_.HasServices())
    {
        place_.Tell(EventKind::kNmt, 0U, static_cast<std::uint64_t>(state), 0U);
    }
    if (state == NmtState::kOperational)
    {
        Obey(cia301::NmtCommand::kStart);
    }
    else
    {
        Obey((state == NmtState::kStopped) ? cia301::NmtCommand::kStop : cia301::NmtCommand::kPreOperational);
    }
}

void Node::Obey(const cia301::NmtCommand command)
{
    firmware_.Obey(command);
    Settle();
}

void Node::Run()
{
    if (!HasSupply())
    {
        PowerOn();
        return;
    }
    if (processor_.IsRunning() && place_.Now() >= clock_.NextCycle())
    {
        Cycle();
        return;
    }
    if (processor_.IsRunning() && place_.Now() >= firmware_.ServeAt())
    {
        firmware_.Serve();
        Settle();
    }
    outputs_.Look(clock_.CycleTime());
}

void Node::Cycle()
{
    controllers_.Drain();
    if (processor_.IsRunning())
    {
        firmware_.SendByApplication();
    }
    if (!processor_.IsRunning())
    {
        return;
    }
    const CycleCall call{clock_.Instants(), application_.AcknowledgeFor(Part::kAcknowledgeA),
                         application_.AcknowledgeFor(Part::kAcknowledgeB)};
    if (place_.HasServices())
    {
        firmware_.OnBus(controllers_.Condition());
    }
    firmware_.Cycle(call);
    if (place_.is_tapped)
    {
        LookInside();
    }
    outputs_.Look(clock_.CycleTime());
    pairs_.OnCycle();
    clock_.Advance();
    Settle();
    if (processor_.IsRunning())
    {
        application_.Run(Open());
    }
}

void Node::LookInside()
{
    processor_.NoteEffects();
    Kernel& kernel = firmware_.Assembly().Core();
    application_.NoteUntold(kernel.DeviceState()); // A cycle that ended before any part was called told nobody.
    if (self_test_ != nullptr)
    {
        insight_.TellSelfTest(self_test_->FirstFailed());
    }
    if (place_.journal.KeepsAll())
    {
        if (channels_.Peer() != nullptr)
        {
            insight_.TellLink(channels_.Peer()->Link());
        }
        insight_.TellVerdict(kernel.LastVerdict());
        insight_.TellPermits(outputs_.Permits());
    }
}

/// What follows when the device was called: it may have obeyed a command. Cycles and watchdog begin with the kernel.
void Node::Settle()
{
    if (!processor_.IsRunning())
    {
        return;
    }
    if (firmware_.TakeRestart())
    {
        outputs_.Start();
        insight_.Forget();
        pairs_.Forget();
        clock_.Begin();
    }
    firmware_.FollowState();
}

} // namespace counterpoint::simulator
