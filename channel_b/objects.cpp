// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/channel.hpp"
#include "channel_b/image.hpp"

#include <cstdint>

namespace counterpoint::channel_b
{

namespace
{

/// The lowest bits leave `data` for the object; its last byte is filled up with 0. Returns what is left of the data.
[[nodiscard]] [[gnu::noinline]] std::uint64_t PutBits(std::uint64_t data, std::uint32_t bits,
                                                      std::uint8_t* bytes) noexcept
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

} // namespace

/// Bits leave `rest` at its low end, object by object. Where an entry leads to no object (a dummy, or a corrupted
/// place) they are left out.
void Channel::WriteInverse(SlotIndex slot, std::uint64_t data) const noexcept
{
    const Column<const MappableObject> objects{x_config->objects};
    const Mapping mapping = MappingOf(slot);
    const std::uint32_t count = mapping.count;
    std::uint64_t rest = data;
    for (std::uint32_t index = 1U; index < count; index += 2U)
    {
        const std::uint16_t at = // A static mapping has no table: its entries are looked up each time.
            IsStatic(mapping) ? Find(mapping.entries[index]) : x_storage.table[mapping.first + index];
        if (at >= x_config->object_count)
        {
            rest >>= mapping.entries[index] & 63U;
            continue;
        }
        const MappableObject& object = objects[at];
        if (object.length_bits != kFourBytes)
        {
            rest = PutBits(rest, object.length_bits, object.place);
            continue;
        }
        UnpackFourBytes(static_cast<std::uint32_t>(rest & 0xFFFFFFFFU), object.place);
        rest >>= kFourBytes;
    }
}

/// Complement of the safe value.
std::uint64_t Channel::SafeDataOf(SlotIndex slot) const noexcept
{
    const Payload& safe_value = Column<const SrdoSetup>{x_config->srdos}[slot].safe_value;
    return ~Join(safe_value.low, safe_value.high);
}

} // namespace counterpoint::channel_b
