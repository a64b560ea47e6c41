// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_MANAGER_FRAME_BACKLOG_HPP
#define RUNTIME_MANAGER_FRAME_BACKLOG_HPP

#include "hal/host/live/bus.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::runtime
{
/// Of a connection that tells no times of reception: more frames than a bus carries, after a silence. They have waited
/// somewhere; as of now they would look like two devices. [SRS_MGR_004]
class FrameBacklog
{
  public:
    explicit FrameBacklog(std::uint64_t start_ns) noexcept;

    /// @brief `count` frames came since the last call.
    [[nodiscard]] bool Has(std::size_t count, std::uint64_t now_ns) noexcept;

  private:
    std::uint64_t last_turn_ns_;
    std::uint64_t last_frame_ns_;
    std::uint64_t ahead_ns_{0U}; ///< How much longer the frames are than the time in which they came.
    std::uint64_t silence_end_ns_{0U};
    bool has_{false};
};

/// @brief Of some node; it says the same whenever it came.
[[nodiscard]] bool IsBootUp(const host::LiveFrame& frame) noexcept;
} // namespace counterpoint::runtime

#endif // RUNTIME_MANAGER_FRAME_BACKLOG_HPP
