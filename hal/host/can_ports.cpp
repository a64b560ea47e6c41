// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/can_ports.hpp"

#include <stdexcept>

namespace counterpoint::host
{

HostCanPorts::HostCanPorts(HostClocks& clocks, FrameSink& sink) : clocks_(clocks), sink_(sink)
{
    first_.ports = this;
    second_.ports = this;
}

NodeIndex HostCanPorts::ConnectPort(const CanPortId port, VirtualBus& bus, const std::size_t queue_capacity)
{
    Controller& controller = (port == CanPortId::kSecond) ? second_ : first_;
    const bool known = (port == CanPortId::kFirst) || (port == CanPortId::kSecond);
    if (!known || (controller.bus != nullptr))
    {
        throw std::invalid_argument("CAN port is neither kFirst nor kSecond, or connected already");
    }
    controller.bus = &bus;
    controller.node = bus.Attach(controller, NodeSetup{port, queue_capacity});
    return controller.node;
}

NodeIndex HostCanPorts::NodeOf(const CanPortId port) const
{
    const Controller& controller = (port == CanPortId::kSecond) ? second_ : first_;
    if (controller.bus == nullptr)
    {
        throw std::invalid_argument("CAN port is not connected");
    }
    return controller.node;
}

hal::CanGuarantees HostCanPorts::Guarantees() const noexcept
{
    return hal::CanGuarantees{hal::Guarantee::kGiven, hal::Guarantee::kGiven, hal::Guarantee::kGiven};
}

hal::TransmitStatus HostCanPorts::DoTransmit(const CanFrame& frame) noexcept
{
    const Controller& controller = (frame.port == CanPortId::kSecond) ? second_ : first_;
    if (controller.bus == nullptr)
    {
        return hal::TransmitStatus::kRefused;
    }
    return controller.bus->Submit(controller.node, frame);
}

void HostCanPorts::Controller::OnReceived(const CanFrame& frame, const BusTime at)
{
    ports->sink_.OnFrame(StampedFrame{frame, ports->clocks_.At(at)});
}

void HostCanPorts::Controller::OnConfirmed(const CanFrame& frame, const BusTime at)
{
    ports->sink_.OnConfirm(StampedFrame{frame, ports->clocks_.At(at)});
}

} // namespace counterpoint::host
