// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The device digest as SRS_CFG_034 says it, plain and bit after bit, with one part of it broken.
#include "verification/twins/broken_digest.hpp"

namespace counterpoint::twins
{

namespace
{

struct Item
{
    std::uint32_t value;
    std::uint32_t bytes;
};

template <typename T> std::uint32_t OnlyIf(T value, T counts)
{
    return (value == counts) ? static_cast<std::uint32_t>(counts) : 0U;
}

constexpr std::uint32_t kDeviceParts = 17U;
const char* const kParts[kDigestParts] = {"node-ID",
                                          "granularity",
                                          "dummies",
                                          "gaps",
                                          "use of the GFC",
                                          "normal controller",
                                          "inverse controller",
                                          "cycle time",
                                          "cycle tolerance",
                                          "discrepancy",
                                          "acknowledge time",
                                          "diagnosis",
                                          "test interval",
                                          "clock tolerance",
                                          "clock interval",
                                          "output time",
                                          "1300h",
                                          "number",
                                          "policy",
                                          "form",
                                          "detection",
                                          "transmission type",
                                          "lower safe value",
                                          "higher safe value"};
const char* const kBreaks[] = {" is left out", " is 0",        " forgets what came before",
                               " is one more", " is one less", " has its low byte only"};

void Collect(Item (&items)[kDigestParts], const DigestSource& source)
{
    const DeviceConfig& config = *source.config;
    const SrdoSetup& setup = config.srdos[source.slot];
    const Item all[kDigestParts] = {{config.node_id, 1U},
                                    {config.granularity_bits, 1U},
                                    {OnlyIf(config.dummies, DummyMapping::kAllowed), 1U},
                                    {OnlyIf(config.gaps, NumberGaps::kSearched), 1U},
                                    {OnlyIf(config.gfc, GfcUse::kPresent), 1U},
                                    {static_cast<std::uint32_t>(config.normal_port), 1U},
                                    {static_cast<std::uint32_t>(config.inverse_port), 1U},
                                    {config.cycle_us, 4U},
                                    {config.cycle_tolerance_us, 4U},
                                    {config.discrepancy_us, 4U},
                                    {config.acknowledge_window_us, 4U},
                                    {config.diagnostic_interval_us, 4U},
                                    {config.test_interval_us, 4U},
                                    {config.clock_tolerance_us, 4U},
                                    {config.clock_interval_us, 4U},
                                    {config.output_time_us, 4U},
                                    {source.gfc_parameter, 1U},
                                    {setup.number, 1U},
                                    {OnlyIf(setup.policy, ReleasePolicy::kAutomatic), 1U},
                                    {OnlyIf(setup.form, ProducerForm::kProviderCalled), 1U},
                                    {OnlyIf(setup.detection, SrvtDetection::kLate), 1U},
                                    {source.transmission_type, 1U},
                                    {setup.safe_value.low, 4U},
                                    {setup.safe_value.high, 4U}};
    for (std::uint32_t part = 0U; part < kDigestParts; ++part)
    {
        items[part] = all[part];
    }
}

} // namespace

std::string DigestRuleText(const DigestRule& rule)
{
    return std::string{"digest: "} + kParts[rule.part] + kBreaks[rule.broken];
}

DeviceDigest BrokenDigest(const DigestRule& rule, const DigestSource& source, DeviceDigest before)
{
    Item items[kDigestParts];
    Collect(items, source);
    std::uint32_t crc = ~before.value;
    for (std::uint32_t part = (source.slot == 0U) ? 0U : kDeviceParts; part < kDigestParts; ++part)
    {
        Item item = items[part];
        if (part == rule.part)
        {
            item.bytes = (rule.broken == 0U) ? 0U : ((rule.broken == 5U) ? 1U : item.bytes);
            item.value = (rule.broken == 1U) ? 0U : item.value;
            crc = (rule.broken == 2U) ? 0U : crc;
            item.value += (rule.broken == 3U) ? 1U : 0U;
            item.value -= (rule.broken == 4U) ? 1U : 0U;
        }
        for (std::uint32_t bit = 0U; bit < (8U * item.bytes); ++bit)
        {
            const std::uint32_t leaving = (crc ^ (item.value >> bit)) & 1U;
            crc = (crc >> 1U) ^ ((leaving != 0U) ? 0xEDB88320U : 0U);
        }
    }
    return DeviceDigest{~crc};
}

} // namespace counterpoint::twins
