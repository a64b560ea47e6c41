// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_PORT_FIFO_PINS_HPP
#define EXAMPLES_PORT_FIFO_PINS_HPP

#include "clocks.hpp"
#include "hal/api/output_cutoff.hpp"
#include "hal/api/output_gate.hpp"
#include "hal/api/safety_output.hpp"

#include <cstdint>

namespace port_fifo
{

/// Pin n is the output of slot n, 8 pins. The watchdog makes them inputs, and a pull-down outside makes them low.
class Pins final : public counterpoint::hal::SafetyOutput, public counterpoint::hal::OutputCutoff
{
  public:
    /// @brief `clocks` outlives this.
    Pins(Clocks& clocks, counterpoint::hal::GateLimit limit) noexcept;

    /// @brief Power-on: low, and outputs.
    void Start() noexcept;
    [[nodiscard]] std::uint32_t Challenge() noexcept override;
    void Drive(const counterpoint::hal::PermitSet& permits) noexcept override;
    void CutOff() noexcept override;
    /// @brief Once a cycle: closes what has no right Drive any more, then compares the pins with what was driven. A pin
    /// that does not follow cuts off.
    void Examine() noexcept;
    /// @brief The pins as they are.
    [[nodiscard]] static std::uint32_t ReadBack() noexcept;

  private:
    void Set() noexcept;

    static constexpr std::uint32_t kLive = 0x5A5A5A5AU;

    Clocks& clocks_;
    counterpoint::hal::GateLimit limit_;
    counterpoint::hal::OutputGate gate_{};
    std::uint32_t live_{0U};
};

} // namespace port_fifo

#endif
