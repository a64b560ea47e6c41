// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What a network scenario asks of its managers, against their network files: it would do nothing, or hold whatever
// happens.
#include "canopen/cia306/text/number.hpp"
#include "runtime/manager/order.hpp"
#include "runtime/manager/report/words.hpp"
#include "simulator/networks/simulation.hpp"

#include <algorithm>
#include <map>

namespace counterpoint::simulator
{
namespace
{
using Action = NetworkActionKind;
using Expected = NetworkExpectationKind;

/// Events that are of no node.
bool IsOfNetwork(const std::string& event)
{
    return event == "master" || event == "flying_master" || event == "order" || event == "bus";
}

/// -1 to 127, written as it will be found.
bool IsCodeOf(const network::StartProfile profile, const std::string& text)
{
    constexpr std::uint64_t kHighest = 127U;
    const bool is_negative = !text.empty() && text[0] == '-';
    const auto number = cia306::ParseUnsigned(text.substr(is_negative ? 1U : 0U), kHighest);
    const int code = static_cast<int>(number.value_or(0U)) * (is_negative ? -1 : 1);
    return number && std::to_string(code) == text && !runtime::CodeText(profile, code).empty();
}
} // namespace

/// What the manager cannot know would hold, or not, whatever happens.
void NetworkSimulation::RequireKnown(const NetworkExpectation& expectation)
{
    const bool is_device = expectation.kind == Expected::kDevice || expectation.kind == Expected::kOutput;
    if (is_device)
    {
        return; // Asked of the device, not of a manager.
    }
    const SimulatedManager& manager = ManagerOf(expectation.manager, expectation.place);
    const auto is_it = [&expectation](const ScenarioDevice& device) { return device.node == expectation.node; };
    const auto is_other = [&expectation](const std::unique_ptr<SimulatedManager>& other)
    { return other->node == expectation.node; };
    const bool is_on_bus =
        std::any_of(managers_.begin(), managers_.end(), is_other) || std::any_of(setups_.begin(), setups_.end(), is_it);
    if (expectation.node != 0U && manager.net->Find(expectation.node) == nullptr && !is_on_bus)
    {
        throw YamlError(scenario_.file, expectation.place,
                        "node " + std::to_string(expectation.node) + ", which is no slave of manager " +
                            std::to_string(manager.node) + " and not there",
                        "one of its network file, or of the scenario's devices");
    }
    if (expectation.at_ns <= manager.setup.at_ns)
    {
        throw YamlError(scenario_.file, expectation.place,
                        "a time before manager " + std::to_string(manager.node) + " comes", "a later one");
    }
    RequireOfProfile(expectation, manager);
    RequireOfSafety(expectation, manager);
    RequireOfGuarding(expectation, manager);
}

void NetworkSimulation::RequireOfProfile(const NetworkExpectation& expectation, const SimulatedManager& manager) const
{
    const network::StartProfile profile = manager.net->Plan().manager.profile;
    const bool is_cia302 = profile == network::StartProfile::kCia302;
    const bool is_event = expectation.kind == Expected::kEvent || expectation.kind == Expected::kNoEvent;
    const std::string whose =
        "manager " + std::to_string(manager.node) + " with the profile " + runtime::WordOf(profile);
    std::string wrong;
    std::string expected;
    if ((expectation.kind == Expected::kLetter && !is_cia302) || (expectation.kind == Expected::kCode && is_cia302))
    {
        wrong = std::string(is_cia302 ? "a code" : "a letter") + " of " + whose;
        expected = is_cia302 ? "'letter'" : "'code'";
    }
    else if (expectation.kind == Expected::kCode && !IsCodeOf(profile, expectation.is))
    {
        wrong = "code " + runtime::Shown(expectation.is) + " of " + whose;
        expected = "a decimal code that this profile knows";
    }
    else if (is_event && expectation.is == "pdo" && profile != network::StartProfile::kEl6751)
    {
        wrong = "event 'pdo' of " + whose;
        expected = "the profile el6751";
    }
    else if (is_event && expectation.node != 0U && IsOfNetwork(expectation.is))
    {
        wrong = "event " + runtime::Shown(expectation.is) + " of a node";
        expected = "it without 'node'";
    }
    else if (expectation.kind == Expected::kFlying && !manager.net->Plan().manager.flying)
    {
        wrong = "events of the election at manager " + std::to_string(manager.node) + ", which is no flying master";
        expected = "a manager with 'flying'";
    }
    else if (expectation.kind == Expected::kActive && !manager.net->Plan().manager.flying)
    {
        wrong = "the active master at manager " + std::to_string(manager.node) +
                ", which is no flying master and commands the network while it is there";
        expected = "a manager with 'flying'";
    }
    else
    {
        return;
    }
    throw YamlError(scenario_.file, expectation.place, wrong, expected);
}

void NetworkSimulation::RequireOfSafety(const NetworkExpectation& expectation, const SimulatedManager& manager) const
{
    const bool is_event = expectation.kind == Expected::kEvent || expectation.kind == Expected::kNoEvent;
    const bool is_of_safety = expectation.kind == Expected::kGate ||
                              (is_event && (expectation.is == "gate" || expectation.is == "write_safety"));
    const cia302::NetworkSetup& setup = manager.net->Setup();
    const bool has_safety =
        (expectation.node == 0U) ? setup.HasSafetySlave() : setup.IsSafetySlave(cia302::NodeId{expectation.node});
    if (is_of_safety && !has_safety)
    {
        const std::string node =
            (expectation.node == 0U) ? "of a network" : "of node " + std::to_string(expectation.node);
        throw YamlError(scenario_.file, expectation.place, "the gate " + node + ", which has no safety configuration",
                        "a safety slave");
    }
}

/// Whether somebody writes into the manager while it runs: other guard and consumer times than those of its file.
bool NetworkSimulation::MayChange(const SimulatedManager& manager) const
{
    constexpr std::uint32_t kSdoRequests = 0x600U;
    const auto is_change = [&manager](const NetworkAction& action)
    {
        const bool is_order = action.kind == Action::kOrder &&
                              runtime::ParseManagerOrder(action.order).kind == runtime::ManagerOrderKind::kSet;
        return is_order || (action.kind == Action::kSend && action.identifier == kSdoRequests + manager.node);
    };
    return std::any_of(actions_.begin(), actions_.end(), is_change);
}

/// Events of guarding are those of a slave that is guarded: who has a consumer time is watched by heartbeat.
void NetworkSimulation::RequireOfGuarding(const NetworkExpectation& expectation, const SimulatedManager& manager) const
{
    const bool is_event = expectation.kind == Expected::kEvent || expectation.kind == Expected::kNoEvent;
    const bool is_of_guarding = is_event && (expectation.is == "guard_lost" || expectation.is == "guard_missed" ||
                                             expectation.is == "toggle_error");
    bool is_guarded = false;
    for (const auto& slave : manager.net->Slaves())
    {
        const cia302::SlaveSetup& setup = manager.net->Setup().Slave(cia302::NodeId{slave->plan.node});
        const bool is_listed =
            setup.heartbeat.consumer_ms == 0U && setup.GuardTimeMs() > 0U && setup.RetryFactor() > 0U;
        const bool by_rows = setup.el6751 != nullptr && setup.el6751->IsWatched(); // Guarded without 1017h.
        const bool is_meant = expectation.node == 0U || slave->plan.node == expectation.node;
        is_guarded = is_guarded || (is_meant && (is_listed || by_rows));
    }
    if (is_of_guarding && !is_guarded && !MayChange(manager))
    {
        const std::string name = "manager " + std::to_string(manager.node);
        const std::string whom = (expectation.node == 0U) ? "any node, and " + name + " guards none"
                                                          : "node " + std::to_string(expectation.node) + ", which " +
                                                                name + " does not guard";
        throw YamlError(scenario_.file, expectation.place, expectation.is + " of " + whom,
                        "a slave with guard_time and without consumer time, or heartbeat_lost");
    }
}

/// Whether each manager is there and on the bus, through the events in their order.
void NetworkSimulation::RequireManagers()
{
    std::map<std::uint8_t, bool> is_killed;
    std::map<std::uint8_t, std::uint64_t> off_until_ns;
    for (const NetworkAction& action : actions_)
    {
        if (!IsOfManager(action.kind) || action.kind == Action::kBusBack)
        {
            continue;
        }
        const SimulatedManager& manager = ManagerOf(action.node, action.place);
        const std::string name = "manager " + std::to_string(manager.node);
        const bool is_bus = action.kind == Action::kBusOff || action.kind == Action::kNoController;
        if (action.at_ns < manager.setup.at_ns || is_killed[manager.node])
        {
            throw YamlError(scenario_.file, action.place,
                            "an event of " + name +
                                (is_killed[manager.node] ? " after it was killed" : " before it comes"),
                            "a time at which it is there");
        }
        if (is_bus && action.at_ns < off_until_ns[manager.node])
        {
            throw YamlError(scenario_.file, action.place, name + " is off the bus already",
                            "a time after the 'until' before it");
        }
        is_killed[manager.node] = action.kind == Action::kKillManager;
        off_until_ns[manager.node] = is_bus ? action.until_ns : off_until_ns[manager.node];
    }
}
} // namespace counterpoint::simulator
