// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Elections in which masters behave as other makes do, all of them or some.
#include "verification/elections/series.hpp"

namespace counterpoint::elections
{
namespace
{

using cia302::FlyingMasterOptions;

/// Each option once away from the preset. claim_heard: ignores is not among them: two masters then last as long as the
/// cyclic message lets them. Nor is standby: races with cyclic 072h, which never comes to rest.
std::vector<FlyingMasterOptions> VariantsOf(const FlyingMasterOptions& preset)
{
    std::vector<FlyingMasterOptions> all{};
    const auto add = [&](const auto& change)
    {
        FlyingMasterOptions options = preset;
        change(options);
        all.push_back(options);
    };
    add([](FlyingMasterOptions& options) { options.on_force = cia302::ForceReaction::kRace; });
    add([](FlyingMasterOptions& options) { options.on_force = cia302::ForceReaction::kRestart; });
    add([](FlyingMasterOptions& options) { options.equal_level = cia302::EqualLevel::kLowerNodeForces; });
    add([](FlyingMasterOptions& options) { options.on_loss = cia302::LossReaction::kResetAll; });
    add([](FlyingMasterOptions& options) { options.on_loss = cia302::LossReaction::kRace; });
    add([](FlyingMasterOptions& options) { options.standby = cia302::StandbyReaction::kIgnores; });
    add([](FlyingMasterOptions& options) { options.standby = cia302::StandbyReaction::kAsks; });
    add([](FlyingMasterOptions& options) { options.cyclic = cia302::CyclicMessage::kForce; });
    add([](FlyingMasterOptions& options) { options.cyclic = cia302::CyclicMessage::kNegotiation; });
    add([](FlyingMasterOptions& options) { options.negotiates_pre_operational = true; });
    add([](FlyingMasterOptions& options) { options.keeps_slot = true; });
    add([](FlyingMasterOptions& options) { options.answers_boot_up = true; });
    add([](FlyingMasterOptions& options) { options.max_restarts = 1U; });
    if (preset.cyclic == cia302::CyclicMessage::kForce)
    {
        add([](FlyingMasterOptions& options) { options.standby = cia302::StandbyReaction::kRaces; });
    }
    return all;
}

/// `who` has a bit for each master.
Tally RunAll(const Preset preset, const FlyingMasterOptions& options, const std::uint32_t who, const Losses losses)
{
    const Adapt adapt = [&](std::vector<MasterPlan>& masters, const std::uint64_t number)
    {
        static_cast<void>(number);
        for (std::size_t i = 0U; i < masters.size(); ++i)
        {
            if (((who >> i) & 1U) != 0U)
            {
                masters[i].options = options;
            }
        }
    };
    Tally tally = Combinations(preset, 2U, OffsetsOfTheText(), losses, adapt);
    tally.Add(Splits(preset, 2U, losses, adapt));
    if (losses != Losses::kNone)
    {
        tally.Add(Combinations(preset, 3U, OffsetsOfTheText(), Losses::kNone, adapt));
        tally.Add(Splits(preset, 3U, Losses::kNone, adapt));
    }
    return tally;
}

} // namespace

Tally Variants(const Preset preset, const Losses losses)
{
    constexpr std::uint32_t kAll = 7U;
    constexpr std::uint32_t kOdd = 5U;
    constexpr std::uint32_t kEven = 2U;
    const Preset other = (preset == Preset::kDefault) ? Preset::kSo1114 : Preset::kDefault;
    Tally tally = RunAll(preset, PlanOf(other).options, kEven, losses);
    for (const FlyingMasterOptions& options : VariantsOf(PlanOf(preset).options))
    {
        for (const std::uint32_t who : {kAll, kOdd, kEven})
        {
            tally.Add(RunAll(preset, options, who, losses));
        }
    }
    return tally;
}

} // namespace counterpoint::elections
