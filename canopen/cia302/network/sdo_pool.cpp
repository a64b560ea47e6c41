// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia302/network/sdo_pool.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint32_t kAnswers = 0x580U;

} // namespace

SdoPool::SdoPool(const SdoLaneRoom& room, const SdoTimes& times) noexcept
    : room_(room), times_(times), last_{0U}, quiet_us_(times.time_out_us)
{
    times_.tries = (times_.tries > 0U) ? times_.tries : std::uint8_t{1U};
}

SdoLane* SdoPool::Find(const NodeId node) const noexcept
{
    SdoLane* found = nullptr;
    // With a lane for each node it stands at its own place, unless lanes have changed hands.
    const std::uint32_t likely = (node.value >= 1U) ? (node.value - 1U) : 0U;
    if ((likely < room_.count) && (room_.lanes[likely].client.Server().value == node.value))
    {
        found = &room_.lanes[likely];
    }
    for (std::uint8_t i = 0U; (found == nullptr) && (i < room_.count); ++i)
    {
        found = (room_.lanes[i].client.Server().value == node.value) ? &room_.lanes[i] : nullptr;
    }
    return found;
}

/// The node's lane, or an idle one that becomes its own; null: all others are busy, or its own is.
SdoLane* SdoPool::Claim(const NodeId node) noexcept
{
    SdoLane* lane = Find(node);
    for (std::uint8_t i = 0U; (lane == nullptr) && (i < room_.count); ++i)
    {
        SdoLane& other = room_.lanes[i];
        const bool is_settled = (other.state != TransferState::kBusy) && (other.idle_cycles >= kSettled);
        lane = (is_settled && other.client.Connect(node)) ? &other : nullptr;
        other.state = (lane != nullptr) ? TransferState::kIdle : other.state;
    }
    return ((lane != nullptr) && (lane->state != TransferState::kBusy)) ? lane : nullptr;
}

bool SdoPool::Upload(const NodeId node, const ObjectAddress& object, const Room& room, const SdoMode mode,
                     const Instant now) noexcept
{
    SdoLane* const lane = Claim(node);
    if (lane != nullptr)
    {
        lane->object = object;
        lane->room = room;
        lane->mode = mode;
        lane->is_upload = true;
        lane->tries_left = times_.tries;
        Begin(*lane, now);
    }
    return lane != nullptr;
}

bool SdoPool::Download(const NodeId node, const ObjectAddress& object, const Bytes& value, const SdoMode mode,
                       const Instant now) noexcept
{
    SdoLane* const lane = Claim(node);
    if (lane != nullptr)
    {
        lane->object = object;
        lane->value = value;
        lane->mode = mode;
        lane->is_upload = false;
        lane->tries_left = times_.tries;
        Begin(*lane, now);
    }
    return lane != nullptr;
}

void SdoPool::TryOnce(const NodeId node) noexcept
{
    SdoLane* const lane = Find(node);
    if (lane != nullptr)
    {
        lane->tries_left = 0U;
    }
}

/// One try. The client is free: nothing that runs is taken from it.
void SdoPool::Begin(SdoLane& lane, const Instant now) noexcept
{
    --lane.tries_left;
    lane.idle_cycles = 0U;
    const bool has_begun = lane.is_upload ? lane.client.StartUpload(lane.object, lane.room, lane.mode, now)
                                          : lane.client.StartDownload(lane.object, lane.value, lane.mode, now);
    lane.state = has_begun ? TransferState::kBusy : TransferState::kFailed;
}

TransferState SdoPool::State(const NodeId node) const noexcept
{
    const SdoLane* const lane = Find(node);
    return (lane != nullptr) ? lane->state : TransferState::kIdle;
}

SdoOutcome SdoPool::Outcome(const NodeId node) const noexcept
{
    const SdoLane* const lane = Find(node);
    return (lane != nullptr) ? lane->client.Outcome() : SdoOutcome{SdoAbort::kNoConnection, false, 0U};
}

void SdoPool::Cancel(const NodeId node, const SdoAbort reason) noexcept
{
    SdoLane* const lane = Find(node);
    if ((lane != nullptr) && (lane->state == TransferState::kBusy))
    {
        lane->client.Cancel(reason);
        lane->state = TransferState::kFailed;
    }
}

void SdoPool::OnBootUp(const NodeId node) noexcept
{
    SdoLane* const lane = Find(node);
    if (lane != nullptr)
    {
        lane->client.OnServerRestart();
        lane->state = (lane->state == TransferState::kBusy) ? TransferState::kFailed : lane->state;
    }
}

void SdoPool::OnFrame(const CanFrame& frame, const Instant now) noexcept
{
    const bool is_answer = (frame.identifier > kAnswers) && (frame.identifier <= (kAnswers + kLastNode));
    SdoLane* const lane = is_answer ? Find(NodeId{static_cast<std::uint8_t>(frame.identifier & kLastNode)}) : nullptr;
    if (lane != nullptr)
    {
        lane->client.OnFrame(frame, now);
        Settle(*lane, now);
    }
}

void SdoPool::OnCycle(const Instant now) noexcept
{
    const std::uint32_t passed_us = now.us - last_.us;
    const bool is_long = passed_us >= (times_.time_out_us - quiet_us_);
    quiet_us_ = is_long ? times_.time_out_us : (quiet_us_ + passed_us);
    last_ = now;
    for (std::uint8_t i = 0U; i < room_.count; ++i)
    {
        SdoLane& lane = room_.lanes[i];
        lane.client.OnCycle(now);
        Settle(lane, now);
        quiet_us_ = (lane.state == TransferState::kBusy) ? 0U : quiet_us_;
        lane.idle_cycles = (lane.idle_cycles < kSettled) ? static_cast<std::uint8_t>(lane.idle_cycles + 1U) : kSettled;
    }
}

/// Takes over what the client has come to. Silence is tried again; every other end is one.
void SdoPool::Settle(SdoLane& lane, const Instant now) noexcept
{
    if (lane.state == TransferState::kBusy)
    {
        const cia301::SdoClientState state = lane.client.State();
        lane.idle_cycles = 0U;
        const SdoOutcome& outcome = lane.client.Outcome();
        const bool is_silence = (outcome.abort == SdoAbort::kTimeOut) && !outcome.by_server;
        if (state == cia301::SdoClientState::kDone)
        {
            lane.state = TransferState::kDone;
        }
        else if ((state == cia301::SdoClientState::kAborted) && is_silence && (lane.tries_left > 0U))
        {
            Begin(lane, now);
        }
        else if (state == cia301::SdoClientState::kAborted)
        {
            lane.state = TransferState::kFailed;
        }
    }
}

} // namespace counterpoint::cia302
