// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/channel.hpp"
#include "channel_b/image.hpp"

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

/// Complement of the safe value.
std::uint64_t Channel::SafeDataOf(SlotIndex slot) const noexcept
{
    const Payload& safe_value = Column<const SrdoSetup>{x_config->srdos}[slot].safe_value;
    return ~Join(safe_value.low, safe_value.high);
}

/// What the normal objects hold, or the inverse ones: from the last object to the first one, so that bits enter the
/// word at its low end.
Channel::ObjectData Channel::ReadObjects(const Row& row, std::uint32_t side) const noexcept
{
    const Column<const MappableObject> objects{x_config->objects};
    ObjectData data{0U, 0U};
    for (std::uint32_t rest = EntryCount(row); rest >= 2U; rest -= 2U)
    {
        const std::uint32_t at = row.table[(rest - 2U) + side]; // MISRA D-002
        if (at >= x_config->object_count)
        {
            return ObjectData{0U, 0U}; // A corrupted place: of no length.
        }
        const std::uint32_t length_bits = objects[at].length_bits;
        const Column<const std::uint8_t> place{objects[at].place};
        data.length_bits += length_bits;
        if (length_bits == kFourBytes)
        {
            data.word = (data.word << kFourBytes) | PackFourBytes(&place[0U]);
            continue;
        }
        for (std::uint32_t behind = length_bits / 8U; behind > 0U; --behind)
        {
            data.word = (data.word << 8U) | place[behind - 1U];
        }
    }
    return data;
}

} // namespace counterpoint::channel_b
