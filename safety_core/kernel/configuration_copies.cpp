// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/configuration_copies.hpp"

namespace counterpoint
{
namespace
{

CheckResult CheckBy(Channel& channel, const SlotIndex slot, const CheckDepth depth) noexcept
{
    return (depth == CheckDepth::kValidate) ? channel.Validate(slot) : channel.Recheck(slot);
}

} // namespace

SlotIndex ConfigurationCopies::NamedBy(const ConfigAddress& address) noexcept
{
    const bool is_of_device =
        (address.field == ConfigField::kGfcParameter) || (address.field == ConfigField::kConfigurationValid);
    return is_of_device ? kNoSlot : address.slot;
}

std::uint32_t ConfigurationCopies::Value(const SlotIndex slot, const ConfigField field,
                                         const std::uint8_t sub) const noexcept
{
    return a_.Load(ConfigAddress{slot, field, sub}).value;
}

// Both channels keep the value; what they give back then must be what was stored. The stand-in of a channel on another
// CPU gives back what the channel here keeps: so both keep it first. [SRS_CFG_047]
void ConfigurationCopies::Store(const ConfigItem& item) noexcept
{
    a_.Store(item);
    b_.Store(item);
    const std::uint32_t differences =
        (a_.Load(item.address).value ^ item.value) | (b_.Load(item.address).value ^ item.value);
    if (differences != 0U)
    {
        latch_.Enter(DeviceFault::kConfiguration, NamedBy(item.address));
    }
}

CheckResult ConfigurationCopies::Check(const SlotIndex slot, const CheckDepth depth) noexcept
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

DigestReply ConfigurationCopies::ContinueDigest(const SlotIndex slot, const DeviceDigest before) noexcept
{
    const DigestReply reply{Result::kSuccessful, a_.Digest(slot, before).value};
    if (reply.digest == b_.Digest(slot, before).value)
    {
        return reply;
    }
    latch_.Enter(DeviceFault::kDisagreement, slot);
    return DigestReply{Result::kDeviceFault, reply.digest};
}

} // namespace counterpoint
