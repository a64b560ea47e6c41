// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/settings.hpp"

#include "channel_b/words.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_b
{

namespace
{

// Power-on values. [SRS_CFG_002]
constexpr std::uint8_t kDefaultRefreshMs = 25U;
constexpr std::uint8_t kDefaultSctMs = 50U;
constexpr std::uint8_t kDefaultSrvtMs = 20U;
constexpr std::uint8_t kLastDefaultProducer = 32U;
constexpr std::uint8_t kLastDefaultNode = 64U;

/// The value that counts, or that of all others.
template <typename T> [[nodiscard]] constexpr T OnlyIf(T value, T expected, T other) noexcept
{
    return (value == expected) ? expected : other;
}

} // namespace

void Settings::Restart(const DeviceConfig& config, std::uint8_t count) noexcept
{
    x_config = &config;
    x_count = count;
    x_columns.device[kGfcParameter.at] = 0U;
    x_columns.device[kConfigurationValid.at] = 0U;
    for (SlotIndex slot = 0U; slot < count; ++slot)
    {
        TakeSetup(slot);
    }
}

/// [SRS_CFG_002]
void Settings::TakeSetup(SlotIndex slot) noexcept
{
    const SrdoSetup& setup = Setup(slot);
    const std::uint32_t node = x_config->node_id;
    x_columns.policy[slot] = OnlyIf(setup.policy, ReleasePolicy::kAutomatic, ReleasePolicy::kInterlock);
    x_columns.form[slot] = OnlyIf(setup.form, ProducerForm::kProviderCalled, ProducerForm::kApplicationSends);
    x_columns.detection[slot] = OnlyIf(setup.detection, SrvtDetection::kLate, SrvtDetection::kEarly);
    Unpack(0U, At(slot, 0U), kMaxPayloadBits);
    Unpack(0U, At(slot, kMaxPayloadBytes), kMaxPayloadBits);
    Unpack(kDefaultRefreshMs, At(slot, kSct.at), kSct.bits);
    Unpack(kDefaultSrvtMs, At(slot, kSrvt.at), kSrvt.bits);
    Unpack(kTransmissionTypeAsynchronous, At(slot, kTransmissionType.at), kTransmissionType.bits);
    if ((setup.number == 1U) && (node <= kLastDefaultNode))
    {
        const std::uint32_t normal = (kFirstSrdoIdentifier - 2U) + (2U * node); // 0FFh + 2n
        Unpack(normal, At(slot, kCobId1.at), kCobId1.bits);
        Unpack(normal + 1U, At(slot, kCobId2.at), kCobId2.bits);
        Unpack((node > kLastDefaultProducer) ? kDefaultSctMs : kDefaultRefreshMs, At(slot, kSct.at), kSct.bits);
    }
}

/// [SRS_CFG_003]
bool Settings::Store(const ConfigItem& item) noexcept
{
    const Place place = PlaceOf(item.address);
    Unpack(item.value, place.bytes, place.bits);
    return (place.bits != 0U) && (item.address.field <= ConfigField::kMapCount);
}

/// [SRS_CFG_003]
std::uint32_t Settings::Load(const ConfigAddress& address) const noexcept
{
    const Place place = PlaceOf(address);
    return static_cast<std::uint32_t>(Packed({place.bytes.first}, place.bits) & 0xFFFFFFFFU);
}

/// [SRS_CFG_024]
bool Settings::IsIdentifierInUse(SlotIndex slot) const noexcept
{
    const std::uint32_t normal = NormalIdentifier(slot);
    for (SlotIndex other = 0U; other < x_count; ++other)
    {
        // Ours are `normal` and the next one, so that a modular distance of 0 or 1 is one of them.
        const bool is_other = (other != slot) && (Direction(other) != kDirectionOff);
        const bool is_normal_ours = (NormalIdentifier(other) - normal) <= 1U;
        const bool is_inverse_ours = (InverseIdentifier(other) - normal) <= 1U;
        if (is_other && (is_normal_ours || is_inverse_ours))
        {
            return true;
        }
    }
    return false;
}

/// [SRS_CFG_025]
bool Settings::IsTimingWrong(SlotIndex slot) const noexcept
{
    const std::uint32_t sct_us = SctUs(slot);
    const std::uint32_t srvt_us = SrvtUs(slot);
    if (Direction(slot) == kDirectionProducer)
    {
        return sct_us < x_config->cycle_us;
    }
    return (srvt_us == 0U) || (srvt_us >= sct_us);
}

/// [SRS_CFG_021, SRS_CFG_022, SRS_CFG_023]
ConfigFault Settings::CheckParameters(SlotIndex slot) const noexcept
{
    if (Direction(slot) > kDirectionConsumer)
    {
        return ConfigFault::kDirection;
    }
    if (TransmissionType(slot) != kTransmissionTypeAsynchronous)
    {
        return ConfigFault::kTransmissionType;
    }
    const std::uint32_t normal = NormalIdentifier(slot);
    const bool is_odd_srdo = ((normal - kFirstSrdoIdentifier) < kSrdoIdentifierCount) && ((normal & 1U) != 0U);
    if ((!is_odd_srdo) || (InverseIdentifier(slot) != (normal + 1U)))
    {
        return ConfigFault::kIdentifier;
    }
    if (IsIdentifierInUse(slot))
    {
        return ConfigFault::kIdentifierInUse;
    }
    return IsTimingWrong(slot) ? ConfigFault::kTiming : ConfigFault::kNone;
}

} // namespace counterpoint::channel_b
