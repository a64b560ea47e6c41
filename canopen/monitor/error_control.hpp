// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_MONITOR_ERROR_CONTROL_HPP
#define CANOPEN_MONITOR_ERROR_CONTROL_HPP

#include "canopen/monitor/recording.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace counterpoint::monitor
{
/// What a frame with an identifier of error control tells of its node.
struct ErrorControlFrame
{
    std::uint8_t node_id{0U};
    bool is_request{false};   ///< Of guarding; nothing else counts then.
    bool has_length{false};   ///< One byte; without it nothing else counts.
    bool is_boot_up{false};   ///< 00h.
    bool is_answer{false};    ///< To a guarding request; else a heartbeat.
    bool is_state{false};     ///< One that a node has: 0 as boot-up, 4, 5, 127.
    bool is_alternated{true}; ///< Its toggle bit is not that of the answer before it.
    std::uint8_t state{0U};   ///< Bits 0 to 6.
    std::uint8_t toggle{0U};  ///< Bit 7.

    /// Whether it tells a state; what is marked INVALID tells none. [SRS_MON_019, SRS_MON_710]
    [[nodiscard]] bool TellsState() const noexcept
    {
        return !is_request && has_length && is_state && is_alternated;
    }
};

/// Boot-up, heartbeat and guarding: what follows a guarding request is its answer; its bit 7 alternates. In a heartbeat
/// it is 0.
class ErrorControl
{
  public:
    /// @brief The next frame of 11 bits from 701h to 77Fh, a data frame or a remote one.
    [[nodiscard]] ErrorControlFrame Take(const LogFrame& frame) noexcept;

  private:
    /// Of a node that is guarded.
    struct Guarding
    {
        bool is_asked{false}; ///< Its answer is due.
        std::optional<std::uint8_t> toggle{};
    };

    std::array<Guarding, 128U> guarding_{};
};
} // namespace counterpoint::monitor

#endif // CANOPEN_MONITOR_ERROR_CONTROL_HPP
