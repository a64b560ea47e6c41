// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/build.hpp"

#include "canopen/cia306/text/input_error.hpp"

#include <algorithm>
#include <string>

namespace counterpoint::runtime
{
namespace
{
constexpr std::uint32_t kCyclesOfDiscrepancy = 5U;
constexpr std::uint64_t kLongestIntervalUs = 0x3FFFFFFFU;
/// Of a device that waits for its node-ID: nobody sees it.
constexpr std::uint8_t kPlaceholder = 127U;
constexpr std::uint16_t kHistory = 0x1003U;
} // namespace

DeviceConfig ConfigOf(const runtime::DeviceModel& model, const std::vector<MappableObject>& objects,
                      const std::optional<std::uint32_t> cycle_us)
{
    DeviceConfig config = model.Config();
    config.objects = objects.data();
    config.object_count = static_cast<std::uint16_t>(objects.size());
    if (cycle_us && *cycle_us != config.cycle_us)
    {
        for (const runtime::SrdoModel& srdo : model.Srdos())
        {
            if (srdo.direction == kDirectionProducer && *cycle_us > srdo.times.sct_ms * kMicrosecondsPerMillisecond)
            {
                throw cia306::InputError(model.File(), 0U,
                                         {"--cycle-us " + std::to_string(*cycle_us) + " for SRDO " +
                                              std::to_string(srdo.number) + ", which is sent every " +
                                              std::to_string(srdo.times.sct_ms) + " ms",
                                          "a cycle that is no longer"});
            }
        }
        // As many cycles as before: the self tests do as much in each.
        const std::uint64_t cycles = config.diagnostic_interval_us / config.cycle_us;
        const std::uint64_t same_us = std::min<std::uint64_t>(cycles * *cycle_us, kLongestIntervalUs);
        config.cycle_us = *cycle_us;
        config.cycle_tolerance_us = *cycle_us;
        config.discrepancy_us = std::max(config.discrepancy_us, kCyclesOfDiscrepancy * *cycle_us);
        config.diagnostic_interval_us = std::max(
            {config.diagnostic_interval_us, static_cast<std::uint32_t>(same_us), 2U * *cycle_us * config.srdo_count});
        config.test_interval_us = std::max(config.test_interval_us, *cycle_us);
        config.digest = 0U;
    }
    return config;
}

std::vector<MappableObject> SafetyObjectsOf(const runtime::DeviceModel& model, const cia306::Device& device)
{
    std::vector<MappableObject> kept;
    for (std::size_t place = 0U; place < model.Objects().size(); ++place)
    {
        const MappableObject& object = model.Objects()[place];
        const cia306::Entry* const entry = device.Find(object.index, object.sub);
        const bool is_mapped =
            std::any_of(model.Pairs().begin(), model.Pairs().end(), [place](const runtime::VariablePair& pair)
                        { return pair.normal == place || pair.inverse == place; });
        if (is_mapped || (entry != nullptr && entry->is_srdo_mappable.value_or(false)))
        {
            kept.push_back(object);
        }
    }
    return kept;
}

const runtime::DeviceModel& UseControllers(runtime::DeviceModel& model, NodePorts& ports)
{
    const bool has_second = ports.Inverse() != nullptr;
    if (has_second)
    {
        model.UseTwoControllers();
    }
    else if (model.ControllerCount() != 1U)
    {
        throw cia306::InputError(model.File(), 0U,
                                 {"a device with two controllers, 0x5F00:10 = 2", "--can2 for the second one"});
    }
    return model;
}

NodeObjects::IsKernels KernelsOf(const DeviceConfig& config)
{
    return [&config](const std::uint16_t index, const std::uint8_t sub)
    {
        const bool is_safety = index >= cia301::kFirstKernelIndex && index <= cia301::kLastKernelIndex;
        return is_safety || FindObject(config, KeyOf({index, sub})) != nullptr;
    };
}

std::optional<std::uint8_t> NodeIdOf(const NodeSettings& settings, const cia306::Device& file, const bool has_lss)
{
    const std::optional<std::uint8_t> wanted = settings.lss_node_id ? settings.lss_node_id : settings.node_id;
    const bool is_waiting = has_lss && !wanted && !file.node_id;
    return is_waiting ? std::optional(kPlaceholder) : wanted;
}

std::uint8_t HistoryOf(const cia306::Device& file)
{
    const cia306::Object* const object = file.Find(kHistory);
    return (object == nullptr || object->entries.empty()) ? std::uint8_t{0U} : object->entries.rbegin()->first;
}
} // namespace counterpoint::runtime
