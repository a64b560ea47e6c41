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

/// Safety outputs on the pins of a GIO port: low unless three right permits of this cycle open them. What shall be high
/// is computed twice, each time with a reading of the gate and a copy of the setup of its own. Whatever differs, a pin
/// that does not follow included, cuts all pins off until the next Start. [SRS_TMS_024, SRS_TMS_025, SRS_TMS_026]
///
/// Invariant: `copy_` is the complement of `setup_`, `driven_copy_` that of `driven_`.
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
    /// @brief All pins of both ports low and inputs, whatever the setup says by now. Read back; where that fails,
    /// nERROR is low. [SRS_TMS_026]
    void CutOff() noexcept override;
    /// @brief Once a cycle, after Drive and some time of the pins later: compares the pins with what was driven, then
    /// closes what has no right Drive any more. kFailed: cut off.
    [[nodiscard]] Outcome Examine() noexcept;
    /// @brief Slots that are open now, for the application.
    [[nodiscard]] SrdoMask Open() noexcept;

  private:
    /// The setup again, each member as its complement.
    struct SetupCopy
    {
        std::uint32_t port_address;
        SrdoMask slots[gio::kPins]; // MISRA D-001
        std::uint32_t limit_us;
    };

    [[nodiscard]] bool IsSetUp() const noexcept;
    [[nodiscard]] bool DoPinsFollow() const noexcept;
    [[nodiscard]] std::uint32_t High(SrdoMask open) const noexcept;
    [[nodiscard]] std::uint32_t Low(SrdoMask closed) const noexcept;
    [[nodiscard]] std::uint32_t Used() const noexcept;
    void SetPins(Instant now) noexcept;

    static constexpr std::uint32_t kLive = 0x5A5A5A5AU;

    hal::Clocks& clocks_;
    SafetyPinsSetup setup_{};
    SetupCopy copy_{};
    hal::OutputGate gate_{};
    std::uint32_t driven_{0U}; ///< Pins that were driven high.
    std::uint32_t driven_copy_{0U};
    Shared<std::uint32_t> live_{0U};
};

} // namespace counterpoint::tms570

#endif
