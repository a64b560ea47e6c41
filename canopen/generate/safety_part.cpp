// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/generate/safety_part.hpp"

#include "canopen/cia306/safety/signature.hpp"
#include "canopen/cia306/text/input_error.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace counterpoint::generate
{
namespace
{
using cia306::MappingEntry;
using cia306::SrdoConfiguration;

constexpr std::uint8_t kLastNode = 127U;
constexpr std::uint16_t kNoSignature = 0U;
constexpr std::uint32_t kPayloadBits = 64U;

struct ObjectPlace
{
    std::uint16_t index{0U};
    std::uint8_t sub{0U};
};

std::uint32_t Number(const cia306::Field& field)
{
    return static_cast<std::uint32_t>(field.value.value_or(0U));
}

/// Place of the variable with this index and sub-index; nothing where there is none.
std::optional<std::size_t> Find(const std::vector<Element>& elements, const std::uint32_t key)
{
    const auto found =
        std::lower_bound(elements.begin(), elements.end(), key,
                         [](const Element& element, const std::uint32_t wanted) { return element.Key() < wanted; });
    const bool is_there = found != elements.end() && found->Key() == key && found->IsVariable();
    return is_there ? std::optional(static_cast<std::size_t>(found - elements.begin())) : std::nullopt;
}

/// `bits` of a safe value from `offset` on; nothing beyond it.
std::uint64_t SafeBits(const std::uint64_t safe_value, const std::uint32_t offset, const std::uint32_t bits)
{
    const std::uint64_t rest = (offset < kPayloadBits) ? safe_value >> offset : 0U;
    return (bits < kPayloadBits) ? rest & ((std::uint64_t{1U} << bits) - 1U) : rest;
}

/// Of two SRDOs that map a variable the one that is on has it.
void SetSafeRead(const SrdoConfiguration& srdo, const std::uint64_t bits, Element& element)
{
    const bool is_its = srdo.IsConsumer() || (!srdo.IsProducer() && !element.safe_read);
    if (element.home == Home::kConsumed && is_its)
    {
        element.safe_read = SafeRead{srdo.number, bits};
    }
}
void Append(std::vector<SafetySetting>& settings, const ObjectPlace& object, const std::uint8_t size,
            const std::uint32_t value)
{
    settings.push_back({object.index, object.sub, size, value, std::nullopt, {}});
}

/// That of 13FFh. There is one for each SRDO.
SafetySetting& SignatureSetting(std::vector<SafetySetting>& settings, const std::uint8_t number)
{
    return *std::find_if(settings.begin(), settings.end(), [number](const SafetySetting& setting)
                         { return setting.index == cia306::kSignatureIndex && setting.sub == number; });
}

void AppendMapping(const SrdoConfiguration& srdo, std::vector<SafetySetting>& settings)
{
    Append(settings, {srdo.MappingIndex(), 0U}, 1U, 0U);
    for (const MappingEntry& entry : srdo.mapping)
    {
        Append(settings, {srdo.MappingIndex(), entry.sub}, 4U, entry.raw);
    }
    Append(settings, {srdo.MappingIndex(), 0U}, 1U, Number(srdo.entry_count));
}

void AppendParameters(const SrdoConfiguration& srdo, std::vector<SafetySetting>& settings)
{
    const std::uint16_t index = srdo.CommunicationIndex();
    Append(settings, {index, 2U}, 2U, Number(srdo.sct_ms));
    Append(settings, {index, 3U}, 1U, Number(srdo.srvt_ms));
    Append(settings, {index, 4U}, 1U, Number(srdo.transmission_type));
    Append(settings, {index, 5U}, 4U, Number(srdo.cob_id_1));
    Append(settings, {index, 6U}, 4U, Number(srdo.cob_id_2));
    if (!srdo.is_static)
    {
        AppendMapping(srdo, settings);
    }
    Append(settings, {cia306::kSignatureIndex, srdo.number}, 2U, Number(srdo.signature));
}
} // namespace

SafetyPart::SafetyPart(const cia306::Device& device, const std::optional<std::uint8_t> node_id)
    : device_(device), node_id_(node_id), safety_(cia306::ExtractSafety(device, node_id))
{
    std::vector<cia306::Finding> problems;
    parameters_ = cia306::ReadDeviceParameters(device_, node_id_, problems);
    if (safety_.srdos.empty())
    {
        return;
    }
    cia306::RequireNone(device_.file, safety_.problems);
    for (const SrdoConfiguration& srdo : safety_.srdos)
    {
        cia306::RequireNone(device_.file, srdo.signature_problems);
        cia306::RequireNone(device_.file, srdo.other_problems);
    }
    cia306::RequireNone(device_.file, safety_.limits);
    cia306::RequireNone(device_.file, problems);
    if (!node_id_)
    {
        throw cia306::InputError(device_.file, {}, {"no node-ID", "--node-id, or NodeID in [DeviceComissioning]"});
    }
}

std::uint32_t SafetyPart::Digest() const noexcept
{
    return node_id_ == device_.node_id ? parameters_.digest : 0U;
}

std::optional<Home> SafetyPart::HomeOf(const cia306::Entry& entry) const
{
    const bool is_mappable = entry.is_srdo_mappable.value_or(entry.is_pdo_mappable && safety_.Maps(entry));
    const bool has_length = entry.type.bits != 0U; // At most 64.
    if (safety_.srdos.empty() || !is_mappable || !has_length)
    {
        return std::nullopt;
    }
    switch (entry.access)
    {
    case cia306::Access::kReadOnly:
    case cia306::Access::kReadWriteInput:
    case cia306::Access::kConstant:
        return Home::kProduced;
    case cia306::Access::kWriteOnly:
    case cia306::Access::kReadWriteOutput:
        return Home::kConsumed;
    case cia306::Access::kReadWrite:
        // Fits both directions: what the file maps it to decides.
        return safety_.MapsToReceive(entry) ? Home::kConsumed : Home::kProduced;
    case cia306::Access::kUnknown:
        break;
    }
    return std::nullopt;
}

void SafetyPart::JoinPairs(std::vector<Element>& elements) const
{
    for (Element& element : elements)
    {
        if (element.IsVariable() && element.entry->inverted_srad)
        {
            element.inverse = Find(elements, *element.entry->inverted_srad);
        }
    }
    for (const SrdoConfiguration& srdo : safety_.srdos)
    {
        std::uint32_t offset = 0U;
        for (std::size_t place = 0U; place + 1U < srdo.mapping.size(); place += 2U)
        {
            const std::uint32_t bits = srdo.mapping[place].Bits();
            const auto normal = Find(elements, srdo.mapping[place].raw >> 8U);
            const auto inverse = Find(elements, srdo.mapping[place + 1U].raw >> 8U);
            if (normal && inverse)
            {
                elements[*normal].inverse = inverse;
                SetSafeRead(srdo, SafeBits(parameters_.Srdo(srdo.number).safe_value, offset, bits), elements[*normal]);
            }
            offset += bits;
        }
    }
}

std::vector<StaticPart> SafetyPart::StaticParts(const std::vector<Element>& elements) const
{
    std::vector<StaticPart> parts;
    for (const SrdoConfiguration& srdo : safety_.srdos)
    {
        if (!srdo.is_static)
        {
            continue;
        }
        StaticPart part;
        part.number = srdo.number;
        part.place = srdo.entry_count.place;
        for (const MappingEntry& entry : srdo.mapping)
        {
            const auto place = Find(elements, entry.raw >> 8U);
            if (!place) // [SRS_GEN_351]
            {
                throw cia306::InputError(device_.file, entry.place,
                                         {"the static mapping names " + cia306::ObjectName(entry.Index(), entry.Sub()),
                                          "an object of the file with SRDOMapping=1 and a length of 1 to 64 bits"});
            }
            (entry.IsNormal() ? part.normal : part.inverse).push_back(*place);
            part.entries.push_back(entry.raw);
        }
        parts.push_back(part);
    }
    return parts;
}

std::vector<SafetySetting> SafetyPart::Settings() const
{
    std::vector<SafetySetting> settings = SettingsFor(safety_);
    FollowNodeId(settings);
    return settings;
}

std::vector<SafetySetting> SafetyPart::SettingsFor(const cia306::SafetyConfiguration& safety) const
{
    std::vector<SafetySetting> settings;
    for (const SrdoConfiguration& srdo : safety.srdos)
    {
        Append(settings, {srdo.CommunicationIndex(), 1U}, 1U, 0U); // Off, so that the rest can be written.
    }
    for (const SrdoConfiguration& srdo : safety.srdos)
    {
        AppendParameters(srdo, settings);
    }
    for (const SrdoConfiguration& srdo : safety.srdos)
    {
        Append(settings, {srdo.CommunicationIndex(), 1U}, 1U, Number(srdo.direction));
    }
    const bool has_gfc = safety.gfc.value && parameters_.gfc_use == cia306::kGfcPresent;
    if (has_gfc)
    {
        Append(settings, {cia306::kGfcIndex, 0U}, 1U, Number(safety.gfc));
    }
    if (!settings.empty())
    {
        Append(settings, {cia306::kConfigurationValidIndex, 0U}, 1U, Number(safety.configuration_valid));
    }
    return settings;
}

/// The settings of one node-ID become those of another one by a number each: there are as many of them. [SRS_GEN_350]
void SafetyPart::RequireSameMappings(const cia306::SafetyConfiguration& other) const
{
    for (std::size_t place = 0U; place < safety_.srdos.size(); ++place)
    {
        const SrdoConfiguration& srdo = safety_.srdos[place];
        const SrdoConfiguration& of_other = other.srdos[place];
        if (of_other.entry_count.value != srdo.entry_count.value || of_other.mapping.size() != srdo.mapping.size())
        {
            throw cia306::InputError(device_.file, srdo.entry_count.place,
                                     {"the mapping of SRDO " + std::to_string(srdo.number) +
                                          " has another number of entries with another node-ID",
                                      "as many for each node-ID"});
        }
    }
}

/// A sum that is too great for one node-ID is so for each that follows.
std::vector<cia306::Finding> SafetyPart::ValuesTooGreat() const
{
    if (safety_.srdos.empty() || ProblemsWith(kLastNode).empty())
    {
        return {};
    }
    std::map<std::string, std::uint8_t> first; // Of each object.
    for (std::uint8_t node = 1U; node <= kLastNode; ++node)
    {
        for (const cia306::Finding& problem : ProblemsWith(node))
        {
            first.emplace(problem.object, node);
        }
    }
    std::vector<cia306::Finding> findings = ProblemsWith(kLastNode);
    for (cia306::Finding& finding : findings)
    {
        finding.severity = cia306::Severity::kWarning;
        finding.text = "no value with node-IDs " + std::to_string(first.at(finding.object)) + " to " +
                       std::to_string(kLastNode) + ", expected a sum that its type holds; Configure refuses them";
    }
    return findings;
}

/// What cannot be read with this node-ID; nothing with that of the file.
std::vector<cia306::Finding> SafetyPart::ProblemsWith(const std::uint8_t node_id) const
{
    const cia306::SafetyConfiguration safety = cia306::ExtractSafety(device_, node_id);
    std::vector<cia306::Finding> problems = safety.problems;
    for (const SrdoConfiguration& srdo : safety.srdos)
    {
        problems.insert(problems.end(), srdo.signature_problems.begin(), srdo.signature_problems.end());
        problems.insert(problems.end(), srdo.other_problems.begin(), srdo.other_problems.end());
    }
    return problems;
}

/// Formulas are the node-ID and a number: two node-IDs tell which values have one.
void SafetyPart::FollowNodeId(std::vector<SafetySetting>& settings) const
{
    const cia306::SafetyConfiguration one = cia306::ExtractSafety(device_, 1U);
    const cia306::SafetyConfiguration two = cia306::ExtractSafety(device_, 2U);
    RequireSameMappings(one);
    RequireSameMappings(two);
    const std::vector<SafetySetting> of_one = SettingsFor(one);
    const std::vector<SafetySetting> of_two = SettingsFor(two);
    std::set<std::uint8_t> numbers; // SRDOs of which something depends on the node-ID.
    for (std::size_t place = 0U; place < settings.size(); ++place)
    {
        if (of_one[place].value != of_two[place].value)
        {
            settings[place].node_addend = of_one[place].value - 1U;
            numbers.insert(
                static_cast<std::uint8_t>((settings[place].index - cia306::kFirstCommunicationIndex) % 0x80U + 1U));
        }
    }
    for (std::uint8_t node = 1U; !numbers.empty() && node <= kLastNode; ++node)
    {
        const cia306::SafetyConfiguration other = cia306::ExtractSafety(device_, node);
        for (std::size_t place = 0U; place < safety_.srdos.size(); ++place)
        {
            const SrdoConfiguration& srdo = safety_.srdos[place];
            const auto signature = cia306::SignatureWithNode(srdo, other.srdos[place]);
            if (numbers.count(srdo.number) != 0U && signature)
            {
                // Of values that the node-ID does not have there is none, and nobody comes to write it.
                const bool has_values = other.srdos[place].signature_problems.empty();
                SignatureSetting(settings, srdo.number).signatures.push_back(has_values ? *signature : kNoSignature);
            }
        }
    }
}
} // namespace counterpoint::generate
