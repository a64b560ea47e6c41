// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/generate/text.hpp"

#include "canopen/cia306/input_error.hpp"

namespace counterpoint::generate
{
namespace
{
constexpr std::uint32_t kMicrosecondsPerMillisecond = 1000U;

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

std::string SettingsText(const Layout& layout)
{
    std::string text;
    std::size_t count = 0U;
    for (const SafetySetting& setting : layout.safety.Settings())
    {
        text += "    {{" + HexLiteral(setting.index, 4) + ", " + HexLiteral(setting.sub, 2) + "}, " +
                UnsignedLiteral(setting.size_bytes) + ", " + HexLiteral(setting.value, 2 * setting.size_bytes) + "},\n";
        ++count;
    }
    const bool has_fields = !layout.fields.empty();
    const std::string settings =
        count == 0U ? "" : "constexpr counterpoint::generated::Setting kSettings[]{\n" + text + "};\n\n";
    return settings + "constexpr counterpoint::generated::Configuration kConfiguration{" +
           (count == 0U ? "nullptr" : "kSettings") + ", " + (has_fields ? "kFields" : "nullptr") + ", " +
           UnsignedLiteral(count) + ", " + UnsignedLiteral(layout.fields.size()) + "};\n\n";
}

std::string Member(const std::string& value, const char* const name)
{
    return "    " + value + ", // " + name + "\n";
}

std::string Port(const std::uint8_t number)
{
    return std::string("counterpoint::CanPortId::") + (number == 2U ? "kSecond" : "kFirst");
}
} // namespace

std::string KernelText(const FileText& file)
{
    const Layout& layout = file.layout;
    return ObjectsText(layout) + MapsText(layout) + SetupsText(layout) + SettingsText(layout);
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
           Member(HexLiteral(layout.safety.Digest(), 8), "digest") + "};\n\n";
}
} // namespace counterpoint::generate
