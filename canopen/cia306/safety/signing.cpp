// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/safety/signing.hpp"

#include "canopen/cia306/file/data_type.hpp"
#include "canopen/cia306/file/device_reader.hpp"
#include "canopen/cia306/file/value_edits.hpp"
#include "canopen/cia306/safety/digest.hpp"
#include "canopen/cia306/safety/signature.hpp"

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
    std::vector<ValueEdit> edits;
    for (const SrdoConfiguration& srdo : configuration.srdos)
    {
        RequireNone(device.file, srdo.signature_problems);
        const Entry& place = PlaceOf(device, srdo);
        const bool is_there = place.parameter_value.IsSet() && srdo.signature.Is(SignatureOf(srdo));
        if (!is_there)
        {
            edits.push_back({&place, Hex(SignatureOf(srdo), 4)});
        }
    }
    const DigestRecord digest = ExtractDigest(device, configuration, node_id);
    RequireNone(device.file, digest.problems);
    const Entry* const digest_place = device.Find(kDigestIndex, 0U);
    const bool is_digest_there =
        digest.is_present && digest_place->parameter_value.IsSet() && digest.stored.Is(DigestOf(digest.fields));
    if (digest.is_present && !is_digest_there)
    {
        edits.push_back({digest_place, Hex(DigestOf(digest.fields), 8)});
    }
    IniDocument document_with = WithParameterValues(document, device, edits);
    RequireSigned(document_with, node_id);
    return document_with;
}
} // namespace counterpoint::cia306
