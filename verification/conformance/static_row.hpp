// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CONFORMANCE_STATIC_ROW_HPP
#define VERIFICATION_CONFORMANCE_STATIC_ROW_HPP

#include "safety_core/contract/channel.hpp"

#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace counterpoint::conformance
{

/// A device with one consumer whose static mapping has up to 130 entries: 2300h:01 to 41h and 2301h:01 to 41h, objects
/// of 8 bits, each side in one field. No device of the cases has so many.
class StaticRow
{
  public:
    StaticRow() noexcept
    {
        for (std::uint8_t at = 0U; at < kPairs; ++at)
        {
            const std::uint8_t sub = static_cast<std::uint8_t>(at + 1U);
            objects_[at] = MappableObject{0x2300U, sub, 8U, MapAccess::kConsumer, &normal_[at]};
            objects_[kPairs + at] = MappableObject{0x2301U, sub, 8U, MapAccess::kConsumer, &inverse_[at]};
            entries_[2U * at] = 0x23000008U | (std::uint32_t{sub} << 8U);
            entries_[(2U * at) + 1U] = 0x23010008U | (std::uint32_t{sub} << 8U);
        }
        setup_.number = 1U;
        config_.srdos = &setup_;
        config_.objects = objects_;
        config_.object_count = 2U * kPairs;
        config_.srdo_count = 1U;
        config_.node_id = 1U;
        config_.granularity_bits = 8U;
        config_.map_entries = kMaxMapEntries;
        config_.normal_port = CanPortId::kFirst;
        config_.inverse_port = CanPortId::kFirst;
        config_.cycle_us = 1000U;
    }
    StaticRow(const StaticRow&) = delete;
    StaticRow(StaticRow&&) = delete;
    StaticRow& operator=(const StaticRow&) = delete;
    StaticRow& operator=(StaticRow&&) = delete;
    ~StaticRow() = default;

    /// @brief What the channel finds from power-on on, with so many entries and both fields registered.
    [[nodiscard]] CheckResult Validated(Channel& channel, const std::uint8_t count) noexcept
    {
        setup_.map = StaticMap{entries_, count};
        channel.Restart(config_);
        channel.SetFields(0U, StaticFields{normal_, inverse_});
        for (const auto& [field, value] :
             {Value{ConfigField::kDirection, 2U}, Value{ConfigField::kSct, 50U}, Value{ConfigField::kSrvt, 20U},
              Value{ConfigField::kCobId1, 0x111U}, Value{ConfigField::kCobId2, 0x112U}})
        {
            channel.Store(ConfigItem{ConfigAddress{0U, field, 0U}, value});
        }
        channel.Store(ConfigItem{ConfigAddress{0U, ConfigField::kSignature, 0U}, channel.Validate(0U).signature});
        return channel.Validate(0U);
    }

  private:
    struct Value
    {
        ConfigField field;
        std::uint32_t value;
    };

    static constexpr std::uint8_t kPairs = 65U;

    std::uint8_t normal_[kPairs]{};
    std::uint8_t inverse_[kPairs]{};
    MappableObject objects_[2U * kPairs]{};
    std::uint32_t entries_[2U * kPairs]{};
    SrdoSetup setup_{};
    DeviceConfig config_{};
};

} // namespace counterpoint::conformance

#endif
