// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_PDO_MAPPING_HPP
#define CANOPEN_CIA301_PDO_MAPPING_HPP

#include "canopen/cia301/dictionary/dictionary.hpp"
#include "canopen/cia301/dictionary/number_hook.hpp"

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
    std::uint8_t bits{0U};  ///< Length in bits of the first `count` fields together.
};

/// Bytes of a PDO.
struct PdoData
{
    std::uint8_t bytes[kPdoBytes];
};

/// One sub-index that a client writes.
struct FieldChange
{
    std::uint8_t sub;
    std::uint32_t value;
    std::uint8_t direction; ///< kInTpdo, kInRpdo.
};

/// @brief A sub-index of a mapping as the bus reads it. O(1)
[[nodiscard]] ObjectValue FetchField(const PdoMap& map, std::uint8_t sub) noexcept;
/// @brief A sub-index that exists gets another value, if the rules of order allow it: fields while nothing is enabled,
/// both while the PDO is not valid. O(log n + count) [SRS_PDO_003]
[[nodiscard]] SdoAbort ChangeMap(PdoMap& map, bool is_valid, const FieldChange& change,
                                 Dictionary& dictionary) noexcept;
/// @brief Writes one sub-index of a mapping, 1 to room, if `direction` (kInTpdo, kInRpdo) allows it; 0 empties it. The
/// mapping is not enabled. O(log n) [SRS_PDO_003, SRS_PDO_005]
[[nodiscard]] SdoAbort WriteField(PdoMap& map, std::uint8_t sub, std::uint32_t mapping, std::uint8_t direction,
                                  Dictionary& dictionary) noexcept;
/// @brief Enables the first `count` fields, or none. O(count) [SRS_PDO_004]
[[nodiscard]] SdoAbort WriteCount(PdoMap& map, std::uint32_t count) noexcept;
/// @brief Takes sub-index 0 to room without a check; ResolveMap checks all of them. [SRS_PDO_007]
void PrepareMap(PdoMap& map, std::uint8_t sub, std::uint32_t value) noexcept;
/// @brief Checks what was prepared; if it does not hold nothing is enabled. O(room log n) [SRS_PDO_007]
[[nodiscard]] SdoAbort ResolveMap(PdoMap& map, std::uint8_t direction, Dictionary& dictionary) noexcept;
/// @brief Empties the mapping: no field is enabled.
void ClearMap(PdoMap& map) noexcept;
/// @brief Length of the frame in bytes.
[[nodiscard]] std::uint8_t LengthOf(const PdoMap& map) noexcept;
/// @brief The present values of the mapped objects as bytes of the frame. A value that cannot be read is sent as 0.
/// O(count) [SRS_PDO_006]
[[nodiscard]] PdoData Pack(const PdoMap& map) noexcept;
/// @brief Whether a mapped value differs that is an event: 1013h goes on by itself and is none. O(count) [SRS_PDO_150]
[[nodiscard]] bool IsChanged(const PdoMap& map, const PdoData& before, const PdoData& now) noexcept;
/// @brief Writes the values to their entries; one that is refused stays as it was. O(count) [SRS_PDO_006]
void Unpack(const PdoMap& map, const PdoData& data) noexcept;

} // namespace counterpoint::cia301

#endif
