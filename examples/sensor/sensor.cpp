// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "examples/sensor/sensor.hpp"

namespace counterpoint::examples
{
namespace
{

constexpr Setting kSettings[]{
    {{0x1300U, 0U}, 1U, 1U},
    {{0x1381U, 1U}, 4U, 0x20000108U},
    {{0x1381U, 2U}, 4U, 0x21000108U},
    {{0x1381U, 3U}, 4U, 0x20000208U},
    {{0x1381U, 4U}, 4U, 0x21000208U},
    {{0x1381U, 0U}, 1U, 4U},
    {{0x1301U, 2U}, 2U, 25U},
    {{0x1301U, 3U}, 1U, 20U},
    {{0x1301U, 5U}, 4U, 0x101U},
    {{0x1301U, 6U}, 4U, 0x102U},
    {{0x1301U, 1U}, 1U, kDirectionProducer},
    {{0x13FFU, 1U}, 2U, 0xB631U},
    {{0x13FEU, 0U}, 1U, kConfigurationValidValue},
};

constexpr SrdoSetup kSrdos[]{
    {1U, ReleasePolicy::kInterlock, ProducerForm::kProviderCalled, Payload{}, SrvtDetection::kEarly, StaticMap{}}};

} // namespace

const DeviceConfig& Sensor::Describe() noexcept
{
    for (std::uint8_t button = 0U; button < kButtons; ++button)
    {
        const std::uint8_t sub = static_cast<std::uint8_t>(button + 1U);
        objects_[button] = MappableObject{0x2000U, sub, 8U, MapAccess::kProducer, &normal_[button]};
        objects_[kButtons + button] = MappableObject{0x2100U, sub, 8U, MapAccess::kProducer, &inverse_[button]};
    }
    SetCommonConfig(config_);
    config_.srdos = kSrdos;
    config_.srdo_count = 1U;
    config_.objects = objects_;
    config_.object_count = 2U * kButtons;
    config_.node_id = 1U;
    config_.digest = 0xDCD151DEU;
    return config_;
}

AbortCode Sensor::Configure(Kernel& kernel) noexcept
{
    return WriteSettings(kernel, SettingList{kSettings, sizeof(kSettings) / sizeof(kSettings[0])});
}

void Sensor::Sense(const std::uint8_t button, const Contacts& contacts) noexcept
{
    contacts_[button % kButtons] = contacts;
}

// The normal objects follow the contacts A and the inverse objects the contacts B. Contacts that are alike give a pair
// that is not inverse: the channels find it (kNotInverse) and send nothing.
RefreshAnswer Sensor::OnRefresh(CommunicationIndex /*index*/) noexcept
{
    for (std::uint8_t button = 0U; button < kButtons; ++button)
    {
        normal_[button] = contacts_[button].a;
        inverse_[button] = static_cast<std::uint8_t>(0xFEU | contacts_[button].b);
    }
    return RefreshAnswer::kReady;
}

} // namespace counterpoint::examples
