// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/check/rules.hpp"

#include "canopen/cia306/file/data_type.hpp"
#include "canopen/cia306/file/entry_reader.hpp"
#include "canopen/cia306/safety/signature.hpp"

#include <algorithm>
#include <optional>

namespace counterpoint::cia306
{
namespace
{
constexpr std::uint8_t kHighestCommunicationSub = 6U;

/// Of a configuration with an SRDO: without one nothing but that is told.
Place FirstPlace(const SafetyConfiguration& configuration)
{
    return configuration.srdos.front().place;
}

bool IsReserved(const std::uint16_t index)
{
    const bool is_after_communication = index >= 0x1341U && index <= 0x1380U;
    const bool is_after_mapping = index >= 0x13C1U && index <= 0x13FDU;
    return is_after_communication || is_after_mapping;
}

/// The highest sub-index that the object may have; nothing for other objects.
std::optional<std::uint8_t> HighestSubOf(const std::uint16_t index)
{
    const bool is_communication = index >= kFirstCommunicationIndex && index < kFirstCommunicationIndex + kMaxSrdos;
    const bool is_mapping = index >= kFirstMappingIndex && index < kFirstMappingIndex + kMaxSrdos;
    if (is_communication)
    {
        return kHighestCommunicationSub;
    }
    if (is_mapping)
    {
        return kMaxMappingEntries;
    }
    return index == kSignatureIndex ? std::optional(kMaxSrdos) : std::nullopt;
}

void CheckHighestSub(const Object& object, Findings& findings)
{
    const std::optional<std::uint8_t> highest = HighestSubOf(object.index);
    const bool is_beyond = highest && !object.entries.empty() && object.entries.rbegin()->first > *highest;
    if (is_beyond)
    {
        const Entry& last = object.entries.rbegin()->second;
        findings.Error(last.place, ObjectName(object.index, last.sub),
                       "sub-index " + std::to_string(last.sub) + " is not defined",
                       "at most sub-index " + std::to_string(*highest));
    }
}

void CheckIndices(const Device& device, Findings& findings)
{
    for (const auto& [index, object] : device.objects)
    {
        const std::string name = Hex(index, 4);
        if (IsReserved(index))
        {
            findings.Error(object.place, name, "the index is reserved", "no object here");
        }
        CheckHighestSub(object, findings);
        const bool is_mapping = index >= kFirstMappingIndex && index < kFirstMappingIndex + kMaxSrdos;
        const auto communication = static_cast<std::uint16_t>(index - kFirstMappingIndex + kFirstCommunicationIndex);
        if (is_mapping && device.Find(communication) == nullptr)
        {
            findings.Error(object.place, name, "mapping parameters without communication parameters",
                           "a section [" + Hex(communication, 4).substr(2U) + "]");
        }
    }
}

/// A value of a safety object that nothing else has read.
void CheckValue(const CheckContext& context, const Entry& entry, Findings& findings)
{
    const std::string name = ObjectName(entry.index, entry.sub);
    const bool is_silent = DataTypeOf(entry.data_type).kind != DataKind::kUnsigned || !entry.Configured().IsSet() ||
                           findings.HasErrorAt(entry.ValuePlace(), name);
    const ValueResult value = is_silent ? ValueResult{Value{}, {}} : ConfiguredValue(entry, context.node_id);
    if (!value.value)
    {
        findings.Error(entry.ValuePlace(), name, value.problem.wrong, value.problem.expected);
    }
}

/// What a rule finds wrong with a value is told by the rule.
void CheckLimits(const CheckContext& context, Findings& findings)
{
    std::vector<Finding> left;
    for (const Finding& finding : context.configuration.limits)
    {
        if (!findings.HasErrorAt(finding.place, finding.object))
        {
            left.push_back(finding);
        }
    }
    findings.Add(left);
}

void CheckInvertedSrad(const Device& device, const Entry& entry, Findings& findings)
{
    const std::uint32_t srad = entry.inverted_srad.value_or(0U);
    const auto index = static_cast<std::uint16_t>(srad >> 8U);
    const auto sub = static_cast<std::uint8_t>(srad & 0xFFU);
    const Entry* const inverse = device.Find(index, sub);
    const std::string text = "InvertedSRAD " + ObjectName(index, sub);
    if (inverse == &entry)
    {
        findings.Error(entry.inverted_srad_place, ObjectName(entry.index, entry.sub), text + " names the object itself",
                       "another object");
    }
    else if (inverse == nullptr)
    {
        findings.Error(entry.inverted_srad_place, ObjectName(entry.index, entry.sub), text + " names an unknown object",
                       "an object that the file describes");
    }
    else if (inverse->data_type != entry.data_type)
    {
        findings.Error(entry.inverted_srad_place, ObjectName(entry.index, entry.sub),
                       text + " is of " + DataTypeOf(inverse->data_type).name,
                       std::string("the same data type, ") + DataTypeOf(entry.data_type).name);
    }
}

void CheckEntries(const CheckContext& context, Findings& findings)
{
    for (const auto& [index, object] : context.device.objects)
    {
        for (const auto& [sub, entry] : object.entries)
        {
            if (entry.is_safety)
            {
                CheckValue(context, entry, findings);
            }
            if (entry.inverted_srad)
            {
                CheckInvertedSrad(context.device, entry, findings);
            }
        }
    }
}

void CheckGfc(const CheckContext& context, Findings& findings)
{
    const Field& gfc = context.configuration.gfc;
    const bool is_told = context.device.Find(kDeviceParametersIndex, kGfcUseSub) != nullptr;
    if (context.device.Find(kGfcIndex) == nullptr)
    {
        if (is_told)
        {
            return; // By 5F00h, with which the parameters are compared.
        }
        findings.Warning(FirstPlace(context.configuration), Hex(kGfcIndex, 4), "the GFC parameter is missing",
                         "an object of type UNSIGNED8");
    }
    else if (gfc.value.value_or(0U) > 1U)
    {
        findings.Error(gfc.place, ObjectName(kGfcIndex, 0U), "GFC parameter " + std::to_string(*gfc.value), "0 or 1");
    }
}

/// The kernel keeps 0000h for an SRDO that does not exist.
void CheckGaps(const CheckContext& context, Findings& findings)
{
    const Object& signatures = *context.device.Find(kSignatureIndex);
    for (const auto& [sub, entry] : signatures.entries)
    {
        const bool is_gap = sub != 0U && context.device.Find(static_cast<std::uint16_t>(kGfcIndex + sub)) == nullptr;
        if (!is_gap)
        {
            continue;
        }
        const ValueResult value = ConfiguredValue(entry, context.node_id);
        if (value.value && value.value->bits != 0U)
        {
            findings.Warning(entry.ValuePlace(), ObjectName(kSignatureIndex, sub),
                             "signature " + Hex(value.value->bits, 4) + " of an SRDO that does not exist", "0x0000");
        }
    }
}

void CheckSignatures(const CheckContext& context, Findings& findings)
{
    const SafetyConfiguration& configuration = context.configuration;
    if (context.device.Find(kSignatureIndex) == nullptr)
    {
        findings.Error(FirstPlace(configuration), Hex(kSignatureIndex, 4),
                       "the safety configuration signature is missing", "an array with a sub-index for each SRDO");
        return;
    }
    CheckGaps(context, findings);
    const std::uint8_t highest = configuration.srdos.back().number;
    if (configuration.signature_count.value && *configuration.signature_count.value < highest)
    {
        findings.Error(configuration.signature_count.place, ObjectName(kSignatureIndex, 0U),
                       std::to_string(*configuration.signature_count.value) + " signatures",
                       "at least " + std::to_string(highest) + ", the highest SRDO");
    }
    for (const SrdoConfiguration& srdo : configuration.srdos)
    {
        const bool is_comparable = srdo.signature_problems.empty() && srdo.signature.value;
        if (is_comparable && !srdo.signature.Is(SignatureOf(srdo)))
        {
            findings.Error(srdo.signature.place, ObjectName(kSignatureIndex, srdo.number),
                           "signature " + Hex(*srdo.signature.value, 4) + " of SRDO " + std::to_string(srdo.number),
                           Hex(SignatureOf(srdo), 4) + ", computed from its parameters");
        }
    }
}

void CheckValid(const CheckContext& context, Findings& findings)
{
    const Field& valid = context.configuration.configuration_valid;
    const std::string name = ObjectName(kConfigurationValidIndex, 0U);
    const Entry* const entry = context.device.Find(kConfigurationValidIndex, 0U);
    if (entry == nullptr)
    {
        findings.Error(FirstPlace(context.configuration), name, "the configuration valid flag is missing",
                       "an object of type UNSIGNED8");
        return;
    }
    if (findings.HasError())
    {
        const std::optional<Finding> finding = ValidInSpiteOfErrors(context.configuration);
        findings.Add(finding ? std::vector<Finding>{*finding} : std::vector<Finding>{});
    }
    else if (!valid.Is(kConfigurationIsValid)) // One without a value is an error.
    {
        findings.Warning(valid.place, name, Hex(valid.value.value_or(0U), 2) + ": the SRDOs stay off",
                         "0xA5 to set them going");
    }
}

/// A configuration that is declared valid and has nothing to do. [SRS_CLI_330]
void CheckAnyOn(const SafetyConfiguration& configuration, Findings& findings)
{
    const auto& srdos = configuration.srdos;
    const bool are_off =
        std::all_of(srdos.begin(), srdos.end(), [](const SrdoConfiguration& srdo) { return srdo.direction.Is(0U); });
    if (are_off && configuration.configuration_valid.Is(kConfigurationIsValid))
    {
        const SrdoConfiguration& first = srdos.front();
        findings.Warning(first.direction.place, ObjectName(first.CommunicationIndex(), 1U),
                         "no SRDO is on: the device sends and receives none, and 'counterpoint monitor' watches none",
                         "1 (producer) or 2 (consumer) in the direction of one");
    }
}

void CheckSupport(const Device& device, Findings& findings)
{
    if (device.is_safety_supported.value_or(false))
    {
        return;
    }
    findings.Warning(device.device_info_place.OrBeginning(), "", "[DeviceInfo] does not announce CANopen Safety",
                     "CANopenSafetySupported=1");
}
} // namespace

std::optional<Finding> ValidInSpiteOfErrors(const SafetyConfiguration& configuration)
{
    const Field& valid = configuration.configuration_valid;
    if (!valid.Is(kConfigurationIsValid))
    {
        return std::nullopt;
    }
    return Finding{Severity::kError, valid.place, ObjectName(kConfigurationValidIndex, 0U),
                   "0xA5 marks a configuration with errors as valid, expected 0x00 until all of them are repaired"};
}

void CheckObjects(const CheckContext& context, Findings& findings)
{
    CheckIndices(context.device, findings);
    CheckEntries(context, findings);
    CheckLimits(context, findings);
    if (context.configuration.srdos.empty())
    {
        const Place place = context.device.device_info_place.OrBeginning();
        const std::string expected = "communication parameters at 0x1301 to 0x1340";
        const auto object = FirstSafetyObject(context.device);
        if (object)
        {
            findings.Error(object->second, Hex(object->first, 4), "a safety object and no SRDO", expected);
        }
        else if (context.device.is_safety_supported.value_or(false))
        {
            findings.Error(place, "", "CANopenSafetySupported is 1 and there is no SRDO", expected);
        }
        else
        {
            findings.Warning(place, "", "no SRDO, nothing of CANopen Safety is checked", expected);
        }
        return;
    }
    CheckSupport(context.device, findings);
    CheckGfc(context, findings);
    CheckSignatures(context, findings);
    CheckValid(context, findings);
    CheckAnyOn(context.configuration, findings);
}
} // namespace counterpoint::cia306
