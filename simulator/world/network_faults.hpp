// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_NETWORK_FAULTS_HPP
#define SIMULATOR_WORLD_NETWORK_FAULTS_HPP

#include "simulator/faults/foreign_controller.hpp"
#include "simulator/faults/frame_faults.hpp"
#include "simulator/world/agenda.hpp"
#include "simulator/world/world.hpp"

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <vector>

namespace counterpoint::simulator
{
/// Makes the faults of a scenario happen: faults of frames are installed on the bus, all others are planned on the
/// agenda. [SRS_SIM_020, SRS_SIM_021, SRS_SIM_022, SRS_SIM_023, SRS_SIM_024, SRS_SIM_025]
class NetworkFaults
{
  public:
    /// @brief Both outlive it.
    NetworkFaults(World& world, Agenda& agenda);

    /// @brief Installs and plans all faults. Call it once. Throws YamlError for a place that a device does not have.
    void PlanAll();
    /// @brief By fault, how many copies of frames were dropped because a frame can have no more receptions.
    /// [SRS_SIM_017]
    [[nodiscard]] const std::map<std::size_t, std::uint32_t>& Dropped() const noexcept;
    /// @brief After the nodes ran: faults that wait for the supply of their device have an effect now.
    void LookAtSupply();

  private:
    void BuildForeignControllers();
    void Install();
    template <typename Family> [[nodiscard]] std::vector<FrameSelector> SelectorsOf() const;
    // What a kind does by itself, by family. Of frames and messages others choose those that a fault hits.
    void Plan(FrameFault kind, std::size_t index);
    void Plan(ControllerFault kind, std::size_t index);
    void Plan(ForeignFault kind, std::size_t index);
    void Plan(PartFault kind, std::size_t index);
    void Plan(NodeFault kind, std::size_t index);
    void Plan(LinkFault kind, std::size_t index);
    /// @brief The beginnings and ends of a fault that lasts, as often as it comes and goes.
    void PlanState(std::size_t index, const std::function<void()>& begin, const std::function<void()>& act_at_end);
    /// @brief As often as the fault says.
    void PlanTimes(std::size_t index, const std::function<void()>& act);
    [[nodiscard]] runtime::BitPlace PlaceOfBit(std::size_t index);
    void PlanClock(std::size_t index);
    /// @brief The controllers that are meant go, and come back.
    void PlanAbsence(std::size_t index, void (host::VirtualBus::*go)(host::NodeIndex),
                     void (host::VirtualBus::*come)(host::NodeIndex));
    void Insert(std::size_t index);
    void NoteFault(std::size_t index, NodeIndex node);
    /// @brief A fault that lasts begins; in a device without supply it has an effect when that comes.
    void NoteBegin(std::size_t index);
    /// @brief A fault of one instant in a device. Without supply nothing is there that it could change.
    void PlanInstant(std::size_t index, const std::function<void(Node&)>& act);

    World& world_;
    const Scenario& scenario_;
    Agenda& agenda_;
    std::unique_ptr<FrameFaults> frame_faults_;
    std::unique_ptr<ControllerFaults> controller_faults_;
    std::map<std::size_t, std::unique_ptr<ForeignController>> foreign_; ///< By fault.
    std::set<std::size_t> waiting_;                                     ///< Faults that have begun without effect.
};

/// The row of the table of limits for a fault, where the scenario names none. [SRS_SIM_031, SRS_SIM_215, SRS_SIM_216]
[[nodiscard]] FaultClass ClassOf(const FaultSetup& fault);
} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_NETWORK_FAULTS_HPP
