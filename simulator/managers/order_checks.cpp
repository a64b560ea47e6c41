// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Orders of a scenario that a manager answers with a refusal whenever they come, by its network file. [SRS_MGR_587]
#include "runtime/manager/order.hpp"
#include "runtime/manager/report/texts.hpp"
#include "simulator/managers/manager.hpp"
#include "simulator/scenario/names.hpp"

#include <algorithm>

namespace counterpoint::simulator
{
namespace
{
using Kind = runtime::ManagerOrderKind;

/// What is wrong with an order, and what was expected; empty: nothing.
struct Problem
{
    std::string wrong;
    std::string expected;
};

std::string NodeText(const runtime::ManagerOrder& order)
{
    return "node " + std::to_string(order.node);
}

/// What the profile of the manager, or its role, does not have.
Problem OfProfile(const runtime::ManagerOrder& order, const SimulatedManager& manager)
{
    const network_plan::ManagerPlan& plan = manager.Net().Plan().manager;
    const bool is_el6751 = plan.profile == network_plan::StartProfile::kEl6751;
    const bool is_by_order = plan.flying && plan.flying->is_by_order;
    Problem problem;
    if ((order.kind == Kind::kControl || order.kind == Kind::kOutput) && !is_el6751)
    {
        problem = {"with the profile " + runtime::WordOf(plan.profile), "the profile el6751"};
    }
    else if (order.kind == Kind::kNegotiate && !is_by_order)
    {
        problem = {"at manager " + std::to_string(manager.Node()) + ", whose negotiation waits for no order",
                   "flying: {start: by_order}"};
    }
    return problem;
}

/// A node that the order cannot be for: commands go to all and to the manager itself, too.
Problem OfNode(const runtime::ManagerOrder& order, const SimulatedManager& manager)
{
    const cia302::NetworkSetup& setup = manager.Net().Setup();
    const cia302::NodeId node{order.node};
    const bool is_command = order.kind == Kind::kCommand;
    const bool is_of_slave = order.kind == Kind::kControl || order.kind == Kind::kOutput || order.kind == Kind::kBoot ||
                             order.kind == Kind::kWriteSafety;
    const bool is_wide = is_command && (order.node == 0U || order.node == manager.Node());
    Problem problem;
    if ((is_command || is_of_slave) && !is_wide && !setup.IsListed(node))
    {
        problem = {"for " + NodeText(order) + ", which is no slave of manager " + std::to_string(manager.Node()),
                   "one of its network file"};
    }
    else if (order.kind == Kind::kWriteSafety && !setup.IsSafetySlave(node))
    {
        problem = {"for " + NodeText(order) + ", which has no safety configuration", "a safety slave"};
    }
    return problem;
}

/// An RxPDO that the slave does not have, or of another length.
Problem OfOutput(const runtime::ManagerOrder& order, const SimulatedManager& manager)
{
    const network_plan::LoadedSlave* const slave = manager.Net().Find(order.node);
    Problem problem;
    if (order.kind == Kind::kOutput && slave != nullptr)
    {
        const auto& pdos = slave->profile.rx_pdos;
        const auto found = std::find_if(pdos.begin(), pdos.end(),
                                        [&order](const cia302::El6751Pdo& pdo) { return pdo.number == order.pdo; });
        const std::string name = "for RxPDO " + std::to_string(order.pdo) + " of " + NodeText(order);
        if (found == pdos.end())
        {
            problem = {name + ", which it does not have", "one that its DCF switches on and maps"};
        }
        else if (found->length_bytes != order.bytes.size())
        {
            problem = {name + " with " + std::to_string(order.bytes.size()) + " bytes",
                       std::to_string(found->length_bytes) + " as its mapping has"};
        }
    }
    return problem;
}

/// ADS and device states that no row of the text's table has.
Problem OfStates(const runtime::ManagerOrder& order)
{
    constexpr std::uint16_t kRun = 5U;
    constexpr std::uint16_t kStop = 6U;
    constexpr std::uint16_t kLastOfRun = 3U;
    const bool is_run = order.ads_state == kRun && order.device_state <= kLastOfRun;
    const bool is_stop = order.ads_state == kStop && order.device_state == 0U;
    Problem problem;
    if (order.kind == Kind::kControl && !is_run && !is_stop)
    {
        problem = {"with ADS state " + std::to_string(order.ads_state) + " and device state " +
                       std::to_string(order.device_state),
                   "5 and 0 to 3, or 6 and 0"};
    }
    return problem;
}

/// An object that the manager does not have, or that nobody writes.
Problem OfObject(const runtime::ManagerOrder& order, SimulatedManager& manager)
{
    Problem problem;
    if (order.kind == Kind::kSet)
    {
        const runtime::ManagerStation station(
            manager.NetRoom(), [](const CanFrame&) { return false; }, [](const runtime::ManagerEvent&) {});
        if (!station.CanSet(order.object))
        {
            problem = {"for " + ObjectText(order.object) + " of manager " + std::to_string(manager.Node()),
                       "a number that it has and that can be written"};
        }
    }
    return problem;
}
} // namespace

void RequirePossible(const Action& action, const runtime::ManagerOrder& order, SimulatedManager& manager)
{
    for (const Problem& problem : {OfProfile(order, manager), OfNode(order, manager), OfOutput(order, manager),
                                   OfStates(order), OfObject(order, manager)})
    {
        if (!problem.wrong.empty())
        {
            throw YamlError(action.order_source.file, action.order_source.place,
                            "order " + runtime::Shown(action.order) + " " + problem.wrong, problem.expected);
        }
    }
}
} // namespace counterpoint::simulator
