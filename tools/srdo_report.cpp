// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/srdo_report.hpp"

#include "canopen/cia306/text/input_error.hpp"

#include <string>

namespace counterpoint::tools
{
namespace
{
using cia306::Field;
using cia306::MappingEntry;
using cia306::SrdoConfiguration;

/// A number that the file may lack.
std::string Decimal(const Field& field)
{
    return field.value ? std::to_string(*field.value) : "?";
}

std::string Hexadecimal(const Field& field, const int digits)
{
    return field.value ? cia306::Hex(*field.value, digits) : "?";
}

std::string NameOf(const MappingEntry& entry)
{
    return cia306::ObjectName(entry.Index(), entry.Sub());
}

/// The name of the object in the file, and nothing for one that it does not have.
std::string TitleOf(const cia306::Device& device, const MappingEntry& entry)
{
    const cia306::Entry* const object = device.Find(entry.Index(), entry.Sub());
    return object == nullptr ? "" : cia306::Printable(object->name);
}

const char* DirectionOf(const SrdoConfiguration& srdo)
{
    return srdo.IsProducer() ? "sends" : (srdo.IsConsumer() ? "receives" : "off");
}
} // namespace

void PrintSrdos(const cia306::Device& device, const cia306::SafetyConfiguration& configuration, std::ostream& out)
{
    for (const SrdoConfiguration& srdo : configuration.srdos)
    {
        out << "SRDO " << static_cast<unsigned>(srdo.number) << " " << DirectionOf(srdo) << " "
            << Hexadecimal(srdo.cob_id_1, 3) << " and " << Hexadecimal(srdo.cob_id_2, 3) << ", "
            << (srdo.IsProducer() ? "refresh time " : "SCT ") << Decimal(srdo.sct_ms) << " ms, SRVT "
            << Decimal(srdo.srvt_ms) << " ms, signature " << Hexadecimal(srdo.signature, 4) << "\n";
        for (const MappingEntry& entry : srdo.mapping)
        {
            if (entry.IsNormal())
            {
                out << "  " << NameOf(entry);
                continue;
            }
            const MappingEntry& normal = srdo.mapping.at(entry.sub - 2U);
            out << " and " << NameOf(entry) << "  " << static_cast<unsigned>(entry.Bits()) << " bit  "
                << TitleOf(device, normal) << "\n";
        }
    }
}

nlohmann::ordered_json SrdosToJson(const cia306::Device& device, const cia306::SafetyConfiguration& configuration)
{
    const auto number = [](const Field& field)
    { return field.value ? nlohmann::ordered_json(*field.value) : nlohmann::ordered_json(nullptr); };
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const SrdoConfiguration& srdo : configuration.srdos)
    {
        nlohmann::ordered_json mapping = nlohmann::ordered_json::array();
        for (const MappingEntry& entry : srdo.mapping)
        {
            mapping.push_back({{"object", NameOf(entry)},
                               {"bits", entry.Bits()},
                               {"inverse", !entry.IsNormal()},
                               {"name", TitleOf(device, entry)}});
        }
        rows.push_back({{"srdo", srdo.number},
                        {"direction", DirectionOf(srdo)},
                        {"cob_id_1", number(srdo.cob_id_1)},
                        {"cob_id_2", number(srdo.cob_id_2)},
                        {"sct_ms", number(srdo.sct_ms)},
                        {"srvt_ms", number(srdo.srvt_ms)},
                        {"signature", number(srdo.signature)},
                        {"mapping", mapping}});
    }
    return rows;
}
} // namespace counterpoint::tools
