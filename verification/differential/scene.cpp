// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/differential/scene.hpp"

namespace counterpoint::differential
{

void Scene::MakeDevice() noexcept
{
    device.Make(random);
    request = 0U;
    stand = 0U;
    configured = 0U;
    configuration_valid = 0U;
    nmt = NmtState::kPreOperational;
    has_odd_mapping = false;
}

/// One sequence in four runs across the wrap of the counter.
void Scene::StartClock() noexcept
{
    clock_us = random.Chance(250U) ? (0U - random.Below(60000U)) : random.Next();
    now_us = clock_us;
    for (std::uint32_t& stamp : last_us)
    {
        stamp = clock_us;
    }
}

SlotIndex Scene::AnySlot() noexcept
{
    return static_cast<SlotIndex>(random.Below(device.config_a.srdo_count));
}

Payload Scene::AnyData() noexcept
{
    return Payload{random.Next(), random.Next()};
}

CanFrame Scene::FrameOf(SlotIndex slot, bool is_inverse, const Payload& data) const noexcept
{
    const SlotPlan& plan = device.plans[slot];
    CanFrame frame{is_inverse ? plan.cob_id_2 : plan.cob_id_1,
                   FrameKind::kData,
                   is_inverse ? device.config_a.inverse_port : device.config_a.normal_port,
                   BytesOf((plan.bits <= kMaxPayloadBits) ? plan.bits : kMaxPayloadBits),
                   {}};
    for (std::uint32_t i = 0U; i < kMaxPayloadBytes; ++i)
    {
        const std::uint32_t half = (i < 4U) ? data.low : data.high;
        frame.data[i] = static_cast<std::uint8_t>((half >> (8U * (i % 4U))) & 0xFFU);
    }
    if (frame.length_bytes != 0U)
    {
        const std::uint8_t mask = LastByteMask(plan.bits);
        std::uint8_t& last = frame.data[frame.length_bytes - 1U];
        last = static_cast<std::uint8_t>(is_inverse ? (last | (0xFFU ^ mask)) : (last & mask));
    }
    return frame;
}

/// The bus moves on by less than `most_us`.
void Scene::LetTimePass(std::uint32_t most_us) noexcept
{
    clock_us += random.Below(most_us + 1U);
}

/// The bus moves on to one of the limits of `slot`, or one microsecond before or behind it, if that lies ahead and
/// near.
void Scene::GoNear(SlotIndex slot) noexcept
{
    const SlotPlan& plan = device.plans[slot];
    const std::uint32_t ms = random.Chance(500U) ? plan.sct_ms : plan.srvt_ms;
    const std::uint32_t limit = last_us[slot] + (ms * kMicrosecondsPerMillisecond) + random.Below(3U) - 1U;
    const std::uint32_t ahead = limit - clock_us;
    // Mostly within the time in which a call is not late.
    const std::uint32_t room = (now_us + device.config_a.cycle_us + device.config_a.cycle_tolerance_us) - clock_us;
    const bool is_near = (room < 0x80000000U) && (ahead <= room);
    if (is_near || ((ahead <= 60000U) && random.Chance(100U)))
    {
        clock_us = limit;
    }
}

} // namespace counterpoint::differential
