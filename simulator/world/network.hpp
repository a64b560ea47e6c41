// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_NETWORK_HPP
#define SIMULATOR_WORLD_NETWORK_HPP

#include "simulator/world/network_events.hpp"
#include "simulator/world/network_faults.hpp"
#include "simulator/world/participant.hpp"
#include "simulator/world/storm.hpp"

#include <cstdint>
#include <deque>
#include <map>
#include <vector>

namespace counterpoint::simulator
{
/// A scenario as it runs: bus, nodes, and what happens to them. Throws YamlError and cia306::InputError while it is
/// being built; afterwards only time passes. The same scenario gives the same journal. Managers join it. [SRS_SIM_003]
class Network final : private host::BusObserver
{
  public:
    /// @brief `scenario` and `journal` outlive the network.
    Network(const Scenario& scenario, Journal& journal);

    /// @brief Adds a participant that acts by itself, on that node of the bus; in the journal its frames belong to
    /// `whose`. It must outlive the last RunUntil.
    void Join(Participant& participant, host::NodeIndex bus_node, NodeIndex whose);
    /// @brief Lets time pass, up to and including `until`. Small steps cost little.
    void RunUntil(Nanoseconds until);
    /// @brief The time up to which everything was done.
    [[nodiscard]] Nanoseconds Now() const noexcept
    {
        return world_.Now();
    }
    /// @brief A node by its index in Scenario::nodes.
    [[nodiscard]] Node& At(NodeIndex node)
    {
        return *world_.nodes.at(node);
    }
    /// @brief Number of nodes.
    [[nodiscard]] std::size_t Size() const noexcept
    {
        return world_.scenario.nodes.size();
    }
    /// @brief The bus.
    [[nodiscard]] host::VirtualBus& Bus() noexcept
    {
        return world_.bus;
    }
    /// @brief By fault, how many copies of frames were dropped because a frame can have no more receptions.
    /// [SRS_SIM_017]
    [[nodiscard]] const std::map<std::size_t, std::uint32_t>& DroppedCopies() const noexcept;

  private:
    void OnBusRecord(const host::BusRecord& record) override;
    void BuildNodes();
    void BuildNode(NodeIndex index, const NodeSetup& setup, Journal& journal, bool is_tapped);
    void BuildLinks();
    void BuildStorms();
    void DeliverMessages();
    [[nodiscard]] Nanoseconds NextEvent() const noexcept;

    Journal unheard_; ///< Of devices that are not the scenario's.
    std::deque<NodeSetup> duplicates_;
    World world_;
    Agenda agenda_;
    std::unique_ptr<NetworkFaults> faults_;
    NetworkEvents events_;
    std::deque<Storm> storms_;
    std::vector<Participant*> participants_;
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_NETWORK_HPP
