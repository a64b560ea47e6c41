// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/cia302/fake_slave.hpp"

#include <algorithm>
#include <new>

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint32_t kUsPerMs = 1000U;
constexpr std::uint32_t kRoom = 4000U;

std::uint32_t KeyAt(const ObjectAddress& address)
{
    return cia301::KeyOf(address.index, address.sub);
}

} // namespace

FakeSlave::FakeSlave(const std::uint8_t id, cia301::FrameSink& bus)
    : node(id), bus_(bus), nmt_(NodeId{id}, cia301::StartUp{false, 0U}),
      server_(cia301::SdoServerParts{dictionary_, cia301::Room{buffer_.data(), 8000U}, 1'000'000U, 100U}),
      port_(server_, bus, NodeId{id}), heartbeat_(NodeId{id}), guarding_(NodeId{id})
{
}

void FakeSlave::Put(const std::uint16_t index, const std::uint8_t sub, const Octets& value)
{
    values_[cia301::KeyOf(index, sub)] = value;
}

void FakeSlave::Put32(const std::uint16_t index, const std::uint8_t sub, const std::uint32_t value)
{
    Put(index, sub,
        {static_cast<std::uint8_t>(value & 0xFFU), static_cast<std::uint8_t>((value >> 8U) & 0xFFU),
         static_cast<std::uint8_t>((value >> 16U) & 0xFFU), static_cast<std::uint8_t>(value >> 24U)});
}

void FakeSlave::Put8(const std::uint16_t index, const std::uint8_t sub, const std::uint8_t value)
{
    Put(index, sub, {value});
}

Octets FakeSlave::Get(const std::uint16_t index, const std::uint8_t sub) const
{
    const auto found = values_.find(cia301::KeyOf(index, sub));
    return (found == values_.end()) ? Octets{} : found->second;
}

void FakeSlave::PutIdentity()
{
    Put32(0x1000U, 0U, 0x191U);
    Put32(0x1018U, 1U, 0x2AU);
    Put32(0x1018U, 2U, 7U);
    Put32(0x1018U, 3U, 3U);
    Put32(0x1018U, 4U, 0x1234U);
}

/// Every object is served by the hooks; domains may take another length.
void FakeSlave::Build()
{
    entries_.clear();
    for (const auto& [key, value] : values_)
    {
        cia301::Entry entry{};
        entry.index = static_cast<std::uint16_t>(key >> 8U);
        entry.sub = static_cast<std::uint8_t>(key & 0xFFU);
        entry.access = cia301::Access::kReadWrite;
        entry.readable_in = cia301::kInBoth;
        entry.writable_in = cia301::kInBoth;
        const std::size_t size = value.size();
        const bool is_number = (size == 1U) || (size == 2U) || (size == 4U);
        entry.type = is_number ? ((size == 1U)   ? cia301::DataType::kUnsigned8
                                  : (size == 2U) ? cia301::DataType::kUnsigned16
                                                 : cia301::DataType::kUnsigned32)
                               : cia301::DataType::kDomain;
        entry.size_bytes = is_number ? static_cast<std::uint32_t>(size) : kRoom;
        entry.length_bytes = is_number ? nullptr : &lengths_[key];
        entry.read_hook = this;
        entry.write_hook = this;
        entries_.push_back(entry);
    }
    dictionary_.~Dictionary();
    new (&dictionary_)
        cia301::Dictionary{cia301::EntryTable{entries_.data(), static_cast<std::uint32_t>(entries_.size())}, foreign_};
}

void FakeSlave::Power(const Instant now)
{
    Build();
    is_on = true;
    nmt_ = cia301::NmtSlave{NodeId{node}, cia301::StartUp{is_self_starting, 0U}};
    Restart(now);
}

void FakeSlave::Unplug()
{
    is_on = false;
}

cia301::NodeState FakeSlave::State() const
{
    return nmt_.State();
}

void FakeSlave::Restart(const Instant now)
{
    ++resets;
    for (const auto& [key, value] : after_reset)
    {
        values_[key] = value;
    }
    port_.ResetCommunication(NodeId{node});
    guarding_.Reset();
    heartbeat_.SetPeriod(0U);
    reset_at_ = now;
    is_booting_ = true;
}

void FakeSlave::OnFrame(const CanFrame& frame, const Instant now)
{
    if (is_on && !is_booting_)
    {
        const cia301::Moment moment{nmt_.State(), now};
        nmt_.OnFrame(frame);
        const cia301::NodeState state = nmt_.State();
        const bool is_reset =
            (state == cia301::NodeState::kResetApplication) || (state == cia301::NodeState::kResetCommunication);
        if (is_reset)
        {
            Restart(now);
        }
        else
        {
            const cia301::GuardReply guard =
                guarding_.OnFrame(frame, cia301::GuardMoment{moment.state, heartbeat_ms, now});
            if (guard.reply.is_present)
            {
                CanFrame reply = guard.reply.frame;
                reply.data[0] = is_toggle_stuck ? static_cast<std::uint8_t>(reply.data[0] & 0x7FU) : reply.data[0];
                static_cast<void>(bus_.Send(reply));
            }
            if (!is_sdo_mute && (writes.size() < mute_after_writes))
            {
                port_.OnFrame(frame, moment);
            }
        }
    }
}

void FakeSlave::OnCycle(const Instant now)
{
    if (is_on && is_booting_ && ((now.us - reset_at_.us) >= (kUsPerMs * boot_ms)))
    {
        is_booting_ = false;
        cia301::FrameToSend boot_up{false, {}};
        for (int i = 0; (i < 4) && !boot_up.is_present; ++i)
        {
            boot_up = nmt_.Advance();
        }
        if (has_boot_up)
        {
            static_cast<void>(bus_.Send(boot_up.frame));
        }
        heartbeat_.SetPeriod(heartbeat_ms);
    }
    if (is_on && !is_booting_)
    {
        const cia301::Moment moment{nmt_.State(), now};
        const bool is_operational = (moment.state == cia301::NodeState::kOperational);
        dictionary_.SetNmtState(is_operational ? NmtState::kOperational : NmtState::kPreOperational);
        const cia301::FrameToSend beat = heartbeat_.Poll(moment.state, now);
        if (beat.is_present)
        {
            static_cast<void>(bus_.Send(beat.frame));
        }
        port_.OnCycle(moment);
    }
}

cia301::Reading FakeSlave::OnRead(const ObjectAddress& address, const cia301::Room& room) noexcept
{
    ++reads;
    const auto refusal = refused.find(KeyAt(address));
    const Octets& value = values_[KeyAt(address)];
    cia301::Reading reading{SdoAbort::kNone, static_cast<std::uint32_t>(value.size())};
    if (refusal != refused.end())
    {
        reading.abort = refusal->second;
    }
    else if (value.size() > room.size_bytes)
    {
        reading.abort = SdoAbort::kOutOfMemory;
    }
    else
    {
        std::copy(value.begin(), value.end(), room.data);
    }
    return reading;
}

SdoAbort FakeSlave::OnWrite(const ObjectAddress& address, const cia301::Bytes& value) noexcept
{
    const auto refusal = refused.find(KeyAt(address));
    const SdoAbort abort = (refusal == refused.end()) ? SdoAbort::kNone : refusal->second;
    writes.push_back(KeyAt(address));
    if (abort == SdoAbort::kNone)
    {
        values_[KeyAt(address)] = Octets(value.data, value.data + value.size_bytes);
        const bool is_period = KeyAt(address) == cia301::KeyOf(0x1017U, 0U);
        heartbeat_ms = is_period ? static_cast<std::uint16_t>(value.data[0] | (value.data[1] << 8U)) : heartbeat_ms;
        if (is_period || !is_period_kept)
        {
            heartbeat_.SetPeriod(heartbeat_ms);
        }
    }
    return abort;
}

} // namespace counterpoint::cia302
