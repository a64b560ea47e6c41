// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_DICTIONARY_OBJECT_KINDS_HPP
#define CANOPEN_CIA301_DICTIONARY_OBJECT_KINDS_HPP

#include "safety_core/kernel/object_access.hpp"

#include <cstdint>

// Objects of services that a dictionary treats in another way than the others, after CiA 301.
namespace counterpoint::cia301
{

/// @brief Whether this is 1010h or 1011h.
[[nodiscard]] constexpr bool IsStoreObject(const std::uint16_t index) noexcept
{
    return (index == 0x1010U) || (index == 0x1011U);
}

/// @brief Whether a device has values of its own there, whatever its file says: its errors, commands, the default SDO.
[[nodiscard]] constexpr bool IsOwnObject(const std::uint16_t index) noexcept
{
    return (index == 0x1001U) || (index == 0x1003U) || (index == 0x1200U) || IsStoreObject(index);
}

/// @brief Whether this is 1600h to 17FFh or 1A00h to 1BFFh.
[[nodiscard]] constexpr bool IsPdoMapping(const std::uint16_t index) noexcept
{
    return ((index >= 0x1600U) && (index <= 0x17FFU)) || ((index >= 0x1A00U) && (index <= 0x1BFFU));
}

/// @brief Whether this is the number of sub-indices of a service's list or record, which the device's file tells and no
/// service: 1010h, 1011h, 1016h, 1028h, 1029h, 1200h to 12FFh, 1400h to 15FFh and 1800h to 19FFh. That of 1003h counts
/// errors, that of a mapping what is mapped.
[[nodiscard]] constexpr bool IsSubCount(const ObjectAddress& object) noexcept
{
    const std::uint16_t index = object.index;
    const bool is_list = (index == 0x1016U) || (index == 0x1028U) || (index == 0x1029U) || IsStoreObject(index);
    const bool is_sdo = (index >= 0x1200U) && (index <= 0x12FFU);
    const bool is_pdo = (index >= 0x1400U) && (index <= 0x19FFU) && !IsPdoMapping(index);
    return (object.sub == 0U) && (is_list || is_sdo || is_pdo);
}

} // namespace counterpoint::cia301

#endif
