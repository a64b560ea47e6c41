// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/time/sync.hpp"

#include "canopen/cia301/base/cob_id.hpp"
#include "canopen/cia301/objects/service_table.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint16_t kCobIdObject = 0x1005U;
constexpr std::uint16_t kPeriodObject = 0x1006U;
constexpr std::uint16_t kWindowObject = 0x1007U;
constexpr std::uint16_t kOverflowObject = 0x1019U;
constexpr std::uint32_t kDefaultCobId = 0x80U;
constexpr std::uint32_t kLeastOverflow = 2U;
constexpr std::uint32_t kGreatestOverflow = 240U;
constexpr std::uint32_t kStandard = 0x7FFU;
constexpr std::uint32_t kFixedBits = 0x3FFFFFFFU; ///< Bits that do not change while SYNC is produced.

} // namespace

Sync::Sync(const SyncParts& parts) noexcept
    : parts_(parts), cob_id_(kDefaultCobId), period_us_(0U), window_us_(0U), overflow_(0U), counter_(0U),
      is_running_(false), due_{0U}
{
}

void Sync::Reset() noexcept
{
    cob_id_ = kDefaultCobId;
    period_us_ = 0U;
    window_us_ = 0U;
    overflow_ = 0U;
    counter_ = 0U;
    is_running_ = false;
}

bool Sync::Uses(const std::uint32_t identifier) const noexcept
{
    return identifier == (cob_id_ & kStandard);
}

void Sync::OnFrame(const CanFrame& frame, const Moment& moment) noexcept
{
    const bool is_sync = (frame.kind == FrameKind::kData) && (frame.identifier == (cob_id_ & kStandard));
    const std::uint8_t length_bytes = (overflow_ == 0U) ? 0U : 1U;
    if (is_sync && IsAllowed(Service::kSync, moment.state))
    {
        if (frame.length_bytes == length_bytes)
        {
            const std::uint8_t counter = (length_bytes == 0U) ? std::uint8_t{0U} : frame.data[0];
            parts_.errors.Clear(CommunicationError::kSyncLength, 0U);
            parts_.listener.OnSync(SyncEvent{counter, window_us_, moment});
        }
        else
        {
            parts_.errors.Raise(CommunicationError::kSyncLength, 0U);
        }
    }
}

void Sync::OnCycle(const Moment& moment) noexcept
{
    const bool is_producer = ((cob_id_ & kCobBit30) != 0U) && (period_us_ > 0U);
    const std::uint32_t since_us = moment.now.us - due_.us;
    if (!is_producer || !IsAllowed(Service::kSync, moment.state))
    {
        is_running_ = false;
        counter_ = 0U;
    }
    else if (!is_running_ || (since_us >= period_us_))
    {
        const bool is_first = (counter_ == 0U) || (counter_ >= overflow_);
        const auto next = static_cast<std::uint8_t>(is_first ? 1U : (counter_ + 1U));
        const std::uint8_t counter = (overflow_ == 0U) ? std::uint8_t{0U} : next;
        const std::uint8_t length_bytes = (overflow_ == 0U) ? 0U : 1U;
        const CanFrame frame{cob_id_ & kStandard, FrameKind::kData, CanPortId::kFirst, length_bytes, {counter}};
        if (parts_.sink.Send(frame))
        {
            // Phase is kept unless a whole period was missed.
            const bool is_steady = is_running_ && ((since_us - period_us_) < period_us_);
            due_.us = is_steady ? (due_.us + period_us_) : moment.now.us;
            is_running_ = true;
            counter_ = counter;
            parts_.listener.OnSync(SyncEvent{counter, window_us_, moment});
        }
    }
}

ObjectValue Sync::Fetch(const ObjectAddress& address) noexcept
{
    ObjectValue value{SdoAbort::kNone, 0U, 4U};
    switch (address.index)
    {
    case kCobIdObject:
        value.value = cob_id_;
        break;
    case kPeriodObject:
        value.value = period_us_;
        break;
    case kWindowObject:
        value.value = window_us_;
        break;
    case kOverflowObject:
        value = ObjectValue{SdoAbort::kNone, overflow_, 1U};
        break;
    default:
        value.abort = SdoAbort::kObjectUnknown;
        break;
    }
    if ((value.abort == SdoAbort::kNone) && (address.sub != 0U))
    {
        value.abort = SdoAbort::kSubUnknown;
    }
    return value;
}

SdoAbort Sync::Store(const ObjectAddress& address, const std::uint32_t value) noexcept
{
    SdoAbort abort = Fetch(address).abort;
    if (abort == SdoAbort::kNone)
    {
        switch (address.index)
        {
        case kCobIdObject:
            abort = WriteCobId(value);
            break;
        case kPeriodObject:
            is_running_ = is_running_ && (value == period_us_);
            period_us_ = value;
            break;
        case kWindowObject:
            window_us_ = value;
            break;
        default:
            abort = WriteOverflow(value);
            break;
        }
    }
    return abort;
}

SdoAbort Sync::WriteCobId(const std::uint32_t value) noexcept
{
    const bool is_produced = ((cob_id_ & kCobBit30) != 0U) && ((value & kCobBit30) != 0U);
    const bool is_changed = ((cob_id_ ^ value) & kFixedBits) != 0U;
    const bool is_usable = ((value & kCobExtended) == 0U) && IsConfigurable(value & kCobIdentifier);
    SdoAbort abort = SdoAbort::kValueRange;
    if (is_usable && (IsConfiguring() || !(is_produced && is_changed)))
    {
        if (((cob_id_ ^ value) & kStandard) != 0U)
        {
            parts_.errors.Clear(CommunicationError::kSyncLength, 0U);
        }
        cob_id_ = value;
        abort = SdoAbort::kNone;
    }
    return abort;
}

SdoAbort Sync::WriteOverflow(const std::uint32_t value) noexcept
{
    const bool is_usable = (value == 0U) || ((value >= kLeastOverflow) && (value <= kGreatestOverflow));
    SdoAbort abort = SdoAbort::kNone;
    if (!is_usable)
    {
        abort = SdoAbort::kValueRange;
    }
    else if ((value != overflow_) && (period_us_ != 0U) && !IsConfiguring())
    {
        abort = SdoAbort::kDeviceState;
    }
    else
    {
        if ((value == 0U) != (overflow_ == 0U))
        {
            parts_.errors.Clear(CommunicationError::kSyncLength, 0U);
        }
        overflow_ = static_cast<std::uint8_t>(value);
    }
    return abort;
}

} // namespace counterpoint::cia301
