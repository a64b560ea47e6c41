// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/configuration_diagnosis.hpp"
namespace counterpoint
{
namespace
{

// Only what was declared can be otherwise than declared.
bool IsSlotSound(ConfigurationCopies& copies, const SlotIndex slot, const std::uint8_t valid) noexcept
{
    return (valid != kConfigurationValidValue) ||
           (copies.Check(slot, CheckDepth::kRecheck).fault == ConfigFault::kNone);
}

} // namespace

bool ConfigurationDiagnosis::IsDigestSound(const std::uint8_t valid) const noexcept
{
    const bool is_compared = is_digest_whole_ && (valid == kConfigurationValidValue);
    return (!is_compared) || (digest_.value == reference_.value);
}

// step    0          1         2          3         ...
// slot    0 recheck  0 digest  1 recheck  1 digest  ...    a change in both channels shows when all slots are done
SlotIndex ConfigurationDiagnosis::Examine(ConfigurationCopies& copies, const std::uint8_t valid) noexcept
{
    const std::uint32_t step = step_;
    const std::uint32_t following = step + 1U;
    const bool is_last = following == (2U * static_cast<std::uint32_t>(copies.Device().srdo_count));
    step_ = is_last ? std::uint8_t{0U} : static_cast<std::uint8_t>(following);
    const SlotIndex slot = static_cast<SlotIndex>(step / 2U);
    SlotIndex checked = kNoSlot;
    bool is_sound = true;
    if ((step & 1U) == 0U)
    {
        is_digest_whole_ = is_digest_whole_ || (slot == 0U);
        is_sound = IsSlotSound(copies, slot, valid);
        checked = slot;
    }
    else
    {
        const DigestReply further = copies.ContinueDigest(slot, DeviceDigest{(slot == 0U) ? 0U : digest_.value});
        digest_.value = further.digest;
        const bool is_complete = (further.result == Result::kSuccessful) && is_last;
        is_sound = (!is_complete) || IsDigestSound(valid);
    }
    if (!is_sound)
    {
        copies.Report(is_last ? kNoSlot : slot);
    }
    return checked;
}

} // namespace counterpoint
