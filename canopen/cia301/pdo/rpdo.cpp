// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What happens to a received PDO, and the objects of the RPDOs: 1400h.. and 1600h..
#include "canopen/cia301/pdo/rpdo.hpp"

#include "canopen/cia301/base/cob_id.hpp"
#include "canopen/cia301/objects/service_table.hpp"
#include "canopen/cia301/pdo/settings.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint16_t kFirstObject = 0x1400U;
constexpr std::uint32_t kUsPerMs = 1000U;
constexpr std::uint32_t kStandard = 0x7FFU;

constexpr std::uint8_t kHighestSub = 5U;
constexpr std::uint32_t kFirstEventDriven = 254U;

bool IsType(const std::uint32_t type) noexcept
{
    return (type <= kLastSynchronous) || (type >= kFirstEventDriven);
}

} // namespace

void Rpdos::OnFrame(const CanFrame& frame, const Moment& moment) noexcept
{
    FollowState(moment);
    for (std::uint16_t i = 0U; is_operational_ && (frame.kind == FrameKind::kData) && (i < parts_.table.count); ++i)
    {
        Rpdo& pdo = parts_.table.pdos[i];
        const bool is_receiving = ((pdo.settings.cob_id & kCobOff) == 0U) && (pdo.map.count > 0U);
        if (is_receiving && (frame.identifier == (pdo.settings.cob_id & kStandard)))
        {
            Take(pdo, frame, moment.now);
        }
    }
}

void Rpdos::Take(Rpdo& pdo, const CanFrame& frame, const Instant now) noexcept
{
    const std::uint8_t length_bytes = LengthOf(pdo.map);
    if (frame.length_bytes < length_bytes)
    {
        parts_.errors.Raise(CommunicationError::kPdoShort, pdo.number);
    }
    else
    {
        parts_.errors.Clear(CommunicationError::kPdoShort, pdo.number);
        if (frame.length_bytes > length_bytes)
        {
            parts_.errors.Raise(CommunicationError::kPdoLong, pdo.number);
        }
        else
        {
            parts_.errors.Clear(CommunicationError::kPdoLong, pdo.number);
        }
    }
    const bool is_in_time = !IsSynchronous(pdo) || IsInWindow(now);
    if ((frame.length_bytes >= length_bytes) && is_in_time)
    {
        parts_.errors.Clear(CommunicationError::kRpdoTimeOut, pdo.number);
        for (std::uint32_t i = 0U; i < kPdoBytes; ++i)
        {
            pdo.run.data.bytes[i] = frame.data[i];
        }
        pdo.run.received_at = now;
        pdo.run.is_supervised = true;
        pdo.run.is_waiting = true;
        if (!IsSynchronous(pdo))
        {
            Apply(pdo, now);
        }
    }
}

void Rpdos::OnSync(const SyncEvent& event) noexcept
{
    FollowState(event.moment);
    sync_at_ = event.moment.now;
    window_us_ = event.window_us;
    has_sync_ = is_operational_;
    for (std::uint16_t i = 0U; is_operational_ && (i < parts_.table.count); ++i)
    {
        if (parts_.table.pdos[i].run.is_waiting)
        {
            Apply(parts_.table.pdos[i], event.moment.now);
        }
    }
}

void Rpdos::OnCycle(const Moment& moment) noexcept
{
    FollowState(moment);
    for (std::uint16_t i = 0U; is_operational_ && (i < parts_.table.count); ++i)
    {
        Rpdo& pdo = parts_.table.pdos[i];
        const std::uint32_t limit_us = pdo.settings.event_ms * kUsPerMs;
        const bool is_watched = (limit_us > 0U) && pdo.run.is_supervised;
        if (is_watched && ((moment.now.us - pdo.run.received_at.us) > limit_us))
        {
            pdo.run.is_supervised = false;
            parts_.errors.Raise(CommunicationError::kRpdoTimeOut, pdo.number);
        }
    }
}

void Rpdos::FollowState(const Moment& moment) noexcept
{
    const bool is_allowed = IsAllowed(Service::kPdo, moment.state);
    for (std::uint16_t i = 0U; is_allowed && !is_operational_ && (i < parts_.table.count); ++i)
    {
        parts_.table.pdos[i].run = RpdoRun{};
    }
    has_sync_ = has_sync_ && is_operational_;
    is_operational_ = is_allowed;
}

void Rpdos::Apply(Rpdo& pdo, const Instant now) noexcept
{
    pdo.run.is_waiting = false;
    Unpack(pdo.map, pdo.run.data);
    if (parts_.listener != nullptr)
    {
        parts_.listener->OnRpdo(pdo.number, now);
    }
}

bool Rpdos::IsInWindow(const Instant now) const noexcept
{
    return (window_us_ == 0U) || !has_sync_ || ((now.us - sync_at_.us) <= window_us_);
}

Rpdos::Rpdos(const RpdoParts& parts) noexcept
    : parts_(parts), sync_at_{0U}, window_us_(0U), has_sync_(false), is_operational_(false), is_configuring_(false)
{
}

void Rpdos::Reset() noexcept
{
    for (std::uint16_t i = 0U; i < parts_.table.count; ++i)
    {
        Rpdo& pdo = parts_.table.pdos[i];
        pdo.settings = RpdoSettings{};
        pdo.run = RpdoRun{};
        ClearMap(pdo.map);
    }
    has_sync_ = false;
    is_operational_ = false;
    is_configuring_ = false;
}

void Rpdos::BeginConfiguration() noexcept
{
    is_configuring_ = true;
}

void Rpdos::EndConfiguration() noexcept
{
    for (std::uint16_t i = 0U; is_configuring_ && (i < parts_.table.count); ++i)
    {
        Rpdo& pdo = parts_.table.pdos[i];
        const bool is_mapped = ResolveMap(pdo.map, kInRpdo, parts_.dictionary) == SdoAbort::kNone;
        const bool is_set = IsUsable(pdo.settings.cob_id) && IsType(pdo.settings.type);
        pdo.settings.cob_id |= (is_mapped && is_set) ? 0U : kCobOff;
        pdo.run = RpdoRun{};
    }
    is_configuring_ = false;
}

void Rpdos::TurnOffShared(const WriteRule& rule) noexcept
{
    cia301::TurnOffShared(parts_.table.pdos, parts_.table.count, kFirstObject, rule);
}

bool Rpdos::Uses(const std::uint32_t identifier, const std::uint16_t except) const noexcept
{
    return IsUsed(parts_.table.pdos, parts_.table.count, identifier, except);
}

ObjectValue Rpdos::FetchSetting(const std::uint16_t number, const std::uint8_t sub) const noexcept
{
    const Rpdo* const pdo = Find(number);
    ObjectValue value{SdoAbort::kObjectUnknown, 0U, 1U};
    if (pdo != nullptr)
    {
        const RpdoSettings& own = pdo->settings;
        value = FetchShared({own.cob_id, own.type, own.inhibit_100us, own.event_ms}, sub, kHighestSub);
    }
    return value;
}

ObjectValue Rpdos::FetchMapping(const std::uint16_t number, const std::uint8_t sub) const noexcept
{
    const Rpdo* const pdo = Find(number);
    return (pdo != nullptr) ? FetchField(pdo->map, sub) : ObjectValue{SdoAbort::kObjectUnknown, 0U, 1U};
}

SdoAbort Rpdos::StoreSetting(const std::uint16_t number, const std::uint8_t sub, const std::uint32_t value) noexcept
{
    Rpdo* const pdo = Find(number);
    const ObjectValue old = FetchSetting(number, sub);
    SdoAbort abort = old.abort;
    if ((abort == SdoAbort::kNone) && (sub == 0U))
    {
        abort = SdoAbort::kReadOnly;
    }
    else if ((abort == SdoAbort::kNone) && (old.value != value))
    {
        abort = Change(*pdo, sub, value);
    }
    return abort;
}

/// A value that differs from what is there.
SdoAbort Rpdos::Change(Rpdo& pdo, const std::uint8_t sub, const std::uint32_t value) noexcept
{
    bool is_taken = true;
    switch (sub)
    {
    case kCobIdSub:
        is_taken = WriteCobId(pdo, value);
        break;
    case kTypeSub:
        is_taken = IsType(value);
        pdo.settings.type = is_taken ? static_cast<std::uint8_t>(value) : pdo.settings.type;
        break;
    case kInhibitSub:
        pdo.settings.inhibit_100us = static_cast<std::uint16_t>(value);
        break;
    default:
        WriteDeadline(pdo, static_cast<std::uint16_t>(value));
        break;
    }
    return is_taken ? SdoAbort::kNone : SdoAbort::kValueRange;
}

bool Rpdos::WriteCobId(Rpdo& pdo, const std::uint32_t value) noexcept
{
    const bool is_taken = is_configuring_ || IsAdmitted(pdo.settings.cob_id, value);
    if (is_taken)
    {
        pdo.settings.cob_id = value;
        pdo.run = RpdoRun{};
        ForgetErrors(pdo);
    }
    return is_taken;
}

void Rpdos::WriteDeadline(Rpdo& pdo, const std::uint16_t event_ms) noexcept
{
    pdo.settings.event_ms = event_ms;
    if (event_ms == 0U)
    {
        parts_.errors.Clear(CommunicationError::kRpdoTimeOut, pdo.number);
    }
}

/// No reception can end them any more.
void Rpdos::ForgetErrors(const Rpdo& pdo) noexcept
{
    parts_.errors.Clear(CommunicationError::kPdoShort, pdo.number);
    parts_.errors.Clear(CommunicationError::kPdoLong, pdo.number);
    parts_.errors.Clear(CommunicationError::kRpdoTimeOut, pdo.number);
}

SdoAbort Rpdos::StoreMapping(const std::uint16_t number, const std::uint8_t sub, const std::uint32_t value) noexcept
{
    Rpdo* const pdo = Find(number);
    const ObjectValue old = FetchMapping(number, sub);
    SdoAbort abort = old.abort;
    if ((abort == SdoAbort::kNone) && is_configuring_)
    {
        PrepareMap(pdo->map, sub, value);
    }
    else if ((abort == SdoAbort::kNone) && (old.value != value))
    {
        abort = ChangeMap(pdo->map, IsValid(*pdo), FieldChange{sub, value, kInRpdo}, parts_.dictionary);
    }
    return abort;
}

Rpdo* Rpdos::Find(const std::uint16_t number) const noexcept
{
    return FindPdo(parts_.table.pdos, parts_.table.count, number);
}

} // namespace counterpoint::cia301
