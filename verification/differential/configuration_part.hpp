// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_DIFFERENTIAL_CONFIGURATION_PART_HPP
#define VERIFICATION_DIFFERENTIAL_CONFIGURATION_PART_HPP

#include "verification/differential/comparison.hpp"
#include "verification/differential/cycle_part.hpp"
#include "verification/differential/scene.hpp"

#include <cstdint>

namespace counterpoint::differential
{

/// The guard's part: what it stores, validates and rechecks.
class ConfigurationPart
{
  public:
    ConfigurationPart(Scene& scene, Comparison& comparison, CyclePart& cycle) noexcept
        : scene_{scene}, compare_{comparison}, cycle_{cycle}
    {
    }
    void Configure() noexcept;
    void Reconfigure() noexcept;
    void Recheck(SlotIndex slot) noexcept;
    void Digest() noexcept;

  private:
    void StoreSlot(SlotIndex slot) noexcept;
    void Store(SlotIndex slot, ConfigField field, std::uint8_t sub, std::uint32_t value) noexcept;
    void Load() noexcept;
    void ValidateSlot(SlotIndex slot) noexcept;
    [[nodiscard]] CheckResult Validate(SlotIndex slot) noexcept;
    void RegisterFields(SlotIndex slot) noexcept;
    void Register(SlotIndex slot, std::uint32_t normal_at, std::uint32_t inverse_at) noexcept;

    Scene& scene_;
    Comparison& compare_;
    CyclePart& cycle_;
};

} // namespace counterpoint::differential

#endif
