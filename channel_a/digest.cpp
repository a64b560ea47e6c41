// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/channel.hpp"
#include "channel_a/octets.hpp"
#include "channel_a/voice.hpp"

#include <cstddef>
#include <cstdint>

// What the signature does not cover. [SRS-CFG-034]
namespace counterpoint::channel_a
{
namespace
{

constexpr std::uint32_t kPolynomial = 0xEDB88320U; // 04C11DB7h reflected.

// Bit by bit, the lowest first: it is not looked at often enough for a table.
std::uint32_t Fed(const std::uint32_t crc, const std::uint32_t value, const std::uint32_t bits) noexcept
{
    std::uint32_t fed = crc ^ value;
    for (std::uint32_t bit = 0U; bit < bits; ++bit)
    {
        fed = (fed >> 1U) ^ (((fed & 1U) != 0U) ? kPolynomial : 0U);
    }
    return fed;
}

std::uint32_t FedByte(const std::uint32_t crc, const std::uint32_t byte) noexcept
{
    return Fed(crc, byte, kBitsPerByte);
}

std::uint32_t FedWord(const std::uint32_t crc, const std::uint32_t word) noexcept
{
    return Fed(crc, word, kBitsPerWord);
}

// One byte: the value that grants something, or 00h for any other.
template <typename Option>
std::uint32_t FedOption(const std::uint32_t crc, const Option value, const Option granting) noexcept
{
    const bool is_granted = value == granting;
    return FedByte(crc, is_granted ? static_cast<std::uint32_t>(granting) : 0U);
}

std::uint32_t FedDevice(const std::uint32_t start, const Voice& voice) noexcept
{
    const DeviceConfig& config = *voice.config;
    std::uint32_t crc = FedByte(start, config.node_id);
    crc = FedByte(crc, config.granularity_bits);
    crc = FedOption(crc, config.dummies, DummyMapping::kAllowed);
    crc = FedOption(crc, config.gaps, NumberGaps::kSearched);
    crc = FedOption(crc, config.gfc, GfcUse::kPresent);
    crc = FedByte(crc, static_cast<std::uint32_t>(voice.ports[0]));
    crc = FedByte(crc, static_cast<std::uint32_t>(voice.ports[1]));
    crc = FedWord(crc, config.cycle_us);
    crc = FedWord(crc, config.cycle_tolerance_us);
    crc = FedWord(crc, config.discrepancy_us);
    crc = FedWord(crc, config.acknowledge_window_us);
    crc = FedWord(crc, config.diagnostic_interval_us);
    crc = FedWord(crc, config.test_interval_us);
    crc = FedWord(crc, config.clock_tolerance_us);
    crc = FedWord(crc, config.clock_interval_us);
    crc = FedWord(crc, config.output_time_us);
    return FedByte(crc, voice.globals[kGfcParameterPlace]);
}

} // namespace

DeviceDigest Channel::Digest(const SlotIndex slot, const DeviceDigest before) const noexcept
{
    const Record& record = At(voice_, slot);
    std::uint32_t crc = ~before.value;
    if (slot == 0U)
    {
        crc = FedDevice(crc, voice_);
    }
    crc = FedByte(crc, voice_.config->srdos[slot].number); // MISRA D-002
    crc = FedOption(crc, record.policy, ReleasePolicy::kAutomatic);
    crc = FedOption(crc, record.form, ProducerForm::kProviderCalled);
    crc = FedOption(crc, record.detection, SrvtDetection::kLate);
    crc = FedByte(crc, record.values[kTransmissionTypePlace]);
    crc = FedWord(crc, record.safe.low);
    crc = FedWord(crc, record.safe.high);
    return DeviceDigest{~crc};
}

} // namespace counterpoint::channel_a
