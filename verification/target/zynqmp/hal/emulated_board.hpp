// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TARGET_ZYNQMP_HAL_EMULATED_BOARD_HPP
#define VERIFICATION_TARGET_ZYNQMP_HAL_EMULATED_BOARD_HPP

#include "hal/api/output_gate.hpp"
#include "hal/api/watchdog_timer.hpp"
#include "hal/zynqmp/board.hpp"

#include <cstdint>

/// What the emulator's machine does not have: pins and a watchdog. The rules are those of hal/api, the time is that of
/// the emulated counters; there is no register.
namespace counterpoint::target
{

class EmulatedOutput final : public zynqmp::OutputDriver
{
  public:
    explicit EmulatedOutput(hal::Clocks& clocks) noexcept : clocks_(clocks)
    {
    }
    [[nodiscard]] zynqmp::Outcome Start() noexcept override;
    [[nodiscard]] zynqmp::Outcome Examine() noexcept override;
    [[nodiscard]] SrdoMask Open() noexcept override;
    [[nodiscard]] std::uint32_t Inputs() noexcept override;
    void SetOutputs(std::uint32_t bits) noexcept override;
    void CutOff() noexcept override;
    [[nodiscard]] std::uint32_t Challenge() noexcept override;
    void Drive(const hal::PermitSet& permits) noexcept override;

    std::uint32_t inputs{0U};
    std::uint32_t outputs{0U}; ///< What would be at the pins in series with the gates.

  private:
    hal::Clocks& clocks_;
    hal::OutputGate gate_{};
    bool is_live_{false};
};

class EmulatedWatchdog final : public zynqmp::WatchdogDriver
{
  public:
    explicit EmulatedWatchdog(hal::Clocks& clocks) noexcept : clocks_(clocks)
    {
    }
    [[nodiscard]] zynqmp::Outcome Start() noexcept override;
    [[nodiscard]] zynqmp::Outcome Examine() noexcept override;
    [[nodiscard]] hal::WatchdogQuestion Question() noexcept override;
    void Answer(const hal::WatchdogAnswer& answer) noexcept override;
    [[nodiscard]] bool IsAlive() const noexcept
    {
        return timer_.IsAlive();
    }

  private:
    hal::Clocks& clocks_;
    hal::WatchdogTimer timer_{};
};

} // namespace counterpoint::target

#endif
