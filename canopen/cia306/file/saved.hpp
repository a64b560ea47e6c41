// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_FILE_SAVED_HPP
#define CANOPEN_CIA306_FILE_SAVED_HPP

#include "canopen/cia306/file/device.hpp"

#include <cstdint>

namespace counterpoint::cia306
{
/// @brief Whether this is a command to save or to restore, 1010h or 1011h: a client may write it in PRE-OPERATIONAL
/// alone, whatever the file says. [SRS_STO_008]
[[nodiscard]] inline bool IsStoreCommand(const std::uint16_t index) noexcept
{
    return index == 0x1010U || index == 0x1011U;
}

/// Whether a save (1010h) of a device of this file keeps the value: somebody can write it and read it back, and it is
/// no list of errors (1003h), no command (1010h, 1011h) and no safety object: those of 1300h to 13FFh the kernel keeps,
/// 5F00h to 5F05h are parameters of the program.
/// [SRS_NODE_038, SRS_GEN_330]
[[nodiscard]] inline bool IsSaved(const Entry& entry) noexcept
{
    constexpr std::uint16_t error_field = 0x1003U;
    const bool is_own = entry.index == error_field || IsStoreCommand(entry.index);
    return !entry.IsFixed() && entry.access != Access::kWriteOnly && !is_own && !entry.is_safety;
}
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_FILE_SAVED_HPP
