// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/limits.hpp"

#include "safety_core/kernel/limits.hpp"
#include "verification/campaign/variants.hpp"

#include <algorithm>
#include <initializer_list>

namespace counterpoint::campaign
{
namespace
{
std::uint32_t LongestOf(const runtime::DeviceModel& model, const DeviceConfig& config,
                        const std::initializer_list<FaultClass> classes)
{
    std::uint32_t longest = 0U;
    for (const runtime::SrdoModel& srdo : model.Srdos())
    {
        for (const FaultClass each : classes)
        {
            const Limit limit = ComputeLimit(config, srdo.times, each);
            longest = (limit.result == Result::kSuccessful) ? std::max(longest, limit.us) : longest;
        }
    }
    return longest;
}
} // namespace

Limits LimitsOf(const runtime::DeviceModel& model, const DeviceConfig& config)
{
    const std::uint32_t of_channel =
        LongestOf(model, config,
                  {FaultClass::kBus, FaultClass::kBusNextNormal, FaultClass::kChannel, FaultClass::kConfiguration});
    const std::uint32_t of_kernel =
        std::max(of_channel, LongestOf(model, config, {FaultClass::kSupervisor, FaultClass::kClock}));
    Limits limits;
    limits.us.fill(of_kernel);
    limits.us[static_cast<std::size_t>(Part::kChannelA)] = of_channel;
    limits.us[static_cast<std::size_t>(Part::kChannelB)] = of_channel;
    limits.us[static_cast<std::size_t>(Part::kVariables)] = of_channel;
    limits.us[static_cast<std::size_t>(Part::kTables)] = LongestOf(model, config, {FaultClass::kSharedSource});
    const std::uint32_t of_bus = LongestOf(model, config, {FaultClass::kBus, FaultClass::kBusNextNormal});
    const std::uint32_t of_steps =
        std::max(of_bus, LongestOf(model, config, {FaultClass::kSupervisor, FaultClass::kChannel, FaultClass::kClock}));
    limits.wrong_frame_us = LongestOf(model, config, {FaultClass::kWrongFrame});
    limits.wrong_channel_us = std::max(of_bus, LongestOf(model, config, {FaultClass::kChannel}));
    limits.us[static_cast<std::size_t>(Part::kBus)] = of_bus;
    limits.us[static_cast<std::size_t>(Part::kKernelCalls)] = of_bus;
    limits.us[static_cast<std::size_t>(Part::kCallsOfA)] = of_channel;
    limits.us[static_cast<std::size_t>(Part::kCallsOfB)] = of_channel;
    limits.us[static_cast<std::size_t>(Part::kBothChannels)] = of_channel;
    limits.us[static_cast<std::size_t>(Part::kSteps)] = of_steps;
    limits.us[static_cast<std::size_t>(Part::kCycle)] = of_steps;
    limits.us[static_cast<std::size_t>(Part::kInputs)] = of_steps;
    limits.us[static_cast<std::size_t>(Part::kCounters)] = LongestOf(model, config, {FaultClass::kClock});
    return limits;
}

Limits LimitsOf(const runtime::DeviceModel& model, const DeviceConfig& config, const LinkConfig& link)
{
    Limits limits = LimitsOf(model, config);
    const std::uint32_t of_link = ComputeLimit(config, LinkTime{link.timeout_us}).us;
    // A copy of the configuration is compared with that of the other CPU.
    const std::uint32_t of_copy = LongestOf(model, config, {FaultClass::kSharedSource});
    for (std::size_t part = 0U; part < kMemoryPartCount; ++part)
    {
        limits.us[part] = std::max(limits.us[part], of_link);
    }
    for (const Part part : {Part::kChannelA, Part::kChannelB, Part::kTables})
    {
        limits.us[static_cast<std::size_t>(part)] = std::max(of_copy, of_link);
    }
    for (const Part part : {Part::kKernelCalls, Part::kCallsOfA, Part::kCallsOfB, Part::kSteps, Part::kCycle,
                            Part::kInputs, Part::kCommands})
    {
        limits.us[static_cast<std::size_t>(part)] = std::max(limits.us[static_cast<std::size_t>(part)], of_link);
    }
    limits.wrong_channel_us = std::max(limits.wrong_channel_us, of_link);
    limits.us[static_cast<std::size_t>(Part::kLink)] = of_link;
    limits.us[static_cast<std::size_t>(Part::kCpu)] = of_link;
    // A drift shows within an interval in which the clocks are compared.
    limits.drift_us = ComputeLimit(config, LinkTime{link.timeout_us + link.clock_interval_us}).us;
    limits.us[static_cast<std::size_t>(Part::kCounters)] = limits.drift_us;
    return limits;
}

std::uint32_t Limits::Of(const Experiment& experiment) const
{
    const bool is_call = experiment.part == Part::kCallsOfA || experiment.part == Part::kCallsOfB;
    const auto call = static_cast<ChannelCall>(experiment.subject / kTurns);
    // What guard and comparator read is found by their own checks.
    const bool is_read = call == ChannelCall::kHeld || call == ChannelCall::kLoad || call == ChannelCall::kRecheck;
    return (is_call && !is_read) ? wrong_channel_us : Of(experiment.part, experiment.kind);
}

std::size_t HorizonOf(const Limits& limits, const DeviceConfig& config)
{
    return (*std::max_element(limits.us.begin(), limits.us.end()) / config.cycle_us) + kMoreCycles;
}
} // namespace counterpoint::campaign
