// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_MANAGER_ASSEMBLY_HPP
#define RUNTIME_MANAGER_ASSEMBLY_HPP

#include "canopen/manager/manager.hpp"
#include "canopen/network_plan/loaded_network.hpp"
#include "canopen/start_up/cia302/start_up.hpp"
#include "canopen/start_up/el6751/start_up.hpp"
#include "canopen/start_up/plc_designer/start_up.hpp"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// A network manager with all the room it needs, as a network file describes it. Time and frames come in with the
/// calls. Its parts refer to each other, so it cannot be moved or copied. [SRS_MGR_001]
class ManagerAssembly
{
  public:
    /// @brief All arguments outlive it.
    ManagerAssembly(const network_plan::LoadedNetwork& net, cia301::FrameSink& sink, cia302::ManagerListener& listener);
    ManagerAssembly(const ManagerAssembly&) = delete;
    ManagerAssembly& operator=(const ManagerAssembly&) = delete;

    /// @brief The manager.
    [[nodiscard]] cia302::Manager& Core() noexcept
    {
        return manager_;
    }
    /// @brief The same, to look at.
    [[nodiscard]] const cia302::Manager& Core() const noexcept
    {
        return manager_;
    }
    /// @brief The network.
    [[nodiscard]] const network_plan::LoadedNetwork& Net() const noexcept
    {
        return net_;
    }
    /// @brief The start-up profile.
    [[nodiscard]] cia302::StartUp& Profile() noexcept
    {
        return *profile_;
    }
    /// @brief The same, to look at.
    [[nodiscard]] const cia302::StartUp& Profile() const noexcept
    {
        return *profile_;
    }
    /// @brief 1F90h of a flying master; a change counts from the next start of a negotiation on.
    [[nodiscard]] cia302::FlyingMasterTimes& FlyingTimes() noexcept
    {
        return flying_times_;
    }
    /// @brief 1017h of the manager.
    void SetHeartbeat(std::uint16_t period_ms) noexcept;
    /// @brief Lets the first negotiation begin. Answers "taken", or the reason why not. [SRS_MGR_023]
    [[nodiscard]] std::string Negotiate();
    /// @brief Lets later negotiations begin by themselves. Call it before the manager's cycle.
    void OnCycle(Instant now);
    /// @brief Whether a slave is OPERATIONAL by what it said last, where a heartbeat or guarding answer is expected of
    /// it or it was heard, else by what it was told. [SRS_MGR_082]
    [[nodiscard]] bool Runs(cia302::NodeId node) const noexcept;
    /// @brief Whether a slave was started, and the heartbeat that is expected of it has not come since.
    [[nodiscard]] bool IsUnheard(cia302::NodeId node) const noexcept;
    /// @brief Whether a slave runs, its start-up ended without a finding, and it told no fault of the device.
    /// [SRS_MGR_131, SRS_MGR_132]
    [[nodiscard]] bool IsGood(cia302::NodeId node) const noexcept;
    /// @brief Whether the profile is CiA 302-2, this manager leads, and boots the slave (1F81h bit 2), whose boot
    /// has not ended.
    /// [SRS_MGR_750]
    [[nodiscard]] bool HasUnendedBoot(cia302::NodeId node) const noexcept;
    /// @brief Whether another device was heard with the node-ID of this manager, since the last reset of it.
    /// [SRS_MGR_588]
    [[nodiscard]] bool HasDouble() const noexcept;
    /// @brief Whether every mandatory slave is good, or waits for TxPDOs alone, and this manager is the only one of its
    /// node-ID. [SRS_MGR_004, SRS_MGR_588]
    [[nodiscard]] bool HasStarted() const noexcept;
    /// @brief Tells the flying master and the EL6751 profile the state of the controller.
    void OnController(cia302::ControllerState state, Instant now) noexcept;
    /// @brief A frame of this manager was on the bus.
    void OnSent(const CanFrame& frame) noexcept;
    /// @brief The state from which Control goes on; kUnknown under another profile than EL6751. [SRS_ELM_670]
    [[nodiscard]] cia302::SlaveState ControlState(cia302::NodeId node) const noexcept
    {
        return (el6751_ != nullptr) ? el6751_->ControlState(node) : cia302::SlaveState::kUnknown;
    }
    /// @brief Manual network management of the EL6751 profile; kWrong under another profile. [SRS_ELM_046]
    [[nodiscard]] cia302::NmtAnswer Control(cia302::NodeId node, std::uint16_t ads_state, std::uint16_t device_state,
                                            Instant now) noexcept;

  private:
    [[nodiscard]] bool HasFault(cia302::NodeId node) const noexcept;
    [[nodiscard]] cia302::ManagerRoom Room() noexcept;
    void MakeProfile();
    void Use(cia302::StartUp& profile) noexcept;
    void MakeFlying(cia301::FrameSink& sink);

    const network_plan::LoadedNetwork& net_;
    std::array<cia302::NodeRecord, cia302::kNodeRoom> records_{};
    std::array<cia302::WatchedNode, cia302::kNodeRoom> watched_{};
    std::array<cia302::GateState, cia302::kNodeRoom> gates_{};
    std::array<cia302::NmtRequest, 256U> commands_{};
    std::array<cia302::SafetySlot, cia302::kLastNode> safety_{};
    cia302::SdoTimes times_;
    cia302::SdoLanes<cia302::kLastNode> lanes_;
    cia302::Manager manager_;
    std::array<cia302::BootRecord, cia302::kNodeRoom> boots_{};
    std::array<cia302::El6751Node, cia302::kNodeRoom> el6751_nodes_{};
    std::vector<cia302::El6751PdoRecord> el6751_pdos_;
    std::array<cia302::PlcNode, cia302::kNodeRoom> plc_nodes_{};
    std::unique_ptr<cia302::Cia302StartUp> cia302_;
    std::unique_ptr<cia302::El6751StartUp> el6751_;
    std::unique_ptr<cia302::PlcStartUp> plc_;
    cia302::StartUp* profile_{nullptr}; ///< One of the three.
    cia302::FlyingMasterTimes flying_times_{};
    cia302::FlyingMasterOptions flying_options_{};
    bool is_held_{false}; ///< The first negotiation waits for its order.
    std::unique_ptr<cia302::FlyingMaster> flying_;
};

/// @brief 1F90h of a flying master, with the defaults where the plan has nothing.
[[nodiscard]] cia302::FlyingMasterTimes FlyingTimesOf(const network_plan::NetworkPlan& plan);
} // namespace counterpoint::runtime

#endif // RUNTIME_MANAGER_ASSEMBLY_HPP
