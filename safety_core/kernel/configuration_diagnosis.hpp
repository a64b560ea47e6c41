// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_CONFIGURATION_DIAGNOSIS_HPP
#define SAFETY_CORE_KERNEL_CONFIGURATION_DIAGNOSIS_HPP

#include "safety_core/kernel/configuration_copies.hpp"

#include <cstdint>

namespace counterpoint
{

/// The cyclic look at the configuration: signature by signature and slot by slot of the device digest, so that all is
/// seen within the diagnostic interval. Each step begins by time, in the first cycle in its share of the interval: late
/// cycles do not add up, and from a step to the same one of the next walk it is the interval and one cycle at the most.
/// [SRS_CFG_048, SRS_CFG_050, SRS_LIM_002, SRS_LIM_213]
class ConfigurationDiagnosis
{
  public:
    /// @brief Kernel::Start made sure that no share is shorter than a cycle as late as allowed.
    void Restart(const DeviceConfig& config) noexcept
    {
        share_us_ = config.diagnostic_interval_us / (2U * config.srdo_count);
        is_timed_ = false;
        step_ = 0U;
    }
    /// @brief Once a cycle: whether the next step has to be done now. The time counts from the first call on.
    [[nodiscard]] bool TakeTurn(const Instant now) noexcept
    {
        if (!is_timed_)
        {
            is_timed_ = true;
            begun_ = now;
        }
        if ((now.us - begun_.us) < share_us_)
        {
            return false;
        }
        begun_.us += share_us_;
        return true;
    }
    /// @brief One step; `valid` is 13FEh. Faults enter the latch. The slot whose signature it checked, or
    /// kNoSlot.
    [[nodiscard]] SlotIndex Examine(ConfigurationCopies& copies, std::uint8_t valid) noexcept;
    /// @brief From now on the cyclic digest has to be this one. The walk under way began before, and is not compared.
    void SetReference(const DeviceDigest digest) noexcept
    {
        reference_ = digest;
        is_digest_whole_ = false;
    }

  private:
    // What is used in one place alone is inline: the compiler then decides whether it needs a call of its own.
    [[nodiscard]] inline bool IsDigestSound(std::uint8_t valid) const noexcept;

    std::uint8_t step_{};      ///< Twice the slot, plus one for its digest.
    bool is_digest_whole_{};   ///< `digest_` is that of the walk through the slots that is under way.
    bool is_timed_{};          ///< `begun_` is set.
    std::uint32_t share_us_{}; ///< From the begin of one share to that of the next.
    Instant begun_{};          ///< Begin of the share that is under way.
    DeviceDigest reference_{}; ///< Of the last declaration, or of the last write to 1300h.
    DeviceDigest digest_{};    ///< Of the slots so far.
};

} // namespace counterpoint

#endif
