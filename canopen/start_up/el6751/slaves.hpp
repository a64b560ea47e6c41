// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_EL6751_SLAVES_HPP
#define CANOPEN_START_UP_EL6751_SLAVES_HPP

#include "canopen/cia302/network/safety_reader.hpp"
#include "canopen/start_up/el6751/pdos.hpp"
#include "canopen/start_up/el6751/rows.hpp"
#include "canopen/start_up/el6751/states.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// Values of NodeState, which the status of a slave has as `code`.
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

/// One slave: the phase of its start-up, and what is known besides. Zero-filled at first.
struct El6751Node
{
    El6751Phase phase; ///< Is changed by Next alone.
    El6751Place place;
    NodeStatus status;
    std::int16_t cause;         ///< NodeState of the last error.
    std::int16_t control_fault; ///< 1, 14 or 12 until the next right sign of life; 0: none.
    std::int16_t held_code;     ///< NodeState while the phase is kHeld or kDeactivated.
    std::uint8_t signs;         ///< NodeRecord::signs when the phase, the fault or the wait began.
    /// NodeRecord::beats when the control fault began: an answer that does not toggle does not end it.
    std::uint8_t beats;
    bool has_answered; ///< An SDO of this start-up was answered.
    bool is_transferring;
    bool is_requested;    ///< NMT start was handed over.
    bool is_start_wanted; ///< Its start was ordered, whatever the automatic start says.
    bool is_held_by_hand;
    bool was_started;     ///< An NMT start of its own was sent since Begin.
    bool was_operational; ///< It said OPERATIONAL since its start.
    bool is_settled;      ///< 1 s has passed since its start.
    bool is_wait_over;    ///< 10 s have passed since its start.
    SafetyReading reading;
    bool has_restarted; ///< It restarted while it was deactivated.
    bool is_cut;        ///< It was held by hand while its SDOs ran.
    Instant started;
    std::uint8_t buffer[8];
};

/// What the profile works with; all kept by reference. `nodes` has kNodeRoom elements.
struct El6751Parts
{
    StartUpParts common;
    El6751Node* nodes;
    El6751PdoRoom pdos;
    El6751Times times;
};

/// The slaves of the profile: what is known of each, and the only function that changes NodeState and step. Node-IDs
/// are 1 to 127, checked by the caller.
class El6751Slaves
{
  public:
    explicit El6751Slaves(const El6751Parts& parts) noexcept : parts_(parts)
    {
    }

    /// @brief What the profile works with.
    [[nodiscard]] const StartUpParts& Parts() const noexcept
    {
        return parts_.common;
    }
    /// @brief Record of a slave.
    [[nodiscard]] El6751Node& Of(const NodeId node) const noexcept
    {
        return parts_.nodes[node.value & kLastNode];
    }
    /// @brief What the profile is configured to do with the slave.
    [[nodiscard]] const El6751Slave& SetupOf(const NodeId node) const noexcept
    {
        return El6751SlaveOf(parts_.common.setup, node);
    }
    /// @brief Whether it is a safety slave.
    [[nodiscard]] bool IsSafety(const NodeId node) const noexcept
    {
        return parts_.common.setup.IsSafetySlave(node);
    }
    /// @brief Whether its start-up or its stop is under way.
    [[nodiscard]] bool IsBusy(const NodeId node) const noexcept
    {
        const El6751Phase phase = Of(node).phase;
        return (phase == El6751Phase::kResetting) || (phase == El6751Phase::kRows) || (phase == El6751Phase::kVerify) ||
               (phase == El6751Phase::kStarting) || IsStopping(phase);
    }
    /// @brief For El6751Node::signs behind a start-up: what the slave said meanwhile counts, or a start of somebody
    /// else, of which a slave without error control gives no other sign.
    [[nodiscard]] std::uint8_t SignsBefore(const NodeId node) const noexcept
    {
        return static_cast<std::uint8_t>(parts_.common.table.Record(node).signs - 1U);
    }
    /// @brief Sets NodeState and step; the listener is told if one of them has changed.
    void Tell(const NodeId node, const std::int16_t code, const StartUpStep step, const Instant now) noexcept
    {
        NodeStatus& status = Of(node).status;
        const bool has_changed = (status.code != code) || (status.step != step);
        status.code = code;
        status.step = step;
        if (has_changed)
        {
            parts_.common.listener.OnNodeStatus(node, now);
        }
    }

  private:
    El6751Parts parts_;
};

} // namespace counterpoint::cia302

#endif
