// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CONFORMANCE_DEVICE_PARTS_HPP
#define VERIFICATION_CONFORMANCE_DEVICE_PARTS_HPP

#include "verification/conformance/device.hpp"

#include <cstddef>
#include <cstdint>

/// Of what the devices of the cases are made.
namespace counterpoint::conformance
{

inline constexpr std::uint32_t kGoldMap[] = {0x60100108U, 0x60110108U, 0x60100208U, 0x60110208U};
inline constexpr std::uint32_t kWordMap[] = {0x62000120U, 0x62010120U};
inline constexpr std::uint32_t kSenderMap[] = {0x62100108U, 0x62110108U, 0x62100208U, 0x62110208U};
inline constexpr SrdoValues kGoldValues{2U, 50U, 20U, 0x111U, 0x112U, 4U, kGoldMap, 0x4370U};
inline constexpr SrdoValues kWordValues{2U, 50U, 20U, 0x103U, 0x104U, 2U, kWordMap, 0xD999U};
inline constexpr SrdoValues kSenderValues{1U, 25U, 20U, 0x101U, 0x102U, 4U, kSenderMap, 0xF2B5U};
inline constexpr SrdoValues kBareValues{0U, 25U, 20U, 0x0U, 0x0U, 0U, nullptr, 0x162EU};
inline constexpr Payload kGoldSafe{0x0000C3A5U, 0U};
inline constexpr Payload kWordSafe{0x44332211U, 0U};

constexpr SrdoSetup Consumer(std::uint8_t number, ReleasePolicy policy, const Payload& safe_value)
{
    return SrdoSetup{
        number, policy, ProducerForm::kApplicationSends, safe_value, SrvtDetection::kEarly, StaticMap{nullptr, 0U}};
}

constexpr SrdoSetup Producer(std::uint8_t number, ProducerForm form)
{
    return SrdoSetup{number,          ReleasePolicy::kInterlock, form,
                     Payload{0U, 0U}, SrvtDetection::kEarly,     StaticMap{nullptr, 0U}};
}

/// Common to all: one second of cycle and of tolerance, 100 ms for an acknowledge, one controller.
template <std::size_t kCount>
constexpr DeviceConfig Config(const SrdoSetup (&setups)[kCount], std::uint8_t count = kCount)
{
    return DeviceConfig{setups,
                        nullptr,
                        kAllObjects,
                        count,
                        40U,
                        8U,
                        kUsualMapEntries,
                        DummyMapping::kRefused,
                        NumberGaps::kSearched,
                        GfcUse::kPresent,
                        CanPortId::kFirst,
                        CanPortId::kFirst,
                        1000000U,
                        1000000U,
                        10000U,
                        100000U,
                        900000U,
                        900000U,
                        1000U,
                        1000000U,
                        1000U,
                        0U};
}

constexpr DeviceConfig Every(DeviceConfig config, std::uint32_t cycle_us, std::uint32_t tolerance_us)
{
    config.cycle_us = cycle_us;
    config.cycle_tolerance_us = tolerance_us;
    return config;
}

constexpr DeviceConfig OnTwoPorts(DeviceConfig config)
{
    config.inverse_port = CanPortId::kSecond;
    return config;
}

constexpr DeviceConfig OnSwappedPorts(DeviceConfig config)
{
    config.normal_port = CanPortId::kSecond;
    config.inverse_port = CanPortId::kFirst;
    return config;
}

constexpr DeviceConfig Node(DeviceConfig config, std::uint8_t node_id)
{
    config.node_id = node_id;
    return config;
}

constexpr DeviceConfig Coarse(DeviceConfig config, std::uint8_t granularity_bits)
{
    config.granularity_bits = granularity_bits;
    return config;
}

constexpr DeviceConfig Objects(DeviceConfig config, std::uint16_t object_count)
{
    config.object_count = object_count;
    return config;
}

} // namespace counterpoint::conformance

#endif
