// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_TIME_RTI_HPP
#define HAL_TMS570_TIME_RTI_HPP

#include "hal/api/clocks.hpp"
#include "hal/tms570/chip/registers.hpp"

#include <cstdint>

namespace counterpoint::tms570
{

/// RTICLK; a whole number of MHz, 1 or more.
struct RtiClock
{
    std::uint8_t mhz;
};

/// The two counters of time: counter block 0 for channel A, block 1 for channel B, each with a prescaler of its own to
/// one microsecond. Both are fed by RTICLK, which the clock comparator supervises. [SRS_TMS_020]
class Rti final : public hal::Clocks
{
  public:
    /// @brief Sets both to 0 and starts them together; read back. kFailed as well when one of them does not advance.
    /// [SRS_TMS_021]
    [[nodiscard]] Outcome Start(RtiClock clock) noexcept;
    [[nodiscard]] InstantPair Now() noexcept override;
    /// @brief Once a cycle: set up as it was. Whether the counters run the kernel finds out from the stamps.
    [[nodiscard]] Outcome Examine() const noexcept;

  private:
    std::uint32_t prescale_{0U};
};

} // namespace counterpoint::tms570

#endif
