// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/proof/runs.hpp"

#include <memory>

namespace counterpoint::proof
{

namespace
{
constexpr std::uint32_t kBaseUs = 0x40000000U;
constexpr std::uint32_t kBeforeWrapUs = 0xFFFFE000U; ///< Eight cycles.
constexpr std::uint64_t kMostStates = 60000000U;
constexpr std::uint32_t kMostTwins = 2U;
constexpr std::uint32_t kUntilClosed = 100U;
} // namespace

std::vector<Exploration> ExplorationsOf(const bool is_long)
{
    if (is_long)
    {
        return {{"all", Sight::kShown, kUntilClosed, false},
                {"timing", Sight::kBytes, 10U, false},
                {"frames", Sight::kBytes, 9U, false},
                {"calls", Sight::kBytes, 8U, false},
                {"all", Sight::kBytes, 6U, false}};
    }
    return {{"timing", Sight::kShown, kUntilClosed, false}, {"timing", Sight::kShown, kUntilClosed, true},
            {"calls", Sight::kShown, kUntilClosed, false},  {"frames", Sight::kShown, kUntilClosed, false},
            {"timing", Sight::kBytes, 7U, false},           {"all", Sight::kBytes, 4U, false}};
}

std::vector<ConsumerSetup> MakeSetups()
{
    return {{ReleasePolicy::kInterlock, SrvtDetection::kEarly},
            {ReleasePolicy::kInterlock, SrvtDetection::kLate},
            {ReleasePolicy::kAutomatic, SrvtDetection::kEarly},
            {ReleasePolicy::kAutomatic, SrvtDetection::kLate}};
}

std::string NameOf(const ConsumerSetup& setup)
{
    return std::string{(setup.policy == ReleasePolicy::kAutomatic) ? "automatic" : "interlock"} +
           ((setup.detection == SrvtDetection::kLate) ? ", late" : ", early");
}

Result RunExploration(const Exploration& exploration, const ConsumerSetup& setup, Between* const around_a,
                      Between* const around_b)
{
    const auto world = std::make_unique<World>(setup, around_a, around_b);
    for (const Domain& domain : MakeDomains())
    {
        if (domain.name == exploration.domain)
        {
            const Reach reach{exploration.depth, kMostStates, exploration.is_wrapping ? kBeforeWrapUs : kBaseUs,
                              exploration.sight, kMostTwins};
            return Explorer{*world, domain, reach}.Run();
        }
    }
    Result unknown;
    unknown.refused = "no domain of this name: " + exploration.domain;
    return unknown;
}

} // namespace counterpoint::proof
