// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The third voice beside kernel and channels over drawn sequences: the same on host and target. The line that begins
// with "run=" must be the same on both. [SRS_ZYN_016]
#include "verification/target/gtest/memory.hpp"
#include "verification/target/target.hpp"
#include "verification/third_voice/sequence.hpp"

extern "C" std::uint32_t TargetMain() noexcept;

namespace
{
using namespace counterpoint;

constexpr std::uint32_t kSequences = 300U;
constexpr std::uint64_t kSeed = 1U;
constexpr std::uint32_t kFactor = 16777619U; // FNV-1a, a word at a time.

void Add(std::uint32_t& hash, const std::uint32_t word)
{
    hash = (hash ^ word) * kFactor;
}

void Tell(const char* const name, const std::uint32_t value)
{
    target::Write(" ");
    target::Write(name);
    target::Write("=");
    target::WriteNumber(value);
}

} // namespace

extern "C" std::uint32_t TargetMain() noexcept
{
    third_voice::SequenceResult sum;
    std::uint32_t differences = 0U;
    std::uint32_t hash = 2166136261U;
    for (std::uint32_t number = 0U; number < kSequences; ++number)
    {
        const std::size_t mark = target::MarkMemory();
        const third_voice::SequenceResult result = third_voice::RunSequence(kSeed + number);
        for (const std::uint32_t word : {result.steps, result.releases, result.faults, result.refusals})
        {
            Add(hash, word);
        }
        sum.steps += result.steps;
        sum.releases += result.releases;
        sum.faults += result.faults;
        sum.refusals += result.refusals;
        if (!result.is_equal)
        {
            ++differences;
            target::Write("failed: ");
            target::Write(result.difference.c_str());
            target::Write("\n");
        }
        target::ReleaseMemory(mark);
    }
    target::Write("run=third_voice");
    Tell("cases", kSequences);
    Tell("failures", differences);
    target::Write(" hash=");
    target::WriteHex(hash);
    Tell("steps", sum.steps);
    Tell("releases", sum.releases);
    Tell("causes", sum.faults);
    Tell("refusals", sum.refusals);
    target::Write("\n");
    return (differences == 0U) ? 0U : 1U;
}
