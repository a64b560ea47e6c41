// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/check/rules.hpp"

#include "canopen/cia306/check/sides.hpp"
#include "canopen/cia306/file/data_type.hpp"

#include <map>
#include <vector>

namespace counterpoint::cia306
{
namespace
{
constexpr std::uint32_t kMaxBits = 64U;
constexpr std::uint16_t kLastDummy = 0x0007U;

std::string Bits(const std::uint32_t bits)
{
    return std::to_string(bits) + " bit";
}

std::string EntryName(const SrdoConfiguration& srdo, const MappingEntry& entry)
{
    return ObjectName(srdo.MappingIndex(), entry.sub);
}

std::string MappedName(const MappingEntry& entry)
{
    return ObjectName(entry.Index(), entry.Sub());
}

void CheckDummy(const CheckContext& context, const SrdoConfiguration& srdo, const MappingEntry& entry,
                Findings& findings)
{
    const std::string name = EntryName(srdo, entry);
    const std::uint8_t bits = DataTypeOf(entry.Index()).bits;
    const bool is_allowed =
        context.device.dummies.count(entry.Index()) != 0U && entry.Sub() == 0U && entry.Index() <= kLastDummy;
    if (!is_allowed)
    {
        findings.Error(entry.place, name, "dummy object " + MappedName(entry) + " is not mappable",
                       "a data type 0x0001 to 0x0007 that [DummyUsage] allows, with sub-index 0");
    }
    else if (entry.Bits() != bits)
    {
        findings.Error(entry.place, name, "length of " + Bits(entry.Bits()), Bits(bits) + " of the dummy object");
    }
    else if (context.parameters.dummy_mapping != kDummiesAllowed)
    {
        findings.Error(entry.place, name, "dummy object " + MappedName(entry) + " in a device without dummy mapping",
                       "0x66 in " + ObjectName(kDeviceParametersIndex, kDummyMappingSub));
    }
    if (srdo.IsProducer())
    {
        findings.Error(entry.place, name, "dummy object " + MappedName(entry) + " in a producer",
                       "an object with data to send");
    }
}

bool IsMappable(const Entry& object)
{
    return object.is_srdo_mappable.value_or(object.is_pdo_mappable);
}

bool IsAccessRight(const Access access, const bool is_consumer)
{
    switch (access)
    {
    case Access::kReadWrite:
        return true;
    case Access::kWriteOnly:
    case Access::kReadWriteOutput:
        return is_consumer;
    case Access::kReadOnly:
    case Access::kReadWriteInput:
    case Access::kConstant:
        return !is_consumer;
    case Access::kUnknown:
        break;
    }
    return false;
}

void CheckObject(const SrdoConfiguration& srdo, const MappingEntry& entry, const Entry& object, Findings& findings)
{
    const std::string name = EntryName(srdo, entry);
    const std::string mapped = "mapped object " + MappedName(entry);
    if (!IsMappable(object))
    {
        findings.Error(entry.place, name, mapped + " is not mappable (line " + std::to_string(object.place.line) + ")",
                       object.is_safety ? "an object of the application, not of the safety functions"
                                        : "SRDOMapping=1, or PDOMapping=1 where there is no SRDOMapping");
    }
    const bool is_wrong_access = !srdo.direction.Is(0U) && !IsAccessRight(object.access, srdo.IsConsumer());
    if (is_wrong_access)
    {
        findings.Error(entry.place, name,
                       mapped + " has the wrong AccessType (line " + std::to_string(object.access_place.line) + ")",
                       srdo.IsConsumer() ? "rw, wo or rww to be received" : "ro, rw, rwr or const to be sent");
    }
    const DataType& type = object.type;
    if (type.bits == 0U)
    {
        findings.Error(entry.place, name, mapped + " is of " + type.name, "a data type with a fixed length");
    }
    else if (type.bits != entry.Bits())
    {
        findings.Error(entry.place, name, "length of " + Bits(entry.Bits()),
                       Bits(type.bits) + ", the length of " + MappedName(entry) + " (" + type.name + ")");
    }
}

void CheckCount(const CheckContext& context, const SrdoConfiguration& srdo, Findings& findings)
{
    const std::string name = ObjectName(srdo.MappingIndex(), 0U);
    const std::uint64_t count = srdo.entry_count.value.value_or(0U);
    const std::string text = std::to_string(count) + " mapping entries";
    const bool is_odd = (count & 1U) != 0U;
    if (is_odd)
    {
        findings.Error(srdo.entry_count.place, name, text, "an even number: one normal and one inverse entry a pair");
    }
    const std::uint8_t room = context.parameters.map_entries;
    const bool is_above_room = !srdo.is_static && count > room && count <= kMaxMappingEntries;
    if (is_above_room)
    {
        findings.Error(srdo.entry_count.place, name, text,
                       "at most " + std::to_string(room) + ", for which " +
                           ObjectName(kDeviceParametersIndex, kMapEntriesSub) + " gives room");
    }
    const bool is_empty = srdo.entry_count.Is(0U) && srdo.IsOn();
    if (is_empty)
    {
        findings.Error(srdo.entry_count.place, name, "no mapping entry in an SRDO that is on", "2 or more");
    }
}

void CheckTotals(const SrdoConfiguration& srdo, Findings& findings)
{
    std::uint32_t normal_bits = 0U;
    std::uint32_t inverse_bits = 0U;
    for (const MappingEntry& entry : srdo.mapping)
    {
        std::uint32_t& total = entry.IsNormal() ? normal_bits : inverse_bits;
        total += entry.Bits();
    }
    const std::string name = ObjectName(srdo.MappingIndex(), 0U);
    if (normal_bits > kMaxBits)
    {
        findings.Error(srdo.entry_count.place, name, Bits(normal_bits) + " of normal data", "at most 64 bit");
    }
    if (inverse_bits > kMaxBits)
    {
        findings.Error(srdo.entry_count.place, name, Bits(inverse_bits) + " of inverse data", "at most 64 bit");
    }
}

/// Normal data at an odd sub-index, its inverse at the next.
void CheckPairs(const SrdoConfiguration& srdo, Findings& findings)
{
    for (std::size_t place = 1U; place < srdo.mapping.size(); ++place)
    {
        const MappingEntry& normal = srdo.mapping[place - 1U];
        const MappingEntry& inverse = srdo.mapping[place];
        const bool is_pair = normal.IsNormal() && inverse.sub == normal.sub + 1U;
        if (!is_pair)
        {
            continue;
        }
        const std::string name = EntryName(srdo, inverse);
        if (normal.Bits() != inverse.Bits())
        {
            findings.Tell(
                WhenOn(srdo), inverse.place, name,
                {"inverse entry of " + Bits(inverse.Bits()), Bits(normal.Bits()) + " as the normal entry before it"});
        }
        if (normal.IsDummy() != inverse.IsDummy())
        {
            findings.Error(inverse.place, name, "dummy object on one side of the pair only",
                           "normal and inverse data to be stored both or not at all");
        }
    }
}

void CheckSides(const SrdoConfiguration& srdo, Findings& findings)
{
    std::map<std::uint32_t, const MappingEntry*> normals;
    std::map<std::uint32_t, const MappingEntry*> inverses;
    for (const MappingEntry& entry : srdo.mapping)
    {
        if (entry.IsDummy())
        {
            continue; // Stores nothing, so that it may stand on both sides and often.
        }
        auto& own_side = entry.IsNormal() ? normals : inverses;
        const auto& other_side = entry.IsNormal() ? inverses : normals;
        const std::uint32_t object = entry.raw >> 8U;
        const auto other = other_side.find(object);
        if (other != other_side.end())
        {
            findings.Tell(
                WhenOn(srdo), entry.place, EntryName(srdo, entry),
                {"object " + MappedName(entry) + " is normal and inverse data of SRDO " + std::to_string(srdo.number),
                 "another object than in sub-index " + std::to_string(other->second->sub)});
        }
        const auto [before, is_new] = own_side.emplace(object, &entry);
        if (!is_new)
        {
            findings.Tell(WhenOn(srdo), entry.place, EntryName(srdo, entry),
                          {"object " + MappedName(entry) + " is mapped twice",
                           "another object than in sub-index " + std::to_string(before->second->sub)});
        }
    }
}
/// A value of a safety variable that its type cannot have has no place among what other files may have wrong.
void CheckMappedValue(const CheckContext& context, const MappingEntry& entry, Findings& findings)
{
    const Entry* const object = context.device.Find(entry.Index(), entry.Sub());
    const bool has_value = object != nullptr && object->Configured().IsSet();
    const auto problem = has_value ? ProblemOf(object->Configured().text, object->type) : std::nullopt;
    if (problem)
    {
        findings.Error(object->ValuePlace(), MappedName(entry), problem->wrong, problem->expected);
    }
}

} // namespace

void CheckMappedObject(const CheckContext& context, const SrdoConfiguration& srdo, const MappingEntry& entry,
                       Findings& findings)
{
    const std::string name = EntryName(srdo, entry);
    // One that there is not is told where it stands: it divides nothing. [SRS_CLI_490]
    const bool is_known = IsGranularity(context.granularity_bits);
    if (is_known && (entry.Bits() == 0U || entry.Bits() % context.granularity_bits != 0U))
    {
        findings.Tell(
            WhenOn(srdo), entry.place, name,
            {"length of " + Bits(entry.Bits()), "a multiple of " + Bits(context.granularity_bits) + " (granularity)"});
    }
    if (entry.IsDummy())
    {
        CheckDummy(context, srdo, entry, findings);
        return;
    }
    const Entry* const object = context.device.Find(entry.Index(), entry.Sub());
    if (object == nullptr)
    {
        findings.Error(entry.place, name, "mapped object " + MappedName(entry) + " is unknown",
                       "an object that the file describes");
        return;
    }
    CheckObject(srdo, entry, *object, findings);
}

void CheckMapping(const CheckContext& context, const SrdoConfiguration& srdo, Findings& findings)
{
    CheckCount(context, srdo, findings);
    for (const MappingEntry& entry : srdo.mapping)
    {
        CheckMappedObject(context, srdo, entry, findings);
        CheckMappedValue(context, entry, findings);
    }
    CheckTotals(srdo, findings);
    findings.Add(WrongSides(context.device, srdo));
    CheckPairs(srdo, findings);
    CheckSides(srdo, findings);
}

void CheckShared(const SafetyConfiguration& configuration, Findings& findings)
{
    std::map<std::uint32_t, std::vector<const SrdoConfiguration*>> users;
    for (const SrdoConfiguration& srdo : configuration.srdos)
    {
        const bool is_on = srdo.IsOn();
        for (const MappingEntry& entry : srdo.mapping)
        {
            if (!is_on || entry.IsDummy())
            {
                continue;
            }
            std::vector<const SrdoConfiguration*>& others = users[entry.raw >> 8U];
            for (const SrdoConfiguration* const other : others)
            {
                const bool is_shared = other != &srdo && (srdo.IsConsumer() || other->IsConsumer());
                if (is_shared)
                {
                    findings.Error(entry.place, EntryName(srdo, entry),
                                   "object " + MappedName(entry) + " is in the mapping of SRDO " +
                                       std::to_string(other->number) + " too, and one of the two receives",
                                   "an object of its own");
                    break;
                }
            }
            others.push_back(&srdo);
        }
    }
}
} // namespace counterpoint::cia306
