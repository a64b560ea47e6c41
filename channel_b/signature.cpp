// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/channel.hpp"
#include "channel_b/checksum.hpp"
#include "channel_b/image.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_b
{

namespace
{

/// The only value that counts, or 0.
template <typename T> [[nodiscard]] constexpr std::uint32_t OnlyIf(T value, T expected) noexcept
{
    return (value == expected) ? static_cast<std::uint32_t>(expected) : 0U;
}

void AddDevice(Crc32& crc, const DeviceConfig& config, std::uint32_t gfc) noexcept
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
    crc.AddByte(config.node_id);
    crc.AddByte(config.granularity_bits);
    crc.AddByte(OnlyIf(config.dummies, DummyMapping::kAllowed));
    crc.AddByte(OnlyIf(config.gaps, NumberGaps::kSearched));
    crc.AddByte(OnlyIf(config.gfc, GfcUse::kPresent));
    crc.AddByte(static_cast<std::uint32_t>(config.normal_port));
    crc.AddByte(static_cast<std::uint32_t>(config.inverse_port));
    for (const std::uint32_t word : words)
    {
        crc.AddWord(word);
    }
    crc.AddByte(gfc);
}

} // namespace

/// The bytes of the image in its order, those that a map count leaves out excepted. [SRS_CFG_010]
std::uint16_t Channel::SignatureOf(const Row& row, const Mapping& mapping) const noexcept
{
    Crc16 crc;
    for (std::size_t at = 0U; at < kMapCountAt; ++at)
    {
        crc.AddByte(ByteAt(row, at));
    }
    crc.AddByte(mapping.count);
    for (std::uint32_t index = 0U; index < mapping.count; ++index)
    {
        crc.AddByte(index + 1U);
        crc.AddWord(mapping.entries[index]);
    }
    return crc.Value();
}

/// [SRS_CFG_034]
DeviceDigest Channel::Digest(SlotIndex slot, DeviceDigest before) const noexcept
{
    const SrdoSetup& setup = Column<const SrdoSetup>{x_config->srdos}[slot];
    const Row& row = x_storage.rows[slot];
    Crc32 crc{before.value};
    if (slot == 0U)
    {
        AddDevice(crc, *x_config, x_storage.device[kGfcParameterAt]);
    }
    crc.AddByte(setup.number);
    crc.AddByte(static_cast<std::uint32_t>(row.policy));
    crc.AddByte(static_cast<std::uint32_t>(row.form));
    crc.AddByte(static_cast<std::uint32_t>(row.detection));
    crc.AddByte(ByteAt(row, kTransmissionTypeAt));
    crc.AddWord(setup.safe_value.low);
    crc.AddWord(setup.safe_value.high);
    return DeviceDigest{crc.Value()};
}

} // namespace counterpoint::channel_b
