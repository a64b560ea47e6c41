// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/bench/safety_setup.hpp"

namespace counterpoint::bench
{
namespace
{

constexpr std::uint16_t kNormalIndex = 0x6000U;
constexpr std::uint16_t kInverseIndex = 0x6100U;
constexpr std::uint16_t kCommunicationIndex = 0x1301U;
constexpr std::uint16_t kMappingIndex = 0x1381U;
constexpr std::uint16_t kValidIndex = 0x13FEU;
constexpr std::uint16_t kSignatureIndex = 0x13FFU;
constexpr std::uint32_t kSrvtMs = 20U;

bool Write(Kernel& kernel, const ObjectAddress& address, const ObjectNumber& number) noexcept
{
    ObjectData data{};
    data.size_bytes = number.size_bytes;
    for (std::uint32_t i = 0U; i < number.size_bytes; ++i)
    {
        data.bytes[i] = static_cast<std::uint8_t>(number.value >> (8U * i));
    }
    return kernel.WriteObject(address, data) == AbortCode::kNone;
}

} // namespace

const DeviceConfig& SafetySetup::Describe(const DevicePlan& plan) noexcept
{
    plan_ = plan;
    const MapAccess access = (plan.role == DeviceRole::kConsumers) ? MapAccess::kConsumer : MapAccess::kProducer;
    for (std::uint8_t slot = 0U; slot < plan.srdo_count; ++slot)
    {
        setups_[slot] = SrdoSetup{static_cast<std::uint8_t>(slot + 1U),
                                  ReleasePolicy::kAutomatic,
                                  ProducerForm::kApplicationSends,
                                  Payload{0U, 0U},
                                  SrvtDetection::kEarly,
                                  StaticMap{nullptr, 0U}};
        for (std::uint8_t part = 0U; part < plan.shape.parts; ++part)
        {
            const std::uint32_t normal = (std::uint32_t{plan.shape.parts} * slot) + part;
            const std::uint32_t inverse = (std::uint32_t{plan.shape.parts} * plan.srdo_count) + normal;
            const auto sub = static_cast<std::uint8_t>(part + 1U);
            objects_[normal] = MappableObject{static_cast<std::uint16_t>(kNormalIndex + slot), sub, plan.shape.bits,
                                              access, places_[normal]};
            objects_[inverse] = MappableObject{static_cast<std::uint16_t>(kInverseIndex + slot), sub, plan.shape.bits,
                                               access, places_[inverse]};
        }
    }
    config_.srdos = setups_;
    config_.objects = objects_;
    config_.object_count = static_cast<std::uint16_t>(2U * plan.shape.parts * plan.srdo_count);
    config_.srdo_count = plan.srdo_count;
    config_.node_id = kNodeId;
    config_.granularity_bits = plan.shape.bits;
    config_.map_entries = kUsualMapEntries;
    config_.gfc = GfcUse::kPresent;
    config_.normal_port = CanPortId::kFirst;
    config_.inverse_port = CanPortId::kFirst;
    config_.cycle_us = kCycleUs;
    config_.cycle_tolerance_us = 100U;
    config_.discrepancy_us = 2U * kCycleUs;
    config_.acknowledge_window_us = 500000U;
    config_.diagnostic_interval_us = plan.interval_us;
    config_.test_interval_us = plan.interval_us;
    config_.clock_tolerance_us = 1000U;
    config_.clock_interval_us = 100000U;
    config_.output_time_us = 100U;
    return config_;
}

bool SafetySetup::ConfigureSlot(Kernel& kernel, const std::uint8_t slot) const noexcept
{
    const auto communication = static_cast<std::uint16_t>(kCommunicationIndex + slot);
    const auto mapping = static_cast<std::uint16_t>(kMappingIndex + slot);
    const std::uint32_t direction = (plan_.role == DeviceRole::kConsumers) ? kDirectionConsumer : kDirectionProducer;
    const std::uint32_t cob_id = kFirstSrdoIdentifier + (2U * slot);
    bool good = Write(kernel, {communication, 1U}, {kDirectionOff, 1U});
    good = Write(kernel, {mapping, 0U}, {0U, 1U}) && good;
    for (std::uint8_t part = 0U; part < plan_.shape.parts; ++part)
    {
        const std::uint32_t tail = ((part + 1U) << 8U) | plan_.shape.bits;
        const auto sub = static_cast<std::uint8_t>((2U * part) + 1U);
        const std::uint32_t normal = ((kNormalIndex + static_cast<std::uint32_t>(slot)) << 16U) | tail;
        const std::uint32_t inverse = ((kInverseIndex + static_cast<std::uint32_t>(slot)) << 16U) | tail;
        good = Write(kernel, {mapping, sub}, {normal, 4U}) && good;
        good = Write(kernel, {mapping, static_cast<std::uint8_t>(sub + 1U)}, {inverse, 4U}) && good;
    }
    good = Write(kernel, {mapping, 0U}, {2U * std::uint32_t{plan_.shape.parts}, 1U}) && good;
    good = Write(kernel, {communication, 2U}, {plan_.sct_ms, 2U}) && good;
    good = Write(kernel, {communication, 3U}, {kSrvtMs, 1U}) && good;
    good = Write(kernel, {communication, 4U}, {kTransmissionTypeAsynchronous, 1U}) && good;
    good = Write(kernel, {communication, 5U}, {cob_id, 4U}) && good;
    good = Write(kernel, {communication, 6U}, {cob_id + 1U, 4U}) && good;
    good = Write(kernel, {communication, 1U}, {direction, 1U}) && good;
    const SignReply signature = kernel.Sign(CommunicationIndex{communication});
    return Write(kernel, {kSignatureIndex, static_cast<std::uint8_t>(slot + 1U)}, {signature.signature, 2U}) && good;
}

bool SafetySetup::Configure(Kernel& kernel) const noexcept
{
    bool good = true;
    for (std::uint8_t slot = 0U; slot < plan_.srdo_count; ++slot)
    {
        good = ConfigureSlot(kernel, slot) && good;
    }
    return Write(kernel, {kValidIndex, 0U}, {kConfigurationValidValue, 1U}) && good;
}

void SafetySetup::FillVariables() noexcept
{
    for (std::uint32_t i = 0U; i < config_.object_count; ++i)
    {
        const bool inverse = i >= std::uint32_t{plan_.shape.parts} * plan_.srdo_count;
        for (std::uint8_t& byte : places_[i])
        {
            byte = inverse ? 0xA5U : 0x5AU;
        }
    }
}

std::uint8_t SafetySetup::SrdoCount() const noexcept
{
    return plan_.srdo_count;
}

std::uint8_t SafetySetup::FrameBytes() const noexcept
{
    return static_cast<std::uint8_t>((plan_.shape.parts * plan_.shape.bits) / 8U);
}

} // namespace counterpoint::bench
