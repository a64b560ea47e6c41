// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/safety/device_parameters.hpp"

#include "canopen/cia306/file/data_type.hpp"

#include <algorithm>

namespace counterpoint::cia306
{
namespace
{
constexpr std::uint16_t kLastDummy = 0x0007U;

std::uint8_t GreatestMapping(const Device& device, const std::optional<std::uint8_t> node_id)
{
    std::uint64_t greatest = kUsualEntries;
    for (std::uint8_t place = 0U; place < kMaxSrdos; ++place)
    {
        const Entry* const count = device.Find(static_cast<std::uint16_t>(kFirstMappingIndex + place), 0U);
        const ValueResult result = count == nullptr ? ValueResult{} : ConfiguredValue(*count, node_id);
        const std::uint64_t entries = result.value ? result.value->bits + (result.value->bits & 1U) : 0U;
        greatest = entries <= kMaxMappingEntries ? std::max(greatest, entries) : greatest;
    }
    return static_cast<std::uint8_t>(greatest);
}

/// What the rest of the file says about things that the objects would tell.
void ReadDefaults(const Device& device, const std::optional<std::uint8_t> node_id, DeviceParameters& parameters)
{
    parameters.granularity_bits = device.granularity_bits.value_or(parameters.granularity_bits);
    parameters.map_entries = GreatestMapping(device, node_id);
    const auto dummy = device.dummies.lower_bound(1U);
    const bool has_dummies = dummy != device.dummies.end() && *dummy <= kLastDummy;
    parameters.dummy_mapping = has_dummies ? kDummiesAllowed : std::uint8_t{0U};
    parameters.gfc_use = device.Find(kGfcIndex) != nullptr ? kGfcPresent : std::uint8_t{0U};
}

/// Reads what is there: an entry that is missing, or has no value, has its default.
class ParameterReader
{
  public:
    ParameterReader(const Device& device, const std::optional<std::uint8_t> node_id, std::vector<Finding>& problems)
        : device_(device), node_id_(node_id), problems_(problems)
    {
    }

    template <typename Number>
    void Read(const std::uint16_t index, const std::uint8_t sub, const std::uint16_t data_type, Number& number)
    {
        const Entry* const entry = device_.Find(index, sub);
        const bool has_value = entry != nullptr && entry->is_safety && entry->Configured().IsSet();
        if (!has_value)
        {
            return;
        }
        const Field field = ReadField(device_, index, sub, data_type, node_id_, entry->place, problems_);
        number = field.value ? static_cast<Number>(*field.value) : number;
    }

    /// Milliseconds that are kept as microseconds in 32 bits. [SRS_CLI_018]
    void ReadInterval(const std::uint8_t sub, std::uint32_t& interval_ms)
    {
        std::uint32_t number = interval_ms;
        Read(kDeviceParametersIndex, sub, kUnsigned32, number);
        if (number > kLongestMs)
        {
            problems_.push_back({Severity::kError, device_.Find(kDeviceParametersIndex, sub)->ValuePlace(),
                                 ObjectName(kDeviceParametersIndex, sub),
                                 "interval of " + std::to_string(number) + " ms, expected at most " +
                                     std::to_string(kLongestMs) + " ms"});
            return;
        }
        interval_ms = number;
    }

  private:
    const Device& device_;
    std::optional<std::uint8_t> node_id_;
    std::vector<Finding>& problems_;
};
} // namespace

DeviceParameters ReadDeviceParameters(const Device& device, const std::optional<std::uint8_t> node_id,
                                      std::vector<Finding>& problems)
{
    DeviceParameters parameters;
    ReadDefaults(device, node_id, parameters);
    ParameterReader reader(device, node_id, problems);
    reader.Read(kDeviceParametersIndex, 1U, kUnsigned32, parameters.cycle_us);
    reader.Read(kDeviceParametersIndex, 2U, kUnsigned32, parameters.cycle_tolerance_us);
    reader.Read(kDeviceParametersIndex, 3U, kUnsigned32, parameters.discrepancy_us);
    reader.ReadInterval(4U, parameters.diagnostic_interval_ms);
    reader.ReadInterval(5U, parameters.test_interval_ms);
    reader.Read(kDeviceParametersIndex, 6U, kUnsigned32, parameters.clock_tolerance_us);
    reader.Read(kDeviceParametersIndex, 7U, kUnsigned32, parameters.clock_tolerance_interval_us);
    reader.Read(kDeviceParametersIndex, 8U, kUnsigned32, parameters.output_us);
    reader.Read(kDeviceParametersIndex, 9U, kUnsigned32, parameters.acknowledge_window_us);
    reader.Read(kDeviceParametersIndex, kGranularitySub, kUnsigned8, parameters.granularity_bits);
    reader.Read(kDeviceParametersIndex, kMapEntriesSub, kUnsigned8, parameters.map_entries);
    reader.Read(kDeviceParametersIndex, kDummyMappingSub, kUnsigned8, parameters.dummy_mapping);
    reader.Read(kDeviceParametersIndex, kNumberGapsSub, kUnsigned8, parameters.number_gaps);
    reader.Read(kDeviceParametersIndex, kGfcUseSub, kUnsigned8, parameters.gfc_use);
    reader.Read(kDeviceParametersIndex, kNormalPortSub, kUnsigned8, parameters.normal_port);
    reader.Read(kDeviceParametersIndex, kInversePortSub, kUnsigned8, parameters.inverse_port);
    reader.Read(kDigestIndex, 0U, kUnsigned32, parameters.digest);
    for (std::uint8_t number = 1U; number <= kMaxSrdos; ++number)
    {
        SrdoParameters& srdo = parameters.srdos.at(number - 1U);
        reader.Read(kReleasePolicyIndex, number, kUnsigned8, srdo.release_policy);
        reader.Read(kSafeValueIndex, number, kUnsigned64, srdo.safe_value);
        reader.Read(kProducerFormIndex, number, kUnsigned8, srdo.producer_form);
        reader.Read(kDetectionIndex, number, kUnsigned8, srdo.srvt_detection);
    }
    return parameters;
}
} // namespace counterpoint::cia306
