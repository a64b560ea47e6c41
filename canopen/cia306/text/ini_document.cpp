// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/text/ini_document.hpp"

#include "canopen/cia306/text/input_error.hpp"

#include <stdexcept>

namespace counterpoint::cia306
{
namespace
{
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kBlank = " \t";
constexpr std::string_view kCommentSigns = "#;";
constexpr char kDosEndOfFile = '\x1A';

bool StartsWith(const std::string_view text, const std::string_view prefix)
{
    return text.substr(0U, prefix.size()) == prefix;
}

std::string_view WithoutLineEnd(std::string_view line)
{
    if (!line.empty() && line.back() == '\n')
    {
        line.remove_suffix(1U);
    }
    if (!line.empty() && line.back() == '\r')
    {
        line.remove_suffix(1U);
    }
    return line;
}

/// `line` with its value replaced; what stands around the value stays, a comment too.
std::string WithValue(const std::string& line, const std::string& value)
{
    const std::string_view content = WithoutLineEnd(line);
    const std::size_t after_sign = content.find('=') + 1U;
    const std::size_t first = content.find_first_not_of(kBlank, after_sign);
    const std::size_t begin = first == std::string_view::npos ? after_sign : first;
    const std::string_view old = WithoutComment(content.substr(begin));
    return line.substr(0U, begin) + value + line.substr(begin + old.size());
}
} // namespace

std::string Lower(const std::string_view text)
{
    std::string out(text);
    for (char& character : out)
    {
        const bool is_upper = character >= 'A' && character <= 'Z';
        character = is_upper ? static_cast<char>(character - 'A' + 'a') : character;
    }
    return out;
}

std::string_view Trimmed(const std::string_view text)
{
    const std::size_t first = text.find_first_not_of(kBlank);
    if (first == std::string_view::npos)
    {
        return {};
    }
    return text.substr(first, text.find_last_not_of(kBlank) - first + 1U);
}

std::string_view WithoutComment(const std::string_view value)
{
    return Trimmed(value.substr(0U, value.find_first_of(kCommentSigns)));
}

std::optional<Finding> CommentBehind(const std::string_view value, const Place place)
{
    const std::size_t begin = value.find_first_of(kCommentSigns);
    if (begin == std::string_view::npos)
    {
        return std::nullopt;
    }
    return Finding{Severity::kWarning,
                   {place.line, place.column + begin},
                   "",
                   "a comment " + Quoted(value.substr(begin)) +
                       " behind a value, expected it in a line of its own; it is ignored"};
}

const IniKey* IniSection::Find(const std::string_view key) const
{
    const auto found = index.find(Lower(key));
    return found == index.end() ? nullptr : &keys[found->second];
}

IniDocument IniDocument::Parse(std::string file, const std::string_view text)
{
    IniDocument document;
    document.file_ = std::move(file);
    const bool is_utf16 = StartsWith(text, "\xFF\xFE") || StartsWith(text, "\xFE\xFF");
    if (is_utf16)
    {
        document.Refuse({1U, 1U}, "the text is UTF-16", "8-bit text (ASCII, Latin-1 or UTF-8)");
    }
    document.SplitLines(text);
    for (std::size_t place = 0U; place < document.lines_.size(); ++place)
    {
        std::string_view content = WithoutLineEnd(document.lines_[place]);
        if (place == 0U && StartsWith(content, kByteOrderMark))
        {
            content.remove_prefix(kByteOrderMark.size());
        }
        document.ReadLine(place + 1U, content);
    }
    return document;
}

void IniDocument::SplitLines(const std::string_view text)
{
    std::size_t begin = 0U;
    while (begin < text.size())
    {
        const std::size_t found = text.find('\n', begin);
        const std::size_t end = found == std::string_view::npos ? text.size() : found + 1U;
        if (lines_.size() == kMaxLines)
        {
            Refuse({kMaxLines + 1U, 1U}, "there is a line more", "at most " + std::to_string(kMaxLines) + " lines");
        }
        if (end - begin > kMaxLineBytes)
        {
            RequirePrintable(lines_.size() + 1U, text.substr(begin, kMaxLineBytes));
            Refuse({lines_.size() + 1U, 1U}, "the line has more than " + std::to_string(kMaxLineBytes) + " bytes",
                   "shorter lines (CiA 306: 255)");
        }
        lines_.emplace_back(text.substr(begin, end - begin));
        begin = end;
    }
}

void IniDocument::ReadLine(const std::size_t line, const std::string_view content)
{
    const bool is_dos_end = line == lines_.size() && content.size() == 1U && content.front() == kDosEndOfFile;
    if (is_dos_end)
    {
        warnings_.push_back(
            {Severity::kWarning, {line, 1U}, "", "end-of-file character 1Ah, expected the end of the file"});
        return;
    }
    RequirePrintable(line, content);
    const std::string_view text = Trimmed(content);
    if (text.empty() || text.front() == ';')
    {
        return;
    }
    const Place place{line, content.find_first_not_of(kBlank) + 1U};
    if (text.front() == '#')
    {
        warnings_.push_back(
            {Severity::kWarning, place, "", "a comment with '#' is no part of CiA 306, expected ';'; it is ignored"});
        return;
    }
    if (text.front() == '[')
    {
        ReadSectionHead(place, text);
        return;
    }
    ReadKey(place, text);
}

void IniDocument::ReadSectionHead(const Place place, const std::string_view content)
{
    const std::size_t close = content.find(']');
    if (close == std::string_view::npos)
    {
        Refuse(place, "section " + Quoted(content) + " is not closed", "']' at its end");
    }
    const std::size_t after = content.find_first_not_of(kBlank, close + 1U);
    if (after != std::string_view::npos)
    {
        WarnOfRest({place.line, place.column + after}, content.substr(after));
    }
    const std::string_view name = Trimmed(content.substr(1U, close - 1U));
    if (name.empty() || name.find('[') != std::string_view::npos)
    {
        Refuse(place, "section name " + Quoted(name), "a name such as [DeviceInfo] or [1000sub0]");
    }
    const auto [number, is_new] = section_index_.emplace(Lower(name), sections_.size());
    if (!is_new)
    {
        Refuse(place, "section " + Quoted(name) + " stands a second time",
               "it once, as in line " + std::to_string(sections_[number->second].place.line));
    }
    IniSection section;
    section.name = std::string(name);
    section.place = place;
    section.last_line = place.line;
    sections_.push_back(std::move(section));
}

/// What stands behind the name of a section: a comment is left out, anything else refused.
void IniDocument::WarnOfRest(const Place place, const std::string_view rest)
{
    if (!WithoutComment(rest).empty())
    {
        Refuse(place, "text " + Quoted(rest) + " after the section name", "nothing after ']'");
    }
    warnings_.push_back({Severity::kWarning, place, "",
                         "a comment " + Quoted(rest) +
                             " behind the section name, expected it in a line of its own; it "
                             "is ignored"});
}

void IniDocument::ReadKey(const Place place, const std::string_view content)
{
    const std::size_t sign = content.find('=');
    if (sign == std::string_view::npos)
    {
        Refuse(place, Quoted(content) + " is no line of an EDS",
               "[section], key=value or a comment that begins with ';'");
    }
    const std::string_view name = Trimmed(content.substr(0U, sign));
    if (name.empty())
    {
        Refuse(place, "a value without a key", "key=value");
    }
    if (sections_.empty())
    {
        Refuse(place, "key " + Quoted(name) + " before the first section", "a section such as [FileInfo] before it");
    }
    IniSection& section = sections_.back();
    const auto [number, is_new] = section.index.emplace(Lower(name), section.keys.size());
    if (!is_new)
    {
        Refuse(place, "key " + Quoted(name) + " stands a second time in section " + Quoted(section.name),
               "it once, as in line " + std::to_string(section.keys[number->second].place.line));
    }
    const std::size_t found = content.find_first_not_of(kBlank, sign + 1U);
    const std::size_t begin = found == std::string_view::npos ? content.size() : found;
    section.keys.push_back(
        {std::string(name), std::string(content.substr(begin)), {place.line, place.column + begin}, place});
    section.last_line = place.line;
}

void IniDocument::RequirePrintable(const std::size_t line, const std::string_view content) const
{
    for (std::size_t place = 0U; place < content.size(); ++place)
    {
        const auto byte = static_cast<unsigned char>(content[place]);
        const bool is_control = (byte < 0x20U && byte != 0x09U) || byte == 0x7FU;
        if (is_control)
        {
            Refuse({line, place + 1U}, "control byte " + Hex(byte, 2),
                   byte == 0x0DU ? "lines that end in LF or CR LF" : "8-bit text");
        }
    }
}

void IniDocument::Refuse(const Place place, const std::string& wrong, const std::string& expected) const
{
    throw InputError(file_, place, {wrong, expected});
}

const IniSection* IniDocument::Find(const std::string_view section) const
{
    const auto found = section_index_.find(Lower(section));
    return found == section_index_.end() ? nullptr : &sections_[found->second];
}

std::string IniDocument::Text() const
{
    std::string text;
    for (const std::string& line : lines_)
    {
        text += line;
    }
    return text;
}

const IniSection& IniDocument::Existing(const std::string& section) const
{
    const IniSection* const found = Find(section);
    if (found == nullptr)
    {
        throw std::invalid_argument("no section [" + section + "] to edit");
    }
    return *found;
}

std::string IniDocument::LineEnd() const
{
    const std::string& first = lines_.front();
    const bool is_dos = first.size() >= 2U && first[first.size() - 2U] == '\r';
    return is_dos ? "\r\n" : "\n";
}

IniDocument IniDocument::With(const std::vector<KeyEdit>& keys, const std::vector<SectionEdit>& sections) const
{
    std::vector<std::string> lines = lines_;
    std::vector<std::string> added(lines.size()); // What comes after the line of the same place.
    const std::string end = LineEnd();
    for (const KeyEdit& edit : keys)
    {
        const IniSection& section = Existing(edit.section);
        const IniKey* const key = section.Find(edit.key);
        if (key != nullptr)
        {
            lines[key->place.line - 1U] = WithValue(lines[key->place.line - 1U], edit.value);
            continue;
        }
        const IniKey* const before = section.Find(edit.after_key);
        const std::size_t line = before == nullptr ? section.last_line : before->place.line;
        added[line - 1U] += edit.key + "=" + edit.value + end;
    }
    for (const SectionEdit& edit : sections)
    {
        std::string& place = added[Existing(edit.after_section).last_line - 1U];
        place += end + "[" + edit.name + "]" + end;
        for (const auto& [key, value] : edit.keys)
        {
            place += key + "=" + value + end;
        }
    }
    std::string text;
    for (std::size_t place = 0U; place < lines.size(); ++place)
    {
        const bool lacks_end = !added[place].empty() && lines[place].back() != '\n';
        text += lines[place] + (lacks_end ? end : "") + added[place];
    }
    return Parse(file_, text);
}

IniDocument IniDocument::Without(const std::vector<std::string>& sections, const std::vector<KeyPlace>& keys) const
{
    std::vector<bool> is_left_out(lines_.size() + 1U, false); // By line.
    for (const std::string& name : sections)
    {
        const IniSection& section = Existing(name);
        const bool has_empty_line =
            section.last_line < lines_.size() && Trimmed(WithoutLineEnd(lines_[section.last_line])).empty();
        const std::size_t last = section.last_line + (has_empty_line ? 1U : 0U);
        for (std::size_t line = section.place.line; line <= last; ++line)
        {
            is_left_out[line] = true;
        }
    }
    for (const KeyPlace& place : keys)
    {
        const IniKey* const key = Existing(place.section).Find(place.key);
        if (key == nullptr)
        {
            throw std::invalid_argument("no key " + place.key + " in [" + place.section + "] to leave out");
        }
        is_left_out[key->place.line] = true;
    }
    std::string text;
    for (std::size_t place = 0U; place < lines_.size(); ++place)
    {
        text += is_left_out[place + 1U] ? "" : lines_[place];
    }
    return Parse(file_, text);
}
} // namespace counterpoint::cia306
