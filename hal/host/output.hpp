// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_OUTPUT_HPP
#define HAL_HOST_OUTPUT_HPP

#include "hal/api/output_cutoff.hpp"
#include "hal/api/output_gate.hpp"
#include "hal/api/safety_output.hpp"
#include "hal/host/virtual/bit_rate.hpp"
#include "hal/host/virtual/bus.hpp"
#include "hal/host/watchdog.hpp"

#include <cstdint>

namespace counterpoint::host
{

/// The output stage of a simulated device: the output gate, run on bus time, in series with the watchdog. Call Open at
/// least once an hour. An exception cuts the output off for good. [SRS_HAL_013, SRS_HAL_014, SRS_STS_052]
class HostOutput final : public hal::SafetyOutput, public hal::OutputCutoff
{
  public:
    /// @brief `limit` is how long one right Drive keeps the output open; usually one cycle and its tolerance.
    HostOutput(const VirtualBus& bus, HostWatchdog& watchdog, const hal::GateLimit& limit);

    [[nodiscard]] std::uint32_t Challenge() noexcept override;
    void Drive(const hal::PermitSet& permits) noexcept override;
    [[nodiscard]] hal::ProbeAnswer Probe(const hal::PermitSet& permits,
                                         std::uint32_t challenge) const noexcept override;
    void CutOff() noexcept override;
    /// @brief Slots whose outputs are open at the present instant of the bus.
    [[nodiscard]] SrdoMask Open();
    /// @brief When the open slots close if no further Drive comes; kNever if none is open.
    [[nodiscard]] BusTime ClosesAt();

  private:
    const VirtualBus& bus_;
    HostWatchdog& watchdog_;
    hal::OutputGate gate_{};
    hal::GateLimit limit_;
    BusTime driven_us_{0};
    std::uint32_t watchdog_start_{0U};
    volatile bool is_cut_off_{false}; ///< Written by the handler of a signal.
};

} // namespace counterpoint::host

#endif
