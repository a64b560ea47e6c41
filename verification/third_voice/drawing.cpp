// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/third_voice/drawing.hpp"

#include "verification/third_voice/rig.hpp"

#include <algorithm>

namespace counterpoint::third_voice
{
namespace
{
/// Of 8, 16 and 32 bits, to send and to receive, a normal and an inverse side.
void AddObjects(Drawing& drawing)
{
    for (const MapAccess access : {MapAccess::kProducer, MapAccess::kConsumer})
    {
        const auto base = static_cast<std::uint16_t>((access == MapAccess::kProducer) ? 0x2000U : 0x2200U);
        for (const std::uint16_t side : {std::uint16_t{0U}, std::uint16_t{0x100U}})
        {
            for (std::uint8_t sub = 1U; sub <= 6U; ++sub)
            {
                const std::uint8_t bits = (sub <= 2U) ? 8U : ((sub <= 4U) ? 16U : 32U);
                drawing.objects.push_back({static_cast<std::uint16_t>(base + side), sub, bits, access, nullptr});
            }
        }
    }
    std::sort(drawing.objects.begin(), drawing.objects.end(),
              [](const MappableObject& left, const MappableObject& right)
              { return left.index != right.index ? left.index < right.index : left.sub < right.sub; });
}

/// At the edge of what half an interval with half of the tolerance leaves, less a late cycle's share.
constexpr std::uint32_t kMostPartsPerMillion = 1700U;

/// Limits between the cycle time and a late cycle: more than one of them runs out between two calls.
void MakeDense(Dice& dice, Drawing& drawing)
{
    const DeviceConfig& config = drawing.config;
    const std::uint32_t least = config.cycle_us / 1000U;
    const std::uint32_t most = (config.cycle_us + config.cycle_tolerance_us) / 1000U;
    drawing.is_dense = true;
    for (std::uint32_t& sct : drawing.scts)
    {
        sct = std::max<std::uint32_t>(2U, least + dice.Below(most - least + 1U));
    }
}

/// What falls due at the instant of a call for one counter comes a call later for the other, and nowhere else.
void AlignToCalls(Dice& dice, Drawing& drawing)
{
    const std::uint32_t cycle_ms = drawing.config.cycle_us / 1000U;
    if (dice.Chance(80U))
    {
        drawing.config.node_id = static_cast<std::uint8_t>(2U * cycle_ms * (1U + dice.Below(12U / cycle_ms)));
    }
    for (std::uint32_t& sct : drawing.scts)
    {
        sct = (dice.Chance(80U) && !drawing.is_dense) ? cycle_ms * (sct / cycle_ms) : sct;
    }
    for (SrdoSetup& setup : drawing.setups)
    {
        setup.form = dice.Chance(90U) ? ProducerForm::kProviderCalled : setup.form;
    }
}
} // namespace

Drift AnyDrift(Dice& dice, const Drawing& drawing)
{
    if (drawing.is_dense && dice.Chance(70U))
    {
        const Time most = Time{200U + dice.Below(kMostPartsPerMillion - 200U)};
        return {dice.Chance(50U) ? most : -most, 0, 0};
    }
    if (dice.Chance(40U))
    {
        return {0, dice.Pick<Time>({-1, 1}), Time{5000U + dice.Below(60000U)}};
    }
    const Time parts = dice.Pick<Time>({1, 10, 50, 100, Time{1U + dice.Below(100U)}});
    return {dice.Chance(50U) ? parts : -parts, 0, 0};
}

Drawing Draw(Dice& dice, const bool is_asked, const Pace pace)
{
    Drawing drawing{};
    DeviceConfig& config = drawing.config;
    const auto count = static_cast<std::uint8_t>(1U + dice.Below(3U));
    for (std::uint8_t number = 1U; number <= count; ++number)
    {
        SrdoSetup setup{};
        setup.number = number;
        setup.policy = dice.Chance(50U) ? ReleasePolicy::kInterlock : ReleasePolicy::kAutomatic;
        setup.form = dice.Chance(60U) ? ProducerForm::kProviderCalled : ProducerForm::kApplicationSends;
        setup.detection = dice.Chance(50U) ? SrvtDetection::kLate : SrvtDetection::kEarly;
        setup.safe_value = {0x5AU, 0U};
        drawing.scts.push_back(10U + dice.Below(40U));
        drawing.setups.push_back(setup);
    }
    AddObjects(drawing);
    config.srdo_count = count;
    config.node_id = static_cast<std::uint8_t>(1U + dice.Below(127U));
    config.granularity_bits = 8U;
    config.map_entries = Rig::kEntries;
    config.dummies = DummyMapping::kRefused;
    config.gaps = NumberGaps::kRefused;
    config.gfc = GfcUse::kPresent;
    config.normal_port = CanPortId::kFirst;
    config.inverse_port = CanPortId::kFirst;
    const bool is_dense = dice.Chance(20U);
    config.cycle_us = is_dense ? dice.Pick({2000U, 5000U}) : dice.Pick({1000U, 2000U, 5000U});
    config.cycle_tolerance_us = config.cycle_us / 2U;
    drawing.window_cycles = dice.Pick({5U, 10U, 40U});
    config.discrepancy_us = dice.Pick<std::uint32_t>({5U, is_asked ? 20U : drawing.window_cycles}) * config.cycle_us;
    config.acknowledge_window_us = drawing.window_cycles * config.cycle_us;
    config.diagnostic_interval_us = 40U * config.cycle_us;
    config.test_interval_us = 30U * config.cycle_us;
    config.clock_tolerance_us = 200U;
    config.clock_interval_us = 100000U;
    config.output_time_us = 1000U;
    if (is_dense)
    {
        MakeDense(dice, drawing);
    }
    if (pace == Pace::kDrifting)
    {
        AlignToCalls(dice, drawing);
    }
    return drawing;
}
} // namespace counterpoint::third_voice
