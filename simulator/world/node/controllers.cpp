// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/world/node/controllers.hpp"

#include <algorithm>
#include <utility>

namespace counterpoint::simulator
{
namespace
{
constexpr std::size_t kLeastMailboxes = 16U;
constexpr std::size_t kMailboxesOfServices = 8U;

/// So many that all SRDOs may be due in one cycle, whoever configures them. [SRS_SIM_070]
std::size_t MailboxesFor(const std::size_t srdo_count)
{
    return std::max(kLeastMailboxes, 2U * srdo_count + kMailboxesOfServices);
}
} // namespace

// The second of two takes the inverse frames of SRDOs (even identifiers), the first everything else.
NodeControllers::NodeControllers(const NodePlace& place, const NodeProcessor& processor, host::HostClocks& counters,
                                 const runtime::DeviceModel& model, host::FrameSink& device)
    : place_(place), processor_(processor), device_(device), can_(counters, *this)
{
    host::VirtualBus& bus = place.bus;
    const std::size_t mailboxes = MailboxesFor(model.Config().srdo_count);
    bus_nodes_.push_back(can_.ConnectPort(CanPortId::kFirst, bus, mailboxes));
    if (model.ControllerCount() > 1U)
    {
        bus_nodes_.push_back(can_.ConnectPort(CanPortId::kSecond, bus, mailboxes));
        constexpr std::uint32_t kLastIdentifier = 0x7FFU;
        bus.AcceptNone(bus_nodes_[0U]);
        bus.AcceptNone(bus_nodes_[1U]);
        bus.AcceptRange(bus_nodes_[0U], 0U, kFirstSrdoIdentifier - 1U);
        bus.AcceptRange(bus_nodes_[0U], kLastSrdoIdentifier + 1U, kLastIdentifier);
        for (std::uint32_t identifier = kFirstSrdoIdentifier; identifier <= kLastSrdoIdentifier; ++identifier)
        {
            const bool is_normal = (identifier & 1U) != 0U;
            bus.AcceptRange(bus_nodes_[is_normal ? 0U : 1U], identifier, identifier);
        }
    }
    for (const host::NodeIndex node : bus_nodes_)
    {
        if (place.HasServices())
        {
            bus.SwitchOff(node); // Whoever has no supply hears nobody.
        }
    }
}

void NodeControllers::PowerOn()
{
    for (const host::NodeIndex node : bus_nodes_)
    {
        place_.bus.SwitchOn(node); // Without what it said when it was rehearsed.
    }
}

void NodeControllers::PowerOff()
{
    queue_.reset();
    for (const host::NodeIndex node : bus_nodes_)
    {
        place_.bus.SwitchOff(node);
    }
}

void NodeControllers::Restart()
{
    queue_.reset();
}

void NodeControllers::Poll(const std::size_t capacity, const std::size_t fault)
{
    capacity_ = capacity;
    fault_ = (capacity == 0U) ? fault_ : fault;
}

void NodeControllers::Drain()
{
    if (queue_ != nullptr)
    {
        const std::unique_ptr<host::FrameQueue> queue = std::move(queue_);
        queue->Drain(device_);
    }
}

device::BusCondition NodeControllers::Condition() const
{
    const bool is_off = std::any_of(bus_nodes_.begin(), bus_nodes_.end(), [this](const host::NodeIndex node)
                                    { return place_.bus.State(node) == host::ControllerState::kBusOff; });
    return is_off ? device::BusCondition::kOff : device::BusCondition::kActive;
}

void NodeControllers::OnFrame(const StampedFrame& frame)
{
    if (capacity_ == 0U && queue_ == nullptr)
    {
        device_.OnFrame(frame);
        return;
    }
    if (!processor_.HasSupply())
    {
        return;
    }
    if (queue_ == nullptr)
    {
        queue_ = std::make_unique<host::FrameQueue>(capacity_);
    }
    if (queue_->Size() >= capacity_ && capacity_ != 0U && fault_ != kNoFaultIndex)
    {
        place_.Note(EventKind::kFault, 0U, fault_, 0U);
        fault_ = kNoFaultIndex;
    }
    queue_->OnFrame(frame);
}

void NodeControllers::OnConfirm(const StampedFrame& frame)
{
    if (queue_ == nullptr)
    {
        device_.OnConfirm(frame);
        return;
    }
    queue_->OnConfirm(frame); // Behind the frames that wait.
}

void NodeControllers::OnOverflow()
{
    device_.OnOverflow();
}
} // namespace counterpoint::simulator
