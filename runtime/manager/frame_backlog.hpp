// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_MANAGER_FRAME_BACKLOG_HPP
#define RUNTIME_MANAGER_FRAME_BACKLOG_HPP

#include "hal/host/live/bus.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::runtime
{
/// Finds frames that have waited somewhere, on a connection that tells no times of reception: after a silence more
/// frames come than a bus can carry. Taken as new, they would look like two devices with one node-ID. [SRS_MGR_004]
class FrameBacklog
{
  public:
    /// @brief Begins at `start_ns`, without a backlog.
    explicit FrameBacklog(std::uint64_t start_ns) noexcept;

    /// @brief `count` frames came since the last call. True: they belong to a backlog.
    [[nodiscard]] bool Has(std::size_t count, std::uint64_t now_ns) noexcept;

  private:
    std::uint64_t last_turn_ns_;
    std::uint64_t last_frame_ns_;
    std::uint64_t ahead_ns_{0U}; ///< How much longer the frames are than the time in which they came.
    std::uint64_t silence_end_ns_{0U};
    bool has_{false};
};

/// @brief Whether the frame is a boot-up message.
[[nodiscard]] bool IsBootUp(const host::LiveFrame& frame) noexcept;
} // namespace counterpoint::runtime

#endif // RUNTIME_MANAGER_FRAME_BACKLOG_HPP
