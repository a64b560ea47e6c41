// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/channel.hpp"
#include "channel_b/image.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_b
{

namespace
{

constexpr std::uint32_t kPairs = kMaxMapEntries / 2U;
constexpr std::uint32_t kFourBytes = 32U; ///< Length in bits. Such objects are common; all others go byte by byte.

} // namespace

/// Bits leave `rest` at its low end, object by object.
void Channel::WriteInverse(const Row& row, std::uint64_t data) const noexcept
{
    const Column<const MappableObject> objects{x_config->objects};
    std::uint64_t rest = data;
    for (std::uint32_t pair = 0U; pair < kPairs; ++pair)
    {
        const std::uint32_t inverse = row.table[(2U * pair) + 1U]; // MISRA D-002
        if (inverse >= x_config->object_count) // Behind the last entry; a corrupted place leads nowhere either.
        {
            break;
        }
        const std::uint32_t length_bits = objects[inverse].length_bits;
        const Column<std::uint8_t> place{objects[inverse].place};
        if (length_bits == kFourBytes)
        {
            UnpackFourBytes(static_cast<std::uint32_t>(rest & 0xFFFFFFFFU), &place[0U]);
            rest >>= kFourBytes;
            continue;
        }
        for (std::uint32_t at = 0U; at < (length_bits / 8U); ++at)
        {
            place[at] = static_cast<std::uint8_t>(rest & 0xFFU);
            rest >>= 8U;
        }
    }
}

/// From the last object to the first one, so that bits enter the word at its low end.
Channel::ObjectData Channel::ReadObjects(const Row& row) const noexcept
{
    const Column<const MappableObject> objects{x_config->objects};
    const std::uint32_t object_count = x_config->object_count;
    std::uint64_t word = 0U;
    std::uint32_t alike = 0U;
    std::uint32_t rest_bits = row.length_bytes * 8U;
    for (std::uint32_t pair = EntryCount(row) / 2U; pair > 0U; --pair)
    {
        const std::uint32_t normal = row.table[(2U * pair) - 2U];  // MISRA D-002
        const std::uint32_t inverse = row.table[(2U * pair) - 1U]; // MISRA D-002
        if ((normal >= object_count) || (inverse >= object_count))
        {
            return ObjectData{0U, 1U};
        }
        const std::uint32_t length_bits = objects[inverse].length_bits;
        if (objects[normal].length_bits != length_bits)
        {
            return ObjectData{0U, 1U};
        }
        const Column<const std::uint8_t> plain{objects[normal].place};
        const Column<const std::uint8_t> inverted{objects[inverse].place};
        rest_bits -= length_bits;
        if (length_bits == kFourBytes)
        {
            const std::uint32_t four = PackFourBytes(&inverted[0U]);
            alike |= ~(PackFourBytes(&plain[0U]) ^ four);
            word = (word << kFourBytes) | four;
            continue;
        }
        for (std::uint32_t behind = length_bits / 8U; behind > 0U; --behind)
        {
            const std::uint32_t one = inverted[behind - 1U];
            alike |= plain[behind - 1U] ^ one ^ 0xFFU;
            word = (word << 8U) | one;
        }
    }
    return ObjectData{word, alike | rest_bits};
}

} // namespace counterpoint::channel_b
