// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/object_value.hpp"

#include "canopen/cia301/dictionary/entry_value.hpp"
#include "canopen/cia306/safety/signature.hpp"
#include "canopen/cia306/text/input_error.hpp"
#include "runtime/node/number.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <vector>

namespace counterpoint::runtime
{
namespace
{
using cia301::DataType;
using cia301::SdoAbort;
using Octets = std::vector<std::uint8_t>;

constexpr std::size_t kMostShown = 256U;
constexpr std::uint32_t kReplacement = 0xFFFDU;

/// Of one that the kernel has the file tells the type.
DataType TypeOf(const cia306::Device& file, const cia301::Entry* const entry, const ObjectAddress& object)
{
    const cia306::Entry* const source = file.Find(object.index, object.sub);
    if (entry != nullptr)
    {
        return entry->type;
    }
    const bool is_real = source != nullptr && source->type.kind == cia306::DataKind::kReal;
    return is_real ? static_cast<DataType>(source->data_type) : DataType::kUnsigned64;
}

void AppendUtf8(std::string& text, const std::uint32_t point)
{
    constexpr std::uint32_t kOneByte = 0x80U;
    if (point < kOneByte)
    {
        text += static_cast<char>(point);
        return;
    }
    const int further = (point < 0x800U) ? 1 : (point < 0x10000U ? 2 : 3);
    const std::array<std::uint32_t, 4U> heads{0U, 0xC0U, 0xE0U, 0xF0U};
    text += static_cast<char>(heads.at(static_cast<std::size_t>(further)) | (point >> (6 * further)));
    for (int rest = further - 1; rest >= 0; --rest)
    {
        text += static_cast<char>(0x80U | ((point >> (6 * rest)) & 0x3FU));
    }
}

/// UTF-16, low byte first; half a pair is told as a character that nobody knows, half a character is left out.
std::string Utf8Of(const Octets& bytes)
{
    std::string text;
    std::uint32_t first = 0U; // Of a pair that is not complete.
    for (std::size_t at = 0U; at + 1U < bytes.size(); at += 2U)
    {
        const std::uint32_t unit = bytes[at] | (std::uint32_t{bytes[at + 1U]} << 8U);
        const bool is_second = (unit & 0xFC00U) == 0xDC00U;
        if (is_second && first != 0U)
        {
            AppendUtf8(text, 0x10000U + ((first & 0x3FFU) << 10U) + (unit & 0x3FFU));
            first = 0U;
            continue;
        }
        if (first != 0U)
        {
            AppendUtf8(text, kReplacement);
        }
        first = ((unit & 0xFC00U) == 0xD800U) ? unit : 0U;
        if (first == 0U)
        {
            AppendUtf8(text, is_second ? kReplacement : unit);
        }
    }
    if (first != 0U)
    {
        AppendUtf8(text, kReplacement);
    }
    return text;
}

ObjectValue StringOf(const cia301::Entry& entry)
{
    Octets bytes(entry.size_bytes);
    const cia301::Reading reading = cia301::ReadEntry(entry, {bytes.data(), entry.size_bytes});
    if (reading.abort != SdoAbort::kNone)
    {
        return {reading.abort, "", {}};
    }
    bytes.resize(std::min<std::size_t>(reading.size_bytes, kMostShown));
    const std::string size = std::to_string(reading.size_bytes) + " bytes";
    const bool is_cut = bytes.size() < reading.size_bytes;
    const bool is_wide = entry.type == DataType::kUnicodeString;
    if (is_wide || entry.type == DataType::kVisibleString)
    {
        const std::string text = is_wide ? Utf8Of(bytes) : std::string(bytes.begin(), bytes.end());
        return {SdoAbort::kNone,
                "'" + cia306::Printable(text) + "'" + (is_cut ? " and more, " + size : ""),
                {{"value", text}, {"size_bytes", reading.size_bytes}}};
    }
    const std::string text = cia306::HexBytes(bytes);
    return {SdoAbort::kNone,
            size + (bytes.empty() ? "" : ": " + text) + (is_cut ? " and more" : ""),
            {{"value", text}, {"size_bytes", reading.size_bytes}}};
}

/// The shortest text that is this number.
template <typename Real, typename Bits> ObjectValue RealOf(const std::uint64_t pattern)
{
    const Bits bits = static_cast<Bits>(pattern);
    Real value{};
    std::memcpy(&value, &bits, sizeof(value));
    std::array<char, 32U> room{};
    const std::string text(room.data(), std::to_chars(room.data(), room.data() + room.size(), value).ptr);
    const bool is_number = std::isfinite(value);
    return {SdoAbort::kNone,
            text,
            {{"value",
              is_number ? nlohmann::ordered_json(std::strtod(text.c_str(), nullptr)) : nlohmann::ordered_json(text)}}};
}
} // namespace

ObjectValue ValueOf(const cia306::Device& file, cia301::Dictionary& dictionary, const ObjectAddress& object)
{
    const cia301::Entry* const entry = dictionary.Find(object);
    const DataType type = TypeOf(file, entry, object);
    const std::array<DataType, 4U> strings{DataType::kVisibleString, DataType::kOctetString, DataType::kUnicodeString,
                                           DataType::kDomain};
    if (std::find(strings.begin(), strings.end(), type) != strings.end())
    {
        return StringOf(*entry);
    }
    const cia301::NumberReading reading = dictionary.ReadNumber(object);
    if (reading.abort != SdoAbort::kNone)
    {
        return {reading.abort, "", {}};
    }
    if (type == DataType::kReal32)
    {
        return RealOf<float, std::uint32_t>(reading.value);
    }
    if (type == DataType::kReal64)
    {
        return RealOf<double, std::uint64_t>(reading.value);
    }
    const NumberForm form = FormOf(file, dictionary, object);
    return {SdoAbort::kNone, NumberText(form, reading.value), {{"value", NumberJson(form, reading.value)}}};
}
} // namespace counterpoint::runtime
