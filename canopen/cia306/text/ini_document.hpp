// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_TEXT_INI_DOCUMENT_HPP
#define CANOPEN_CIA306_TEXT_INI_DOCUMENT_HPP

#include "canopen/cia306/text/finding.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace counterpoint::cia306
{
constexpr std::size_t kMaxLines = 400000U;
constexpr std::size_t kMaxLineBytes = 65535U;

/// The text in ASCII lower case; names of sections and keys are compared in this form.
[[nodiscard]] std::string Lower(std::string_view text);

/// The text without spaces and tabs at both ends.
[[nodiscard]] std::string_view Trimmed(std::string_view text);

/// A number or word without the comment that '#' or ';' begins behind it: neither of them holds one. [SRS_EDS_035]
[[nodiscard]] std::string_view WithoutComment(std::string_view value);

/// The warning of the comment behind a value that begins at `place`; nothing: there is none.
[[nodiscard]] std::optional<Finding> CommentBehind(std::string_view value, Place place);

/// A key of a section with its value.
struct IniKey
{
    std::string name;
    std::string value; ///< Without blanks at both ends, a comment behind it included: only its reader knows.
    Place place;       ///< Of the value.
    Place name_place;

    /// The value as a number or word is read.
    [[nodiscard]] std::string Bare() const
    {
        return std::string(WithoutComment(value));
    }
};

/// A section with its keys.
struct IniSection
{
    std::string name;
    Place place;
    std::size_t last_line{0U};                ///< Line of its last key; of its head where it has no key.
    std::vector<IniKey> keys;                 ///< In the order of the file.
    std::map<std::string, std::size_t> index; ///< Lower case name to place in `keys`.

    /// The key of that name, upper or lower case; null: there is none.
    [[nodiscard]] const IniKey* Find(std::string_view key) const;
};

/// Sets a key of a section that exists: replaces its value, or adds a line after `after_key` (the end of the section
/// where that is not there).
struct KeyEdit
{
    std::string section;
    std::string key;
    std::string value;
    std::string after_key;
};

/// Adds a section after the last key of `after_section`.
struct SectionEdit
{
    std::string after_section;
    std::string name;
    std::vector<std::pair<std::string, std::string>> keys;
};

/// A key of a section that exists.
struct KeyPlace
{
    std::string section;
    std::string key;
};

/// The lines of a file, and the sections and keys seen in them.
/// Invariant: Text() of a parsed document is the text that was parsed, byte by byte; lines are never rewritten, an edit
/// replaces the value in one line or adds lines. [SRS_EDS_002, SRS_EDS_003, SRS_EDS_004, SRS_EDS_005, SRS_EDS_016,
/// SRS_EDS_018, SRS_EDS_035]
class IniDocument
{
  public:
    /// Parses a text. `file` is used in messages only. Throws InputError.
    [[nodiscard]] static IniDocument Parse(std::string file, std::string_view text);

    /// Name of the file, as it was given.
    [[nodiscard]] const std::string& File() const noexcept
    {
        return file_;
    }
    /// All sections, in the order of the file.
    [[nodiscard]] const std::vector<IniSection>& Sections() const noexcept
    {
        return sections_;
    }
    /// The section of that name, upper or lower case; null: there is none.
    [[nodiscard]] const IniSection* Find(std::string_view section) const;
    /// What the lines have wrong without being refused.
    [[nodiscard]] const std::vector<Finding>& Warnings() const noexcept
    {
        return warnings_;
    }
    /// Number of lines.
    [[nodiscard]] std::size_t LineCount() const noexcept
    {
        return lines_.size();
    }
    /// The whole text, byte by byte as it was parsed or edited.
    [[nodiscard]] std::string Text() const;

    /// A copy with these edits. The sections that the edits name must exist (std::invalid_argument otherwise).
    [[nodiscard]] IniDocument With(const std::vector<KeyEdit>& keys, const std::vector<SectionEdit>& sections) const;
    /// A copy without these sections, each from its head to its last key and with the empty line behind, and without
    /// these keys. All must exist (std::invalid_argument otherwise).
    [[nodiscard]] IniDocument Without(const std::vector<std::string>& sections,
                                      const std::vector<KeyPlace>& keys) const;

  private:
    void SplitLines(std::string_view text);
    void ReadLine(std::size_t line, std::string_view content);
    void ReadSectionHead(Place place, std::string_view content);
    void WarnOfRest(Place place, std::string_view rest);
    void ReadKey(Place place, std::string_view content);
    void RequirePrintable(std::size_t line, std::string_view content) const;
    [[noreturn]] void Refuse(Place place, const std::string& wrong, const std::string& expected) const;
    [[nodiscard]] const IniSection& Existing(const std::string& section) const;
    [[nodiscard]] std::string LineEnd() const;

    std::string file_;
    std::vector<std::string> lines_; ///< Each with its line end; the first with the byte order mark, if any.
    std::vector<IniSection> sections_;
    std::map<std::string, std::size_t> section_index_;
    std::vector<Finding> warnings_;
};
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_TEXT_INI_DOCUMENT_HPP
