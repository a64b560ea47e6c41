// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/scenario/checks.hpp"

#include "simulator/scenario/names.hpp"
#include "simulator/scenario/network_names.hpp"

#include "runtime/device/time_text.hpp"

#include <algorithm>

namespace counterpoint::simulator
{
namespace
{
constexpr Nanoseconds kMostSwitches = 100000; ///< How often an intermittent fault may come and go.

/// Whether two faults would work on the same part, counter, object or controller.
bool HitTheSame(const FaultSetup& one, const FaultSetup& other)
{
    if (one.node != other.node)
    {
        return false;
    }
    if (std::holds_alternative<PartFault>(one.kind) && std::holds_alternative<PartFault>(other.kind))
    {
        const bool is_second = one.second_part != Part::kNone && one.second_part == other.second_part;
        return one.part == other.part || one.part == other.second_part || one.second_part == other.part || is_second;
    }
    const Claim claim = RowOf(one.kind).claim;
    if (claim != RowOf(other.kind).claim)
    {
        return false;
    }
    switch (claim)
    {
    case Claim::kNothing:
        return false;
    case Claim::kController:
        return one.controller == 0U || other.controller == 0U || one.controller == other.controller;
    case Claim::kRate:
        return !one.jump && !other.jump &&
               ((one.hits_counter_a && other.hits_counter_a) || (one.hits_counter_b && other.hits_counter_b));
    case Claim::kObject:
        return one.object.index == other.object.index && one.object.sub == other.object.sub;
    }
    return false;
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
                throw YamlError(other.source.file, other.source.place,
                                "fault " + runtime::Shown(other.name) + " overlaps " + runtime::Shown(one.name) +
                                    " on the same part, counter, object or controller",
                                "one fault there at a time");
            }
        }
    }
}

bool HasTime(const Expectation& expectation)
{
    return expectation.kind == ExpectationKind::kReleased || expectation.kind == ExpectationKind::kSafe ||
           expectation.kind == ExpectationKind::kValue || (IsOfNetwork(expectation.kind) && expectation.at != kNever);
}

/// Whether it is about what a device shows at an instant.
bool IsOfDeviceAt(const Expectation& expectation)
{
    const bool is_network =
        expectation.kind == ExpectationKind::kDevice || expectation.kind == ExpectationKind::kOutput;
    return HasTime(expectation) && (!IsOfNetwork(expectation.kind) || is_network);
}

bool HasFault(const Expectation& expectation)
{
    return expectation.kind == ExpectationKind::kDetectedBy || expectation.kind == ExpectationKind::kSafeWithin;
}

/// The end of a fault and its pattern, in whatever way it chooses its time.
Nanoseconds BeginOf(const FaultSetup& fault)
{
    return std::max(fault.at, fault.frames.from);
}

void RequireFewSwitches(const Scenario& scenario, const FaultSetup& fault)
{
    const Nanoseconds period = fault.on + fault.off;
    const Nanoseconds length = std::min(fault.until, scenario.duration) - fault.at;
    if (period > 0 && length / period > kMostSwitches)
    {
        throw YamlError(fault.source.file, fault.source.place,
                        "fault " + runtime::Shown(fault.name) + " that comes and goes " +
                            std::to_string(length / period) + " times",
                        "at most " + std::to_string(kMostSwitches));
    }
}

/// [SRS_SIM_585]
void RequireWithinTheRun(const Scenario& scenario, const Expectation& expectation)
{
    if (HasTime(expectation) && expectation.at > scenario.duration)
    {
        throw YamlError(expectation.source.file, expectation.source.place,
                        "expectation at " + runtime::ExactText(expectation.at) + ", after the end of the run",
                        "a time up to " + runtime::ExactText(scenario.duration));
    }
    if (IsOfEvents(expectation.kind) && expectation.from >= scenario.duration)
    {
        throw YamlError(expectation.source.file, expectation.source.place,
                        "a window from " + runtime::ExactText(expectation.from) + ", not before the end of the run",
                        "'from' below " + runtime::ExactText(scenario.duration));
    }
}

/// What a device shows before it has a supply is the same whatever happens. [SRS_SIM_586]
void RequireThere(const Scenario& scenario, const Expectation& expectation)
{
    const Nanoseconds phase = IsOfDeviceAt(expectation) ? scenario.nodes[expectation.node].phase : -1;
    if (IsOfDeviceAt(expectation) && expectation.at < phase)
    {
        throw YamlError(expectation.source.file, expectation.source.place,
                        "expectation at " + runtime::ExactText(expectation.at) + ", before node " +
                            runtime::Shown(scenario.nodes[expectation.node].name) + " comes",
                        "a time from " + runtime::ExactText(phase) + " on");
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
        throw YamlError(expectation.source.file, expectation.source.place,
                        "fault " + runtime::Shown(name) + ", which is the name of several",
                        "a name of its own for each");
    }
}

/// Who enters OPERATIONAL at a time that the file names (`start_at`, `start_after`), where what leads to it comes
/// before `end`. [SRS_SIM_710]
std::vector<Happening> StartsOf(const Scenario& scenario, const Nanoseconds end)
{
    std::vector<Happening> starts;
    for (const NodeSetup& node : scenario.nodes)
    {
        if (node.names_start && node.phase < end)
        {
            starts.push_back({node.start_at, node.source, "start of node " + runtime::Shown(node.name)});
        }
    }
    for (const NmtEvent& event : scenario.nmt)
    {
        if (event.start_after != kNever && event.at < end)
        {
            starts.push_back({event.at + event.start_after, event.source, "start after an NMT event"});
        }
    }
    for (const PowerCycle& cycle : scenario.power)
    {
        if (cycle.start_after != kNever && cycle.at < end)
        {
            starts.push_back({cycle.at + cycle.off + cycle.start_after, cycle.source, "start after a power cycle"});
        }
    }
    return starts;
}
} // namespace

std::vector<Happening> HappeningsFrom(const Scenario& scenario, const Nanoseconds end)
{
    std::vector<Happening> late;
    const auto add = [&late, end](const Nanoseconds at, const Source& source, const std::string& what)
    {
        if (at >= end)
        {
            late.push_back({at, source, what});
        }
    };
    const auto add_all = [&add](const auto& items, const char* const what)
    {
        for (const auto& item : items)
        {
            add(item.at, item.source, what);
        }
    };
    add_all(scenario.stimuli, "input");
    add_all(scenario.acknowledges, "acknowledge");
    add_all(scenario.nmt, "NMT event");
    add_all(scenario.power, "power cycle");
    add_all(scenario.gfc, "GFC event");
    for (const NodeSetup& node : scenario.nodes)
    {
        add(node.phase, node.source, "node " + runtime::Shown(node.name));
    }
    for (const Happening& start : StartsOf(scenario, end))
    {
        add(start.at, start.source, start.what);
    }
    add_all(scenario.managers, "manager");
    for (const Action& action : scenario.actions)
    {
        add((action.kind == ActionKind::kBusBack) ? 0 : action.at, action.source, NameOf(kActionWords, action.kind));
    }
    for (const FaultSetup& fault : scenario.faults)
    {
        add(BeginOf(fault), fault.source, "fault " + runtime::Shown(fault.name));
    }
    return late;
}

void RequireHappening(const Scenario& scenario)
{
    for (const Happening& first : HappeningsFrom(scenario, scenario.duration))
    {
        if (first.source.file != scenario.file)
        {
            continue; // Of the extended scenario, which may be longer: told after the run.
        }
        throw YamlError(first.source.file, first.source.place,
                        first.what + " at " + runtime::ExactText(first.at) + ", not before the end of the run",
                        "a time below " + runtime::ExactText(scenario.duration));
    }
    for (const FaultSetup& fault : scenario.faults)
    {
        RequireFewSwitches(scenario, fault);
    }
    RequireNetwork(scenario);
    RequireSupply(scenario);
}

void RequirePossible(const Scenario& scenario)
{
    RequireApart(scenario);
    for (const Expectation& expectation : scenario.expectations)
    {
        RequireWithinTheRun(scenario, expectation);
        RequireThere(scenario, expectation);
        RequireOneFault(scenario, expectation);
    }
}
} // namespace counterpoint::simulator
