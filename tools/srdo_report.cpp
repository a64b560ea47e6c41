// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/srdo_report.hpp"

#include "canopen/cia306/text/input_error.hpp"

#include <algorithm>
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

/// The entry at a sub-index; null: the file has none that can be read.
const MappingEntry* EntryAt(const SrdoConfiguration& srdo, const unsigned sub)
{
    const auto found = std::find_if(srdo.mapping.begin(), srdo.mapping.end(),
                                    [sub](const MappingEntry& entry) { return entry.sub == sub; });
    return found == srdo.mapping.end() ? nullptr : &*found;
}

/// A normal object and the inverse object behind it are one line; in a file with errors either may be missing.
void PrintPairs(const cia306::Device& device, const SrdoConfiguration& srdo, std::ostream& out)
{
    for (unsigned sub = 1U; sub < cia306::kMaxMappingEntries; sub += 2U)
    {
        const MappingEntry* const normal = EntryAt(srdo, sub);
        const MappingEntry* const inverse = EntryAt(srdo, sub + 1U);
        const MappingEntry* const either = normal == nullptr ? inverse : normal;
        if (either != nullptr)
        {
            out << "  " << (normal == nullptr ? "?" : NameOf(*normal)) << " and "
                << (inverse == nullptr ? "?" : NameOf(*inverse)) << "  " << static_cast<unsigned>(either->Bits())
                << " bit  " << TitleOf(device, *either) << "\n";
        }
    }
}

/// "?": it is missing, or none that there is.
const char* DirectionOf(const SrdoConfiguration& srdo)
{
    if (srdo.IsOn())
    {
        return srdo.IsProducer() ? "sends" : "receives";
    }
    return srdo.direction.Is(0U) ? "off" : "?";
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
        PrintPairs(device, srdo, out);
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
        const bool is_known = srdo.IsOn() || srdo.direction.Is(0U);
        rows.push_back(
            {{"srdo", srdo.number},
             {"direction", is_known ? nlohmann::ordered_json(DirectionOf(srdo)) : nlohmann::ordered_json(nullptr)},
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
