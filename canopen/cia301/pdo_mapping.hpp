// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_PDO_MAPPING_HPP
#define CANOPEN_CIA301_PDO_MAPPING_HPP

#include "canopen/cia301/dictionary.hpp"

namespace counterpoint::cia301
{

constexpr std::uint32_t kPdoBits = 64U;
constexpr std::uint8_t kPdoBytes = 8U;
constexpr std::uint8_t kMaxPdoFields = 64U; ///< Sub-indices of a mapping at a granularity of one bit.

/// One sub-index of a mapping: index, sub-index and bits as they are in 1600h.. and 1A00h.., and where that leads.
/// Zero-filled at first.
struct PdoField
{
    std::uint32_t mapping;
    const Entry* entry; ///< Null: a dummy, or nothing.
};

/// Mapping of one PDO in room of its owner.
struct PdoMap
{
    PdoField* fields;
    std::uint8_t room;      ///< 0 to kMaxPdoFields.
    std::uint8_t count{0U}; ///< Sub-index 0.
    std::uint8_t bits{0U};  ///< Of the first `count` fields.
};

/// Bytes of a PDO.
struct PdoData
{
    std::uint8_t bytes[kPdoBytes];
};

/// @brief Writes one sub-index of a mapping, 1 to room, if `direction` (kInTpdo, kInRpdo) allows it; 0 empties it. The
/// mapping is not enabled. O(log n) [SRS-PDO-003, SRS-PDO-005]
[[nodiscard]] SdoAbort WriteField(PdoMap& map, std::uint8_t sub, std::uint32_t mapping, std::uint8_t direction,
                                  const Dictionary& dictionary) noexcept;
/// @brief Enables the first `count` fields, or none. O(count log n) [SRS-PDO-004]
[[nodiscard]] SdoAbort WriteCount(PdoMap& map, std::uint32_t count, std::uint8_t direction,
                                  const Dictionary& dictionary) noexcept;
/// @brief Length of the frame.
[[nodiscard]] std::uint8_t LengthOf(const PdoMap& map) noexcept;
/// @brief The mapped values of now. A value that cannot be read is sent as 0. O(count) [SRS-PDO-006]
[[nodiscard]] PdoData Pack(const PdoMap& map) noexcept;
/// @brief Writes the values to their entries; one that is refused stays as it was. O(count) [SRS-PDO-006]
void Unpack(const PdoMap& map, const std::uint8_t* bytes) noexcept;

} // namespace counterpoint::cia301

#endif
