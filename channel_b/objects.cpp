// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/channel.hpp"
#include "channel_b/image.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_b
{

namespace
{

constexpr std::size_t kPairs = kMaxMapEntries / 2U;

/// The value of an object of 1 to 8 bytes, put together from its parts of 4, 2 and 1 bytes.
[[nodiscard]] std::uint64_t ReadObject(const MappableObject& object) noexcept
{
    const std::uint32_t length = static_cast<std::uint32_t>(object.length_bits) / 8U;
    const Column<const std::uint8_t> place{object.place};
    if ((length & 8U) != 0U)
    {
        return PackBytes(place.first);
    }
    std::uint64_t word = 0U;
    std::uint32_t at = 0U;
    if ((length & 4U) != 0U)
    {
        word = PackFourBytes(place.first);
        at = 4U;
    }
    if ((length & 2U) != 0U)
    {
        const std::uint32_t two = static_cast<std::uint32_t>(place[at]) | (static_cast<std::uint32_t>(place[at + 1U]) << 8U);
        word |= static_cast<std::uint64_t>(two) << (8U * at);
        at += 2U;
    }
    if ((length & 1U) != 0U)
    {
        word |= static_cast<std::uint64_t>(place[at]) << (8U * at);
    }
    return word;
}

void PutBytes(const Column<std::uint8_t>& place, std::uint64_t data, std::uint32_t from, std::uint32_t to) noexcept
{
    for (std::uint32_t at = from; at < to; ++at)
    {
        place[at] = static_cast<std::uint8_t>((data >> ((8U * at) & 63U)) & 0xFFU);
    }
}

void PutFourBytes(const Column<std::uint8_t>& place, std::uint32_t data) noexcept
{
    place[0U] = static_cast<std::uint8_t>(data & 0xFFU);
    place[1U] = static_cast<std::uint8_t>((data >> 8U) & 0xFFU);
    place[2U] = static_cast<std::uint8_t>((data >> 16U) & 0xFFU);
    place[3U] = static_cast<std::uint8_t>((data >> 24U) & 0xFFU);
}

/// Objects of four bytes are the common ones; all others go byte by byte.
void WriteObject(const MappableObject& object, std::uint64_t data) noexcept
{
    const std::uint32_t length = static_cast<std::uint32_t>(object.length_bits) / 8U;
    const Column<std::uint8_t> place{object.place};
    if (length == 4U)
    {
        PutFourBytes(place, static_cast<std::uint32_t>(data & 0xFFFFFFFFU));
    }
    else
    {
        PutBytes(place, data, 0U, length);
    }
}

} // namespace

void Channel::WriteInverse(SlotIndex slot, std::uint64_t data) const noexcept
{
    const Column<const MappableObject> objects{x_config->objects};
    const Column<std::uint16_t> table{&x_storage.table[static_cast<std::size_t>(slot) * kMaxMapEntries]};
    const std::uint16_t object_count = x_config->object_count;
    std::uint32_t shift = 0U;
    for (std::size_t pair = 0U; pair < kPairs; ++pair)
    {
        const std::uint16_t place = table[(2U * pair) + 1U];
        if (place >= object_count) // Behind the last entry; a corrupted place leads nowhere either.
        {
            break;
        }
        const MappableObject& object = objects[place];
        WriteObject(object, data >> (shift & 63U));
        shift += object.length_bits;
    }
}

Channel::ObjectData Channel::ReadObjects(SlotIndex slot) const noexcept
{
    const Column<const MappableObject> objects{x_config->objects};
    const Column<std::uint16_t> table{&x_storage.table[static_cast<std::size_t>(slot) * kMaxMapEntries]};
    const std::uint16_t object_count = x_config->object_count;
    ObjectData data{0U, 0U};
    std::uint32_t shift = 0U;
    for (std::size_t pair = 0U; pair < kPairs; ++pair)
    {
        const std::uint16_t normal = table[2U * pair];
        const std::uint16_t inverse = table[(2U * pair) + 1U];
        if ((normal >= object_count) || (inverse >= object_count))
        {
            break;
        }
        data.normal |= ReadObject(objects[normal]) << (shift & 63U);
        data.inverse |= ReadObject(objects[inverse]) << (shift & 63U);
        shift += objects[inverse].length_bits;
    }
    return data;
}

} // namespace counterpoint::channel_b
