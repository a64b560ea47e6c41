// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/crc.hpp"
#include "channel_a/rules.hpp"

// What the signature does not cover. [SRS_CFG_034]
namespace counterpoint::channel_a
{
namespace
{

// In place of a copy that is not what the description has: no controller, and nothing that grants, is coded so.
constexpr std::uint32_t kDiffers = 0xFFU;

// One byte: the value that grants something, or 00h for any other.
template <typename Option> void AddGranted(Crc32& crc, const Option value, const Option granting) noexcept
{
    crc.AddByte((value == granting) ? static_cast<std::uint32_t>(granting) : 0U);
}

void AddDevice(Crc32& crc, const Voice& voice) noexcept
{
    const DeviceConfig& config = *voice.config;
    crc.AddByte(config.node_id);
    crc.AddByte(config.granularity_bits);
    AddGranted(crc, config.dummies, DummyMapping::kAllowed);
    AddGranted(crc, config.gaps, NumberGaps::kSearched);
    AddGranted(crc, config.gfc, GfcUse::kPresent);
    // The kernel reads this one, and the form below, in the description, where the channel has a copy. [SRS_CFG_800]
    const CanPortId normal = voice.ports[kNormalHalf];
    crc.AddByte((normal == config.normal_port) ? static_cast<std::uint32_t>(normal) : kDiffers);
    crc.AddByte(static_cast<std::uint32_t>(voice.ports[kInverseHalf]));
    crc.AddWord(config.cycle_us);
    crc.AddWord(config.cycle_tolerance_us);
    crc.AddWord(config.discrepancy_us);
    crc.AddWord(config.acknowledge_window_us);
    crc.AddWord(config.diagnostic_interval_us);
    crc.AddWord(config.test_interval_us);
    crc.AddWord(config.clock_tolerance_us);
    crc.AddWord(config.clock_interval_us);
    crc.AddWord(config.output_time_us);
    crc.AddByte(voice.gfc_parameter);
}

} // namespace

// A policy whose complement is not beside it is automatic to nobody.
DeviceDigest DigestOf(const Voice& voice, const std::size_t slot, const DeviceDigest before) noexcept
{
    const Record& record = At(voice, slot);
    const SrdoSetup& setup = voice.config->srdos[slot]; // MISRA D-002
    const std::uint8_t automatic = static_cast<std::uint8_t>(ReleasePolicy::kAutomatic);
    const Payload safe = PayloadOf(record.safe);
    Crc32 crc{before.value};
    if (slot == 0U)
    {
        AddDevice(crc, voice);
    }
    crc.AddByte(setup.number);
    crc.AddByte(record.grants.Is(Grant::kPolicy, automatic) ? automatic : std::uint32_t{0U});
    if (record.form == setup.form)
    {
        AddGranted(crc, record.form, ProducerForm::kProviderCalled);
    }
    else
    {
        crc.AddByte(kDiffers); // [SRS_CFG_800]
    }
    AddGranted(crc, record.detection, SrvtDetection::kLate);
    crc.AddByte(record.values.transmission_type);
    crc.AddWord(safe.low);
    crc.AddWord(safe.high);
    return DeviceDigest{crc.Value()};
}

} // namespace counterpoint::channel_a
