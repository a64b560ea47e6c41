// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_NMT_NODE_GUARDING_HPP
#define CANOPEN_CIA301_NMT_NODE_GUARDING_HPP

#include "canopen/cia301/nmt/slave.hpp"

namespace counterpoint::cia301
{

/// What life guarding found: the master guards no more, or guards again.
enum class GuardEvent : std::uint8_t
{
    kNone = 0U,
    kLost = 1U,
    kResumed = 2U,
};

/// What a remote frame leads to: the answer to be sent, and an event.
struct GuardReply
{
    FrameToSend reply;
    GuardEvent event;
};

/// Time, NMT state and heartbeat time of the own node when a frame comes, or when it looks.
struct GuardMoment
{
    NodeState state;
    std::uint16_t heartbeat_ms; ///< 1017h; guarding rests if it is not 0.
    Instant now;
};

/// Node guarding and life guarding as a slave sees them: both rest while the node sends heartbeats. Poll at least once
/// in 2^30 us. Not reentrant.
class NodeGuarding
{
  public:
    /// @brief Life guarding is off at first.
    explicit NodeGuarding(NodeId node) noexcept;

    /// @brief Sets 100Ch (ms) and 100Dh; life guarding waits for the next remote frame. Either of them 0: off.
    /// [SRS_GRD_002]
    void SetLifeTime(std::uint16_t guard_time_ms, std::uint8_t factor) noexcept;
    /// @brief A reset: the toggle is 0, life guarding waits. [SRS_GRD_001]
    void Reset() noexcept;
    /// @brief A frame from the bus. [SRS_GRD_001, SRS_GRD_002]
    [[nodiscard]] GuardReply OnFrame(const CanFrame& frame, const GuardMoment& moment) noexcept;
    /// @brief Whether the master was lost just now. With a heartbeat period life guarding ends, and waits for the first
    /// remote frame without one. [SRS_GRD_002, SRS_GRD_010]
    [[nodiscard]] GuardEvent Poll(const GuardMoment& moment) noexcept;
    /// @brief Whether the master is lost: false again where it guards again, and where nobody is guarded any more.
    /// [SRS_GRD_011]
    [[nodiscard]] bool IsLost() const noexcept
    {
        return is_lost_;
    }

  private:
    NodeId node_;
    std::uint64_t life_us_; ///< 0: off.
    std::uint64_t silence_us_;
    Instant last_; ///< Up to where `silence_us_` counts.
    std::uint8_t toggle_;
    bool is_guarded_;
    bool is_lost_;
};

} // namespace counterpoint::cia301

#endif
