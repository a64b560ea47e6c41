// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Course of the start-up. Commands and error handling are in a file of their own.
#include "canopen/start_up/cia302/start_up.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint32_t kAnswers = 0x580U;
constexpr std::uint32_t kErrorControl = 0x700U;
constexpr std::uint32_t kLongestExpectMs = 1'000'000U; ///< See NodeTable::Expect.
constexpr std::uint8_t kBehindLast = kLastNode + 1U;

} // namespace

Cia302StartUp::Cia302StartUp(const StartUpParts& parts, BootRecord* const records) noexcept
    : parts_(parts), boot_(parts, records, *this), step_(MasterStep::kIdle), reset_(NmtCommand::kResetCommunication),
      cursor_(0U), reaction_(Reaction::kNone), is_start_due_(false), has_news_(false), clock_us_(0U), last_{0U},
      has_clock_(false)
{
}

/// The count goes on as far as the counter did since the call before.
BootTime Cia302StartUp::Tick(const Instant now) noexcept
{
    const std::uint32_t passed_us = has_clock_ ? (now.us - last_.us) : 0U;
    clock_us_ += passed_us;
    last_ = now;
    has_clock_ = true;
    return BootTime{now, clock_us_};
}

void Cia302StartUp::Go(const MasterEvent event, const Instant now) noexcept
{
    const MasterStep step = Next(step_, event);
    if (step != step_)
    {
        step_ = step;
        parts_.listener.OnMasterState(MasterState(), now);
    }
}

void Cia302StartUp::Begin(const Instant now) noexcept
{
    static_cast<void>(Tick(now));
    End();
    if (parts_.setup.Has(kIsMaster))
    {
        Restart(NmtCommand::kResetCommunication, now);
    }
}

void Cia302StartUp::End() noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        boot_.End(NodeId{id});
        boot_.Record(NodeId{id}) = BootRecord{};
        parts_.table.Unwatch(NodeId{id});
        parts_.gate.Close(NodeId{id});
    }
    reaction_ = Reaction::kNone;
    is_start_due_ = false;
    Go(MasterEvent::kEnd, last_);
}

/// From the resets on.
void Cia302StartUp::Restart(const NmtCommand reset, const Instant now) noexcept
{
    End();
    reset_ = reset;
    const bool is_singly = (reset == NmtCommand::kResetCommunication) && HasKeptAlive();
    cursor_ = is_singly ? std::uint8_t{1U} : std::uint8_t{0U};
    Go(MasterEvent::kReset, now);
    SendResets(Tick(now));
}

bool Cia302StartUp::HasKeptAlive() const noexcept
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
void Cia302StartUp::SendResets(const BootTime& time) noexcept
{
    bool is_going = true;
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
void Cia302StartUp::BootAll(const BootTime& time) noexcept
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
        if (is_new && (limit_ms > 0U))
        {
            parts_.table.Expect(node, limit_ms, time.now);
        }
    }
    has_news_ = true;
}

/// Whether all listed slaves with these bits are booted, or none of them has failed.
bool Cia302StartUp::IsEach(const std::uint32_t bits, const bool is_booted) const noexcept
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

/// The master follows its mandatory slaves. Called at the end of a call, not inside a boot.
void Cia302StartUp::GoOn(const BootTime& time) noexcept
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
        if (!parts_.setup.Has(kApplicationStartsSelf))
        {
            static_cast<void>(CommandOwn(NmtCommand::kStart, time));
        }
    }
    else if (is_waiting)
    {
        Go(MasterEvent::kAgain, time.now);
    }
}

/// A slave that is kept alive may fail its boot while it runs: nobody else looks at it any more. [SRS_BOOT_013]
void Cia302StartUp::VerifyRunning(const BootTime& time) noexcept
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

/// With one start for all if that hits booted slaves only, and none that must be verified.
void Cia302StartUp::StartSlaves(const BootTime& time) noexcept
{
    is_start_due_ = false;
    const bool is_together = !parts_.setup.HasSafetySlave() && IsEach(kInNetwork | kBootSlave, true);
    const bool is_sent =
        is_together && (parts_.nmt.Request(NmtCommand::kStart, kAllNodes, time.now) == NmtAnswer::kTaken);
    is_start_due_ = is_together && !is_sent;
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const NodeId node{id};
        BootRecord& record = boot_.Record(node);
        const bool is_meant =
            parts_.setup.IsListed(node) && parts_.setup.Slave(node).Has(kBootSlave) && record.is_booted;
        if (is_meant && is_sent)
        {
            record.status.is_started = true;
        }
        else if (is_meant && !is_together && !record.was_operational)
        {
            boot_.Start(node, time);
        }
    }
}

void Cia302StartUp::OnBooted(const NodeId /*node*/, const BootTime& /*time*/) noexcept
{
    has_news_ = true;
}

void Cia302StartUp::OnBootFailed(const NodeId node, const BootTime& /*time*/) noexcept
{
    const bool is_unsafe = (boot_.Record(node).status.step == StartUpStep::kSafety);
    if (is_unsafe && parts_.setup.Slave(node).Has(kMandatory) && parts_.setup.Has(kStopAllOnError))
    {
        reaction_ = Reaction::kStopAll;
    }
    has_news_ = true;
}

bool Cia302StartUp::IsMasterOperational() const noexcept
{
    return step_ == MasterStep::kOperational;
}

void Cia302StartUp::OnFrame(const CanFrame& frame, const Instant now) noexcept
{
    const BootTime time = Tick(now);
    const std::uint32_t service = frame.identifier & ~std::uint32_t{kLastNode};
    const NodeId node{static_cast<std::uint8_t>(frame.identifier & kLastNode)};
    const bool is_of_slave = (service == kAnswers) || (service == kErrorControl);
    if (is_of_slave && parts_.setup.IsListed(node))
    {
        boot_.OnCycle(node, time);
        GoOn(time);
    }
    if ((service == kErrorControl) && parts_.setup.IsSafetySlave(node))
    {
        VerifyAgain(node, time);
    }
}

/// It runs, but its gate was closed since it was started: it may have left OPERATIONAL and come back between two signs.
/// [SRS_BOOT_013]
void Cia302StartUp::VerifyAgain(const NodeId node, const BootTime& time) noexcept
{
    const GateState gate = parts_.gate.State(node);
    const bool is_closed = (gate != GateState::kOpen) && (gate != GateState::kBusy);
    const bool is_past_resets = (step_ != MasterStep::kIdle) && (step_ != MasterStep::kReset);
    const bool is_quiet = !boot_.Record(node).status.is_busy && (parts_.nmt.Waiting() == 0U); // No stop on its way.
    if (is_closed && is_past_resets && is_quiet && parts_.table.RunsSurely(node))
    {
        boot_.Verify(node, time);
    }
}

void Cia302StartUp::OnCycle(const Instant now) noexcept
{
    const BootTime time = Tick(now);
    if (step_ == MasterStep::kReset)
    {
        SendResets(time);
    }
    React(time);
    if (is_start_due_)
    {
        StartSlaves(time);
    }
    for (std::uint8_t id = 1U; (step_ != MasterStep::kIdle) && (id <= kLastNode); ++id)
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
    has_news_ = has_news_ || (step_ == MasterStep::kHalted); // What halts it may be mandatory no more.
    GoOn(time);
}

NodeStatus Cia302StartUp::Status(const NodeId node) const noexcept
{
    return boot_.Record(node).status;
}

std::int16_t Cia302StartUp::MasterState() const noexcept
{
    return static_cast<std::int16_t>(step_);
}

} // namespace counterpoint::cia302
