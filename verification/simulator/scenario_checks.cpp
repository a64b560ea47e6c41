// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/simulator/scenario_checks.hpp"

#include "verification/simulator/names.hpp"

#include <algorithm>

namespace counterpoint::simulator
{
namespace
{
bool IsOfPart(const FaultSetup& fault)
{
    return fault.kind >= FaultKind::kSkipped && fault.kind <= FaultKind::kAlwaysGood;
}

/// Whether two faults would work on the same part, counter or object.
bool HitTheSame(const FaultSetup& one, const FaultSetup& other)
{
    if (one.node != other.node)
    {
        return false;
    }
    if (IsOfPart(one) && IsOfPart(other))
    {
        return one.part == other.part;
    }
    if (one.kind != other.kind)
    {
        return false;
    }
    const bool is_counter = one.kind == FaultKind::kClock && one.is_counter_a == other.is_counter_a;
    const bool is_object = one.kind == FaultKind::kNotInverse && one.object.index == other.object.index &&
                           one.object.sub == other.object.sub;
    return is_counter || is_object;
}

void RequireApart(const Scenario& scenario)
{
    for (std::size_t later = 1U; later < scenario.faults.size(); ++later)
    {
        for (std::size_t earlier = 0U; earlier < later; ++earlier)
        {
            const FaultSetup& one = scenario.faults[earlier];
            const FaultSetup& other = scenario.faults[later];
            const bool overlap = one.at < other.until && other.at < one.until;
            if (overlap && HitTheSame(one, other))
            {
                throw ScenarioError(other.source.file, other.source.place,
                                    "fault " + Shown(other.name) + " overlaps " + Shown(one.name) +
                                        " on the same part, counter or object",
                                    "one fault there at a time");
            }
        }
    }
}

bool HasTime(const Expectation& expectation)
{
    return expectation.kind == ExpectationKind::kReleased || expectation.kind == ExpectationKind::kSafe ||
           expectation.kind == ExpectationKind::kValue;
}

bool HasFault(const Expectation& expectation)
{
    return expectation.kind == ExpectationKind::kDetectedBy || expectation.kind == ExpectationKind::kSafeWithin;
}

void RequireWithinTheRun(const Scenario& scenario, const Expectation& expectation)
{
    if (HasTime(expectation) && expectation.at > scenario.duration)
    {
        throw ScenarioError(expectation.source.file, expectation.source.place,
                            "expectation at " + MillisecondsText(expectation.at) + ", after the end of the run",
                            "a time up to " + MillisecondsText(scenario.duration));
    }
}

void RequireOneFault(const Scenario& scenario, const Expectation& expectation)
{
    if (!HasFault(expectation))
    {
        return;
    }
    const std::string& name = scenario.faults[expectation.fault].name;
    const auto count = std::count_if(scenario.faults.begin(), scenario.faults.end(),
                                     [&name](const FaultSetup& fault) { return fault.name == name; });
    if (count > 1)
    {
        throw ScenarioError(expectation.source.file, expectation.source.place,
                            "fault " + Shown(name) + ", which is the name of several", "a name of its own for each");
    }
}
} // namespace

void RequirePossible(const Scenario& scenario)
{
    RequireApart(scenario);
    for (const Expectation& expectation : scenario.expectations)
    {
        RequireWithinTheRun(scenario, expectation);
        RequireOneFault(scenario, expectation);
    }
}
} // namespace counterpoint::simulator
