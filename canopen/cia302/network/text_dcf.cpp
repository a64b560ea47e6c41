// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia302/network/text_dcf.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint32_t kNoDigit = 0xFFU;
constexpr std::uint64_t kMost = 0xFFFF'FFFF'FFFF'FFFFU;
constexpr std::uint8_t kVisibleString = 9U;
constexpr std::uint8_t kTypes = 0x1CU;
/// Bytes of the data types of CiA 301 by their numbers; 0: no number.
constexpr std::uint8_t kSizes[kTypes] = {0U, 1U, 1U, 2U, 4U, 1U, 2U, 4U, 4U, 0U, 0U, 0U, 0U, 0U,
                                         0U, 0U, 3U, 8U, 5U, 6U, 7U, 8U, 3U, 0U, 5U, 6U, 7U, 8U};

/// What a section says of its object.
struct Section
{
    bool is_object;
    ObjectAddress object;
    Bytes type;
    Bytes access;
    Bytes value;
    Bytes flags;
};

struct Number
{
    bool is_right;
    std::uint64_t value;
    std::uint32_t used_bytes;
};

std::uint8_t Lower(const std::uint8_t letter) noexcept
{
    const bool is_capital = (letter >= 'A') && (letter <= 'Z');
    return is_capital ? static_cast<std::uint8_t>(letter + 32U) : letter;
}

/// Whether `text` begins with a word in lower case, whatever its own case.
bool Begins(const Bytes& text, const char* const word, const std::uint32_t length) noexcept
{
    bool is_same = (text.size_bytes >= length);
    for (std::uint32_t i = 0U; is_same && (i < length); ++i)
    {
        is_same = (Lower(text.data[i]) == static_cast<std::uint8_t>(word[i]));
    }
    return is_same;
}

bool Is(const Bytes& text, const char* const word, const std::uint32_t length) noexcept
{
    return (text.size_bytes == length) && Begins(text, word, length);
}

Bytes From(const Bytes& text, const std::uint32_t offset) noexcept
{
    return Bytes{&text.data[offset], text.size_bytes - offset};
}

bool IsBlank(const std::uint8_t letter) noexcept
{
    return (letter == ' ') || (letter == '\t') || (letter == '\r');
}

Bytes Trimmed(const Bytes& text) noexcept
{
    Bytes rest = text;
    while ((rest.size_bytes > 0U) && IsBlank(rest.data[0]))
    {
        rest = From(rest, 1U);
    }
    while ((rest.size_bytes > 0U) && IsBlank(rest.data[rest.size_bytes - 1U]))
    {
        --rest.size_bytes;
    }
    return rest;
}

/// Bytes up to a mark, or all.
std::uint32_t Up(const Bytes& text, const std::uint8_t mark) noexcept
{
    std::uint32_t count = 0U;
    while ((count < text.size_bytes) && (text.data[count] != mark))
    {
        ++count;
    }
    return count;
}

std::uint32_t DigitOf(const std::uint8_t letter, const std::uint32_t base) noexcept
{
    const std::uint8_t low = Lower(letter);
    std::uint32_t digit = kNoDigit;
    if ((low >= '0') && (low <= '9'))
    {
        digit = std::uint32_t{low} - '0';
    }
    else if ((low >= 'a') && (low <= 'f'))
    {
        digit = (std::uint32_t{low} - 'a') + 10U;
    }
    return (digit < base) ? digit : kNoDigit;
}

/// A base with the greatest number that it writes. The division is the compiler's: a target without a library has none
/// of 64 bits.
struct Base
{
    std::uint32_t base;
    std::uint64_t limit;      ///< What may stand before the last digit,
    std::uint32_t last_digit; ///< and that digit behind the limit itself.
};

constexpr Base BaseOf(const std::uint32_t base) noexcept
{
    return Base{base, kMost / base, static_cast<std::uint32_t>(kMost % base)};
}

constexpr Base kOctal = BaseOf(8U);
constexpr Base kDecimal = BaseOf(10U);
constexpr Base kHexadecimal = BaseOf(16U);

/// As many digits as there are.
Number Digits(const Bytes& text, const Base& base) noexcept
{
    Number number{true, 0U, 0U};
    std::uint32_t digit = 0U;
    while (number.is_right && (digit != kNoDigit) && (number.used_bytes < text.size_bytes))
    {
        digit = DigitOf(text.data[number.used_bytes], base.base);
        if (digit != kNoDigit)
        {
            const bool is_at_limit = number.value == base.limit;
            number.is_right = (number.value < base.limit) || (is_at_limit && (digit <= base.last_digit));
            number.value = (number.value * base.base) + digit;
            ++number.used_bytes;
        }
    }
    number.is_right = number.is_right && (number.used_bytes > 0U);
    return number;
}

/// 0x: hexadecimal; 0: octal; else decimal.
Number Constant(const Bytes& text) noexcept
{
    const bool is_hex = Begins(text, "0x", 2U);
    const bool is_octal = !is_hex && (text.size_bytes > 1U) && (text.data[0] == '0');
    const std::uint32_t prefix = is_hex ? 2U : 0U;
    Number number = Digits(From(text, prefix), is_hex ? kHexadecimal : (is_octal ? kOctal : kDecimal));
    number.used_bytes += prefix;
    number.is_right = number.is_right && (number.used_bytes == text.size_bytes);
    return number;
}

/// Also `$NODEID`, before or behind a plus.
Number Value(const Bytes& text, const NodeId node) noexcept
{
    constexpr std::uint32_t kWord = 7U;
    const std::uint32_t plus = Up(text, '+');
    const Bytes first = Trimmed(Bytes{text.data, plus});
    const bool has_second = (plus < text.size_bytes);
    const Bytes second = has_second ? Trimmed(From(text, plus + 1U)) : Bytes{text.data, 0U};
    const bool is_first = Is(first, "$nodeid", kWord);
    const bool is_second = Is(second, "$nodeid", kWord);
    const Bytes& other = is_first ? second : first;
    Number number{true, 0U, 0U};
    if (!is_first || has_second)
    {
        number = Constant(other);
    }
    const bool is_one = (is_first || is_second) ? (is_first != is_second) : !has_second;
    number.value += (is_first || is_second) ? node.value : 0U;
    number.is_right = number.is_right && is_one;
    return number;
}

/// A number that fits into its type, negative ones as two's complement.
Number Fitting(const Bytes& text, const std::uint32_t size_bytes, const NodeId node) noexcept
{
    const bool is_negative = (text.size_bytes > 0U) && (text.data[0] == '-');
    Number number = is_negative ? Constant(From(text, 1U)) : Value(text, node);
    const std::uint32_t bits = 8U * size_bytes;
    const std::uint64_t most = (bits < 64U) ? ((std::uint64_t{1U} << bits) - 1U) : kMost;
    const std::uint64_t limit = is_negative ? ((most / 2U) + 1U) : most;
    number.is_right = number.is_right && (number.value <= limit);
    number.value = is_negative ? ((0U - number.value) & most) : number.value;
    return number;
}

/// [1018] or [1018sub1]; every other section is no object.
Section SectionOf(const Bytes& name) noexcept
{
    constexpr std::uint32_t kLastIndex = 0xFFFFU;
    constexpr std::uint32_t kLastSub = 0xFFU;
    Section section{};
    const Number index = Digits(name, kHexadecimal);
    const Bytes rest = From(name, index.used_bytes);
    const bool has_sub = Begins(rest, "sub", 3U);
    const Bytes digits = has_sub ? From(rest, 3U) : rest;
    const Number sub = Digits(digits, kHexadecimal);
    const bool is_sub = has_sub && sub.is_right && (sub.used_bytes == digits.size_bytes) && (sub.value <= kLastSub);
    section.is_object = index.is_right && (index.value <= kLastIndex) && (is_sub || (rest.size_bytes == 0U));
    section.object =
        ObjectAddress{static_cast<std::uint16_t>(index.value), static_cast<std::uint8_t>(is_sub ? sub.value : 0U)};
    return section;
}

void TakeLine(Section& section, const Bytes& line) noexcept
{
    const std::uint32_t equals = Up(line, '=');
    if (equals < line.size_bytes)
    {
        const Bytes key = Trimmed(Bytes{line.data, equals});
        const Bytes value = Trimmed(From(line, equals + 1U));
        section.type = Is(key, "datatype", 8U) ? value : section.type;
        section.access = Is(key, "accesstype", 10U) ? value : section.access;
        section.value = Is(key, "parametervalue", 14U) ? value : section.value;
        section.flags = Is(key, "objflags", 8U) ? value : section.flags;
    }
}

bool IsWritten(const Section& section) noexcept
{
    const bool is_writable = Is(section.access, "rw", 2U) || Is(section.access, "rww", 3U) ||
                             Is(section.access, "rwr", 3U) || Is(section.access, "wo", 2U);
    constexpr std::uint64_t kRefuseWrite = 1U;
    const Number flags = Constant(section.flags);
    const bool is_refused = flags.is_right && ((flags.value & kRefuseWrite) != 0U);
    return section.is_object && is_writable && !is_refused && (section.value.size_bytes > 0U);
}

TextReading ReadingOf(const Section& section, const NodeId node) noexcept
{
    TextReading reading{TextState::kMalformed, section.object, 0U, 0U, nullptr, 0U};
    const Number type = Constant(section.type);
    const bool is_known = type.is_right && (type.value < kTypes);
    const std::uint8_t size = is_known ? kSizes[type.value] : std::uint8_t{0U};
    if (is_known && (type.value == kVisibleString))
    {
        reading.state = TextState::kEntry;
        reading.text = section.value.data;
        reading.size_bytes = section.value.size_bytes;
    }
    else if (size > 0U)
    {
        const Number number = Fitting(section.value, size, node);
        reading.state = number.is_right ? TextState::kEntry : TextState::kMalformed;
        reading.number = number.value;
        reading.size_bytes = size;
    }
    return reading;
}

} // namespace

TextReading ReadTextDcf(const Bytes& dcf, const std::uint32_t offset, const NodeId node) noexcept
{
    Section section{};
    std::uint32_t at = offset;
    bool is_found = false;
    while (!is_found && (at < dcf.size_bytes))
    {
        const Bytes rest = From(dcf, at);
        const std::uint32_t length = Up(rest, '\n');
        const Bytes line = Trimmed(Bytes{rest.data, length});
        const bool is_head = (line.size_bytes > 1U) && (line.data[0] == '[');
        is_found = is_head && IsWritten(section); // A section ends where the next one begins.
        if (is_head && !is_found)
        {
            section = SectionOf(Bytes{&line.data[1], Up(line, ']') - 1U});
        }
        else if (!is_head && (line.size_bytes > 0U) && (line.data[0] != ';'))
        {
            TakeLine(section, line);
        }
        const std::uint32_t end = at + length;
        at = is_found ? at : ((end < dcf.size_bytes) ? (end + 1U) : end);
    }
    TextReading reading{TextState::kEnd, ObjectAddress{0U, 0U}, 0U, 0U, nullptr, at};
    if (IsWritten(section))
    {
        reading = ReadingOf(section, node);
        reading.next = at;
    }
    return reading;
}

} // namespace counterpoint::cia302
