// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/comparator/comparator.hpp"
#include "tests/safety_core/crosslink/peer_rig.hpp"
#include "verification/trace/ids/crosslink.hpp"
#include "verification/trace/ids/kernel.hpp"

#include <gtest/gtest.h>

namespace counterpoint
{
namespace
{

constexpr HeldPair kPair{Payload{0x1234U, 0x5678U}, 3U, 1U};

/// One CPU in contact whose comparator looks at both voices; both CPUs hold one pair, behind a fault that both had. A
/// message and a cycle every 10 ms; discrepancy time 50 ms, acknowledge window 200 ms.
class AcknowledgeSkew : public ::testing::TestWithParam<PeerRole>
{
  protected:
    void SetUp() override
    {
        comparator.Restart(ComparatorSetup{50000U, 200000U, 3U});
        rig.channel.digest_of.fill(0U); // As the peer's words tell it.
        rig.Contact(1000U);
        rig.channel.outcome.waiting = 0U;
        rig.channel.outcome.faulted = 1U;
        ++rig.channel.outcome.cycle;
        rig.Complete(8000U, 10000U, kPair);
    }
    /// The next message and cycle, and what the comparator makes of them.
    Verdict Step()
    {
        LinkMessage word = rig.AnswerTo(now_us);
        word.reports[0] =
            SlotReport{0U, Holding::kPair, SrdoState::kFaulted, SrdoCause::kSct, 9U, now_us - 7000U, kPair.data};
        word.released = peer_releases ? 1U : 0U;
        rig.Hear(word, now_us + 2000U);
        now_us += 10000U;
        ++rig.channel.outcome.cycle;
        rig.channel.outcome.released = own_releases ? 1U : 0U;
        rig.channel.outcome.faulted = own_releases ? 0U : 1U;
        rig.Cycle(now_us);
        const CycleOutcome& a = rig.IsA() ? rig.own : rig.remote;
        const CycleOutcome& b = rig.IsA() ? rig.remote : rig.own;
        return comparator.Compare(Comparison{&a, &b, &rig.peer.VoiceA(), &rig.peer.VoiceB(), Instant{now_us},
                                             rig.channel.outcome.cycle, 0xABCDU, HeldPair{}});
    }
    void NothingHappens(const std::uint32_t steps)
    {
        for (std::uint32_t step = 0U; step < steps; ++step)
        {
            const Verdict verdict = Step();
            EXPECT_EQ(verdict.agreement.agreed, 0U) << "step " << step;
            EXPECT_EQ(verdict.demote, 0U) << "step " << step;
            EXPECT_EQ(verdict.fault, DeviceFault::kNone) << "step " << step;
        }
    }

    // t [ms]   50 (first release)   250 (second release)
    void ExpectThatTheSecondOneReleases(bool& first, bool& second)
    {
        NothingHappens(3U);
        first = true;
        NothingHappens(20U);
        second = true;
        const Verdict verdict = Step();
        EXPECT_EQ(verdict.agreement.agreed, 1U);
        EXPECT_EQ(verdict.agreement.matched & 1U, 1U);
        EXPECT_EQ(verdict.demote, 0U);
    }

    PeerRig rig{GetParam()};
    Comparator comparator{};
    std::uint32_t now_us{10000U};
    bool own_releases{false};
    bool peer_releases{false};
};

TEST_P(AcknowledgeSkew, EdgeOfThisCpuWaitsForTheOtherOne)
{
    Verifies(req::SRS_TWO_005);
    Verifies(req::SRS_CMP_008);
    ExpectThatTheSecondOneReleases(own_releases, peer_releases);
}

TEST_P(AcknowledgeSkew, EdgeOfTheOtherCpuWaitsForThisOne)
{
    Verifies(req::SRS_TWO_005);
    Verifies(req::SRS_CMP_008);
    ExpectThatTheSecondOneReleases(peer_releases, own_releases);
}

TEST_P(AcknowledgeSkew, EdgeOfOneCpuAloneIsDemotedBehindTheWindow)
{
    Verifies(req::SRS_TWO_001);
    Verifies(req::SRS_CMP_008);
    own_releases = true;
    NothingHappens(21U);
    EXPECT_EQ(Step().demote, 1U);
}

INSTANTIATE_TEST_SUITE_P(Cpus, AcknowledgeSkew, ::testing::Values(PeerRole::kA, PeerRole::kB));

} // namespace
} // namespace counterpoint
