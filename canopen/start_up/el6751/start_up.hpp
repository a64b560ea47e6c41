// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_EL6751_START_UP_HPP
#define CANOPEN_START_UP_EL6751_START_UP_HPP

#include "canopen/start_up/el6751/operation.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// MasterState of this profile.
constexpr std::int16_t kEl6751Ended = 0;
constexpr std::int16_t kEl6751Starts = 1;   ///< Not every slave was started.
constexpr std::int16_t kEl6751Runs = 2;     ///< Every slave was started once.
constexpr std::int16_t kEl6751NoBus = 3;    ///< The controller is bus-off or does not start.
constexpr std::int16_t kEl6751Unusable = 4; ///< Not enough room for the PDOs: nothing is started.

/// State of the manager's CAN controller, as its owner tells it.
enum class ControllerState : std::uint8_t
{
    kRunning = 0U,
    kBusOff = 1U,
    kAbsent = 2U, ///< It does not start.
};

/// Start-up and supervision as in the EL6751 text. The SDO pool should have kEl6751SdoTimes. See StartUp for the order
/// of calls.
class El6751StartUp final : public StartUp
{
  public:
    /// @brief The parts are kept by reference.
    explicit El6751StartUp(const El6751Parts& parts) noexcept;

    void Begin(Instant now) noexcept override;
    void End() noexcept override;
    void OnFrame(const CanFrame& frame, Instant now) noexcept override;
    void OnCycle(Instant now) noexcept override;
    void OnRoom(Instant now) noexcept override;
    void OnNodeEvent(NodeId node, NodeEvent event, Instant now) noexcept override;
    void OnStartDropped(NodeId node, Instant now) noexcept override;
    /// @brief Stop and PRE-OPERATIONAL hold the slave by hand; a start while a start-up runs follows it.
    [[nodiscard]] NmtAnswer Command(NmtCommand command, NodeId node, Instant now) noexcept override;
    /// @brief Reset communication of the slave, then its start-up, also of one that is held by hand.
    [[nodiscard]] bool Boot(NodeId node, Instant now) noexcept override;
    /// @brief The SDOs of the slave again without a reset; a slave that is held by hand stays held.
    [[nodiscard]] bool Resume(NodeId node, Instant now) noexcept override;
    /// @brief Boot of a slave that IsConfigurable. [SRS_NMM_151]
    [[nodiscard]] bool Configure(NodeId node, Instant now) noexcept override;
    [[nodiscard]] NodeStatus Status(NodeId node) const noexcept override;
    [[nodiscard]] std::int16_t MasterState() const noexcept override;
    [[nodiscard]] IdentityRule Identity() const noexcept override
    {
        return IdentityRule::kEl6751;
    }

    /// @brief A frame of this device was on the bus; only El6751Window::kLastRxPdo needs it.
    void OnSent(const CanFrame& frame) noexcept;
    /// @brief The state of the controller changed. [SRS_ELM_044, SRS_ELM_045]
    void OnController(ControllerState state, Instant now) noexcept;
    /// @brief Network management by hand: ADS state and device state of a write control. kWrong: the table has no such
    /// transition from the slave's state, or its start-up runs. [SRS_ELM_046, SRS_ELM_047]
    [[nodiscard]] NmtAnswer Control(NodeId node, std::uint16_t ads_state, std::uint16_t device_state,
                                    Instant now) noexcept;
    /// @brief The state from which Control goes on: what 1F82h reads; STOPPED of a slave that is deactivated.
    [[nodiscard]] SlaveState ControlState(NodeId node) const noexcept;
    /// @brief NodeState of the slave's last error since Begin; 0: none.
    [[nodiscard]] std::int16_t Cause(NodeId node) const noexcept;

  private:
    void TellMaster(Instant now) noexcept;
    void BeginAll(Instant now) noexcept;
    void SendReset(Instant now) noexcept;
    void GiveUpStartOfAll() noexcept;
    void StartAll(Instant now) noexcept;
    void OnRestartOfSlave(NodeId node, Instant now) noexcept;
    [[nodiscard]] NmtAnswer CommandOne(NmtCommand command, NodeId node, Instant now) noexcept;
    [[nodiscard]] NmtAnswer Hold(NmtCommand command, NodeId node, Instant now) noexcept;
    [[nodiscard]] NmtAnswer Start(NodeId node, Instant now) noexcept;
    [[nodiscard]] NmtAnswer Reset(NmtCommand command, NodeId node, Instant now) noexcept;

    StartUpParts parts_;
    El6751Pdos pdos_;
    El6751Slaves slaves_;
    El6751Sdos sdos_;
    El6751Operation operation_;
    ControllerState controller_;
    std::int16_t master_; ///< As told last.
    bool is_active_;
    bool is_usable_;
    bool is_reset_due_;
    bool has_started_all_;
};

} // namespace counterpoint::cia302

#endif
