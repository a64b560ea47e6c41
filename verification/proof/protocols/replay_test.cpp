// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/proof/protocols/replay.hpp"

#include "verification/proof/protocols/comparator_rig.hpp"
#include "verification/proof/protocols/election_rig.hpp"
#include "verification/proof/protocols/link_rig.hpp"
#include "verification/proof/protocols/producer_rig.hpp"
#include "verification/trace/ids/verification.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>

namespace counterpoint::protocols
{
namespace
{

using Story = std::vector<std::string>;

Model ModelOf(const std::string& text)
{
    std::istringstream lines{text};
    return ReadModel(lines);
}

/// Code of two states that go round; a defect makes it stay in the second.
struct Toggle
{
    bool is_stuck{false};
    std::int32_t state{0};

    Numbers Apply(const Numbers&)
    {
        state = (is_stuck || (state == 0)) ? 1 : 0;
        return {state};
    }
};

constexpr const char* kToggle = "spin told something\nT 0 | 7 | 1 | 1\nT 1 | 8 | 0 | 0\nT 1 | 8 | 0 | 0\n";

TEST(ReplayOfModels, EachTransitionIsDrivenFromEachWayIntoItsState)
{
    Verifies(req::SRS_VER_131);
    const Replayed replayed = Replay<Toggle>{ModelOf(kToggle)}.Run(Toggle{});
    EXPECT_EQ(replayed.refused, "");
    EXPECT_EQ(replayed.states, 2U);
    EXPECT_EQ(replayed.transitions, 2U);
    EXPECT_EQ(replayed.steps, 3U); // From the first state as begun and as reached again.
}

TEST(ReplayOfModels, CodeThatShowsSomethingElseIsRefusedWithItsStory)
{
    Verifies(req::SRS_VER_132);
    const Replayed replayed = Replay<Toggle>{ModelOf(kToggle)}.Run(Toggle{true});
    EXPECT_EQ(replayed.refused, "model shows 0, code shows 1");
    EXPECT_EQ(replayed.story, (Story{"7", "8"}));
}

TEST(ReplayOfModels, TransitionThatNothingLeadsToIsRefused)
{
    Verifies(req::SRS_VER_132);
    const std::string text = std::string{kToggle} + "T 5 | 8 | 0 | 0\n";
    const Replayed replayed = Replay<Toggle>{ModelOf(text)}.Run(Toggle{});
    EXPECT_EQ(replayed.refused, "the code was driven through 2 transitions of 3");
}

TEST(ReplayOfModels, EmptyModelAndOtherTextAreRefused)
{
    Verifies(req::SRS_VER_132);
    EXPECT_THROW(static_cast<void>(ModelOf("no transition\n")), std::runtime_error);
    EXPECT_THROW(static_cast<void>(ModelOf("T 0 | 7 | 1\n")), std::runtime_error);
    EXPECT_THROW(static_cast<void>(ModelOf("T 0 | x | 1 | 1\n")), std::runtime_error);
}

// Given a start and two cycles in which both channels say released with a new pair, then the output opens; with channel
// A alone it stays closed, unless the code lacks the other half of the agreement.
TEST(ReplayOfModels, ComparatorOfTheProductOpensByBothAlone)
{
    Verifies(req::SRS_VER_131);
    Verifies(req::SRS_VER_132);
    const Model model = ModelOf("T 0 | 1 0 0 0 0 0 0 0 0 0 | 1 | 1 0 0 0\n"
                                "T 1 | 0 1 1 0 0 1 0 0 0 0 | 2 | 1 1 0 1\n"
                                "T 1 | 0 1 0 0 0 1 0 0 0 0 | 3 | 1 0 0 0\n"
                                "T 2 | 0 1 1 0 0 0 0 0 1 0 | 4 | 0 0 0 0\n"
                                "T 4 | 0 1 1 0 0 1 0 0 0 0 | 4 | 0 0 0 0\n");
    EXPECT_EQ(Replay<ComparatorRig>{model}.Run(ComparatorRig{}).refused, "");
    const Replayed one = Replay<ComparatorRig>{model}.Run(ComparatorRig{ComparatorDefect::kOneIsEnough});
    EXPECT_EQ(one.refused, "model shows 1 0 0 0, code shows 1 1 0 1");
    EXPECT_EQ(one.story, (Story{"1 0 0 0 0 0 0 0 0 0", "0 1 0 0 0 1 0 0 0 0"}));
    const Replayed out = Replay<ComparatorRig>{model}.Run(ComparatorRig{ComparatorDefect::kWayOut});
    EXPECT_EQ(out.refused, "model shows 0 0 0 0, code shows 1 0 0 0");
}

// Given a start and a cycle, when the peer answers the own message of that cycle, then contact begins; what answers
// nothing, and the same damaged, changes nothing.
TEST(ReplayOfModels, LinkOfTheProductBeginsByAnAnswerAlone)
{
    Verifies(req::SRS_VER_131);
    Verifies(req::SRS_VER_132);
    const Model model = ModelOf("T 0 | 0 0 0 0 0 0 | 1 | 1 0 0 99\n"
                                "T 0 | 1 0 1 0 1 0 | 2 | 1 4 1 0\n"
                                "T 1 | 1 0 1 0 1 1 | 1 | 1 5 0 99\n"
                                "T 1 | 1 0 1 0 1 2 | 1 | 1 5 0 99\n"
                                "T 1 | 1 0 1 0 1 0 | 3 | 2 1 1 0\n"
                                "T 3 | 1 0 1 0 1 0 | 3 | 2 2 1 0\n");
    EXPECT_EQ(Replay<LinkRig>{model}.Run(LinkRig{}).refused, "");
    const Replayed older = Replay<LinkRig>{model}.Run(LinkRig{LinkDefect::kOlderAnswers});
    EXPECT_EQ(older.refused, "model shows 1 4 1 0, code shows 2 1 1 0");
    const Replayed foreign = Replay<LinkRig>{model}.Run(LinkRig{LinkDefect::kTakesForeign});
    EXPECT_EQ(foreign.refused, "model shows 1 5 0 99, code shows 1 4 1 0");
    EXPECT_EQ(foreign.story, (Story{"0 0 0 0 0 0", "1 0 1 0 1 1"}));
}

// Given a device of level 1 alone, when it asks and a worse one claims, then it sends 076h and begins anew after 5 ms;
// with level 2 instead it follows.
TEST(ReplayOfModels, FlyingMasterOfTheProductForcesAWorseOneAlone)
{
    Verifies(req::SRS_VER_131);
    Verifies(req::SRS_VER_132);
    const Model model = ModelOf("T 0 | 0 0 250 1 2 | 1 | 0 0 0 0 0 0 0\n"
                                "T 1 | 1 0 0 1 2 | 2 | 1 0 0 0 5 0 0\n"
                                "T 2 | 3 0 5 1 2 | 3 | 1 0 0 0 0 0 0\n"
                                "T 3 | 1 0 0 1 2 | 4 | 2 0 0 0 32 0 4\n"
                                "T 4 | 2 0 6 1 2 | 5 | 1 0 1 0 5 0 5\n");
    EXPECT_EQ(Replay<ElectionRig>{model}.Run(ElectionRig{}).refused, "");
    const Model follows = ModelOf("T 0 | 1 0 0 2 2 | 1 | 1 0 0 0 5 0 0\n"
                                  "T 1 | 2 0 6 2 2 | 2 | 4 0 0 0 6000 0 0\n");
    EXPECT_EQ(Replay<ElectionRig>{follows}.Run(ElectionRig{}).refused, "");
    const Replayed wrong = Replay<ElectionRig>{follows}.Run(ElectionRig{ElectionDefect::kWrongPriority});
    EXPECT_EQ(wrong.refused, "model shows 4 0 0 0 6000 0 0, code shows 1 0 0 0 5 0 0");
}

// Given OPERATIONAL since a cycle, then both channels call the producer due in the next one, and the pair that is
// prepared is given up by bus-off in both; one channel that is not told of it shows something else.
TEST(ReplayOfModels, ProducerOfBothChannelsIsDueAfterItsDelay)
{
    Verifies(req::SRS_VER_131);
    Verifies(req::SRS_VER_132);
    const Model model = ModelOf("T 0 | 0 1 0 | 1 | 1 0 0 0 0 0 0\n"
                                "T 1 | 0 1 0 | 2 | 1 1 0 0 0 0 1\n"
                                "T 2 | 1 0 0 | 3 | 1 0 0 1 0 0 0\n"
                                "T 3 | 2 0 0 | 4 | 1 0 0 0 1 1 0\n"
                                "T 3 | 2 1 0 | 5 | 1 0 1 0 0 0 0\n"
                                "T 4 | 3 14 0 | 5 | 1 0 1 0 0 0 0\n");
    EXPECT_EQ(Replay<ProducerRig>{model}.Run(ProducerRig{}).refused, "");
    const Replayed untold = Replay<ProducerRig>{model}.Run(ProducerRig{ProducerDefect::kForgetsFaults});
    EXPECT_EQ(untold.refused, "model shows 1 0 1 0 0 0 0, code shows -1");
    EXPECT_EQ(untold.story, (Story{"0 1 0", "0 1 0", "1 0 0", "2 0 0", "3 14 0"}));
}

} // namespace
} // namespace counterpoint::protocols
