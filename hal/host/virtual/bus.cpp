// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/virtual/bus.hpp"

#include "hal/host/virtual/frame_bits.hpp"

#include <algorithm>
#include <utility>

namespace counterpoint::host
{

VirtualBus::VirtualBus(const BitRate rate) : bit_time_(BitTime(rate))
{
}

NodeIndex VirtualBus::Attach(BusListener& listener, const NodeSetup& setup)
{
    Node node{&listener, TransmitQueue(setup.queue_capacity), {}, 0U, 0U, setup.port, true, true, false};
    node.accepted.set();
    nodes_.push_back(std::move(node)); // A copy of the queue would not keep the memory set aside for its frames.
    senders_.reserve(nodes_.size());
    deliveries_.reserve(nodes_.size());
    return nodes_.size() - 1U;
}

void VirtualBus::Detach(const NodeIndex node)
{
    Node& gone = nodes_.at(node);
    gone.listener = nullptr;
    gone.connected = false;
    gone.queue.Clear();
}

hal::TransmitStatus VirtualBus::Submit(const NodeIndex node, const CanFrame& frame)
{
    Node& sender = nodes_.at(node);
    if (sender.bus_off)
    {
        return hal::TransmitStatus::kBusOff;
    }
    CanFrame sent = frame;
    for (BusFault* const fault : faults_)
    {
        const SubmitFate fate = fault->OnSubmit(sent, node, now_);
        if (fate != SubmitFate::kQueued)
        {
            return (fate == SubmitFate::kSwallowed) ? hal::TransmitStatus::kAccepted : hal::TransmitStatus::kQueueFull;
        }
    }
    if (!IsClassicalFrame(sent))
    {
        return hal::TransmitStatus::kRefused;
    }
    if (sender.queue.IsFull())
    {
        return hal::TransmitStatus::kQueueFull;
    }
    sender.queue.Insert(QueuedFrame{sent, ArbitrationKey(sent), 0U, order_});
    ++order_;
    Arm();
    Schedule();
    return hal::TransmitStatus::kAccepted;
}

void VirtualBus::AbortAll(const NodeIndex node)
{
    nodes_.at(node).queue.ClearWaiting();
}

void VirtualBus::Plan(const NodeIndex node, const CanFrame& frame, const BusTime at)
{
    static_cast<void>(nodes_.at(node));
    PlanEvent(PlannedEvent{std::max(at, now_), order_, node, frame, EventKind::kReception});
    ++order_;
    Schedule();
}

void VirtualBus::AcceptAll(const NodeIndex node)
{
    nodes_.at(node).accepted.set();
    nodes_.at(node).accepts_extended = true;
}

void VirtualBus::AcceptNone(const NodeIndex node)
{
    nodes_.at(node).accepted.reset();
    nodes_.at(node).accepts_extended = false;
}

void VirtualBus::AcceptRange(const NodeIndex node, const std::uint32_t first_identifier,
                             const std::uint32_t last_identifier)
{
    Node& receiver = nodes_.at(node);
    const std::uint32_t last = std::min(last_identifier, kGreatestStandardIdentifier);
    for (std::uint32_t identifier = first_identifier; identifier <= last; ++identifier)
    {
        receiver.accepted.set(identifier);
    }
}

void VirtualBus::Install(BusFault& fault)
{
    faults_.push_back(&fault);
}

void VirtualBus::Remove(BusFault& fault)
{
    faults_.erase(std::remove(faults_.begin(), faults_.end(), &fault), faults_.end());
}

void VirtualBus::Disconnect(const NodeIndex node)
{
    nodes_.at(node).connected = false;
}

void VirtualBus::Connect(const NodeIndex node)
{
    Node& back = nodes_.at(node);
    back.connected = back.listener != nullptr;
    Arm();
    Schedule();
}

void VirtualBus::ForceBusOff(const NodeIndex node)
{
    EnterBusOff(nodes_.at(node));
}

void VirtualBus::Recover(const NodeIndex node)
{
    Node& back = nodes_.at(node);
    back.bus_off = false;
    back.transmit_errors = 0U;
    back.receive_errors = 0U;
}

ControllerState VirtualBus::State(const NodeIndex node) const
{
    const Node& looked_at = nodes_.at(node);
    if (looked_at.bus_off)
    {
        return ControllerState::kBusOff;
    }
    const std::uint32_t errors = std::max(looked_at.transmit_errors, looked_at.receive_errors);
    return (errors > kErrorPassiveAbove) ? ControllerState::kErrorPassive : ControllerState::kErrorActive;
}

std::uint32_t VirtualBus::TransmitErrors(const NodeIndex node) const
{
    return nodes_.at(node).transmit_errors;
}

std::uint32_t VirtualBus::ReceiveErrors(const NodeIndex node) const
{
    return nodes_.at(node).receive_errors;
}

std::size_t VirtualBus::Pending(const NodeIndex node) const
{
    return nodes_.at(node).queue.Size();
}

void VirtualBus::EnterBusOff(Node& node)
{
    if (node.bus_off)
    {
        return;
    }
    node.bus_off = true;
    node.transmit_errors = std::max(node.transmit_errors, kBusOffFrom);
    node.queue.Clear();
    if (node.listener != nullptr)
    {
        node.listener->OnBusOff(now_);
    }
}

} // namespace counterpoint::host
