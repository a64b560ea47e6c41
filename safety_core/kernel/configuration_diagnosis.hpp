// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_CONFIGURATION_DIAGNOSIS_HPP
#define SAFETY_CORE_KERNEL_CONFIGURATION_DIAGNOSIS_HPP

#include "safety_core/kernel/configuration_copies.hpp"

#include <cstdint>

namespace counterpoint
{

/// The cyclic look at the configuration: signature by signature and slot by slot of the device digest, so that all is
/// seen within the diagnostic interval. [SRS_CFG_048, SRS_CFG_050]
class ConfigurationDiagnosis
{
  public:
    /// @brief Kernel::Start made sure that the interval holds at least two cycles for each SRDO.
    void Restart(const DeviceConfig& config) noexcept
    {
        cycles_per_check_ = config.diagnostic_interval_us / (2U * config.cycle_us * config.srdo_count);
        cycles_to_check_ = cycles_per_check_;
        step_ = 0U;
    }
    /// @brief Once a cycle: whether the next step has to be done now.
    [[nodiscard]] bool TakeTurn() noexcept
    {
        --cycles_to_check_;
        if (cycles_to_check_ != 0U)
        {
            return false;
        }
        cycles_to_check_ = cycles_per_check_;
        return true;
    }
    /// @brief One step; `valid` is 13FEh. Faults enter the latch.
    void Examine(ConfigurationCopies& copies, std::uint8_t valid) noexcept;
    /// @brief From now on the cyclic digest has to be this one. The walk under way began before, and is not compared.
    void SetReference(const DeviceDigest digest) noexcept
    {
        reference_ = digest;
        is_digest_whole_ = false;
    }

  private:
    // What is used in one place alone is inline: the compiler then decides whether it needs a call of its own.
    [[nodiscard]] inline bool IsDigestSound(std::uint8_t valid) const noexcept;

    std::uint8_t step_{};    ///< Twice the slot, plus one for its digest.
    bool is_digest_whole_{}; ///< `digest_` is that of the walk through the slots that is under way.
    std::uint32_t cycles_per_check_{};
    std::uint32_t cycles_to_check_{};
    DeviceDigest reference_{}; ///< Of the last declaration, or of the last write to 1300h.
    DeviceDigest digest_{};    ///< Of the slots so far.
};

} // namespace counterpoint

#endif
