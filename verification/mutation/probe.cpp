// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What a mutant has to get past: conformance cases, corrupted storage, differential run. Prints one line for each part
// and stops at the first that fails; exit status 1 then. Linked once for each mutant by run.py.
#include "verification/conformance/flip_rig.hpp"
#include "verification/conformance/runner.hpp"
#include "verification/differential/differential.hpp"

#include <cinttypes>
#include <cstdio>
#include <memory>

namespace counterpoint
{
namespace
{

constexpr std::uint32_t kSequences = 4000U;
constexpr std::uint32_t kSeed = 1U;

class Listener final : public conformance::Reporter
{
  public:
    void OnFailure(const conformance::Failure& failure) noexcept override
    {
        if (name == nullptr)
        {
            name = failure.case_name;
        }
    }

    const char* name{nullptr};
};

class Silent final : public differential::Observer
{
  public:
    void OnStep(const differential::StepRecord& /*record*/) noexcept override
    {
    }
    void OnDifference(const differential::Difference& difference) noexcept override
    {
        std::printf("killed: differential, sequence %u, %s\n", difference.sequence, difference.field);
    }
};

bool PassesConformance(Channel& channel, conformance::Party party)
{
    Listener listener;
    const auto runner = std::make_unique<conformance::Runner>(channel, party, listener);
    const conformance::RunResult result = conformance::RunConformance(*runner);
    if (result.failures != 0U)
    {
        std::printf("killed: conformance, %u of %u, first %s\n", result.failures, result.cases, listener.name);
    }
    return result.failures == 0U;
}

bool PassesDifferential(Channel& a, Channel& b)
{
    Silent silent;
    const auto run = std::make_unique<differential::Differential>(a, b, silent);
    return differential::RunDifferential(*run, kSeed, 0U, kSequences, 1U).failures == 0U;
}

/// A device of each kind, and either policy.
struct Rig
{
    conformance::RigKind kind;
    ReleasePolicy policy;
};

constexpr Rig kRigs[] = {{conformance::RigKind::kBytes, ReleasePolicy::kAutomatic},
                         {conformance::RigKind::kBytes, ReleasePolicy::kInterlock},
                         {conformance::RigKind::kFixed, ReleasePolicy::kAutomatic},
                         {conformance::RigKind::kBits, ReleasePolicy::kInterlock}};

bool PassesFlips(conformance::Party party)
{
    for (std::uint32_t phase = 0U; phase < conformance::kPhaseCount; ++phase)
    {
        for (const Rig& rig : kRigs)
        {
            const conformance::FlipResult result = conformance::FlipEveryBit(party, rig.policy, phase, rig.kind);
            if ((result.complaints != 0U) || (result.granted != result.runs))
            {
                std::printf("killed: corrupted storage, phase %u, %s\n", phase, result.first.c_str());
                return false;
            }
        }
    }
    return true;
}

/// The differential run is asked for by any argument, so that each mutant shows which of both kills it.
int Main(bool is_differential_only)
{
    const auto storage_a = std::make_unique<channel_a::StorageFor<kMaxSrdoCount, kMaxMapEntries>>();
    const auto storage_b = std::make_unique<channel_b::StorageFor<kMaxSrdoCount, kMaxMapEntries>>();
    channel_a::Channel a{storage_a->Handle()};
    channel_b::Channel b{storage_b->Handle()};
    if (is_differential_only)
    {
        return PassesDifferential(a, b) ? 0 : 1;
    }
    const bool passes = PassesConformance(a, conformance::Party::kA) && PassesConformance(b, conformance::Party::kB) &&
                        PassesFlips(conformance::Party::kA) && PassesFlips(conformance::Party::kB);
    return passes ? 0 : 1;
}

} // namespace
} // namespace counterpoint

int main(int argc, char** /*argv*/)
{
    return counterpoint::Main(argc > 1);
}
