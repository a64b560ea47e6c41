// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/edit/mapping_text.hpp"

#include "canopen/cia306/file/data_type.hpp"
#include "canopen/cia306/text/ini_document.hpp"
#include "canopen/cia306/text/number.hpp"

#include <algorithm>
#include <utility>

namespace counterpoint::cia306
{
namespace
{
constexpr std::uint64_t kMostPairs = 8U; ///< Of 8 bits in 64.
constexpr std::uint64_t kFirstCobId = 0x101U;
constexpr std::uint64_t kLastCobId = 0x17FU;
constexpr std::string_view kNode = "node";
constexpr const char* kForm =
    "[NAME=][COUNTx]LENGTH such as 2x8, i16 or Speed=32, or INDEX:SUB of an object of the file, such as 0x6004:00";

using Halves = std::pair<std::string_view, std::optional<std::string_view>>;

/// What stands before the sign and behind it, without spaces around.
Halves SplitAt(const std::string_view text, const char sign)
{
    const std::size_t place = text.find(sign);
    if (place == std::string_view::npos)
    {
        return {Trimmed(text), std::nullopt};
    }
    return {Trimmed(text.substr(0U, place)), Trimmed(text.substr(place + 1U))};
}

bool IsName(const std::string_view text)
{
    constexpr std::size_t most = 60U;
    const auto is_letter = [](const char character)
    {
        const bool is_alphabetic =
            (character >= 'A' && character <= 'Z') || (character >= 'a' && character <= 'z') || character == ' ';
        return is_alphabetic || (character >= '0' && character <= '9') || character == '_' || character == '-';
    };
    return !text.empty() && text.size() <= most && std::all_of(text.begin(), text.end(), is_letter);
}

/// The integer of this many bits; nothing where CiA 301 has none of whole bytes.
std::optional<std::uint16_t> IntegerType(const std::string_view length)
{
    const bool is_signed = !length.empty() && length.front() == 'i';
    const bool has_sign = is_signed || (!length.empty() && length.front() == 'u');
    const auto bits = ParseUnsigned(length.substr(has_sign ? 1U : 0U), 64U);
    const DataKind kind = is_signed ? DataKind::kSigned : DataKind::kUnsigned;
    for (std::uint16_t code = 1U; bits && code <= kUnsigned64; ++code)
    {
        const DataType type = DataTypeOf(code);
        if (type.kind == kind && type.bits == *bits)
        {
            return code;
        }
    }
    return std::nullopt;
}

std::optional<ObjectPlace> PlaceOf(const std::string_view text)
{
    const auto [index_text, sub_text] = SplitAt(text, ':');
    // 6004:00 would be a decimal number, which nobody means.
    const bool is_hexadecimal = index_text.substr(0U, 2U) == "0x";
    const auto index = is_hexadecimal ? ParseUnsigned(index_text, 0xFFFFU) : std::nullopt;
    // Sub-indices are written as messages show them: two hexadecimal digits.
    const auto sub = ParseDigits(sub_text.value_or(""), 16);
    const bool is_place = index && sub && *sub <= 0xFEU;
    return is_place ? std::optional(ObjectPlace{static_cast<std::uint16_t>(*index), static_cast<std::uint8_t>(*sub)})
                    : std::nullopt;
}

/// Objects of the file: INDEX:SUB or INDEX:SUB/INDEX:SUB.
std::optional<PlannedPair> PresentPair(const std::string_view text)
{
    const auto [normal, inverse] = SplitAt(text, '/');
    PlannedPair pair;
    pair.normal = PlaceOf(normal);
    pair.inverse = inverse ? PlaceOf(*inverse) : std::nullopt;
    const bool is_right = pair.normal && (!inverse || pair.inverse);
    return is_right ? std::optional(pair) : std::nullopt;
}

/// Adds the pairs of one element; false where it is none.
bool AddElement(const std::string_view text, std::vector<PlannedPair>& pairs)
{
    if (text.find(':') != std::string_view::npos)
    {
        const auto pair = PresentPair(text);
        pairs.push_back(pair.value_or(PlannedPair{}));
        return pair.has_value();
    }
    const auto [first, named] = SplitAt(text, '=');
    const std::string_view what = named.value_or(first);
    const auto [count_text, length] = SplitAt(what, 'x');
    const auto count = length ? ParseUnsigned(count_text, kMostPairs) : std::optional<std::uint64_t>(1U);
    const auto type = IntegerType(length.value_or(what));
    const bool is_right = count && *count != 0U && type && (!named || IsName(first));
    if (!is_right)
    {
        return false;
    }
    for (std::uint64_t place = 1U; place <= *count; ++place)
    {
        PlannedPair pair;
        pair.name = named ? std::string(first) + (*count > 1U ? " " + std::to_string(place) : "") : "";
        pair.data_type = *type;
        pairs.push_back(std::move(pair));
    }
    return true;
}
} // namespace

std::optional<std::uint32_t> PreDefinedCobId(const std::uint64_t node_id) noexcept
{
    constexpr std::uint32_t base = 0xFFU;
    constexpr std::uint64_t last_node_id = 64U;
    const bool has_one = node_id != 0U && node_id <= last_node_id;
    return has_one ? std::optional(base + 2U * static_cast<std::uint32_t>(node_id)) : std::nullopt;
}

std::optional<std::uint32_t> DefaultCobId(const std::uint8_t number, const bool is_producer,
                                          const std::uint8_t node_id) noexcept
{
    constexpr std::uint8_t last_producer = 32U;
    const bool is_for_direction = is_producer ? node_id <= last_producer : node_id > last_producer;
    return number == 1U && is_for_direction ? PreDefinedCobId(node_id) : std::nullopt;
}

std::optional<std::uint32_t> ParseCobId(const std::string_view text)
{
    const bool is_node = text.substr(0U, kNode.size()) == kNode;
    const auto number = ParseUnsigned(is_node ? text.substr(kNode.size()) : text, kLastCobId);
    if (is_node)
    {
        return PreDefinedCobId(number.value_or(0U));
    }
    const bool is_cob_id = number && *number >= kFirstCobId && (*number & 1U) != 0U;
    return is_cob_id ? std::optional(static_cast<std::uint32_t>(*number)) : std::nullopt;
}

MappingText ParseMapping(const std::string_view text)
{
    MappingText result;
    const auto [mapping, cob_id] = SplitAt(text, '@');
    if (cob_id)
    {
        result.cob_id = ParseCobId(*cob_id);
    }
    if (cob_id && !result.cob_id)
    {
        result.problem = {"COB-ID " + Quoted(*cob_id), "an odd one from 0x101 to 0x17F, or node1 to node64"};
        return result;
    }
    std::optional<std::string_view> rest = mapping;
    while (rest)
    {
        const Halves halves = SplitAt(*rest, ',');
        rest = halves.second;
        if (!AddElement(halves.first, result.pairs))
        {
            result.problem = {Quoted(halves.first), kForm};
            return result;
        }
    }
    std::uint64_t bits = 0U;
    for (const PlannedPair& pair : result.pairs)
    {
        bits += DataTypeOf(pair.data_type).bits;
    }
    if (bits > 64U || result.pairs.size() > 64U)
    {
        result.problem = {Quoted(mapping) + " has " + std::to_string(bits) + " bits in " +
                              std::to_string(result.pairs.size()) + " objects",
                          "at most 64 bits"};
    }
    return result;
}
} // namespace counterpoint::cia306
