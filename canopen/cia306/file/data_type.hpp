// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_FILE_DATA_TYPE_HPP
#define CANOPEN_CIA306_FILE_DATA_TYPE_HPP

#include <cstdint>

namespace counterpoint::cia306
{
/// What sort of value a data type has.
enum class DataKind : std::uint8_t
{
    kUnknown = 0U,
    kBoolean = 1U,
    kSigned = 2U,
    kUnsigned = 3U,
    kReal = 4U,
    kTime = 5U,      ///< 48 bits, given as a number.
    kText = 6U,      ///< Strings and DOMAIN: no fixed length, never mapped.
    kStructure = 7U, ///< Has sub-indices, each with a type of its own.
};

/// What a data type stands for.
struct DataType
{
    const char* name{"an unknown data type"};
    DataKind kind{DataKind::kUnknown};
    std::uint8_t bits{0U}; ///< 0: no fixed length.
};

constexpr std::uint16_t kUnsigned8 = 0x0005U;
constexpr std::uint16_t kUnsigned16 = 0x0006U;
constexpr std::uint16_t kUnsigned32 = 0x0007U;
constexpr std::uint16_t kDomainType = 0x000FU;
constexpr std::uint16_t kUnsigned64 = 0x001BU;

/// The data type with this code: its index in the object dictionary (CiA 301 table 44), and 0030h to 0037h for BIT1 to
/// BIT8, which files of devices with CoE have.
[[nodiscard]] DataType DataTypeOf(std::uint16_t code) noexcept;
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_FILE_DATA_TYPE_HPP
