// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/world/node/firmware.hpp"

#include "simulator/world/participant.hpp"

#include "canopen/cia301/store/stored_parts.hpp"
#include "canopen/cia306/text/input_error.hpp"

#include <utility>

namespace counterpoint::simulator
{
namespace
{
constexpr ObjectAddress kSerialNumber{0x1018U, 4U};
constexpr std::uint32_t kByteBits = 8U;

std::uint64_t DetailsOf(const cia301::ReceivedEmergency& emergency)
{
    std::uint64_t details = 0U;
    for (const std::uint8_t byte : emergency.details)
    {
        details = (details << kByteBits) | byte;
    }
    return details;
}

/// A frame of an NMT master, if it is one for this node.
void NoteCommand(const NodePlace& place, const CanFrame& frame, const std::uint8_t node_id)
{
    const bool is_for_it = frame.kind == FrameKind::kData && frame.identifier == 0U && frame.length_bytes >= 2U &&
                           (frame.data[1] == 0U || frame.data[1] == node_id);
    const auto order = static_cast<cia301::NmtCommand>(frame.data[0]);
    if (is_for_it && cia301::IsNmtCommand(order))
    {
        CommandEntry command{place.Now(), place.index};
        command.closes = order != cia301::NmtCommand::kStart;
        place.journal.Note(command);
    }
}
} // namespace

NodeFirmware::NodeFirmware(const NodeInside& inside, hal::CanPorts& ports)
    : inside_(inside), processor_(inside.processor),
      assembly_(inside.model, inside.model.Config(),
                {inside.channels.Voice(runtime::Letter::kA), inside.channels.Voice(runtime::Letter::kB), ports,
                 inside.outputs.Output(), inside.channels.Supervision(), inside.application, inside.self_test, *this,
                 inside.place.file, inside.processor.Flow()}),
      serial_(inside.setup.serial)
{
    inside_.application.Join(assembly_.Core());
    if (inside.place.HasServices())
    {
        assembly_.Connect(nullptr);
        if (inside.place.file->is_lss_supported)
        {
            assembly_.UseLss(*inside.place.file, {inside.model.Config().node_id, {0U}}, nullptr); // Nothing is kept.
        }
    }
}

void NodeFirmware::Start()
{
    refused_write_.reset();
    processor_.Image().RestorePointers(); // What stood in RAM is gone: no wild one may be used on the way up.
    assembly_.PowerOff();
    const bool is_up = assembly_.Device().PowerOn(inside_.clock.Instants().a) == device::LoadResult::kLoaded;
    if (refused_write_ && !inside_.place.HasServices()) // Whoever manages the others finds it and says so.
    {
        throw runtime::RefusalOf(inside_.model, *refused_write_, refused_);
    }
    if (!is_up)
    {
        throw cia306::InputError(
            inside_.model.File(), {},
            {runtime::NoStartText(started_), "SRDOs, objects and times of 0x5F00 within the ranges of DeviceConfig"});
    }
}

void NodeFirmware::PowerOff() noexcept
{
    state_ = cia301::NodeState::kInvalid;
    condition_ = device::BusCondition::kActive;
    serve_at_ = kNever;
}

bool NodeFirmware::TakeRestart() noexcept
{
    if (!std::exchange(has_restarted_, false))
    {
        return false;
    }
    state_ = cia301::NodeState::kInvalid; // Followed again, even if it is the same.
    cycles_to_send_ = 0U;
    cycles_per_send_ = 0U;
    return true;
}

/// Directions, times, identifiers and mappings stay as they are until OPERATIONAL is left. What a manager may have
/// written is followed; without services they are those of the file.
void NodeFirmware::FollowState()
{
    const cia301::NodeState state = assembly_.Device().State();
    if (state == state_)
    {
        return;
    }
    state_ = state;
    if (inside_.place.HasServices())
    {
        inside_.place.Tell(EventKind::kNmt, 0U, static_cast<std::uint64_t>(cia301::KernelState(state)), 0U);
        if (assembly_.NewNodeId())
        {
            inside_.place.Note(EventKind::kNewNodeId, 0U, *assembly_.NewNodeId(), 0U);
        }
    }
    if (state != cia301::NodeState::kOperational)
    {
        return;
    }
    cycles_per_send_ = assembly_.CyclesPerSend();
    cycles_to_send_ = 0U;
    if (inside_.place.HasServices())
    {
        inside_.pairs.Follow(assembly_.Core());
        inside_.application.Logic().Follow(assembly_.Core(), inside_.model);
    }
}

void NodeFirmware::OnFrame(const StampedFrame& frame)
{
    if (!processor_.IsRunning())
    {
        return;
    }
    NoteCommand(inside_.place, frame.frame, inside_.model.Config().node_id);
    if (inside_.place.is_tapped)
    {
        inside_.pairs.OnFrame(frame.frame);
    }
    processor_.RunSound(
        [this, &frame]()
        {
            const StampedFrame stamped = inside_.clock.Stamped(frame);
            const Peer* const peer = inside_.channels.Peer();
            const bool is_echo = peer != nullptr && peer->IsEcho(frame.frame);
            is_echo ? assembly_.Device().OnConfirm(stamped) : assembly_.Device().OnFrame(stamped);
            HandOver();
        });
}

void NodeFirmware::OnConfirm(const StampedFrame& frame)
{
    if (processor_.IsRunning())
    {
        processor_.RunSound(
            [this, &frame]()
            {
                assembly_.Device().OnConfirm(inside_.clock.Stamped(frame));
                HandOver();
            });
    }
}

void NodeFirmware::HandOver()
{
    assembly_.Device().HandOver();
    if (inside_.place.HasServices() && serve_at_ == kNever)
    {
        serve_at_ = inside_.place.Now() + ReactionTime(inside_.place.bus);
    }
}

void NodeFirmware::OnMessage(const hal::LinkFrame& frame)
{
    if (processor_.IsRunning())
    {
        processor_.RunSound([this, &frame]()
                            { inside_.channels.Peer()->OnMessage(frame, inside_.clock.Instants().a); });
    }
}

void NodeFirmware::OnBus(const device::BusCondition condition) noexcept
{
    if (condition != condition_)
    {
        condition_ = condition;
        assembly_.Device().OnBus(condition);
    }
}

void NodeFirmware::Obey(const cia301::NmtCommand command)
{
    if (!processor_.IsRunning())
    {
        return;
    }
    CanFrame frame{};
    frame.kind = FrameKind::kData;
    frame.port = CanPortId::kFirst;
    frame.length_bytes = 2U;
    frame.data[0] = static_cast<std::uint8_t>(command);
    frame.data[1] = inside_.model.Config().node_id;
    processor_.RunSound(
        [this, &frame]()
        {
            const InstantPair now = inside_.clock.Instants();
            assembly_.Device().OnFrame({frame, now});
            assembly_.Device().Serve(now.a);
        });
}

void NodeFirmware::SendGfc()
{
    Result result = Result::kDeviceFault;
    if (processor_.IsRunning())
    {
        processor_.RunSound([this, &result]() { result = assembly_.Core().SendGfc(); });
    }
    inside_.place.Note(EventKind::kGfc, 0U, (result == Result::kSuccessful) ? 1U : 0U,
                       static_cast<std::uint64_t>(result));
}

void NodeFirmware::Store(const ObjectAddress& object, const std::uint32_t value)
{
    constexpr std::uint32_t kObjectBits = 32U;
    cia301::SdoAbort abort = cia301::SdoAbort::kGeneral;
    if (processor_.IsRunning() && inside_.place.HasServices())
    {
        processor_.Run(
            [this, &object, &abort, value]()
            {
                const cia301::Reading size = assembly_.Dictionary().SizeOf(object);
                abort = assembly_.Dictionary().WriteNumber(object, value, size.size_bytes);
            });
    }
    const std::uint64_t number = (std::uint64_t{object.index} << kByteBits) | object.sub;
    inside_.place.Note(EventKind::kStore, 0U, value, (static_cast<std::uint64_t>(abort) << kObjectBits) | number);
}

// At once after a change, and every refresh time after the last time. CPU B follows CPU A. [SRS_SIM_069]
void NodeFirmware::SendByApplication()
{
    if (cycles_per_send_ == 0U || inside_.setup.role == runtime::CpuRole::kB)
    {
        return;
    }
    if (assembly_.Device().State() != cia301::NodeState::kOperational)
    {
        cycles_to_send_ = 0U;
        return;
    }
    const bool has_changed = inside_.application.Logic().TakeChange();
    if (cycles_to_send_ != 0U && !has_changed)
    {
        --cycles_to_send_;
        return;
    }
    cycles_to_send_ = cycles_per_send_ - 1U;
    inside_.application.WriteOut(); // What has changed since the last cycle is what it sends.
    processor_.RunSound([this]() { assembly_.SendAll(); });
}

// As the contract of Peer has it; messages and frames came before.
void NodeFirmware::Cycle(const CycleCall& call)
{
    processor_.Run(
        [this, &call]()
        {
            if (inside_.self_test == nullptr)
            {
                processor_.RequireSound();
            }
            Peer* const peer = inside_.channels.Peer();
            if (peer != nullptr && peer->Examine(call.now.a) != LinkFinding::kNone)
            {
                assembly_.Core().OnCrossLinkFault();
            }
            assembly_.Device().Cycle(call);
            if (peer != nullptr)
            {
                processor_.RequireSound();
                hal::LinkFrame message{};
                peer->Compose({call.now.a, assembly_.Core().DeviceState().fault}, message);
                wire_->Send(inside_.place.index, message, inside_.place.Now());
            }
        });
}

void NodeFirmware::Serve()
{
    serve_at_ = kNever;
    processor_.RunSound([this]() { assembly_.Device().Serve(inside_.clock.Instants().a); });
}

void NodeFirmware::OnStart() noexcept
{
    processor_.Image().RestorePointers();
    inside_.application.ForgetFault();
    if (inside_.self_test != nullptr)
    {
        inside_.self_test->Start();
    }
}

void NodeFirmware::OnNoStart(const StartResult result) noexcept
{
    started_ = result;
}

void NodeFirmware::OnRefused(const runtime::ConfigurationWrite& write, const AbortCode code) noexcept
{
    if (!refused_write_)
    {
        refused_write_ = write;
        refused_ = code;
    }
}

void NodeFirmware::OnLoaded(const std::uint8_t groups) noexcept
{
    has_restarted_ = has_restarted_ || (groups & cia301::kApplicationGroup) != 0U;
    if (serial_ && inside_.place.HasServices() && (groups & cia301::kCommunicationGroup) != 0U)
    {
        static_cast<void>(assembly_.Dictionary().WriteNumber(kSerialNumber, *serial_, sizeof *serial_));
    }
}

void NodeFirmware::OnResetCommunication(const std::vector<cia306::Finding>& /*refusals*/) noexcept
{
    state_ = cia301::NodeState::kInvalid;
}

void NodeFirmware::OnTime(const cia301::TimeOfDay& time, const Instant /*now*/) noexcept
{
    inside_.place.Tell(EventKind::kTime, 0U, time.ms, time.days);
}

void NodeFirmware::OnEmergency(const cia301::ReceivedEmergency& emergency) noexcept
{
    inside_.place.Tell(EventKind::kEmergency, 0U,
                       (std::uint64_t{emergency.node.value} << 24U) | (std::uint64_t{emergency.error_register} << 16U) |
                           emergency.code,
                       DetailsOf(emergency));
}
} // namespace counterpoint::simulator
