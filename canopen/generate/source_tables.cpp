// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/file/saved.hpp"
#include "canopen/generate/text.hpp"

namespace counterpoint::generate
{
namespace
{
std::string MemoryText(const Layout& layout)
{
    std::string bytes;
    std::string lengths;
    for (const std::size_t place : layout.memory_order)
    {
        const Element& element = layout.elements[place];
        std::vector<std::uint8_t> value = element.value;
        value.resize(element.size_bytes, 0U);
        bytes += "        " + ByteList(value) + "// " + AddressName(*element.entry) + "\n";
        lengths += element.is_text ? UnsignedLiteral(element.value.size()) + ", " : "";
    }
    const std::string byte_count = UnsignedLiteral(layout.stored_bytes == 0U ? 1U : layout.stored_bytes);
    const std::string length_count = UnsignedLiteral(layout.length_count == 0U ? 1U : layout.length_count);
    return "/// Values in little-endian order, and the lengths of strings.\nstruct Storage\n{\n    std::uint8_t "
           "bytes[" +
           byte_count + "];\n    std::uint32_t lengths[" + length_count +
           "];\n};\n\nconstexpr Storage kPowerOn{\n    {\n" + (bytes.empty() ? "        0U,\n" : bytes) +
           "    },\n    {" + (lengths.empty() ? "0U" : lengths) + "}};\n\nStorage storage = kPowerOn;\n\n";
}

std::string ConstantsText(const Layout& layout)
{
    std::string bytes;
    std::string table;
    std::size_t count = 0U;
    for (const Element& element : layout.elements)
    {
        if (element.home != Home::kConstant)
        {
            continue;
        }
        const cia306::Entry& entry = *element.entry;
        bytes += "    " + ByteList(element.value) + "// " + AddressName(entry) + "\n";
        table += "    {{" + HexLiteral(entry.index, 4) + ", " + HexLiteral(entry.sub, 2) + "}, " +
                 UnsignedLiteral(element.size_bytes) + ", kConstantBytes + " + UnsignedLiteral(element.offset) + "},\n";
        ++count;
    }
    if (count == 0U)
    {
        return "";
    }
    const std::string end = layout.constant_bytes == 0U ? "    0U,\n" : "";
    return "constexpr std::uint8_t kConstantBytes[]{\n" + bytes + end +
           "};\n\nconstexpr counterpoint::generated::ConstantValue kConstantValues[]{\n" + table +
           "};\n\ncounterpoint::generated::ConstantObjects constants{counterpoint::generated::ConstantTable{"
           "kConstantValues, " +
           UnsignedLiteral(count) + "}};\n\n";
}

std::string LimitsText(const Layout& layout)
{
    std::string text;
    for (const Element& element : layout.elements)
    {
        const bool is_limited = element.limits && !element.IsVariable();
        text += is_limited ? "    {" + HexLiteral(element.limits->low, 1) + ", " + HexLiteral(element.limits->high, 1) +
                                 "}, // " + AddressName(*element.entry) + "\n"
                           : "";
    }
    return text.empty() ? "" : "constexpr counterpoint::cia301::ValueLimits kLimits[]{\n" + text + "};\n\n";
}

/// Place, length, limits and hooks of an entry.
std::string Rest(const Element& element, std::size_t& limit_count)
{
    std::string limits = "nullptr";
    if (element.limits)
    {
        limits = "kLimits + " + UnsignedLiteral(limit_count);
        ++limit_count;
    }
    if (element.home == Home::kConstant)
    {
        return "nullptr, nullptr, " + limits + ", &constants, &constants";
    }
    if (element.home == Home::kNowhere)
    {
        return "nullptr, &domain_length, nullptr, &objects, &objects";
    }
    const std::string length = element.is_text ? "storage.lengths + " + UnsignedLiteral(element.length) : "nullptr";
    return "storage.bytes + " + UnsignedLiteral(element.offset) + ", " + length + ", " + limits +
           ", &objects, &objects";
}

/// Where the bus may write an entry. [SRS_STO_008]
std::string StatesText(const std::uint16_t index)
{
    return cia306::IsStoreCommand(index) ? "kInPreOperational" : "kInBoth";
}

/// Into which PDOs an entry may be mapped, and whether a save keeps it; nothing where none of it. [SRS_GEN_330]
std::string UsesText(const Element& element)
{
    const cia306::Entry& entry = *element.entry;
    std::string text;
    const auto add = [&text](const bool is_used, const char* const word)
    { text += is_used ? (text.empty() ? ", " : " | ") + std::string(word) : ""; };
    add(entry.IsInTpdo(), "kInTpdo");
    add(entry.IsInRpdo(), "kInRpdo");
    add(cia306::IsSaved(entry) && element.home == Home::kStored, "kStored");
    return text;
}

/// What a store has to know of values with $NODEID. [SRS_GEN_331]
std::string NodeValuesText(const Layout& layout)
{
    std::string values;
    std::size_t number = 0U;
    std::size_t count = 0U;
    for (const Element& element : layout.elements)
    {
        if (element.IsVariable())
        {
            continue;
        }
        if (element.node_addend)
        {
            values += "    {" + UnsignedLiteral(number) + ", " + UnsignedLiteral(*element.node_addend) + "}, // " +
                      AddressName(*element.entry) + "\n";
            ++count;
        }
        ++number;
    }
    const std::string table =
        values.empty() ? "" : "constexpr counterpoint::generated::NodeValue kNodeValues[]{\n" + values + "};\n\n";
    return "counterpoint::cia301::NodeId node_now{kNodeId};\n\n" + table +
           "constexpr counterpoint::generated::NodeValues node_values{counterpoint::generated::NodeValueTable{" +
           (values.empty() ? "nullptr" : "kNodeValues") + ", " + UnsignedLiteral(count) + "}, node_now};\n\n";
}

std::string EntriesText(const Layout& layout)
{
    std::string text;
    std::size_t limit_count = 0U;
    bool has_domain = false;
    for (const Element& element : layout.elements)
    {
        if (element.IsVariable())
        {
            continue;
        }
        const cia306::Entry& entry = *element.entry;
        const bool is_domain = element.home == Home::kNowhere;
        has_domain = has_domain || is_domain;
        text += "    // " + Describe(element) + "\n    {" + HexLiteral(entry.index, 4) + ", " +
                HexLiteral(entry.sub, 2) + ", DataType::" + TableTypeOf(entry) + ", Access::" + TableAccessOf(element) +
                ", kInBoth, " + StatesText(entry.index) + ", " +
                (is_domain ? "kAnyLength" : UnsignedLiteral(element.size_bytes)) + ", " + Rest(element, limit_count) +
                UsesText(element) + "},\n";
    }
    const std::string domain =
        "// A DOMAIN has no value here, and may have any length.\n"
        "constexpr std::uint32_t kAnyLength = 0xFFFFFFFEU;\nstd::uint32_t domain_length = 0U;\n\n";
    return (has_domain ? domain : "") +
           "extern const counterpoint::cia301::Entry kEntries[];\n\n"
           "counterpoint::generated::StoredObjects objects{counterpoint::cia301::EntryTable{kEntries, "
           "kEntryCount}};\n\n"
           "using counterpoint::cia301::Access;\nusing counterpoint::cia301::DataType;\n"
           "using counterpoint::cia301::kInBoth;\nusing counterpoint::cia301::kInPreOperational;\n"
           "using counterpoint::cia301::kInRpdo;\n"
           "using counterpoint::cia301::kInTpdo;\nusing counterpoint::cia301::kStored;\n\n"
           "constexpr counterpoint::cia301::Entry kEntries[]{\n" +
           text + "};\n\n";
}
} // namespace

std::string TableText(const Layout& layout)
{
    return MemoryText(layout) + ConstantsText(layout) + LimitsText(layout) + EntriesText(layout) +
           NodeValuesText(layout);
}
} // namespace counterpoint::generate
