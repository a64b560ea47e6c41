// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_EL6751_START_UP_HPP
#define CANOPEN_START_UP_EL6751_START_UP_HPP

#include "canopen/cia302/network/start_up.hpp"
#include "canopen/start_up/el6751/pdos.hpp"
#include "canopen/start_up/el6751/rows.hpp"
#include "canopen/start_up/el6751/states.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// NodeState: what the status of a slave has as `code`.
constexpr std::int16_t kNodeRuns = 0;        ///< Started, every TxPDO received, no error.
constexpr std::int16_t kNodeDeactivated = 1; ///< Heartbeat or guarding lost, or stopped until a hand restarts it.
constexpr std::int16_t kNodeNotFound = 2;    ///< The first SDO is not answered.
constexpr std::int16_t kNodeSyntax = 4;      ///< An SDO of the start-up was aborted, or of a wrong length.
constexpr std::int16_t kNodeMismatch = 5;    ///< A value is not the configured one.
constexpr std::int16_t kNodeStarts = 8;      ///< Start-up runs.
constexpr std::int16_t kNodeBusOff = 11;     ///< The manager's own controller.
constexpr std::int16_t kNodePreOperational = 12;
constexpr std::int16_t kNodeBusFault = 13; ///< The manager's controller does not start.
constexpr std::int16_t kNodeToggle = 14;   ///< Guarding.
constexpr std::int16_t kNodePdoTooShort = 20;
constexpr std::int16_t kNodePdoMissing = 22;
constexpr std::int16_t kNodeWaitsForPdos = 23; ///< Started; not every TxPDO was received.
constexpr std::int16_t kNodePdoNotInCycle = 40;

/// MasterState of this profile.
constexpr std::int16_t kEl6751Ended = 0;
constexpr std::int16_t kEl6751Starts = 1;   ///< Not every slave was started.
constexpr std::int16_t kEl6751Runs = 2;     ///< Every slave was started once.
constexpr std::int16_t kEl6751NoBus = 3;    ///< The controller is bus-off or does not start.
constexpr std::int16_t kEl6751Unusable = 4; ///< Not enough room for the PDOs: nothing is started.

/// State of the manager's CAN controller, told by its owner.
enum class ControllerState : std::uint8_t
{
    kRunning = 0U,
    kBusOff = 1U,
    kAbsent = 2U, ///< It does not start.
};

/// One slave. Zero-filled at first. Beside the phase stands what is known.
struct El6751Node
{
    El6751Phase phase; ///< Changes by Next alone.
    El6751Place place;
    NodeStatus status;
    std::int16_t cause;         ///< NodeState of the last error.
    std::int16_t control_fault; ///< 1, 14 or 12 until the next right sign of life; 0: none.
    std::int16_t held_code;     ///< Of kHeld.
    std::uint8_t signs;         ///< Of the node table, when the phase, the fault or the wait began.
    std::uint8_t beats;         ///< Likewise, when the control fault began: an answer that does not toggle ends none.
    bool has_answered;          ///< Any SDO of this start-up.
    bool is_transferring;
    bool is_requested;    ///< NMT start was handed over.
    bool is_start_wanted; ///< By hand, whatever the automatic start says.
    bool is_held_by_hand;
    bool was_started;     ///< Singly, since Begin.
    bool was_operational; ///< Said so since its start.
    bool is_settled;      ///< 1 s since the start.
    bool is_wait_over;    ///< 10 s since the start.
    bool is_checking;     ///< Found OPERATIONAL: the gate reads.
    bool was_checked;     ///< Found OPERATIONAL and read.
    bool is_unread;       ///< Stopped because it ran and did not answer.
    bool has_restarted;   ///< While it was deactivated.
    bool is_cut;          ///< Held by hand in the middle of its SDOs.
    Instant started;
    std::uint8_t buffer[8];
};

/// `nodes` has kNodeRoom elements. All kept by reference.
struct El6751Parts
{
    StartUpParts common;
    El6751Node* nodes;
    El6751PdoRoom pdos;
    El6751Times times;
};

/// Start-up and supervision as in the EL6751 text. The SDO pool should have kEl6751SdoTimes. See StartUp for the order
/// of calls.
class El6751StartUp final : public StartUp
{
  public:
    explicit El6751StartUp(const El6751Parts& parts) noexcept;

    void Begin(Instant now) noexcept override;
    void End() noexcept override;
    void OnFrame(const CanFrame& frame, Instant now) noexcept override;
    void OnCycle(Instant now) noexcept override;
    void OnNodeEvent(NodeId node, NodeEvent event, Instant now) noexcept override;
    void OnStartDropped(NodeId node, Instant now) noexcept override;
    /// @brief Stop and PRE-OPERATIONAL hold the slave by hand; a start while a start-up runs follows it.
    [[nodiscard]] NmtAnswer Command(NmtCommand command, NodeId node, Instant now) noexcept override;
    /// @brief Reset communication of the slave, then its start-up, also of one that is held by hand.
    [[nodiscard]] bool Boot(NodeId node, Instant now) noexcept override;
    /// @brief Its SDOs without the reset; one that is held by hand waits on.
    [[nodiscard]] bool Resume(NodeId node, Instant now) noexcept override;
    [[nodiscard]] NodeStatus Status(NodeId node) const noexcept override;
    [[nodiscard]] std::int16_t MasterState() const noexcept override;
    [[nodiscard]] IdentityRule Identity() const noexcept override
    {
        return IdentityRule::kEl6751;
    }

    /// @brief A frame of this device was on the bus; only El6751Window::kLastRxPdo needs it.
    void OnSent(const CanFrame& frame) noexcept;
    /// @brief The controller changed. [SRS_ELM_044, SRS_ELM_045]
    void OnController(ControllerState state, Instant now) noexcept;
    /// @brief Network management by hand: ADS state and device state of a write control. kWrong: the table has no such
    /// transition from the slave's state, or its start-up runs. [SRS_ELM_046, SRS_ELM_047]
    [[nodiscard]] NmtAnswer Control(NodeId node, std::uint16_t ads_state, std::uint16_t device_state,
                                    Instant now) noexcept;
    /// @brief NodeState of the slave's last error since Begin; 0: none.
    [[nodiscard]] std::int16_t Cause(NodeId node) const noexcept;

  private:
    [[nodiscard]] El6751Node& Of(NodeId node) const noexcept;
    [[nodiscard]] const El6751Slave& SetupOf(NodeId node) const noexcept;
    [[nodiscard]] El6751Context Context(NodeId node) const noexcept;
    [[nodiscard]] bool IsSafety(NodeId node) const noexcept;
    void Tell(NodeId node, std::int16_t code, StartUpStep step, Instant now) noexcept;
    void TellMaster(Instant now) noexcept;
    void SendReset(Instant now) noexcept;
    void Drive(NodeId node, Instant now) noexcept;
    void StartAll(Instant now) noexcept;
    void OnRestartOfSlave(NodeId node, Instant now) noexcept;
    void OnFault(NodeId node, std::int16_t code, Instant now) noexcept;

    void DriveReset(NodeId node, Instant now) noexcept;
    void BeginRows(NodeId node, std::int16_t code, Instant now) noexcept;
    void DriveRows(NodeId node, Instant now) noexcept;
    void BeginTransfer(NodeId node, Instant now) noexcept;
    void EndTransfer(NodeId node, Instant now) noexcept;
    void EndRows(NodeId node, Instant now) noexcept;
    void Fail(NodeId node, std::int16_t code, Instant now) noexcept;
    void Supervise(NodeId node, Instant now) noexcept;
    void BeginStart(NodeId node, Instant now) noexcept;
    void DriveVerify(NodeId node, Instant now) noexcept;
    void StopUnread(NodeId node, Instant now) noexcept;
    void RefuseSafety(NodeId node, Instant now) noexcept;
    void DriveStart(NodeId node, Instant now) noexcept;

    void Run(NodeId node, Instant now) noexcept;
    void Watch(NodeId node, Instant now) noexcept;
    [[nodiscard]] std::int16_t FaultOf(NodeId node) noexcept;
    void React(NodeId node, std::int16_t code, Instant now) noexcept;
    void StopOthers(NodeId node, Instant now) noexcept;
    void Stop(NodeId node, El6751Event event, Instant now) noexcept;
    void DriveStop(NodeId node, Instant now) noexcept;
    void Hold(NodeId node, std::int16_t code, Instant now) noexcept;
    void DriveIdle(NodeId node, Instant now) noexcept;
    void VerifyAgain(NodeId node, Instant now) noexcept;
    void DriveCheck(NodeId node, bool is_suspect, Instant now) noexcept;

    [[nodiscard]] NmtAnswer CommandOne(NmtCommand command, NodeId node, Instant now) noexcept;
    [[nodiscard]] NmtAnswer HoldByHand(NmtCommand command, NodeId node, Instant now) noexcept;
    [[nodiscard]] NmtAnswer StartByHand(NodeId node, Instant now) noexcept;
    [[nodiscard]] NmtAnswer Reset(NmtCommand command, NodeId node, Instant now) noexcept;

    El6751Parts parts_;
    El6751Pdos pdos_;
    ControllerState controller_;
    std::int16_t master_; ///< As told last.
    bool is_active_;
    bool is_usable_;
    bool is_reset_due_;
    bool has_started_all_;
};

} // namespace counterpoint::cia302

#endif
