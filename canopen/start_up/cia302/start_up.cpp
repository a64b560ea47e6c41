// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/start_up/cia302/start_up.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint32_t kAnswers = 0x580U;
constexpr std::uint32_t kErrorControl = 0x700U;

bool IsReset(const NmtCommand command) noexcept
{
    return (command == NmtCommand::kResetNode) || (command == NmtCommand::kResetCommunication);
}

/// A command that takes nodes out of OPERATIONAL.
bool IsLeave(const CanFrame& frame) noexcept
{
    constexpr std::uint8_t kCommandBytes = 2U;
    const auto command = static_cast<NmtCommand>(frame.data[0]);
    const bool is_command =
        (frame.identifier == 0U) && (frame.kind == FrameKind::kData) && (frame.length_bytes == kCommandBytes);
    return is_command && IsNmtCommand(command) && (command != NmtCommand::kStart);
}

/// Signs that a slave is OPERATIONAL no more: a boot-up message, its loss, another state.
bool ShowsThatItLeft(const NodeEvent event, const SlaveState state) noexcept
{
    const bool is_gone = (event == NodeEvent::kBootUp) || (state == SlaveState::kMissing);
    return is_gone || (state == SlaveState::kStopped) || (state == SlaveState::kPreOperational);
}

} // namespace

Cia302StartUp::Cia302StartUp(const StartUpParts& parts, BootRecord* const records) noexcept
    : parts_(parts), boot_(parts, records, *this), master_(parts, boot_), clock_{}, reaction_(Reaction::kNone)
{
}

void Cia302StartUp::Begin(const Instant now) noexcept
{
    const BootTime time = clock_.Tick(now);
    End();
    if (parts_.setup.Has(kIsMaster))
    {
        master_.Begin(NmtCommand::kResetCommunication, time);
    }
}

void Cia302StartUp::End() noexcept
{
    reaction_ = Reaction::kNone;
    master_.End(clock_.last);
    master_.Free();
}

void Cia302StartUp::OnFrame(const CanFrame& frame, const Instant now) noexcept
{
    const BootTime time = clock_.Tick(now);
    const std::uint32_t service = frame.identifier & ~std::uint32_t{kLastNode};
    const NodeId node{static_cast<std::uint8_t>(frame.identifier & kLastNode)};
    const bool is_of_slave = (service == kAnswers) || (service == kErrorControl);
    if (is_of_slave && parts_.setup.IsListed(node))
    {
        boot_.OnCycle(node, time);
        master_.GoOn(time);
    }
    if ((service == kErrorControl) && parts_.setup.IsSafetySlave(node))
    {
        VerifyAgain(node, time);
    }
    for (std::uint8_t id = 1U; IsLeave(frame) && (id <= kLastNode); ++id)
    {
        // Of somebody else. A slave without heartbeat and guarding gives no other sign.
        if ((frame.data[1] == kAllNodes.value) || (frame.data[1] == id))
        {
            NoteLeft(NodeId{id});
        }
    }
}

/// It is OPERATIONAL no more, or was told to be: one whose boot ended with an error counts as not started since. No
/// safety slave: that is verified before each start. [SRS_BOOT_520]
void Cia302StartUp::NoteLeft(const NodeId node) noexcept
{
    BootRecord& record = boot_.Record(node);
    const bool is_refused = record.HasFailed() && !parts_.setup.IsSafetySlave(node);
    record.status.is_started = record.status.is_started && !is_refused;
}

/// It runs, but its gate was closed since it was started: it may have left OPERATIONAL and come back between two signs,
/// or not have heard the reset behind which its boot-up message is waited for. [SRS_BOOT_013]
void Cia302StartUp::VerifyAgain(const NodeId node, const BootTime& time) noexcept
{
    const GateState gate = parts_.gate.State(node);
    const bool is_closed = (gate != GateState::kOpen) && (gate != GateState::kBusy);
    const bool is_past_resets = (master_.Step() != MasterStep::kIdle) && (master_.Step() != MasterStep::kReset);
    const bool is_quiet = !parts_.nmt.IsLeaving(node); // No stop on its way. [SRS_BOOT_770]
    const bool is_found = is_closed && is_past_resets && is_quiet && parts_.table.RunsSurely(node);
    if (is_found && (boot_.Record(node).state == BootState::kUnheard))
    {
        boot_.TakeOver(node, time);
    }
    else if (is_found && !boot_.Record(node).status.is_busy)
    {
        boot_.Verify(node, time);
    }
    else
    {
        // As it is to be, or under way.
    }
}

void Cia302StartUp::OnCycle(const Instant now) noexcept
{
    const BootTime time = clock_.Tick(now);
    master_.TellSent(now);
    master_.SendResets(time);
    React(time);
    master_.SendStart(time);
    for (std::uint8_t id = 1U; (master_.Step() != MasterStep::kIdle) && (id <= kLastNode); ++id)
    {
        const BootRecord& record = boot_.Record(NodeId{id});
        if (record.is_start_owed && !record.status.is_busy)
        {
            boot_.Start(NodeId{id}, time);
        }
        if (parts_.setup.IsListed(NodeId{id}))
        {
            boot_.OnCycle(NodeId{id}, time);
        }
    }
    if (master_.Step() == MasterStep::kHalted)
    {
        master_.OnNews(); // What halts it may be mandatory no more.
    }
    master_.GoOn(time);
}

void Cia302StartUp::OnNodeEvent(const NodeId node, const NodeEvent event, const Instant now) noexcept
{
    const BootTime time = clock_.Tick(now);
    const bool is_listed = parts_.setup.IsListed(node);
    const bool is_active = (master_.Step() != MasterStep::kIdle) && (master_.Step() != MasterStep::kStopped);
    const bool is_boot_up = (event == NodeEvent::kBootUp);
    const bool is_lost = (event == NodeEvent::kHeartbeatLost) || (event == NodeEvent::kGuardLost);
    const bool is_state = (event == NodeEvent::kStarted) || (event == NodeEvent::kChanged);
    if (ShowsThatItLeft(event, parts_.table.Record(node).state))
    {
        NoteLeft(node);
    }
    if (is_active && !is_listed && (is_boot_up || (event == NodeEvent::kUnexpected)))
    {
        OnForeign(node, now);
    }
    else if (is_listed && is_boot_up)
    {
        OnBootUp(node, time);
    }
    else if (is_active && is_listed && is_lost)
    {
        OnLost(node, time);
    }
    else if ((master_.Step() != MasterStep::kIdle) && is_listed && is_state)
    {
        OnState(node, event, time);
    }
}

/// After a stop of all by error handling nobody is booted but by order. Who boots up then may be another device.
void Cia302StartUp::OnBootUp(const NodeId node, const BootTime& time) noexcept
{
    const BootRecord& record = boot_.Record(node);
    const bool is_stopped = (master_.Step() == MasterStep::kStopped);
    const bool is_ordered = record.status.is_busy && (!record.is_extra || record.IsAwaitingBootUp());
    if ((master_.Step() != MasterStep::kIdle) && (!is_stopped || is_ordered))
    {
        boot_.OnBootUp(node, time);
    }
    else if (is_stopped && parts_.setup.IsSafetySlave(node))
    {
        boot_.Doubt(node, time);
    }
    else
    {
        // Nothing was found of it, or it has no gate.
    }
}

void Cia302StartUp::OnForeign(const NodeId node, const Instant now) noexcept
{
    NodeStatus& status = boot_.Record(node).status;
    const bool is_news = (status.letter != 'A') && (node.value != parts_.setup.own.value);
    if (is_news)
    {
        status = NodeStatus{};
        status.letter = 'A';
        parts_.listener.OnNodeStatus(node, now);
    }
}

/// A safety slave that runs and was not verified, or not started by this master: it was verified before it ran, and
/// changed since. One that has left OPERATIONAL can be changed: what was verified holds no more.
void Cia302StartUp::OnState(const NodeId node, const NodeEvent event, const BootTime& time) noexcept
{
    const bool is_running = (parts_.table.Record(node).state == SlaveState::kOperational);
    const bool is_free = !boot_.Record(node).status.is_busy;
    const bool is_foreign = parts_.setup.IsSafetySlave(node) && !boot_.Record(node).status.is_started;
    const bool is_found = parts_.table.IsFoundRunning(node); // Else at its next sign: VerifyAgain.
    if (is_found && is_free && (is_foreign || !parts_.gate.MayStart(node)))
    {
        boot_.Verify(node, time);
    }
    else if (!is_running && is_free && (event == NodeEvent::kChanged) && parts_.gate.MayStart(node))
    {
        parts_.gate.Close(node);
    }
    else
    {
        // As it is to be, or under way.
    }
}

void Cia302StartUp::OnLost(const NodeId node, const BootTime& time) noexcept
{
    const BootRecord& record = boot_.Record(node);
    const bool is_mandatory = parts_.setup.Slave(node).Has(kMandatory);
    const bool is_booted = record.is_booted && (!record.status.is_busy || record.is_extra);
    if (is_booted && is_mandatory && parts_.setup.Has(kStopAllOnError))
    {
        reaction_ = Reaction::kStopAll;
    }
    else if (is_booted && is_mandatory && parts_.setup.Has(kResetAllOnError))
    {
        reaction_ = (reaction_ == Reaction::kStopAll) ? reaction_ : Reaction::kResetAll;
    }
    else if (is_booted)
    {
        boot_.Reset(node, time);
    }
    React(time);
}

/// What error handling owes, as soon as the queue has room.
void Cia302StartUp::React(const BootTime& time) noexcept
{
    if (reaction_ == Reaction::kStopAll)
    {
        if (parts_.nmt.Request(NmtCommand::kStop, kAllNodes, time.now) == NmtAnswer::kTaken)
        {
            reaction_ = Reaction::kNone;
            EndBoots(time);
            master_.Stop(time.now);
        }
    }
    else if (reaction_ == Reaction::kResetAll)
    {
        reaction_ = Reaction::kNone;
        master_.End(time.now); // Who is held stays so: nobody has ordered this reset. [SRS_BOOT_033]
        master_.Begin(NmtCommand::kResetNode, time);
    }
}

/// A safety slave in the middle of its boot was perhaps not asked yet who it is.
void Cia302StartUp::EndBoots(const BootTime& time) noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const NodeId node{id};
        BootRecord& record = boot_.Record(node);
        const bool is_booting = record.IsBooting();
        boot_.End(node);
        record.NoteCommand(false, false, parts_.nmt.IsLeaving(node));
        if (is_booting && parts_.setup.IsSafetySlave(node))
        {
            boot_.Doubt(node, time);
        }
    }
}

void Cia302StartUp::OnBooted(const NodeId /*node*/, const BootTime& /*time*/) noexcept
{
    master_.OnNews();
}

void Cia302StartUp::OnBootFailed(const NodeId node, const BootTime& /*time*/) noexcept
{
    const bool is_unsafe = (boot_.Record(node).status.step == StartUpStep::kSafety);
    if (is_unsafe && parts_.setup.Slave(node).Has(kMandatory) && parts_.setup.Has(kStopAllOnError))
    {
        reaction_ = Reaction::kStopAll;
    }
    master_.OnNews();
}

bool Cia302StartUp::IsMasterOperational() const noexcept
{
    return master_.IsOperational();
}

/// It is verified anew and started in the next cycle, unless it boots anew. [SRS_BOOT_014, SRS_NMM_121,
/// SRS_NMM_122] A start of all becomes one for each slave that waits for it. [SRS_BOOT_800]
void Cia302StartUp::OnStartDropped(const NodeId node, const Instant /*now*/) noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        BootRecord& record = boot_.Record(NodeId{id});
        const bool is_of_all = (node.value == kAllNodes.value) && record.is_start_waiting;
        if ((node.value == id) || is_of_all)
        {
            // Two starts of one slave may be given up in one cycle.
            const bool is_owed = record.is_start_owed || record.status.is_started;
            record.is_start_owed = is_owed && parts_.setup.IsListed(NodeId{id});
            record.NoteCommand(false, false, parts_.nmt.IsLeaving(NodeId{id}));
        }
    }
}

/// Whom the master asked before may have been replaced since, and it was itself that did not hear the others. Whom
/// somebody else stopped is left alone. [SRS_BOOT_230]
void Cia302StartUp::OnBusBack(const Instant now) noexcept
{
    const BootTime time = clock_.Tick(now);
    const bool is_booting = (master_.Step() != MasterStep::kIdle) && (master_.Step() != MasterStep::kStopped);
    for (std::uint8_t id = 1U; is_booting && (id <= kLastNode); ++id)
    {
        const NodeId node{id};
        const BootRecord& record = boot_.Record(node);
        const NodeStatus& status = record.status;
        const SlaveState asked = parts_.table.Record(node).asked;
        const bool is_to_start = !record.is_extra || record.is_start_wanted;
        const bool is_cut = status.is_busy && is_to_start && !record.IsAwaitingBootUp();
        // Reset since, by whomever: its boot-up message may be lost. One that runs all the same was found so (L).
        const bool is_reset = (asked == SlaveState::kUnknown) && !parts_.table.RunsSurely(node);
        const bool has_start = is_reset || parts_.nmt.HasStart(node);
        const bool is_waiting = record.is_start_owed || (status.is_started && has_start);
        const bool has_failed = (status.letter != '\0') && !record.is_booted && (asked != SlaveState::kStopped);
        const bool is_ended = !status.is_busy && (is_waiting || has_failed);
        if (parts_.setup.IsListed(node) && (is_cut || is_ended))
        {
            boot_.AskAgain(node, time);
        }
    }
}

NmtAnswer Cia302StartUp::Command(const NmtCommand command, const NodeId node, const Instant now) noexcept
{
    const BootTime time = clock_.Tick(now);
    NmtAnswer answer = NmtAnswer::kInvalid;
    if (node.value == kAllNodes.value)
    {
        answer = CommandAll(command, time);
    }
    else if (node.value == parts_.setup.own.value)
    {
        answer = master_.CommandOwn(command, time);
    }
    else
    {
        answer = CommandNode(command, node, time);
    }
    return answer;
}

NmtAnswer Cia302StartUp::CommandAll(const NmtCommand command, const BootTime& time) noexcept
{
    const bool is_start = (command == NmtCommand::kStart);
    NmtAnswer answer = NmtAnswer::kTaken;
    if (is_start && (parts_.setup.HasSafetySlave() || master_.IsAnyRefused()))
    {
        answer = StartEach(time);
    }
    else
    {
        answer = parts_.nmt.Request(command, kAllNodes, time.now);
        for (std::uint8_t id = 1U; (answer == NmtAnswer::kTaken) && (id <= kLastNode); ++id)
        {
            // Who was never there heard nothing of it. [SRS_MGR_122] Who failed runs by a start of its own.
            BootRecord& record = boot_.Record(NodeId{id});
            const bool is_despite = record.status.is_started && record.HasFailed();
            record.NoteCommand(is_start && (record.is_booted || is_despite), parts_.nmt.IsStarting(NodeId{id}),
                               parts_.nmt.IsLeaving(NodeId{id}));
            record.is_start_owed = false;
            Keep(command, NodeId{id}, time);
        }
        const bool is_begun = (answer == NmtAnswer::kTaken) && (master_.Step() != MasterStep::kIdle);
        if (is_begun && IsReset(command))
        {
            reaction_ = Reaction::kNone;
            master_.BootAnew(time);
        }
        else if (is_begun)
        {
            master_.Obey(command, time.now);
        }
    }
    return answer;
}

bool Cia302StartUp::IsLeftOut(const NodeId node) const noexcept
{
    return boot_.IsRefused(node);
}

/// Whoever is refused keeps nobody else from being started.
NmtAnswer Cia302StartUp::StartEach(const BootTime& time) noexcept
{
    NmtAnswer answer = NmtAnswer::kTaken;
    NmtAnswer refusal = NmtAnswer::kTaken;
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const bool is_meant = parts_.setup.IsListed(NodeId{id}) && (answer == NmtAnswer::kTaken);
        const bool is_refused = is_meant && boot_.IsRefused(NodeId{id});
        const bool is_asked = is_meant && !is_refused;
        const NmtAnswer one = is_asked ? CommandNode(NmtCommand::kStart, NodeId{id}, time) : NmtAnswer::kTaken;
        refusal = (is_refused && (refusal == NmtAnswer::kTaken)) ? NmtAnswer::kPartly : refusal;
        refusal = (one == NmtAnswer::kOtherDevice) ? one : refusal;
        answer = ((one == NmtAnswer::kTaken) || (one == NmtAnswer::kOtherDevice)) ? answer : one;
    }
    answer = (answer == NmtAnswer::kTaken) ? master_.CommandOwn(NmtCommand::kStart, time) : answer;
    return (answer == NmtAnswer::kTaken) ? refusal : answer;
}

NmtAnswer Cia302StartUp::CommandNode(const NmtCommand command, const NodeId node, const BootTime& time) noexcept
{
    const bool is_guarded =
        (command == NmtCommand::kStart) && parts_.setup.IsSafetySlave(node) && parts_.nmt.IsActive();
    const bool is_other = is_guarded && boot_.Record(node).status.is_other;
    const NmtAnswer guarded = is_other ? NmtAnswer::kOtherDevice : NmtAnswer::kTaken;
    const NmtAnswer answer = is_guarded ? guarded : parts_.nmt.Request(command, node, time.now);
    const bool is_listed = parts_.setup.IsListed(node);
    if (is_guarded && !is_other)
    {
        boot_.Start(node, time); // Verifies, whatever was verified before, and then starts.
    }
    else if ((answer == NmtAnswer::kTaken) && is_listed && IsReset(command) && (master_.Step() != MasterStep::kIdle))
    {
        boot_.Free(node);
        boot_.Await(node, time);
    }
    else if ((answer == NmtAnswer::kTaken) && is_listed)
    {
        BootRecord& record = boot_.Record(node);
        record.NoteCommand(command == NmtCommand::kStart, parts_.nmt.IsStarting(node), parts_.nmt.IsLeaving(node));
        record.is_start_owed = false;
        Keep(command, node, time);
    }
    return answer;
}

/// What was ordered counts for the start-up that runs, and for what may start it later. [SRS_BOOT_030]
void Cia302StartUp::Keep(const NmtCommand command, const NodeId node, const BootTime& time) noexcept
{
    const bool is_hold = (command == NmtCommand::kStop) || (command == NmtCommand::kPreOperational);
    const bool is_meant = parts_.setup.IsListed(node) && (master_.Step() != MasterStep::kIdle);
    if (is_meant && is_hold)
    {
        boot_.Hold(node);
    }
    else if (is_meant && (command == NmtCommand::kStart))
    {
        boot_.Release(node, time);
    }
    else
    {
        // A reset begins the start-up anew.
    }
}

bool Cia302StartUp::Boot(const NodeId node, const Instant now) noexcept
{
    const BootTime time = clock_.Tick(now);
    const bool is_node = (node.value >= 1U) && (node.value <= kLastNode);
    const bool is_listed = parts_.setup.IsListed(node) && (master_.Step() != MasterStep::kIdle);
    if (is_listed)
    {
        boot_.Free(node);
        boot_.Ask(node, time);
    }
    else if (is_node && !parts_.setup.IsListed(node))
    {
        OnForeign(node, now);
    }
    return is_listed;
}

/// After a stop of all only orders start a slave. [SRS_BOOT_343]
bool Cia302StartUp::Resume(const NodeId node, const Instant now) noexcept
{
    const BootTime time = clock_.Tick(now);
    const bool is_going = (master_.Step() != MasterStep::kIdle) && (master_.Step() != MasterStep::kStopped);
    const bool is_one = parts_.setup.IsListed(node) && is_going;
    if (is_one)
    {
        boot_.Resume(node, time);
    }
    return is_one;
}

bool Cia302StartUp::Configure(const NodeId node, const Instant now) noexcept
{
    const BootTime time = clock_.Tick(now);
    const bool is_free =
        parts_.setup.IsListed(node) && (master_.Step() != MasterStep::kIdle) && IsConfigurable(parts_, *this, node);
    if (is_free)
    {
        boot_.Configure(node, time);
    }
    return is_free;
}

NodeStatus Cia302StartUp::Status(const NodeId node) const noexcept
{
    const BootRecord& record = boot_.Record(node);
    NodeStatus status = record.status;
    status.is_started = record.IsSeenStarted();
    return status;
}

std::int16_t Cia302StartUp::MasterState() const noexcept
{
    return static_cast<std::int16_t>(master_.ToldStep());
}

} // namespace counterpoint::cia302
