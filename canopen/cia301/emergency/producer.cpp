// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/emergency/producer.hpp"

#include "canopen/cia301/base/cob_id.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint32_t kIdentifierBits = 0x7FFU;
constexpr std::uint32_t kBelowOff = 0x3FFFFFFFU;
constexpr std::uint8_t kGeneric = 0x01U;
constexpr std::uint32_t kUsPerStep = 100U;

} // namespace

EmergencyProducer::EmergencyProducer(const NodeId node, const ErrorHistory& history) noexcept
    : EmergencyProducer(node, history, EmergencyRoom{own_active_, own_waiting_, kEmergencyRoom})
{
}

EmergencyProducer::EmergencyProducer(const NodeId node, const ErrorHistory& history, const EmergencyRoom& room) noexcept
    : own_active_{}, own_waiting_{}, room_(room), history_(history), cob_id_(0x80U + node.value), inhibit_100us_(0U),
      active_count_(0U), waiting_count_(0U), history_count_(0U), dropped_(0U), is_inhibited_(false),
      is_end_untold_(false), sent_{0U}
{
    history_.count = (history_.count > kLongestHistory) ? kLongestHistory : history_.count;
    if (room_.count == 0U)
    {
        room_ = EmergencyRoom{own_active_, own_waiting_, kEmergencyRoom};
    }
}

/// Who hears the boot-up message that follows takes the device for one without errors.
void EmergencyProducer::ResetCommunication(const NodeId node) noexcept
{
    cob_id_ = 0x80U + node.value;
    inhibit_100us_ = 0U;
    waiting_count_ = 0U;
    is_inhibited_ = false;
    is_end_untold_ = false;
    for (std::uint16_t at = 0U; at < active_count_; ++at)
    {
        EmergencyError& error = room_.active[at];
        error.is_untold = false;
        if (error.urgency == EmergencyUrgency::kUrgent)
        {
            error.is_untold = !Queue(error.code, error); // None waits: there is a place for each.
        }
    }
}

void EmergencyProducer::Raise(const EmergencyError& error) noexcept
{
    if (Find(error.code, error.source) == active_count_)
    {
        if (active_count_ < RoomFor(error.urgency))
        {
            EmergencyError& active = room_.active[active_count_];
            active = error;
            ++active_count_;
            Remember(error);
            active.is_untold = !Queue(error.code, error);
        }
        else if (dropped_ < 0xFFU)
        {
            ++dropped_;
        }
    }
}

void EmergencyProducer::Clear(const std::uint16_t code, const std::uint16_t source) noexcept
{
    const std::uint16_t at = Find(code, source);
    if (at < active_count_)
    {
        --active_count_;
        for (std::uint16_t i = at; i < active_count_; ++i)
        {
            room_.active[i] = room_.active[i + 1U];
        }
        is_end_untold_ = !Queue(0U, EmergencyError{}); // One that finds room speaks for those before.
    }
}

FrameToSend EmergencyProducer::Poll(const NodeState state, const Instant now) noexcept
{
    const bool is_state = (state == NodeState::kPreOperational) || (state == NodeState::kOperational);
    const bool is_waiting = (waiting_count_ > 0U) && ((cob_id_ & kCobOff) == 0U);
    is_inhibited_ = is_inhibited_ && ((now.us - sent_.us) < (inhibit_100us_ * kUsPerStep));
    FrameToSend message{false, {}};
    if (is_state && is_waiting && !is_inhibited_)
    {
        message = FrameToSend{true, CanFrame{cob_id_ & kIdentifierBits, FrameKind::kData, CanPortId::kFirst, 8U, {}}};
        for (std::uint32_t i = 0U; i < 8U; ++i)
        {
            message.frame.data[i] = room_.waiting[0].bytes[i];
        }
        --waiting_count_;
        for (std::uint16_t i = 0U; i < waiting_count_; ++i)
        {
            room_.waiting[i] = room_.waiting[i + 1U];
        }
        TellUntold();
        is_inhibited_ = true;
        sent_ = now;
    }
    return message;
}

/// What found no room, as far as there is some now: one end for all that ended, then what is still active.
void EmergencyProducer::TellUntold() noexcept
{
    if (is_end_untold_ && (waiting_count_ < RoomFor(EmergencyUrgency::kUsual)))
    {
        is_end_untold_ = !Queue(0U, EmergencyError{});
    }
    for (std::uint16_t at = 0U; at < active_count_; ++at)
    {
        EmergencyError& error = room_.active[at];
        if (error.is_untold && (waiting_count_ < RoomFor(error.urgency)))
        {
            error.is_untold = !Queue(error.code, error);
        }
    }
}

std::uint8_t EmergencyProducer::Register() const noexcept
{
    std::uint8_t bits = 0U;
    for (std::uint16_t i = 0U; i < active_count_; ++i)
    {
        bits |= static_cast<std::uint8_t>(room_.active[i].register_bits | kGeneric);
    }
    return bits;
}

HistoryReading EmergencyProducer::History(const std::uint8_t sub) const noexcept
{
    HistoryReading reading{SdoAbort::kNone, history_count_};
    if (sub > history_.count)
    {
        reading.abort = SdoAbort::kSubUnknown;
    }
    else if (sub > history_count_)
    {
        reading.abort = SdoAbort::kNoData;
    }
    else if (sub > 0U)
    {
        reading.value = history_.errors[sub - 1U];
    }
    return reading;
}

SdoAbort EmergencyProducer::WriteHistory(const std::uint8_t count) noexcept
{
    history_count_ = (count == 0U) ? std::uint8_t{0U} : history_count_;
    return (count == 0U) ? SdoAbort::kNone : SdoAbort::kValueRange;
}

std::uint32_t EmergencyProducer::CobId() const noexcept
{
    return cob_id_;
}

SdoAbort EmergencyProducer::WriteCobId(const std::uint32_t value) noexcept
{
    const bool is_on = ((cob_id_ & kCobOff) == 0U) && ((value & kCobOff) == 0U);
    const bool is_changed = ((cob_id_ ^ value) & kBelowOff) != 0U;
    return (is_on && is_changed) ? SdoAbort::kValueRange : LoadCobId(value);
}

SdoAbort EmergencyProducer::LoadCobId(const std::uint32_t value) noexcept
{
    const bool is_usable = ((value & kCobBit30) == 0U) && IsConfigurable(value & kBelowOff);
    SdoAbort abort = SdoAbort::kValueRange;
    if (is_usable)
    {
        cob_id_ = value;
        abort = SdoAbort::kNone;
    }
    return abort;
}

std::uint16_t EmergencyProducer::InhibitTime() const noexcept
{
    return inhibit_100us_;
}

void EmergencyProducer::SetInhibitTime(const std::uint16_t time_100us) noexcept
{
    inhibit_100us_ = time_100us;
}

std::uint8_t EmergencyProducer::Dropped() const noexcept
{
    return dropped_;
}

/// Places that such an error may take, and its message.
std::uint16_t EmergencyProducer::RoomFor(const EmergencyUrgency urgency) const noexcept
{
    return (urgency == EmergencyUrgency::kUrgent) ? room_.count : static_cast<std::uint16_t>(room_.count - 1U);
}

/// Place of an active error, or `active_count_`.
std::uint16_t EmergencyProducer::Find(const std::uint16_t code, const std::uint16_t source) const noexcept
{
    std::uint16_t at = 0U;
    while ((at < active_count_) && ((room_.active[at].code != code) || (room_.active[at].source != source)))
    {
        ++at;
    }
    return at;
}

/// Whether there was room.
bool EmergencyProducer::Queue(const std::uint16_t code, const EmergencyError& error) noexcept
{
    const bool has_room = waiting_count_ < RoomFor(error.urgency);
    if (has_room)
    {
        EmergencyMessage& message = room_.waiting[waiting_count_];
        message.bytes[0] = static_cast<std::uint8_t>(code & 0xFFU);
        message.bytes[1] = static_cast<std::uint8_t>(code >> 8U);
        message.bytes[2] = Register();
        for (std::uint32_t i = 0U; i < 5U; ++i)
        {
            message.bytes[3U + i] = error.details[i];
        }
        ++waiting_count_;
    }
    else if (dropped_ < 0xFFU)
    {
        ++dropped_;
    }
    return has_room;
}

void EmergencyProducer::Remember(const EmergencyError& error) noexcept
{
    if (history_.count > 0U)
    {
        const bool is_full = history_count_ == history_.count;
        history_count_ = is_full ? history_count_ : static_cast<std::uint8_t>(history_count_ + 1U);
        for (std::uint32_t i = history_count_ - 1U; i > 0U; --i)
        {
            history_.errors[i] = history_.errors[i - 1U];
        }
        const std::uint32_t details = error.details[0] | (static_cast<std::uint32_t>(error.details[1]) << 8U);
        history_.errors[0] = error.code | (details << 16U);
    }
}

} // namespace counterpoint::cia301
