// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "examples/controller/controller.hpp"

namespace counterpoint::examples
{
namespace
{

constexpr Setting kSettings[]{
    {{0x1300U, 0U}, 1U, 1U},
    {{0x1381U, 1U}, 4U, 0x22000108U},
    {{0x1381U, 2U}, 4U, 0x23000108U},
    {{0x1381U, 3U}, 4U, 0x22000208U},
    {{0x1381U, 4U}, 4U, 0x23000208U},
    {{0x1381U, 0U}, 1U, 4U},
    {{0x1301U, 2U}, 2U, 100U},
    {{0x1301U, 3U}, 1U, 60U},
    {{0x1301U, 5U}, 4U, 0x101U},
    {{0x1301U, 6U}, 4U, 0x102U},
    {{0x1301U, 1U}, 1U, kDirectionConsumer},
    {{0x1382U, 1U}, 4U, 0x20000108U},
    {{0x1382U, 2U}, 4U, 0x21000108U},
    {{0x1382U, 3U}, 4U, 0x20000208U},
    {{0x1382U, 4U}, 4U, 0x21000208U},
    {{0x1382U, 0U}, 1U, 4U},
    {{0x1302U, 2U}, 2U, 25U},
    {{0x1302U, 3U}, 1U, 20U},
    {{0x1302U, 5U}, 4U, 0x103U},
    {{0x1302U, 6U}, 4U, 0x104U},
    {{0x1302U, 1U}, 1U, kDirectionProducer},
    {{0x13FFU, 1U}, 2U, 0xB881U},
    {{0x13FFU, 2U}, 2U, 0xCA45U},
    {{0x13FEU, 0U}, 1U, kConfigurationValidValue},
};

// The received buttons move nothing here: they may be used again as soon as they come again.
constexpr SrdoSetup kSrdos[]{
    {1U, ReleasePolicy::kAutomatic, ProducerForm::kApplicationSends, Payload{}, SrvtDetection::kEarly, StaticMap{}},
    {2U, ReleasePolicy::kInterlock, ProducerForm::kProviderCalled, Payload{}, SrvtDetection::kEarly, StaticMap{}}};

} // namespace

Controller::Controller(const PeerRole role) noexcept : role_{role}
{
}

const DeviceConfig& Controller::Describe() noexcept
{
    for (std::uint8_t value = 0U; value < kValues; ++value)
    {
        const std::uint8_t sub = static_cast<std::uint8_t>(value + 1U);
        objects_[value] = MappableObject{0x2000U, sub, 8U, MapAccess::kProducer, &command_[value]};
        objects_[2U + value] = MappableObject{0x2100U, sub, 8U, MapAccess::kProducer, &command_inverse_[value]};
        objects_[4U + value] = MappableObject{0x2200U, sub, 8U, MapAccess::kConsumer, &button_[value]};
        objects_[6U + value] = MappableObject{0x2300U, sub, 8U, MapAccess::kConsumer, &button_inverse_[value]};
    }
    SetCommonConfig(config_);
    config_.srdos = kSrdos;
    config_.srdo_count = 2U;
    config_.objects = objects_;
    config_.object_count = 4U * kValues;
    config_.node_id = 2U;
    config_.discrepancy_us = 20000U;
    config_.clock_tolerance_us = 1000U;
    config_.digest = 0x98F6E4B0U;
    return config_;
}

// Time-out: three cycles, two delays of the wire, and room for a lost message in each direction.
LinkConfig Controller::DescribeLink() const noexcept
{
    return LinkConfig{role_, 10000U, 5000U, 100000U, 50U};
}

AbortCode Controller::Configure(Kernel& kernel) noexcept
{
    return WriteSettings(kernel, SettingList{kSettings, sizeof(kSettings) / sizeof(kSettings[0])});
}

std::uint8_t Controller::Button(const std::uint8_t number) const noexcept
{
    return (role_ == PeerRole::kA) ? button_[number] : static_cast<std::uint8_t>(~button_inverse_[number]);
}

// Both buttons let go: 1 and 1. One pressed: 0 and 1. Both pressed, or nothing valid received: 0 and 0.
RefreshAnswer Controller::OnRefresh(CommunicationIndex /*index*/) noexcept
{
    command_[0] = static_cast<std::uint8_t>(Button(0U) & Button(1U));
    command_[1] = static_cast<std::uint8_t>(Button(0U) | Button(1U));
    for (std::uint8_t value = 0U; value < kValues; ++value)
    {
        command_inverse_[value] = static_cast<std::uint8_t>(~command_[value]);
    }
    return RefreshAnswer::kReady;
}

} // namespace counterpoint::examples
