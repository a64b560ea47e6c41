// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_NMT_HEARTBEAT_PRODUCER_HPP
#define CANOPEN_CIA301_NMT_HEARTBEAT_PRODUCER_HPP

#include "canopen/cia301/nmt/slave.hpp"

namespace counterpoint::cia301
{

/// Sends the NMT state with the period of 1017h. Call Poll at least once in 2^30 us. Not reentrant.
class HeartbeatProducer
{
  public:
    /// @brief Off at first.
    explicit HeartbeatProducer(NodeId node) noexcept;

    /// @brief Sets 1017h in ms; 0 turns the heartbeat off. The first heartbeat is due at once. [SRS_HB_001]
    void SetPeriod(std::uint16_t period_ms) noexcept;
    /// @brief 1017h in ms; 0: off.
    [[nodiscard]] std::uint16_t PeriodMs() const noexcept;
    /// @brief The heartbeat that is due, or none. [SRS_HB_001, SRS_HB_002]
    [[nodiscard]] FrameToSend Poll(NodeState state, Instant now) noexcept;

  private:
    NodeId node_;
    std::uint16_t period_ms_;
    bool is_running_; ///< One was sent; `sent_` is its instant.
    Instant sent_;
};

} // namespace counterpoint::cia301

#endif
