// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/third_voice/sequence.hpp"
#include "verification/trace/ids/verification.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::third_voice
{
namespace
{
constexpr std::uint64_t kSequences = 10000U;

std::uint32_t DifferencesIn(const std::uint64_t sequences, const Flaw flaw)
{
    std::uint32_t differences = 0U;
    for (std::uint64_t seed = 1U; seed <= sequences; ++seed)
    {
        differences += RunSequence(seed, flaw).is_equal ? 0U : 1U;
    }
    return differences;
}

/// Within the sequences of the comparison.
bool IsTold(const Flaw flaw)
{
    bool is_told = false;
    for (std::uint64_t seed = 1U; seed <= kSequences && !is_told; ++seed)
    {
        is_told = !RunSequence(seed, flaw).is_equal;
    }
    return is_told;
}

TEST(ThirdVoice, KernelAndChannelsDoWhatTheSemanticsSay)
{
    Verifies(req::SRS_VER_032);
    std::uint32_t releases = 0U;
    std::uint32_t faults = 0U;
    for (std::uint64_t seed = 1U; seed <= kSequences; ++seed)
    {
        const SequenceResult result = RunSequence(seed);
        ASSERT_TRUE(result.is_equal) << result.story << "seed " << seed << ": " << result.difference;
        releases += result.releases;
        faults += result.faults;
    }
    // Sequences in which nothing happens would show nothing.
    EXPECT_GT(releases, 150000U);
    EXPECT_GT(faults, 150000U);
}

TEST(ThirdVoice, AModelWithOneBrokenRuleIsTold)
{
    Verifies(req::SRS_VER_032);
    EXPECT_GT(DifferencesIn(200U, Flaw::kSctLonger), 0U);
    EXPECT_GT(DifferencesIn(200U, Flaw::kSrvtLonger), 0U);
    EXPECT_GT(DifferencesIn(200U, Flaw::kNoInversion), 0U);
    EXPECT_GT(DifferencesIn(200U, Flaw::kNoSignature), 0U);
    EXPECT_GT(DifferencesIn(200U, Flaw::kKeepsReleased), 0U);
    EXPECT_GT(DifferencesIn(200U, Flaw::kEdgeAtOnce), 0U);
    EXPECT_GT(DifferencesIn(200U, Flaw::kOneEdgeIsEnough), 0U);
    EXPECT_GT(DifferencesIn(200U, Flaw::kToldAlways), 0U);
    EXPECT_GT(DifferencesIn(200U, Flaw::kRefreshDrifts), 0U);
    EXPECT_GT(DifferencesIn(200U, Flaw::kSharedObjects), 0U);
    EXPECT_GT(DifferencesIn(200U, Flaw::kRefreshSkipped), 0U);
    EXPECT_GT(DifferencesIn(200U, Flaw::kRequestAlone), 0U);
    EXPECT_GT(DifferencesIn(200U, Flaw::kNothingStands), 0U);
    EXPECT_GT(DifferencesIn(200U, Flaw::kHalfConfirmed), 0U);
}

TEST(ThirdVoice, ARarerRuleThatIsBrokenIsTold)
{
    Verifies(req::SRS_VER_032);
    EXPECT_TRUE(IsTold(Flaw::kBehindFault));
    EXPECT_TRUE(IsTold(Flaw::kMissesStanding));
    EXPECT_TRUE(IsTold(Flaw::kLateIsInTime));
    EXPECT_TRUE(IsTold(Flaw::kSilenceShorter));
    EXPECT_TRUE(IsTold(Flaw::kSilenceLonger));
    EXPECT_TRUE(IsTold(Flaw::kGfcPutOff));
    EXPECT_TRUE(IsTold(Flaw::kGfcFromCycle));
    EXPECT_TRUE(IsTold(Flaw::kGfcAtOnce));
    EXPECT_TRUE(IsTold(Flaw::kGfcFollowed));
    EXPECT_TRUE(IsTold(Flaw::kMissedInLevel2));
    EXPECT_TRUE(IsTold(Flaw::kEntersInLevel2));
    EXPECT_TRUE(IsTold(Flaw::kSentInLevel2));
    EXPECT_TRUE(IsTold(Flaw::kKeepsInLevel2));
}
} // namespace
} // namespace counterpoint::third_voice
