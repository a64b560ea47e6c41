// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/objects/service_objects.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint16_t kErrorRegister = 0x1001U;
constexpr std::uint16_t kErrorHistory = 0x1003U;
constexpr std::uint16_t kGuardTime = 0x100CU;
constexpr std::uint16_t kLifeFactor = 0x100DU;
constexpr std::uint16_t kEmergencyCobId = 0x1014U;
constexpr std::uint16_t kEmergencyInhibit = 0x1015U;
constexpr std::uint16_t kConsumerTimes = 0x1016U;
constexpr std::uint16_t kProducerTime = 0x1017U;
constexpr std::uint16_t kHeartbeatError = 0x8130U;
constexpr std::uint32_t kNodeShift = 16U;

} // namespace

ServiceObjects::ServiceObjects(const ServiceParts& parts) noexcept : parts_(parts), guard_time_ms_(0U), life_factor_(0U)
{
}

ObjectValue ServiceObjects::Fetch(const ObjectAddress& address) noexcept
{
    const bool is_list = (address.index == kErrorHistory) || (address.index == kConsumerTimes);
    return is_list ? FetchList(address) : FetchNumber(address);
}

SdoAbort ServiceObjects::Store(const ObjectAddress& address, const std::uint32_t value) noexcept
{
    SdoAbort abort = SdoAbort::kNone;
    switch (address.index)
    {
    case kErrorHistory:
        abort = (address.sub == 0U) ? parts_.emergency.WriteHistory(static_cast<std::uint8_t>(value & 0xFFU))
                                    : SdoAbort::kReadOnly;
        break;
    case kGuardTime:
        guard_time_ms_ = static_cast<std::uint16_t>(value & 0xFFFFU);
        parts_.guarding.SetLifeTime(guard_time_ms_, life_factor_);
        break;
    case kLifeFactor:
        life_factor_ = static_cast<std::uint8_t>(value & 0xFFU);
        parts_.guarding.SetLifeTime(guard_time_ms_, life_factor_);
        break;
    case kEmergencyCobId:
        abort = IsConfiguring() ? parts_.emergency.LoadCobId(value) : parts_.emergency.WriteCobId(value);
        break;
    case kEmergencyInhibit:
        parts_.emergency.SetInhibitTime(static_cast<std::uint16_t>(value & 0xFFFFU));
        break;
    case kConsumerTimes:
        abort = (address.sub == 0U) ? SdoAbort::kReadOnly : StoreConsumerTime(address.sub, value);
        break;
    case kProducerTime:
        parts_.producer.SetPeriod(static_cast<std::uint16_t>(value & 0xFFFFU));
        break;
    case kErrorRegister:
        abort = SdoAbort::kReadOnly;
        break;
    default:
        abort = SdoAbort::kObjectUnknown;
        break;
    }
    return abort;
}

SdoAbort ServiceObjects::StoreConsumerTime(const std::uint8_t sub, const std::uint32_t value) noexcept
{
    const std::uint32_t left = parts_.consumer.Value(sub);
    const SdoAbort abort = IsConfiguring() ? parts_.consumer.Load(sub, value) : parts_.consumer.Write(sub, value);
    const auto node = static_cast<std::uint16_t>((left >> kNodeShift) & 0xFFU);
    if ((abort == SdoAbort::kNone) && (node != 0U))
    {
        parts_.emergency.Clear(kHeartbeatError, node); // Of a node that was lost: nobody else ends it.
    }
    return abort;
}

ObjectValue ServiceObjects::FetchNumber(const ObjectAddress& address) const noexcept
{
    ObjectValue value{SdoAbort::kNone, 0U, 2U};
    switch (address.index)
    {
    case kErrorRegister:
        value = ObjectValue{SdoAbort::kNone, parts_.emergency.Register(), 1U};
        break;
    case kGuardTime:
        value.value = guard_time_ms_;
        break;
    case kLifeFactor:
        value = ObjectValue{SdoAbort::kNone, life_factor_, 1U};
        break;
    case kEmergencyCobId:
        value = ObjectValue{SdoAbort::kNone, parts_.emergency.CobId(), 4U};
        break;
    case kEmergencyInhibit:
        value.value = parts_.emergency.InhibitTime();
        break;
    case kProducerTime:
        value.value = parts_.producer.PeriodMs();
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

/// 1003h and 1016h: sub-index 0 has one byte, the others four.
ObjectValue ServiceObjects::FetchList(const ObjectAddress& address) const noexcept
{
    const std::uint32_t size_bytes = (address.sub == 0U) ? 1U : 4U;
    ObjectValue value{SdoAbort::kNone, parts_.consumer_count, size_bytes};
    if (address.index == kErrorHistory)
    {
        const HistoryReading history = parts_.emergency.History(address.sub);
        value.abort = history.abort;
        value.value = history.value;
    }
    else if (address.sub > parts_.consumer_count)
    {
        value.abort = SdoAbort::kSubUnknown;
    }
    else if (address.sub > 0U)
    {
        value.value = parts_.consumer.Value(address.sub);
    }
    return value;
}

} // namespace counterpoint::cia301
