// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_NETWORK_HPP
#define SIMULATOR_WORLD_NETWORK_HPP

#include "simulator/faults/foreign_controller.hpp"
#include "simulator/faults/frame_faults.hpp"
#include "simulator/journal/bus_place.hpp"
#include "simulator/journal/journal.hpp"
#include "simulator/scenario/scenario.hpp"
#include "simulator/world/link_wire.hpp"
#include "simulator/world/node.hpp"

#include "hal/host/virtual/bus.hpp"

#include <functional>
#include <map>
#include <memory>
#include <vector>

namespace counterpoint::simulator
{
/// A scenario brought to life: bus, nodes, what happens to them. Throws YamlError and cia306::InputError while it
/// is being built; after that only time passes. The same scenario gives the same journal. [SRS_SIM_003]
class Network final : private host::BusObserver
{
  public:
    /// @brief `scenario` and `journal` outlive the network.
    Network(const Scenario& scenario, Journal& journal);

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
    /// One thing that the scenario makes happen.
    struct Action
    {
        Nanoseconds at{0};
        std::function<void()> act;
    };

    void OnBusRecord(const host::BusRecord& record) override;
    void BuildNodes();
    void BuildLinks();
    void DeliverMessages();
    void RequireLinks() const;
    void RequireOfCpu(const FaultSetup& fault) const;
    void PlanInsertedMessages(std::size_t index);
    void RequireThatEverythingExists() const;
    void RequirePair(NodeIndex node, const ObjectAddress& object, bool is_consumer, const Source& source) const;
    void RequireSrdo(NodeIndex node, std::uint8_t number, bool needs_consumer, const Source& source) const;
    void RequireValue(NodeIndex node, const ObjectAddress& object, std::uint64_t value, const Source& source) const;
    void RequireNodeIds() const;
    void RequireOfFault(const FaultSetup& fault) const;
    void RequireOfExpectation(const Expectation& expectation) const;
    void Plan(Nanoseconds at, std::function<void()> act);
    void BuildForeignControllers();
    void InstallFaults();
    [[nodiscard]] std::vector<FrameSelector> SelectorsOf(bool (*is_wanted)(FaultKind)) const;
    void PlanWorld();
    void PlanNmt();
    void Command(NodeIndex node, const NmtEvent& event);
    void PlanFault(std::size_t index);
    /// @brief The beginnings and ends of a fault that lasts, as often as it comes and goes.
    void PlanState(std::size_t index, const std::function<void()>& begin, const std::function<void()>& end);
    void PlanForeignFrames(std::size_t index);
    void PlanPartFault(std::size_t index);
    [[nodiscard]] runtime::BitPlace PlaceOfBit(std::size_t index);
    void PlanBitFault(std::size_t index);
    void PlanStandstill(std::size_t index);
    void PlanDisturbance(std::size_t index);
    void PlanClock(std::size_t index);
    void PlanControllerFault(std::size_t index);
    void PlanBabbling(std::size_t index);
    void Insert(std::size_t index);
    void NoteFault(std::size_t index, NodeIndex node);
    void RunActions();

    const Scenario& scenario_;
    Journal& journal_;
    host::VirtualBus bus_;
    BusPlaces places_;
    std::unique_ptr<FrameFaults> frame_faults_;
    std::unique_ptr<ControllerFaults> controller_faults_;
    std::map<std::size_t, std::unique_ptr<ForeignController>> foreign_; ///< By fault.
    std::vector<std::unique_ptr<runtime::DeviceModel>> models_;
    std::vector<std::unique_ptr<Node>> nodes_;
    std::map<NodeIndex, std::unique_ptr<LinkWire>> wires_; ///< By CPU A.
    std::vector<Action> actions_;                          ///< By time; of two at the same time the one planned first.
    std::size_t next_action_{0U};
    std::uint64_t cycles_{0U};
};

/// What follows from a fault for its limit when the scenario says nothing. [SRS_SIM_031]
[[nodiscard]] FaultClass ClassOf(const FaultSetup& fault);
} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_NETWORK_HPP
