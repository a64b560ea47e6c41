// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_TEXT_NUMBER_HPP
#define CANOPEN_CIA306_TEXT_NUMBER_HPP

#include <cstdint>
#include <optional>
#include <string_view>

namespace counterpoint::cia306
{
/// A text that is digits of this base and nothing else, letters upper or lower case. Nothing when it is none, or has
/// more than 64 bits.
[[nodiscard]] std::optional<std::uint64_t> ParseDigits(std::string_view text, int base);

/// A number as CiA 306 writes it: 0x hexadecimal, leading 0 octal, decimal otherwise; one sign in front.
struct Number
{
    bool is_negative{false}; ///< Below 0: -0 is not.
    bool is_hexadecimal{false};
    bool has_suffix{
        false}; ///< One of C stands behind it (U, L, LL and their combinations), which CiA 306 does not know.
    std::uint64_t magnitude{0U};
};

/// Reads a number. Nothing when the text is none, or when it has more than 64 bits. [SRS_EDS_006]
[[nodiscard]] std::optional<Number> ParseNumber(std::string_view text);

/// As ParseNumber, not negative, without a suffix and at most `max`.
[[nodiscard]] std::optional<std::uint64_t> ParseUnsigned(std::string_view text, std::uint64_t max);

/// As ParseUnsigned, of what a person types: decimal, or hexadecimal after 0x. A leading zero is refused, since it is
/// octal in files and nobody who types it means that. [SRS_MGR_134, SRS_NODE_003]
[[nodiscard]] std::optional<std::uint64_t> ParseTyped(std::string_view text, std::uint64_t max);

/// A number, or $NODEID and a number in either order. [SRS_EDS_007]
struct Formula
{
    bool has_node_id{false};
    Number number;
};

/// Reads a formula; nothing when the text is none.
[[nodiscard]] std::optional<Formula> ParseFormula(std::string_view text);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_TEXT_NUMBER_HPP
