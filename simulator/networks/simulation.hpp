// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_NETWORKS_SIMULATION_HPP
#define SIMULATOR_NETWORKS_SIMULATION_HPP

#include "runtime/manager/station.hpp"
#include "simulator/journal/journal.hpp"
#include "simulator/networks/device.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace counterpoint::simulator
{
/// One manager of a simulated network, with what it told.
struct SimulatedManager
{
    ManagerSetup setup;
    std::size_t place{0U}; ///< In the journal: behind the nodes come the managers, then whoever else sends.
    std::uint8_t node{0U};
    std::unique_ptr<network::LoadedNetwork> net;
    std::unique_ptr<SimulatedPort> port; ///< Null: it has no supply.
    std::unique_ptr<runtime::ManagerStation> station;
    std::vector<runtime::ManagerEvent> events;
    Nanoseconds next_cycle{0};
    bool is_off_bus{false}; ///< Its controller neither sends nor receives.
};

using SimulatedManagers = std::vector<std::unique_ptr<SimulatedManager>>;

/// @brief What a scenario asks of its managers, against their network files: it would do nothing, or hold whatever
/// happens. Throws YamlError. [SRS_MGR_012]
void RequireOfManagers(const Scenario& scenario, const SimulatedManagers& managers);
/// @brief The manager with that node-ID, 0: the first one. Throws YamlError.
[[nodiscard]] SimulatedManager& ManagerOf(const SimulatedManagers& managers, std::uint8_t node_id,
                                          const Source& source);

/// A scenario with managers brought to life. The same scenario gives the same events. [SRS_MGR_012]
class NetworkSimulation
{
  public:
    /// @brief `scenario` and `journal` outlive it. Throws cia306::InputError and YamlError.
    NetworkSimulation(const Scenario& scenario, Journal& journal);

    /// @brief Everything up to and including `until`.
    void RunUntil(Nanoseconds until);
    [[nodiscard]] const SimulatedManagers& Managers() const noexcept
    {
        return managers_;
    }
    /// @brief Null: it is not there.
    [[nodiscard]] SimulatedDevice* DeviceOf(NodeIndex node);

  private:
    /// Frames that a defective device sends, one after the other.
    struct Storm
    {
        Action action;
        std::unique_ptr<SimulatedPort> port;
        Nanoseconds next{0};
    };
    /// What was last told of a device.
    struct Told
    {
        cia301::NodeState state{cia301::NodeState::kInvalid};
        SrdoMask open{0U};
    };

    void LoadManagers();
    [[nodiscard]] Nanoseconds Next() const;
    void Step(Nanoseconds now);
    void StartDue(Nanoseconds now);
    void StartManager(SimulatedManager& manager, Nanoseconds now);
    void Act(const Action& action, Nanoseconds now);
    void ActOnController(const Action& action, Nanoseconds now);
    void ActOnDevice(const Action& action, Nanoseconds now);
    void Insert(NodeIndex node, Nanoseconds now);
    void Pull(NodeIndex node);
    void RunStorms(Nanoseconds now);
    void RunManager(SimulatedManager& manager, Nanoseconds now);
    void TellFrame(const host::LiveFrame& frame, std::uint64_t begin_ns, std::size_t owner);
    void TellDevices(Nanoseconds now);
    void TellOutputs(SimulatedDevice& device, SrdoMask changed, Nanoseconds now);

    const Scenario& scenario_;
    Journal& journal_;
    SimulatedBus bus_;
    SimulatedManagers managers_;
    std::vector<NodeSetup> setups_; ///< As they are now: a replaced one has another serial number.
    std::vector<bool> has_come_;    ///< By setup: its supply came once.
    std::vector<Told> told_;        ///< By setup.
    std::vector<std::unique_ptr<SimulatedDevice>> devices_;
    std::vector<Storm> storms_;
    std::vector<Action> actions_; ///< By time.
    std::size_t next_action_{0U};
    Nanoseconds now_{-1};
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_NETWORKS_SIMULATION_HPP
