// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/channel.hpp"
#include "channel_b/image.hpp"

#include <cstdint>

namespace counterpoint::channel_b
{

namespace
{

/// One object of any length, up to eight bits at a time; its last byte is filled up with 0.
[[nodiscard]] std::uint64_t ExchangeBits(const MappableObject& object, std::uint64_t data, bool is_read) noexcept
{
    const Column<std::uint8_t> place{object.place};
    std::uint64_t word = data;
    std::uint32_t left = object.length_bits;
    for (std::uint32_t at = 0U; left > 0U; ++at)
    {
        const std::uint32_t step = (left < 8U) ? left : 8U;
        const std::uint32_t bits = (1U << step) - 1U;
        if (is_read)
        {
            word |= place[at] & bits;
        }
        else
        {
            place[at] = static_cast<std::uint8_t>(word & bits);
        }
        word = Turned(word, step);
        left -= step;
    }
    return word;
}

} // namespace

/// The way for all objects, from one entry on: the word turns object by object, so that those bits are at its low end
/// that are written to an object, or that enter it where they are read (they are 0 then). A dummy, or a corrupted
/// place, leaves its bits out.
std::uint64_t Channel::ExchangeFrom(SlotIndex slot, std::uint32_t from, std::uint64_t data, Way way) const noexcept
{
    const Mapping mapping = MappingOf(slot);
    std::uint64_t word = data;
    for (std::uint32_t index = from; index < mapping.count; index += 2U)
    {
        const std::uint32_t entry = mapping.entries[index];
        const std::uint32_t at = IsStatic(mapping) ? Find(entry) : mapping.table[index];
        const bool is_object = at < x_object_count;
        word = is_object ? ExchangeBits(x_objects[at], word, way == Way::kRead) : Turned(word, entry);
    }
    return Turned(word, 64U - x_storage.rows[slot].length_bits);
}

/// For two objects of four bytes, which fill a frame, there is nothing to call.
void Channel::WriteInverse(SlotIndex slot, std::uint64_t data) const noexcept
{
    const Row& row = x_storage.rows[slot];
    const std::size_t low = row.words & 0xFFFFU;
    const std::size_t high = row.words >> 16U;
    if (((low < high) ? high : low) < x_object_count)
    {
        const MappableObject& first = x_objects[low];
        const MappableObject& second = x_objects[high];
        if ((first.length_bits == kFourBytes) && (second.length_bits == kFourBytes))
        {
            UnpackFourBytes(PartOf(data, 0U), first.place);
            UnpackFourBytes(PartOf(data, 1U), second.place);
            return;
        }
    }
    static_cast<void>(ExchangeFrom(slot, 1U, data, Way::kWritten));
}

/// Complement of the safe value.
void Channel::WriteSafe(SlotIndex slot) const noexcept
{
    const Payload& safe_value = Column<const SrdoSetup>{x_config->srdos}[slot].safe_value;
    WriteInverse(slot, ~Join(safe_value.low, safe_value.high));
}

} // namespace counterpoint::channel_b
