// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_B_SETTINGS_HPP
#define CHANNEL_B_SETTINGS_HPP

#include "channel_b/storage.hpp"
#include "channel_b/words.hpp"
#include "safety_core/contract/configuration.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_b
{

/// First byte and length of a field in an image, or in the device's bytes.
struct Span
{
    std::uint8_t at;
    std::uint8_t bits;
};

constexpr Span kDirection{0U, 8U};
constexpr Span kSct{1U, 16U};
constexpr Span kSrvt{3U, 8U};
constexpr Span kCobId1{4U, 32U};
constexpr Span kCobId2{8U, 32U};
constexpr Span kMapCount{12U, 8U};
constexpr Span kTransmissionType{13U, 8U};
constexpr Span kSignature{14U, 16U};
constexpr Span kGfcParameter{0U, 8U};
constexpr Span kConfigurationValid{1U, 8U};
constexpr Span kNowhere{0U, 0U};

/// By ConfigField; entries of mappings are not kept here.
constexpr std::uint8_t kFieldCount = 12U;
constexpr Span kSpans[kFieldCount] = {
    kNowhere, kDirection, kSct,      kSrvt,    kTransmissionType, // MISRA D-001
    kCobId1,  kCobId2,    kMapCount, kNowhere, kSignature,        kGfcParameter, kConfigurationValid};

static_assert(kImageBytes == (kSignature.at + (kSignature.bits / kBitsPerByte)), "nothing behind the signature");

/// The configuration as canonical images, one a slot, the only copy that this channel has: all but the entries of
/// mappings. Besides, what the digest covers of the setups.
class Settings
{
  public:
    explicit Settings(const SettingColumns& columns) noexcept : x_columns(columns)
    {
    }

    /// @brief Power-on values for the first `count` slots.
    void Restart(const DeviceConfig& config, std::uint8_t count) noexcept;

    /// @brief Keeps a value; whether it belongs to a slot and the slot has to be validated again.
    bool Store(const ConfigItem& item) noexcept;
    [[nodiscard]] std::uint32_t Load(const ConfigAddress& address) const noexcept;
    /// @brief All rules before those of the mapping.
    [[nodiscard]] ConfigFault CheckParameters(SlotIndex slot) const noexcept;

    /// @brief As it enters the signature.
    [[nodiscard]] std::uint8_t ImageByte(SlotIndex slot, std::uint8_t at) const noexcept
    {
        return At(slot, at)[0U];
    }

    [[nodiscard]] std::uint8_t Direction(SlotIndex slot) const noexcept
    {
        return ImageByte(slot, kDirection.at);
    }

    /// @brief SCT of a consumer, refresh time of a producer.
    [[nodiscard]] std::uint32_t SctUs(SlotIndex slot) const noexcept
    {
        return Number(slot, kSct) * kMicrosecondsPerMillisecond;
    }

    [[nodiscard]] std::uint32_t SrvtUs(SlotIndex slot) const noexcept
    {
        return ImageByte(slot, kSrvt.at) * kMicrosecondsPerMillisecond;
    }

    [[nodiscard]] std::uint32_t NormalIdentifier(SlotIndex slot) const noexcept
    {
        return Number(slot, kCobId1);
    }

    [[nodiscard]] std::uint32_t InverseIdentifier(SlotIndex slot) const noexcept
    {
        return Number(slot, kCobId2);
    }

    [[nodiscard]] std::uint8_t MapCount(SlotIndex slot) const noexcept
    {
        return ImageByte(slot, kMapCount.at);
    }

    [[nodiscard]] std::uint8_t TransmissionType(SlotIndex slot) const noexcept
    {
        return ImageByte(slot, kTransmissionType.at);
    }

    [[nodiscard]] std::uint32_t Signature(SlotIndex slot) const noexcept
    {
        return Number(slot, kSignature);
    }

    /// @brief 1300h and 13FEh.
    [[nodiscard]] std::uint8_t GfcParameter() const noexcept
    {
        return x_columns.device[kGfcParameter.at];
    }

    [[nodiscard]] std::uint8_t ConfigurationValid() const noexcept
    {
        return x_columns.device[kConfigurationValid.at];
    }

    [[nodiscard]] ReleasePolicy Policy(SlotIndex slot) const noexcept
    {
        return x_columns.policy[slot];
    }

    [[nodiscard]] ProducerForm Form(SlotIndex slot) const noexcept
    {
        return x_columns.form[slot];
    }

    [[nodiscard]] SrvtDetection Detection(SlotIndex slot) const noexcept
    {
        return x_columns.detection[slot];
    }

    [[nodiscard]] const SrdoSetup& Setup(SlotIndex slot) const noexcept
    {
        return Column<const SrdoSetup>{x_config->srdos}[slot];
    }

    [[nodiscard]] const DeviceConfig& Config() const noexcept
    {
        return *x_config;
    }

    [[nodiscard]] std::uint8_t Count() const noexcept
    {
        return x_count;
    }

    /// @brief Longest time between two calls that is not late.
    [[nodiscard]] std::uint32_t LongestCallUs() const noexcept
    {
        return x_config->cycle_us + x_config->cycle_tolerance_us;
    }

  private:
    /// Where a value is kept; no bits if it does not exist.
    struct Place
    {
        Column<std::uint8_t> bytes;
        std::uint32_t bits;
    };

    [[nodiscard]] std::uint32_t Number(SlotIndex slot, Span span) const noexcept
    {
        return static_cast<std::uint32_t>(Packed({At(slot, span.at).first}, span.bits) & 0xFFFFFFFFU);
    }
    void TakeSetup(SlotIndex slot) noexcept;
    [[nodiscard]] Place PlaceOf(const ConfigAddress& address) const noexcept
    {
        const std::uint32_t field = static_cast<std::uint32_t>(address.field);
        if (field >= kFieldCount)
        {
            return Place{{nullptr}, 0U};
        }
        const Span span = kSpans[field]; // MISRA D-002
        if (address.field >= ConfigField::kGfcParameter)
        {
            return Place{{&x_columns.device[span.at]}, span.bits};
        }
        if (address.slot >= x_count)
        {
            return Place{{nullptr}, 0U};
        }
        return Place{At(address.slot, span.at), span.bits};
    }

    [[nodiscard]] Column<std::uint8_t> At(SlotIndex slot, std::uint8_t at) const noexcept
    {
        return {&x_columns.image[(std::size_t{slot} * kImageBytes) + at]};
    }

    [[nodiscard]] bool IsIdentifierInUse(SlotIndex slot) const noexcept;
    [[nodiscard]] bool IsTimingWrong(SlotIndex slot) const noexcept;

    SettingColumns x_columns;
    const DeviceConfig* x_config{nullptr};
    std::uint8_t x_count{0U};
};

} // namespace counterpoint::channel_b

#endif
