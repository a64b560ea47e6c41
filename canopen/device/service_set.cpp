// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/device/service_set.hpp"

namespace counterpoint::device
{
namespace
{

constexpr cia301::StartUp kNoStartUp{false, 0U};
constexpr std::uint8_t kLastNode = 127U;

} // namespace

ServiceSet::ServiceSet(const cia301::NodeId own_node, hal::CanPorts* const sender) noexcept
    : node(own_node), slave(own_node, kNoStartUp), can(sender), waiting{false, {}}
{
}

void ServiceSet::PowerOff() noexcept
{
    slave = cia301::NmtSlave{node, cia301::StartUp{false, 0U}};
    waiting.is_present = false;
}

bool ServiceSet::MayBoot() const noexcept
{
    return false;
}

void ServiceSet::OnResetNode() noexcept
{
}

bool ServiceSet::TakeNodeId() noexcept
{
    return (node.value >= 1U) && (node.value <= kLastNode);
}

void ServiceSet::BeginConfiguration() noexcept
{
}

void ServiceSet::EndConfiguration() noexcept
{
    Rejoin(kNoStartUp);
}

void ServiceSet::Send(const cia301::FrameToSend& frame) noexcept
{
    waiting = frame.is_present ? frame : waiting;
}

void ServiceSet::OnState(NmtState /*left*/, NmtState /*entered*/) noexcept
{
}

void ServiceSet::OnOperational() noexcept
{
}

bool ServiceSet::Wants(const CanFrame& /*frame*/) const noexcept
{
    return false;
}

void ServiceSet::OnConfirm() noexcept
{
}

void ServiceSet::OnOverrun(bool /*has_lost*/) noexcept
{
}

void ServiceSet::OnFrame(const CanFrame& /*frame*/, const cia301::Moment& /*moment*/) noexcept
{
}

void ServiceSet::OnCycle(const cia301::Moment& moment) noexcept
{
    Flush(moment.now);
}

void ServiceSet::OnBus(BusCondition /*left*/, BusCondition /*entered*/) noexcept
{
}

void ServiceSet::Flush(Instant /*now*/) noexcept
{
    if (waiting.is_present)
    {
        const hal::TransmitStatus status =
            (can == nullptr) ? hal::TransmitStatus::kRefused : can->Transmit(waiting.frame);
        // What is refused never will be taken.
        waiting.is_present = (status != hal::TransmitStatus::kAccepted) && (status != hal::TransmitStatus::kRefused);
    }
}

void ServiceSet::Rejoin(const cia301::StartUp& start_up) noexcept
{
    slave = cia301::NmtSlave{node, start_up};
    static_cast<void>(slave.Advance()); // To reset application,
    static_cast<void>(slave.Advance()); // and back to where it was: reset communication.
}

NoServices::NoServices(const cia301::NodeId own_node, hal::CanPorts* const sender) noexcept
    : ServiceSet(own_node, sender)
{
}

} // namespace counterpoint::device
