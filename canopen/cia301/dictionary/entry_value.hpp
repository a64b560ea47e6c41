// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_DICTIONARY_ENTRY_VALUE_HPP
#define CANOPEN_CIA301_DICTIONARY_ENTRY_VALUE_HPP

#include "canopen/cia301/dictionary/entry.hpp"

namespace counterpoint::cia301
{

/// @brief Whether values of this type are two's complements.
[[nodiscard]] bool IsSigned(DataType type) noexcept;
/// @brief Whether values of this type are numbers, so that limits can apply.
[[nodiscard]] bool IsNumber(DataType type) noexcept;
/// @brief A value of an entry as a number, sign-extended for signed types. `value` has 1 to 8 bytes.
[[nodiscard]] std::uint64_t NumberOf(DataType type, const Bytes& value) noexcept;
/// @brief Refuses a length that the entry does not take. [SRS_OBD_005]
[[nodiscard]] SdoAbort CheckLength(const Entry& entry, std::uint32_t size_bytes) noexcept;
/// @brief Refuses a value beyond the entry's limits; its length was checked. [SRS_OBD_006]
[[nodiscard]] SdoAbort CheckLimits(const Entry& entry, const Bytes& value) noexcept;
/// @brief The value from hook or place. [SRS_OBD_007, SRS_OBD_009]
[[nodiscard]] Reading ReadEntry(const Entry& entry, const Room& room) noexcept;
/// @brief Checks, asks the hook, stores. [SRS_OBD_005, SRS_OBD_006, SRS_OBD_007, SRS_OBD_015]
[[nodiscard]] SdoAbort WriteEntry(const Entry& entry, const Bytes& value, Attempt attempt) noexcept;
/// @brief Whether a service has this object: the device's file may have more sub-indices than the service.
[[nodiscard]] bool HasObject(ReadHook& hook, const ObjectAddress& address) noexcept;

} // namespace counterpoint::cia301

#endif
