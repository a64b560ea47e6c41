// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_ZYNQMP_OUTPUT_SAFETY_PINS_HPP
#define HAL_ZYNQMP_OUTPUT_SAFETY_PINS_HPP

#include "hal/api/clocks.hpp"
#include "hal/api/output_gate.hpp"
#include "hal/zynqmp/output/gpio_registers.hpp"
#include "hal/zynqmp/output/output_driver.hpp"

#include <cstdint>

namespace counterpoint::zynqmp
{

/// Which pins a device has, all in the lower halves of banks of the controller's own pins.
struct SafetyPinsSetup
{
    std::uint32_t gate_bank;
    SrdoMask slots[gpio::kPins]; ///< By pin of that bank: slots that must all be open; 0: no gate. // MISRA D-001
    std::uint32_t other_bank;    ///< Another one than `gate_bank`.
    std::uint32_t outputs;       ///< Pins of `other_bank`, neighbours, that are outputs in series with the gates.
    hal::GateLimit limit;        ///< Usually one cycle and its tolerance.
};

/// Safety outputs on pins: low unless three right permits of this cycle open them. What shall be high is computed
/// twice, each time with a reading of the gate and a copy of the setup of its own. Whatever differs, a pin that does
/// not follow included, cuts all pins off until the next Start. [SRS_ZYN_062]
///
/// Invariant: `copy_` is the complement of `setup_`, `driven_copy_` that of `driven_`.
class SafetyPins final : public OutputDriver
{
  public:
    /// @brief `clocks` and `setup` outlive this; counter A is the time of the gate.
    SafetyPins(hal::Clocks& clocks, const SafetyPinsSetup& setup) noexcept;

    [[nodiscard]] Outcome Start() noexcept override;
    [[nodiscard]] std::uint32_t Challenge() noexcept override;
    void Drive(const hal::PermitSet& permits) noexcept override;
    [[nodiscard]] hal::ProbeAnswer Probe(const hal::PermitSet& permits,
                                         std::uint32_t challenge) const noexcept override;
    void CutOff() noexcept override;
    [[nodiscard]] Outcome Examine() noexcept override;
    [[nodiscard]] SrdoMask Open() noexcept override;
    [[nodiscard]] std::uint32_t Inputs() noexcept override;
    void SetOutputs(std::uint32_t bits) noexcept override;

  private:
    [[nodiscard]] bool IsSetUp() const noexcept;
    [[nodiscard]] bool DoPinsFollow() const noexcept;
    [[nodiscard]] std::uint32_t High(SrdoMask open) const noexcept;
    [[nodiscard]] std::uint32_t Low(SrdoMask closed) const noexcept;
    [[nodiscard]] std::uint32_t Used() const noexcept;
    void SetPins(Instant now) noexcept;

    static constexpr std::uint32_t kLive = 0x5A5A5A5AU;

    hal::Clocks& clocks_;
    SafetyPinsSetup setup_;
    SafetyPinsSetup copy_{};
    hal::OutputGate gate_{};
    std::uint32_t driven_{0U}; ///< Pins that were driven high.
    std::uint32_t driven_copy_{0U};
    std::uint32_t live_{0U};
};

} // namespace counterpoint::zynqmp

#endif
