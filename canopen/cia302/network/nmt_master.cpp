// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia302/network/nmt_master.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint32_t kUsPerInhibitUnit = 100U;
constexpr std::uint32_t kFreshUs = 10000U; ///< What was verified before a start is not older when the start leaves.

} // namespace

NmtMaster::NmtMaster(const NmtMasterParts& parts) noexcept
    : parts_(parts), first_(0U), waiting_(0U), dropped_(0U), last_{0U}, has_sent_(false), is_sending_(false),
      is_active_(false), is_hurried_(false)
{
}

void NmtMaster::SetActive(const bool is_active) noexcept
{
    is_active_ = is_active;
    waiting_ = is_active ? waiting_ : std::uint16_t{0U};
}

NmtAnswer NmtMaster::Check(const NmtRequest& request) const noexcept
{
    const bool is_start = (request.command == NmtCommand::kStart);
    NmtAnswer answer = NmtAnswer::kTaken;
    if (!IsNmtCommand(request.command) || (request.node.value > kLastNode))
    {
        answer = NmtAnswer::kWrong;
    }
    else if (!is_active_)
    {
        answer = NmtAnswer::kNotActive;
    }
    else if (is_start && (request.node.value == kAllNodes.value))
    {
        answer = parts_.setup.HasSafetySlave() ? NmtAnswer::kNoBroadcast : NmtAnswer::kTaken;
    }
    else if (is_start && parts_.setup.IsSafetySlave(request.node) && !parts_.gate.MayStart(request.node))
    {
        answer = NmtAnswer::kNotVerified;
    }
    return answer;
}

NmtRequest& NmtMaster::At(const std::uint16_t place) const noexcept
{
    return parts_.room.requests[(std::uint32_t{first_} + place) % parts_.room.count];
}

/// As the last one for its node: behind it nothing would change. A start counts from its order on, and the stop of a
/// refused slave may be dropped: IsStale.
bool NmtMaster::IsWaiting(const NmtRequest& request) const noexcept
{
    bool is_waiting = false;
    for (std::uint16_t i = 0U; i < waiting_; ++i)
    {
        const NmtRequest& other = At(i);
        const bool is_same = (other.node.value == request.node.value);
        const bool is_all = (other.node.value == kAllNodes.value) || (request.node.value == kAllNodes.value);
        const bool is_alike = is_same && (other.command == request.command) && !other.is_halt;
        is_waiting = (is_same || is_all) ? is_alike : is_waiting;
    }
    return is_waiting && (request.command != NmtCommand::kStart);
}

/// At the end; a stop of one node before what waits for others: who has to be stopped runs as long as it waits. It goes
/// before no other stop, and before nothing that is for this node or for all.
void NmtMaster::Put(const NmtRequest& request) noexcept
{
    std::uint16_t place = waiting_;
    bool is_urgent = (request.command == NmtCommand::kStop) && (request.node.value != kAllNodes.value);
    while (is_urgent && (place > 0U))
    {
        const NmtRequest& before = At(static_cast<std::uint16_t>(place - 1U));
        const bool is_meant = (before.node.value == request.node.value) || (before.node.value == kAllNodes.value);
        is_urgent = !is_meant && (before.command != NmtCommand::kStop);
        if (is_urgent)
        {
            At(place) = before;
            --place;
        }
    }
    At(place) = request;
    ++waiting_;
}

NmtAnswer NmtMaster::Request(const NmtCommand command, const NodeId node, const Instant now) noexcept
{
    const NmtRequest request{command, node, now};
    NmtAnswer answer = Check(request);
    const bool is_new = (answer == NmtAnswer::kTaken) && !IsWaiting(request);
    if (is_new && (waiting_ >= parts_.room.count))
    {
        answer = NmtAnswer::kQueueFull;
    }
    else if (is_new)
    {
        Put(request);
        SendUnlessSending(now);
    }
    else
    {
        // Refused, or it waits already.
    }
    return answer;
}

/// One that waits already keeps its place.
NmtAnswer NmtMaster::Halt(const NodeId node, const Instant now) noexcept
{
    const NmtRequest request{NmtCommand::kStop, node, now, true};
    NmtAnswer answer = Check(request);
    const bool is_new = (answer == NmtAnswer::kTaken) && !IsHalting(node);
    if (is_new && (waiting_ >= parts_.room.count))
    {
        answer = NmtAnswer::kQueueFull;
    }
    else if (is_new)
    {
        Supersede(node);
        PutFirst(request);
        SendUnlessSending(now);
    }
    else
    {
        // Refused, or it waits already.
    }
    return answer;
}

void NmtMaster::SendUnlessSending(const Instant now) noexcept
{
    if (!is_sending_)
    {
        OnCycle(now);
    }
}

bool NmtMaster::IsHalting(const NodeId node) const noexcept
{
    bool is_halting = false;
    for (std::uint16_t i = 0U; i < waiting_; ++i)
    {
        const NmtRequest& request = At(i);
        is_halting = is_halting || (request.is_halt && (request.node.value == node.value));
    }
    return is_halting;
}

/// What waits for the node would undo its stop. A reset does not: its start-up begins anew behind it, and what was
/// asked for later is for the time behind it. Nor does the stop of an order, which leaves whatever becomes of this one.
void NmtMaster::Supersede(const NodeId node) noexcept
{
    bool is_before = true;
    for (std::uint16_t i = 0U; i < waiting_; ++i)
    {
        NmtRequest& request = At(i);
        const bool is_it = (request.node.value == node.value);
        const bool is_reset =
            (request.command == NmtCommand::kResetNode) || (request.command == NmtCommand::kResetCommunication);
        is_before = is_before && !(is_it && is_reset);
        const bool is_undone = is_it && is_before && (request.command != NmtCommand::kStop);
        request.command = is_undone ? NmtCommand::kInvalid : request.command; // Falls out when its turn comes.
    }
}

/// Behind other stops of refused slaves alone: each of them runs as long as its stop waits.
void NmtMaster::PutFirst(const NmtRequest& request) noexcept
{
    std::uint16_t place = waiting_;
    while ((place > 0U) && !At(static_cast<std::uint16_t>(place - 1U)).is_halt)
    {
        At(place) = At(static_cast<std::uint16_t>(place - 1U));
        --place;
    }
    At(place) = request;
    ++waiting_;
}

NmtAnswer NmtMaster::RequestEach(const NmtCommand command, const NodeId except, const Instant now) noexcept
{
    NmtAnswer worst = NmtAnswer::kTaken;
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        if (parts_.setup.IsListed(NodeId{id}) && (id != except.value))
        {
            const NmtAnswer answer = Request(command, NodeId{id}, now);
            worst = (worst == NmtAnswer::kTaken) ? answer : worst;
        }
    }
    return worst;
}

void NmtMaster::DropStarts(const NodeId node) noexcept
{
    for (std::uint16_t i = 0U; i < waiting_; ++i)
    {
        NmtRequest& request = At(i);
        const bool is_it = (request.command == NmtCommand::kStart) && (request.node.value == node.value);
        request.command = is_it ? NmtCommand::kInvalid : request.command; // Falls out when its turn comes.
    }
}

bool NmtMaster::IsLeaving(const NodeId node) const noexcept
{
    bool is_leaving = false;
    for (std::uint16_t i = 0U; i < waiting_; ++i)
    {
        const NmtRequest& request = At(i);
        const bool is_meant = (request.node.value == node.value) || (request.node.value == kAllNodes.value);
        const bool is_end = (request.command != NmtCommand::kStart) && (request.command != NmtCommand::kInvalid);
        is_leaving = is_leaving || (is_meant && is_end);
    }
    return is_leaving;
}

bool NmtMaster::HasStart(const NodeId node) const noexcept
{
    bool has_one = false;
    for (std::uint16_t i = 0U; i < waiting_; ++i)
    {
        const NmtRequest& request = At(i);
        has_one = has_one || ((request.command == NmtCommand::kStart) && (request.node.value == node.value));
    }
    return has_one;
}

/// A start of a safety slave that waited too long: the slave may have been changed meanwhile. [SRS_SFS_152] The stop of
/// a refused one that was verified meanwhile. [SRS_NMM_771]
bool NmtMaster::IsStale(const NmtRequest& request, const Instant now) const noexcept
{
    const bool is_start = (request.command == NmtCommand::kStart);
    const bool is_late = (now.us - request.since.us) > kFreshUs;
    const bool is_stale = request.is_halt ? parts_.gate.MayStart(request.node) : (is_start && is_late);
    return is_stale && parts_.setup.IsSafetySlave(request.node);
}

/// A command that comes too soon behind another one is better than none.
void NmtMaster::Finish(const Instant now) noexcept
{
    is_hurried_ = true;
    OnCycle(now);
    is_hurried_ = false;
}

/// In order: what waits for the inhibit time or for room in the sink keeps all behind it waiting.
void NmtMaster::OnCycle(const Instant now) noexcept
{
    bool is_going = true;
    const std::uint32_t inhibit_us = kUsPerInhibitUnit * parts_.setup.inhibit_100us;
    has_sent_ = has_sent_ && ((now.us - last_.us) < inhibit_us); // In each cycle: the counter comes round.
    is_sending_ = true;
    while (is_going && (waiting_ > 0U))
    {
        const NmtRequest request = parts_.room.requests[first_];
        const bool is_right = (Check(request) == NmtAnswer::kTaken) && !IsStale(request, now);
        is_going = !is_right || Emit(request, now);
        if (is_going)
        {
            first_ = static_cast<std::uint16_t>((first_ + 1U) % parts_.room.count);
            --waiting_;
            dropped_ += is_right ? 0U : 1U;
            if (is_right)
            {
                parts_.table.OnNmtSent(request, now);
                parts_.listener.OnNmtSent(request, now);
            }
            else if (request.command == NmtCommand::kStart)
            {
                parts_.listener.OnStartDropped(request.node, now);
            }
            else
            {
                // Of no concern any more.
            }
        }
    }
    is_sending_ = false;
}

/// Whether it left. What is for the own node alone does not go to the bus.
bool NmtMaster::Emit(const NmtRequest& request, const Instant now) noexcept
{
    const bool is_broadcast = (request.node.value == kAllNodes.value); // A master without node-ID has this one too.
    bool has_left = !is_broadcast && (request.node.value == parts_.setup.own.value);
    const bool is_inhibited = has_sent_ && !is_hurried_ && (parts_.setup.inhibit_100us > 0U);
    if (!has_left && !is_inhibited)
    {
        const CanFrame frame{0U,
                             FrameKind::kData,
                             CanPortId::kFirst,
                             2U,
                             {static_cast<std::uint8_t>(request.command), request.node.value}};
        has_left = parts_.sink.Send(frame);
        has_sent_ = has_left;
        last_ = now;
    }
    return has_left;
}

} // namespace counterpoint::cia302
