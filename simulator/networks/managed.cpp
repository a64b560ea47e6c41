// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// A network with managers as a run sees it. [SRS_MGR_012]
#include "simulator/networks/managed.hpp"

#include "runtime/manager/report/status.hpp"
#include "runtime/manager/report/words.hpp"
#include "simulator/networks/simulation.hpp"
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
    for (const runtime::ManagerEvent& event : manager.events)
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
    for (const runtime::ManagerEvent& event : manager.events)
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
    if (manager.station == nullptr)
    {
        return "no manager yet";
    }
    const cia302::Manager& core = manager.station->Host().Core();
    const cia302::NodeId node{expectation.node_id};
    const cia302::NodeStatus status = core.Status(node);
    const cia302::GateFinding gate = core.Gate().Finding(node);
    const bool is_refused =
        core.Gate().State(node) == cia302::GateState::kDiffers || core.Gate().State(node) == cia302::GateState::kFailed;
    const ObjectAddress object = is_refused ? gate.object : status.object;
    const bool has_finding = is_refused || !runtime::FindingText(manager.net->Plan().manager.profile, status).empty();
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
        return (manager.port != nullptr && core.IsActive()) ? "true" : "false";
    default:
        return FlyingEvents(manager);
    }
}

std::string FoundAtDevice(const Expectation& expectation, SimulatedDevice* const device)
{
    if (device == nullptr)
    {
        return "absent";
    }
    if (expectation.kind == Expected::kDevice)
    {
        return runtime::WordOf(device->Device().Services().State());
    }
    const std::optional<SlotIndex> slot = device->Device().Model().SlotOf(expectation.srdo);
    const bool is_open = slot && ((device->Device().Open() >> *slot) & 1U) != 0U;
    return is_open ? "open" : "closed";
}

class Managed final : public ManagedWorld
{
  public:
    Managed(const Scenario& scenario, Journal& journal) : scenario_(scenario), simulation_(scenario, journal)
    {
    }

    void RunUntil(const Nanoseconds until) override
    {
        simulation_.RunUntil(until);
    }
    [[nodiscard]] std::string Found(const Expectation& expectation) override
    {
        return IsOfManager(expectation.kind)
                   ? FoundAtManager(expectation,
                                    ManagerOf(simulation_.Managers(), expectation.manager, expectation.source))
                   : FoundAtDevice(expectation, simulation_.DeviceOf(expectation.node));
    }
    [[nodiscard]] std::vector<std::string> Warnings() const override
    {
        std::vector<std::string> lines;
        for (const auto& manager : simulation_.Managers())
        {
            const std::vector<std::string>& more = manager->net->Warnings();
            lines.insert(lines.end(), more.begin(), more.end());
        }
        return lines;
    }
    [[nodiscard]] std::vector<std::uint8_t> Managers() const override
    {
        std::vector<std::uint8_t> nodes;
        for (const auto& manager : simulation_.Managers())
        {
            nodes.push_back(manager->node);
        }
        return nodes;
    }
    [[nodiscard]] std::string Pictures() const override
    {
        std::string text = runtime::DiagramStyle();
        for (const auto& manager : simulation_.Managers())
        {
            if (manager->station != nullptr)
            {
                text += runtime::DiagramSection(
                    manager->station->Host(), manager->station->Diagram(),
                    runtime::InstantAt(static_cast<std::uint64_t>(scenario_.duration / kNanosecondsPerMicrosecond)));
            }
        }
        return text;
    }

  private:
    const Scenario& scenario_;
    NetworkSimulation simulation_;
};
} // namespace

std::unique_ptr<ManagedWorld> MakeManagedWorld(const Scenario& scenario, Journal& journal)
{
    return std::make_unique<Managed>(scenario, journal);
}
} // namespace counterpoint::simulator
