// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// A network with managers as a run sees it. [SRS_MGR_012]
#include "simulator/managers/managed.hpp"

#include "runtime/manager/report/texts.hpp"
#include "simulator/managers/manager.hpp"
#include "simulator/scenario/names.hpp"

namespace counterpoint::simulator
{
namespace
{
using Expected = ExpectationKind;

/// Numbers of the events of the flying master, in order: "3 4".
std::string FlyingEvents(const SimulatedManager& manager)
{
    std::string numbers;
    for (const runtime::ManagerEvent& event : manager.Events())
    {
        if (event.kind == "flying_master")
        {
            numbers += (numbers.empty() ? "" : " ") + event.word;
        }
    }
    return numbers.empty() ? "none" : numbers;
}

/// The word of the expectation if such an event was there, else none.
std::string EventIn(const SimulatedManager& manager, const Expectation& expectation)
{
    for (const runtime::ManagerEvent& event : manager.Events())
    {
        const Nanoseconds at = static_cast<Nanoseconds>(event.at_us) * kNanosecondsPerMicrosecond;
        const bool is_node = expectation.node_id == 0U || event.node == expectation.node_id;
        if (is_node && event.kind == expectation.is && at >= expectation.from && at <= expectation.at)
        {
            return event.kind;
        }
    }
    return "none";
}

std::string FoundAtManager(const Expectation& expectation, const SimulatedManager& manager)
{
    if (manager.Station() == nullptr)
    {
        return "no manager yet";
    }
    const cia302::Manager& core = manager.Station()->Assembly().Core();
    const cia302::NodeId node{expectation.node_id};
    const cia302::NodeStatus status = core.Status(node);
    const cia302::GateFinding gate = core.Gate().Finding(node);
    const bool is_refused =
        core.Gate().State(node) == cia302::GateState::kDiffers || core.Gate().State(node) == cia302::GateState::kFailed;
    const ObjectAddress object = is_refused ? gate.object : status.object;
    const bool has_finding = is_refused || !runtime::FindingText(manager.Net().Plan().manager.profile, status).empty();
    switch (expectation.kind)
    {
    case Expected::kState:
        return runtime::WordOf(core.Table().Record(node).state);
    case Expected::kLetter:
        return (status.letter == 0) ? "none" : std::string(1U, status.letter);
    case Expected::kCode:
        return std::to_string(status.code);
    case Expected::kGate:
        return runtime::WordOf(core.Gate().State(node));
    case Expected::kFinding:
        return has_finding ? ObjectText(object) : "none";
    case Expected::kEvent:
    case Expected::kNoEvent:
        return EventIn(manager, expectation);
    case Expected::kActive:
        return (manager.HasSupply() && core.IsActive()) ? "true" : "false";
    default:
        return FlyingEvents(manager);
    }
}

class Managed final : public ManagedWorld
{
  public:
    Managed(const Scenario& scenario, Journal& journal, Network& network)
    {
        for (const ManagerSetup& setup : scenario.managers)
        {
            const std::size_t place = scenario.nodes.size() + managers_.size();
            auto manager = std::make_unique<SimulatedManager>(setup, scenario.profile, place, network.Bus(), journal);
            for (const auto& other : managers_)
            {
                if (other->Node() == manager->Node())
                {
                    throw YamlError(setup.source.file, setup.source.place,
                                    "manager " + std::to_string(manager->Node()) + " a second time",
                                    "each manager with a node-ID of its own");
                }
            }
            for (const NodeSetup& node : scenario.nodes)
            {
                if (node.node_id == manager->Node())
                {
                    throw YamlError(node.source.file, node.source.place,
                                    "node-ID " + std::to_string(manager->Node()) + ", which a manager has",
                                    "a node-ID of its own for each node");
                }
            }
            network.Join(*manager, manager->BusNode(), place);
            managers_.push_back(std::move(manager));
        }
        RequireOfManagers(scenario, managers_);
        for (const Action& action : scenario.actions)
        {
            if (IsOfManager(action.kind))
            {
                ManagerOf(managers_, action.node_id, action.source).Plan(action);
            }
        }
    }

    [[nodiscard]] std::string Found(const Expectation& expectation) override
    {
        return FoundAtManager(expectation, ManagerOf(managers_, expectation.manager, expectation.source));
    }
    [[nodiscard]] std::vector<std::string> Warnings() const override
    {
        std::vector<std::string> lines;
        for (const auto& manager : managers_)
        {
            const std::vector<std::string>& more = manager->Net().Warnings();
            lines.insert(lines.end(), more.begin(), more.end());
        }
        return lines;
    }
    [[nodiscard]] std::vector<std::uint8_t> Managers() const override
    {
        std::vector<std::uint8_t> nodes;
        for (const auto& manager : managers_)
        {
            nodes.push_back(manager->Node());
        }
        return nodes;
    }
    [[nodiscard]] std::string Pictures() const override
    {
        std::string text = runtime::DiagramStyle();
        for (const auto& manager : managers_)
        {
            if (manager->Station() != nullptr)
            {
                text += runtime::DiagramSection(*manager->Station());
            }
        }
        return text;
    }

  private:
    SimulatedManagers managers_;
};
} // namespace

SimulatedManager& ManagerOf(const SimulatedManagers& managers, const std::uint8_t node_id, const Source& source)
{
    for (const auto& manager : managers)
    {
        if (node_id == 0U || manager->Node() == node_id)
        {
            return *manager;
        }
    }
    throw YamlError(source.file, source.place, "no manager with node-ID " + std::to_string(node_id),
                    "one of the scenario's managers");
}

std::unique_ptr<ManagedWorld> MakeManagedWorld(const Scenario& scenario, Journal& journal, Network& network)
{
    return std::make_unique<Managed>(scenario, journal, network);
}
} // namespace counterpoint::simulator
