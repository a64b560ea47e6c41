// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Flipped bits in the storage of each channel, instrumented: what only a corrupted storage reaches. How the storage
// lies in memory differs between target and host, and with it how often something is reached, not whether. [SRS_FW_010]
#include "verification/conformance/flip_rig.hpp"
#include "verification/target/coverage/profile.hpp"
#include "verification/target/gtest/memory.hpp"
#include "verification/target/target.hpp"

extern "C" std::uint32_t TargetMain() noexcept;

namespace
{

using counterpoint::ReleasePolicy;
using counterpoint::conformance::FlipResult;
using counterpoint::conformance::Party;
using counterpoint::conformance::RigKind;

/// Flips in one phase of operation.
struct Flips
{
    Party party;
    ReleasePolicy policy;
    std::uint32_t phase;
    RigKind kind;
};

constexpr Flips kFlips[]{
    {Party::kA, ReleasePolicy::kAutomatic, 6U, RigKind::kFixed},
    {Party::kB, ReleasePolicy::kAutomatic, 6U, RigKind::kFixed},
    {Party::kB, ReleasePolicy::kInterlock, 4U, RigKind::kBytes},
};

[[nodiscard]] bool IsGood(const FlipResult& result) noexcept
{
    return (result.runs != 0U) && (result.granted != 0U) && (result.complaints == 0U);
}

} // namespace

extern "C" std::uint32_t TargetMain() noexcept
{
    using namespace counterpoint;
    bool is_good = true;
    for (const Flips& flips : kFlips)
    {
        const std::size_t before = target::MarkMemory();
        is_good = IsGood(conformance::FlipEveryBit(flips.party, flips.policy, flips.phase, flips.kind)) && is_good;
        target::ReleaseMemory(before);
    }
    for (const Party party : {Party::kA, Party::kB})
    {
        const std::size_t before = target::MarkMemory();
        is_good = IsGood(conformance::FlipSignedEntries(party, RigKind::kBytes)) && is_good;
        target::ReleaseMemory(before);
    }
    const bool is_written = target::WriteProfile(target::Argument());
    target::Write((is_good && is_written) ? "flips: done\n" : "FAILURE: flips\n");
    return (is_good && is_written) ? 0U : 1U;
}
