// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_ZYNQMP_OUTPUT_OUTPUT_DRIVER_HPP
#define HAL_ZYNQMP_OUTPUT_OUTPUT_DRIVER_HPP

#include "hal/api/output_cutoff.hpp"
#include "hal/api/safety_output.hpp"
#include "hal/zynqmp/chip/registers.hpp"
#include "safety_core/contract/srdo.hpp"

#include <cstdint>

namespace counterpoint::zynqmp
{

/// The pins of a device as its board drives them: those of the controller, or others. [SRS_ZYN_062]
class OutputDriver : public hal::SafetyOutput, public hal::OutputCutoff
{
  public:
    /// @brief All outputs low, read back.
    [[nodiscard]] virtual Outcome Start() noexcept = 0;
    /// @brief Once a cycle, after Drive and some time of the pins later: compares the pins with what was driven, then
    /// closes what has no right Drive any more. kFailed: cut off.
    [[nodiscard]] virtual Outcome Examine() noexcept = 0;
    /// @brief Slots that are open now, for the application.
    [[nodiscard]] virtual SrdoMask Open() noexcept = 0;
    /// @brief A reading of the inputs, the lowest for bit 0.
    [[nodiscard]] virtual std::uint32_t Inputs() noexcept = 0;
    /// @brief The outputs in series with the gates, the lowest for bit 0.
    virtual void SetOutputs(std::uint32_t bits) noexcept = 0;

    OutputDriver(const OutputDriver&) = delete;
    OutputDriver(OutputDriver&&) = delete;
    OutputDriver& operator=(const OutputDriver&) = delete;
    OutputDriver& operator=(OutputDriver&&) = delete;

  protected:
    OutputDriver() noexcept = default;
    ~OutputDriver() noexcept = default;
};

} // namespace counterpoint::zynqmp

#endif
