// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/differential/differential.hpp"

namespace counterpoint::differential
{

namespace
{
constexpr std::uint32_t kLeastSteps = 24U;
constexpr std::uint32_t kMostSteps = 48U;
} // namespace

Differential::Differential(Channel& a, Channel& b, Observer& observer) noexcept
    : scene_{a, b}, comparison_{scene_, observer}, producer_{scene_, comparison_},
      cycle_{scene_, comparison_, producer_}, consumer_{scene_, comparison_, cycle_},
      configuration_{scene_, comparison_, cycle_}
{
}

bool Differential::RunSequence(std::uint32_t seed, std::uint32_t number) noexcept
{
    comparison_.Begin(seed, number);
    scene_.random.Start(seed, number);
    StartSequence();
    configuration_.Configure();
    const std::uint32_t rounds = scene_.random.Between(kLeastSteps, kMostSteps);
    for (std::uint32_t round = 0U; (round < rounds) && (!comparison_.Differs()); ++round)
    {
        const std::uint32_t kind = scene_.random.Below(1000U);
        if (kind < 430U)
        {
            cycle_.Step();
        }
        else if (kind < 830U)
        {
            consumer_.Step();
        }
        else if (kind < 950U)
        {
            producer_.Step();
        }
        else if (kind < 970U)
        {
            configuration_.Recheck(scene_.AnySlot());
        }
        else
        {
            configuration_.Reconfigure();
        }
    }
    configuration_.Digest();
    ++sequences_;
    steps_ += comparison_.Steps();
    failures_ += comparison_.Differs() ? 1U : 0U;
    return !comparison_.Differs();
}

void Differential::StartSequence() noexcept
{
    scene_.MakeDevice();
    cycle_.Begin();
    scene_.StartClock();
    const Device& device = scene_.device;
    comparison_.Step("Restart: SRDOs, node-ID, cycle", kNoSlot, device.config_a.srdo_count, device.config_a.node_id,
                     device.config_a.cycle_us);
    scene_.a.Restart(device.config_a);
    scene_.b.Restart(device.config_b);
    comparison_.AllSlots();
}

DifferentialResult RunDifferential(Differential& run, std::uint32_t seed, std::uint32_t first, std::uint32_t count,
                                   std::uint32_t most_failures) noexcept
{
    for (std::uint32_t i = 0U; (i < count) && (run.Result().failures < most_failures); ++i)
    {
        static_cast<void>(run.RunSequence(seed, first + i));
    }
    return run.Result();
}

} // namespace counterpoint::differential
