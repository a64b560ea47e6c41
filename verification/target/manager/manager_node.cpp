// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/target/manager/manager_node.hpp"

#include "verification/target/target.hpp"

namespace counterpoint::target
{
namespace
{

constexpr const char* kEvents[]{"nothing",      "boot-up",    "supervision begins", "state",      "heartbeat lost",
                                "guard missed", "guard lost", "toggle error",       "never seen", "unexpected"};
constexpr const char* kFlyingEvents[]{"nothing", "slave of", "forces", "resets the network", "master", "refuses"};

template <std::uint32_t Count>
const char* NameOf(const char* const (&names)[Count], const std::uint32_t number) noexcept
{
    return names[(number < Count) ? number : 0U];
}

const char* NameOf(const cia302::NmtCommand command) noexcept
{
    switch (command)
    {
    case cia302::NmtCommand::kStart:
        return "NMT start";
    case cia302::NmtCommand::kStop:
        return "NMT stop";
    case cia302::NmtCommand::kPreOperational:
        return "NMT preop";
    case cia302::NmtCommand::kResetNode:
        return "NMT reset node";
    case cia302::NmtCommand::kResetCommunication:
        return "NMT reset communication";
    case cia302::NmtCommand::kInvalid:
    default:
        return "NMT nothing";
    }
}

const char* NameOf(const cia302::GateState state) noexcept
{
    switch (state)
    {
    case cia302::GateState::kBusy:
        return "gate reads";
    case cia302::GateState::kDiffers:
        return "gate differs";
    case cia302::GateState::kFailed:
        return "gate failed";
    case cia302::GateState::kOpen:
        return "gate open";
    case cia302::GateState::kClosed:
    default:
        return "gate closed";
    }
}

void WriteObject(const char* const what, const ObjectAddress& object) noexcept
{
    Write(what);
    WriteHex((static_cast<std::uint32_t>(object.index) << 8U) | object.sub);
}

} // namespace

ManagerNode::ManagerNode(const examples::ManagerSettings& settings) noexcept
    : own_{settings.setup.own.value}, device_{settings, *this, *this}
{
}

void ManagerNode::Cycle(const Instant now) noexcept
{
    if (!has_begun_)
    {
        has_begun_ = true;
        device_.Core().Begin(now);
    }
    device_.Core().OnCycle(now);
}

CanFrame ManagerNode::Waiting() const noexcept
{
    return (read_ == written_) ? CanFrame{} : frames_[read_ % kPlaces];
}

void ManagerNode::Sent(const Instant /*now*/) noexcept
{
    device_.Core().OnSent(frames_[read_ % kPlaces]);
    ++read_;
}

void ManagerNode::Hear(const CanFrame& frame, const Instant now) noexcept
{
    device_.Core().OnFrame(frame, now);
}

bool ManagerNode::Send(const CanFrame& frame) noexcept
{
    const bool is_taken = (written_ - read_) < kPlaces;
    if (is_taken)
    {
        frames_[written_ % kPlaces] = frame;
        ++written_;
    }
    return is_taken;
}

void ManagerNode::Tell(const Instant now, const char* const what, const std::uint32_t node) const noexcept
{
    WriteNumber(now.us / 1000U);
    Write(" manager ");
    WriteNumber(own_);
    Write(": node ");
    WriteNumber(node);
    Write(" ");
    Write(what);
}

void ManagerNode::OnNodeEvent(const cia302::NodeId node, const cia302::NodeEvent event, const Instant now) noexcept
{
    Tell(now, NameOf(kEvents, static_cast<std::uint32_t>(event)), node.value);
    Write(" ");
    WriteNumber(static_cast<std::uint32_t>(device_.Core().Table().Record(node).state));
    Write("\n");
}

void ManagerNode::OnNodeStatus(const cia302::NodeId node, const Instant now) noexcept
{
    const cia302::NodeStatus status = device_.Core().Status(node);
    const char letter[2]{(status.letter == '\0') ? '-' : status.letter, '\0'};
    Tell(now, "step ", node.value);
    WriteNumber(static_cast<std::uint32_t>(status.step));
    Write(" letter ");
    Write(letter);
    if (status.letter != '\0')
    {
        WriteObject(" object ", status.object);
        Write(" expected ");
        WriteHex(static_cast<std::uint32_t>(status.expected));
        Write(" read ");
        WriteHex(static_cast<std::uint32_t>(status.read));
    }
    Write("\n");
}

void ManagerNode::OnMasterState(const std::int16_t state, const Instant now) noexcept
{
    Tell(now, "master state ", own_);
    WriteNumber(static_cast<std::uint32_t>(state));
    Write("\n");
}

void ManagerNode::OnNmtSent(const cia302::NmtRequest& request, const Instant now) noexcept
{
    Tell(now, NameOf(request.command), request.node.value);
    Write("\n");
}

void ManagerNode::OnGate(const cia302::NodeId node, const cia302::GateState state, const Instant now) noexcept
{
    const cia302::GateFinding finding = device_.Core().Gate().Finding(node);
    Tell(now, NameOf(state), node.value);
    if (state == cia302::GateState::kDiffers)
    {
        WriteObject(" object ", finding.object);
        Write(" expected ");
        WriteHex(static_cast<std::uint32_t>(finding.expected));
        Write(" read ");
        WriteHex(static_cast<std::uint32_t>(finding.read));
    }
    Write("\n");
}

void ManagerNode::OnEmergency(const cia302::NodeId node, const cia302::EmergencyRecord& emergency,
                              const Instant now) noexcept
{
    Tell(now, "emergency ", node.value);
    WriteHex(emergency.code);
    Write("\n");
}

void ManagerNode::OnDuplicate(const cia302::NodeId node, const Instant now) noexcept
{
    Tell(now, "duplicate\n", node.value);
}

void ManagerNode::OnFlyingMaster(const cia302::FlyingEvent event, const cia302::MasterClaim& claim,
                                 const Instant now) noexcept
{
    Tell(now, NameOf(kFlyingEvents, static_cast<std::uint32_t>(event)), own_);
    Write(" ");
    WriteNumber(claim.node.value);
    Write(" level ");
    WriteNumber(claim.level);
    Write("\n");
}

} // namespace counterpoint::target
