// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_LIVE_HARDWARE_CLOCK_HPP
#define HAL_HOST_LIVE_HARDWARE_CLOCK_HPP

#include <cstdint>

namespace counterpoint::host
{

/// Maps the stamps of a controller's own clock to CLOCK_MONOTONIC. A software stamp is never too early and sometimes
/// too late, so the least distance of the two stamps is the distance of the clocks. It may grow by 200 ppm, because
/// crystals differ. [SRS_LIVE_057]
class HardwareClock
{
  public:
    /// @brief When a frame came, in CLOCK_MONOTONIC; both stamps are of this frame. Never after `software_ns`.
    [[nodiscard]] std::uint64_t Map(std::uint64_t hardware_ns, std::uint64_t software_ns) noexcept;

  private:
    std::int64_t distance_ns_{0}; ///< Software less hardware.
    std::uint64_t newest_ns_{0U}; ///< Hardware stamp that the distance is of.
    bool is_known_{false};
};

} // namespace counterpoint::host

#endif
