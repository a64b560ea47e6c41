// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_EDIT_SRDO_PLAN_HPP
#define CANOPEN_CIA306_EDIT_SRDO_PLAN_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::cia306
{
/// Index and sub-index of a data element.
struct ObjectPlace
{
    std::uint16_t index{0U};
    std::uint8_t sub{0U};
};

/// One normal object that an SRDO is to map, and its inverse object.
struct PlannedPair
{
    std::string name;                   ///< Of a new object; empty: made from the number of the SRDO.
    std::uint16_t data_type{0U};        ///< Of a new object.
    std::optional<ObjectPlace> normal;  ///< An object of the file; nothing: a new one.
    std::optional<ObjectPlace> inverse; ///< The object of the file that is its inverse; nothing: its InvertedSRAD, or a
                                        ///< new one.
};

/// An SRDO that a file is to get.
struct SrdoPlan
{
    std::uint8_t number{1U}; ///< 1 to 64.
    bool is_producer{false};
    std::uint16_t sct_ms{50U}; ///< The refresh time of a producer.
    std::uint8_t srvt_ms{20U};
    std::uint32_t cob_id{0U};     ///< Of the normal data; that of the inverse data is the next one.
    bool is_automatic{false};     ///< Release policy of a consumer (5F01h): else the restart interlock.
    bool is_late{false};          ///< SRVT detection of a consumer (5F05h): else early.
    std::uint64_t safe_value{0U}; ///< 5F02h: image of the normal data, first mapped bit lowest.
    std::vector<PlannedPair> pairs;
};
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_EDIT_SRDO_PLAN_HPP
