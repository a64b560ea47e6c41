// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_NODE_NODE_HPP
#define SIMULATOR_WORLD_NODE_NODE_HPP

#include "simulator/world/node/controllers.hpp"
#include "simulator/world/node/firmware.hpp"
#include "simulator/world/node/inside.hpp"
#include "simulator/world/node/insight.hpp"
#include "simulator/world/node/parts.hpp"

#include <algorithm>
#include <memory>

namespace counterpoint::simulator
{
/// One device of the simulated network, or one CPU of it: an assembly with shipped channels on the hardware layer of
/// the host, with taps in front of them where it is looked into. [SRS_SIM_001]
class Node
{
  public:
    /// @brief Everything given outlives the node, but for the file. A setup whose phase never comes has no supply until
    /// PowerOn.
    Node(const NodePlace& place, const NodeSetup& setup, runtime::DeviceModel& model);

    /// @brief Starts and commissions the kernel as PowerOn will, to find out early whether it can be. Throws
    /// cia306::InputError.
    void Rehearse()
    {
        firmware_.Start();
    }
    /// @brief The supply comes, for the first time or again: counters begin, the kernel starts and is commissioned, the
    /// watchdog starts. A device whose tables were hit by a fault may not start; then it stays off.
    void PowerOn();
    /// @brief The supply goes: outputs close, the controllers forget their frames. [SRS_SIM_037]
    void PowerOff();
    /// @brief Starts the kernel anew; a node that hangs does not hear of it.
    void ResetNode();
    /// @brief Passes initialising; the kernel's safe state and interlocks stay.
    void ResetCommunication();
    /// @brief Leads the node to this state, as a command of the NMT master to this node alone would.
    void SetNmt(NmtState state);
    /// @brief The next instant at which the node does something: a cycle, or an output that closes by itself.
    [[nodiscard]] Nanoseconds NextEvent() const noexcept
    {
        const Nanoseconds of_program = std::min(clock_.NextCycle(), firmware_.ServeAt());
        return std::min(processor_.IsHung() ? kNever : of_program, outputs_.LookAt());
    }
    /// @brief Does what is due at the bus's present instant.
    void Run();

    [[nodiscard]] NodeIndex Index() const noexcept
    {
        return place_.index;
    }
    [[nodiscard]] bool HasSupply() const noexcept
    {
        return processor_.HasSupply();
    }
    /// @brief kInvalid: it has no supply.
    [[nodiscard]] cia301::NodeState State() const noexcept
    {
        return HasSupply() ? firmware_.State() : cia301::NodeState::kInvalid;
    }
    [[nodiscard]] SrdoMask Open() const noexcept
    {
        return outputs_.Open();
    }
    [[nodiscard]] const runtime::DeviceModel& Model() const noexcept
    {
        return model_;
    }
    [[nodiscard]] NodeProcessor& Processor() noexcept
    {
        return processor_;
    }
    [[nodiscard]] NodeClock& Clock() noexcept
    {
        return clock_;
    }
    [[nodiscard]] NodeApplication& App() noexcept
    {
        return application_;
    }
    [[nodiscard]] NodeControllers& Controllers() noexcept
    {
        return controllers_;
    }
    [[nodiscard]] NodeFirmware& Firmware() noexcept
    {
        return firmware_;
    }
    [[nodiscard]] NodeParts& Parts() noexcept
    {
        return parts_;
    }

  private:
    void StartFresh();
    void Cycle();
    void LookInside();
    void Obey(cia301::NmtCommand command);
    void Settle();
    [[nodiscard]] NodeInside Inside() noexcept;

    NodePlace place_; ///< Its file is a mark only.
    const NodeSetup& setup_;
    runtime::DeviceModel& model_;
    NodeProcessor processor_;
    NodeClock clock_;
    NodePairs pairs_;
    NodeInsight insight_;
    NodeOutputs outputs_;
    NodeChannels channels_;
    NodeApplication application_;
    std::unique_ptr<NodeSelfTest> self_test_; ///< Null: the device has none.
    NodeControllers controllers_;
    NodeFirmware firmware_;
    NodeParts parts_;
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_NODE_NODE_HPP
