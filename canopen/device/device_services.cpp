// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/device/device.hpp"

#include "canopen/cia301/service_table.hpp"

// NMT and the services behind the safety part. [SRS-DEV-002..005, SRS-DEV-010, SRS-DEV-011, SRS-DEV-014]
namespace counterpoint::device
{
namespace
{

using cia301::NodeState;
using cia301::Service;

constexpr std::uint32_t kSdoRequest = 0x600U;
constexpr std::uint32_t kSdoAnswer = 0x580U;
constexpr std::uint16_t kStartUpIndex = 0x1F80U;
constexpr std::uint16_t kConfigurationValidIndex = 0x13FEU;
constexpr std::uint8_t kCobIdSub1 = 5U;
constexpr std::uint8_t kCobIdSub2 = 6U;
/// 13FEh itself, and nothing more to tell.
constexpr ErrorEvent kNotValid{{0U}, 0U};

} // namespace

void Device::Serve(const Instant now) noexcept
{
    HandOver();
    TakenFrame command = commands_.Take();
    while (command.is_present)
    {
        Obey(command.item.frame.frame);
        command = commands_.Take();
    }
    TakenFrame other = others_.Take();
    while (other.is_present)
    {
        ServeFrame(other.item.frame, now);
        other = others_.Take();
    }
    Services& services = parts_.services;
    services.consumer.Poll(now);
    static_cast<void>(services.guarding.Poll(now));
    PollSdo(now);
    Send(services.producer.Poll(State(), now));
    Send(services.emergency.Poll(State(), now));
    Settle();
    outbox_.Poll(now);
}

// Each command takes effect completely before the next one is looked at.
void Device::Obey(const CanFrame& command) noexcept
{
    parts_.services.slave.OnFrame(command);
    Settle();
}

/// Carries out what the state machine asks for, until it rests.
void Device::Settle() noexcept
{
    Initialise();
    ApplyState();
}

void Device::Initialise() noexcept
{
    cia301::NmtSlave& slave = parts_.services.slave;
    while ((!is_failed_) && (cia301::StateByte(slave.State()) == 0U))
    {
        ApplyState();
        is_failed_ = Load() != LoadResult::kLoaded;
        if (!is_failed_)
        {
            Send(slave.Advance());
        }
    }
}

/// What a sub-state of INITIALISATION loads.
LoadResult Device::Load() noexcept
{
    Services& services = parts_.services;
    LoadResult loaded = LoadResult::kLoaded;
    if (services.slave.State() == NodeState::kResetApplication)
    {
        parts_.watch.EndDeviceFault();
        loaded = parts_.owner.OnResetNode();
    }
    else if (services.slave.State() == NodeState::kResetCommunication)
    {
        static_cast<void>(sdo_.Close(cia301::SdoAbort::kDeviceState));
        services.Reset();
        loaded = parts_.owner.OnResetCommunication();
        const cia301::NumberReading start_up = dictionary_.ReadNumber({kStartUpIndex, 0U});
        const bool is_present = start_up.abort == cia301::SdoAbort::kNone;
        services.SetStartUp({is_present, static_cast<std::uint32_t>(start_up.value)});
    }
    else
    {
        // The first one loads nothing.
    }
    return loaded;
}

void Device::ApplyState() noexcept
{
    const NmtState state = cia301::KernelState(State());
    if (state != kernel_state_)
    {
        const bool was_operational = kernel_state_ == NmtState::kOperational;
        kernel_state_ = state;
        dictionary_.SetNmtState(state);
        if (was_operational)
        {
            LeaveOperational();
        }
        if (state == NmtState::kOperational)
        {
            AdmitSrdos();
        }
        parts_.kernel.SetNmtState(state);
        if (state == NmtState::kOperational)
        {
            EnterOperational();
        }
    }
    if (!cia301::IsAllowed(Service::kSdo, State()))
    {
        Answer(sdo_.Close(cia301::SdoAbort::kDeviceState));
    }
}

void Device::LeaveOperational() noexcept
{
    safety_.AdmitNone();
    parts_.watch.EndSrdoErrors();
    parts_.services.errors.EndAll(Concern::kConfiguration);
}

void Device::EnterOperational() noexcept
{
    const cia301::NumberReading valid = dictionary_.ReadNumber({kConfigurationValidIndex, 0U});
    if (valid.value != kConfigurationValidValue)
    {
        parts_.services.errors.Set(Concern::kConfiguration, kNotValid);
    }
}

// Directions and identifiers stay as they are until OPERATIONAL is left.
void Device::AdmitSrdos() noexcept
{
    for (std::uint8_t number = 0U; number < kMaxSrdoCount; ++number)
    {
        const auto index = static_cast<std::uint16_t>(kFirstCommunication + number);
        const ParametersReply parameters = parts_.kernel.GetParameters(CommunicationIndex{index});
        if ((parameters.result == Result::kSuccessful) && (parameters.direction != kDirectionOff))
        {
            safety_.Admit(static_cast<std::uint32_t>(dictionary_.ReadNumber({index, kCobIdSub1}).value));
            safety_.Admit(static_cast<std::uint32_t>(dictionary_.ReadNumber({index, kCobIdSub2}).value));
        }
    }
}

void Device::ServeFrame(const StampedFrame& frame, const Instant now) noexcept
{
    Services& services = parts_.services;
    const CanFrame& can = frame.frame;
    const bool is_request = (can.identifier == (kSdoRequest + services.node.value)) && (can.kind == FrameKind::kData);
    if (is_request && cia301::IsAllowed(Service::kSdo, State()))
    {
        cia301::SdoFrame request{};
        for (std::uint32_t i = 0U; i < kMaxPayloadBytes; ++i)
        {
            request.bytes[i] = can.data[i];
        }
        Answer(sdo_.OnFrame(request, can.length_bytes, now));
    }
    if (cia301::IsAllowed(Service::kErrorControl, State()))
    {
        services.consumer.OnFrame(can, now);
        const cia301::GuardMoment moment{State(), services.producer.PeriodMs(), now};
        Send(services.guarding.OnFrame(can, moment).reply);
    }
}

void Device::PollSdo(const Instant now) noexcept
{
    Answer(sdo_.Poll(now));
}

void Device::Answer(const cia301::SdoAnswer& answer) noexcept
{
    if (answer.presence == cia301::SdoPresence::kFrame)
    {
        CanFrame frame{kSdoAnswer + parts_.services.node.value, FrameKind::kData, CanPortId::kFirst, 8U, {}};
        for (std::uint32_t i = 0U; i < kMaxPayloadBytes; ++i)
        {
            frame.data[i] = answer.frame.bytes[i];
        }
        static_cast<void>(outbox_.Send(frame));
    }
}

void Device::Send(const cia301::FrameToSend& frame) noexcept
{
    if (frame.is_present)
    {
        static_cast<void>(outbox_.Send(frame.frame));
    }
}

} // namespace counterpoint::device
