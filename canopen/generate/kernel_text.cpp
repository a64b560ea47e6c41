// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/generate/text.hpp"

#include <algorithm>

namespace counterpoint::generate
{
namespace
{
constexpr std::uint32_t kMicrosecondsPerMillisecond = 1000U;
constexpr std::size_t kSignaturesALine = 8U;

const StaticFieldPlace* FieldOf(const Layout& layout, const std::uint8_t number)
{
    for (const StaticFieldPlace& field : layout.fields)
    {
        if (field.part.number == number)
        {
            return &field;
        }
    }
    return nullptr;
}

std::string ObjectsText(const Layout& layout)
{
    std::string text;
    for (const Element& element : layout.elements)
    {
        if (element.IsVariable())
        {
            const cia306::Entry& entry = *element.entry;
            const std::string access = element.home == Home::kProduced ? "kProducer" : "kConsumer";
            text += "    {" + HexLiteral(entry.index, 4) + ", " + HexLiteral(entry.sub, 2) + ", " +
                    UnsignedLiteral(entry.type.bits) + ", counterpoint::MapAccess::" + access + ", storage.bytes + " +
                    UnsignedLiteral(element.offset) + "}, // " + element.name + "\n";
        }
    }
    return text.empty() ? "" : "constexpr counterpoint::MappableObject kVariables[]{\n" + text + "};\n\n";
}

std::string MapsText(const Layout& layout)
{
    std::string text;
    std::string fields;
    for (const StaticFieldPlace& field : layout.fields)
    {
        const std::string number = std::to_string(field.part.number);
        text += "constexpr std::uint32_t kMap" + number + "[]{";
        for (const std::uint32_t entry : field.part.entries)
        {
            text += HexLiteral(entry, 8) + ", ";
        }
        text += "};\n";
        fields += "    {{" + HexLiteral(cia306::kFirstCommunicationIndex - 1U + field.part.number, 4) +
                  "}, {storage.bytes + " + UnsignedLiteral(field.normal) + ", storage.bytes + " +
                  UnsignedLiteral(field.inverse) + "}},\n";
    }
    return text.empty() ? ""
                        : text + "\nconstexpr counterpoint::generated::FieldSetting kFields[]{\n" + fields + "};\n\n";
}

std::string SetupsText(const Layout& layout)
{
    std::string text;
    for (const cia306::SrdoConfiguration& srdo : layout.safety.Srdos())
    {
        const cia306::SrdoParameters& parameters = layout.safety.Parameters().Srdo(srdo.number);
        const bool is_automatic = parameters.release_policy == cia306::kAutomaticRelease;
        const bool is_called = parameters.producer_form == cia306::kProviderCalled;
        const bool is_late = parameters.srvt_detection == cia306::kLateDetection;
        const StaticFieldPlace* const field = FieldOf(layout, srdo.number);
        const std::string map = field == nullptr ? "{nullptr, 0U}"
                                                 : "{kMap" + std::to_string(srdo.number) + ", " +
                                                       UnsignedLiteral(field->part.entries.size()) + "}";
        text += "    {" + UnsignedLiteral(srdo.number) +
                ", counterpoint::ReleasePolicy::" + (is_automatic ? "kAutomatic" : "kInterlock") +
                ", counterpoint::ProducerForm::" + (is_called ? "kProviderCalled" : "kApplicationSends") + ", {" +
                HexLiteral(parameters.safe_value & 0xFFFFFFFFU, 8) + ", " +
                HexLiteral(parameters.safe_value >> 32U, 8) +
                "}, counterpoint::SrvtDetection::" + (is_late ? "kLate" : "kEarly") + ", " + map + "},\n";
    }
    return text.empty() ? "" : "constexpr counterpoint::SrdoSetup kSetups[]{\n" + text + "};\n\n";
}

std::string SignatureTable(const std::string& name, const std::vector<std::uint16_t>& signatures)
{
    std::string text = "/// For the node-IDs from 1 on.\nconstexpr std::uint16_t " + name + "[]{\n";
    for (std::size_t place = 0U; place < signatures.size(); ++place)
    {
        const bool is_first = place % kSignaturesALine == 0U;
        text += std::string(is_first ? "    " : "") + HexLiteral(signatures[place], 4) +
                ((place + 1U) % kSignaturesALine == 0U || place + 1U == signatures.size() ? ",\n" : ", ");
    }
    return text + "};\n\n";
}

/// Settings that depend on the node-ID, or nothing.
std::string NodeSettingsText(const std::vector<SafetySetting>& settings)
{
    std::string tables;
    std::string text;
    for (std::size_t place = 0U; place < settings.size(); ++place)
    {
        const SafetySetting& setting = settings[place];
        const std::string name = "kSignatures" + std::to_string(setting.sub);
        const bool has_table = !setting.signatures.empty();
        tables += has_table ? SignatureTable(name, setting.signatures) : "";
        if (has_table || setting.node_addend)
        {
            text += "    {" + UnsignedLiteral(place) + ", " + HexLiteral(setting.node_addend.value_or(0U), 8) + ", " +
                    (has_table ? name : "nullptr") + "},\n";
        }
    }
    return text.empty()
               ? ""
               : tables + "constexpr counterpoint::generated::NodeSetting kNodeSettings[]{\n" + text + "};\n\n";
}

std::string SettingsText(const FileText& file)
{
    const Layout& layout = file.layout;
    const std::vector<SafetySetting> settings = layout.safety.Settings();
    std::string text;
    for (const SafetySetting& setting : settings)
    {
        text += "    {{" + HexLiteral(setting.index, 4) + ", " + HexLiteral(setting.sub, 2) + "}, " +
                UnsignedLiteral(setting.size_bytes) + ", " + HexLiteral(setting.value, 2 * setting.size_bytes) + "},\n";
    }
    const std::string node_settings = NodeSettingsText(settings);
    const auto node_count = std::count_if(settings.begin(), settings.end(), [](const SafetySetting& setting)
                                          { return setting.node_addend || !setting.signatures.empty(); });
    const std::string all =
        settings.empty() ? "" : "constexpr counterpoint::generated::Setting kSettings[]{\n" + text + "};\n\n";
    return all + node_settings + "constexpr counterpoint::generated::Configuration kConfiguration{" +
           (settings.empty() ? "nullptr" : "kSettings") + ", " + (layout.fields.empty() ? "nullptr" : "kFields") +
           ", " + (node_count == 0 ? "nullptr" : "kNodeSettings") + ", " + UnsignedLiteral(settings.size()) + ", " +
           UnsignedLiteral(static_cast<std::uint64_t>(node_count)) + ", " + UnsignedLiteral(layout.fields.size()) +
           ", kNodeId};\n\n";
}

std::string Member(const std::string& value, const char* const name)
{
    return "    " + value + ", // " + name + "\n";
}

/// Where ApplyNodeId keeps the description for another node-ID.
constexpr const char* kOtherDevice =
    "namespace\n{\n\ncounterpoint::DeviceConfig other_device{};\n"
    "const counterpoint::DeviceConfig* device_now{&kDevice};\n\n"
    "void DescribeNode(const std::uint8_t node_id) noexcept\n{\n"
    "    node_now.value = node_id;\n    other_device = kDevice;\n    other_device.node_id = node_id;\n    "
    "other_device.digest = 0U;\n"
    "    device_now = (node_id == kNodeId) ? &kDevice : &other_device;\n}\n\n} // namespace\n\n";

std::string Port(const std::uint8_t number)
{
    return std::string("counterpoint::CanPortId::") + (number == 2U ? "kSecond" : "kFirst");
}
} // namespace

std::string KernelText(const FileText& file)
{
    const Layout& layout = file.layout;
    return ObjectsText(layout) + MapsText(layout) + SetupsText(layout) + SettingsText(file);
}

std::string DeviceText(const FileText& file)
{
    const Layout& layout = file.layout;
    const cia306::DeviceParameters& parameters = layout.safety.Parameters();
    const bool has_dummies = parameters.dummy_mapping == cia306::kDummiesAllowed;
    const bool has_gaps = parameters.number_gaps == cia306::kGapsSearched;
    const bool has_gfc = parameters.gfc_use == cia306::kGfcPresent;
    const std::size_t srdos = layout.safety.Srdos().size();
    return "constexpr counterpoint::DeviceConfig kDevice{\n" + Member(srdos == 0U ? "nullptr" : "kSetups", "srdos") +
           Member(layout.variable_count == 0U ? "nullptr" : "kVariables", "objects") +
           Member(UnsignedLiteral(layout.variable_count), "object_count") + Member("kSrdoCount", "srdo_count") +
           Member("kNodeId", "node_id") + Member(UnsignedLiteral(parameters.granularity_bits), "granularity_bits") +
           Member("kMapEntries", "map_entries") +
           Member(std::string("counterpoint::DummyMapping::") + (has_dummies ? "kAllowed" : "kRefused"), "dummies") +
           Member(std::string("counterpoint::NumberGaps::") + (has_gaps ? "kSearched" : "kRefused"), "gaps") +
           Member(std::string("counterpoint::GfcUse::") + (has_gfc ? "kPresent" : "kRemoved"), "gfc") +
           Member(Port(parameters.normal_port), "normal_port") + Member(Port(parameters.inverse_port), "inverse_port") +
           Member(UnsignedLiteral(parameters.cycle_us), "cycle_us") +
           Member(UnsignedLiteral(parameters.cycle_tolerance_us), "cycle_tolerance_us") +
           Member(UnsignedLiteral(parameters.discrepancy_us), "discrepancy_us") +
           Member(UnsignedLiteral(parameters.acknowledge_window_us), "acknowledge_window_us") +
           Member(UnsignedLiteral(parameters.diagnostic_interval_ms * kMicrosecondsPerMillisecond),
                  "diagnostic_interval_us") +
           Member(UnsignedLiteral(parameters.test_interval_ms * kMicrosecondsPerMillisecond), "test_interval_us") +
           Member(UnsignedLiteral(parameters.clock_tolerance_us), "clock_tolerance_us") +
           Member(UnsignedLiteral(parameters.clock_tolerance_interval_us), "clock_interval_us") +
           Member(UnsignedLiteral(parameters.output_us), "output_time_us") +
           Member(HexLiteral(layout.safety.Digest(), 8), "digest") + "};\n\n" + kOtherDevice;
}
} // namespace counterpoint::generate
