// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "examples/firmware/own_device/own_application.hpp"

#include "safety_core/kernel/variable.hpp"

namespace counterpoint::examples
{
namespace
{

// As in own_device.dcf. `counterpoint sign own_device.dcf` tells the signatures (13FFh) and the digest after a change.
constexpr Setting kSettings[]{
    {{0x1300U, 0U}, 1U, 1U},
    {{0x1381U, 1U}, 4U, 0x20000108U},
    {{0x1381U, 2U}, 4U, 0x21000108U},
    {{0x1381U, 0U}, 1U, 2U},
    {{0x1301U, 2U}, 2U, 25U},
    {{0x1301U, 3U}, 1U, 20U},
    {{0x1301U, 5U}, 4U, 0x121U},
    {{0x1301U, 6U}, 4U, 0x122U},
    {{0x1301U, 1U}, 1U, kDirectionProducer},
    {{0x1382U, 1U}, 4U, 0x20000208U},
    {{0x1382U, 2U}, 4U, 0x21000208U},
    {{0x1382U, 0U}, 1U, 2U},
    {{0x1302U, 2U}, 2U, 25U},
    {{0x1302U, 3U}, 1U, 20U},
    {{0x1302U, 5U}, 4U, 0x123U},
    {{0x1302U, 6U}, 4U, 0x124U},
    {{0x1302U, 1U}, 1U, kDirectionProducer},
    {{0x1383U, 1U}, 4U, 0x22000108U},
    {{0x1383U, 2U}, 4U, 0x23000108U},
    {{0x1383U, 0U}, 1U, 2U},
    {{0x1303U, 2U}, 2U, 50U},
    {{0x1303U, 3U}, 1U, 20U},
    {{0x1303U, 5U}, 4U, 0x111U},
    {{0x1303U, 6U}, 4U, 0x112U},
    {{0x1303U, 1U}, 1U, kDirectionConsumer},
    {{0x1384U, 1U}, 4U, 0x22000208U},
    {{0x1384U, 2U}, 4U, 0x23000208U},
    {{0x1384U, 0U}, 1U, 2U},
    {{0x1304U, 2U}, 2U, 50U},
    {{0x1304U, 3U}, 1U, 20U},
    {{0x1304U, 5U}, 4U, 0x113U},
    {{0x1304U, 6U}, 4U, 0x114U},
    {{0x1304U, 1U}, 1U, kDirectionConsumer},
    {{0x13FFU, 1U}, 2U, 0xE570U},
    {{0x13FFU, 2U}, 2U, 0x0E21U},
    {{0x13FFU, 3U}, 2U, 0xE070U},
    {{0x13FFU, 4U}, 2U, 0x0B21U},
    {{0x13FEU, 0U}, 1U, kConfigurationValidValue},
};

constexpr SrdoSetup Setup(const std::uint8_t number, const ProducerForm form) noexcept
{
    return SrdoSetup{number, ReleasePolicy::kInterlock, form, Payload{}, SrvtDetection::kEarly, StaticMap{}};
}

// Safe value 0: off. Interlock: after a fault an output waits for a pair and for a person.
constexpr SrdoSetup kSetups[]{Setup(1U, ProducerForm::kProviderCalled), Setup(2U, ProducerForm::kProviderCalled),
                              Setup(3U, ProducerForm::kApplicationSends), Setup(4U, ProducerForm::kApplicationSends)};

} // namespace

const DeviceConfig& OwnApplication::Describe() noexcept
{
    for (std::uint8_t number = 0U; number < kProducers; ++number)
    {
        const std::uint8_t sub = static_cast<std::uint8_t>(number + 1U);
        objects_[number] = MappableObject{0x2000U, sub, 8U, MapAccess::kProducer, &input_[number]};
        objects_[number + 2U] = MappableObject{0x2100U, sub, 8U, MapAccess::kProducer, &input_inverse_[number]};
        objects_[number + 4U] = MappableObject{0x2200U, sub, 8U, MapAccess::kConsumer, &command_[number]};
        objects_[number + 6U] = MappableObject{0x2300U, sub, 8U, MapAccess::kConsumer, &command_inverse_[number]};
    }
    SetCommonConfig(config_);
    config_.inverse_port = inverse_port_;
    config_.srdos = kSetups;
    config_.srdo_count = kSrdos;
    config_.objects = objects_;
    config_.object_count = kObjects;
    config_.node_id = 17U;
    // The second as `counterpoint sign` tells it where 5F00h:10 is 2.
    config_.digest = (inverse_port_ == CanPortId::kFirst) ? 0x95777803U : 0x6B0F27C3U;
    return config_;
}

AbortCode OwnApplication::Configure(Kernel& kernel) noexcept
{
    return WriteSettings(kernel, SettingList{kSettings, sizeof(kSettings) / sizeof(kSettings[0])});
}

void OwnApplication::Sense(const std::uint8_t input, const std::uint8_t a, const std::uint8_t b) noexcept
{
    sensed_a_[input % kProducers] = a;
    sensed_b_[input % kProducers] = b;
}

bool OwnApplication::IsEnabled(const std::uint8_t output, const SrdoMask open) const noexcept
{
    const std::uint8_t number = output % kConsumers;
    const bool is_open = ((open >> (kProducers + number)) & 1U) != 0U;
    const bool is_inverse = static_cast<std::uint8_t>(~command_inverse_[number]) == command_[number];
    return is_open && is_inverse && (command_[number] == 1U);
}

// Both sides come from readings of their own; readings that contradict give a pair that is not inverse, and nothing is
// sent.
RefreshAnswer OwnApplication::OnRefresh(const CommunicationIndex index) noexcept
{
    const std::uint32_t number = (static_cast<std::uint32_t>(index.value) - kFirstCommunication) % kProducers;
    input_[number] = sensed_a_[number];
    input_inverse_[number] = static_cast<std::uint8_t>(0xFEU | sensed_b_[number]);
    return RefreshAnswer::kReady;
}

} // namespace counterpoint::examples
