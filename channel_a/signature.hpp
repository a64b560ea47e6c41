// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_SIGNATURE_HPP
#define CHANNEL_A_SIGNATURE_HPP

#include "channel_a/storage.hpp"

#include <cstdint>

namespace counterpoint::channel_a
{

/// @brief Map count as the loops over a mapping use it: at most 16, whatever is stored.
[[nodiscard]] inline std::uint32_t MapCount(const Record& record) noexcept
{
    const std::uint32_t count = record.values[kMapCountPlace];
    return (count < kMaxMapEntries) ? count : kMaxMapEntries;
}

/// @brief CRC-16 over the values of one SRDO, each fed to the table as it is read. O(entries) [SRS-CFG-010]
[[nodiscard]] std::uint32_t Signature(const Record& record) noexcept;

} // namespace counterpoint::channel_a

#endif
