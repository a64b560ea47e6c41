// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_OUTPUT_SAFETY_PINS_HPP
#define HAL_TMS570_OUTPUT_SAFETY_PINS_HPP

#include "hal/api/clocks.hpp"
#include "hal/api/output_cutoff.hpp"
#include "hal/api/output_gate.hpp"
#include "hal/api/safety_output.hpp"
#include "hal/tms570/chip/registers.hpp"
#include "hal/tms570/chip/shared.hpp"
#include "hal/tms570/output/gio_registers.hpp"

#include <cstdint>

namespace counterpoint::tms570
{

/// Slots whose outputs must all be open for this pin to be high; 0 for a pin that is not a safety output.
struct SafetyPin
{
    SrdoMask slots;
};

/// How the safety outputs are set up.
struct SafetyPinsSetup
{
    RegisterBase port;          ///< gio::kPortA or gio::kPortB
    SafetyPin pins[gio::kPins]; ///< By bit of the port. // MISRA D-001
    hal::GateLimit limit;       ///< Usually one cycle and its tolerance.
};

/// Safety outputs on the pins of a GIO port: low unless three right permits of this cycle open them. A pin that does
/// not follow cuts all of them off until the next Start. [SRS_TMS_024, SRS_TMS_025]
class SafetyPins final : public hal::SafetyOutput, public hal::OutputCutoff
{
  public:
    /// @brief `clocks` outlives this; its counter A is the time of the gate.
    explicit SafetyPins(hal::Clocks& clocks) noexcept;

    /// @brief All pins of the setup low and outputs, read back.
    [[nodiscard]] Outcome Start(const SafetyPinsSetup& setup) noexcept;
    [[nodiscard]] std::uint32_t Challenge() noexcept override;
    void Drive(const hal::PermitSet& permits) noexcept override;
    [[nodiscard]] hal::ProbeAnswer Probe(const hal::PermitSet& permits,
                                         std::uint32_t challenge) const noexcept override;
    void CutOff() noexcept override;
    /// @brief Once a cycle, after Drive and some time of the pins later: closes what has no right Drive any more and
    /// compares the pins with what was driven. kFailed: cut off.
    [[nodiscard]] Outcome Examine() noexcept;
    /// @brief Slots that are open now, for the application.
    [[nodiscard]] SrdoMask Open() noexcept;

  private:
    void SetPins(SrdoMask open) noexcept;

    static constexpr std::uint32_t kLive = 0x5A5A5A5AU;

    hal::Clocks& clocks_;
    SafetyPinsSetup setup_{};
    hal::OutputGate gate_{};
    std::uint32_t used_{0U};   ///< Pins that are safety outputs.
    std::uint32_t driven_{0U}; ///< Pins that were driven high.
    Shared<std::uint32_t> live_{0U};
};

} // namespace counterpoint::tms570

#endif
