// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/yaml/document.hpp"

#include "canopen/cia306/text/input_error.hpp"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>
#include <system_error>

namespace counterpoint::runtime
{
namespace
{
/// A mark of the library counts from 0; where it has none (-1) the place is none, either.
Place PlaceOf(const YAML::Mark& mark)
{
    return {static_cast<std::size_t>(mark.line) + 1U, static_cast<std::size_t>(mark.column) + 1U};
}

/// Length of the UTF-8 character at `place`, 0 if there is none or it is a control character other than tab and
/// newline.
std::size_t CharacterLength(const std::string& text, const std::size_t place)
{
    const auto first = static_cast<unsigned char>(text[place]);
    if (first < 0x80U)
    {
        const bool is_text = first == '\n' || first == '\t' || (first >= 0x20U && first != 0x7FU);
        return is_text ? 1U : 0U;
    }
    std::size_t length = (first >= 0xC2U && first < 0xF5U) ? 2U : 0U;
    length += (length != 0U && first >= 0xE0U) ? 1U : 0U;
    length += (length != 0U && first >= 0xF0U) ? 1U : 0U;
    if (length == 0U || place + length > text.size())
    {
        return 0U;
    }
    for (std::size_t offset = 1U; offset < length; ++offset)
    {
        const auto next = static_cast<unsigned char>(text[place + offset]);
        if ((next & 0xC0U) != 0x80U)
        {
            return 0U;
        }
    }
    return length;
}

/// Builds the tree. The nodes under construction lie on a stack; a finished one is appended to the one below it.
class TreeBuilder : public YAML::EventHandler
{
  public:
    TreeBuilder(const std::string& file, const std::string& text) : file_(file), text_(text)
    {
    }

    void OnDocumentStart(const YAML::Mark& mark) override
    {
        static_cast<void>(mark);
        stack_.clear();
    }
    void OnDocumentEnd() override
    {
    }
    void OnNull(const YAML::Mark& mark, const YAML::anchor_t anchor) override
    {
        static_cast<void>(anchor);
        Begin(mark, YamlKind::kNull, "").place = SaysNothing(mark) ? PlaceOf(mark) : PlaceOfMissing(mark);
        End();
    }
    void OnAlias(const YAML::Mark& mark, const YAML::anchor_t anchor) override
    {
        static_cast<void>(anchor);
        throw YamlError(file_, PlaceOf(mark), "alias", "the value itself; aliases are not allowed");
    }
    void OnScalar(const YAML::Mark& mark, const std::string& tag, const YAML::anchor_t anchor,
                  const std::string& value) override
    {
        static_cast<void>(anchor);
        YamlNode& node = Begin(mark, YamlKind::kScalar, tag);
        node.scalar = value;
        RequirePrintable(value, node.place);
        node.is_quoted = tag == "!";
        Read(mark, EndOfScalar(mark, value, node.place));
        End();
    }
    void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, const YAML::anchor_t anchor,
                         const YAML::EmitterStyle::value style) override
    {
        static_cast<void>(anchor);
        static_cast<void>(style);
        Begin(mark, YamlKind::kSequence, tag);
        Read(mark, OffsetOf(mark));
    }
    void OnSequenceEnd() override
    {
        End();
    }
    void OnMapStart(const YAML::Mark& mark, const std::string& tag, const YAML::anchor_t anchor,
                    const YAML::EmitterStyle::value style) override
    {
        static_cast<void>(anchor);
        static_cast<void>(style);
        Begin(mark, YamlKind::kMap, tag);
        Read(mark, OffsetOf(mark));
    }
    void OnMapEnd() override
    {
        End();
    }

    [[nodiscard]] YamlNode Take()
    {
        return std::move(root_);
    }

  private:
    YamlNode& Begin(const YAML::Mark& mark, const YamlKind kind, const std::string& tag)
    {
        const Place place = PlaceOf(mark);
        const bool is_plain = tag.empty() || tag == "?" || tag == "!";
        if (!is_plain)
        {
            throw YamlError(file_, place, "tag " + Shown(tag), "a value without a tag");
        }
        ++count_;
        if (count_ > kMaxYamlNodes)
        {
            throw YamlError(file_, place, "too many values", "at most " + std::to_string(kMaxYamlNodes));
        }
        if (stack_.size() >= kMaxYamlDepth)
        {
            throw YamlError(file_, place, "nested too deeply", "at most " + std::to_string(kMaxYamlDepth) + " levels");
        }
        stack_.emplace_back();
        stack_.back().kind = kind;
        stack_.back().place = place;
        return stack_.back();
    }

    void End()
    {
        YamlNode node = std::move(stack_.back());
        stack_.pop_back();
        if (stack_.empty())
        {
            root_ = std::move(node);
            return;
        }
        stack_.back().items.push_back(std::move(node));
    }

    /// Escapes of quoted text can make what RequireText refused in the file itself.
    void RequirePrintable(const std::string& value, const Place place) const
    {
        for (std::size_t at = 0U; at < value.size();)
        {
            const std::size_t length = CharacterLength(value, at);
            const bool is_control = length == 2U && static_cast<unsigned char>(value[at]) == 0xC2U &&
                                    static_cast<unsigned char>(value[at + 1U]) < 0xA0U;
            if (length == 0U || is_control)
            {
                throw YamlError(file_, place, "text with a character that is not printable", "printable text");
            }
            at += length;
        }
    }

    [[nodiscard]] std::size_t OffsetOf(const YAML::Mark& mark) const
    {
        return std::min(static_cast<std::size_t>(mark.pos), text_.size());
    }

    /// What begins at `mark` was read up to `end`.
    void Read(const YAML::Mark& mark, const std::size_t end)
    {
        written_ = end;
        line_begin_ = OffsetOf(mark) - static_cast<std::size_t>(mark.column);
    }

    /// Where a text ends; one of several lines without quotes may be longer than told. The library takes the end of the
    /// file for the end of a quoted text.
    [[nodiscard]] std::size_t EndOfScalar(const YAML::Mark& mark, const std::string& value, const Place place) const
    {
        const std::size_t begin = OffsetOf(mark);
        const char quote = text_.c_str()[begin];
        if (quote != '"' && quote != '\'')
        {
            return begin + value.size();
        }
        std::size_t at = begin + 1U;
        while (at < text_.size())
        {
            const bool is_escape = text_[at] == '\\' && quote == '"';
            const bool is_double = quote == '\'' && text_.compare(at, 2U, "''") == 0;
            if (!is_escape && !is_double && text_[at] == quote)
            {
                return at + 1U;
            }
            at += (is_escape || is_double) ? 2U : 1U;
        }
        throw YamlError(file_, place, "quoted text without an end", std::string("a closing ") + quote);
    }

    /// Whether the value is there and says that it is none. What is missing has the place of what follows it.
    [[nodiscard]] bool SaysNothing(const YAML::Mark& mark) const
    {
        static constexpr std::array<std::string_view, 4U> kNothing{"~", "null", "Null", "NULL"};
        const std::string_view rest = std::string_view(text_).substr(OffsetOf(mark));
        const std::string_view word = rest.substr(0U, rest.find_first_of(" \t,]}\n"));
        return std::find(kNothing.begin(), kNothing.end(), word) != kNothing.end();
    }

    /// The library places a value that is not written at what follows it, which may be lines below, or at its key: it
    /// is missing behind the last character before that which is no comment. [SRS_SIM_400]
    [[nodiscard]] Place PlaceOfMissing(const YAML::Mark& mark)
    {
        std::size_t line = PlaceOf(mark).line;
        std::size_t line_begin = line_begin_;
        bool is_comment = false;
        for (std::size_t at = written_; at < OffsetOf(mark); ++at)
        {
            const char now = text_[at];
            is_comment = now == '#' || (is_comment && now != '\n');
            if (now == '\n')
            {
                line_begin = at + 1U;
                --line;
            }
            else if (!is_comment && now != ' ' && now != '\t')
            {
                written_ = at + 1U;
                line_begin_ = line_begin;
                line = PlaceOf(mark).line;
            }
            else
            {
                // Nothing is written here.
            }
        }
        return {line, written_ - line_begin_ + 1U};
    }

    const std::string& file_;
    const std::string& text_;
    std::vector<YamlNode> stack_;
    YamlNode root_;
    std::size_t count_{0U};
    std::size_t written_{0U};    ///< Where what was read last ends, or a place in it.
    std::size_t line_begin_{0U}; ///< Where the line of that begins.
};

void RequireText(const std::string& file, const std::string& text)
{
    Place place{1U, 1U};
    std::size_t at = 0U;
    while (at < text.size())
    {
        const std::size_t length = CharacterLength(text, at);
        if (length == 0U)
        {
            std::ostringstream byte;
            byte << "byte 0x" << std::hex << static_cast<unsigned>(static_cast<unsigned char>(text[at]));
            throw YamlError(file, place, byte.str(), "UTF-8 text");
        }
        place.column = (text[at] == '\n') ? 1U : place.column + 1U;
        place.line += (text[at] == '\n') ? 1U : 0U;
        at += length;
    }
}

std::string Normalised(const std::string& raw)
{
    const std::string mark = "\xEF\xBB\xBF";
    std::string text;
    text.reserve(raw.size());
    for (std::size_t at = (raw.compare(0U, mark.size(), mark) == 0) ? mark.size() : 0U; at < raw.size(); ++at)
    {
        const bool is_return = raw[at] == '\r' && at + 1U < raw.size() && raw[at + 1U] == '\n';
        if (!is_return)
        {
            text.push_back(raw[at]);
        }
    }
    return text;
}
} // namespace

YamlError::YamlError(const std::string& file, const Place place, const std::string& wrong, const std::string& expected)
    : std::runtime_error(cia306::PlaceText(file, place) + ": error: " + wrong + ", expected " + expected)
{
}

std::string Shown(const std::string_view text)
{
    constexpr std::size_t kMaxShown = 60U;
    std::string shown = "'";
    for (const char character : text.substr(0U, kMaxShown))
    {
        const auto code = static_cast<unsigned char>(character);
        shown.push_back((code < 0x20U || code >= 0x7FU) ? '?' : character);
    }
    return shown + ((text.size() > kMaxShown) ? "...'" : "'");
}

std::string ReadYamlText(const std::string& file)
{
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(file, error);
    if (status.type() == std::filesystem::file_type::not_found)
    {
        throw YamlError(file, {}, "no such file", "a YAML file");
    }
    if (status.type() == std::filesystem::file_type::none)
    {
        throw YamlError(file, {}, "cannot be opened (" + error.message() + ")", "a readable file");
    }
    if (!std::filesystem::is_regular_file(status))
    {
        throw YamlError(file, {}, "not a regular file", "a YAML file");
    }
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (size > kMaxYamlBytes) // So is what has no size.
    {
        throw YamlError(file, {}, std::to_string(size) + " bytes", "at most " + std::to_string(kMaxYamlBytes));
    }
    std::ifstream stream(file, std::ios::binary);
    std::string raw(static_cast<std::size_t>(size), '\0');
    stream.read(raw.data(), static_cast<std::streamsize>(raw.size()));
    if (stream.gcount() != static_cast<std::streamsize>(raw.size()))
    {
        throw YamlError(file, {}, "cannot be read", "a readable file");
    }
    std::string text = Normalised(raw);
    RequireText(file, text);
    return text;
}

YamlNode ParseYaml(const std::string& file, const std::string& text)
{
    std::istringstream stream(text);
    TreeBuilder builder(file, text);
    try
    {
        YAML::Parser parser(stream);
        if (!parser.HandleNextDocument(builder))
        {
            throw YamlError(file, {1, 1}, "no document", "a map of keys and values");
        }
        YamlNode root = builder.Take();
        if (parser.HandleNextDocument(builder))
        {
            throw YamlError(file, builder.Take().place, "a second document", "one document");
        }
        return root;
    }
    catch (const YAML::Exception& exception)
    {
        throw YamlError(file, PlaceOf(exception.mark), "not YAML: " + exception.msg, "a YAML 1.2 document");
    }
}
} // namespace counterpoint::runtime
