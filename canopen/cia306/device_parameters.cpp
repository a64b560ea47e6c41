// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/device_parameters.hpp"

#include "canopen/cia306/data_type.hpp"

namespace counterpoint::cia306
{
namespace
{
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
        const bool has_value = entry != nullptr && entry->Configured().IsSet();
        if (!has_value)
        {
            return;
        }
        const Field field = ReadField(device_, index, sub, data_type, node_id_, entry->line, problems_);
        number = field.value ? static_cast<Number>(*field.value) : number;
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
    ParameterReader reader(device, node_id, problems);
    reader.Read(kDeviceParametersIndex, 1U, kUnsigned32, parameters.cycle_us);
    reader.Read(kDeviceParametersIndex, 2U, kUnsigned32, parameters.cycle_tolerance_us);
    reader.Read(kDeviceParametersIndex, 3U, kUnsigned32, parameters.discrepancy_us);
    reader.Read(kDeviceParametersIndex, 4U, kUnsigned32, parameters.diagnostic_interval_ms);
    reader.Read(kDeviceParametersIndex, 5U, kUnsigned32, parameters.test_interval_ms);
    reader.Read(kDeviceParametersIndex, 6U, kUnsigned32, parameters.clock_tolerance_us);
    reader.Read(kDeviceParametersIndex, 7U, kUnsigned32, parameters.clock_tolerance_interval_us);
    reader.Read(kDeviceParametersIndex, 8U, kUnsigned32, parameters.output_us);
    reader.Read(kDeviceParametersIndex, 9U, kUnsigned32, parameters.acknowledge_window_us);
    for (std::uint8_t number = 1U; number <= kMaxSrdos; ++number)
    {
        SrdoParameters& srdo = parameters.srdos.at(number - 1U);
        reader.Read(kReleasePolicyIndex, number, kUnsigned8, srdo.release_policy);
        reader.Read(kSafeValueIndex, number, kUnsigned64, srdo.safe_value);
        reader.Read(kProducerFormIndex, number, kUnsigned8, srdo.producer_form);
    }
    return parameters;
}
} // namespace counterpoint::cia306
