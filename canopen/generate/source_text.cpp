// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/generate/text.hpp"

namespace counterpoint::generate
{
namespace
{
using cia306::DataKind;

/// The body that reads a number.
std::string ReadText(const Element& element)
{
    const cia306::DataType& type = element.entry->type;
    const std::string place = PlaceText(element);
    const std::string bits = "counterpoint::ReadVariable(" + place + ").bits";
    if (type.kind == DataKind::kBoolean)
    {
        return bits + " != 0U";
    }
    if (type.kind == DataKind::kReal)
    {
        return "counterpoint::generated::ReadReal" + std::to_string(type.bits) + "(" + place + ")";
    }
    const bool is_signed = type.kind == DataKind::kSigned;
    const std::string value = is_signed ? "counterpoint::generated::ReadSigned(" + place + ")" : bits;
    return type.bits > 32U ? value : "static_cast<" + CppTypeOf(type) + ">(" + value + ")";
}

std::string WriteText(const Element& element)
{
    const cia306::DataType& type = element.entry->type;
    const std::string place = PlaceText(element);
    if (type.kind == DataKind::kSigned)
    {
        return "counterpoint::generated::WriteSigned(" + place + ", value)";
    }
    if (type.kind == DataKind::kReal)
    {
        return "counterpoint::generated::WriteReal" + std::to_string(type.bits) + "(" + place + ", value)";
    }
    const std::string bits = type.kind == DataKind::kBoolean ? "value ? 1U : 0U" : "value";
    return "counterpoint::WriteVariable(" + place + ", counterpoint::VariableValue{" + bits + "})";
}

std::string Function(const std::string& head, const std::string& body)
{
    return head + " noexcept\n{\n    " + body + "\n}\n\n";
}

std::string StringAccess(const Element& element)
{
    const std::string bytes = "storage.bytes + " + UnsignedLiteral(element.offset);
    const std::string length = "storage.lengths[" + UnsignedLiteral(element.length) + "]";
    return Function("counterpoint::cia301::Bytes Get" + element.name + "()",
                    "return counterpoint::cia301::Bytes{" + bytes + ", " + length + "};") +
           Function("bool Set" + element.name + "(const counterpoint::cia301::Bytes& value)",
                    "return SetText(counterpoint::cia301::Room{" + bytes + ", " + UnsignedLiteral(element.size_bytes) +
                        "}, " + length + ", value);");
}

std::string NumberAccess(const Layout& layout, const Element& element)
{
    const std::string type = CppTypeOf(element.entry->type);
    std::string text = Function(type + " " + GetterName(element) + "()", "return " + ReadText(element) + ";");
    if (HasSetter(element))
    {
        text += Function("void Set" + element.name + "(const " + type + " value)", WriteText(element) + ";");
    }
    if (element.inverse)
    {
        text += Function("counterpoint::PairView Compare" + element.name + "()",
                         "return counterpoint::IsInversePair(" + PlaceText(element) + ", " +
                             PlaceText(layout.elements[*element.inverse]) + ");");
    }
    if (HasCheckedGetter(element))
    {
        const std::string slot = "kSrdo" + std::to_string(element.safe_read->srdo) + "Slot";
        text += Function(type + " Get" + element.name + "(const counterpoint::SrdoMask released)",
                         "const bool is_released = ((released >> " + slot +
                             ") & 1U) != 0U;\n"
                             "    const bool is_whole = Compare" +
                             element.name +
                             "() == counterpoint::PairView::kInverse;\n"
                             "    return (is_released && is_whole) ? " +
                             GetterName(element) + "() : static_cast<" + type + ">(" + SafeLiteral(element) + ");");
    }
    return text;
}

constexpr const char* kCopy =
    "/// Values of power-on for the first bytes and lengths.\n"
    "void Restore(const std::uint32_t byte_count, const std::uint32_t length_count) noexcept\n{\n"
    "    for (std::uint32_t i = 0U; i < byte_count; ++i)\n    {\n        storage.bytes[i] = kPowerOn.bytes[i];\n    }\n"
    "    for (std::uint32_t i = 0U; i < length_count; ++i)\n    {\n        storage.lengths[i] = kPowerOn.lengths[i];\n"
    "    }\n}\n\n";

constexpr const char* kSetText = "bool SetText(const counterpoint::cia301::Room& room, std::uint32_t& length,\n"
                                 "             const counterpoint::cia301::Bytes& value) noexcept\n{\n"
                                 "    const bool fits = value.size_bytes <= room.size_bytes;\n"
                                 "    for (std::uint32_t i = 0U; fits && (i < value.size_bytes); ++i)\n    {\n"
                                 "        room.data[i] = value.data[i];\n    }\n"
                                 "    length = fits ? value.size_bytes : length;\n    return fits;\n}\n\n";

/// A function of the generated file and its call; both empty where there is nothing to do.
struct NodeIdWrites
{
    std::string function;
    std::string call;
};

/// One write for each value that has the node-ID in it: those of 1000h to 1FFFh, or all others. [SRS_GEN_150]
NodeIdWrites WritesOf(const Layout& layout, const bool is_communication)
{
    const std::string name = is_communication ? "FollowNodeIdInCommunication" : "FollowNodeIdElsewhere";
    std::string text;
    for (const Element& element : layout.elements)
    {
        const bool has_formula = element.node_addend && element.IsInMemory();
        if (has_formula && ((element.offset < layout.communication_bytes) == is_communication))
        {
            text += "\n    counterpoint::WriteVariable(" + PlaceText(element) + ", counterpoint::VariableValue{" +
                    UnsignedLiteral(*element.node_addend) + " + number});";
        }
    }
    const std::string number = "const std::uint64_t number = device_now->node_id;";
    return text.empty() ? NodeIdWrites{} : NodeIdWrites{Function("void " + name + "()", number + text), name + "();"};
}

/// Values of power-on for a node-ID that may be another one than the file's.
std::string ResetText(const Layout& layout)
{
    const std::string all = UnsignedLiteral(layout.stored_bytes) + ", " + UnsignedLiteral(layout.length_count);
    const std::string communication =
        UnsignedLiteral(layout.communication_bytes) + ", " + UnsignedLiteral(layout.communication_lengths);
    const NodeIdWrites of_communication = WritesOf(layout, true);
    const NodeIdWrites of_others = WritesOf(layout, false);
    const auto then = [](const NodeIdWrites& writes) { return writes.call.empty() ? "" : "\n    " + writes.call; };
    const std::string functions = of_communication.function + of_others.function;
    const std::string follow = then(of_communication) + then(of_others);
    return (functions.empty() ? "" : "namespace\n{\n\n" + functions + "} // namespace\n\n") +
           Function("void ResetApplication()", "Restore(" + all + ");" + follow) +
           Function("void ResetCommunication()", "Restore(" + communication + ");" + then(of_communication)) +
           Function("void ApplyNodeId(const std::uint8_t node_id)", "DescribeNode(node_id);" + follow);
}

std::string PublicText(const FileText& file)
{
    return "constexpr counterpoint::cia301::EntryTable kEntryTable{kEntries, kEntryCount};\n"
           "static_assert(counterpoint::cia301::IsUsable(kEntryTable), \"ordered, nothing of the kernel\");\n\n" +
           Function("counterpoint::generated::StoredObjects& Objects()", "return objects;") +
           Function("counterpoint::generated::ConfigureReply Configure(counterpoint::Kernel& kernel)",
                    "return counterpoint::generated::Configure(kernel, kConfiguration, device_now->node_id);") +
           Function("const counterpoint::DeviceConfig& Device()", "return *device_now;") +
           Function("const counterpoint::cia301::NodeId& NodeNow()", "return node_now;") +
           Function("const counterpoint::cia301::NodeDefaults& DefaultsOfNode()", "return node_values;") +
           ResetText(file.layout);
}
} // namespace

std::string SourceText(const FileText& file)
{
    const Layout& layout = file.layout;
    std::string access;
    bool has_strings = false;
    for (const Element& element : layout.elements)
    {
        if (element.IsInMemory())
        {
            access += element.is_text ? StringAccess(element) : NumberAccess(layout, element);
            has_strings = has_strings || element.is_text;
        }
    }
    return "//" + file.origin + "\n// clang-format off\n#include \"" + kHeaderName +
           "\"\n\n#include \"canopen/generated/constant_objects.hpp\"\n#include "
           "\"canopen/generated/node_values.hpp\"\n#include \"canopen/generated/numbers.hpp\"\n"
           "#include \"safety_core/kernel/variable.hpp\"\n\nnamespace " +
           file.name_space + "\n{\nnamespace\n{\n\n" + TableText(layout) + KernelText(file) + kCopy +
           (has_strings ? kSetText : "") + "} // namespace\n\n" + DeviceText(file) + PublicText(file) + access +
           "} // namespace " + file.name_space + "\n";
}
} // namespace counterpoint::generate
