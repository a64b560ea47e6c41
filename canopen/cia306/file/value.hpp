// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_FILE_VALUE_HPP
#define CANOPEN_CIA306_FILE_VALUE_HPP

#include "canopen/cia306/file/data_type.hpp"
#include "canopen/cia306/text/input_error.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace counterpoint::cia306
{
/// A value by its data type. Numbers are the low bits of `bits` (two's complement, IEEE 754 pattern); strings and
/// DOMAIN are `text` as it stands in the file.
struct Value
{
    std::uint64_t bits{0U};
    std::string text;
};

/// A value, or what is wrong with its text.
struct ValueResult
{
    std::optional<Value> value;
    Problem problem; ///< Where there is no value.
};

/// Reads a value of the data type. A formula is evaluated with `node_id`; without one it is a problem that says so.
/// A REAL may be a decimal fraction, or its IEEE 754 pattern after 0x. [SRS_EDS_007, SRS_EDS_008, SRS_EDS_014]
[[nodiscard]] ValueResult ParseValue(std::string_view text, std::uint16_t data_type,
                                     std::optional<std::uint8_t> node_id);
/// The same for a type of the file.
[[nodiscard]] ValueResult ParseValue(std::string_view text, const DataType& type, std::optional<std::uint8_t> node_id);

/// What is wrong with a text as a value of the data type; nothing if it is a value. There is no node-ID: a formula is
/// tried with node-ID 127.
[[nodiscard]] std::optional<Problem> ProblemOf(std::string_view text, std::uint16_t data_type);
/// The same for a type of the file.
[[nodiscard]] std::optional<Problem> ProblemOf(std::string_view text, const DataType& type);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_FILE_VALUE_HPP
