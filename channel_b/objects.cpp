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
constexpr std::uint8_t kFourBytes = 32U; ///< Length in bits.

/// The value of an object of 1 to 8 bytes. Objects of four bytes are common; all others go byte by byte.
[[nodiscard]] inline std::uint64_t ReadObject(const std::uint8_t* bytes, std::uint32_t length_bits) noexcept
{
    if (length_bits == kFourBytes)
    {
        return PackFourBytes(bytes);
    }
    const Column<const std::uint8_t> place{bytes};
    std::uint64_t word = 0U;
    for (std::uint32_t behind = length_bits / 8U; behind > 0U; --behind)
    {
        word = (word << 8U) | place[behind - 1U];
    }
    return word;
}

inline void WriteObject(std::uint8_t* bytes, std::uint32_t length_bits, std::uint64_t data) noexcept
{
    const Column<std::uint8_t> place{bytes};
    std::uint64_t rest = data;
    if (length_bits == kFourBytes)
    {
        place[0U] = static_cast<std::uint8_t>(data & 0xFFU);
        place[1U] = static_cast<std::uint8_t>((data >> 8U) & 0xFFU);
        place[2U] = static_cast<std::uint8_t>((data >> 16U) & 0xFFU);
        place[3U] = static_cast<std::uint8_t>((data >> 24U) & 0xFFU);
        return;
    }
    for (std::uint32_t at = 0U; at < (length_bits / 8U); ++at)
    {
        place[at] = static_cast<std::uint8_t>(rest & 0xFFU);
        rest >>= 8U;
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
        const std::uint32_t length_bits = object.length_bits;
        WriteObject(object.place, length_bits, data >> (shift & 63U));
        shift += length_bits;
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
        const MappableObject& plain = objects[normal];
        const MappableObject& inverted = objects[inverse];
        const std::uint32_t length_bits = inverted.length_bits;
        data.normal |= ReadObject(plain.place, plain.length_bits) << (shift & 63U);
        data.inverse |= ReadObject(inverted.place, length_bits) << (shift & 63U);
        shift += length_bits;
    }
    return data;
}

} // namespace counterpoint::channel_b
