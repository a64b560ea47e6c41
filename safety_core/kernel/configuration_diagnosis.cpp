// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/configuration_guard.hpp"

// Checks of the configuration: all at once, and bit by bit in the cycles. [SRS_CFG_048, SRS_CFG_050, SRS_KRN_015]
namespace counterpoint
{
namespace
{

constexpr std::uint32_t kTokenRotation = 8U;
constexpr std::uint32_t kWordBits = 32U;
constexpr std::uint32_t kEveryByte = 0x01010101U;

constexpr std::uint32_t kRules = 10U;
// Return codes of the reference for the rules of a configuration, by their number. MISRA D-001
constexpr Result kRuleResults[kRules] = {
    Result::kDeviceFault,    Result::kInvalidConfiguration, Result::kInvalidConfiguration, Result::kIdError,
    Result::kIdInUse,        Result::kTimingError,          Result::kMappingError,         Result::kLengthExceeded,
    Result::kSignatureError, Result::kMappingError};
static_assert(static_cast<std::uint32_t>(ConfigFault::kTable) == kRules - 1U, "one result a rule");

} // namespace

Result ToResult(const ConfigFault rule) noexcept
{
    if (rule == ConfigFault::kNone)
    {
        return Result::kSuccessful;
    }
    const std::uint32_t number = static_cast<std::uint32_t>(rule);
    return (number < kRules) ? kRuleResults[number] : Result::kInvalidConfiguration; // MISRA D-002
}

CheckResult ConfigurationGuard::CheckBy(Channel& channel, const SlotIndex slot, const CheckDepth depth) noexcept
{
    return (depth == CheckDepth::kValidate) ? channel.Validate(slot) : channel.Recheck(slot);
}

CheckResult ConfigurationGuard::Check(const SlotIndex slot, const CheckDepth depth) noexcept
{
    CheckResult result = CheckBy(a_, slot, depth);
    const CheckResult other = CheckBy(b_, slot, depth);
    if ((result.fault != other.fault) || (result.signature != other.signature))
    {
        latch_.Enter(DeviceFault::kDisagreement, slot);
        result.fault = ConfigFault::kInvalid;
    }
    return result;
}

ConfigFault ConfigurationGuard::CheckAll(const CheckDepth depth) noexcept
{
    ConfigFault rule = ConfigFault::kNone;
    for (SlotIndex slot = 0U; (slot < config_->srdo_count) && (rule == ConfigFault::kNone); ++slot)
    {
        rule = Check(slot, depth).fault;
        faulty_ = slot;
    }
    return rule;
}

// One more slot by both channels: a difference between them shows at the slot where it is. [SRS_CFG_050]
DigestReply ConfigurationGuard::ContinueDigest(const SlotIndex slot, const DeviceDigest before) noexcept
{
    const DigestReply reply{Result::kSuccessful, a_.Digest(slot, before).value};
    if (reply.digest == b_.Digest(slot, before).value)
    {
        return reply;
    }
    latch_.Enter(DeviceFault::kDisagreement, slot);
    return DigestReply{Result::kDeviceFault, reply.digest};
}

DigestReply ConfigurationGuard::Digest() noexcept
{
    DigestReply reply{(nmt_ == NmtState::kInvalid) ? Result::kDeviceFault : Result::kSuccessful, 0U};
    for (SlotIndex slot = 0U; slot < config_->srdo_count; ++slot)
    {
        const DigestReply further = ContinueDigest(slot, DeviceDigest{reply.digest});
        reply.digest = further.digest;
        reply.result = (further.result == Result::kSuccessful) ? reply.result : further.result;
    }
    const bool is_expected = (config_->digest == 0U) || (config_->digest == reply.digest);
    if ((reply.result == Result::kSuccessful) && (!is_expected))
    {
        reply.result = Result::kInvalidConfiguration;
    }
    return reply;
}

// The digest of the device as it is becomes the reference of the cyclic one. A walk that is under way saw another.
Result ConfigurationGuard::TakeDigest() noexcept
{
    const DigestReply reply = Digest();
    reference_.value = reply.digest;
    is_digest_whole_ = false;
    return reply.result;
}

std::uint32_t ConfigurationGuard::Cycle(const std::uint32_t challenge) noexcept
{
    --cycles_to_check_;
    if (cycles_to_check_ == 0U)
    {
        cycles_to_check_ = cycles_per_check_;
        Examine();
    }
    const std::uint32_t rotated = (challenge << kTokenRotation) | (challenge >> (kWordBits - kTokenRotation));
    return rotated ^ (static_cast<std::uint32_t>(valid_) * kEveryByte);
}

// Only what was declared can be otherwise than declared.
bool ConfigurationGuard::IsSlotSound(const SlotIndex slot) noexcept
{
    return (!IsValid()) || (Check(slot, CheckDepth::kRecheck).fault == ConfigFault::kNone);
}

bool ConfigurationGuard::IsDigestSound() const noexcept
{
    const bool is_compared = is_digest_whole_ && IsValid();
    return (!is_compared) || (digest_.value == reference_.value);
}

// step    0          1         2          3         ...
// slot    0 recheck  0 digest  1 recheck  1 digest  ...    a change in both channels shows when all slots are done
void ConfigurationGuard::Examine() noexcept
{
    const std::uint32_t step = step_;
    const std::uint32_t following = step + 1U;
    const bool is_last = following == (2U * static_cast<std::uint32_t>(config_->srdo_count));
    step_ = is_last ? std::uint8_t{0U} : static_cast<std::uint8_t>(following);
    const SlotIndex slot = static_cast<SlotIndex>(step / 2U);
    bool is_sound = true;
    if ((step & 1U) == 0U)
    {
        is_digest_whole_ = is_digest_whole_ || (slot == 0U);
        is_sound = IsSlotSound(slot);
    }
    else
    {
        const DigestReply further = ContinueDigest(slot, DeviceDigest{(slot == 0U) ? 0U : digest_.value});
        digest_.value = further.digest;
        const bool is_complete = (further.result == Result::kSuccessful) && is_last;
        is_sound = (!is_complete) || IsDigestSound();
    }
    if (!is_sound)
    {
        latch_.Enter(DeviceFault::kConfiguration, is_last ? kNoSlot : slot);
    }
}

} // namespace counterpoint
