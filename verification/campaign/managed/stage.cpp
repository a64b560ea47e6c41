// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/managed/stage.hpp"

#include "simulator/scenario/checks.hpp"
#include "simulator/scenario/reader.hpp"
#include "verification/campaign/trap.hpp"

#include <algorithm>

namespace counterpoint::campaign::managed
{
namespace
{
constexpr ObjectAddress kValid{0x13FEU, 0U};
constexpr std::uint32_t kValidValue = 0xA5U;

/// The object as a master sees it: nothing above its length.
[[nodiscard]] std::uint32_t Cut(const std::uint64_t value, const std::uint8_t size)
{
    constexpr std::uint8_t kWord = 4U;
    const std::uint64_t mask = (size >= kWord) ? 0xFFFFFFFFU : ((std::uint64_t{1U} << (size * 8U)) - 1U);
    return static_cast<std::uint32_t>(value & mask);
}

[[nodiscard]] simulator::Scenario Whole(simulator::Scenario scenario)
{
    simulator::RequireHappening(scenario);
    simulator::RequirePossible(scenario);
    return scenario;
}
} // namespace

Stranger::Stranger(host::VirtualBus& bus) : bus_(bus), node_(bus.Attach(*this, host::NodeSetup{CanPortId::kFirst, 4U}))
{
}

void Stranger::Send(const CanFrame& frame)
{
    static_cast<void>(bus_.Submit(node_, frame));
}

void Stranger::Run(const Nanoseconds /*now*/)
{
}

void Stranger::OnReceived(const CanFrame& /*frame*/, const host::BusTime /*at*/)
{
}

void Stranger::OnConfirmed(const CanFrame& /*frame*/, const host::BusTime /*at*/)
{
}

void GuardedManager::Run(const Nanoseconds now)
{
    Look(now, [this, now]() { manager_.Run(now); });
}

void GuardedManager::Look(const Nanoseconds now, const std::function<void()>& look)
{
    if (!is_guarded_)
    {
        look();
        return;
    }
    bool has_thrown = false;
    const Return how = Trap::Run(
        [&look, &has_thrown]()
        {
            try
            {
                look();
            }
            catch (const std::exception&)
            {
                has_thrown = true;
            }
        });
    if (how != Return::kEnded || has_thrown)
    {
        manager_.SwitchOff();
        ended_at_ = (ended_at_ < 0) ? now : ended_at_;
    }
}

Stage::Stage(const Plan& plan) : scenario_(Whole(simulator::ReadScenario(plan.scenario, plan.profile)))
{
    const auto refuse = [&plan](const char* const wrong, const char* const expected)
    { throw runtime::YamlError(plan.file, plan.scenario_source.place, wrong, expected); };
    if (scenario_.managers.empty())
    {
        refuse("a scenario without managers", "one with managers; without them a plan names scenario and device");
    }
    if (!scenario_.faults.empty())
    {
        refuse("a scenario with faults", "one without faults of its own");
    }
    network_ = std::make_unique<simulator::Network>(scenario_, journal_);
    BuildManagers();
    stranger_ = std::make_unique<Stranger>(network_->Bus());
    network_->Join(*stranger_, stranger_->BusNode(), scenario_.nodes.size() + managers_.size());
    network_->Bus().Install(fault_);
    BuildSlaves();
}

void Stage::BuildManagers()
{
    for (const simulator::ManagerSetup& setup : scenario_.managers)
    {
        const std::size_t place = scenario_.nodes.size() + managers_.size();
        managers_.push_back(
            std::make_unique<simulator::SimulatedManager>(setup, scenario_.profile, place, network_->Bus(), journal_));
        guards_.push_back(std::make_unique<GuardedManager>(*managers_.back()));
        network_->Join(*guards_.back(), managers_.back()->BusNode(), place);
    }
    simulator::RequireOfManagers(scenario_, managers_);
    for (const simulator::Action& action : scenario_.actions)
    {
        if (simulator::IsOfManager(action.kind))
        {
            simulator::ManagerOf(managers_, action.node_id, action.source).Plan(action);
        }
    }
}

void Stage::BuildSlaves()
{
    for (simulator::NodeIndex index = 0U; index < network_->Size(); ++index)
    {
        simulator::Node& node = network_->At(index);
        Slave slave{index, node.Model().Config().node_id, node.Controllers().BusNodes().front(), {}, 0U};
        for (const auto& manager : managers_)
        {
            const cia302::NodeId id{slave.node_id};
            if (!manager->Net().Setup().IsSafetySlave(id) || !slave.expected.empty())
            {
                continue;
            }
            const cia302::SlaveSetup& setup = manager->Net().Setup().Slave(id);
            for (std::uint16_t object = 0U; object < setup.safety->count; ++object)
            {
                const cia302::ExpectedObject& each = setup.safety->objects[object];
                // Of 8 bytes (5F02h) are none: a file with a digest has 5F04h instead.
                slave.expected.push_back(
                    {each.address, static_cast<std::uint32_t>(each.value), cia302::SizeOf(each.address)});
            }
            slave.expected.push_back({kValid, kValidValue, 1U});
            slave.serial = setup.serial_number;
        }
        slaves_.push_back(slave);
    }
}

simulator::SimulatedManager* Stage::ManagerAt(const host::NodeIndex bus_node) noexcept
{
    const auto found = std::find_if(managers_.begin(), managers_.end(),
                                    [bus_node](const auto& manager) { return manager->BusNode() == bus_node; });
    return (found == managers_.end()) ? nullptr : found->get();
}

const Slave* Stage::SlaveAt(const host::NodeIndex bus_node) const noexcept
{
    const auto found = std::find_if(slaves_.begin(), slaves_.end(),
                                    [bus_node](const Slave& slave) { return slave.bus_node == bus_node; });
    return (found == slaves_.end()) ? nullptr : &*found;
}

std::string Stage::NameOf(const host::NodeIndex bus_node) noexcept
{
    const simulator::SimulatedManager* const manager = ManagerAt(bus_node);
    const Slave* const slave = SlaveAt(bus_node);
    return (manager != nullptr) ? "manager " + std::to_string(manager->Node())
           : (slave != nullptr) ? "node " + std::to_string(slave->node_id)
                                : "somebody else";
}

std::optional<std::uint32_t> Stage::ValueIn(const Slave& slave, const ObjectAddress& object)
{
    simulator::Node& node = network_->At(slave.index);
    if (!node.HasSupply())
    {
        return std::nullopt;
    }
    const cia301::NumberReading reading = node.Firmware().Assembly().Dictionary().ReadNumber(object);
    const auto expected =
        std::find_if(slave.expected.begin(), slave.expected.end(), [&object](const ExpectedValue& each)
                     { return each.object.index == object.index && each.object.sub == object.sub; });
    const std::uint8_t size = (expected == slave.expected.end()) ? 4U : expected->size;
    return (reading.abort == cia301::SdoAbort::kNone) ? std::optional<std::uint32_t>(Cut(reading.value, size))
                                                      : std::nullopt;
}
} // namespace counterpoint::campaign::managed
