// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/network_plan/loaded_network.hpp"

#include "canopen/cia306/check/check.hpp"
#include "canopen/cia306/file/data_type.hpp"
#include "canopen/cia306/safety/device_parameters.hpp"
#include "canopen/cia306/safety/safety_configuration.hpp"
#include "canopen/cia306/text/input_error.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace counterpoint::network_plan
{
namespace
{
using cia302::ExpectedObject;
using cia306::Device;
using cia306::SafetyConfiguration;
using cia306::SrdoConfiguration;

constexpr std::uint16_t kGfc = 0x1300U;
constexpr std::uint16_t kLastCommunication = 0x1340U;
constexpr std::uint16_t kLastMapping = 0x13C0U;
constexpr std::uint16_t kSignatures = 0x13FFU;

bool IsOfSrdo(const std::uint16_t index)
{
    return index >= cia306::kFirstCommunicationIndex && index <= kLastCommunication;
}

/// An SRDO that is off, or that has no section of its own, may be switched on over the bus like any other.
bool DescribesSrdos(const Device& device, const SafetyConfiguration& safety)
{
    return !safety.srdos.empty() || std::any_of(device.missing.begin(), device.missing.end(),
                                                [](const auto& missing) { return IsOfSrdo(missing.first); });
}

bool IsFixed(const Device& device, const std::uint16_t index, const std::uint8_t sub)
{
    const cia306::Entry* const entry = device.Find(index, sub);
    return entry != nullptr && entry->IsFixed();
}

class Maker
{
  public:
    explicit Maker(const Device& device) : device_(device)
    {
    }

    void Add(const std::uint16_t index, const std::uint8_t sub, const cia306::Field& field)
    {
        list_.push_back({{index, sub}, field.value.value_or(0U), IsFixed(device_, index, sub)});
    }
    void AddSrdo(const SrdoConfiguration& srdo)
    {
        const cia306::Field* const settings[] = {&srdo.direction,         &srdo.sct_ms,   &srdo.srvt_ms,
                                                 &srdo.transmission_type, &srdo.cob_id_1, &srdo.cob_id_2};
        Add(srdo.CommunicationIndex(), 0U, srdo.highest_sub);
        std::uint8_t sub = 1U;
        for (const cia306::Field* const field : settings)
        {
            Add(srdo.CommunicationIndex(), sub, *field);
            ++sub;
        }
        Add(srdo.MappingIndex(), 0U, srdo.entry_count);
        for (const cia306::MappingEntry& entry : srdo.mapping)
        {
            Add(srdo.MappingIndex(), entry.sub, {entry.raw, entry.place});
        }
        Add(kSignatures, srdo.number, srdo.signature);
    }
    /// What is a part of the slave's program beside the SRDOs: entries above the count of a mapping, signatures of
    /// SRDOs that are not there.
    void AddConstants(const std::uint16_t index, const std::uint8_t node_id)
    {
        const cia306::Object* const object = device_.Find(index);
        const auto entries = (object == nullptr) ? std::map<std::uint8_t, cia306::Entry>{} : object->entries;
        for (const auto& [sub, entry] : entries)
        {
            const std::uint8_t size = cia302::SizeOf({index, sub});
            const bool is_meant = sub > 0U && entry.access == cia306::Access::kConstant && !Has(index, sub);
            std::vector<cia306::Finding> problems;
            const std::uint16_t type = (size == 2U) ? cia306::kUnsigned16 : cia306::kUnsigned32;
            const cia306::Field field = cia306::ReadField(device_, index, sub, type, node_id, entry.place, problems);
            if (is_meant && problems.empty())
            {
                Add(index, sub, field);
            }
        }
    }
    /// What 13FFh does not cover: the digest over all of it, or what the file has of an SRDO. [SRS_NET_670]
    void AddParameters(const std::uint8_t node_id)
    {
        constexpr std::uint16_t kOfSrdos[] = {cia306::kReleasePolicyIndex, cia306::kSafeValueIndex,
                                              cia306::kDetectionIndex};
        const std::uint64_t digest = ValueOf(cia306::kDigestIndex, 0U, node_id).value_or(0U);
        if (digest != 0U)
        {
            list_.push_back({{cia306::kDigestIndex, 0U}, digest, true});
            return;
        }
        for (const std::uint16_t index : kOfSrdos)
        {
            for (std::uint8_t number = 1U; number <= cia306::kMaxSrdos; ++number)
            {
                if (const std::optional<std::uint64_t> value = ValueOf(index, number, node_id))
                {
                    list_.push_back({{index, number}, *value, true});
                }
            }
        }
    }
    std::vector<ExpectedObject> Sorted()
    {
        std::sort(list_.begin(), list_.end(), [](const ExpectedObject& left, const ExpectedObject& right)
                  { return KeyOf(left.address).value < KeyOf(right.address).value; });
        return list_;
    }

  private:
    /// Of a file that RequireRight let pass.
    [[nodiscard]] std::optional<std::uint64_t> ValueOf(const std::uint16_t index, const std::uint8_t sub,
                                                       const std::uint8_t node_id) const
    {
        const cia306::Entry* const entry = device_.Find(index, sub);
        const cia306::ValueResult result =
            (entry == nullptr) ? cia306::ValueResult{} : cia306::ConfiguredValue(*entry, node_id);
        return result.value ? std::optional<std::uint64_t>(result.value->bits) : std::nullopt;
    }
    [[nodiscard]] bool Has(const std::uint16_t index, const std::uint8_t sub) const
    {
        return std::any_of(list_.begin(), list_.end(), [=](const ExpectedObject& object)
                           { return object.address.index == index && object.address.sub == sub; });
    }

    const Device& device_;
    std::vector<ExpectedObject> list_;
};

/// Whoever expects something wrong would never start the slave, or start the wrong one.
void RequireRight(const Device& device, const std::uint8_t node_id)
{
    cia306::CheckOptions options;
    options.node_id = node_id;
    for (const cia306::Finding& finding : cia306::CheckDevice(device, options))
    {
        if (finding.severity == cia306::Severity::kError)
        {
            throw cia306::InputError(device.file, finding.place,
                                     {(finding.object.empty() ? "" : finding.object + ": ") + finding.text, ""});
        }
    }
}
} // namespace

std::vector<ExpectedObject> MakeExpectation(const Device& device, const std::uint8_t node_id)
{
    const SafetyConfiguration safety = cia306::ExtractSafety(device, node_id);
    if (!DescribesSrdos(device, safety))
    {
        return {};
    }
    RequireRight(device, node_id); // From here on each object of an SRDO is there and has a value.
    Maker maker(device);
    for (const SrdoConfiguration& srdo : safety.srdos)
    {
        maker.AddSrdo(srdo);
    }
    if (device.Find(kGfc, 0U) != nullptr)
    {
        maker.Add(kGfc, 0U, safety.gfc);
    }
    if (device.Find(kSignatures, 0U) != nullptr)
    {
        maker.Add(kSignatures, 0U, safety.signature_count);
    }
    for (std::uint16_t index = cia306::kFirstMappingIndex; index <= kLastMapping; ++index)
    {
        maker.AddConstants(index, node_id);
    }
    maker.AddConstants(kSignatures, node_id);
    maker.AddParameters(node_id);
    return maker.Sorted();
}
} // namespace counterpoint::network_plan
