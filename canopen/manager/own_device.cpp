// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/manager/own_device.hpp"

namespace counterpoint::cia302
{

using cia301::NodeState;

OwnDevice::OwnDevice(const NodeId own, cia301::FrameSink& sink, const std::uint16_t heartbeat_ms) noexcept
    : own_(own), sink_(sink), producer_(own), state_(NodeState::kInitialising), owes_boot_up_(false),
      owes_heartbeat_(false), is_waiting_(false)
{
    producer_.SetPeriod(heartbeat_ms);
}

void OwnDevice::Restart() noexcept
{
    state_ = NodeState::kPreOperational;
    owes_boot_up_ = true;
    owes_heartbeat_ = false;
    is_waiting_ = false;
}

void OwnDevice::Obey(const NmtCommand command) noexcept
{
    switch (command)
    {
    case NmtCommand::kStart:
        state_ = NodeState::kOperational;
        break;
    case NmtCommand::kStop:
        state_ = NodeState::kStopped;
        break;
    case NmtCommand::kPreOperational:
        state_ = NodeState::kPreOperational;
        break;
    case NmtCommand::kResetNode:
    case NmtCommand::kResetCommunication:
        Restart();
        break;
    case NmtCommand::kInvalid:
    default:
        break;
    }
}

/// A heartbeat that found no room leaves late, with the state of then: the sink may be full for many periods, and who
/// watches this device would lose it. [SRS_MGR_231]
void OwnDevice::Send(const bool is_initialising, const Instant now) noexcept
{
    if (!is_initialising && owes_boot_up_)
    {
        owes_boot_up_ = !sink_.Send(cia301::ErrorControlFrame(own_, 0U));
        is_waiting_ = owes_boot_up_;
    }
    else if (!is_initialising)
    {
        const cia301::FrameToSend heartbeat = producer_.Poll(state_, now);
        owes_heartbeat_ = (owes_heartbeat_ || heartbeat.is_present) && (producer_.PeriodMs() > 0U);
        owes_heartbeat_ = owes_heartbeat_ && !sink_.Send(cia301::ErrorControlFrame(own_, cia301::StateByte(state_)));
        is_waiting_ = owes_heartbeat_;
    }
    else
    {
        // Nobody is to take this device for one that is there. Whoever leaves INITIALISATION says so. [SRS_FLY_028]
        Restart();
    }
}

} // namespace counterpoint::cia302
