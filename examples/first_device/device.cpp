// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "device.hpp"

namespace first_device
{
namespace
{
using namespace counterpoint;

struct Setting
{
    ObjectAddress address;
    std::uint8_t size_bytes;
    std::uint32_t value;
};

// The same values as in first_device.dcf, in the order in which the kernel takes them.
constexpr Setting kSettings[]{
    {{0x1300U, 0U}, 1U, 1U},          // Global fail-safe command is followed.
    {{0x1381U, 1U}, 4U, 0x22000108U}, // SRDO 1: 2200h:01, 8 bits, and its inverse object.
    {{0x1381U, 2U}, 4U, 0x23000108U},
    {{0x1381U, 0U}, 1U, 2U},
    {{0x1301U, 2U}, 2U, 50U}, // SCT [ms]
    {{0x1301U, 3U}, 1U, 20U}, // SRVT [ms]
    {{0x1301U, 5U}, 4U, 0x101U},
    {{0x1301U, 6U}, 4U, 0x102U},
    {{0x1301U, 1U}, 1U, kDirectionConsumer},
    {{0x1382U, 1U}, 4U, 0x20000108U}, // SRDO 2: 2000h:01, 8 bits, and its inverse object.
    {{0x1382U, 2U}, 4U, 0x21000108U},
    {{0x1382U, 0U}, 1U, 2U},
    {{0x1302U, 2U}, 2U, 25U}, // Refresh time [ms]
    {{0x1302U, 3U}, 1U, 20U},
    {{0x1302U, 5U}, 4U, 0x103U},
    {{0x1302U, 6U}, 4U, 0x104U},
    {{0x1302U, 1U}, 1U, kDirectionProducer},
    {{0x13FFU, 1U}, 2U, 0x9EA7U}, // Signatures from `counterpoint sign`.
    {{0x13FFU, 2U}, 2U, 0x62AAU},
    {{0x13FEU, 0U}, 1U, kConfigurationValidValue}, // Last: declares all of it valid.
};

// Number, policy, form, safe value, detection, static mapping.
constexpr SrdoSetup kSrdos[]{
    {1U, ReleasePolicy::kInterlock, ProducerForm::kApplicationSends, Payload{}, SrvtDetection::kEarly, StaticMap{}},
    {2U, ReleasePolicy::kInterlock, ProducerForm::kProviderCalled, Payload{}, SrvtDetection::kEarly, StaticMap{}}};
} // namespace

const DeviceConfig& Device::Describe() noexcept
{
    objects_[0] = MappableObject{0x2000U, 1U, 8U, MapAccess::kProducer, report_};
    objects_[1] = MappableObject{0x2100U, 1U, 8U, MapAccess::kProducer, report_inverse_};
    objects_[2] = MappableObject{0x2200U, 1U, 8U, MapAccess::kConsumer, command_};
    objects_[3] = MappableObject{0x2300U, 1U, 8U, MapAccess::kConsumer, command_inverse_};
    config_.srdos = kSrdos;
    config_.srdo_count = 2U;
    config_.objects = objects_;
    config_.object_count = 4U;
    config_.node_id = 2U;
    config_.granularity_bits = 8U;
    config_.map_entries = kUsualMapEntries;
    config_.gfc = GfcUse::kPresent;
    config_.normal_port = CanPortId::kFirst;
    config_.inverse_port = CanPortId::kFirst;
    config_.cycle_us = 1000U;
    config_.cycle_tolerance_us = 500U;
    config_.discrepancy_us = 5000U;
    config_.acknowledge_window_us = 1000000U;
    config_.diagnostic_interval_us = 1000000U;
    config_.test_interval_us = 1000000U;
    config_.clock_tolerance_us = 500U;
    config_.clock_interval_us = 100000U;
    config_.output_time_us = 1000U;
    config_.digest = 0xE5394992U; // 5F04h from `counterpoint sign`.
    return config_;
}

AbortCode Device::Configure(Kernel& kernel) noexcept
{
    for (const Setting& setting : kSettings)
    {
        ObjectData data{};
        data.size_bytes = setting.size_bytes;
        for (std::uint32_t byte = 0U; byte < setting.size_bytes; ++byte)
        {
            data.bytes[byte] = static_cast<std::uint8_t>(setting.value >> (8U * byte));
        }
        const AbortCode abort = kernel.WriteObject(setting.address, data);
        if (abort != AbortCode::kNone)
        {
            return abort;
        }
    }
    return AbortCode::kNone;
}

std::uint8_t Device::Command() const noexcept
{
    const bool is_inverse = command_[0] == static_cast<std::uint8_t>(~command_inverse_[0]);
    return is_inverse ? command_[0] : std::uint8_t{0U};
}

SrdoCause Device::TakeError() noexcept
{
    const SrdoCause error = error_;
    error_ = SrdoCause::kNone;
    return error;
}

// A safety device reads its two inputs here, each by its own way. This one reports the command that it obeys.
RefreshAnswer Device::OnRefresh(CommunicationIndex /*index*/) noexcept
{
    report_[0] = command_[0];
    report_inverse_[0] = command_inverse_[0];
    return RefreshAnswer::kReady;
}

void Device::OnSrdoEvent(CommunicationIndex /*index*/) noexcept
{
}

void Device::OnSrdoError(CommunicationIndex /*index*/, const SrdoCause cause) noexcept
{
    error_ = (error_ == SrdoCause::kNone) ? cause : error_;
}

void Device::OnConfigurationInvalid(CommunicationIndex /*index*/) noexcept
{
}

void Device::OnDeviceFault(const DeviceFaultReport& /*report*/) noexcept
{
}

} // namespace first_device
