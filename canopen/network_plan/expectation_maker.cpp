// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/network_plan/loaded_network.hpp"

#include "canopen/cia306/check/check.hpp"
#include "canopen/cia306/safety/safety_configuration.hpp"
#include "canopen/cia306/text/input_error.hpp"

#include <algorithm>

namespace counterpoint::network_plan
{
namespace
{
using cia302::ExpectedObject;
using cia306::Device;
using cia306::SafetyConfiguration;
using cia306::SrdoConfiguration;

constexpr std::uint16_t kGfc = 0x1300U;
constexpr std::uint16_t kSignatures = 0x13FFU;

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
        const auto value = static_cast<std::uint32_t>(field.value.value_or(0U));
        list_.push_back({{index, sub}, value, IsFixed(device_, index, sub)});
    }
    void AddSrdo(const SrdoConfiguration& srdo)
    {
        const cia306::Field* const settings[] = {&srdo.direction,         &srdo.sct_ms,   &srdo.srvt_ms,
                                                 &srdo.transmission_type, &srdo.cob_id_1, &srdo.cob_id_2};
        std::uint8_t sub = 1U;
        for (const cia306::Field* const field : settings)
        {
            Add(srdo.CommunicationIndex(), sub, *field);
            ++sub;
        }
        Add(srdo.MappingIndex(), 0U, srdo.entry_count);
        for (const cia306::MappingEntry& entry : srdo.mapping)
        {
            Add(srdo.MappingIndex(), entry.sub, {entry.raw, entry.line});
        }
        Add(kSignatures, srdo.number, srdo.signature);
    }
    std::vector<ExpectedObject> Sorted()
    {
        std::sort(list_.begin(), list_.end(), [](const ExpectedObject& left, const ExpectedObject& right)
                  { return KeyOf(left.address).value < KeyOf(right.address).value; });
        return list_;
    }

  private:
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
            throw cia306::InputError(device.file, finding.line,
                                     {(finding.object.empty() ? "" : finding.object + ": ") + finding.text, ""});
        }
    }
}
} // namespace

std::vector<ExpectedObject> MakeExpectation(const Device& device, const std::uint8_t node_id)
{
    const SafetyConfiguration safety = cia306::ExtractSafety(device, node_id);
    const bool is_safety_slave = std::any_of(safety.srdos.begin(), safety.srdos.end(), [](const SrdoConfiguration& srdo)
                                             { return srdo.IsProducer() || srdo.IsConsumer(); });
    if (!is_safety_slave)
    {
        return {};
    }
    RequireRight(device, node_id);
    Maker maker(device);
    for (const SrdoConfiguration& srdo : safety.srdos)
    {
        maker.AddSrdo(srdo);
    }
    if (device.Find(kGfc, 0U) != nullptr && safety.gfc.value)
    {
        maker.Add(kGfc, 0U, safety.gfc);
    }
    if (device.Find(kSignatures, 0U) != nullptr && safety.signature_count.value)
    {
        maker.Add(kSignatures, 0U, safety.signature_count);
    }
    return maker.Sorted();
}
} // namespace counterpoint::network_plan
