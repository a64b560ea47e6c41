// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/time/time_stamp.hpp"

#include "canopen/cia301/base/cob_id.hpp"
#include "canopen/cia301/base/little_endian.hpp"
#include "canopen/cia301/objects/service_table.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint16_t kObject = 0x1012U;
constexpr std::uint16_t kHighResolution = 0x1013U;
constexpr std::uint32_t kDefaultCobId = 0x100U;
constexpr std::uint32_t kConsumes = 0x80000000U;
constexpr std::uint32_t kRoles = kConsumes | kCobBit30;
constexpr std::uint32_t kStandard = 0x7FFU;
constexpr std::uint32_t kFixedBits = 0x3FFFFFFFU; ///< Bits that do not change while one of the roles is played.
constexpr std::uint8_t kTimeBytes = 6U;
constexpr std::uint32_t kMsBits = 0x0FFFFFFFU;

} // namespace

TimeStamp::TimeStamp(FrameSink& sink, TimeListener& listener) noexcept
    : sink_(sink), listener_(listener), cob_id_(kDefaultCobId), now_us_(0U), ahead_us_(0U)
{
}

bool TimeStamp::Wants(const std::uint32_t identifier) const noexcept
{
    return ((cob_id_ & kConsumes) != 0U) && (identifier == (cob_id_ & kStandard));
}

bool TimeStamp::Uses(const std::uint32_t identifier) const noexcept
{
    return ((cob_id_ & kRoles) != 0U) && (identifier == (cob_id_ & kStandard));
}

void TimeStamp::ResetCommunication(NodeId) noexcept
{
    cob_id_ = kDefaultCobId;
    ahead_us_ = 0U;
}

void TimeStamp::OnFrame(const CanFrame& frame, const Moment& moment) noexcept
{
    const bool is_time = (frame.kind == FrameKind::kData) && (frame.length_bytes == kTimeBytes);
    if (is_time && Wants(frame.identifier) && IsAllowed(Service::kTime, moment.state))
    {
        const auto ms = static_cast<std::uint32_t>(FromLittleEndian(frame.data, 4U));
        const auto days = static_cast<std::uint16_t>(FromLittleEndian(&frame.data[4], 2U));
        listener_.OnTime(TimeOfDay{ms & kMsBits, days}, moment.now);
    }
}

void TimeStamp::OnCycle(const Moment& moment) noexcept
{
    now_us_ = moment.now.us;
}

bool TimeStamp::Send(const TimeOfDay& time, const Moment& moment) noexcept
{
    bool is_sent = false;
    if (((cob_id_ & kCobBit30) != 0U) && IsAllowed(Service::kTime, moment.state))
    {
        CanFrame frame{cob_id_ & kStandard, FrameKind::kData, CanPortId::kFirst, kTimeBytes, {}};
        ToLittleEndian(time.ms & kMsBits, frame.data, 4U);
        ToLittleEndian(time.days, &frame.data[4], 2U);
        is_sent = sink_.Send(frame);
    }
    return is_sent;
}

ObjectValue TimeStamp::Fetch(const ObjectAddress& address) noexcept
{
    const bool is_count = address.index == kHighResolution;
    ObjectValue value{SdoAbort::kNone, is_count ? (now_us_ + ahead_us_) : cob_id_, 4U};
    if ((!is_count) && (address.index != kObject))
    {
        value.abort = SdoAbort::kObjectUnknown;
    }
    else if (address.sub != 0U)
    {
        value.abort = SdoAbort::kSubUnknown;
    }
    return value;
}

SdoAbort TimeStamp::Store(const ObjectAddress& address, const std::uint32_t value) noexcept
{
    const bool is_playing = ((cob_id_ & kRoles) != 0U) && ((value & kRoles) != 0U);
    const bool is_moved = is_playing && (((cob_id_ ^ value) & kFixedBits) != 0U) && !IsConfiguring();
    const bool is_usable = ((value & kCobExtended) == 0U) && IsConfigurable(value & kCobIdentifier);
    SdoAbort abort = Fetch(address).abort;
    if ((abort == SdoAbort::kNone) && (address.index == kHighResolution))
    {
        ahead_us_ = value - now_us_;
    }
    else if ((abort == SdoAbort::kNone) && (is_moved || !is_usable))
    {
        abort = SdoAbort::kValueRange;
    }
    else if (abort == SdoAbort::kNone)
    {
        cob_id_ = value;
    }
    return abort;
}

} // namespace counterpoint::cia301
