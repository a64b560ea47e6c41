// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA302_NETWORK_NMT_MASTER_HPP
#define CANOPEN_CIA302_NETWORK_NMT_MASTER_HPP

#include "canopen/cia301/nmt/frame_sink.hpp"
#include "canopen/cia302/network/nmt_command.hpp"
#include "canopen/cia302/network/setup.hpp"
#include "canopen/cia302/network/start_gate.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// Whether a command was taken, or why not.
enum class NmtAnswer : std::uint8_t
{
    kInvalid = 0U,
    kTaken = 0x69U,
    kQueueFull = 1U,
    kNotActive = 2U,   ///< This device is not the active master.
    kNoBroadcast = 3U, ///< A start of all nodes while a safety slave is assigned.
    kNotVerified = 4U, ///< A start of a safety slave whose configuration was not verified since its boot-up.
    kWrong = 5U,       ///< No such command or node.
    kOtherDevice = 6U, ///< A start of a slave whose start-up did not find the expected device.
    kPartly = 7U,      ///< A command for all: some nodes are in a state that does not allow it, the others obey.
};

/// Room for commands that wait, kept by reference. 256 hold one command for each node and the answer to it.
struct NmtQueueRoom
{
    NmtRequest* requests;
    std::uint16_t count;
};

/// What an NMT master works with; all kept by reference.
struct NmtMasterParts
{
    const NetworkSetup& setup;
    NmtQueueRoom room;
    cia301::FrameSink& sink;
    NmtListener& table;    ///< The node table.
    NmtListener& listener; ///< Of the application: obeys commands for the own node and for all.
    const StartGate& gate; ///< Tells who may be started.
};

/// Sends the NMT commands of the device; no other part sends one. It sends them in order, but a stop of one node before
/// what waits for others, and that of a refused safety slave before all, with 102Ah between two of them. The start of a
/// safety slave is checked when it is asked for, and again when it leaves. Not reentrant.
class NmtMaster
{
  public:
    /// @brief Inactive, with an empty queue.
    explicit NmtMaster(const NmtMasterParts& parts) noexcept;

    /// @brief Tells whether this device is the active master. When it is no longer, the queue is emptied. [SRS_NMM_002]
    void SetActive(bool is_active) noexcept;
    /// @brief Whether this device is the active master.
    [[nodiscard]] bool IsActive() const noexcept
    {
        return is_active_;
    }

    /// @brief Puts a command into the queue, and sends it at once if the inhibit time is over and nothing waits. One
    /// but a start that is the last one waiting for its node is taken and not put there a second time. What is refused,
    /// and why: see NmtAnswer. O(queue) [SRS_NMM_001, SRS_NMM_002, SRS_NMM_003, SRS_NMM_004, SRS_NMM_005,
    /// SRS_NMM_213, SRS_NMM_214, SRS_NMM_215,
    /// SRS_NMM_120]
    [[nodiscard]] NmtAnswer Request(NmtCommand command, NodeId node, Instant now) noexcept;
    /// @brief Stops a safety slave that runs and is refused: before all that waits but other such stops. A start
    /// and PRE-OPERATIONAL of it that wait are superseded and do not leave, but what follows a reset of it does. If the
    /// node is verified before it leaves, it is dropped. Refused as Request. O(queue) [SRS_NMM_770, SRS_NMM_771]
    [[nodiscard]] NmtAnswer Halt(NodeId node, Instant now) noexcept;
    /// @brief The command singly to each node of the network list but `except` (0: nobody) and the own
    /// node: kTaken, or the first refusal, while the others are asked for. O(127)
    [[nodiscard]] NmtAnswer RequestEach(NmtCommand command, NodeId except, Instant now) noexcept;
    /// @brief The start-up of the node begins again: starts of it that wait are dropped. O(queue)
    void DropStarts(NodeId node) noexcept;
    /// @brief Whether a start of this node waits. O(queue)
    [[nodiscard]] bool HasStart(NodeId node) const noexcept;
    /// @brief Whether a start waits for this node or for all. O(queue)
    [[nodiscard]] bool IsStarting(const NodeId node) const noexcept
    {
        return HasStart(node) || HasStart(kAllNodes);
    }
    /// @brief Whether a command waits for this node or for all that takes it out of OPERATIONAL. O(queue)
    [[nodiscard]] bool IsLeaving(NodeId node) const noexcept;
    /// @brief Sends what is due. Call once a cycle. O(commands that leave) [SRS_NMM_001]
    void OnCycle(Instant now) noexcept;

    /// @brief The device ends: all that waits is sent now, whatever the inhibit time. What the sink does not take waits
    /// on. O(queue) [SRS_NMM_520]
    void Finish(Instant now) noexcept;

    /// @brief How many commands wait.
    [[nodiscard]] std::uint16_t Waiting() const noexcept
    {
        return waiting_;
    }
    /// @brief One of those that wait, from 0 on in the order in which they are to leave; kInvalid: one that was
    /// given up.
    [[nodiscard]] NmtRequest WaitingAt(const std::uint16_t place) const noexcept
    {
        return At(place);
    }
    /// @brief How many commands were taken and not sent: starts, because the gate closed or the node began anew, and
    /// what the stop of a refused slave supersedes, or its verification.
    [[nodiscard]] std::uint32_t Dropped() const noexcept
    {
        return dropped_;
    }

  private:
    [[nodiscard]] NmtAnswer Check(const NmtRequest& request) const noexcept;
    [[nodiscard]] NmtRequest& At(std::uint16_t place) const noexcept;
    [[nodiscard]] bool IsWaiting(const NmtRequest& request) const noexcept;
    void Put(const NmtRequest& request) noexcept;
    void PutFirst(const NmtRequest& request) noexcept;
    void Supersede(NodeId node) noexcept;
    void SendUnlessSending(Instant now) noexcept;
    [[nodiscard]] bool IsHalting(NodeId node) const noexcept;
    [[nodiscard]] bool IsStale(const NmtRequest& request, Instant now) const noexcept;
    [[nodiscard]] bool Emit(const NmtRequest& request, Instant now) noexcept;

    NmtMasterParts parts_;
    std::uint16_t first_;
    std::uint16_t waiting_;
    std::uint32_t dropped_;
    Instant last_; ///< When a frame left, only with `has_sent_`.
    bool has_sent_;
    bool is_sending_; ///< A listener that asks for more is served by the running OnCycle.
    bool is_active_;
    bool is_hurried_; ///< Finish runs.
};

} // namespace counterpoint::cia302

#endif
