// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_SIMULATOR_OUTPUT_TAP_HPP
#define VERIFICATION_SIMULATOR_OUTPUT_TAP_HPP

#include "hal/api/safety_output.hpp"

namespace counterpoint::simulator
{
/// Passes everything on to the output stage of the host and remembers the permits of the last cycle.
class OutputTap final : public hal::SafetyOutput
{
  public:
    explicit OutputTap(hal::SafetyOutput& real) noexcept : real_(real)
    {
    }

    [[nodiscard]] std::uint32_t Challenge() noexcept override
    {
        return real_.Challenge();
    }
    void Drive(const hal::PermitSet& permits) noexcept override
    {
        permits_ = permits;
        real_.Drive(permits);
    }
    [[nodiscard]] hal::ProbeAnswer Probe(const hal::PermitSet& permits, std::uint32_t challenge) const noexcept override
    {
        return real_.Probe(permits, challenge);
    }
    [[nodiscard]] const hal::PermitSet& Permits() const noexcept
    {
        return permits_;
    }

  private:
    hal::SafetyOutput& real_;
    hal::PermitSet permits_{};
};
} // namespace counterpoint::simulator

#endif // VERIFICATION_SIMULATOR_OUTPUT_TAP_HPP
