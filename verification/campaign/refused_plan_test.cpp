// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Plans that are refused, each at its place in the file.
#include "verification/campaign/campaign_rig.hpp"

namespace counterpoint::campaign::test
{
namespace
{
using PlanTest = CampaignTest;

struct BadPlan
{
    const char* lines; ///< From line 4 on.
    const char* message;
};

class BadPlans : public CampaignTest, public ::testing::WithParamInterface<BadPlan>
{
};

TEST_P(BadPlans, AreRefusedWithTheirPlace)
{
    Verifies(req::SRS_CMG_004);
    const std::string plan = PlanFile("plan.yaml", "actuator", GetParam().lines);
    const tools::test::Answer answer = Campaign({plan});
    EXPECT_EQ(answer.status, 2);
    EXPECT_NE(answer.err.find(plan + GetParam().message), std::string::npos) << answer.err;
}

INSTANTIATE_TEST_SUITE_P(
    Plans, BadPlans,
    ::testing::Values(
        BadPlan{"", ":1:1: error: no key 'at'"},
        BadPlan{"at: [500 ms, 400 ms]\n", ":4:14: error: a time that is not later"},
        BadPlan{"at: [9 s]\n", ":4:5: error: an instant at which"},
        BadPlan{"at: [3 s]\n", ":4:5: error: an instant at which"},
        BadPlan{"at: [500 ms]\nparts: [stack]\n", ":5:9: error: 'stack', expected one of channel_a"},
        BadPlan{"at: [500 ms]\nkinds: [flip, flip]\n", ":5:15: error: the same word twice"},
        BadPlan{"at: [500 ms]\nmembers: [latchx]\n", ":5:11: error: member 'latchx' that the device does not have"},
        BadPlan{"at: [500 ms]\nmembers: [latch+12]\n",
                ":5:11: error: byte 12 of member 'latch', which has 12, expected latch+0 to latch+11"},
        BadPlan{"at: [500 ms]\nknown:\n  - {place: latch, class: masked, reason: none}\n",
                ":6:27: error: 'masked', expected one of silent"},
        BadPlan{"at: [500 ms]\nparts: [bus]\nmembers: [channel_b.data]\n",
                ":6:11: error: member 'channel_b.data' without an effect"},
        BadPlan{"at: [500 ms]\nparts: [bus]\nphases: [permits]\n",
                ":6:9: error: phases where nothing of the memory is hit"},
        BadPlan{"at: [500 ms]\nparts: [bus]\nkinds: [lost, flip]\n", ":6:15: error: a kind that none of the parts has"},
        BadPlan{"at: [500 ms]\nreach: 51 us\n", ":5:8: error: a reach that is no multiple of the grid"},
        BadPlan{"at: [500 ms]\nreach: 1 ms\n", ":5:8: error: a reach where nothing moves in time"},
        BadPlan{"at: [500 ms]\nparts: [cycle, steps]\nkinds: [late, early]\nreach: 0 ms\n",
                ":7:8: error: '0 ms', expected a time above 0"},
        BadPlan{"at: [500 ms]\nparts: [cycle, steps]\nkinds: [early]\nreach: 1 ms\n",
                ":7:8: error: a reach where nothing moves in time"},
        BadPlan{"at: [500 ms]\nparts: [bus, steps]\nkinds: [lost, late]\nreach: 1 ms\n",
                ":7:8: error: a reach where nothing moves in time"},
        // The gate is the output; no frame comes in this cycle; of these parts the member is another one's
        BadPlan{"at: [500 ms]\nparts: [latch, pins]\n", ":5:16: error: part 'pins' of which nothing is hit"},
        BadPlan{"at: [500 ms]\nparts: [bus, latch]\n", ":5:9: error: part 'bus' of which nothing is hit"},
        BadPlan{"at: [500 ms]\nparts: [latch, guard]\nmembers: [latch+0]\n",
                ":5:16: error: part 'guard' of which nothing is hit"},
        BadPlan{"at: [500 ms]\nmembers: []\n", ":5:10: error: an empty list, expected at least one"},
        BadPlan{"at: [500 ms]\nmembers: [latch, latch]\n", ":5:18: error: the same member twice"},
        BadPlan{"at: [500 ms]\nvoices: []\n", ":5:9: error: an empty list, expected at least one"},
        BadPlan{"at: [500 ms]\nvoices: [channel_a.sct, channel_a.sct]\n", ":5:25: error: the same voice twice"},
        BadPlan{"at: [500 ms]\nvoices: [channel_a.none]\n", ":5:10: error: 'channel_a.none', expected"},
        BadPlan{"at: [500 ms]\nknown: []\n", ":5:8: error: an empty list, expected at least one"},
        BadPlan{"at: [500 ms]\nknown:\n  - {place: latch, reason: \"\"}\n",
                ":6:28: error: an empty text, expected who answers for it"},
        BadPlan{"at: [500 ms]\nknown:\n  - {place: comparator, reason: none}\n",
                ":6:13: error: part 'comparator' as a known place, expected a member, byte or bit"},
        BadPlan{"at: [500 ms]\nknown:\n  - {place: both_channels, reason: none}\n",
                ":6:13: error: part 'both_channels' as a known place"},
        BadPlan{"at: [500 ms]\nknown:\n  - {place: latch+12, reason: none}\n",
                ":6:13: error: place 'latch+12' that the device does not have"},
        BadPlan{"at: [500 ms]\nknown:\n  - {place: latch+11.8, reason: none}\n",
                ":6:13: error: place 'latch+11.8' that the device does not have"},
        BadPlan{"at: [500 ms]\nknown:\n  - {place: latchx+1, reason: none}\n",
                ":6:13: error: place 'latchx+1' that the device does not have"},
        BadPlan{"at: [500 ms]\nsample: 0\n", ":5:9: error: "},
        BadPlan{"at: [500 ms]\ncolour: red\n", ":5:1: error: unknown key"}));

TEST_F(PlanTest, KindOfWhichNothingIsHitIsRefused)
{
    Verifies(req::SRS_CMG_004);
    // Given pairs whose normal frames come in the cycle of 511.7 ms, and an inverse frame alone in the next one
    const auto of = [this](const std::string& at)
    {
        return Campaign({File("plan.yaml", "title: A test\nscenario: " COUNTERPOINT_SOURCE_FOLDER
                                           "/verification/campaign/planted/pair_in_two_cycles.yaml\n"
                                           "device: actuator\nparts: [bus]\nkinds: [lost, pair_delayed]\nreach: 1 ms\n"
                                           "at: [" +
                                               at + "]\n"),
                         "--replay", "0"});
    };
    // Then there is a pair in the first one alone
    EXPECT_EQ(of("511 ms").status, 0);
    const tools::test::Answer later = of("512 ms");
    EXPECT_EQ(later.status, 2);
    EXPECT_NE(later.err.find(":5:15: error: kind 'pair_delayed' of which nothing is hit"), std::string::npos)
        << later.err;
}

TEST_F(PlanTest, VoiceThatIsNoCauseOfAChannelIsRefused)
{
    Verifies(req::SRS_CMG_041);
    const std::string plan = PlanFile("plan.yaml", "actuator", "at: [500 ms]\nvoices: [channel_c.srvt]\n");
    EXPECT_NE(Campaign({plan}).err.find(plan + ":5:10: error: 'channel_c.srvt', expected a cause of one channel"),
              std::string::npos);
}
} // namespace
} // namespace counterpoint::campaign::test
