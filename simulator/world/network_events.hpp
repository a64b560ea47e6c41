// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_NETWORK_EVENTS_HPP
#define SIMULATOR_WORLD_NETWORK_EVENTS_HPP

#include "simulator/world/agenda.hpp"
#include "simulator/world/world.hpp"

namespace counterpoint::simulator
{
/// Plans everything that happens to the devices of a scenario, but for faults. [SRS_SIM_006, SRS_SIM_037, SRS_MGR_155]
class NetworkEvents
{
  public:
    /// @brief Both outlive it.
    NetworkEvents(World& world, Agenda& agenda);

    /// @brief Puts all of it on the agenda. Call it once.
    void PlanAll();

  private:
    void PlanNmt();
    void PlanActions();
    /// @brief `closes`: it leaves OPERATIONAL by it.
    void NoteCommand(NodeIndex node, bool closes);
    void Start(NodeIndex node);
    void Command(NodeIndex node, const NmtEvent& event);
    void Act(const Action& action, Node& node);
    void PullAll(NodeIndex index);

    World& world_;
    const Scenario& scenario_;
    Agenda& agenda_;
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_NETWORK_EVENTS_HPP
