// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_EDIT_MAPPING_TEXT_HPP
#define CANOPEN_CIA306_EDIT_MAPPING_TEXT_HPP

#include "canopen/cia306/edit/srdo_plan.hpp"
#include "canopen/cia306/text/input_error.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace counterpoint::cia306
{
/// What a text such as "2x8,Speed=i16@0x109" says of an SRDO, or what is wrong with it.
struct MappingText
{
    std::vector<PlannedPair> pairs;
    std::optional<std::uint32_t> cob_id; ///< Of the normal data; nothing: the text gives none.
    Problem problem;                     ///< Where `wrong` is empty the text is right.
};

/// Reads ELEMENT[,ELEMENT...][@COB-ID]. An element is [NAME=][COUNTx]LENGTH for new objects of 8, 16, 24, 32, 40, 48,
/// 56 or 64 bits, unsigned or after an i signed, or INDEX:SUB[/INDEX:SUB] for an object of the file and its inverse
/// object. COB-ID is 101h to 17Fh and odd, or nodeN: 0FFh + 2 * N, what node N produces by default. [SRS_NEW_003,
/// SRS_NEW_004]
[[nodiscard]] MappingText ParseMapping(std::string_view text);

/// 0FFh + 2 * node-ID, which the pre-defined connection set gives node-ID 1 to 64; nothing for others.
[[nodiscard]] std::optional<std::uint32_t> PreDefinedCobId(std::uint64_t node_id) noexcept;

/// The COB-ID that the normal data of an SRDO have where none is given: the pre-defined one, for SRDO 1 alone, a
/// producer with node-ID 1 to 32, a consumer with 33 to 64. [SRS_NEW_004]
[[nodiscard]] std::optional<std::uint32_t> DefaultCobId(std::uint8_t number, bool is_producer,
                                                        std::uint8_t node_id) noexcept;

/// A COB-ID of normal data as a person gives it, as above.
[[nodiscard]] std::optional<std::uint32_t> ParseCobId(std::string_view text);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_EDIT_MAPPING_TEXT_HPP
