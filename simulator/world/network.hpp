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
/// A scenario brought to life: bus, nodes, what happens to them. Throws YamlError and cia306::InputError while it
/// is being built; after that only time passes. The same scenario gives the same journal. Managers join it.
/// [SRS_SIM_003]
class Network final : private host::BusObserver
{
  public:
    /// @brief `scenario` and `journal` outlive the network.
    Network(const Scenario& scenario, Journal& journal);

    /// @brief One more who acts by itself, on that node of the bus; `whose` frames they are in the journal. Outlives
    /// the last RunUntil.
    void Join(Participant& participant, host::NodeIndex bus_node, NodeIndex whose);
    /// @brief Everything up to and including `until`. Cheap to call in small steps.
    void RunUntil(Nanoseconds until);
    [[nodiscard]] Nanoseconds Now() const noexcept;
    [[nodiscard]] Node& At(NodeIndex node);
    [[nodiscard]] std::size_t Size() const noexcept;
    [[nodiscard]] host::VirtualBus& Bus() noexcept;
    [[nodiscard]] std::uint64_t CycleCount() const noexcept;
    /// @brief Copies of frames that did not fit any more, by fault. [SRS_SIM_017]
    [[nodiscard]] const std::map<std::size_t, std::uint32_t>& DroppedCopies() const noexcept;

  private:
    void OnBusRecord(const host::BusRecord& record) override;
    void BuildNodes();
    void BuildNode(NodeIndex index, const NodeSetup& setup, Journal& journal, Insight insight);
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
    std::uint64_t cycles_{0U};
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_NETWORK_HPP
