// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/text/input_error.hpp"

#include <utility>

namespace counterpoint::cia306
{
namespace
{
constexpr std::size_t kMaxQuotedLength = 60U;
constexpr std::string_view kHexDigits = "0123456789ABCDEF";

void AppendEscaped(std::string& out, const unsigned char byte)
{
    out += "\\x";
    out += kHexDigits[byte >> 4U];
    out += kHexDigits[byte & 0x0FU];
}

std::string Sentence(const Problem& problem)
{
    return problem.expected.empty() ? problem.wrong : problem.wrong + ", expected " + problem.expected;
}

} // namespace

std::string PlaceText(const std::string& file, const Place place)
{
    std::string text = Printable(file);
    text += place.line != 0U ? ":" + std::to_string(place.line) : "";
    text += place.line != 0U && place.column != 0U ? ":" + std::to_string(place.column) : "";
    return text;
}

std::string Quoted(const std::string_view text)
{
    std::string out = "'";
    for (const char character : text)
    {
        const auto byte = static_cast<unsigned char>(character);
        const bool is_plain = byte >= 0x20U && byte < 0x7FU;
        if (out.size() > kMaxQuotedLength)
        {
            return out + "...'";
        }
        if (is_plain)
        {
            out += character;
        }
        else
        {
            AppendEscaped(out, byte);
        }
    }
    return out + "'";
}

std::string Printable(const std::string_view text)
{
    std::string out;
    for (const char character : text)
    {
        const auto byte = static_cast<unsigned char>(character);
        const bool is_control = byte < 0x20U || byte == 0x7FU;
        if (is_control)
        {
            AppendEscaped(out, byte);
        }
        else
        {
            out += character;
        }
    }
    return out;
}

std::string Hex(const std::uint64_t value, const int digits)
{
    std::string reversed;
    std::uint64_t rest = value;
    while (rest != 0U || reversed.size() < static_cast<std::size_t>(digits))
    {
        reversed += kHexDigits[rest & 0x0FU];
        rest >>= 4U;
    }
    return "0x" + std::string(reversed.rbegin(), reversed.rend());
}

std::string ObjectName(const std::uint16_t index, const std::uint8_t sub)
{
    return Hex(index, 4) + ":" + Hex(sub, 2).substr(2U);
}

InputError::InputError(std::string file, const Place place, const Problem& problem)
    : std::runtime_error(PlaceText(file, place) + ": error: " + Sentence(problem)), file_(std::move(file)),
      place_(place), message_(Sentence(problem))
{
}
} // namespace counterpoint::cia306
