// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// PDOs and findings of the EL6751 profile at their limits, and phases that something else comes into.
#include "tests/canopen/start_up/el6751/rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/nmt_master.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"

namespace counterpoint::cia302
{
namespace
{

class El6751LimitsTest : public El6751Rig
{
  public:
    using El6751Rig::El6751Rig;

    bool Send(const CanFrame& frame) noexcept override
    {
        return (frame.identifier != refused) && El6751Rig::Send(frame);
    }
    NmtAnswer Command(const NmtCommand what, const std::uint8_t node)
    {
        return Do([&] { return el.Command(what, NodeId{node}, Now()); });
    }
    void Event(const std::uint8_t node, const NodeEvent event)
    {
        static_cast<void>(Do(
            [&]
            {
                el.OnNodeEvent(NodeId{node}, event, Now());
                return true;
            }));
    }
    void Say(const std::uint8_t node, const std::uint8_t state)
    {
        slaves.at(node)->Turn(state);
        Put(0x700U + node, {state});
    }

    std::uint32_t refused{0xFFFFU}; ///< The sink takes no frame with this identifier.
};

/// Without a factor of SYNC.
class El6751NoFactorTest : public El6751LimitsTest
{
  public:
    El6751NoFactorTest() : El6751LimitsTest(NoFactor())
    {
    }
    static El6751Times NoFactor()
    {
        El6751Times without{};
        without.sync_multiplier = 0U;
        return without;
    }
};

TEST_F(El6751NoFactorTest, NoFactorOfSyncIsOne)
{
    Verifies(req::SRS_ELM_033);
    setup.sync_period_us = 10000U;
    AddBox(5U);
    Rx(5U, MakePdo(1U, 0x205U, 1U, 1U, 0U, 0U));
    Begin();
    Run(1200U);
    EXPECT_EQ(Code(5U), 0);
    EXPECT_FALSE(Times(0x205U).empty());
}

TEST_F(El6751LimitsTest, OnlyPdosThatAreUsedAndOfTheCycleFollowSync)
{
    Verifies(req::SRS_ELM_031);
    setup.sync_period_us = 10000U;
    // Given RxPDOs of each SYNC and of each third one, one by events, and one that is not used
    AddBox(5U);
    Rx(5U, MakePdo(1U, 0x205U, 1U, 1U, 0U, 0U));
    Rx(5U, MakePdo(2U, 0x305U, 3U, 1U, 0U, 0U));
    Rx(5U, MakePdo(3U, 0x405U, 255U, 1U, 0U, 0U));
    Rx(5U, MakePdo(4U, 0x8000'0505U, 1U, 1U, 0U, 0U));
    Rx(5U, MakePdo(5U, 0x8000'0506U, 255U, 1U, 0U, 0U));
    Begin();
    Run(2000U);
    ASSERT_EQ(Code(5U), 0);
    const std::size_t each = Times(0x205U).size();
    EXPECT_GT(each, 50U);
    EXPECT_NEAR(static_cast<double>(Times(0x305U).size()), static_cast<double>(each) / 3.0, 1.0);
    EXPECT_EQ(Times(0x405U).size(), 1U);
    EXPECT_TRUE(Times(0x505U).empty());
    EXPECT_TRUE(Times(0x506U).empty());
}

TEST_F(El6751LimitsTest, APdoHasNoMoreThanEightBytesAndWaitsForRoom)
{
    Verifies(req::SRS_ELM_030);
    Verifies(req::SRS_ELM_031);
    const std::array<std::uint8_t, 9> data{1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 9U};
    El6751Pdo pdo = MakePdo(1U, 0x205U, 255U, 9U, 0U, 50U);
    pdo.data_bytes = data.data();
    AddBox(5U);
    Rx(5U, pdo);
    Begin();
    Run(1300U);
    const std::size_t before = Times(0x205U).size();
    ASSERT_GT(before, 1U);
    EXPECT_EQ(sent.back().frame.length_bytes, 8U);
    EXPECT_EQ(sent.back().frame.data[7], 8U);
    // What the sink does not take stays due, and goes out as soon as it does
    refused = 0x205U;
    Run(200U);
    EXPECT_EQ(Times(0x205U).size(), before);
    refused = 0xFFFFU;
    Run(2U);
    EXPECT_EQ(Times(0x205U).size(), before + 1U);
}

TEST_F(El6751LimitsTest, TheFirstFaultOfATxPdoIsTold)
{
    Verifies(req::SRS_ELM_037);
    // Given two TxPDOs of which one is received once and no more
    AddBox(5U);
    boxes[5].node_reaction = El6751NodeReaction::kNone;
    Tx(5U, MakePdo(1U, 0x185U, 255U, 1U, 0U, 100U));
    Tx(5U, MakePdo(2U, 0x285U, 255U, 1U, 0U, 100U));
    Begin();
    Run(50U);
    Put(0x185U, {1U});
    Put(0x285U, {1U});
    Run(250U);
    EXPECT_EQ(Code(5U), 22);
}

TEST_F(El6751LimitsTest, MorePdosThanThereIsRoomForMakeItUnusable)
{
    Verifies(req::SRS_ELM_001);
    AddBox(5U);
    for (std::uint16_t number = 1U; number <= 65U; ++number)
    {
        Tx(5U, MakePdo(number, 0x185U, 255U, 1U, 0U, 0U));
    }
    Begin();
    Run(50U);
    const int state = el.MasterState();
    Event(5U, NodeEvent::kBootUp);
    Run(50U);
    EXPECT_EQ(el.MasterState(), state);
    EXPECT_TRUE(slaves[5]->log.empty());
    EXPECT_TRUE(Commands().empty());
}

TEST_F(El6751LimitsTest, OneThatWasLostWithoutAHeartbeatTimeIsGuardedAgain)
{
    Verifies(req::SRS_ELM_039);
    AddBox(5U);
    boxes[5].node_reaction = El6751NodeReaction::kNone;
    setups[5].assignment |= (100U << 16U) | (3U << 8U);
    Begin();
    Run(200U);
    slaves[5]->answers_guard = false;
    Run(600U);
    ASSERT_EQ(table.RequestValue(NodeId{5U}), 1U);
    slaves[5]->answers_guard = true;
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(300U);
    EXPECT_EQ(table.Record(NodeId{5U}).watch, Watch::kGuarding);
    EXPECT_EQ(Code(5U), 0);
}

TEST_F(El6751LimitsTest, AHeldSlaveThatIsRefusedIsStoppedWhenThatCanBeSent)
{
    Verifies(req::SRS_ELM_049);
    AddSafety(5U);
    boxes[5].is_started = false;
    Begin();
    Run(50U);
    gate.verdict = GateState::kDiffers;
    nmt.SetActive(false);
    Say(5U, 5U);
    Say(5U, 5U);
    Run(5U);
    EXPECT_TRUE(Of(5U).is_busy);
    sent.clear();
    nmt.SetActive(true);
    Run(5U);
    EXPECT_EQ(Commands(), (Log{"02 05"}));
    EXPECT_FALSE(Of(5U).is_busy);
}

TEST_F(El6751LimitsTest, OneThatSaysThatItIsStoppedIsWokenToBeRead)
{
    Verifies(req::SRS_BOOT_023);
    Verifies(req::SRS_ELM_048);
    AddSafety(5U);
    boxes[5].node_reaction = El6751NodeReaction::kNone;
    setups[5].heartbeat = HeartbeatSetup{300U, 50U, Arming::kFirstHeartbeat};
    Begin();
    Run(50U);
    Say(5U, 5U);
    Say(5U, 4U);
    Run(5U);
    sent.clear();
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(50U);
    EXPECT_EQ(Commands(), (Log{"80 05", "01 05"}));
    EXPECT_EQ(slaves[5]->state, 5U);
}

TEST_F(El6751LimitsTest, AStartThatWasNotHandedOverCannotBeDropped)
{
    Verifies(req::SRS_NMM_121);
    AddSafety(5U);
    gate.cycles = 20;
    Begin();
    Run(10U);
    nmt.SetActive(false);
    Run(50U);
    ASSERT_EQ(Of(5U).step, StartUpStep::kStart);
    static_cast<void>(Do(
        [&]
        {
            el.OnStartDropped(NodeId{5U}, Now());
            return true;
        }));
    EXPECT_EQ(Of(5U).step, StartUpStep::kStart);
}

TEST_F(El6751LimitsTest, ACommandOfSomebodyElseIsNoFaultBeforeTheSlaveSaysSo)
{
    Verifies(req::SRS_ELM_041);
    AddSafety(5U);
    Begin();
    Run(50U);
    Say(5U, 5U);
    Say(5U, 5U);
    Run(5U);
    Put(0x000U, {0x80U, 5U}); // Nobody has obeyed it yet.
    Run(50U);
    EXPECT_EQ(Code(5U), 0);
    EXPECT_EQ(gate.State(NodeId{5U}), GateState::kOpen);
}

TEST_F(El6751LimitsTest, ALossInTheMiddleOfItsSdosIsNoFault)
{
    Verifies(req::SRS_ELM_039);
    AddBox(5U).Behave(0x1000U, 0U, Manner::kSilent);
    Begin();
    Run(50U);
    sent.clear();
    Event(5U, NodeEvent::kGuardLost);
    Event(5U, NodeEvent::kToggleError);
    Run(50U);
    EXPECT_EQ(Commands(), (Log{}));
    EXPECT_TRUE(Of(5U).is_busy);
}

TEST_F(El6751LimitsTest, SilenceBehindAFindingIsNoNews)
{
    Verifies(req::SRS_ELM_049);
    // Given a safety slave whose objects could not be read, with silence
    gate.verdict = GateState::kFailed;
    gate.finding = GateFinding{{0x1301U, 1U}, SdoAbort::kTimeOut, 0U, 0U};
    AddSafety(5U);
    Begin();
    Run(50U);
    ASSERT_EQ(Code(5U), 4);
    ASSERT_EQ(Of(5U).object.index, 0x1301U);
    // When somebody starts it, and it does not answer for another object
    gate.finding = GateFinding{{0x1302U, 1U}, SdoAbort::kTimeOut, 0U, 0U};
    const int verified = gate.verifications;
    Put(0x000U, {0x01U, 5U});
    table.Presume(NodeId{5U}, Now());
    Run(50U);
    EXPECT_GT(gate.verifications, verified);
    EXPECT_EQ(Of(5U).object.index, 0x1301U);
}

TEST_F(El6751LimitsTest, ASlaveThatIsAnotherDeviceIsStartedByNoOrder)
{
    Verifies(req::SRS_SFS_009);
    AddSafety(5U).Set(0x1000U, 0U, 0x192U);
    Begin();
    Run(50U);
    EXPECT_TRUE(Of(5U).is_other);
    EXPECT_EQ(Command(NmtCommand::kStart, 5U), NmtAnswer::kOtherDevice);
}

TEST_F(El6751LimitsTest, OneThatSomebodyElseWokeMeanwhileIsNotWokenAgain)
{
    Verifies(req::SRS_SFS_006);
    AddSafety(5U);
    Begin();
    Run(50U);
    slaves[5]->Behave(0x1000U, 0U, Manner::kSilent);
    EXPECT_TRUE(Do([&] { return el.Resume(NodeId{5U}, Now()); }));
    Say(5U, 5U);
    Say(5U, 5U);
    sent.clear();
    Run(2100U);
    ASSERT_EQ(Commands(), (Log{"02 05"}));
    Put(0x000U, {0x80U, 5U});
    Run(4100U);
    EXPECT_EQ(Commands(), (Log{"02 05"}));
}

TEST_F(El6751LimitsTest, AnObjectOfTheUserMayHaveMoreBytesThanANumber)
{
    Verifies(req::SRS_ELM_024);
    AddBox(5U);
    User(5U, 0x2000U, 0U, Octets(9U, 0x5AU));
    User(5U, 0x2001U, 0U, {2U});
    Begin();
    Run(100U);
    EXPECT_EQ(Code(5U), 0);
    EXPECT_EQ(slaves[5]->log.back(), "nmt 01");
}

TEST_F(El6751LimitsTest, AListThatIsCutWhileItIsWrittenIsNotGoneOnWith)
{
    Verifies(req::SRS_ELM_024);
    AddBox(5U);
    User(5U, 0x2000U, 0U, {1U});
    User(5U, 0x2001U, 0U, {2U});
    slaves[5]->Behave(0x2001U, 0U, Manner::kSilent);
    Begin();
    Run(50U);
    ASSERT_EQ(Of(5U).object.index, 0x2001U);
    setups[5].concise_dcf.size_bytes -= 1U;
    Run(2500U);
    EXPECT_NE(Code(5U), 0);
}

} // namespace
} // namespace counterpoint::cia302
