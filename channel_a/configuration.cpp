// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/channel.hpp"
#include "channel_a/octets.hpp"
#include "channel_a/seal.hpp"
#include "channel_a/slots.hpp"
#include "channel_a/voice.hpp"

#include <cstddef>
#include <cstdint>

// The own copy of the configuration and its rules.
namespace counterpoint::channel_a
{
namespace
{

constexpr std::uint32_t kU8 = 24U; // How many of 32 bits the field has not.
constexpr std::uint32_t kU16 = 16U;
constexpr std::uint32_t kU32 = 0U;

constexpr std::size_t kNoPlace = kValueCount;
constexpr std::uint32_t kNoSub = 0xFFFFFFFFU; // Above every limit of a mapping.

// Width and place in Record::values by ConfigField; the direction and the entries have no place there.
struct FieldFacts
{
    std::uint8_t missing_bits;
    std::uint8_t place;
};

constexpr std::size_t kFieldCount = 10U;
constexpr FieldFacts kFields[kFieldCount] = {
    // MISRA D-001
    {kU8, kNoPlace},     {kU8, kNoPlace},          {kU16, kSctPlace}, {kU8, kSrvtPlace}, {kU8, kTransmissionTypePlace},
    {kU32, kCobIdPlace}, {kU32, kCobIdPlace + 1U}, {kU8, kNoPlace},   {kU32, kNoPlace},  {kU16, kSignaturePlace},
};
static_assert(static_cast<std::size_t>(ConfigField::kSignature) + 1U == kFieldCount, "facts for each field of a slot");

// Place of a value of the whole device; not below kGlobalCount if it is none of these.
std::size_t GlobalPlaceOf(const ConfigAddress& address) noexcept
{
    return static_cast<std::size_t>(address.field) - static_cast<std::size_t>(ConfigField::kGfcParameter);
}

bool IsOfSlot(const Voice& voice, const ConfigAddress& address) noexcept
{
    return (address.slot < voice.count) && (static_cast<std::size_t>(address.field) < kFieldCount);
}

// Where the value of a field of a slot is kept; null if it is not: the direction, an entry that does not exist, what is
// a part of the program.
std::uint32_t* CellOf(const Voice& voice, const ConfigAddress& address) noexcept
{
    const std::size_t place = kFields[static_cast<std::size_t>(address.field)].place;
    if (place < kValueCount)
    {
        return &At(voice, address.slot).values[place];
    }
    const Mapping mapping = MappingOf(voice, address.slot);
    std::uint32_t sub = kNoSub;
    if (address.field == ConfigField::kMapCount)
    {
        sub = 0U;
    }
    if ((address.field == ConfigField::kMapEntry) && (address.sub != 0U))
    {
        sub = address.sub;
    }
    if ((mapping.places == nullptr) || (sub > mapping.limit))
    {
        return nullptr;
    }
    return RowOf(voice, address.slot) + sub; // MISRA D-002
}

// A producer takes its refresh time anew.
void StoreOfSlot(const Voice& voice, const ConfigItem& item) noexcept
{
    Record& record = At(voice, item.address.slot);
    const std::uint32_t value =
        item.value & (kAllBits >> kFields[static_cast<std::size_t>(item.address.field)].missing_bits);
    std::uint32_t* const cell = CellOf(voice, item.address);
    if (item.address.field == ConfigField::kDirection)
    {
        SetDirection(record, static_cast<std::uint8_t>(value));
    }
    else if (cell != nullptr)
    {
        *cell = value;
    }
    else
    {
        return;
    }
    Demand(record, kLook);
    if (item.address.field != ConfigField::kSignature)
    {
        record.mapping = kUnmarked;
    }
}

std::uint32_t LoadOfSlot(const Voice& voice, const ConfigAddress& address) noexcept
{
    const Mapping mapping = MappingOf(voice, address.slot);
    const std::uint32_t* const cell = CellOf(voice, address);
    const std::uint32_t position = address.sub - std::uint32_t{1U};
    std::uint32_t value = 0U;
    if (cell != nullptr)
    {
        value = *cell;
    }
    else if (address.field == ConfigField::kDirection)
    {
        value = At(voice, address.slot).direction;
    }
    else if (address.field == ConfigField::kMapCount)
    {
        value = mapping.stored_count;
    }
    else if ((address.field == ConfigField::kMapEntry) && (position < mapping.count))
    {
        value = mapping.entries[position]; // MISRA D-002
    }
    else
    {
        // Nothing is there.
    }
    return value;
}

// Whether another SRDO has one of the two identifiers from `first` on.
bool IsInUse(const Voice& voice, const SlotIndex slot, const std::uint32_t first) noexcept
{
    bool is_in_use = false;
    for (SlotIndex other = 0U; other < voice.count; ++other)
    {
        const Record& record = At(voice, other);
        const bool is_other = (other != slot) && (record.direction != kDirectionOff);
        const bool has_it =
            ((record.values[kCobIdPlace] - first) < 2U) || ((record.values[kCobIdPlace + 1U] - first) < 2U);
        if (is_other && has_it)
        {
            is_in_use = true;
        }
    }
    return is_in_use;
}

bool HasGoodTiming(const Voice& voice, const Record& record) noexcept
{
    const std::uint32_t sct_ms = record.values[kSctPlace];
    const std::uint32_t srvt_ms = record.values[kSrvtPlace];
    bool is_good = (sct_ms * kMicrosecondsPerMillisecond) >= voice.config->cycle_us;
    if (record.direction == kDirectionConsumer)
    {
        is_good = (srvt_ms != 0U) && (srvt_ms < sct_ms);
    }
    return is_good;
}

// SRS_CFG_021, SRS_CFG_022, SRS_CFG_023, SRS_CFG_024, SRS_CFG_025.
ConfigFault CheckCommunication(const Voice& voice, const SlotIndex slot) noexcept
{
    const Record& record = At(voice, slot);
    const std::uint32_t identifier = record.values[kCobIdPlace];
    if (record.direction > kDirectionConsumer)
    {
        return ConfigFault::kDirection;
    }
    if (record.values[kTransmissionTypePlace] != kTransmissionTypeAsynchronous)
    {
        return ConfigFault::kTransmissionType;
    }
    // The range from 101h on makes an odd place an even identifier.
    const std::uint32_t place = identifier - kFirstSrdoIdentifier;
    if ((place >= kSrdoIdentifierCount) || ((place % 2U) != 0U) ||
        (record.values[kCobIdPlace + 1U] != (identifier + 1U)))
    {
        return ConfigFault::kIdentifier;
    }
    if (IsInUse(voice, slot, identifier))
    {
        return ConfigFault::kIdentifierInUse;
    }
    return HasGoodTiming(voice, record) ? ConfigFault::kNone : ConfigFault::kTiming;
}

} // namespace

void Channel::Store(const ConfigItem& item) noexcept
{
    const std::size_t place = GlobalPlaceOf(item.address);
    if (place < kGlobalCount)
    {
        voice_.globals[place] = static_cast<std::uint8_t>(item.value);
    }
    if (IsOfSlot(voice_, item.address))
    {
        StoreOfSlot(voice_, item);
    }
}

ConfigItem Channel::Load(const ConfigAddress& address) const noexcept
{
    ConfigItem item{address, 0U};
    const std::size_t place = GlobalPlaceOf(address);
    if (place < kGlobalCount)
    {
        item.value = voice_.globals[place];
    }
    if (IsOfSlot(voice_, address))
    {
        item.value = LoadOfSlot(voice_, address);
    }
    return item;
}

ChannelRoom Channel::Room() const noexcept
{
    const std::size_t entries = voice_.storage.row - kFirstEntry;
    return ChannelRoom{voice_.storage.capacity, static_cast<std::uint8_t>(entries)};
}

void Channel::SetFields(const SlotIndex slot, const StaticFields& fields) noexcept
{
    if (MappingOf(voice_, slot).places == nullptr)
    {
        At(voice_, slot).fields = fields;
        At(voice_, slot).mapping = kUnmarked;
    }
}

CheckResult Channel::Validate(const SlotIndex slot) noexcept
{
    Record& record = At(voice_, slot);
    const Mapping mapping = MappingOf(voice_, slot);
    CheckResult result{ConfigFault::kNone, static_cast<std::uint16_t>(Signature(record, mapping))};
    const bool is_off = record.direction == kDirectionOff;
    record.mapping = kUnmarked;
    record.check = kUnmarked;
    if (!is_off)
    {
        result.fault = CheckCommunication(voice_, slot);
    }
    if (!is_off && (result.fault == ConfigFault::kNone))
    {
        result.fault = Resolve(*voice_.config, record, mapping);
    }
    if ((result.fault == ConfigFault::kNone) && (result.signature != record.values[kSignaturePlace]))
    {
        result.fault = ConfigFault::kSignature;
    }
    if (result.fault == ConfigFault::kNone)
    {
        record.check = kMarked;
        record.mapping = is_off ? kUnmarked : kMarked;
    }
    if ((record.mapping == kMarked) && (record.direction == kDirectionConsumer))
    {
        WriteObjects(voice_, slot, record.safe);
        Put(voice_.committed, slot, 0U); // The objects hold no pair any more.
    }
    return result;
}

CheckResult Channel::Recheck(const SlotIndex slot) noexcept
{
    Record& record = At(voice_, slot);
    const Mapping mapping = MappingOf(voice_, slot);
    CheckResult result{ConfigFault::kNone, static_cast<std::uint16_t>(Signature(record, mapping))};
    if (result.signature != record.values[kSignaturePlace])
    {
        result.fault = ConfigFault::kSignature;
    }
    else if ((record.direction != kDirectionOff) && !HoldsTable(*voice_.config, record, mapping))
    {
        result.fault = ConfigFault::kTable;
    }
    else
    {
        // Nothing found.
    }
    record.check = (result.fault == ConfigFault::kNone) ? kMarked : kUnmarked;
    return result;
}

} // namespace counterpoint::channel_a
