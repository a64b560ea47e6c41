// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/virtual/bus_events.hpp"

#include "hal/host/virtual/frame_bits.hpp"

#include <algorithm>

namespace counterpoint::host
{

namespace
{

constexpr std::uint32_t kTransmitErrorWeight = 8U;
/// Superposed error flags of all nodes at their longest, and the delimiter. [SRS_BUS_007]
constexpr std::uint16_t kErrorFrameBits = 12U + 8U;
/// A frame that starts at t is chosen just after t, so that everything submitted at t takes part. [SRS_BUS_003]
constexpr BusTime kChoiceDelay = 1;

void CountDown(std::uint32_t& errors)
{
    errors -= (errors > 0U) ? 1U : 0U;
}

/// Whether whoever sends is acknowledged.
bool IsHeardByOthers(const std::vector<BusNode>& nodes)
{
    std::size_t on_bus = 0U;
    for (const BusNode& node : nodes)
    {
        on_bus += node.IsOnBus() ? 1U : 0U;
    }
    return on_bus > 1U;
}

} // namespace

BusEvents::BusEvents(const BitRate rate, std::vector<BusNode>& nodes, const std::vector<BusFault*>& faults)
    : bit_time_(BitTime(rate)), nodes_(nodes), faults_(faults)
{
}

void BusEvents::OnAttached()
{
    senders_.reserve(nodes_.size());
    deliveries_.reserve(nodes_.size());
}

void BusEvents::Plan(const NodeIndex node, const CanFrame& frame, const BusTime at)
{
    PlanEvent(PlannedEvent{std::max(at, now_), NextOrder(), node, frame, EventKind::kReception});
    Schedule();
}

void BusEvents::OnWaiting()
{
    Arm();
    Schedule();
}

void BusEvents::Run(const BusTime until, BusObserver* const observer)
{
    while (next_event_ <= until)
    {
        now_ = std::max(now_, next_event_);
        if (!planned_.empty() && (planned_.front().at <= now_))
        {
            RunPlanned();
        }
        else if (frame_end_ <= now_)
        {
            FinishFrame(observer);
        }
        else
        {
            Arbitrate();
        }
        Schedule();
    }
}

bool BusEvents::IsLater(const PlannedEvent& left, const PlannedEvent& right)
{
    return (left.at != right.at) ? (left.at > right.at) : (left.order > right.order);
}

void BusEvents::RunPlanned()
{
    std::pop_heap(planned_.begin(), planned_.end(), IsLater);
    const PlannedEvent event = planned_.back();
    planned_.pop_back();
    Deliver(event);
}

void BusEvents::PlanEvent(const PlannedEvent& event)
{
    planned_.push_back(event);
    std::push_heap(planned_.begin(), planned_.end(), IsLater);
}

void BusEvents::Arbitrate()
{
    const BusTime start = arbitration_at_;
    arbitration_at_ = kNever;
    if (!TakeWinners())
    {
        return;
    }
    const Sender& first = senders_.front();
    record_.sent = FrameOnBus{first.queued.frame, first.node, start, first.queued.attempt};
    record_.receivers = 0U;
    record_.bits = MeasureFrame(first.queued.frame).OnWire();
    record_.fate = FrameFate::kComplete;
    // Whatever destroys the frame first counts; bits are counted from 0.
    std::uint16_t last_bit = static_cast<std::uint16_t>(record_.bits - 1U);
    const auto destroy = [this, &last_bit](const std::uint16_t bit, const FrameFate fate)
    {
        last_bit = std::min(last_bit, bit);
        record_.fate = fate;
        record_.bits = static_cast<std::uint16_t>(last_bit + 1U + kErrorFrameBits);
    };
    const std::uint16_t ack_slot = static_cast<std::uint16_t>((record_.bits - kTrailerBits) + 1U);
    const std::uint16_t difference = FirstDifference();
    const std::uint16_t hit = FirstHit();
    if (!IsHeardByOthers(nodes_))
    {
        destroy(ack_slot, FrameFate::kNotAcknowledged);
    }
    if (difference <= last_bit)
    {
        destroy(difference, FrameFate::kCollision);
    }
    if ((hit != WireHit::kNone) && ((hit <= last_bit) || (record_.fate == FrameFate::kComplete)))
    {
        destroy(hit, FrameFate::kHit);
    }
    frame_end_ = start + (static_cast<BusTime>(record_.bits) * bit_time_);
}

bool BusEvents::TakeWinners()
{
    bool found = false;
    std::uint32_t lowest = 0U;
    for (const BusNode& node : nodes_)
    {
        const bool waits = node.IsOnBus() && !node.queue.IsEmpty();
        if (waits && (!found || (node.queue.Front().key < lowest)))
        {
            found = true;
            lowest = node.queue.Front().key;
        }
    }
    senders_.clear();
    for (NodeIndex index = 0U; found && (index < nodes_.size()); ++index)
    {
        BusNode& node = nodes_[index];
        const bool may_join = senders_.empty() || !takes_turns_;
        const bool waits = may_join && node.IsOnBus() && !node.queue.IsEmpty();
        if (waits && (node.queue.Front().key == lowest))
        {
            senders_.push_back(Sender{index, node.queue.Take()});
            ++senders_.back().queued.attempt;
        }
    }
    return found;
}

std::uint16_t BusEvents::FirstHit() const
{
    std::uint16_t first = WireHit::kNone;
    for (BusFault* const fault : faults_)
    {
        first = std::min(first, fault->OnWire(record_.sent).bit);
    }
    return first;
}

/// First bit in which the frames of several senders differ; WireHit::kNone if there is none.
std::uint16_t BusEvents::FirstDifference() const
{
    std::uint16_t first = WireHit::kNone;
    if (senders_.size() > 1U)
    {
        const WireImage image = DrawFrame(senders_.front().queued.frame);
        for (const Sender& sender : senders_)
        {
            const WireImage other = DrawFrame(sender.queued.frame);
            const auto found = std::mismatch(image.level.begin(), image.level.begin() + image.count,
                                             other.level.begin(), other.level.begin() + other.count);
            if (found.first != (image.level.begin() + image.count))
            {
                first = std::min(first, static_cast<std::uint16_t>(found.first - image.level.begin()));
            }
        }
    }
    return first;
}

bool BusEvents::IsSender(const NodeIndex node) const
{
    for (const Sender& sender : senders_)
    {
        if (sender.node == node)
        {
            return true;
        }
    }
    return false;
}

void BusEvents::FinishFrame(BusObserver* const observer)
{
    record_.end = frame_end_;
    frame_end_ = kNever;
    free_at_ = record_.end + (static_cast<BusTime>(kIntermissionBits) * bit_time_);
    for (const Sender& sender : senders_)
    {
        const BusNode& node = nodes_[sender.node];
        if (!node.IsOnBus() || !node.queue.IsSending())
        {
            record_.fate = FrameFate::kSenderGone;
        }
    }
    if (record_.fate == FrameFate::kComplete)
    {
        CompleteFrame(observer);
    }
    else
    {
        DestroyFrame(observer);
    }
    Arm();
}

void BusEvents::CompleteFrame(BusObserver* const observer)
{
    deliveries_.clear();
    for (NodeIndex index = 0U; index < nodes_.size(); ++index)
    {
        if (nodes_[index].IsOnBus() && !IsSender(index))
        {
            CountDown(nodes_[index].receive_errors);
            CollectReceptions(index);
        }
    }
    for (const Sender& sender : senders_)
    {
        BusNode& node = nodes_[sender.node];
        CountDown(node.transmit_errors);
        node.queue.Release();
        CollectConfirmation(sender.node);
    }
    if (observer != nullptr)
    {
        observer->OnBusRecord(record_);
    }
    for (const PlannedEvent& delivery : deliveries_)
    {
        Deliver(delivery);
    }
}

void BusEvents::DestroyFrame(BusObserver* const observer)
{
    CountErrors();
    for (const Sender& sender : senders_)
    {
        TransmitQueue& queue = nodes_[sender.node].queue;
        if (queue.IsSending())
        {
            queue.PutBack(sender.queued);
        }
    }
    if (observer != nullptr)
    {
        observer->OnBusRecord(record_);
    }
    for (const Sender& sender : senders_)
    {
        if (nodes_[sender.node].transmit_errors >= kBusOffFrom)
        {
            EnterBusOff(nodes_[sender.node], Absence::kErrors);
        }
    }
}

void BusEvents::CountErrors()
{
    for (NodeIndex index = 0U; index < nodes_.size(); ++index)
    {
        BusNode& node = nodes_[index];
        const bool sends = IsSender(index);
        const bool forgiven =
            (record_.fate == FrameFate::kNotAcknowledged) && (node.transmit_errors > kErrorPassiveAbove);
        if (node.IsOnBus() && sends && !forgiven)
        {
            node.transmit_errors += kTransmitErrorWeight;
        }
        if (node.IsOnBus() && !sends)
        {
            ++node.receive_errors;
        }
    }
}

void BusEvents::CollectReceptions(const NodeIndex receiver)
{
    receptions_.Clear();
    receptions_.Add(Reception{record_.sent.frame, 0});
    for (BusFault* const fault : faults_)
    {
        fault->OnReception(record_.sent, receiver, receptions_);
    }
    record_.receivers = static_cast<std::uint16_t>(record_.receivers + (receptions_.IsEmpty() ? 0U : 1U));
    Spread(receiver, EventKind::kReception);
}

void BusEvents::CollectConfirmation(const NodeIndex sender)
{
    receptions_.Clear();
    receptions_.Add(Reception{record_.sent.frame, 0});
    for (BusFault* const fault : faults_)
    {
        fault->OnConfirmation(record_.sent, receptions_);
    }
    Spread(sender, EventKind::kConfirmation);
}

void BusEvents::Spread(const NodeIndex node, const EventKind kind)
{
    for (const Reception& reception : receptions_)
    {
        const PlannedEvent event{now_ + std::max<BusTime>(reception.delay, 0), NextOrder(), node, reception.frame,
                                 kind};
        if (event.at > now_)
        {
            PlanEvent(event);
        }
        else
        {
            deliveries_.push_back(event);
        }
    }
}

void BusEvents::Deliver(const PlannedEvent& event)
{
    const BusNode& node = nodes_[event.node];
    if (!node.IsOnBus())
    {
        return;
    }
    CanFrame frame = event.frame;
    frame.port = node.port;
    if (event.kind == EventKind::kConfirmation)
    {
        node.listener->OnConfirmed(frame, now_);
        return;
    }
    const bool standard = (frame.kind == FrameKind::kData) || (frame.kind == FrameKind::kRemote);
    const bool standard_accepted = standard && (frame.identifier < node.accepted.size()) &&
                                   node.accepted[frame.identifier & kGreatestStandardIdentifier];
    const bool extended_accepted = !standard && node.accepts_extended;
    if (standard_accepted || extended_accepted)
    {
        node.listener->OnReceived(frame, now_);
    }
}

/// Fixes the next SOF if the bus is idle and somebody has something to send.
void BusEvents::Arm()
{
    if ((frame_end_ != kNever) || (arbitration_at_ != kNever))
    {
        return;
    }
    for (const BusNode& node : nodes_)
    {
        if (node.IsOnBus() && !node.queue.IsEmpty())
        {
            arbitration_at_ = std::max(now_, free_at_);
            return;
        }
    }
}

void BusEvents::Schedule()
{
    const BusTime choice = (arbitration_at_ == kNever) ? kNever : (arbitration_at_ + kChoiceDelay);
    const BusTime planned = planned_.empty() ? kNever : planned_.front().at;
    next_event_ = std::min({choice, planned, frame_end_});
}

void BusEvents::EnterBusOff(BusNode& node, const Absence why)
{
    const bool is_new = !node.IsBusOff();
    node.Leave(why);
    if (!is_new)
    {
        return;
    }
    node.transmit_errors = std::max(node.transmit_errors, kBusOffFrom);
    node.queue.Clear();
    if (node.listener != nullptr)
    {
        node.listener->OnBusOff(now_);
    }
}

} // namespace counterpoint::host
