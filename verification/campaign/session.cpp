// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/session.hpp"

#include "verification/campaign/two_cpus.hpp"
#include "version/version.hpp"

#include <algorithm>

namespace counterpoint::campaign
{
namespace
{
constexpr std::size_t kRegionBytes = std::size_t{1U} << 20U;

DeviceSetup SetupOf(const Plan& plan)
{
    DeviceSetup setup;
    setup.has_call_faults = std::any_of(plan.parts.begin(), plan.parts.end(), [](const Part part)
                                        { return part == Part::kCallsOfA || part == Part::kCallsOfB; });
    setup.has_self_test = plan.has_self_test;
    return setup;
}

std::unique_ptr<Device> MakeDevice(Region& region, const RecordedScenario& scenario, const Plan& plan)
{
    if (!scenario.HasTwoCpus())
    {
        return std::make_unique<Device>(region, scenario.Model(), scenario.Record(), plan.output, SetupOf(plan));
    }
    if (plan.output != OutputKind::kGate || plan.has_self_test)
    {
        throw runtime::YamlError(plan.file, plan.device_node.place, "output: pins or self_test: true with two CPUs",
                                 "output: gate and self_test: false");
    }
    return std::make_unique<TwoCpus>(region, scenario, SetupOf(plan).has_call_faults);
}

Limits LimitsFor(const RecordedScenario& scenario, const Device& device)
{
    if (!scenario.HasTwoCpus())
    {
        return LimitsOf(scenario.Model(), device.Config());
    }
    return LimitsOf(scenario.Model(), device.Config(), LinkConfigOf(scenario, PeerRole::kA));
}
} // namespace

Session::Session(const std::string& plan_file)
    : plan_(ReadPlan(plan_file)), scenario_(plan_.scenario, runtime::YamlValue(plan_.file, plan_.device_node)),
      region_(kRegionBytes), device_(MakeDevice(region_, scenario_, plan_)),
      judge_(scenario_.Record(), scenario_.Model(), *device_), limits_(LimitsFor(scenario_, *device_)),
      space_(plan_, scenario_.Record(), *device_, HorizonOf(limits_, device_->Config())),
      runner_(*device_, judge_, scenario_.Record(), space_, limits_)
{
}

/// Of the text of the plan, of what the device receives, of how it lies in memory, and of the program.
ResultsOf Session::Identity(const Shard& shard) const
{
    std::uint64_t digest = plan_.digest;
    const auto add = [&digest](const std::uint64_t value) { digest = (digest ^ value) * 0x100000001B3U; };
    for (const RecordedFrame& frame : scenario_.Record().frames)
    {
        add(static_cast<std::uint64_t>(frame.at));
        add(frame.stamped.frame.identifier);
        add(NumberIn(frame.stamped.frame));
    }
    for (const RecordedCycle& cycle : scenario_.Record().cycles)
    {
        add(static_cast<std::uint64_t>(cycle.at));
        add(cycle.call.acknowledge_a);
        add(static_cast<std::uint64_t>(cycle.nmt));
    }
    for (const RecordedInput& input : scenario_.Record().inputs)
    {
        add(input.cycle);
        add(input.value);
    }
    for (const Place& place : device_->Places())
    {
        add(place.offset);
        add(place.size);
    }
    return {OfProgram(digest, CounterpointVersion), space_.Size(), shard};
}
} // namespace counterpoint::campaign
