// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/virtual/bus.hpp"

#include "hal/host/virtual/frame_bits.hpp"

#include <algorithm>
#include <utility>

namespace counterpoint::host
{

VirtualBus::VirtualBus(const BitRate rate) : events_(rate, nodes_, faults_)
{
}

NodeIndex VirtualBus::Attach(BusListener& listener, const NodeSetup& setup)
{
    BusNode node{&listener, TransmitQueue(setup.queue_capacity), {}, kNoIdentifier, 0U, 0U, setup.port, true, 0U};
    node.accepted.set();
    nodes_.push_back(std::move(node)); // A copy of the queue would not keep the memory set aside for its frames.
    events_.OnAttached();
    return nodes_.size() - 1U;
}

void VirtualBus::Detach(const NodeIndex node)
{
    BusNode& gone = nodes_.at(node);
    gone.listener = nullptr;
    gone.Leave(Absence::kDetached);
    gone.queue.Clear();
}

hal::TransmitStatus VirtualBus::Submit(const NodeIndex node, const CanFrame& frame)
{
    BusNode& sender = nodes_.at(node);
    if (sender.IsBusOff())
    {
        return hal::TransmitStatus::kBusOff;
    }
    CanFrame sent = frame;
    for (BusFault* const fault : faults_)
    {
        const SubmitFate fate = fault->OnSubmit(sent, node, events_.Now());
        if (fate != SubmitFate::kQueued)
        {
            return (fate == SubmitFate::kSwallowed) ? hal::TransmitStatus::kAccepted : hal::TransmitStatus::kQueueFull;
        }
    }
    if (!IsClassicalFrame(sent))
    {
        return hal::TransmitStatus::kRefused;
    }
    const QueuedFrame queued{sent, ArbitrationKey(sent), 0U, events_.NextOrder()};
    if (sent.kind == FrameKind::kData && sent.identifier == sender.waits_once)
    {
        sender.queue.Discard(queued);
    }
    if (sender.queue.IsFull())
    {
        return hal::TransmitStatus::kQueueFull;
    }
    sender.queue.Insert(queued);
    events_.OnWaiting();
    return hal::TransmitStatus::kAccepted;
}

void VirtualBus::AbortAll(const NodeIndex node)
{
    nodes_.at(node).queue.ClearWaiting();
}

void VirtualBus::Plan(const NodeIndex node, const CanFrame& frame, const BusTime at)
{
    static_cast<void>(nodes_.at(node));
    events_.Plan(node, frame, at);
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
    BusNode& receiver = nodes_.at(node);
    const std::uint32_t last = std::min(last_identifier, kGreatestStandardIdentifier);
    for (std::uint32_t identifier = first_identifier; identifier <= last; ++identifier)
    {
        receiver.accepted.set(identifier);
    }
}

void VirtualBus::WaitOnce(const NodeIndex node, const std::uint32_t identifier)
{
    nodes_.at(node).waits_once = identifier;
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
    nodes_.at(node).Leave(Absence::kCable);
}

void VirtualBus::Connect(const NodeIndex node)
{
    nodes_.at(node).Return(Absence::kCable);
    events_.OnWaiting();
}

void VirtualBus::SwitchOff(const NodeIndex node)
{
    nodes_.at(node).queue.Clear();
    nodes_.at(node).Leave(Absence::kSupply);
}

void VirtualBus::SwitchOn(const NodeIndex node)
{
    BusNode& back = nodes_.at(node);
    back.queue.Clear();
    back.transmit_errors = 0U;
    back.receive_errors = 0U;
    back.Return(Absence::kSupply);
    back.Return(Absence::kErrors);
}

void VirtualBus::ForceBusOff(const NodeIndex node)
{
    events_.EnterBusOff(nodes_.at(node), Absence::kHeldOff);
}

void VirtualBus::Recover(const NodeIndex node)
{
    BusNode& back = nodes_.at(node);
    back.Return(Absence::kErrors);
    back.Return(Absence::kHeldOff);
    back.transmit_errors = 0U;
    back.receive_errors = 0U;
}

ControllerState VirtualBus::State(const NodeIndex node) const
{
    const BusNode& looked_at = nodes_.at(node);
    if (looked_at.IsBusOff())
    {
        return ControllerState::kBusOff;
    }
    const std::uint32_t errors = std::max(looked_at.transmit_errors, looked_at.receive_errors);
    return (errors > kErrorPassiveAbove) ? ControllerState::kErrorPassive : ControllerState::kErrorActive;
}

bool VirtualBus::IsOnBus(const NodeIndex node) const
{
    return nodes_.at(node).IsOnBus();
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

} // namespace counterpoint::host
