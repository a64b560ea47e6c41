// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_ELECTIONS_WORLD_PLAN_HPP
#define VERIFICATION_ELECTIONS_WORLD_PLAN_HPP

#include "canopen/cia302/flying_master/flying_master.hpp"
#include "verification/elections/bus.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace counterpoint::elections
{

/// One flying master of a run.
struct MasterPlan
{
    cia302::NodeId node;
    cia302::FlyingMasterTimes times;
    Time power_on;                                        ///< Its application calls Start at once.
    Time phase;                                           ///< Of its cycle, below WorldPlan::cycle.
    Time clock_ppm{0};                                    ///< How much faster its clock goes than that of the world.
    std::uint32_t clock_begin{0U};                        ///< Its counter at the beginning of the world.
    std::optional<cia302::FlyingMasterOptions> options{}; ///< Its own; else those of the WorldPlan.
};

/// Which complete frame is lost, counted from 0, and for whom.
struct Loss
{
    static constexpr std::uint32_t kNoFrame = 0xFFFFFFFFU;
    static constexpr std::size_t kEverybody = SIZE_MAX;
    std::uint32_t frame{kNoFrame};
    std::size_t receiver{kEverybody};
};

/// What all runs of a series have in common.
struct WorldPlan
{
    cia302::FlyingMasterOptions options;
    Time cycle{kMs};
    Time bit_us{8};
    Time heartbeat{1000 * kMs}; ///< Of the active master; its consumers wait for options.watch_ms.
    bool has_managers{false};   ///< Each device is a whole network manager, with a network without slaves.
    bool polls{false};          ///< Frames are handled in the next cycle, not when they are complete.
    Time traffic_gap{0};        ///< Frames of other services with 8 bytes, this apart in the mean; 0: none.
    std::uint64_t traffic_seed{0U};
};

} // namespace counterpoint::elections

#endif
