// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "examples/common/settings.hpp"

namespace counterpoint::examples
{

AbortCode WriteSettings(Kernel& kernel, const SettingList& list) noexcept
{
    for (std::uint32_t number = 0U; number < list.count; ++number)
    {
        const Setting& setting = list.first[number];
        ObjectData data{};
        data.size_bytes = setting.size_bytes;
        for (std::uint32_t byte = 0U; byte < setting.size_bytes; ++byte)
        {
            data.bytes[byte] = static_cast<std::uint8_t>(setting.value >> (8U * byte));
        }
        const AbortCode abort = kernel.WriteObject(setting.address, data);
        if (abort != AbortCode::kNone)
        {
            return abort;
        }
    }
    return AbortCode::kNone;
}

void SetCommonConfig(DeviceConfig& config) noexcept
{
    config.granularity_bits = 8U;
    config.map_entries = kUsualMapEntries;
    config.gfc = GfcUse::kPresent;
    config.normal_port = CanPortId::kFirst;
    config.inverse_port = CanPortId::kFirst;
    config.cycle_us = 1000U;
    config.cycle_tolerance_us = 500U;
    config.discrepancy_us = 5000U;
    config.acknowledge_window_us = 1000000U;
    config.diagnostic_interval_us = 1000000U;
    config.test_interval_us = 1000000U;
    config.clock_tolerance_us = 500U;
    config.clock_interval_us = 100000U;
    config.output_time_us = 1000U;
}

} // namespace counterpoint::examples
