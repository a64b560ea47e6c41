// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/channel.hpp"
#include "channel_b/image.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_b
{

namespace
{

/// Place and width of a field in the image; the number of the field is the row.
struct FieldSpan
{
    std::uint8_t at;
    std::uint8_t width;
};

constexpr std::uint8_t kFieldCount = 12U;
constexpr FieldSpan kSpans[kFieldCount] = { // MISRA D-001
    {0U, 0U},
    {0U, 1U},
    {kSctAt, 2U},
    {kSrvtAt, 1U},
    {kTransmissionTypeAt, 1U},
    {kCobId1At, 4U},
    {kCobId2At, 4U},
    {kMapCountAt, 1U},
    {kEntriesAt + 1U, 4U},
    {kSignatureAt, 2U},
    {kGfcParameterAt, 1U},
    {kConfigurationValidAt, 1U}};

/// The object that the entry names: index and sub-index.
[[nodiscard]] std::uint32_t KeyOf(const MappableObject& object) noexcept
{
    return (static_cast<std::uint32_t>(object.index) << 8U) | static_cast<std::uint32_t>(object.sub);
}

[[nodiscard]] std::uint32_t StoredSignature(const Row& row) noexcept
{
    return ByteAt(row, kSignatureAt) | (ByteAt(row, kSignatureAt + 1U) << 8U);
}

} // namespace

Channel::Place Channel::PlaceOf(const ConfigAddress& address) const noexcept
{
    const std::uint32_t field = static_cast<std::uint32_t>(address.field);
    const FieldSpan span = kSpans[(field < kFieldCount) ? field : 0U]; // MISRA D-002
    if (field >= static_cast<std::uint32_t>(ConfigField::kGfcParameter))
    {
        return Place{{&x_storage.device[span.at]}, span.width};
    }
    // Without a map entry the sub-index counts for nothing; sub-index 0 of one becomes a huge number.
    const bool is_entry = address.field == ConfigField::kMapEntry;
    const std::uint32_t index = is_entry ? (static_cast<std::uint32_t>(address.sub) - 1U) : 0U;
    if ((address.slot >= x_count) || (index >= kMaxMapEntries))
    {
        return Place{{nullptr}, 0U};
    }
    if (address.field == ConfigField::kDirection)
    {
        return Place{{&x_storage.direction[address.slot]}, span.width};
    }
    const std::size_t at = span.at + (std::size_t{index} * kEntryBytes);
    return Place{{&x_storage.rows[address.slot].image[at]}, span.width}; // MISRA D-002
}

void Channel::Store(const ConfigItem& item) noexcept
{
    const Place place = PlaceOf(item.address);
    if (place.width == 0U)
    {
        return;
    }
    const SlotIndex slot = item.address.slot;
    if (item.address.field == ConfigField::kSct)
    {
        // A window of signals that is running ends by the new time.
        const std::uint32_t new_us = (item.value & 0xFFFFU) * kMicrosecondsPerMillisecond;
        x_storage.rows[slot].window_left += new_us - SctUs(x_storage.rows[slot]);
    }
    for (std::uint32_t byte = 0U; byte < place.width; ++byte)
    {
        place.bytes[byte] = static_cast<std::uint8_t>((item.value >> (8U * byte)) & 0xFFU);
    }
    if (item.address.field <= ConfigField::kMapEntry)
    {
        MarksOf(x_storage, slot).resolved &= ~BitOf(slot);
    }
}

ConfigItem Channel::Load(const ConfigAddress& address) const noexcept
{
    const Place place = PlaceOf(address);
    std::uint32_t value = 0U;
    for (std::uint32_t byte = 0U; byte < place.width; ++byte)
    {
        value |= static_cast<std::uint32_t>(place.bytes[byte]) << (8U * byte);
    }
    return ConfigItem{address, value};
}

bool Channel::IsIdentifierInUse(SlotIndex slot) const noexcept
{
    const std::uint32_t normal = NormalIdentifier(x_storage.rows[slot]);
    bool is_in_use = false;
    for (SlotIndex other = 0U; other < x_count; ++other)
    {
        // Ours are `normal` and the next one, so that a modular distance of 0 or 1 is one of them.
        const bool is_other = (other != slot) && (x_storage.direction[other] != kDirectionOff);
        const bool is_normal_ours = (NormalIdentifier(x_storage.rows[other]) - normal) <= 1U;
        const bool is_inverse_ours = (InverseIdentifier(x_storage.rows[other]) - normal) <= 1U;
        if (is_other && (is_normal_ours || is_inverse_ours))
        {
            is_in_use = true;
        }
    }
    return is_in_use;
}

bool Channel::IsTimingWrong(SlotIndex slot) const noexcept
{
    if (x_storage.direction[slot] == kDirectionProducer)
    {
        return SctUs(x_storage.rows[slot]) < x_config->cycle_us;
    }
    const std::uint32_t srvt_ms = ByteAt(x_storage.rows[slot], kSrvtAt);
    return (srvt_ms < 1U) || (srvt_ms >= SctMs(x_storage.rows[slot]));
}

/// All rules before those of the mapping. [SRS-CFG-021 to 025]
ConfigFault Channel::CheckParameters(SlotIndex slot) const noexcept
{
    if (x_storage.direction[slot] > kDirectionConsumer)
    {
        return ConfigFault::kDirection;
    }
    if (ByteAt(x_storage.rows[slot], kTransmissionTypeAt) != kTransmissionTypeAsynchronous)
    {
        return ConfigFault::kTransmissionType;
    }
    const std::uint32_t normal = NormalIdentifier(x_storage.rows[slot]);
    const std::uint32_t offset = normal - kFirstSrdoIdentifier;
    const bool is_normal_right = (offset < kSrdoIdentifierCount) && ((offset & 1U) == 0U);
    if ((!is_normal_right) || (InverseIdentifier(x_storage.rows[slot]) != (normal + 1U)))
    {
        return ConfigFault::kIdentifier;
    }
    if (IsIdentifierInUse(slot))
    {
        return ConfigFault::kIdentifierInUse;
    }
    return IsTimingWrong(slot) ? ConfigFault::kTiming : ConfigFault::kNone;
}

std::uint16_t Channel::Find(std::uint32_t entry) const noexcept
{
    const Column<const MappableObject> objects{x_config->objects};
    const std::uint32_t key = entry >> 8U;
    std::uint16_t low = 0U;
    std::uint16_t high = x_config->object_count;
    while (low < high) // Halves at each turn: at most 11 for 1024 objects.
    {
        const std::uint16_t middle = static_cast<std::uint16_t>(low + ((high - low) / 2));
        if (KeyOf(objects[middle]) < key)
        {
            low = static_cast<std::uint16_t>(middle + 1);
        }
        else
        {
            high = middle;
        }
    }
    return low;
}

/// Whether the object at `place` is the one that the entry names, of its length, and fits the direction.
bool Channel::IsEntryRight(std::uint16_t place, std::uint32_t entry, std::uint8_t direction) const noexcept
{
    if (place >= x_config->object_count)
    {
        return false;
    }
    const MappableObject& object = Column<const MappableObject>{x_config->objects}[place];
    const MapAccess access = (direction == kDirectionProducer) ? MapAccess::kProducer : MapAccess::kConsumer;
    const std::uint32_t named = (KeyOf(object) << 8U) | static_cast<std::uint32_t>(object.length_bits);
    return (named == entry) && (object.access == access);
}

/// SRS-CFG-026 to 028. The table that it writes counts only after a Validate without fault.
ConfigFault Channel::CheckMapping(SlotIndex slot) noexcept
{
    Row& row = x_storage.rows[slot];
    const std::uint32_t count = ByteAt(row, kMapCountAt);
    if ((count == 0U) || (count > kMaxMapEntries) || ((count & 1U) != 0U))
    {
        return ConfigFault::kMapping;
    }
    const std::uint32_t granule = static_cast<std::uint32_t>(x_config->granularity_bits) - 1U;
    std::uint32_t wrong = 0U;
    std::uint32_t all_bits = 0U;
    for (std::uint32_t index = 0U; index < count; ++index)
    {
        const std::uint32_t entry = EntryAt(row, index);
        const std::uint32_t partner = EntryAt(row, index ^ 1U);
        const std::uint16_t place = Find(entry);
        wrong |= ((entry ^ partner) & 0xFFU) | (entry & 0xFFU & granule);
        for (std::uint32_t before = 0U; before < index; ++before)
        {
            wrong |= static_cast<std::uint32_t>(row.table[before] == place); // MISRA D-002
        }
        row.table[index] = place; // MISRA D-002
        all_bits += entry & 0xFFU;
    }
    for (std::uint32_t index = count; index < kMaxMapEntries; ++index)
    {
        row.table[index] = kNoPlace; // MISRA D-002
    }
    if ((wrong != 0U) || (!IsTableRight(slot)))
    {
        return ConfigFault::kMapping;
    }
    // Each normal entry is as long as its inverse entry.
    const std::uint32_t length_bytes = all_bits / 16U;
    if (length_bytes > kMaxPayloadBytes)
    {
        return ConfigFault::kLengthExceeded;
    }
    row.length_bytes = static_cast<std::uint8_t>(length_bytes & 0xFFU);
    row.mask = 0U;
    for (std::uint32_t byte = 0U; byte < length_bytes; ++byte)
    {
        row.mask = (row.mask << 8U) | 0xFFU;
    }
    return ConfigFault::kNone;
}

CheckResult Channel::Validate(SlotIndex slot) noexcept
{
    CheckResult result{ConfigFault::kNone, SignatureOf(slot)};
    const Row& row = x_storage.rows[slot];
    Marks& marks = MarksOf(x_storage, slot);
    const HalfMask bit = BitOf(slot);
    const std::uint8_t direction = x_storage.direction[slot];
    marks.resolved &= ~bit;
    Withdraw(marks.valid, bit);
    if (direction != kDirectionOff)
    {
        result.fault = CheckParameters(slot);
        if (result.fault == ConfigFault::kNone)
        {
            result.fault = CheckMapping(slot);
        }
    }
    if (result.fault != ConfigFault::kNone)
    {
        return result;
    }
    if (static_cast<std::uint32_t>(result.signature) != StoredSignature(row))
    {
        result.fault = ConfigFault::kSignature;
        return result;
    }
    Grant(marks.valid, bit);
    if (direction != kDirectionOff)
    {
        marks.resolved |= bit;
        marks.committed &= ~bit; // Whatever was released is overwritten here, or no longer ours.
    }
    if (direction == kDirectionConsumer)
    {
        WriteInverse(row, SafeDataOf(slot));
    }
    return result;
}

bool Channel::IsTableRight(SlotIndex slot) const noexcept
{
    const Row& row = x_storage.rows[slot];
    const std::uint32_t count = EntryCount(row);
    bool is_right = true;
    for (std::uint32_t index = 0U; index < count; ++index)
    {
        if (!IsEntryRight(row.table[index], EntryAt(row, index), x_storage.direction[slot])) // MISRA D-002
        {
            is_right = false;
        }
    }
    return is_right;
}

CheckResult Channel::Recheck(SlotIndex slot) noexcept
{
    CheckResult result{ConfigFault::kNone, SignatureOf(slot)};
    Marks& marks = MarksOf(x_storage, slot);
    const HalfMask bit = BitOf(slot);
    const bool is_on = x_storage.direction[slot] != kDirectionOff;
    const bool is_right = ((marks.resolved & bit) != 0U) && IsTableRight(slot);
    if (static_cast<std::uint32_t>(result.signature) != StoredSignature(x_storage.rows[slot]))
    {
        result.fault = ConfigFault::kSignature;
    }
    else if (is_on && (!is_right))
    {
        result.fault = ConfigFault::kTable;
    }
    else
    {
        Grant(marks.valid, bit);
        return result;
    }
    Withdraw(marks.valid, bit);
    return result;
}

} // namespace counterpoint::channel_b
