// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/file/data_type.hpp"

#include <array>
#include <cstddef>

namespace counterpoint::cia306
{
namespace
{
constexpr std::size_t kTypeCount = 0x1CU;
constexpr std::uint16_t kFirstBits = 0x0030U;

constexpr std::array<DataType, kTypeCount> kTypes{{
    {},
    {"BOOLEAN", DataKind::kBoolean, 1U},
    {"INTEGER8", DataKind::kSigned, 8U},
    {"INTEGER16", DataKind::kSigned, 16U},
    {"INTEGER32", DataKind::kSigned, 32U},
    {"UNSIGNED8", DataKind::kUnsigned, 8U},
    {"UNSIGNED16", DataKind::kUnsigned, 16U},
    {"UNSIGNED32", DataKind::kUnsigned, 32U},
    {"REAL32", DataKind::kReal, 32U},
    {"VISIBLE_STRING", DataKind::kText, 0U},
    {"OCTET_STRING", DataKind::kText, 0U},
    {"UNICODE_STRING", DataKind::kText, 0U},
    {"TIME_OF_DAY", DataKind::kTime, 48U},
    {"TIME_DIFFERENCE", DataKind::kTime, 48U},
    {},
    {"DOMAIN", DataKind::kText, 0U},
    {"INTEGER24", DataKind::kSigned, 24U},
    {"REAL64", DataKind::kReal, 64U},
    {"INTEGER40", DataKind::kSigned, 40U},
    {"INTEGER48", DataKind::kSigned, 48U},
    {"INTEGER56", DataKind::kSigned, 56U},
    {"INTEGER64", DataKind::kSigned, 64U},
    {"UNSIGNED24", DataKind::kUnsigned, 24U},
    {},
    {"UNSIGNED40", DataKind::kUnsigned, 40U},
    {"UNSIGNED48", DataKind::kUnsigned, 48U},
    {"UNSIGNED56", DataKind::kUnsigned, 56U},
    {"UNSIGNED64", DataKind::kUnsigned, 64U},
}};

constexpr std::array<DataType, 8U> kBits{{
    {"BIT1", DataKind::kUnsigned, 1U},
    {"BIT2", DataKind::kUnsigned, 2U},
    {"BIT3", DataKind::kUnsigned, 3U},
    {"BIT4", DataKind::kUnsigned, 4U},
    {"BIT5", DataKind::kUnsigned, 5U},
    {"BIT6", DataKind::kUnsigned, 6U},
    {"BIT7", DataKind::kUnsigned, 7U},
    {"BIT8", DataKind::kUnsigned, 8U},
}};
} // namespace

DataType DataTypeOf(const std::uint16_t code) noexcept
{
    const bool is_bits = code >= kFirstBits && code < kFirstBits + kBits.size();
    if (is_bits)
    {
        return kBits[code - kFirstBits];
    }
    return code < kTypes.size() ? kTypes[code] : DataType{};
}
} // namespace counterpoint::cia306
