// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/start_up/cia302/master.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint32_t kLongestExpectMs = 1'000'000U; ///< See NodeTable::Expect.
constexpr std::uint8_t kBehindLast = kLastNode + 1U;

} // namespace

Cia302Master::Cia302Master(const StartUpParts& parts, BootSlave& boot) noexcept
    : parts_(parts), boot_(boot), step_(MasterStep::kIdle), told_(MasterStep::kIdle),
      reset_(NmtCommand::kResetCommunication), cursor_(0U), is_start_due_(false), has_news_(false), is_self_due_(false),
      is_held_(false)
{
}

void Cia302Master::Go(const MasterEvent event, const Instant now) noexcept
{
    step_ = Next(step_, event);
    TellStep(now);
}

void Cia302Master::TellStep(const Instant now) noexcept
{
    const bool is_of_all = (step_ == MasterStep::kStopped) || (step_ == MasterStep::kBooting);
    const bool is_waiting = is_of_all && parts_.nmt.IsLeaving(kAllNodes);
    if ((step_ != told_) && !is_waiting)
    {
        told_ = step_;
        parts_.listener.OnMasterState(static_cast<std::int16_t>(told_), now);
    }
}

void Cia302Master::Begin(const NmtCommand reset, const BootTime& time) noexcept
{
    reset_ = reset;
    const bool is_singly = (reset == NmtCommand::kResetCommunication) && HasKeptAlive();
    is_self_due_ = false;
    cursor_ = is_singly ? std::uint8_t{1U} : std::uint8_t{0U};
    Go(MasterEvent::kReset, time.now);
    SendResets(time);
}

void Cia302Master::End(const Instant now) noexcept
{
    Forget();
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        boot_.Record(NodeId{id}).is_end_waiting = false;
    }
    TellStep(now);
}

/// The end is not told: the steps of before are, until the reset was sent. [SRS_BOOT_821]
void Cia302Master::BootAnew(const BootTime& time) noexcept
{
    Forget();
    Free();
    BootAll(time);
}

void Cia302Master::Forget() noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        boot_.Forget(NodeId{id});
        parts_.table.Unwatch(NodeId{id});
        parts_.gate.Close(NodeId{id});
    }
    is_start_due_ = false;
    is_self_due_ = false;
    step_ = Next(step_, MasterEvent::kEnd);
}

void Cia302Master::Free() noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        boot_.Free(NodeId{id});
    }
    is_held_ = false;
}

void Cia302Master::Stop(const Instant now) noexcept
{
    is_start_due_ = false;
    is_self_due_ = false;
    Go(MasterEvent::kStop, now);
}

bool Cia302Master::HasKeptAlive() const noexcept
{
    bool has_one = false;
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const NodeId node{id};
        has_one = has_one || (parts_.setup.IsListed(node) && parts_.setup.Slave(node).Has(kKeepAlive));
    }
    return has_one;
}

/// Singly: nodes that are not listed too. What finds the queue full is tried in the next cycle.
void Cia302Master::SendResets(const BootTime& time) noexcept
{
    bool is_going = (step_ == MasterStep::kReset);
    while (is_going && (cursor_ < kBehindLast))
    {
        const NodeId node{cursor_};
        const bool is_kept =
            (cursor_ > 0U) && (((cursor_ == parts_.setup.own.value)) ||
                               (parts_.setup.IsListed(node) && parts_.setup.Slave(node).Has(kKeepAlive)));
        is_going = is_kept || (parts_.nmt.Request(reset_, node, time.now) == NmtAnswer::kTaken);
        if (is_going)
        {
            cursor_ = (cursor_ == 0U) ? kBehindLast : static_cast<std::uint8_t>(cursor_ + 1U);
        }
    }
    if (is_going && (parts_.nmt.Waiting() == 0U))
    {
        BootAll(time);
    }
}

/// All resets have left. What has booted up meanwhile is on its way already. 1F89h is also the time after which a
/// slave, mandatory or not, is told as never seen.
void Cia302Master::BootAll(const BootTime& time) noexcept
{
    const std::uint32_t asked_ms = parts_.setup.boot_time_ms;
    const std::uint32_t limit_ms = (asked_ms < kLongestExpectMs) ? asked_ms : kLongestExpectMs;
    Go(MasterEvent::kBoot, time.now);
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const NodeId node{id};
        const BootRecord& record = boot_.Record(node);
        const bool is_booting = record.IsBooting(); // An extra alone boots nobody.
        const bool is_new = parts_.setup.IsListed(node) && !is_booting && !record.is_booted;
        if (is_new && parts_.setup.Slave(node).Has(kKeepAlive))
        {
            boot_.Ask(node, time);
        }
        else if (is_new)
        {
            boot_.Await(node, time);
        }
        else
        {
            // On its way, or no slave.
        }
        if (is_new && (limit_ms > 0U))
        {
            parts_.table.Expect(node, limit_ms, time.now);
        }
    }
    has_news_ = true;
}

/// Whether all listed slaves with these bits are booted, or none of them has failed.
bool Cia302Master::IsEach(const std::uint32_t bits, const bool is_booted) const noexcept
{
    bool is_each = true;
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const NodeId node{id};
        const BootRecord& record = boot_.Record(node);
        const bool is_meant = parts_.setup.IsListed(node) && parts_.setup.Slave(node).Has(bits);
        const bool is_booting = record.IsBooting();
        const bool is_good = record.is_booted || (!is_booted && is_booting);
        is_each = is_each && (!is_meant || is_good);
    }
    return is_each;
}

void Cia302Master::OnNews() noexcept
{
    has_news_ = true;
}

void Cia302Master::GoOn(const BootTime& time) noexcept
{
    if (has_news_)
    {
        VerifyRunning(time);
    }
    const bool is_waiting = has_news_ && ((step_ == MasterStep::kBooting) || (step_ == MasterStep::kHalted));
    has_news_ = false;
    if (is_waiting && !IsEach(kMandatory, false))
    {
        Go(MasterEvent::kFailed, time.now);
    }
    else if (is_waiting && IsEach(kMandatory, true))
    {
        Go(MasterEvent::kBooted, time.now);
        is_self_due_ = !parts_.setup.Has(kApplicationStartsSelf) && !is_held_;
    }
    else if (is_waiting)
    {
        Go(MasterEvent::kAgain, time.now);
    }
    else
    {
        // Nothing new.
    }
    if (is_self_due_)
    {
        static_cast<void>(CommandOwn(NmtCommand::kStart, time)); // Obey ends it.
    }
}

/// A slave that is kept alive may fail its boot while it runs: nobody else looks at it any more. [SRS_BOOT_013]
void Cia302Master::VerifyRunning(const BootTime& time) noexcept
{
    for (std::uint8_t id = 1U; (id <= kLastNode) && (step_ != MasterStep::kIdle); ++id)
    {
        const NodeId node{id};
        const BootRecord& record = boot_.Record(node);
        const bool has_failed = (record.status.letter != '\0') && !record.is_booted && !record.status.is_busy;
        const SlaveState state = parts_.table.Record(node).state;
        const bool is_untold = (state == SlaveState::kUnknown) && parts_.setup.Slave(node).Has(kKeepAlive);
        const bool is_running = (state == SlaveState::kOperational) || is_untold;
        const bool is_closed = parts_.setup.IsSafetySlave(node) && (parts_.gate.State(node) == GateState::kClosed);
        if (has_failed && is_running && is_closed)
        {
            boot_.Verify(node, time);
        }
    }
}

void Cia302Master::TellSent(const Instant now) noexcept
{
    TellStep(now);
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        BootRecord& record = boot_.Record(NodeId{id});
        const bool has_started = record.is_start_waiting && !parts_.nmt.IsStarting(NodeId{id});
        const bool has_left = record.is_end_waiting && !parts_.nmt.IsLeaving(NodeId{id});
        record.is_start_waiting = record.is_start_waiting && !has_started;
        record.is_end_waiting = record.is_end_waiting && !has_left;
        if (has_started || has_left)
        {
            parts_.listener.OnNodeStatus(NodeId{id}, now);
        }
    }
}

void Cia302Master::SendStart(const BootTime& time) noexcept
{
    if (is_start_due_)
    {
        StartSlaves(time);
    }
}

bool Cia302Master::IsAnyHeld() const noexcept
{
    bool is_any = false;
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        is_any = is_any || boot_.Record(NodeId{id}).is_held;
    }
    return is_any;
}

bool Cia302Master::IsAnyRefused() const noexcept
{
    bool is_any = false;
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        is_any = is_any || boot_.IsRefused(NodeId{id});
    }
    return is_any;
}

/// With one start for all if that hits booted slaves only, none that must be verified, none that a command holds, and
/// none that was refused, which may be one that is not booted.
void Cia302Master::StartSlaves(const BootTime& time) noexcept
{
    is_start_due_ = false;
    const bool is_known = !IsAnyHeld() && !IsAnyRefused();
    const bool is_together = !parts_.setup.HasSafetySlave() && IsEach(kInNetwork | kBootSlave, true) && is_known;
    const bool is_taken =
        is_together && (parts_.nmt.Request(NmtCommand::kStart, kAllNodes, time.now) == NmtAnswer::kTaken);
    is_start_due_ = is_together && !is_taken;
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const NodeId node{id};
        BootRecord& record = boot_.Record(node);
        const bool is_meant =
            parts_.setup.IsListed(node) && parts_.setup.Slave(node).Has(kBootSlave) && record.is_booted;
        if (is_meant && is_taken)
        {
            record.NoteCommand(true, parts_.nmt.IsStarting(node), parts_.nmt.IsLeaving(node));
            parts_.listener.OnNodeStatus(node, time.now);
        }
        else if (is_meant && !is_together && !record.was_operational && !record.is_held)
        {
            boot_.Start(node, time);
        }
    }
}

/// Without a node-ID of its own the master has no NMT state to change, and node 0 would be everybody.
NmtAnswer Cia302Master::CommandOwn(const NmtCommand command, const BootTime& time) noexcept
{
    const bool has_own = (parts_.setup.own.value != kAllNodes.value);
    const NmtAnswer answer = has_own ? parts_.nmt.Request(command, parts_.setup.own, time.now) : NmtAnswer::kTaken;
    const bool is_start = (command == NmtCommand::kStart);
    const bool was_operational = IsOperational();
    if ((answer == NmtAnswer::kTaken) && is_start && (step_ != MasterStep::kIdle))
    {
        Obey(command, time.now);
        const bool is_due = parts_.setup.Has(kStartAllAtOnce) && !parts_.setup.Has(kApplicationStartsSlaves);
        if (is_due && !was_operational)
        {
            StartSlaves(time);
        }
    }
    else if (answer == NmtAnswer::kTaken)
    {
        Obey(command, time.now);
    }
    else
    {
        // Not ordered.
    }
    return answer;
}

void Cia302Master::Obey(const NmtCommand command, const Instant now) noexcept
{
    const bool is_hold = (command == NmtCommand::kStop) || (command == NmtCommand::kPreOperational);
    is_self_due_ = false;
    if (command == NmtCommand::kStart)
    {
        is_held_ = false;
        Go(MasterEvent::kStart, now);
    }
    else
    {
        is_held_ = is_held_ || (is_hold && (step_ != MasterStep::kIdle));
        Go(IsOperational() ? MasterEvent::kLeave : MasterEvent::kNone, now);
    }
}

bool Cia302Master::IsOperational() const noexcept
{
    return step_ == MasterStep::kOperational;
}

} // namespace counterpoint::cia302
