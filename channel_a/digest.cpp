// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/channel.hpp"
#include "channel_a/octets.hpp"
#include "channel_a/voice.hpp"

#include <cstddef>
#include <cstdint>

// What the signature does not cover. [SRS_CFG_034]
namespace counterpoint::channel_a
{
namespace
{

constexpr std::uint32_t kPolynomial = 0xEDB88320U; // 04C11DB7h reflected.
constexpr std::uint32_t kHalfBits = 4U;
constexpr std::uint32_t kHalfCount = 16U;

// What four bits do to an empty register.
constexpr std::uint32_t kHalves[kHalfCount] = {
    // MISRA D-001
    // clang-format off
    0x00000000U, 0x1DB71064U, 0x3B6E20C8U, 0x26D930ACU, 0x76DC4190U, 0x6B6B51F4U, 0x4DB26158U, 0x5005713CU,
    0xEDB88320U, 0xF00F9344U, 0xD6D6A3E8U, 0xCB61B38CU, 0x9B64C2B0U, 0x86D3D2D4U, 0xA00AE278U, 0xBDBDF21CU,
    // clang-format on
};

// Entry n, shifted by one bit more and without what that bit did, is entry 2 n of five bits: by linearity each entry is
// the sum of those of its bits, and the entry of a bit is that of the next one shifted.
template <std::uint32_t kCrc> constexpr std::uint32_t kShifted = (kCrc >> 1U) ^ ((kCrc & 1U) * kPolynomial);
template <std::size_t kEntry>
constexpr bool kIsSum = kHalves[kEntry] == (kHalves[kEntry & (kEntry - 1U)] ^ kHalves[kEntry & (~kEntry + 1U)]);
template <std::size_t kEntries> constexpr std::size_t kRight = kRight<kEntries - 1U> + (kIsSum<kEntries> ? 1U : 0U);
template <> constexpr std::size_t kRight<0U> = 0U;
static_assert(kHalves[0U] == 0U, "nothing does nothing");
static_assert(kHalves[8U] == kPolynomial, "the last bit in");
static_assert(kHalves[4U] == kShifted<kHalves[8U]>, "the bit before it");
static_assert(kHalves[2U] == kShifted<kHalves[4U]>, "the bit before that");
static_assert(kHalves[1U] == kShifted<kHalves[2U]>, "the first bit in");
static_assert(kRight<kHalfCount - 1U> == (kHalfCount - 1U), "the table is that of the polynomial");

// The low `bits` of the value, four at a time, the lowest first.
std::uint32_t Fed(const std::uint32_t crc, const std::uint32_t value, const std::uint32_t bits) noexcept
{
    std::uint32_t fed = crc ^ value;
    for (std::uint32_t bit = 0U; bit < bits; bit += kHalfBits)
    {
        fed = (fed >> kHalfBits) ^ kHalves[fed % kHalfCount];
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
