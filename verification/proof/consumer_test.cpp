// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/proof/planted.hpp"
#include "verification/proof/runs.hpp"
#include "verification/trace/ids/verification.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::proof
{
namespace
{

constexpr ConsumerSetup kInterlockEarly{ReleasePolicy::kInterlock, SrvtDetection::kEarly};
constexpr ConsumerSetup kAutomaticEarly{ReleasePolicy::kAutomatic, SrvtDetection::kEarly};
constexpr ConsumerSetup kInterlockLate{ReleasePolicy::kInterlock, SrvtDetection::kLate};
using Story = std::vector<std::string>;

/// A defect in both channels alike, so that no comparison of the two sees it.
template <typename Defect>
Result RunBoth(const char* const domain, const ConsumerSetup& setup, const std::uint32_t depth)
{
    Planted<Defect> a;
    Planted<Defect> b;
    return RunExploration({domain, Sight::kShown, depth, false}, setup, &a, &b);
}

TEST(ProofOfConsumer, EverySequenceOfCallsUnderEachPolicy)
{
    Verifies(req::SRS_VER_118);
    Verifies(req::SRS_VER_340);
    for (const ConsumerSetup& setup : {kInterlockLate, kAutomaticEarly})
    {
        const Result result = RunExploration({"calls", Sight::kShown, 100U, false}, setup, nullptr, nullptr);
        EXPECT_EQ(result.refused, "") << NameOf(setup);
        EXPECT_TRUE(result.is_closed);
        EXPECT_GT(result.states, 10000U);
        EXPECT_GT(result.releases, 200U);
        EXPECT_GT(result.faults, 8000U);
        EXPECT_GT(result.twins, 10000U);
    }
}

TEST(ProofOfConsumer, EverySequenceOfTimesWhileTheCounterWraps)
{
    Verifies(req::SRS_VER_118);
    Verifies(req::SRS_VER_340);
    for (const bool is_wrapping : {false, true})
    {
        const Result result =
            RunExploration({"timing", Sight::kShown, 100U, is_wrapping}, kInterlockEarly, nullptr, nullptr);
        EXPECT_EQ(result.refused, "");
        EXPECT_TRUE(result.is_closed);
        EXPECT_GT(result.states, 10000U);
    }
}

TEST(ProofOfConsumer, ByItsBytesToADepth)
{
    Verifies(req::SRS_VER_118);
    Verifies(req::SRS_VER_340);
    const Result result = RunExploration({"all", Sight::kBytes, 3U, false}, kInterlockLate, nullptr, nullptr);
    EXPECT_EQ(result.refused, "");
    EXPECT_EQ(result.depth, 3U);
    EXPECT_GT(result.states, 1000U);
}

TEST(ProofOfConsumer, RefusesAChannelThatSkipsSrvt)
{
    Verifies(req::SRS_VER_119);
    const Result result = RunBoth<SkipsSrvt>("timing", kInterlockEarly, 6U);
    EXPECT_EQ(result.refused, "fault not latched, cause 5");
    EXPECT_EQ(result.story, (Story{"call", "normal", "call", "inverse +1"}));
}

TEST(ProofOfConsumer, RefusesAChannelThatReleasesWithoutAcknowledge)
{
    Verifies(req::SRS_VER_119);
    const Result result = RunBoth<ReleasesAlone>("calls", kInterlockEarly, 6U);
    EXPECT_EQ(result.refused, "released without acknowledge");
    EXPECT_EQ(result.story, (Story{"call, not OPERATIONAL", "call", "normal", "inverse", "call"}));
}

TEST(ProofOfConsumer, RefusesWhatIsHiddenFromTheKey)
{
    Verifies(req::SRS_VER_119);
    const Result result = RunBoth<RemembersRemote>("frames", kInterlockEarly, 6U);
    EXPECT_EQ(result.refused, "fault not latched, cause 2");
    EXPECT_EQ(result.story, (Story{"normal, remote", "call", "inverse"}));
}

TEST(ProofOfConsumer, RefusesADefectOfOneChannelAlone)
{
    Verifies(req::SRS_VER_119);
    Planted<SkipsSrvt> b;
    const Result result = RunExploration({"timing", Sight::kShown, 6U, false}, kInterlockEarly, nullptr, &b);
    EXPECT_EQ(result.refused, "channels differ in what they show");
}

} // namespace
} // namespace counterpoint::proof
