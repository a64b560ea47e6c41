// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_API_SAFETY_OUTPUT_HPP
#define HAL_API_SAFETY_OUTPUT_HPP

#include "safety_core/contract/channel.hpp"

#include <cstdint>

namespace counterpoint::hal
{

/// One permit of each party for one cycle.
struct PermitSet
{
    Permit a;
    Permit b;
    Permit kernel;
};

/// What the gate thinks of a permit set that it was only shown. [SRS_STS_031]
enum class ProbeAnswer : std::uint8_t
{
    kInvalid = 0U,
    kAccepted = 0x69U, ///< Drive would open by it, had the gate issued this challenge.
    kRefused = 1U,
    kAbsent = 2U, ///< This output cannot be probed.
};

/// The final output of a device: opens the outputs of a slot only by three right permits a cycle.
/// hal/api/output_gate.hpp has the decision; a port adds the pins. [SRS_HAL_003, SRS_HAL_004]
class SafetyOutput
{
  public:
    /// @brief A new challenge for this cycle; the one before is void. Never the same twice in a row; 0 says that open
    /// outputs were interrupted, which stay closed until no permits at all arm them. [SRS_HAL_301]
    [[nodiscard]] virtual std::uint32_t Challenge() noexcept = 0;
    /// @brief The permits that answer the last challenge. Anything wrong closes all outputs at once. No permits at all,
    /// where no challenge is outstanding, arm them. [SRS_HAL_302]
    virtual void Drive(const PermitSet& permits) noexcept = 0;
    /// @brief Judges permits as Drive does, against `challenge`, and does nothing. [SRS_STS_031]
    [[nodiscard]] virtual ProbeAnswer Probe(const PermitSet& /*permits*/, std::uint32_t /*challenge*/) const noexcept
    {
        return ProbeAnswer::kAbsent;
    }

    SafetyOutput(const SafetyOutput&) = delete;
    SafetyOutput(SafetyOutput&&) = delete;
    SafetyOutput& operator=(const SafetyOutput&) = delete;
    SafetyOutput& operator=(SafetyOutput&&) = delete;

  protected:
    SafetyOutput() noexcept = default;
    ~SafetyOutput() noexcept = default;
};

} // namespace counterpoint::hal

#endif
