// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/start_up/el6751/release.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint8_t kStoppedByte = 4U; ///< As 1F82h reads it.

} // namespace

El6751Release::El6751Release(El6751Slaves& slaves, El6751Pdos& pdos, El6751Stops& stops) noexcept
    : parts_(slaves.Parts()), slaves_(slaves), pdos_(pdos), stops_(stops), reader_(slaves.Parts())
{
}

void El6751Release::Begin(const NodeId node, const Instant now) noexcept
{
    const El6751Node& slave = slaves_.Of(node);
    const bool is_started = slaves_.SetupOf(node).is_started && !slave.is_held_by_hand;
    Supervise(node, now);
    if (is_started || slave.is_start_wanted)
    {
        Start(node, now);
    }
    else
    {
        stops_.Hold(node, kNodePreOperational, now);
    }
}

/// Heartbeat if the slave took it, else guarding; what the network's list says if this profile has no times.
void El6751Release::Supervise(const NodeId node, const Instant now) noexcept
{
    const El6751Slave& setup = slaves_.SetupOf(node);
    NodeTable& table = parts_.table;
    constexpr std::uint32_t kLongestTime = 0xFFFFU;
    const std::uint32_t life_ms = std::uint32_t{setup.guard_time_ms} * setup.life_time_factor;
    const auto time_ms = static_cast<std::uint16_t>((life_ms > kLongestTime) ? kLongestTime : life_ms);
    const std::uint16_t listed_ms = parts_.setup.Slave(node).heartbeat.consumer_ms;
    const bool was_lost = (table.Record(node).state == SlaveState::kMissing);
    if (!setup.IsWatched() && was_lost && (listed_ms > 0U))
    {
        table.WatchHeartbeat(node, listed_ms, Arming::kImmediately, now); // It was there once.
    }
    else if (!setup.IsWatched())
    {
        table.WatchAsSetUp(node, now);
    }
    else if (slaves_.Of(node).place.is_heartbeat_aborted)
    {
        table.WatchGuarding(node, setup.guard_time_ms, setup.life_time_factor, now);
    }
    else if (slaves_.Of(node).place.is_heartbeat_answered)
    {
        table.WatchHeartbeat(node, time_ms, Arming::kImmediately, now);
    }
    else
    {
        // Started by hand after a start-up that did not come so far: it was told to send nothing.
    }
}

void El6751Release::Start(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    slave.is_requested = false;
    slave.is_held_by_hand = false;
    slave.is_start_wanted = false;
    slave.reading = SafetyReading{};
    slave.control_fault = 0;
    slave.phase = Next(slave.phase, slaves_.IsSafety(node) ? El6751Event::kVerify : El6751Event::kStart);
    slaves_.Tell(node, kNodeStarts, slaves_.IsSafety(node) ? StartUpStep::kSafety : StartUpStep::kStart, now);
    Drive(node, now);
}

void El6751Release::Drive(const NodeId node, const Instant now) noexcept
{
    if (slaves_.Of(node).phase == El6751Phase::kVerify)
    {
        DriveVerify(node, now);
    }
    else if (slaves_.Of(node).phase == El6751Phase::kStarting)
    {
        DriveStart(node, now);
    }
}

/// The gate reads; a STOPPED slave has no SDO and is made PRE-OPERATIONAL before.
void El6751Release::DriveVerify(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    const bool is_deaf =
        (parts_.table.Record(node).asked == SlaveState::kStopped) || (parts_.table.RequestValue(node) == kStoppedByte);
    const ReadingEnd end = reader_.BeforeStart(slave.reading, node, is_deaf, now);
    if (end == ReadingEnd::kOpen)
    {
        slave.reading = SafetyReading{};
        slave.phase = Next(slave.phase, El6751Event::kStart);
        slaves_.Tell(node, kNodeStarts, StartUpStep::kStart, now);
        DriveStart(node, now);
    }
    else if (end == ReadingEnd::kRefused)
    {
        stops_.Refuse(node, now);
    }
    else
    {
        // The gate or the queue is waited for.
    }
}

void El6751Release::OnStartDropped(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    if ((slave.phase == El6751Phase::kStarting) && slave.is_requested)
    {
        slave.phase = Next(slave.phase, El6751Event::kVerify);
        slave.is_requested = false;
        slave.reading = SafetyReading{};
        slaves_.Tell(node, kNodeStarts, StartUpStep::kSafety, now);
    }
}

void El6751Release::DriveStart(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    if (!slave.is_requested)
    {
        pdos_.Await(node);
        const NmtAnswer answer = parts_.nmt.Request(NmtCommand::kStart, node, now);
        slave.is_requested = (answer == NmtAnswer::kTaken);
        if (answer == NmtAnswer::kNotVerified)
        {
            slave.phase = Next(slave.phase, El6751Event::kVerify);
        }
    }
    if (slave.is_requested && (parts_.table.Record(node).asked == SlaveState::kOperational))
    {
        Run(node, now);
    }
}

void El6751Release::Run(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    slave.phase = Next(slave.phase, El6751Event::kRun);
    slave.started = now;
    slave.signs = parts_.table.Record(node).signs;
    slave.is_settled = false;
    slave.is_wait_over = false;
    slave.was_operational = false;
    slave.control_fault = 0;
    slave.was_started = true;
    slave.status.is_started = true;
    const NodeRecord& record = parts_.table.Record(node);
    if ((record.watch == Watch::kNone) || (record.state == SlaveState::kMissing))
    {
        Supervise(node, now);
    }
    const bool has_all = pdos_.HasAll(node);
    slaves_.Tell(node, has_all ? kNodeRuns : kNodeWaitsForPdos,
                 has_all ? StartUpStep::kRunning : StartUpStep::kWaitPdos, now);
}

} // namespace counterpoint::cia302
