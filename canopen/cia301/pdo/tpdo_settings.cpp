// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Objects of the TPDOs: 1800h.. and 1A00h..
#include "canopen/cia301/base/cob_id.hpp"
#include "canopen/cia301/pdo/settings.hpp"
#include "canopen/cia301/pdo/tpdo.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint8_t kHighestSub = 6U;
constexpr std::uint8_t kStartSub = 6U;
constexpr std::uint32_t kFirstOnRtr = 252U;

bool IsValid(const Tpdo& pdo) noexcept
{
    return (pdo.settings.cob_id & kCobOff) == 0U;
}

bool IsType(const std::uint32_t type) noexcept
{
    return (type <= kLastSynchronous) || (type >= kFirstOnRtr);
}

} // namespace

Tpdos::Tpdos(const TpdoParts& parts) noexcept : parts_(parts), is_operational_(false), is_configuring_(false)
{
}

void Tpdos::Reset() noexcept
{
    for (std::uint16_t i = 0U; i < parts_.table.count; ++i)
    {
        Tpdo& pdo = parts_.table.pdos[i];
        pdo.settings = TpdoSettings{};
        pdo.run = TpdoRun{};
        ClearMap(pdo.map);
    }
    is_operational_ = false;
    is_configuring_ = false;
}

void Tpdos::BeginConfiguration() noexcept
{
    is_configuring_ = true;
}

void Tpdos::EndConfiguration() noexcept
{
    for (std::uint16_t i = 0U; is_configuring_ && (i < parts_.table.count); ++i)
    {
        Tpdo& pdo = parts_.table.pdos[i];
        const bool is_mapped = ResolveMap(pdo.map, kInTpdo, parts_.dictionary) == SdoAbort::kNone;
        const bool is_set = IsUsable(pdo.settings.cob_id) && IsType(pdo.settings.type);
        pdo.settings.cob_id |= (is_mapped && is_set) ? 0U : kCobOff;
        Start(pdo);
    }
    is_configuring_ = false;
}

ObjectValue Tpdos::FetchSetting(const std::uint16_t number, const std::uint8_t sub) const noexcept
{
    const Tpdo* const pdo = Find(number);
    ObjectValue value{SdoAbort::kObjectUnknown, 0U, 1U};
    if (pdo != nullptr)
    {
        const TpdoSettings& own = pdo->settings;
        value = FetchShared({own.cob_id, own.type, own.inhibit_100us, own.event_ms}, sub, kHighestSub);
        if (sub == kStartSub)
        {
            value = ObjectValue{SdoAbort::kNone, own.sync_start, 1U};
        }
    }
    return value;
}

ObjectValue Tpdos::FetchMapping(const std::uint16_t number, const std::uint8_t sub) const noexcept
{
    const Tpdo* const pdo = Find(number);
    ObjectValue value{SdoAbort::kObjectUnknown, 0U, 1U};
    if (pdo != nullptr)
    {
        value = FetchField(pdo->map, sub);
    }
    return value;
}

SdoAbort Tpdos::StoreSetting(const std::uint16_t number, const std::uint8_t sub, const std::uint32_t value) noexcept
{
    Tpdo* const pdo = Find(number);
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
SdoAbort Tpdos::Change(Tpdo& pdo, const std::uint8_t sub, const std::uint32_t value) noexcept
{
    const bool is_fixed = IsValid(pdo) && !is_configuring_;
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
        is_taken = !is_fixed;
        pdo.settings.inhibit_100us = is_taken ? static_cast<std::uint16_t>(value) : pdo.settings.inhibit_100us;
        break;
    case kEventSub:
        pdo.settings.event_ms = static_cast<std::uint16_t>(value);
        break;
    default:
        is_taken = !is_fixed && (value <= kLastSynchronous);
        pdo.settings.sync_start = is_taken ? static_cast<std::uint8_t>(value) : pdo.settings.sync_start;
        break;
    }
    return is_taken ? SdoAbort::kNone : SdoAbort::kValueRange;
}

bool Tpdos::WriteCobId(Tpdo& pdo, const std::uint32_t value) noexcept
{
    const bool stays_valid = IsValid(pdo) && ((value & kCobOff) == 0U);
    const bool is_changed = ((pdo.settings.cob_id ^ value) & kFixedCobBits) != 0U;
    const bool is_taken = is_configuring_ || (IsUsable(value) && !(stays_valid && is_changed));
    if (is_taken)
    {
        pdo.settings.cob_id = value;
        Start(pdo);
    }
    return is_taken;
}

SdoAbort Tpdos::StoreMapping(const std::uint16_t number, const std::uint8_t sub, const std::uint32_t value) noexcept
{
    Tpdo* const pdo = Find(number);
    const ObjectValue old = FetchMapping(number, sub);
    SdoAbort abort = old.abort;
    if ((abort == SdoAbort::kNone) && is_configuring_)
    {
        PrepareMap(pdo->map, sub, value);
    }
    else if ((abort == SdoAbort::kNone) && (old.value != value))
    {
        abort = ChangeMap(pdo->map, IsValid(*pdo), FieldChange{sub, value, kInTpdo}, parts_.dictionary);
    }
    return abort;
}

Tpdo* Tpdos::Find(const std::uint16_t number) const noexcept
{
    Tpdo* found = nullptr;
    for (std::uint16_t i = 0U; i < parts_.table.count; ++i)
    {
        found = (parts_.table.pdos[i].number == number) ? &parts_.table.pdos[i] : found;
    }
    return found;
}

} // namespace counterpoint::cia301
