// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA302_NETWORK_NODE_TABLE_HPP
#define CANOPEN_CIA302_NETWORK_NODE_TABLE_HPP

#include "canopen/cia301/nmt/frame_sink.hpp"
#include "canopen/cia302/network/nmt_command.hpp"
#include "canopen/cia302/network/setup.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// State of a slave by what was heard of it; the numbers are those that 1F82h reads.
enum class SlaveState : std::uint8_t
{
    kUnknown = 0U, ///< Nothing heard since the start or since its last reset.
    kMissing = 1U, ///< Expected and silent.
    kStopped = 4U,
    kOperational = 5U,
    kPreOperational = 127U, ///< Also after a boot-up message.
};

/// What the node table tells of a node.
enum class NodeEvent : std::uint8_t
{
    kInvalid = 0U,
    kBootUp = 1U,
    kStarted = 2U,       ///< First heartbeat, or first guarding answer: supervision runs.
    kChanged = 3U,       ///< Another state than the last one told.
    kHeartbeatLost = 4U, ///< Silence above the consumer time; supervision waits for the next sign.
    kGuardMissed = 5U,   ///< One remote frame was not answered.
    kGuardLost = 6U,     ///< As many in a row as the retry factor; the next answer starts supervision anew.
    kToggleError = 7U,   ///< An answer with the toggle bit of the one before; it does not count as an answer.
    kNeverSeen = 8U,     ///< Nothing was heard within the time of Expect.
    kUnexpected = 9U,    ///< First sign of a node that is not in the network list.
};

/// Is told what happens to nodes. It may read the table and change supervision.
class NodeListener
{
  public:
    /// @brief In the order in which it happens, from OnFrame, OnCycle and Presume.
    virtual void OnNodeEvent(NodeId node, NodeEvent event, Instant now) noexcept = 0;

  protected:
    NodeListener() noexcept = default;
    ~NodeListener() noexcept = default;
    NodeListener(const NodeListener&) = default;
    NodeListener& operator=(const NodeListener&) = default;
};

/// How a node is supervised.
enum class Watch : std::uint8_t
{
    kNone = 0U,
    kHeartbeat = 1U,
    kGuarding = 2U,
};

/// Toggle bit that the next guarding answer is to have.
enum class Toggle : std::uint8_t
{
    kAny = 0U, ///< Nothing is known of the slave's bit.
    kClear = 1U,
    kSet = 2U,
};

/// One sign may have been under way when a command made the node leave OPERATIONAL; two in a row were not.
constexpr std::uint8_t kRunsSurely = 2U;

/// Losses of a node that answers and does not toggle, before its supervision counts as failed.
constexpr std::uint8_t kMostUntoggled = 3U;

/// What is known of one node. Zero-filled at first.
struct NodeRecord
{
    SlaveState state;
    SlaveState asked;     ///< State that the last NMT command, of whomever, asked for; kUnknown after a reset.
    bool was_seen;        ///< Ever.
    bool has_booted;      ///< Its boot-up message came since the last reset of it.
    bool is_presumed;     ///< Nothing was heard since Presume: `state` is what was commanded.
    bool has_gap;         ///< Frames were lost since its last sign: Miss.
    bool is_kept_started; ///< KeepStarted, and no command, heartbeat or guarding answer since.
    std::uint8_t signs;   ///< Counts heartbeats, guarding answers and boot-up messages, modulo 256.
    std::uint8_t beats;   ///< Counts heartbeats and guarding answers, modulo 256.
    std::uint8_t runs;    ///< OPERATIONAL signs in a row since the last NMT command but a start, up to kRunsSurely.
    std::uint8_t denials; ///< Heartbeats and guarding answers in a row, since the last NMT command, of whomever, that
                          ///< say another state than it asked for, up to kRunsSurely.
    Instant last_sign;    ///< Only with `was_seen`.

    Watch watch;           ///< What supervises it.
    bool is_running;       ///< Supervision counts: silence becomes a loss.
    bool has_begun;        ///< kStarted was told.
    Instant since;         ///< Last sign, or remote frame, or since when a sign is waited for.
    std::uint32_t time_us; ///< Consumer time, or guard time.
    Arming arming;         ///< Of heartbeat supervision.
    std::uint8_t retry_factor;
    std::uint8_t missed; ///< Unanswered remote frames in a row.
    Toggle toggle;
    bool is_asked;          ///< A remote frame is out and not answered.
    bool is_toggle_wrong;   ///< The toggle error was told already.
    std::uint8_t untoggled; ///< Losses in a row of a node that answers, while its toggle bit did not change.
    bool is_expected;       ///< Expect runs.
    std::uint32_t expect_us;
    Instant expected_from;
};

/// What the node table works with: room for kNodeRoom records by node-ID, and the parts, all kept by reference.
struct NodeTableParts
{
    NodeRecord* records;
    const NetworkSetup& setup;
    cia301::FrameSink& sink; ///< Takes the remote frames.
    NodeListener& listener;
};

/// State and supervision of all nodes as the master sees them. One supervision a node: heartbeat or guarding. Call
/// OnCycle at least once in 2^30 us, and as often as times shall be exact. Not reentrant. [SRS_NMM_021, SRS_NMM_022,
/// SRS_NMM_023, SRS_NMM_024, SRS_NMM_025, SRS_NMM_026]
class NodeTable final : public NmtListener
{
  public:
    /// @brief No node is supervised at first.
    explicit NodeTable(const NodeTableParts& parts) noexcept;

    /// @brief Supervision by heartbeat from now on. `time_ms` 0: none.
    void WatchHeartbeat(NodeId node, std::uint16_t time_ms, Arming arming, Instant now) noexcept;
    /// @brief Supervision by remote frames: one each `time_ms`, the first at once. Time or factor 0: none. Where
    /// kMostUntoggled is reached, NodeRecord::untoggled begins anew.
    void WatchGuarding(NodeId node, std::uint16_t time_ms, std::uint8_t retry_factor, Instant now) noexcept;
    /// @brief No supervision from now on; what was heard stays.
    void Unwatch(NodeId node) noexcept;
    /// @brief Supervision as its setup tells: heartbeat if there is a consumer time, else guarding, else none.
    void WatchAsSetUp(NodeId node, Instant now) noexcept;
    /// @brief kNeverSeen unless a sign comes within `time_ms` (1 to 10^6).
    void Expect(NodeId node, std::uint32_t time_ms, Instant now) noexcept;
    /// @brief One remote frame; the answer shows in `signs` and `state`. False: the sink is full.
    [[nodiscard]] bool AskState(NodeId node) noexcept;
    /// @brief The node counts as missing, which other services found out.
    void SetMissing(NodeId node) noexcept;
    /// @brief Somebody started it: it counts as OPERATIONAL until it says otherwise, and kChanged is told. One that is
    /// missing stays missing.
    void Presume(NodeId node, Instant now) noexcept;
    /// @brief The start of somebody else that comes: it may be behind a reset whose boot-up message still waits, so
    /// that only a heartbeat, a guarding answer or another command ends it, and the node is presumed anew behind a
    /// boot-up message and, where it was missing, an SDO of it. [SRS_SFS_150]
    void KeepStarted(NodeId node) noexcept;

    /// @brief Frames were lost, perhaps those of this node: if its last command was a start, and its next sign says
    /// PRE-OPERATIONAL, kBootUp is told. [SRS_NMM_020]
    void Miss(NodeId node) noexcept;

    /// @brief A frame from the bus. O(1)
    void OnFrame(const CanFrame& frame, Instant now) noexcept;
    /// @brief Sends remote frames and tells who was lost. O(127)
    void OnCycle(Instant now) noexcept;
    /// @brief Called by the NMT master: a reset makes the state unknown until the boot-up message. O(127)
    void OnNmtSent(const NmtRequest& request, Instant now) noexcept override;

    /// @brief `node` is 1 to 127; other values read an empty record.
    [[nodiscard]] const NodeRecord& Record(NodeId node) const noexcept;
    /// @brief What 1F82h reads: the state heard, or the one last asked for where nothing supervises the node.
    [[nodiscard]] std::uint8_t RequestValue(NodeId node) const noexcept;
    /// @brief Whether the node says OPERATIONAL, and no sign that says so can be older than the last command to leave
    /// it.
    [[nodiscard]] bool RunsSurely(NodeId node) const noexcept;
    /// @brief Whether the node is OPERATIONAL although nobody told it otherwise last, or surely so in spite of such a
    /// command.
    [[nodiscard]] bool IsFoundRunning(const NodeId node) const noexcept
    {
        const NodeRecord& record = Record(node);
        const bool is_told = (record.asked == SlaveState::kStopped) || (record.asked == SlaveState::kPreOperational);
        return RunsSurely(node) || ((record.state == SlaveState::kOperational) && !is_told);
    }

  private:
    void Hear(NodeId node, std::uint8_t byte, Instant now) noexcept;
    void HearBootUp(NodeId node, NodeRecord& record, Toggle next, Instant now) noexcept;
    void HearAnswer(NodeId node, Instant now) noexcept;
    void HearState(NodeId node, NodeRecord& record, std::uint8_t byte, Instant now) noexcept;
    [[nodiscard]] bool TakeToggle(NodeId node, NodeRecord& record, bool is_set, Instant now) noexcept;
    void Guard(NodeId node, NodeRecord& record, Instant now) noexcept;
    void Miss(NodeId node, NodeRecord& record, Instant now) noexcept;
    void CheckHeartbeat(NodeId node, NodeRecord& record, Instant now) noexcept;
    void CheckExpected(NodeId node, NodeRecord& record, Instant now) noexcept;
    void Command(NodeRecord& record, NmtCommand command, Instant now) noexcept;
    void HearCommand(NmtCommand command, NodeId node) noexcept;
    [[nodiscard]] bool SendRemote(NodeId node) noexcept;

    NodeTableParts parts_;
};

/// @brief Whether the node was told last to leave OPERATIONAL for STOPPED or PRE-OPERATIONAL, and no sign since says
/// surely that it did not.
[[nodiscard]] inline bool HasLeft(const NodeTable& table, const NodeId node) noexcept
{
    const SlaveState asked = table.Record(node).asked;
    const bool is_told = (asked == SlaveState::kStopped) || (asked == SlaveState::kPreOperational);
    return is_told && !table.RunsSurely(node);
}

/// @brief Whether the node was started by the last command that it heard, and says all the same that it is not
/// OPERATIONAL. One sign may have been under way when the command came, two in a row were not. [SRS_NMM_521]
[[nodiscard]] inline bool DeniesStart(const NodeTable& table, const NodeId node) noexcept
{
    const NodeRecord& record = table.Record(node);
    return (record.asked == SlaveState::kOperational) && (record.denials >= kRunsSurely);
}

/// @brief Whether the node is STOPPED, and has no SDO: it says so, or was told so last and has not spoken of it yet.
[[nodiscard]] inline bool IsStopped(const NodeTable& table, const NodeId node) noexcept
{
    const NodeRecord& record = table.Record(node);
    const bool is_told = (record.asked == SlaveState::kStopped) && !table.RunsSurely(node);
    return (record.state == SlaveState::kStopped) || is_told;
}

} // namespace counterpoint::cia302

#endif
