// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_MANAGER_FRAME_BACKLOG_HPP
#define RUNTIME_MANAGER_FRAME_BACKLOG_HPP

#include "hal/host/live/bus.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace counterpoint::runtime
{
/// Finds frames that have waited somewhere, on a connection that tells no times of reception: after a silence more
/// frames come than a bus can carry, or more heartbeats of one node than it can send. Taken as new, they would look
/// like two devices with one node-ID. [SRS_MGR_140]
class FrameBacklog
{
  public:
    /// @brief Begins at `start_ns`, without a backlog.
    explicit FrameBacklog(std::uint64_t start_ns) noexcept;

    /// @brief `frames` came since the last call. True: they belong to a backlog.
    [[nodiscard]] bool Has(const std::vector<host::LiveFrame>& frames, std::uint64_t now_ns) noexcept;

  private:
    std::uint64_t last_turn_ns_;
    std::uint64_t last_frame_ns_;
    /// How much longer the frames take than the time in which they came: at place 0 all, else the heartbeats of a node.
    std::array<std::uint64_t, 128U> ahead_ns_{};
    std::uint64_t silence_end_ns_{0U};
    bool has_{false};
};

/// @brief Whether the frame is a boot-up message.
[[nodiscard]] bool IsBootUp(const host::LiveFrame& frame) noexcept;
} // namespace counterpoint::runtime

#endif // RUNTIME_MANAGER_FRAME_BACKLOG_HPP
