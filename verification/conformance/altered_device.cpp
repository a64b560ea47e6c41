// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/conformance/altered_device.hpp"

namespace counterpoint::conformance
{

void AlteredDevice::Take(const Device& device, const Dictionary& dictionary) noexcept
{
    config_ = device.config;
    config_.objects = dictionary.Objects();
    if (config_.object_count == kAllObjects)
    {
        config_.object_count = Dictionary::kObjectCount;
    }
    if (config_.srdo_count <= kAlterable)
    {
        for (SlotIndex slot = 0U; slot < config_.srdo_count; ++slot)
        {
            setups_[slot] = device.config.srdos[slot];
        }
        config_.srdos = setups_;
    }
}

void AlteredDevice::Alter(const Step& step) noexcept
{
    const Parameter parameter = static_cast<Parameter>(step.field);
    if (step.slot < kAlterable)
    {
        AlterSetup(parameter, setups_[step.slot], step.x);
    }
    AlterDevice(parameter, step.x);
    AlterTimes(parameter, step.x);
}

void AlteredDevice::AlterDevice(Parameter parameter, std::uint32_t value) noexcept
{
    const std::uint8_t byte = static_cast<std::uint8_t>(value & 0xFFU);
    std::uint8_t* const bytes[] = {&config_.node_id, &config_.granularity_bits, &config_.map_entries};
    if (parameter <= Parameter::kMapEntries)
    {
        *bytes[static_cast<std::uint8_t>(parameter)] = byte;
    }
    config_.dummies = (parameter == Parameter::kDummyMapping) ? static_cast<DummyMapping>(byte) : config_.dummies;
    config_.gaps = (parameter == Parameter::kNumberGaps) ? static_cast<NumberGaps>(byte) : config_.gaps;
    config_.gfc = (parameter == Parameter::kGfc) ? static_cast<GfcUse>(byte) : config_.gfc;
    config_.normal_port = (parameter == Parameter::kNormalPort) ? static_cast<CanPortId>(byte) : config_.normal_port;
    config_.inverse_port = (parameter == Parameter::kInversePort) ? static_cast<CanPortId>(byte) : config_.inverse_port;
}

void AlteredDevice::AlterTimes(Parameter parameter, std::uint32_t value) noexcept
{
    std::uint32_t* const words[] = {&config_.cycle_us,
                                    &config_.cycle_tolerance_us,
                                    &config_.discrepancy_us,
                                    &config_.acknowledge_window_us,
                                    &config_.diagnostic_interval_us,
                                    &config_.test_interval_us,
                                    &config_.clock_tolerance_us,
                                    &config_.clock_interval_us,
                                    &config_.output_time_us,
                                    &config_.digest};
    if ((parameter >= Parameter::kCycle) && (parameter <= Parameter::kDigest))
    {
        *words[static_cast<std::uint8_t>(parameter) - static_cast<std::uint8_t>(Parameter::kCycle)] = value;
    }
}

void AlteredDevice::AlterSetup(Parameter parameter, SrdoSetup& setup, std::uint32_t value) noexcept
{
    const std::uint8_t byte = static_cast<std::uint8_t>(value & 0xFFU);
    setup.number = (parameter == Parameter::kNumber) ? byte : setup.number;
    setup.policy = (parameter == Parameter::kPolicy) ? static_cast<ReleasePolicy>(byte) : setup.policy;
    setup.form = (parameter == Parameter::kForm) ? static_cast<ProducerForm>(byte) : setup.form;
    setup.detection = (parameter == Parameter::kDetection) ? static_cast<SrvtDetection>(byte) : setup.detection;
    setup.safe_value.low = (parameter == Parameter::kSafeLow) ? value : setup.safe_value.low;
    setup.safe_value.high = (parameter == Parameter::kSafeHigh) ? value : setup.safe_value.high;
}

} // namespace counterpoint::conformance
