// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/file/limits.hpp"

#include "canopen/cia306/file/data_type.hpp"
#include "canopen/cia306/file/entry_reader.hpp"
#include "canopen/cia306/file/value.hpp"

#include <string>

namespace counterpoint::cia306
{
namespace
{
/// A number in whose order the values of the type stand; nothing for types without an order.
std::optional<std::uint64_t> OrderOf(const std::uint64_t bits, const DataType& type)
{
    const std::uint64_t sign = type.bits == 0U ? 0U : std::uint64_t{1U} << (type.bits - 1U);
    const bool is_negative = (bits & sign) != 0U;
    switch (type.kind)
    {
    case DataKind::kBoolean:
    case DataKind::kUnsigned:
        return bits;
    case DataKind::kSigned:
        return bits ^ sign;
    case DataKind::kReal: // Sign and magnitude.
        return is_negative ? sign - (bits ^ sign) : bits + sign;
    case DataKind::kTime:
    case DataKind::kText:
    case DataKind::kStructure:
    case DataKind::kUnknown:
        break;
    }
    return std::nullopt;
}

/// What the file gives an object, in the order of its values.
struct Ordered
{
    std::optional<std::uint64_t> value;
    std::optional<std::uint64_t> low;
    std::optional<std::uint64_t> high;
};

Ordered OrderedOf(const Entry& entry, const std::optional<std::uint8_t> node_id)
{
    const auto number = [&entry, node_id](const Text& text) -> std::optional<std::uint64_t>
    {
        const ValueResult result = text.IsSet() ? ParseValue(text.text, entry.type, node_id) : ValueResult{};
        return result.value ? OrderOf(result.value->bits, entry.type) : std::nullopt;
    };
    return {number(entry.Configured()), number(entry.low_limit), number(entry.high_limit)};
}

void TellOutside(const Severity severity, const Entry& entry, const Ordered& ordered, std::vector<Finding>& findings)
{
    const std::string name = ObjectName(entry.index, entry.sub);
    const std::string value = "value " + Quoted(entry.Configured().text) + ", expected at ";
    if (ordered.value && ordered.low && *ordered.value < *ordered.low)
    {
        findings.push_back(
            {severity, entry.ValuePlace(), name, value + "least the LowLimit " + Quoted(entry.low_limit.text)});
    }
    if (ordered.value && ordered.high && *ordered.value > *ordered.high)
    {
        findings.push_back(
            {severity, entry.ValuePlace(), name, value + "most the HighLimit " + Quoted(entry.high_limit.text)});
    }
}

/// A limit of a safety object that is no value of its type.
void TellNoLimit(const Entry& entry, const Text& limit, const std::optional<std::uint8_t> node_id,
                 std::vector<Finding>& findings)
{
    const ValueResult result = limit.IsSet() ? ParseValue(limit.text, entry.type, node_id) : ValueResult{Value{}, {}};
    if (!result.value)
    {
        findings.push_back({Severity::kError, limit.place, ObjectName(entry.index, entry.sub),
                            "limit: " + result.problem.wrong + ", expected " + result.problem.expected});
    }
}
} // namespace

void WarnOfLimits(const Entry& entry, const std::optional<std::uint8_t> node_id, std::vector<Finding>& warnings)
{
    const Ordered ordered = OrderedOf(entry, node_id);
    const bool is_integer = entry.type.kind == DataKind::kUnsigned || entry.type.kind == DataKind::kSigned;
    if (ordered.low && ordered.high && *ordered.low > *ordered.high)
    {
        warnings.push_back({Severity::kWarning, entry.low_limit.place, ObjectName(entry.index, entry.sub),
                            "LowLimit " + Quoted(entry.low_limit.text) + ", expected at most the HighLimit " +
                                Quoted(entry.high_limit.text) + " of line " +
                                std::to_string(entry.high_limit.place.line)});
    }
    else if (is_integer && !entry.is_safety)
    {
        TellOutside(Severity::kWarning, entry, ordered, warnings);
    }
}

std::vector<Finding> LimitProblems(const Device& device, const std::optional<std::uint8_t> node_id)
{
    std::vector<Finding> problems;
    for (const auto& [index, object] : device.objects)
    {
        for (const auto& [sub, entry] : object.entries)
        {
            const bool is_meant = entry.is_safety && entry.type.kind == DataKind::kUnsigned;
            const Ordered ordered = is_meant ? OrderedOf(entry, node_id) : Ordered{};
            if (ordered.value)
            {
                TellNoLimit(entry, entry.low_limit, node_id, problems);
                TellNoLimit(entry, entry.high_limit, node_id, problems);
                TellOutside(Severity::kError, entry, ordered, problems);
            }
        }
    }
    return problems;
}
} // namespace counterpoint::cia306
