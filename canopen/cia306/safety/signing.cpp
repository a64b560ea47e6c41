// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/safety/signing.hpp"

#include "canopen/cia306/file/data_type.hpp"
#include "canopen/cia306/file/device_reader.hpp"
#include "canopen/cia306/safety/digest.hpp"
#include "canopen/cia306/safety/signature.hpp"

#include <utility>
#include <vector>

namespace counterpoint::cia306
{
namespace
{
const Entry& PlaceOf(const Device& device, const SrdoConfiguration& srdo)
{
    const Entry* const entry = device.Find(kSignatureIndex, srdo.number);
    if (entry == nullptr)
    {
        const Object* const object = device.Find(kSignatureIndex);
        throw InputError(device.file, object == nullptr ? srdo.place : object->place,
                         {ObjectName(kSignatureIndex, srdo.number) + " is missing",
                          "an object that takes the signature of SRDO " + std::to_string(srdo.number)});
    }
    const bool is_other_type = entry->data_type != 0U && entry->data_type != kUnsigned16;
    if (is_other_type)
    {
        throw InputError(
            device.file, entry->place,
            {ObjectName(kSignatureIndex, srdo.number) + " is of " + DataTypeOf(entry->data_type).name, "UNSIGNED16"});
    }
    return *entry;
}

/// Values of a compact object stand in a section [13FFValue] that may have to be made first.
struct Edits
{
    std::vector<KeyEdit> keys;
    SectionEdit values;
};

void AddEdit(Edits& edits, const IniDocument& document, const Entry& entry, const std::string& value)
{
    if (!entry.is_compact)
    {
        edits.keys.push_back({entry.section, "ParameterValue", value, "DefaultValue"});
        return;
    }
    const std::string key = std::to_string(entry.sub);
    const IniSection* const values = document.Find(entry.section);
    if (values == nullptr)
    {
        edits.values.name = entry.section;
        edits.values.keys.emplace_back(key, value);
        return;
    }
    // The key may be written with another base; then that line is the one to change.
    std::string present = key;
    for (const IniKey& candidate : values->keys)
    {
        present = candidate.place == entry.parameter_value.place ? candidate.name : present;
    }
    edits.keys.push_back({entry.section, present, value, ""});
}

/// NrOfEntries tells how many of the sub-indices have a value.
void AddEntryCount(Edits& edits, const IniDocument& document, const std::string& section)
{
    const IniSection* const values = document.Find(section);
    const IniKey* const count = values == nullptr ? nullptr : values->Find("NrOfEntries");
    if (count == nullptr)
    {
        return;
    }
    std::size_t entries = values->keys.size() - 1U;
    for (const KeyEdit& edit : edits.keys)
    {
        const bool is_new = edit.section == section && values->Find(edit.key) == nullptr;
        entries += is_new ? 1U : 0U;
    }
    if (std::to_string(entries) != count->value)
    {
        edits.keys.push_back({section, "NrOfEntries", std::to_string(entries), ""});
    }
}

void RequireSigned(const IniDocument& document, const std::optional<std::uint8_t> node_id)
{
    const Device device = ReadDevice(document);
    const SafetyConfiguration configuration = ExtractSafety(device, node_id);
    const DigestRecord digest = ExtractDigest(device, configuration, node_id);
    RequireNone(document.File(), digest.problems);
    const bool is_digest_there = !digest.is_present || digest.stored.Is(DigestOf(digest.fields));
    if (!is_digest_there)
    {
        throw InputError(document.File(), digest.stored.place,
                         {DigestName() + ": the digest is not there when read back", Hex(DigestOf(digest.fields), 8)});
    }
    for (const SrdoConfiguration& srdo : configuration.srdos)
    {
        RequireNone(document.File(), srdo.signature_problems);
        if (!srdo.signature.Is(SignatureOf(srdo)))
        {
            throw InputError(document.File(), srdo.signature.place,
                             {ObjectName(kSignatureIndex, srdo.number) + ": the signature is not there when read back",
                              Hex(SignatureOf(srdo), 4)});
        }
    }
}
} // namespace

IniDocument WithSignatures(const IniDocument& document, const Device& device, const std::optional<std::uint8_t> node_id)
{
    const SafetyConfiguration configuration = ExtractSafety(device, node_id);
    RequireNone(device.file, configuration.missing);
    Edits edits;
    for (const SrdoConfiguration& srdo : configuration.srdos)
    {
        RequireNone(device.file, srdo.signature_problems);
        AddEdit(edits, document, PlaceOf(device, srdo), Hex(SignatureOf(srdo), 4));
    }
    const DigestRecord digest = ExtractDigest(device, configuration, node_id);
    RequireNone(device.file, digest.problems);
    if (digest.is_present)
    {
        AddEdit(edits, document, *device.Find(kDigestIndex, 0U), Hex(DigestOf(digest.fields), 8));
    }
    AddEntryCount(edits, document, Hex(kSignatureIndex, 4).substr(2U) + "Value");
    std::vector<SectionEdit> sections;
    if (!edits.values.keys.empty())
    {
        const std::string count = std::to_string(edits.values.keys.size());
        edits.values.after_section = device.Find(kSignatureIndex)->section;
        edits.values.keys.insert(edits.values.keys.begin(), {"NrOfEntries", count});
        sections.push_back(std::move(edits.values));
    }
    IniDocument document_with = document.With(edits.keys, sections);
    RequireSigned(document_with, node_id);
    return document_with;
}
} // namespace counterpoint::cia306
