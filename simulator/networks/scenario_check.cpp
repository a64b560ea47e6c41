// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What does not fit together in a network scenario: it would do nothing, or hold whatever happens.
#include "simulator/networks/scenario.hpp"

#include "simulator/scenario/names.hpp"

#include <algorithm>

namespace counterpoint::simulator
{
namespace
{
using Action = NetworkActionKind;
using Expected = NetworkExpectationKind;

class Check
{
  public:
    explicit Check(const NetworkScenario& scenario) : scenario_(scenario)
    {
    }

    void Comers() const
    {
        for (const ScenarioManager& manager : scenario_.managers)
        {
            Begins(manager.at_ns, manager.place);
        }
        for (auto device = scenario_.devices.begin(); device != scenario_.devices.end(); ++device)
        {
            Begins(device->at_ns, device->place);
            const auto is_same = [&device](const ScenarioDevice& other) { return other.node == device->node; };
            if (std::any_of(scenario_.devices.begin(), device, is_same))
            {
                Refuse(device->place, "device " + std::to_string(device->node) + " a second time",
                       "each node-ID once; the event 'duplicate' brings another one");
            }
        }
    }
    void Of(const NetworkAction& action) const
    {
        const bool is_bus = action.kind == Action::kBusOff || action.kind == Action::kNoController;
        const bool is_storm = IsStorm(action.kind);
        const bool is_of_manager = IsOfManager(action.kind);
        Begins(action.at_ns, action.place);
        if ((is_storm || is_bus) && action.until_ns < action.at_ns)
        {
            Refuse(action.place, "an end before the beginning", "a time after 'at' behind 'until'");
        }
        if (is_bus && action.until_ns > scenario_.duration_ns)
        {
            Refuse(action.place, "an end after that of the scenario", "a time within its duration behind 'until'");
        }
        if (!is_storm && !is_of_manager)
        {
            RequireDevice(action.node, action.place);
        }
    }
    void Of(const NetworkExpectation& expectation) const
    {
        const bool is_event = expectation.kind == Expected::kEvent || expectation.kind == Expected::kNoEvent;
        if (expectation.kind == Expected::kDevice || expectation.kind == Expected::kOutput)
        {
            RequireDevice(expectation.node, expectation.place);
        }
        if (is_event && expectation.from_ns > expectation.at_ns)
        {
            Refuse(expectation.place, "a window that ends before it begins", "'from' before 'until'");
        }
    }

    /// Whether the device is there, through the events in their order.
    void LifeOf(const ScenarioDevice& device) const
    {
        const std::string name = "device " + std::to_string(device.node);
        bool is_there = true;
        for (const NetworkAction* const action : ActionsOf(device.node))
        {
            const std::string word = NameOf(simulator::kNetworkActionWords, action->kind);
            const bool needs_absence = action->kind == Action::kInsert;
            if (action->at_ns < device.at_ns)
            {
                Refuse(action->place, word + " of " + name + " before it comes", "a time from its 'at' on");
            }
            if (action->kind != Action::kReplace && is_there == needs_absence)
            {
                Refuse(action->place, word + " of " + name + (is_there ? ", which is there" : ", which is not there"),
                       is_there ? "a pull before it" : "an insert before it");
            }
            is_there = action->kind != Action::kPull;
        }
    }

  private:
    /// In the order in which they happen.
    [[nodiscard]] std::vector<const NetworkAction*> ActionsOf(const std::uint8_t node) const
    {
        std::vector<const NetworkAction*> actions;
        for (const NetworkAction& action : scenario_.actions)
        {
            if (action.node == node && !IsStorm(action.kind) && !IsOfManager(action.kind))
            {
                actions.push_back(&action);
            }
        }
        std::stable_sort(actions.begin(), actions.end(), [](const NetworkAction* left, const NetworkAction* right)
                         { return left->at_ns < right->at_ns; });
        return actions;
    }
    [[noreturn]] void Refuse(const Place& place, const std::string& wrong, const std::string& expected) const
    {
        throw YamlError(scenario_.file, place, wrong, expected);
    }
    void Begins(const std::uint64_t at_ns, const Place& place) const
    {
        if (at_ns >= scenario_.duration_ns)
        {
            Refuse(place, "a time at the end of the scenario or later", "one within its duration");
        }
    }
    void RequireDevice(const std::uint8_t node, const Place& place) const
    {
        const auto is_it = [node](const ScenarioDevice& device) { return device.node == node; };
        if (std::none_of(scenario_.devices.begin(), scenario_.devices.end(), is_it))
        {
            Refuse(place, "no device with node-ID " + std::to_string(node), "one of the scenario's devices");
        }
    }

    const NetworkScenario& scenario_;
};
} // namespace

void RequireSense(const NetworkScenario& scenario)
{
    const Check check(scenario);
    check.Comers();
    for (const NetworkAction& action : scenario.actions)
    {
        check.Of(action);
    }
    for (const NetworkExpectation& expectation : scenario.expectations)
    {
        check.Of(expectation);
    }
    for (const ScenarioDevice& device : scenario.devices)
    {
        check.LifeOf(device);
        RequireObjects(scenario, device);
    }
}
} // namespace counterpoint::simulator
