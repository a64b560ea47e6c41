// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/judge/run.hpp"

#include "simulator/scenario/checks.hpp"
#include "simulator/scenario/names.hpp"
#include "simulator/scenario/reader.hpp"

#include <algorithm>

namespace counterpoint::simulator
{
namespace
{
constexpr Nanoseconds kStep = kNanosecondsPerSecond / 10;
constexpr std::size_t kMostRecorded = 500000U;

std::string LineOf(const Source& source, const std::string& what, const std::string& expected)
{
    return source.file + ":" + std::to_string(source.place.line) + ":" + std::to_string(source.place.column) + ": " +
           what + ", expected " + expected;
}

Scenario Changed(Scenario scenario, const std::optional<std::uint64_t> seed, const std::optional<Nanoseconds> until)
{
    RequireHappening(scenario);
    scenario.seed = seed.value_or(scenario.seed);
    scenario.duration = until.value_or(scenario.duration);
    RequirePossible(scenario);
    return scenario;
}
} // namespace

Run::Run(const std::string& file, const std::optional<std::uint64_t> seed, const std::optional<Nanoseconds> until,
         const bool keeps_all)
    : scenario_(Changed(ReadScenario(file), seed, until)), journal_(keeps_all),
      network_(std::make_unique<Network>(scenario_, journal_))
{
}

Run::Run(const Scenario& scenario, const std::optional<Nanoseconds> until, const bool keeps_all)
    : scenario_(Changed(scenario, std::nullopt, until)), journal_(keeps_all),
      network_(std::make_unique<Network>(scenario_, journal_))
{
}

void Run::Simulate(const std::function<void(Nanoseconds)>& progress)
{
    for (Nanoseconds now = 0; now < scenario_.duration;)
    {
        now = std::min(now + kStep, scenario_.duration);
        network_->RunUntil(now);
        const std::size_t recorded = journal_.Events().size() + journal_.Frames().size();
        if (journal_.KeepsAll() && recorded > kMostRecorded)
        {
            throw YamlError(scenario_.file, {}, "more than 500000 frames and events to record",
                            "a shorter run, or --quiet without output files");
        }
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

const runtime::DeviceModel& Run::ModelOf(const NodeIndex node) const
{
    return network_->At(node).Model();
}

const std::vector<ExpectationVerdict>& Run::Verdicts() const noexcept
{
    return verdicts_;
}

std::vector<std::string> Run::FaultsWithoutEffect() const
{
    std::vector<std::string> lines;
    for (std::size_t index = 0U; index < scenario_.faults.size(); ++index)
    {
        const FaultSetup& fault = scenario_.faults[index];
        const bool had_effect =
            std::any_of(journal_.Events().begin(), journal_.Events().end(), [index](const Event& event)
                        { return event.kind == EventKind::kFault && event.value == index; });
        if (!had_effect)
        {
            lines.push_back(
                LineOf(fault.source, "fault " + runtime::Shown(fault.name) + " never happened",
                       fault.is_optional ? "nothing else, it is optional" : "it within the run, or 'optional: true'"));
        }
    }
    return lines;
}

std::vector<std::string> Run::Findings() const
{
    std::vector<std::string> lines;
    for (const Happening& late : HappeningsFrom(scenario_, scenario_.duration))
    {
        lines.push_back(LineOf(late.source, late.what + " at " + MillisecondsText(late.at) + " does not happen",
                               "a time before the end of the run at " + MillisecondsText(scenario_.duration)));
    }
    for (const auto& [fault, count] : network_->DroppedCopies())
    {
        const FaultSetup& setup = scenario_.faults[fault];
        lines.push_back(LineOf(setup.source,
                               std::to_string(count) + " copies of " + runtime::Shown(setup.name) + " dropped",
                               "at most 16 receptions of one frame"));
    }
    return lines;
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
