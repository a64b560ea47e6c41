// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_CLOCK_SUPERVISOR_HPP
#define SAFETY_CORE_KERNEL_CLOCK_SUPERVISOR_HPP

#include "safety_core/contract/configuration.hpp"
#include "safety_core/contract/device_fault.hpp"
#include "safety_core/contract/time.hpp"

#include <cstdint>

namespace counterpoint
{

/// Supervises the progress of the two counters against each other, the distance of the cycles, and the stamps of the
/// frames between them. [SRS_CLK_001, SRS_CLK_002, SRS_CLK_210, SRS_CLK_211, SRS_CLK_212,
/// SRS_KRN_008]
///
/// t      |--- window ---|--- window ---|      A drift that begins in a window may be too little in what is left of it:
/// drift       |---------------------->|       it is found in the next one. Two windows, each a late cycle longer than
///              clock interval + late cycle    it has to be, are the clock interval and one late cycle.
class ClockSupervisor
{
  public:
    /// @brief Shortest clock interval, in us: each of the two windows in it has a cycle of its own, however late.
    [[nodiscard]] static std::uint32_t LeastIntervalUs(const DeviceConfig& config) noexcept;
    /// @brief Times of this device, which Kernel::Start has checked; the references are those of the first OnCycle.
    void Restart(const DeviceConfig& config) noexcept;
    /// @brief Stamps of the next frame in bus order.
    ///
    /// t [cycles]  n            n+1        the stamps of the frames between two cycles lie between the cycles' instants
    /// instants    |--- f1 f2 ---|
    void OnFrame(const InstantPair& stamp) noexcept
    {
        disorder_ |= (stamp.a.us - newest_.a.us) | (stamp.b.us - newest_.b.us);
        newest_ = stamp;
    }
    /// @brief Instants of this cycle; the first device fault found since the last call. The first call after Restart
    /// only sets the references.
    [[nodiscard]] DeviceFault OnCycle(const InstantPair& now) noexcept;

  private:
    InstantPair reference_{{0U}, {0U}};
    InstantPair previous_{{0U}, {0U}};
    InstantPair newest_{{0U}, {0U}}; ///< Latest stamp or cycle instant seen.
    std::uint32_t tolerance_us_{0U}; ///< Within a window.
    std::uint32_t window_us_{0U};    ///< The reference moves on with the first cycle behind it.
    std::uint32_t late_us_{0U};
    /// Steps from one stamp to the next since the last cycle, their bits together. Instants are modular: bit 31 stands
    /// for a step backwards.
    std::uint32_t disorder_{0U};
    bool started_{false};
};

} // namespace counterpoint

#endif
