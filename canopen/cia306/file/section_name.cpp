// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/file/section_name.hpp"

#include "canopen/cia306/text/ini_document.hpp"
#include "canopen/cia306/text/number.hpp"

#include <string>

namespace counterpoint::cia306
{
namespace
{
constexpr std::size_t kIndexDigits = 4U;
constexpr std::size_t kMaxSubDigits = 2U;

bool IsHexadecimal(const std::string_view text)
{
    return !text.empty() && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

std::uint64_t HexadecimalOf(const std::string_view digits)
{
    return ParseUnsigned("0x" + std::string(digits), 0xFFFFU).value_or(0U);
}
} // namespace

SectionName ParseSectionName(const std::string_view name)
{
    const std::string lower = Lower(name);
    const std::string_view text = lower;
    const std::string_view index = text.substr(0U, kIndexDigits);
    const bool is_object = index.size() == kIndexDigits && IsHexadecimal(index);
    if (!is_object)
    {
        const bool is_prefixed = index.substr(0U, 2U) == "0x";
        return {is_prefixed ? SectionKind::kMisspelt : SectionKind::kOther, 0U, 0U};
    }
    SectionName result;
    result.index = static_cast<std::uint16_t>(HexadecimalOf(index));
    const std::string_view rest = text.substr(kIndexDigits);
    const std::string_view sub = rest.substr(0U, 3U) == "sub" ? rest.substr(3U) : std::string_view();
    const bool is_sub = IsHexadecimal(sub) && sub.size() <= kMaxSubDigits;
    result.kind = SectionKind::kMisspelt;
    if (rest.empty())
    {
        result.kind = SectionKind::kObject;
    }
    else if (is_sub)
    {
        result.kind = SectionKind::kSub;
        result.sub = static_cast<std::uint8_t>(HexadecimalOf(sub));
    }
    else if (rest == "name")
    {
        result.kind = SectionKind::kNames;
    }
    else if (rest == "value")
    {
        result.kind = SectionKind::kValues;
    }
    else if (rest == "denotation" || rest == "objectlinks")
    {
        result.kind = SectionKind::kObjectPart;
    }
    return result;
}
} // namespace counterpoint::cia306
