// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/session.hpp"

#include "simulator/scenario/reader.hpp"
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

/// What the device receives, how it lies in memory, what it is made of, and by which limits it is judged. [SRS_CMG_800]
std::uint64_t Session::SettingDigest() const
{
    std::uint64_t digest = WithFiles(kNoDigest, simulator::FilesOf(simulator::LoadScenario(plan_.scenario)));
    for (const RecordedFrame& frame : scenario_.Record().frames)
    {
        digest = With(digest, static_cast<std::uint64_t>(frame.at));
        digest = With(digest, frame.stamped.frame.identifier);
        digest = With(digest, NumberIn(frame.stamped.frame));
    }
    for (const RecordedCycle& cycle : scenario_.Record().cycles)
    {
        digest = With(digest, static_cast<std::uint64_t>(cycle.at));
        digest = With(digest, cycle.call.acknowledge_a);
        digest = With(digest, static_cast<std::uint64_t>(cycle.nmt));
    }
    for (const RecordedInput& input : scenario_.Record().inputs)
    {
        digest = With(digest, input.cycle);
        digest = With(digest, input.value);
    }
    for (const Place& place : device_->Places())
    {
        digest = With(digest, place.offset);
        digest = With(digest, place.size);
    }
    for (const std::uint32_t us : limits_.us)
    {
        digest = With(digest, us);
    }
    digest = With(digest, limits_.wrong_frame_us);
    digest = With(digest, limits_.wrong_channel_us);
    return With(digest, limits_.drift_us);
}

ResultsOf Session::Identity(const Shard& shard) const
{
    return {plan_.digest, space_.Size(), shard, SettingDigest(), OfProgram(kNoDigest, CounterpointVersion), &StrangeIn};
}
} // namespace counterpoint::campaign
