// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/channel.hpp"
#include "channel_b/image.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_b
{

namespace
{

/// What four bits that leave a CRC-32 with polynomial 04C11DB7h, lowest bit first, fold back.
constexpr std::uint32_t kFolded[16U] = { // MISRA D-001
    0x00000000U, 0x1DB71064U, 0x3B6E20C8U, 0x26D930ACU, 0x76DC4190U, 0x6B6B51F4U, 0x4DB26158U, 0x5005713CU,
    0xEDB88320U, 0xF00F9344U, 0xD6D6A3E8U, 0xCB61B38CU, 0x9B64C2B0U, 0x86D3D2D4U, 0xA00AE278U, 0xBDBDF21CU};

/// CRC-16 with polynomial 1021h over the four bytes of a word, the highest first. What a word folds back is q (1 + x^5
/// + x^12), where q is the word less what q itself folds back above bit 15: q = word + q / x^4 + q / x^11 + q / x^16.
/// Three lines solve that for all bits at once, so that there is neither a table nor a loop over bits. Bits of a CRC
/// above bit 15 are rubbish that counts for nothing and is cut off at the end.
[[nodiscard]] std::uint32_t FoldWord(std::uint32_t crc, std::uint32_t word) noexcept
{
    std::uint32_t quotient = word ^ (crc << 16U);
    quotient ^= (quotient >> 4U) ^ (quotient >> 11U) ^ (quotient >> 16U);
    quotient ^= (quotient >> 8U) ^ (quotient >> 22U);
    quotient ^= quotient >> 16U;
    return (quotient << 12U) ^ (quotient << 5U) ^ quotient;
}

/// The same over one byte.
[[nodiscard]] std::uint32_t FoldByte(std::uint32_t crc, std::uint32_t byte) noexcept
{
    const std::uint32_t leaving = ((crc >> 8U) ^ byte) & 0xFFU;
    const std::uint32_t quotient = leaving ^ (leaving >> 4U);
    return (crc << 8U) ^ (quotient << 12U) ^ (quotient << 5U) ^ quotient;
}

/// Low byte first becomes high byte first.
[[nodiscard]] constexpr std::uint32_t Reversed(std::uint32_t word) noexcept
{
    return (word << 24U) | ((word & 0xFF00U) << 8U) | ((word >> 8U) & 0xFF00U) | (word >> 24U);
}

/// CRC-32 over the lowest bits of a word, four at a time, the lowest first: of whole bytes low byte first.
[[nodiscard]] [[gnu::noinline]] std::uint32_t Digested(std::uint32_t crc, std::uint32_t word,
                                                       std::uint32_t bits) noexcept
{
    std::uint32_t digested = crc ^ word;
    for (std::uint32_t rest = bits; rest != 0U; rest -= 4U)
    {
        digested = (digested >> 4U) ^ kFolded[digested & 15U]; // MISRA D-002
    }
    return digested;
}

/// The only value that counts, or 0.
template <typename T> [[nodiscard]] constexpr std::uint32_t OnlyIf(T value, T expected) noexcept
{
    return (value == expected) ? static_cast<std::uint32_t>(expected) : 0U;
}

[[nodiscard]] std::uint32_t DigestedDevice(std::uint32_t crc, const DeviceConfig& config, std::uint32_t gfc) noexcept
{
    const std::uint32_t words[9U] = {config.cycle_us, // MISRA D-001
                                     config.cycle_tolerance_us,
                                     config.discrepancy_us,
                                     config.acknowledge_window_us,
                                     config.diagnostic_interval_us,
                                     config.test_interval_us,
                                     config.clock_tolerance_us,
                                     config.clock_interval_us,
                                     config.output_time_us};
    std::uint32_t digested =
        Digested(crc,
                 FourBytes(config.node_id, config.granularity_bits, OnlyIf(config.dummies, DummyMapping::kAllowed),
                           OnlyIf(config.gaps, NumberGaps::kSearched)),
                 32U);
    digested = Digested(digested,
                        FourBytes(OnlyIf(config.gfc, GfcUse::kPresent), static_cast<std::uint32_t>(config.normal_port),
                                  static_cast<std::uint32_t>(config.inverse_port), 0U),
                        24U);
    for (const std::uint32_t word : words)
    {
        digested = Digested(digested, word, 32U);
    }
    return Digested(digested, gfc, 8U);
}

} // namespace

std::uint16_t Channel::SignatureOf(const Row& row, const Mapping& mapping) const noexcept
{
    std::uint32_t crc = 0U;
    for (std::size_t at = 0U; at < kMapCountAt; at += 4U)
    {
        crc = FoldWord(crc, Reversed(WordAt(row, at)));
    }
    crc = FoldByte(crc, mapping.count);
    for (std::uint32_t index = 0U; index < mapping.count; ++index)
    {
        crc = FoldWord(FoldByte(crc, index + 1U), Reversed(mapping.entries[index]));
    }
    return static_cast<std::uint16_t>(crc & 0xFFFFU);
}

/// [SRS_CFG_034]
DeviceDigest Channel::Digest(SlotIndex slot, DeviceDigest before) const noexcept
{
    const SrdoSetup& setup = Column<const SrdoSetup>{x_config->srdos}[slot];
    const Row& row = x_storage.rows[slot];
    std::uint32_t crc = ~before.value;
    if (slot == 0U)
    {
        crc = DigestedDevice(crc, *x_config, x_storage.device[kGfcParameterAt]);
    }
    crc = Digested(crc,
                   FourBytes(setup.number, static_cast<std::uint32_t>(row.policy), static_cast<std::uint32_t>(row.form),
                             static_cast<std::uint32_t>(row.detection)),
                   32U);
    crc = Digested(crc, row.image[kTransmissionTypeAt], 8U);
    crc = Digested(crc, setup.safe_value.low, 32U);
    crc = Digested(crc, setup.safe_value.high, 32U);
    return DeviceDigest{~crc};
}

} // namespace counterpoint::channel_b
