// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/edit/dictionary_edits.hpp"
#include "canopen/cia306/edit/srdo_edit.hpp"
#include "canopen/cia306/file/device_reader.hpp"
#include "canopen/cia306/file/value_edits.hpp"
#include "canopen/cia306/safety/device_parameters.hpp"
#include "canopen/cia306/safety/safety_configuration.hpp"
#include "canopen/cia306/safety/signing.hpp"
#include "canopen/cia306/text/input_error.hpp"
#include "canopen/cia306/text/number.hpp"

#include <array>
#include <set>
#include <string>
#include <vector>

namespace counterpoint::cia306
{
namespace
{
constexpr std::uint64_t kMostIndex = 0xFFFFU;

/// A list without these objects: those behind them move up, the last keys are left out.
void ShortenList(const IniSection& list, const std::set<std::uint16_t>& objects, std::vector<KeyEdit>& edits,
                 std::vector<KeyPlace>& left_out)
{
    std::vector<const IniKey*> places;
    std::vector<std::string> values;
    for (const IniKey& key : list.keys)
    {
        if (!ParseDigits(key.name, 10))
        {
            continue;
        }
        places.push_back(&key);
        // A number, as its reader has seen; a comment may stand behind it.
        const auto index = static_cast<std::uint16_t>(ParseUnsigned(key.Bare(), kMostIndex).value_or(0U));
        if (objects.count(index) == 0U)
        {
            values.push_back(key.value);
        }
    }
    if (values.size() == places.size())
    {
        return;
    }
    for (std::size_t place = 0U; place < places.size(); ++place)
    {
        const IniKey& key = *places[place];
        if (place >= values.size())
        {
            left_out.push_back({list.name, key.name});
        }
        else if (key.value != values[place])
        {
            edits.push_back({list.name, key.name, values[place], ""});
        }
    }
    edits.push_back({list.name, "SupportedObjects", std::to_string(values.size()), ""});
}

/// The values that belong to the SRDO and are not 0.
std::vector<ValueEdit> ValuesToClear(const Device& device, const std::uint8_t number)
{
    struct Cleared
    {
        std::uint16_t index;
        int digits;
    };
    constexpr std::array<Cleared, 5U> cleared{{{kSignatureIndex, 4},
                                               {kReleasePolicyIndex, 2},
                                               {kSafeValueIndex, 16},
                                               {kProducerFormIndex, 2},
                                               {kDetectionIndex, 2}}};
    std::vector<ValueEdit> edits;
    for (const Cleared& array : cleared)
    {
        const Entry* const entry = device.Find(array.index, number);
        const ValueResult present = entry == nullptr ? ValueResult{} : ConfiguredValue(*entry, std::nullopt);
        if (present.value && present.value->bits != 0U)
        {
            edits.push_back({entry, Hex(0U, array.digits)});
        }
    }
    return edits;
}
} // namespace

IniDocument WithoutSrdo(const IniDocument& document, const std::uint8_t number,
                        const std::optional<std::uint8_t> node_id)
{
    const Device device = ReadDevice(document);
    const auto communication = static_cast<std::uint16_t>(kFirstCommunicationIndex + number - 1U);
    const auto mapping = static_cast<std::uint16_t>(kFirstMappingIndex + number - 1U);
    if (device.Find(communication) == nullptr)
    {
        throw InputError(device.file, {},
                         {"there is no SRDO " + std::to_string(number), "one that the file has (srdo list)"});
    }
    if (ExtractSafety(device, node_id).srdos.size() == 1U)
    {
        throw InputError(device.file, {},
                         {"SRDO " + std::to_string(number) + " is the only one",
                          "another one that stays: a safety device needs one"});
    }
    std::vector<std::string> sections;
    for (const std::uint16_t index : {communication, mapping})
    {
        const Object* const object = device.Find(index);
        const std::vector<std::string> names =
            object == nullptr ? std::vector<std::string>{} : SectionsIn(document, *object);
        sections.insert(sections.end(), names.begin(), names.end());
    }
    std::vector<KeyEdit> edits;
    std::vector<KeyPlace> left_out;
    for (const char* const name : {"MandatoryObjects", "OptionalObjects", "ManufacturerObjects"})
    {
        const IniSection* const list = document.Find(name);
        if (list != nullptr)
        {
            ShortenList(*list, {communication, mapping}, edits, left_out);
        }
    }
    const IniDocument cleared = WithParameterValues(document, device, ValuesToClear(device, number));
    const IniDocument shorter = cleared.With(edits, {}).Without(sections, left_out);
    return WithSignatures(shorter, ReadDevice(shorter), node_id);
}
} // namespace counterpoint::cia306
