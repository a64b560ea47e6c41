// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA302_NETWORK_START_UP_HPP
#define CANOPEN_CIA302_NETWORK_START_UP_HPP

#include "canopen/cia302/network/nmt_master.hpp"
#include "canopen/cia302/network/node_table.hpp"
#include "canopen/cia302/network/sdo_pool.hpp"
#include "canopen/cia302/network/setup.hpp"
#include "canopen/cia302/network/start_gate.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// Where the start-up of a slave is, or where it ended. All profiles use this list, each its part of it.
enum class StartUpStep : std::uint8_t
{
    kNone = 0U,
    kReset = 1U,      ///< Reset sent, boot-up message awaited.
    kWaitBootUp = 2U, ///< Nothing sent: the slave is to come by itself.
    kDeviceType = 3U,
    kVendorId = 4U,
    kProductCode = 5U,
    kRevisionNumber = 6U,
    kSerialNumber = 7U,
    kStateCheck = 8U, ///< Looks whether a slave that is kept alive is OPERATIONAL.
    kSoftwareVersion = 9U,
    kSoftwareUpdate = 10U,
    kConfigurationDate = 11U,
    kRestore = 12U,
    kConfigure = 13U,
    kErrorControl = 14U,
    kSafety = 15U, ///< The gate verifies.
    kStart = 16U,
    kDone = 17U,
    kSyncPeriod = 18U,  ///< 1006h.
    kPdo = 19U,         ///< Communication parameters of a PDO.
    kPdoReadBack = 20U, ///< After an abort.
    kHeartbeat = 21U,   ///< 1017h, 1016h.
    kGuarding = 22U,    ///< 100Ch, 100Dh.
    kUserObjects = 23U, ///< SDOs of the list.
    kWaitPdos = 24U,    ///< Started; not all TxPDOs were received.
    kRunning = 25U,     ///< Nothing is left to do but to supervise.
    kManual = 26U,      ///< Waits for the application.
    kSettling = 27U,    ///< Time between boot-up message and first SDO.
};

/// What is known of the start-up of one slave. It stays until the next start-up of this slave begins.
struct NodeStatus
{
    char letter;            ///< CiA 302-2: 'A' to 'O', 0: none.
    std::int16_t code;      ///< EL6751: NodeState. PLC Designer: nStatus. CiA 302-2: 0.
    StartUpStep step;       ///< Now, or where it failed.
    ObjectAddress object;   ///< Last object asked for.
    SdoAbort abort;         ///< Of that object; kNone with a wrong value.
    std::uint64_t expected; ///< With a wrong value.
    std::uint64_t read;
    bool is_busy;    ///< Start-up runs.
    bool is_started; ///< NMT start was sent since the last boot-up: not while it waits to be.
    bool has_failed; ///< EL6751: the last start-up ended with NodeState 4 or 5, whoever started the slave since.
    bool is_other;   ///< The last start-up found another device than the expected one, or could not ask which it is.
    bool has_ended; ///< CiA 302-2: the last boot came to its end, with or without a letter: none runs, or was given up.

    /// @brief The object that kept the gate closed.
    constexpr void Take(const GateFinding& finding) noexcept
    {
        object = finding.object;
        abort = finding.abort;
        expected = finding.expected;
        read = finding.read;
    }
    /// @brief No object was asked for yet.
    constexpr void ForgetObject() noexcept
    {
        Take(GateFinding{ObjectAddress{0U, 0U}, SdoAbort::kNone, 0U, 0U});
    }
};

/// Is told what changes in the start-up of a network.
class StartUpListener
{
  public:
    /// @brief Step, letter or code of a slave changed; read it by Status.
    virtual void OnNodeStatus(NodeId node, Instant now) noexcept = 0;
    /// @brief MasterState changed.
    virtual void OnMasterState(std::int16_t state, Instant now) noexcept = 0;

  protected:
    StartUpListener() noexcept = default;
    ~StartUpListener() noexcept = default;
    StartUpListener(const StartUpListener&) = default;
    StartUpListener& operator=(const StartUpListener&) = default;
};

/// What every profile works with, kept by reference.
struct StartUpParts
{
    const NetworkSetup& setup;
    NodeTable& table;
    NmtMaster& nmt;
    SdoPool& sdo;
    StartGate& gate;
    cia301::FrameSink& sink; ///< For SYNC and PDOs; never for NMT.
    StartUpListener& listener;
};

/// A profile of start-up and supervision. The owner of the parts carries frames and cycles in this order:
///   OnFrame: table, nmt, sdo, start-up. The table's events come before the frame: on kBootUp and on a loss the
///   owner calls sdo.OnBootUp (boot-up only) and gate.Close, then OnNodeEvent of the start-up.
///   OnCycle: nmt, table, sdo, gate, start-up, nmt. A command that waits goes first, and OnRoom before sdo in both:
///   the others would take each place of the sink that becomes free.
/// Nothing here waits; each call does a bounded piece of work. Not reentrant.
class StartUp
{
  public:
    /// @brief The whole start-up from the beginning; this device is the active master.
    virtual void Begin(Instant now) noexcept = 0;
    /// @brief Everything stops where it is, nothing is sent any more: this device is not the active master.
    virtual void End() noexcept = 0;
    /// @brief A frame from the bus, behind table and SDO pool.
    virtual void OnFrame(const CanFrame& frame, Instant now) noexcept = 0;
    /// @brief Does what is due for every slave. O(127)
    virtual void OnCycle(Instant now) noexcept = 0;
    /// @brief Before others use the sink: what OnCycle had to send and found no room for. By itself this does nothing.
    virtual void OnRoom(Instant now) noexcept;
    /// @brief What the node table told of a node, listed or not.
    virtual void OnNodeEvent(NodeId node, NodeEvent event, Instant now) noexcept = 0;
    /// @brief The NMT master gave up a start that it had taken: the slave is verified again, and then started.
    virtual void OnStartDropped(NodeId node, Instant now) noexcept;
    /// @brief The bus is back after it was away. A profile may begin start-ups again that it was away from; by itself
    /// this does nothing.
    virtual void OnBusBack(Instant now) noexcept;
    /// @brief A command of the application, of 1F82h or typed: a start of a safety slave waits for its verification and
    /// is refused if the slave is another device (kOtherDevice), a start of all is one start for each slave where a
    /// safety slave is assigned.
    [[nodiscard]] virtual NmtAnswer Command(NmtCommand command, NodeId node, Instant now) noexcept = 0;
    /// @brief Begins the start-up of one slave again. False: it is not in the network, or the network is not started.
    [[nodiscard]] virtual bool Boot(NodeId node, Instant now) noexcept = 0;
    /// @brief As Boot without any reset and without restoring: what was written to the slave since stays. One that is
    /// held by a command stays held. False: as Boot.
    [[nodiscard]] virtual bool Resume(const NodeId node, const Instant now) noexcept
    {
        return Boot(node, now);
    }
    /// @brief Configuration of one slave alone (1F25h); a profile that has no such thing boots it. False: as Boot, or
    /// the slave is not IsConfigurable.
    [[nodiscard]] virtual bool Configure(NodeId node, Instant now) noexcept = 0;

    /// @brief Whether a start of several slaves leaves this one out: only a start of its own starts it. By itself none.
    [[nodiscard]] virtual bool IsLeftOut(const NodeId /*node*/) const noexcept
    {
        return false;
    }
    /// @brief What makes a slave the expected device under this profile.
    [[nodiscard]] virtual IdentityRule Identity() const noexcept
    {
        return IdentityRule::kCia302;
    }
    /// @brief `node` is 1 to 127, checked by the caller.
    [[nodiscard]] virtual NodeStatus Status(NodeId node) const noexcept = 0;
    /// @brief Where the profile is, as a number of its own. CiA 302-2: MasterStep (start_up/cia302/master_steps.hpp).
    /// EL6751: kEl6751... (start_up/el6751/start_up.hpp). PLC Designer: nStatus 0, 1, 2, 3 or 5.
    [[nodiscard]] virtual std::int16_t MasterState() const noexcept = 0;

  protected:
    StartUp() noexcept = default;
    ~StartUp() noexcept = default;
    StartUp(const StartUp&) = default;
    StartUp& operator=(const StartUp&) = default;
};

/// @brief Whether a slave can be configured now: it is neither STOPPED, without an SDO to be written by, nor being
/// started up, nor a safety slave that is another device than the expected one. [SRS_NMM_150]
[[nodiscard]] inline bool IsConfigurable(const StartUpParts& parts, const StartUp& start_up, const NodeId node) noexcept
{
    const NodeStatus status = start_up.Status(node);
    const bool is_other = parts.setup.IsSafetySlave(node) && status.is_other;
    return !is_other && !status.is_busy && !IsStopped(parts.table, node);
}

inline void StartUp::OnRoom(const Instant /*now*/) noexcept
{
}

inline void StartUp::OnBusBack(const Instant /*now*/) noexcept
{
}

inline void StartUp::OnStartDropped(const NodeId /*node*/, const Instant /*now*/) noexcept
{
}

} // namespace counterpoint::cia302

#endif
