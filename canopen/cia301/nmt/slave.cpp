// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/nmt/slave.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint32_t kMasterBit = 0x01U;
constexpr std::uint32_t kWaitBit = 0x04U;
constexpr std::uint32_t kErrorControl = 0x700U;
constexpr std::uint8_t kLastNode = 127U;

bool IsRunning(const NodeState state) noexcept
{
    const bool is_working = (state == NodeState::kPreOperational) || (state == NodeState::kOperational);
    return is_working || (state == NodeState::kStopped);
}

bool IsNode(const NodeId node) noexcept
{
    return (node.value >= 1U) && (node.value <= kLastNode);
}

} // namespace

NmtState KernelState(const NodeState state) noexcept
{
    NmtState told = NmtState::kInitialising;
    if (state == NodeState::kPreOperational)
    {
        told = NmtState::kPreOperational;
    }
    else if (state == NodeState::kOperational)
    {
        told = NmtState::kOperational;
    }
    else if (state == NodeState::kStopped)
    {
        told = NmtState::kStopped;
    }
    return told;
}

std::uint8_t StateByte(const NodeState state) noexcept
{
    std::uint8_t byte = 0U;
    if (state == NodeState::kPreOperational)
    {
        byte = 127U;
    }
    else if (state == NodeState::kOperational)
    {
        byte = 5U;
    }
    else if (state == NodeState::kStopped)
    {
        byte = 4U;
    }
    return byte;
}

CanFrame ErrorControlFrame(const NodeId node, const std::uint8_t byte) noexcept
{
    CanFrame frame{};
    frame.identifier = kErrorControl + node.value;
    frame.kind = FrameKind::kData;
    frame.port = CanPortId::kFirst;
    frame.length_bytes = 1U;
    frame.data[0] = byte;
    return frame;
}

NmtSlave::NmtSlave(const NodeId node, const StartUp& start_up) noexcept
    : node_(node), start_up_(start_up), state_(NodeState::kInitialising)
{
}

FrameToSend NmtSlave::Advance() noexcept
{
    FrameToSend boot_up{false, {}};
    if (state_ == NodeState::kInitialising)
    {
        state_ = NodeState::kResetApplication;
    }
    else if (state_ == NodeState::kResetApplication)
    {
        state_ = NodeState::kResetCommunication;
    }
    else if ((state_ == NodeState::kResetCommunication) && IsNode(node_))
    {
        const bool is_starting = start_up_.is_present && ((start_up_.value & (kMasterBit | kWaitBit)) == 0U);
        state_ = is_starting ? NodeState::kOperational : NodeState::kPreOperational;
        boot_up = FrameToSend{true, ErrorControlFrame(node_, 0U)};
    }
    return boot_up;
}

void NmtSlave::SetNodeId(const NodeId node) noexcept
{
    node_ = node;
}

void NmtSlave::OnFrame(const CanFrame& frame) noexcept
{
    const bool is_command = (frame.identifier == 0U) && (frame.kind == FrameKind::kData) && (frame.length_bytes == 2U);
    const bool is_ours = (frame.data[1] == 0U) || (frame.data[1] == node_.value);
    if (is_command && is_ours && IsRunning(state_))
    {
        Obey(static_cast<NmtCommand>(frame.data[0]));
    }
}

bool NmtSlave::Leave(const NodeState to) noexcept
{
    const bool is_allowed =
        (state_ == NodeState::kOperational) && ((to == NodeState::kPreOperational) || (to == NodeState::kStopped));
    state_ = is_allowed ? to : state_;
    return is_allowed;
}

void NmtSlave::Obey(const NmtCommand command) noexcept
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
        state_ = NodeState::kResetApplication;
        break;
    case NmtCommand::kResetCommunication:
        state_ = NodeState::kResetCommunication;
        break;
    case NmtCommand::kInvalid:
    default:
        break; // Reserved commands change nothing.
    }
}

} // namespace counterpoint::cia301
