// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/generate/text.hpp"

#include "canopen/cia306/text/input_error.hpp"

namespace counterpoint::generate
{
namespace
{
std::string GuardOf(const std::string& name_space)
{
    std::string guard;
    for (const char character : name_space)
    {
        const bool is_small = character >= 'a'; // A namespace has letters, digits, '_' and ':' alone.
        const bool is_gap = character == ':';
        const bool is_second = is_gap && guard.back() == '_';
        guard +=
            is_second
                ? ""
                : std::string(1U, is_gap ? '_' : (is_small ? static_cast<char>(character - 'a' + 'A') : character));
    }
    return guard + "_OBJECT_DICTIONARY_HPP";
}

/// A constant as its type holds it.
std::string ConstantLiteral(const Element& element)
{
    std::uint64_t bits = 0U;
    for (std::size_t place = element.value.size(); place != 0U; --place)
    {
        bits = (bits << 8U) | element.value[place - 1U];
    }
    return BitsLiteral(element.entry->type, bits);
}

/// Of a variable that a consumer of the file maps: its value, or its safe value.
std::string CheckedDeclaration(const Element& element)
{
    return "/// As above while SRDO " + std::to_string(element.safe_read->srdo) + " (bit kSrdo" +
           std::to_string(element.safe_read->srdo) +
           "Slot of `released`: what the output gate lets through, or the slots in SrdoState::kReleased)\n"
           "/// is released and the pair is inverse; else its part of the safe value, " +
           SafeLiteral(element) + ".\n[[nodiscard]] " + CppTypeOf(element.entry->type) + " Get" + element.name +
           "(counterpoint::SrdoMask released) noexcept;\n";
}

std::string ConstantDeclaration(const Element& element)
{
    const bool is_real = element.entry->type.kind == cia306::DataKind::kReal;
    if (!IsNumber(element) || is_real || element.is_counter)
    {
        return "";
    }
    return "constexpr " + CppTypeOf(element.entry->type) + " k" + element.name + " = " + ConstantLiteral(element) +
           "; ///< " + Describe(element) + "\n";
}

std::string AccessDeclaration(const Element& element)
{
    const bool is_number = IsNumber(element);
    const std::string type = is_number ? CppTypeOf(element.entry->type) : "counterpoint::cia301::Bytes";
    std::string text = "/// " + Describe(element);
    text += element.home == Home::kProduced ? "; the application writes it for its SRDO\n" : "";
    text += element.home == Home::kConsumed ? "; the channels write it\n" : "";
    text += element.IsVariable() ? "" : "\n";
    text += "[[nodiscard]] " + type + " " + GetterName(element) + "() noexcept;\n";
    text += HasCheckedGetter(element) ? CheckedDeclaration(element) : "";
    if (HasSetter(element) && is_number)
    {
        text += "void Set" + element.name + "(" + type + " value) noexcept;\n";
    }
    else if (HasSetter(element))
    {
        text += "/// False, and nothing is changed, where it is longer than " + std::to_string(element.size_bytes) +
                " bytes.\n[[nodiscard]] bool Set" + element.name + "(const " + type + "& value) noexcept;\n";
    }
    if (element.inverse)
    {
        text +=
            "/// Whether each bit is inverted in its inverse object.\n[[nodiscard]] counterpoint::PairView Compare" +
            element.name + "() noexcept;\n";
    }
    return text + "\n";
}

std::string SrdoConstants(const Layout& layout)
{
    std::string text;
    std::size_t slot = 0U;
    for (const cia306::SrdoConfiguration& srdo : layout.safety.Srdos())
    {
        const std::string number = std::to_string(srdo.number);
        const std::string kind = srdo.IsProducer() ? "producer" : (srdo.IsConsumer() ? "consumer" : "off");
        text += "/// SRDO " + number + ": " + kind + ", COB-IDs " + cia306::Hex(srdo.cob_id_1.value.value_or(0U), 3) +
                " and " + cia306::Hex(srdo.cob_id_2.value.value_or(0U), 3) +
                (srdo.is_static ? ", static mapping" : "") + "\nconstexpr counterpoint::CommunicationIndex kSrdo" +
                number + "{" + HexLiteral(srdo.CommunicationIndex(), 4) +
                "};\nconstexpr counterpoint::SlotIndex kSrdo" + number + "Slot = " + UnsignedLiteral(slot) + ";\n";
        ++slot;
    }
    return text + (text.empty() ? "" : "\n");
}

std::string Opening(const FileText& file)
{
    const Layout& layout = file.layout;
    return "//" + file.origin + "\n// clang-format off\n#ifndef " + GuardOf(file.name_space) + "\n#define " +
           GuardOf(file.name_space) +
           "\n\n#include \"canopen/cia301/dictionary/dictionary.hpp\"\n#include "
           "\"canopen/cia301/nmt/slave.hpp\"\n#include \"canopen/cia301/store/node_defaults.hpp\"\n#include "
           "\"canopen/generated/configuration.hpp\"\n"
           "#include \"canopen/generated/stored_objects.hpp\"\n#include \"safety_core/kernel/kernel.hpp\"\n\n"
           "#include <cstdint>\n\nnamespace " +
           file.name_space + "\n{\n\nconstexpr std::uint8_t kNodeId = " + UnsignedLiteral(file.node_id.value_or(0U)) +
           "; ///< 0: the file has none.\nconstexpr std::uint8_t kSrdoCount = " +
           UnsignedLiteral(layout.safety.Srdos().size()) + "; ///< Slots that a channel's storage needs.\n" +
           "constexpr std::uint8_t kMapEntries = " + UnsignedLiteral(layout.safety.Parameters().map_entries) +
           "; ///< Map entries that a channel's storage needs.\n" +
           "constexpr std::uint32_t kLongestObjectBytes = " + UnsignedLiteral(layout.longest_bytes) +
           "; ///< Buffer that an SDO server needs; a DOMAIN not counted.\n" +
           "constexpr std::uint32_t kEntryCount = " + UnsignedLiteral(layout.entry_count) + ";\n\n" +
           SrdoConstants(layout);
}

constexpr const char* kTables =
    "/// For cia301::Dictionary: all but what the kernel serves.\n"
    "extern const counterpoint::cia301::EntryTable kEntryTable;\n"
    "/// For Kernel::Start, with kNodeId.\n"
    "extern const counterpoint::DeviceConfig kDevice;\n"
    "/// For Kernel::Start: kDevice, or that with the node-ID of ApplyNodeId.\n"
    "[[nodiscard]] const counterpoint::DeviceConfig& Device() noexcept;\n\n"
    "/// For cia301::StoredSafety: the node-ID of Device().\n"
    "[[nodiscard]] const counterpoint::cia301::NodeId& NodeNow() noexcept;\n"
    "/// For cia301::StoredEntries over kEntryTable: which values are those of this node-ID.\n"
    "[[nodiscard]] const counterpoint::cia301::NodeDefaults& DefaultsOfNode() noexcept;\n\n"
    "/// Hooks of services and application.\n"
    "[[nodiscard]] counterpoint::generated::StoredObjects& Objects() noexcept;\n"
    "/// Writes the safety configuration to a started kernel; the first refusal ends it.\n"
    "[[nodiscard]] counterpoint::generated::ConfigureReply Configure(counterpoint::Kernel& kernel) noexcept;\n"
    "/// Values of power-on, for the node-ID of Device: everything; 1000h to 1FFFh. They are there at the start of\n"
    "/// the program, too.\n"
    "void ResetApplication() noexcept;\n"
    "void ResetCommunication() noexcept;\n"
    "/// Another node-ID than kNodeId, 1 to 127: Device, Configure and values with $NODEID follow, these at each\n"
    "/// reset, too. Not while a kernel runs by Device.\n"
    "void ApplyNodeId(std::uint8_t node_id) noexcept;\n\n";
} // namespace

std::string HeaderText(const FileText& file)
{
    std::string text = Opening(file) + kTables;
    std::string constants;
    std::string access;
    for (const Element& element : file.layout.elements)
    {
        constants += element.home == Home::kConstant ? ConstantDeclaration(element) : "";
        access += element.IsInMemory() ? AccessDeclaration(element) : "";
    }
    text += constants + (constants.empty() ? "" : "\n") + access;
    return text + "} // namespace " + file.name_space + "\n\n#endif\n";
}
} // namespace counterpoint::generate
