// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What a network scenario asks of its managers, against their network files: it would do nothing, or hold whatever
// happens.
#include "canopen/cia306/text/number.hpp"
#include "runtime/device/time_text.hpp"
#include "runtime/manager/order.hpp"
#include "runtime/manager/report/texts.hpp"
#include "simulator/managers/manager.hpp"

#include <algorithm>
#include <map>

namespace counterpoint::simulator
{
namespace
{
using Expected = ExpectationKind;

/// Events that are of no node.
bool IsOfNetwork(const std::string& event)
{
    return event == "master" || event == "flying_master" || event == "order" || event == "bus";
}

/// -1 to 127, written as it will be found.
bool IsCodeOf(const network_plan::StartProfile profile, const std::string& text)
{
    constexpr std::uint64_t kHighest = 127U;
    const bool is_negative = !text.empty() && text[0] == '-';
    const auto number = cia306::ParseUnsigned(text.substr(is_negative ? 1U : 0U), kHighest);
    const int code = static_cast<int>(number.value_or(0U)) * (is_negative ? -1 : 1);
    return number && std::to_string(code) == text && !runtime::CodeText(profile, code).empty();
}

[[noreturn]] void Refuse(const Source& source, const std::string& wrong, const std::string& expected)
{
    throw YamlError(source.file, source.place, wrong, expected);
}

class Check
{
  public:
    Check(const Scenario& scenario, const SimulatedManagers& managers) : scenario_(scenario), managers_(managers)
    {
    }

    /// What the manager cannot know would hold, or not, whatever happens.
    void Known(const Expectation& expectation) const
    {
        const SimulatedManager& manager = ManagerOf(managers_, expectation.manager, expectation.source);
        const auto is_it = [&expectation](const NodeSetup& node) { return node.node_id == expectation.node_id; };
        const auto is_other = [&expectation](const std::unique_ptr<SimulatedManager>& other)
        { return other->Node() == expectation.node_id; };
        const bool is_on_bus = std::any_of(managers_.begin(), managers_.end(), is_other) ||
                               std::any_of(scenario_.nodes.begin(), scenario_.nodes.end(), is_it);
        if (expectation.node_id != 0U && manager.Net().Find(expectation.node_id) == nullptr && !is_on_bus)
        {
            Refuse(expectation.source,
                   "node " + std::to_string(expectation.node_id) + ", which is no slave of manager " +
                       std::to_string(manager.Node()) + " and not there",
                   "one of its network file, or of the scenario's devices");
        }
        if (expectation.at <= manager.Setup().at)
        {
            Refuse(expectation.source, "a time before manager " + std::to_string(manager.Node()) + " comes",
                   "a later one");
        }
        BeforeItsEnd(expectation, manager);
        OfProfile(expectation, manager);
        OfSafety(expectation, manager);
        OfGuarding(expectation, manager);
    }

    /// A manager that was killed tells nothing any more, and what it knew last stays. What the election told it until
    /// then can be asked for later, too. [SRS_MGR_585]
    void BeforeItsEnd(const Expectation& expectation, const SimulatedManager& manager) const
    {
        Nanoseconds killed = kNever;
        for (const Action& action : scenario_.actions)
        {
            const bool is_kill = action.kind == ActionKind::kKillManager;
            killed = (is_kill && action.node_id == manager.Node()) ? std::min(killed, action.at) : killed;
        }
        const std::string name = "manager " + std::to_string(manager.Node());
        if (IsOfEvents(expectation.kind) && expectation.from >= killed)
        {
            Refuse(expectation.source, "a window that begins when " + name + " was killed already",
                   "'from' below " + runtime::ExactText(killed));
        }
        if (!IsOfEvents(expectation.kind) && expectation.kind != Expected::kFlying && expectation.at > killed)
        {
            Refuse(expectation.source,
                   "a time after " + name + " was killed (without 'at' it is the end of the scenario)",
                   "one up to " + runtime::ExactText(killed));
        }
    }

    void OfProfile(const Expectation& expectation, const SimulatedManager& manager) const
    {
        const network_plan::StartProfile profile = manager.Net().Plan().manager.profile;
        const bool is_cia302 = profile == network_plan::StartProfile::kCia302;
        const bool is_event = IsOfEvents(expectation.kind);
        const std::string whose =
            "manager " + std::to_string(manager.Node()) + " with the profile " + runtime::WordOf(profile);
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
        else if (is_event && expectation.is == "pdo" && profile != network_plan::StartProfile::kEl6751)
        {
            wrong = "event 'pdo' of " + whose;
            expected = "the profile el6751";
        }
        else if (is_event && expectation.node_id != 0U && IsOfNetwork(expectation.is))
        {
            wrong = "event " + runtime::Shown(expectation.is) + " of a node";
            expected = "it without 'node'";
        }
        else if (expectation.kind == Expected::kFlying && !manager.Net().Plan().manager.flying)
        {
            wrong =
                "events of the election at manager " + std::to_string(manager.Node()) + ", which is no flying master";
            expected = "a manager with 'flying'";
        }
        else if (expectation.kind == Expected::kActive && !manager.Net().Plan().manager.flying)
        {
            wrong = "the active master at manager " + std::to_string(manager.Node()) +
                    ", which is no flying master and commands the network while it is there";
            expected = "a manager with 'flying'";
        }
        else
        {
            return;
        }
        Refuse(expectation.source, wrong, expected);
    }

    void OfSafety(const Expectation& expectation, const SimulatedManager& manager) const
    {
        const bool is_event = IsOfEvents(expectation.kind);
        const bool is_of_safety = expectation.kind == Expected::kGate ||
                                  (is_event && (expectation.is == "gate" || expectation.is == "write_safety"));
        const cia302::NetworkSetup& setup = manager.Net().Setup();
        const bool has_safety = (expectation.node_id == 0U) ? setup.HasSafetySlave()
                                                            : setup.IsSafetySlave(cia302::NodeId{expectation.node_id});
        if (is_of_safety && !has_safety)
        {
            const std::string node =
                (expectation.node_id == 0U) ? "of a network" : "of node " + std::to_string(expectation.node_id);
            Refuse(expectation.source, "the gate " + node + ", which has no safety configuration", "a safety slave");
        }
    }

    /// Whether somebody writes into the manager while it runs: other guard and consumer times than those of its file.
    [[nodiscard]] bool MayChange(const SimulatedManager& manager) const
    {
        constexpr std::uint32_t kSdoRequests = 0x600U;
        const auto is_change = [&manager](const Action& action)
        {
            const bool is_order = action.kind == ActionKind::kOrder &&
                                  runtime::ParseManagerOrder(action.order).kind == runtime::ManagerOrderKind::kSet;
            return is_order || (action.kind == ActionKind::kSend && action.identifier == kSdoRequests + manager.Node());
        };
        return std::any_of(scenario_.actions.begin(), scenario_.actions.end(), is_change);
    }

    /// Events of guarding are those of a slave that is guarded: who has a consumer time is watched by heartbeat.
    void OfGuarding(const Expectation& expectation, const SimulatedManager& manager) const
    {
        const bool is_event = IsOfEvents(expectation.kind);
        const bool is_of_guarding = is_event && (expectation.is == "guard_lost" || expectation.is == "guard_missed" ||
                                                 expectation.is == "toggle_error");
        bool is_guarded = false;
        for (const auto& slave : manager.Net().Slaves())
        {
            const cia302::SlaveSetup& setup = manager.Net().Setup().Slave(cia302::NodeId{slave->plan.node});
            const bool is_listed =
                setup.heartbeat.consumer_ms == 0U && setup.GuardTimeMs() > 0U && setup.RetryFactor() > 0U;
            const bool by_rows = setup.el6751 != nullptr && setup.el6751->IsWatched(); // Guarded without 1017h.
            const bool is_meant = expectation.node_id == 0U || slave->plan.node == expectation.node_id;
            is_guarded = is_guarded || (is_meant && (is_listed || by_rows));
        }
        if (is_of_guarding && !is_guarded && !MayChange(manager))
        {
            const std::string name = "manager " + std::to_string(manager.Node());
            const std::string whom = (expectation.node_id == 0U) ? "any node, and " + name + " guards none"
                                                                 : "node " + std::to_string(expectation.node_id) +
                                                                       ", which " + name + " does not guard";
            Refuse(expectation.source, expectation.is + " of " + whom,
                   "a slave with guard_time and without consumer time, or heartbeat_lost");
        }
    }

    /// Whether each manager is there and on the bus, through the events in their order.
    void Presence() const
    {
        std::map<std::uint8_t, bool> is_killed;
        std::map<std::uint8_t, Nanoseconds> off_until;
        std::vector<Action> actions = scenario_.actions;
        std::stable_sort(actions.begin(), actions.end(),
                         [](const Action& left, const Action& right) { return left.at < right.at; });
        for (const Action& action : actions)
        {
            if (!IsOfManager(action.kind) || action.kind == ActionKind::kBusBack)
            {
                continue;
            }
            const SimulatedManager& manager = ManagerOf(managers_, action.node_id, action.source);
            const std::string name = "manager " + std::to_string(manager.Node());
            const bool is_bus = action.kind == ActionKind::kBusOff || action.kind == ActionKind::kNoController;
            if (action.at < manager.Setup().at || is_killed[manager.Node()])
            {
                Refuse(action.source,
                       "an event of " + name +
                           (is_killed[manager.Node()] ? " after it was killed" : " before it comes"),
                       "a time at which it is there");
            }
            if (is_bus && action.at < off_until[manager.Node()])
            {
                Refuse(action.source, name + " is off the bus already", "a time after the 'until' before it");
            }
            is_killed[manager.Node()] = action.kind == ActionKind::kKillManager;
            off_until[manager.Node()] = is_bus ? action.until : off_until[manager.Node()];
        }
    }

    /// Orders that act: what only asks has nobody here to read the answer.
    void Orders() const
    {
        using Kind = runtime::ManagerOrderKind;
        for (const Action& action : scenario_.actions)
        {
            const runtime::ManagerOrder parsed = runtime::ParseManagerOrder(action.order);
            if (action.kind == ActionKind::kOrder && parsed.kind == Kind::kProblem)
            {
                const std::string expected = ", expected ";
                const std::size_t comma = parsed.problem.find(expected);
                Refuse(action.order_source, parsed.problem.substr(0U, comma),
                       parsed.problem.substr(comma + expected.size()));
            }
            const bool is_idle = parsed.kind == Kind::kNothing || parsed.kind == Kind::kStatus ||
                                 parsed.kind == Kind::kGet || parsed.kind == Kind::kHelp || parsed.kind == Kind::kQuit;
            if (action.kind == ActionKind::kOrder && is_idle)
            {
                Refuse(action.order_source, "order " + runtime::Shown(action.order) + ", which does nothing here",
                       "an order such as start 33");
            }
            if (action.kind == ActionKind::kOrder)
            {
                RequirePossible(action, parsed, ManagerOf(managers_, action.node_id, action.source));
            }
        }
    }

  private:
    const Scenario& scenario_;
    const SimulatedManagers& managers_;
};
} // namespace

void RequireOfManagers(const Scenario& scenario, const SimulatedManagers& managers)
{
    const Check check(scenario, managers);
    check.Orders();
    for (const Expectation& expectation : scenario.expectations)
    {
        if (IsOfManager(expectation.kind))
        {
            check.Known(expectation);
        }
    }
    check.Presence();
}
} // namespace counterpoint::simulator
