// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_DEVICE_OBJECTS_COB_IDS_HPP
#define RUNTIME_DEVICE_OBJECTS_COB_IDS_HPP

#include "canopen/cia301/dictionary/entry.hpp"
#include "canopen/cia306/text/input_error.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// An object that has an identifier which others have, too, and what is wrong with that.
struct SharedIdentifier
{
    std::size_t entry; ///< Place in the table.
    cia306::Problem problem;
};

/// Identifiers that a device has without an object of its file.
struct OwnIdentifiers
{
    std::uint32_t emergency;
    std::uint8_t node_id;
};

/// @brief Whether this object has a COB-ID, as far as its index goes: those of services, with PDOs.
[[nodiscard]] bool IsCobId(std::uint16_t index, std::uint8_t sub) noexcept;

/// @brief The objects of services, PDOs left aside, that have the identifier of an earlier one now, with all of these.
/// A PDO with such an identifier is off. [SRS_NODE_050, SRS_NODE_153]
[[nodiscard]] std::vector<SharedIdentifier> SharedIdentifiers(const cia301::EntryTable& table,
                                                              const OwnIdentifiers& own);

/// @brief The object that has this identifier now, but not the one of the PDO `pdo`; RPDOs may share theirs.
[[nodiscard]] std::string OwnerOf(const cia301::EntryTable& table, const cia301::Entry& pdo, std::uint32_t identifier);

/// @brief Which identifier is expected where CiA 301 gives none like that of `cob_id` to an object; empty: it does.
[[nodiscard]] std::string ExpectedIdentifier(std::uint64_t cob_id);
} // namespace counterpoint::runtime

#endif // RUNTIME_DEVICE_OBJECTS_COB_IDS_HPP
