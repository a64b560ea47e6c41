// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// A device of one SRDO, linked from the installed package alone. Its hardware layer is the absent one, which guarantees
// nothing, so that the kernel has to refuse to start.
#include "channel_a/channel.hpp"
#include "channel_a/storage.hpp"
#include "channel_b/channel.hpp"
#include "channel_b/storage.hpp"
#include "hal/absent/absent.hpp"
#include "safety_core/kernel/kernel.hpp"

#include <cstdio>

namespace
{

using namespace counterpoint;

class Device final : public Application
{
  public:
    RefreshAnswer OnRefresh(CommunicationIndex /*index*/) noexcept override
    {
        return RefreshAnswer::kSkip;
    }
    void OnSrdoEvent(CommunicationIndex /*index*/) noexcept override
    {
    }
    void OnSrdoError(CommunicationIndex /*index*/, SrdoCause /*cause*/) noexcept override
    {
    }
    void OnGfc() noexcept override
    {
    }
    void OnGfcNotFollowed() noexcept override
    {
    }
    void OnConfigurationInvalid(CommunicationIndex /*index*/) noexcept override
    {
    }
    void OnDeviceFault(const DeviceFaultReport& /*report*/) noexcept override
    {
    }
    void OnFlow(const FlowCount& /*count*/) noexcept override
    {
    }
};

std::uint8_t normal_input[1]{0U};
std::uint8_t inverse_input[1]{0xFFU};
const MappableObject kObjects[]{{0x6000U, 1U, 8U, MapAccess::kConsumer, normal_input},
                                {0x6000U, 2U, 8U, MapAccess::kConsumer, inverse_input}};
const SrdoSetup kSrdos[]{
    {1U, ReleasePolicy::kInterlock, ProducerForm::kApplicationSends, Payload{}, SrvtDetection::kEarly, StaticMap{}}};

DeviceConfig Describe()
{
    DeviceConfig config{};
    config.srdos = kSrdos;
    config.srdo_count = 1U;
    config.objects = kObjects;
    config.object_count = 2U;
    config.node_id = 1U;
    config.granularity_bits = 8U;
    config.map_entries = kUsualMapEntries;
    config.gaps = NumberGaps::kSearched;
    config.gfc = GfcUse::kPresent;
    config.normal_port = CanPortId::kFirst;
    config.inverse_port = CanPortId::kFirst;
    config.cycle_us = 1000U;
    config.cycle_tolerance_us = 500U;
    config.discrepancy_us = 2000U;
    config.acknowledge_window_us = 100000U;
    config.diagnostic_interval_us = 100000U;
    config.test_interval_us = 100000U;
    config.clock_tolerance_us = 1000U;
    config.clock_interval_us = 100000U;
    return config;
}

channel_a::StorageFor<1U> storage_a{};
channel_b::StorageFor<1U> storage_b{};

} // namespace

int main()
{
    channel_a::Channel a{storage_a.Handle()};
    channel_b::Channel b{storage_b.Handle()};
    hal::AbsentCanPorts can{};
    hal::AbsentSafetyOutput output{};
    hal::AbsentWatchdog watchdog{};
    Device device{};
    Kernel kernel{KernelParts{a, b, can, output, watchdog, device}};
    const DeviceConfig config = Describe();
    const StartResult result = kernel.Start(config, FlowCallback::kOff);
    std::printf("Start without hardware: result %u, expected %u (bus order is not guaranteed)\n",
                static_cast<unsigned>(result), static_cast<unsigned>(StartResult::kBusOrder));
    return (result == StartResult::kBusOrder) ? 0 : 1;
}
