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

/// The final output of a device: opens the outputs of a slot only by three right permits a cycle.
/// hal/api/output_gate.hpp has the decision; a port adds the pins. [SRS-HAL-003, SRS-HAL-004]
class SafetyOutput
{
  public:
    /// @brief A new challenge for this cycle; the one before is void. Never 0, never the same twice in a row.
    [[nodiscard]] virtual std::uint32_t Challenge() noexcept = 0;
    /// @brief The permits that answer the last challenge. Anything wrong closes all outputs at once.
    virtual void Drive(const PermitSet& permits) noexcept = 0;

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
