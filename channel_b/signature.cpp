// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/channel.hpp"
#include "channel_b/image.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_b
{

namespace
{

/// CRC-16 with polynomial 1021h over one more byte. With x the byte that leaves the register XOR the data, the
/// polynomial x^16 + x^12 + x^5 + 1 folds back into x XOR (x >> 4) at the places 0, 5 and 12: no table and no loop over
/// bits. Bits above 15 are rubbish that the caller cuts off at the end.
[[nodiscard]] inline std::uint32_t Fold(std::uint32_t crc, std::uint32_t byte) noexcept
{
    const std::uint32_t leaving = ((crc >> 8U) & 0xFFU) ^ byte;
    const std::uint32_t mixed = leaving ^ (leaving >> 4U);
    return (crc << 8U) ^ (mixed << 12U) ^ (mixed << 5U) ^ mixed;
}

[[nodiscard]] std::uint32_t FoldAll(std::uint32_t crc, const std::uint8_t* bytes, std::size_t count) noexcept
{
    const Column<const std::uint8_t> byte{bytes};
    std::uint32_t folded = crc;
    for (std::size_t index = 0U; index < count; ++index)
    {
        folded = Fold(folded, byte[index]);
    }
    return folded;
}

} // namespace

std::uint16_t Channel::SignatureOf(SlotIndex slot) const noexcept
{
    const Row& row = x_storage.rows[slot];
    const std::uint32_t count = EntryCount(row);
    std::uint32_t crc = Fold(0U, x_storage.direction[slot]);
    crc = FoldAll(crc, &row.image[kSctAt], kMapCountAt);
    crc = Fold(crc, count);
    crc = FoldAll(crc, &row.image[kEntriesAt], std::size_t{count} * kEntryBytes);
    return static_cast<std::uint16_t>(crc & 0xFFFFU);
}

} // namespace counterpoint::channel_b
