// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/channel.hpp"
#include "channel_b/image.hpp"

#include <cstdint>

namespace counterpoint::channel_b
{

namespace
{

constexpr std::uint32_t kFourBytes = 32U; ///< Length in bits of common objects.

/// The lowest bits leave `data` for the object; its last byte is filled up with 0. Returns what is left of the data.
[[nodiscard]] std::uint64_t PutBits(std::uint64_t data, std::uint32_t bits, std::uint8_t* bytes) noexcept
{
    const Column<std::uint8_t> place{bytes};
    std::uint64_t rest = data;
    std::uint32_t left = bits;
    for (std::uint32_t at = 0U; left > 0U; ++at)
    {
        const std::uint32_t step = (left < 8U) ? left : 8U;
        place[at] = static_cast<std::uint8_t>(rest & ((1U << step) - 1U));
        rest >>= step;
        left -= step;
    }
    return rest;
}

/// The bits of the object enter `data` at its low end, the last byte first; it has the bits above the last whole byte.
[[nodiscard]] std::uint64_t TakeBits(std::uint64_t data, std::uint32_t bits, const std::uint8_t* bytes) noexcept
{
    const Column<const std::uint8_t> place{bytes};
    std::uint64_t taken = data;
    std::uint32_t left = bits;
    while (left > 0U)
    {
        const std::uint32_t step = ((left - 1U) & 7U) + 1U;
        left -= step;
        taken = (taken << step) | (place[left / 8U] & ((1U << step) - 1U));
    }
    return taken;
}

} // namespace

/// Bits leave `rest` at its low end, object by object. Where an entry leads to no object (a dummy, or a corrupted
/// place) they are left out.
void Channel::WriteFrom(SlotIndex slot, std::uint64_t data, std::uint32_t from) const noexcept
{
    const Column<const MappableObject> objects{x_config->objects};
    const Mapping mapping = MappingOf(slot);
    const std::uint32_t count = mapping.count;
    std::uint64_t rest = data;
    for (std::uint32_t index = from; index < count; index += 2U)
    {
        const std::uint16_t at = // A static mapping has no table: its entries are looked up each time.
            IsStatic(mapping) ? Find(mapping.entries[index]) : x_storage.table[mapping.first + index];
        if (at >= x_config->object_count)
        {
            rest >>= mapping.entries[index] & 63U;
            continue;
        }
        rest = PutBits(rest, objects[at].length_bits, objects[at].place);
    }
}

/// As long as a stored mapping leads to objects of four bytes there is nothing to call.
void Channel::WriteInverse(SlotIndex slot, std::uint64_t data) const noexcept
{
    const Column<const MappableObject> objects{x_config->objects};
    const std::uint32_t object_count = x_config->object_count;
    const std::uint32_t count = StoredCount(x_storage.rows[slot], x_map_entries);
    const Column<const std::uint16_t> table{&x_storage.table[FirstEntryOf(x_storage, slot)]};
    std::uint64_t rest = data;
    for (std::uint32_t index = 1U; index < count; index += 2U)
    {
        const std::uint32_t at = table[index];
        if ((at >= object_count) || (objects[at].length_bits != kFourBytes))
        {
            WriteFrom(slot, rest, index);
            return;
        }
        UnpackFourBytes(static_cast<std::uint32_t>(rest & 0xFFFFFFFFU), objects[at].place);
        rest >>= kFourBytes;
    }
    if (count == 0U)
    {
        WriteFrom(slot, data, 1U); // A static mapping has a count of its own.
    }
}

/// Complement of the safe value.
std::uint64_t Channel::SafeDataOf(SlotIndex slot) const noexcept
{
    const Payload& safe_value = Column<const SrdoSetup>{x_config->srdos}[slot].safe_value;
    return ~Join(safe_value.low, safe_value.high);
}

/// The way for all objects, from entry `from` (or the last one) on.
std::uint64_t Channel::ReadFrom(SlotIndex slot, std::uint64_t data, std::uint32_t from) const noexcept
{
    const Column<const MappableObject> objects{x_config->objects};
    const Mapping mapping = MappingOf(slot);
    std::uint64_t word = data;
    for (std::uint32_t rest = (from < mapping.count) ? from : mapping.count; rest > 1U; rest -= 2U)
    {
        const std::uint16_t at =
            IsStatic(mapping) ? Find(mapping.entries[rest - 1U]) : x_storage.table[mapping.first + rest - 1U];
        if (at >= x_config->object_count)
        {
            continue; // A corrupted place: other data than the other channel's.
        }
        word = TakeBits(word, objects[at].length_bits, objects[at].place);
    }
    return word;
}

/// What the inverse objects hold: from the last object to the first one, so that bits enter the word at its low end. As
/// long as a stored mapping leads to objects of four bytes there is nothing to call.
std::uint64_t Channel::ReadInverse(SlotIndex slot) const noexcept
{
    const Column<const MappableObject> objects{x_config->objects};
    const std::uint32_t object_count = x_config->object_count;
    const std::uint32_t count = StoredCount(x_storage.rows[slot], x_map_entries);
    const Column<const std::uint16_t> table{&x_storage.table[FirstEntryOf(x_storage, slot)]};
    std::uint64_t word = 0U;
    for (std::uint32_t rest = count; rest > 1U; rest -= 2U)
    {
        const std::uint32_t at = table[rest - 1U];
        if ((at >= object_count) || (objects[at].length_bits != kFourBytes))
        {
            return ReadFrom(slot, word, rest);
        }
        word = (word << kFourBytes) | PackFourBytes(objects[at].place);
    }
    return (count == 0U) ? ReadFrom(slot, word, kLargestMapping) : word; // A static mapping has a count of its own.
}

} // namespace counterpoint::channel_b
