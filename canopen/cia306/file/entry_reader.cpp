// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/file/entry_reader.hpp"

#include "canopen/cia306/file/data_type.hpp"
#include "canopen/cia306/text/nearest_word.hpp"
#include "canopen/cia306/text/number.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace counterpoint::cia306
{
namespace
{
constexpr std::uint64_t kMaxObjectType = 9U;
constexpr std::uint64_t kMaxInvertedSrad = 0xFFFFFFU;
constexpr std::size_t kInvertedSradDigits = 6U;

constexpr std::array<std::pair<std::string_view, Access>, 6U> kAccessNames{{
    {"ro", Access::kReadOnly},
    {"wo", Access::kWriteOnly},
    {"rw", Access::kReadWrite},
    {"rwr", Access::kReadWriteInput},
    {"rww", Access::kReadWriteOutput},
    {"const", Access::kConstant},
}};

void Warn(std::vector<Finding>& warnings, const Place place, const Entry& entry, const std::string& text)
{
    warnings.push_back({Severity::kWarning, place, ObjectName(entry.index, entry.sub), text});
}

void WarnOfValue(const Entry& entry, const Text& value, std::string_view key, std::vector<Finding>& warnings)
{
    if (!value.IsSet())
    {
        return;
    }
    const auto problem = ProblemOf(value.text, entry.type);
    if (problem)
    {
        Warn(warnings, value.place, entry,
             std::string(key) + ": " + problem->wrong + ", expected " + problem->expected);
    }
}

/// Safety objects, too.
void WarnOfSuffix(const Entry& entry, const Text& value, const std::string_view key, std::vector<Finding>& warnings)
{
    const bool is_text = entry.type.kind == DataKind::kText;
    const auto formula = is_text ? std::nullopt : ParseFormula(value.text);
    if (formula && formula->number.has_suffix)
    {
        Warn(warnings, value.place, entry,
             std::string(key) + ": " + Quoted(value.text) +
                 " is read without its suffix, expected a number without U or L");
    }
}

bool IsBareInvertedSrad(const std::string_view text)
{
    return text.size() == kInvertedSradDigits &&
           text.find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos;
}
} // namespace

SectionReader::SectionReader(const std::string& file, const IniSection& section,
                             std::vector<Finding>& warnings) noexcept
    : file_(&file), section_(&section), warnings_(&warnings)
{
}

const IniKey* SectionReader::Find(const std::string_view key) const
{
    const IniKey* const found = section_->Find(key);
    if (found == nullptr)
    {
        return nullptr;
    }
    const auto comment = CommentBehind(found->value, found->place);
    if (comment)
    {
        warnings_->push_back(*comment);
    }
    return found->Bare().empty() ? nullptr : found;
}

void SectionReader::Refuse(const IniKey& key, const std::string& expected) const
{
    throw InputError(*file_, key.place, {Quoted(key.name) + " is " + Quoted(key.value), expected});
}

std::optional<std::uint64_t> SectionReader::NumberAt(const std::string_view key, const std::uint64_t max) const
{
    const IniKey* const found = Find(key);
    if (found == nullptr)
    {
        return std::nullopt;
    }
    const auto number = ParseUnsigned(found->Bare(), max);
    if (!number)
    {
        Refuse(*found, "a number from 0 to " + std::to_string(max));
    }
    return number;
}

std::optional<bool> SectionReader::FlagAt(const std::string_view key) const
{
    const auto number = NumberAt(key, 1U);
    return number ? std::optional(*number == 1U) : std::nullopt;
}

Text SectionReader::TextAt(const std::string_view key) const
{
    const IniKey* const found = section_->Find(key);
    return found == nullptr || found->value.empty() ? Text{} : Text{found->value, found->place};
}

Place SectionReader::PlaceAt(const std::string_view key) const
{
    const IniKey* const found = section_->Find(key);
    return found == nullptr || found->Bare().empty() ? section_->place : found->place;
}

ObjectType SectionReader::ObjectTypeAt(const std::string_view key) const
{
    const auto number = NumberAt(key, kMaxObjectType);
    const auto type = static_cast<ObjectType>(number.value_or(static_cast<std::uint64_t>(ObjectType::kVar)));
    const bool is_known = type == ObjectType::kNull || type == ObjectType::kDomain || type >= ObjectType::kDeftype;
    if (!is_known)
    {
        Refuse(*section_->Find(key), "0x2 (DOMAIN), 0x5, 0x6, 0x7 (VAR), 0x8 (ARRAY) or 0x9 (RECORD)");
    }
    return type;
}

Access SectionReader::AccessAt(const std::string_view key) const
{
    const IniKey* const found = Find(key);
    if (found == nullptr)
    {
        return Access::kUnknown;
    }
    const std::string lower = Lower(found->Bare());
    for (const auto& [name, access] : kAccessNames)
    {
        if (lower == name)
        {
            return access;
        }
    }
    Refuse(*found, "ro, wo, rw, rwr, rww or const");
}

/// A hint for tools: what is no number refuses no file.
bool SectionReader::IsDownloadRefused() const
{
    constexpr std::uint64_t kMost = 0xFFFFFFFFU;
    constexpr std::uint64_t kRefuseWrite = 1U;
    const IniKey* const found = Find("ObjFlags");
    const auto flags = (found == nullptr) ? std::optional<std::uint64_t>(0U) : ParseUnsigned(found->Bare(), kMost);
    if (!flags)
    {
        warnings_->push_back({Severity::kWarning, found->place, "",
                              "ObjFlags: " + Quoted(found->value) + ", expected a number; it is ignored"});
    }
    return (flags.value_or(0U) & kRefuseWrite) != 0U;
}

void SectionReader::ReadInvertedSrad(Entry& entry) const
{
    const IniKey* const found = Find("InvertedSRAD");
    if (found == nullptr)
    {
        return;
    }
    const std::string text = found->Bare();
    const bool is_bare = IsBareInvertedSrad(text);
    const auto number = ParseUnsigned(is_bare ? "0x" + text : text, kMaxInvertedSrad);
    if (!number)
    {
        Refuse(*found, "index and sub-index of the inverse object as one number, such as 0x210001");
    }
    if (is_bare)
    {
        Warn(*warnings_, found->place, entry, "InvertedSRAD without 0x is read as hexadecimal, expected 0x" + text);
    }
    if (*number != 0U)
    {
        entry.inverted_srad = static_cast<std::uint32_t>(*number);
        entry.inverted_srad_place = found->place;
    }
}

void SectionReader::WarnOfSlips(const std::vector<std::string>& known) const
{
    for (const IniKey& key : section_->keys)
    {
        const bool is_known = std::any_of(known.begin(), known.end(),
                                          [&key](const std::string& name) { return Lower(name) == Lower(key.name); });
        const std::string meant = is_known ? "" : DidYouMean(key.name, known);
        if (!meant.empty())
        {
            warnings_->push_back({Severity::kWarning, key.name_place, "",
                                  "unknown key " + Quoted(key.name) + meant + " in section " + Quoted(section_->name) +
                                      ", expected one of CiA 306; it is ignored"});
        }
    }
}

Entry SectionReader::ReadEntry(const std::uint16_t index, const std::uint8_t sub) const
{
    Entry entry;
    entry.index = index;
    entry.sub = sub;
    entry.name = TextAt("ParameterName").text;
    entry.data_type = static_cast<std::uint16_t>(NumberAt("DataType", 0xFFFFU).value_or(0U));
    if (ObjectTypeAt("ObjectType") == ObjectType::kDomain)
    {
        entry.data_type = kDomainType;
    }
    entry.access = AccessAt("AccessType");
    entry.is_pdo_mappable = FlagAt("PDOMapping").value_or(false);
    entry.is_srdo_mappable = FlagAt("SRDOMapping");
    entry.default_value = TextAt("DefaultValue");
    entry.parameter_value = TextAt("ParameterValue");
    entry.low_limit = TextAt("LowLimit");
    entry.high_limit = TextAt("HighLimit");
    entry.place = section_->place;
    entry.type_place = PlaceAt("DataType");
    entry.access_place = PlaceAt("AccessType");
    entry.section = section_->name;
    entry.is_download_refused = IsDownloadRefused();
    entry.download_file = TextAt("DownloadFile");
    ReadInvertedSrad(entry);
    return entry;
}

void LeaveOutOfSrdos(Entry& entry, std::vector<Finding>& warnings)
{
    if (!entry.is_safety || !entry.is_srdo_mappable.value_or(entry.is_pdo_mappable))
    {
        return;
    }
    entry.is_srdo_mappable = false;
    // All sub-indices of a compact object share what is said once.
    if (!entry.is_compact || entry.sub == 1U)
    {
        const std::string range = entry.index <= 0x13FFU ? "0x1300 to 0x13FF" : "0x5F00 to 0x5F05";
        Warn(warnings, entry.place, entry,
             "it is mappable by SRDOMapping or PDOMapping, expected 0 for " + range + "; no SRDO can map it");
    }
}

void LeaveOutComments(Entry& entry, std::vector<Finding>& warnings)
{
    const bool may_hold_any = entry.type.kind == DataKind::kText || entry.type.kind == DataKind::kUnknown ||
                              entry.type.kind == DataKind::kStructure;
    if (may_hold_any)
    {
        return;
    }
    for (Text* const value : {&entry.default_value, &entry.parameter_value, &entry.low_limit, &entry.high_limit})
    {
        const auto comment = CommentBehind(value->text, value->place);
        if (comment)
        {
            warnings.push_back(*comment);
            value->text = std::string(WithoutComment(value->text));
        }
    }
}

void WarnOfEntry(const Entry& entry, std::vector<Finding>& warnings)
{
    if (entry.data_type == 0U)
    {
        Warn(warnings, entry.place, entry, "no DataType, expected one; its values are not checked");
    }
    else if (entry.type.kind == DataKind::kUnknown)
    {
        Warn(warnings, entry.type_place, entry,
             "DataType " + Hex(entry.data_type, 4) +
                 " is unknown, expected 0x0001 to 0x001B, or an object there that describes it; its values are not "
                 "checked");
    }
    if (entry.access == Access::kUnknown)
    {
        Warn(warnings, entry.place, entry, "no AccessType, expected ro, wo, rw, rwr, rww or const");
    }
    const std::array<std::pair<const Text*, std::string_view>, 4U> values{{{&entry.default_value, "DefaultValue"},
                                                                           {&entry.parameter_value, "ParameterValue"},
                                                                           {&entry.low_limit, "LowLimit"},
                                                                           {&entry.high_limit, "HighLimit"}}};
    for (const auto& [value, key] : values)
    {
        WarnOfSuffix(entry, *value, key, warnings);
        if (!entry.is_safety)
        {
            WarnOfValue(entry, *value, key, warnings);
        }
    }
}
} // namespace counterpoint::cia306
