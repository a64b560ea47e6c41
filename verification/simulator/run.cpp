// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/simulator/run.hpp"

#include "verification/simulator/scenario_reader.hpp"

#include <algorithm>

namespace counterpoint::simulator
{
namespace
{
constexpr Nanoseconds kStep = kNanosecondsPerSecond;

Scenario Changed(Scenario scenario, const std::optional<std::uint64_t> seed, const std::optional<Nanoseconds> until)
{
    scenario.seed = seed.value_or(scenario.seed);
    scenario.duration = until.value_or(scenario.duration);
    return scenario;
}
} // namespace

Run::Run(const std::string& file, const std::optional<std::uint64_t> seed, const std::optional<Nanoseconds> until,
         const bool keeps_all)
    : scenario_(Changed(ReadScenario(file), seed, until)), journal_(keeps_all),
      network_(std::make_unique<Network>(scenario_, journal_))
{
}

void Run::Simulate(const std::function<void(Nanoseconds)>& progress)
{
    for (Nanoseconds now = 0; now < scenario_.duration;)
    {
        now = std::min(now + kStep, scenario_.duration);
        network_->RunUntil(now);
        if (progress)
        {
            progress(now);
        }
    }
    journal_.Sort();
    verdicts_ = Judge(scenario_, journal_, *network_);
}

const Scenario& Run::Setting() const noexcept
{
    return scenario_;
}

const Journal& Run::Record() const noexcept
{
    return journal_;
}

Network& Run::Devices() noexcept
{
    return *network_;
}

const DeviceModel& Run::ModelOf(const NodeIndex node) const
{
    return network_->At(node).Model();
}

const std::vector<ExpectationVerdict>& Run::Verdicts() const noexcept
{
    return verdicts_;
}

bool Run::Holds() const noexcept
{
    return std::all_of(verdicts_.begin(), verdicts_.end(),
                       [](const ExpectationVerdict& verdict) { return verdict.holds; });
}

const Measurement* Run::FirstMeasurement() const noexcept
{
    for (const ExpectationVerdict& verdict : verdicts_)
    {
        if (verdict.measurement)
        {
            return &*verdict.measurement;
        }
    }
    return nullptr;
}

const std::string& Run::NodeName(const NodeIndex node) const
{
    static const std::string kBus = "bus";
    return (node < scenario_.nodes.size()) ? scenario_.nodes[node].name : kBus;
}
} // namespace counterpoint::simulator
