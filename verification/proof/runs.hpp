// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_PROOF_RUNS_HPP
#define VERIFICATION_PROOF_RUNS_HPP

#include "verification/proof/explorer.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::proof
{

/// One exploration: what it looks at, and how far.
struct Exploration
{
    std::string domain;
    Sight sight;
    std::uint32_t depth; ///< Letters; it ends before that where nothing new comes.
    bool is_wrapping;    ///< The counter passes its end on the way.
};

/// @brief Under each release policy and detection of SRVT. Those that ./dev verify runs, or the long ones.
[[nodiscard]] std::vector<Exploration> ExplorationsOf(bool is_long);
[[nodiscard]] std::vector<ConsumerSetup> MakeSetups();
[[nodiscard]] std::string NameOf(const ConsumerSetup& setup);
/// @brief `around` stands in front of each channel, where it is not null.
[[nodiscard]] Result RunExploration(const Exploration& exploration, const ConsumerSetup& setup, Between* around_a,
                                    Between* around_b);

} // namespace counterpoint::proof

#endif
