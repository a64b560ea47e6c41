// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/safety/safety_configuration.hpp"

#include "canopen/cia306/file/data_type.hpp"
#include "canopen/cia306/file/entry_reader.hpp"
#include "canopen/cia306/file/limits.hpp"

#include <algorithm>

namespace counterpoint::cia306
{
namespace
{
void AddError(std::vector<Finding>& problems, const Place place, const std::string& object, const Problem& problem)
{
    problems.push_back({Severity::kError, place, object, problem.wrong + ", expected " + problem.expected});
}

/// Reads the parameters of one SRDO after the other.
class SrdoReader
{
  public:
    SrdoReader(const Device& device, const std::optional<std::uint8_t> node_id) noexcept
        : device_(device), node_id_(node_id)
    {
    }

    [[nodiscard]] SrdoConfiguration Read(const std::uint8_t number, const Object& communication) const
    {
        SrdoConfiguration srdo;
        srdo.number = number;
        srdo.place = communication.place;
        ReadCommunication(srdo);
        ReadMapping(srdo);
        if (device_.Find(kSignatureIndex) != nullptr)
        {
            srdo.signature = ReadAt(kSignatureIndex, number, kUnsigned16, srdo.place, srdo.other_problems);
        }
        return srdo;
    }

  private:
    [[nodiscard]] Field ReadAt(const std::uint16_t index, const std::uint8_t sub, const std::uint16_t data_type,
                               const Place place, std::vector<Finding>& problems) const
    {
        return ReadField(device_, index, sub, data_type, node_id_, place, problems);
    }

    [[nodiscard]] bool IsFixed(const std::uint16_t index, const std::uint8_t sub) const
    {
        const Entry* const entry = device_.Find(index, sub);
        return entry != nullptr && entry->IsFixed();
    }

    void ReadCommunication(SrdoConfiguration& srdo) const
    {
        const std::uint16_t index = srdo.CommunicationIndex();
        srdo.highest_sub = ReadAt(index, 0U, kUnsigned8, srdo.place, srdo.other_problems);
        srdo.direction = ReadAt(index, 1U, kUnsigned8, srdo.place, srdo.signature_problems);
        srdo.sct_ms = ReadAt(index, 2U, kUnsigned16, srdo.place, srdo.signature_problems);
        srdo.srvt_ms = ReadAt(index, 3U, kUnsigned8, srdo.place, srdo.signature_problems);
        srdo.transmission_type = ReadAt(index, 4U, kUnsigned8, srdo.place, srdo.other_problems);
        srdo.cob_id_1 = ReadAt(index, 5U, kUnsigned32, srdo.place, srdo.signature_problems);
        srdo.cob_id_2 = ReadAt(index, 6U, kUnsigned32, srdo.place, srdo.signature_problems);
    }

    void ReadMapping(SrdoConfiguration& srdo) const
    {
        const std::uint16_t index = srdo.MappingIndex();
        const Object* const object = device_.Find(index);
        if (object == nullptr)
        {
            AddError(srdo.signature_problems, srdo.place, Hex(index, 4),
                     {"SRDO " + std::to_string(srdo.number) + " has no mapping parameters",
                      "a section [" + Hex(index, 4).substr(2U) + "]"});
            return;
        }
        srdo.entry_count = ReadAt(index, 0U, kUnsigned8, object->place, srdo.signature_problems);
        const std::uint64_t count = srdo.entry_count.value.value_or(0U);
        if (count > kMaxMappingEntries)
        {
            AddError(srdo.signature_problems, srdo.entry_count.place, ObjectName(index, 0U),
                     {std::to_string(count) + " mapping entries", "at most 128"});
            return;
        }
        srdo.is_static = count != 0U && IsFixed(index, 0U);
        for (std::uint64_t place = 1U; place <= count; ++place)
        {
            const auto sub = static_cast<std::uint8_t>(place);
            const Field field = ReadAt(index, sub, kUnsigned32, srdo.entry_count.place, srdo.signature_problems);
            srdo.is_static = srdo.is_static && IsFixed(index, sub);
            if (field.value)
            {
                srdo.mapping.push_back({sub, static_cast<std::uint32_t>(*field.value), field.place});
            }
        }
    }

    const Device& device_;
    std::optional<std::uint8_t> node_id_;
};
} // namespace

Field ReadField(const Device& device, const std::uint16_t index, const std::uint8_t sub, const std::uint16_t data_type,
                const std::optional<std::uint8_t> node_id, const Place place, std::vector<Finding>& problems)
{
    const std::string name = ObjectName(index, sub);
    const Entry* const entry = device.Find(index, sub);
    if (entry == nullptr)
    {
        const Object* const object = device.Find(index);
        const Place nearest = object == nullptr ? place : object->place;
        AddError(problems, nearest, name,
                 {"is missing", std::string("an object of type ") + DataTypeOf(data_type).name});
        return {std::nullopt, nearest};
    }
    // An entry without DataType is read by the type that it has to have; the reader has warned.
    const bool is_other_type = entry->data_type != 0U && entry->data_type != data_type;
    if (is_other_type)
    {
        AddError(problems, entry->type_place, name,
                 {"DataType is " + Hex(entry->data_type, 4) + " (" + DataTypeOf(entry->data_type).name + ")",
                  Hex(data_type, 4) + " (" + DataTypeOf(data_type).name + ")"});
    }
    const Text& text = entry->Configured();
    if (!text.IsSet())
    {
        AddError(problems, entry->place, name, {"has no value", "a ParameterValue or DefaultValue"});
        return {std::nullopt, entry->place};
    }
    const ValueResult result = ParseValue(text.text, data_type, node_id);
    if (!result.value)
    {
        AddError(problems, text.place, name, result.problem);
        return {std::nullopt, text.place};
    }
    return {result.value->bits, text.place};
}

std::optional<std::pair<std::uint16_t, Place>> FirstSafetyObject(const Device& device)
{
    constexpr std::uint16_t first = 0x1300U;
    constexpr std::uint16_t last = 0x13FFU;
    const auto found = device.objects.lower_bound(first);
    if (found != device.objects.end() && found->first <= last)
    {
        return std::pair(found->first, found->second.place);
    }
    const auto listed = device.missing.lower_bound(first);
    const bool is_listed = listed != device.missing.end() && listed->first <= last;
    return is_listed ? std::optional(std::pair(listed->first, listed->second)) : std::nullopt;
}

bool SrdoConfiguration::Maps(const Entry& entry) const noexcept
{
    return std::any_of(mapping.begin(), mapping.end(), [&entry](const MappingEntry& mapped)
                       { return mapped.Index() == entry.index && mapped.Sub() == entry.sub; });
}

bool SafetyConfiguration::Maps(const Entry& entry) const noexcept
{
    return std::any_of(srdos.begin(), srdos.end(),
                       [&entry](const SrdoConfiguration& srdo) { return srdo.Maps(entry); });
}

bool SafetyConfiguration::MapsToReceive(const Entry& entry) const noexcept
{
    return std::any_of(srdos.begin(), srdos.end(),
                       [&entry](const SrdoConfiguration& srdo) { return srdo.IsConsumer() && srdo.Maps(entry); });
}

SafetyConfiguration ExtractSafety(const Device& device, const std::optional<std::uint8_t> node_id)
{
    SafetyConfiguration configuration;
    const SrdoReader reader(device, node_id);
    for (std::uint8_t number = 1U; number <= kMaxSrdos; ++number)
    {
        const auto index = static_cast<std::uint16_t>(kFirstCommunicationIndex + number - 1U);
        const Object* const object = device.Find(index);
        if (object != nullptr)
        {
            configuration.srdos.push_back(reader.Read(number, *object));
        }
    }
    for (const auto& [index, place] : device.missing)
    {
        if (device.IsSafetyObject(index))
        {
            AddError(configuration.missing, place, Hex(index, 4), {"is listed", "a section that describes it"});
        }
    }
    const auto read = [&](const std::uint16_t index, Field& field)
    {
        if (device.Find(index) != nullptr)
        {
            field = ReadField(device, index, 0U, kUnsigned8, node_id, {}, configuration.problems);
        }
    };
    read(kGfcIndex, configuration.gfc);
    read(kConfigurationValidIndex, configuration.configuration_valid);
    read(kSignatureIndex, configuration.signature_count);
    configuration.limits = LimitProblems(device, node_id);
    return configuration;
}

void RequireNone(const std::string& file, const std::vector<Finding>& problems)
{
    const auto found = std::find_if(problems.begin(), problems.end(),
                                    [](const Finding& finding) { return finding.severity == Severity::kError; });
    if (found != problems.end())
    {
        const std::string object = found->object.empty() ? "" : found->object + ": ";
        throw InputError(file, found->place, {object + found->text, ""});
    }
}
} // namespace counterpoint::cia306
