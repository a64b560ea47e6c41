// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// From NMT start to running: the rows of the EL6751 text behind the SDOs, and the manager's own controller.
#include "tests/canopen/start_up/el6751/rig.hpp"
#include "verification/trace/ids/cia301.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"

namespace counterpoint::cia302
{
namespace
{

using El6751StartTest = El6751Rig;

// t [ms]   0         2         3
// frame    82 00     boot-up   01 05, 01 00
TEST_F(El6751StartTest, RowsStartNodeAndStartAllNodes)
{
    Verifies(req::SRS_ELM_026);
    Verifies(req::SRS_ELM_027);
    AddBox(5U);
    AddBox(9U);
    Begin();
    Run(20U);
    EXPECT_EQ(Nmt(), (Log{"0:82 00", "3:01 05", "3:01 09", "3:01 00"}));
    EXPECT_EQ(told[5], (Log{"8", "0"}));
    EXPECT_EQ(masters, (Log{"1", "2"}));
    // A slave that restarts later is started alone
    slaves[5]->Power(Now().us);
    Run(20U);
    EXPECT_EQ(Nmt().size(), 5U);
    EXPECT_EQ(Nmt().back(), "23:01 05");
}

TEST_F(El6751StartTest, StartFollowsTheLastSdo)
{
    Verifies(req::SRS_ELM_026);
    // Given a slave whose last SDO, one of the user's, is answered late
    AddBox(5U);
    User(5U, 0x2000U, 0U, {1U});
    slaves[5]->Behave(0x2000U, 0U, Manner::kSilent);
    Begin();
    Run(1000U);
    EXPECT_EQ(Nmt(), (Log{"0:82 00"}));
    ASSERT_FALSE(sent.empty());
    EXPECT_EQ(sent.back().frame.identifier, 0x605U);
    EXPECT_EQ(sent.back().frame.data[2], 0x20U);
    // When it is answered, then the slave is started, and no SDO comes behind
    CanFrame answer{0x585U, FrameKind::kData, CanPortId::kFirst, 8U, {0x60U, 0x00U, 0x20U}};
    Put(answer.identifier, Octets(answer.data, answer.data + 8U));
    Run(20U);
    EXPECT_EQ(sent.back().frame.identifier, 0x000U);
    EXPECT_EQ(Nmt().size(), 3U);
    EXPECT_EQ(Nmt()[1].substr(Nmt()[1].find(':') + 1U), "01 05");
}

/// The trace of an FC5101 in the fact sheet: its own time-out, then the boot-up message of slave 1 begins it all again.
/// Two of its frames differ here: the abort names its object, and no answer needs a mark after a boot-up message.
TEST_F(El6751StartTest, TheTraceOfTheReference)
{
    Verifies(req::SRS_ELM_001);
    Verifies(req::SRS_ELM_151);
    Verifies(req::SRS_ELM_002);
    Verifies(req::SRS_ELM_003);
    AddBox(1U);
    setups[1].device_type = 0x70191U;
    setups[1].vendor_id = 2U;
    slaves[1]->Set(0x1000U, 0U, 0x70191U);
    slaves[1]->Set(0x1018U, 1U, 2U);
    slaves[1]->boot_us = 2100000U;
    Tx(1U, MakePdo(1U, 0x181U, 255U, 8U, 0U, 0U));
    Tx(1U, MakePdo(2U, 0x281U, 255U, 8U, 0U, 0U));
    Begin();
    Run(2200U);
    std::vector<Octets> frames{};
    for (const Sent& one : sent)
    {
        Octets bytes(one.frame.data, one.frame.data + one.frame.length_bytes);
        frames.push_back(bytes);
    }
    const std::vector<Octets> begin{
        {0x82U, 0U}, {0x40U, 0x00U, 0x10U, 0U, 0U, 0U, 0U, 0U}, {0x80U, 0x00U, 0x10U, 0U, 0U, 0U, 0x04U, 0x05U}};
    const std::vector<Octets> end{{0x40U, 0x00U, 0x10U, 0U, 0U, 0U, 0U, 0U},
                                  {0x40U, 0x18U, 0x10U, 1U, 0U, 0U, 0U, 0U},
                                  {0x23U, 0x00U, 0x18U, 1U, 0x81U, 1U, 0U, 0U},
                                  {0x2FU, 0x00U, 0x18U, 2U, 0xFFU, 0U, 0U, 0U},
                                  {0x23U, 0x01U, 0x18U, 1U, 0x81U, 2U, 0U, 0U},
                                  {0x2FU, 0x01U, 0x18U, 2U, 0xFFU, 0U, 0U, 0U},
                                  {1U, 1U},
                                  {1U, 0U}};
    ASSERT_GE(frames.size(), begin.size() + end.size());
    EXPECT_EQ(std::vector<Octets>(frames.begin(), frames.begin() + 3), begin);
    EXPECT_EQ(std::vector<Octets>(frames.end() - 8, frames.end()), end);
    EXPECT_EQ(told[1], (Log{"8", "2", "8", "23"}));
}

/// Given a slave that says 1000h in segments, and restarts when the read of it has begun, then the boot-up message
/// begins its start-up again at the first row, and nothing of the read before is told.
TEST_F(El6751StartTest, ARestartWithinAReadInSegmentsBeginsAtTheFirstRow)
{
    Verifies(req::SRS_ELM_002);
    BusSlave& slave = AddBox(5U);
    slave.Behave(0x1000U, 0U, Manner::kSegments);
    slave.answers_segments = false;
    Begin();
    Run(20U);
    EXPECT_EQ(Sdos(5U), Log{"r 1000:00"});
    EXPECT_EQ(Code(5U), 8);
    slave.answers_segments = true;
    slave.Power(Now().us);
    Run(40U);
    EXPECT_EQ(Sdos(5U), (Log{"r 1000:00", "r 1000:00"}));
    EXPECT_EQ(told[5], (Log{"8", "0"}));
    EXPECT_EQ(Of(5U).abort, SdoAbort::kNone);
}

/// Given a slave that keeps the request for 1000h that comes while it boots, and answers it behind its boot-up message,
/// as well as the one that this message leads to, then its start-up goes on with either answer and fails by neither.
TEST_F(El6751StartTest, ARequestOfBeforeTheBootUpMessageMayBeAnsweredBehindIt)
{
    Verifies(req::SRS_SDC_450);
    Verifies(req::SRS_ELM_002);
    for (const Manner manner : {Manner::kGood, Manner::kSegments})
    {
        for (std::uint32_t kept_us = 0U; kept_us < 6000U; kept_us += 500U)
        {
            const auto node = static_cast<std::uint8_t>(5U + slaves.size());
            BusSlave& slave = AddBox(node);
            slave.Behave(0x1000U, 0U, manner);
            slave.keeps_requests = true;
            slave.boot_us = 20000U;
            slave.kept_us = kept_us;
        }
    }
    Begin();
    Run(100U);
    for (const auto& [node, slave] : slaves)
    {
        EXPECT_EQ(told[node], (Log{"8", "0"})) << int{node} << ", " << slave->kept_us << " us";
        EXPECT_EQ(Sdos(node), (Log{"r 1000:00", "r 1000:00"})) << int{node};
        EXPECT_EQ(Of(node).abort, SdoAbort::kNone) << int{node};
    }
}

TEST_F(El6751StartTest, StartAllWaitsForTheLastSlave)
{
    Verifies(req::SRS_ELM_027);
    AddBox(5U);
    AddBox(9U);
    slaves[9]->is_on = false;
    Begin();
    Run(5000U);
    EXPECT_EQ(Nmt(), (Log{"0:82 00", "3:01 05"}));
    EXPECT_EQ(el.MasterState(), 1);
    slaves[9]->Power(Now().us);
    Run(20U);
    EXPECT_EQ(Nmt(), (Log{"0:82 00", "3:01 05", "5003:01 09", "5003:01 00"}));
    EXPECT_EQ(el.MasterState(), 2);
}

TEST_F(El6751StartTest, ASlaveWithoutAutomaticStartWaitsForAHandAndForbidsStartAll)
{
    Verifies(req::SRS_ELM_026);
    Verifies(req::SRS_ELM_027);
    AddBox(5U);
    AddBox(9U);
    boxes[9].is_started = false;
    Begin();
    Run(2000U);
    EXPECT_EQ(Nmt(), (Log{"0:82 00", "3:01 05"}));
    EXPECT_EQ(Code(9U), 12);
    EXPECT_EQ(Of(9U).step, StartUpStep::kManual);
    EXPECT_FALSE(Of(9U).is_busy);
    EXPECT_EQ(slaves[9]->state, 127U);
    // When a hand starts it
    EXPECT_EQ(Control(9U, 5U, 1U), NmtAnswer::kTaken);
    Run(20U);
    EXPECT_EQ(Nmt(), (Log{"0:82 00", "3:01 05", "2000:01 09"}));
    EXPECT_EQ(Code(9U), 0);
}

TEST_F(El6751StartTest, NoStartOfAllWhileASafetySlaveIsAssigned)
{
    Verifies(req::SRS_ELM_027);
    AddBox(5U);
    AddSafety(9U);
    Begin();
    Run(50U);
    EXPECT_EQ(Code(5U), 0);
    EXPECT_EQ(Code(9U), 0);
    EXPECT_EQ(Nmt().size(), 3U);
    EXPECT_EQ(Nmt()[1], "3:01 05");
    EXPECT_EQ(Nmt()[2].substr(Nmt()[2].find(':')), ":01 09");
    // Though a command asks for it
    EXPECT_EQ(Do([this] { return el.Command(NmtCommand::kStart, kAllNodes, Now()); }), NmtAnswer::kTaken);
    Run(50U);
    EXPECT_EQ(Nmt().size(), 3U);
}

TEST_F(El6751StartTest, NodeState8FromTheFirstRowToTheStartAnd0OnlyWithoutAnError)
{
    Verifies(req::SRS_ELM_050);
    // Given a slave whose last SDO is not answered
    AddBox(5U);
    Tx(5U, MakePdo(1U, 0x185U, 255U, 2U, 0U, 0U));
    User(5U, 0x2000U, 0U, {1U});
    slaves[5]->Behave(0x2000U, 0U, Manner::kSilent);
    Begin();
    // Then it has NodeState 8 in each cycle from the first row on
    for (int cycle = 0; cycle < 200; ++cycle)
    {
        Run(1U);
        ASSERT_EQ(Code(5U), 8) << cycle;
    }
    // When that SDO is answered, then it is started, and 0 comes with its TxPDO
    const Octets answer{0x60U, 0x00U, 0x20U, 0x00U, 0U, 0U, 0U, 0U};
    Put(0x585U, answer);
    Run(20U);
    EXPECT_EQ(Nmt()[1].substr(Nmt()[1].find(':') + 1U), "01 05");
    EXPECT_EQ(Code(5U), 23);
    Put(0x185U, {1U, 2U});
    Run(1U);
    EXPECT_EQ(Code(5U), 0);
    EXPECT_EQ(told[5], (Log{"8", "23", "0"}));
    // When it has an error behind that, a TxPDO that is too short, then it is not 0 though it is started
    Put(0x185U, {1U});
    Run(1U);
    EXPECT_EQ(Code(5U), 20);
}

TEST_F(El6751StartTest, NodeState23UntilEveryTxPdoCame)
{
    Verifies(req::SRS_ELM_028);
    Verifies(req::SRS_ELM_050);
    AddBox(5U);
    Tx(5U, MakePdo(1U, 0x185U, 255U, 2U, 0U, 0U));
    Tx(5U, MakePdo(2U, 0x285U, 255U, 8U, 0U, 0U));
    Tx(5U, MakePdo(3U, 0x80000385U, 255U, 8U, 0U, 0U)); // Off: nobody waits for it.
    Begin();
    // A TxPDO before the start does not count
    Put(0x185U, {1U, 2U});
    Run(30U);
    EXPECT_EQ(Code(5U), 23);
    EXPECT_EQ(Of(5U).step, StartUpStep::kWaitPdos);
    Put(0x185U, {1U, 2U});
    Run(1U);
    EXPECT_EQ(Code(5U), 23);
    Put(0x285U, Octets(8U));
    Run(1U);
    EXPECT_EQ(Code(5U), 0);
    EXPECT_EQ(told[5], (Log{"8", "23", "0"}));
    Run(60000U);
    EXPECT_EQ(Code(5U), 0);
}

TEST_F(El6751StartTest, AfterTenSecondsWithoutAnyTxPdoTheStartUpIsRepeatedIfSoConfigured)
{
    Verifies(req::SRS_ELM_029);
    AddBox(5U);
    Tx(5U, MakePdo(1U, 0x185U, 255U, 2U, 0U, 0U));
    Tx(5U, MakePdo(2U, 0x285U, 255U, 8U, 0U, 0U));
    boxes[5].is_restarted_without_pdos = true;
    Begin();
    Run(10006U);
    EXPECT_EQ(Nmt(), (Log{"0:82 00", "7:01 05", "7:01 00"}));
    slaves[5]->log.clear();
    Run(40U);
    EXPECT_EQ(slaves[5]->log[0], "nmt 82");
    EXPECT_EQ(slaves[5]->log[1], "r 1000:00");
    EXPECT_EQ(Nmt(), (Log{"0:82 00", "7:01 05", "7:01 00", "10007:82 05", "10014:01 05"}));
    // One of two is enough
    Put(0x285U, Octets(8U));
    Run(20000U);
    EXPECT_EQ(Nmt().size(), 5U);
    EXPECT_EQ(Code(5U), 23);
}

TEST_F(El6751StartTest, ByDefaultAndWithoutTxPdosNothingIsRepeated)
{
    Verifies(req::SRS_ELM_029);
    AddBox(5U);
    Tx(5U, MakePdo(1U, 0x185U, 255U, 2U, 0U, 0U));
    AddBox(6U);
    boxes[6].is_restarted_without_pdos = true;
    Begin();
    Run(30000U);
    EXPECT_EQ(Nmt(), (Log{"0:82 00", "3:01 06", "5:01 05", "5:01 00"}));
    EXPECT_EQ(Code(5U), 23);
    EXPECT_EQ(Code(6U), 0);
}

TEST_F(El6751StartTest, RxPdosGoOneSecondAfterTheStartAndNotBefore)
{
    Verifies(req::SRS_ELM_030);
    AddBox(5U);
    const Octets data{1U, 2U, 3U};
    El6751Pdo pdo = MakePdo(1U, 0x205U, 255U, 3U, 0U, 0U);
    pdo.data_bytes = data.data();
    Rx(5U, pdo);
    Rx(5U, MakePdo(2U, 0x305U, 1U, 8U, 0U, 0U));
    Begin();
    Run(1006U);
    EXPECT_EQ(Nmt()[1], "7:01 05");
    EXPECT_TRUE(Times(0x205U).empty());
    Run(3000U);
    EXPECT_EQ(Times(0x205U), (std::vector<std::uint32_t>{1008000U}));
    EXPECT_EQ(Times(0x305U).front(), 1008000U);
    for (const Sent& one : sent)
    {
        if (one.frame.identifier == 0x205U)
        {
            EXPECT_EQ(one.frame.length_bytes, 3U);
            EXPECT_EQ(one.frame.data[2], 3U);
        }
    }
}

TEST_F(El6751StartTest, RxPdosStopWithTheSlave)
{
    Verifies(req::SRS_ELM_031);
    AddBox(5U);
    Rx(5U, MakePdo(1U, 0x205U, 255U, 1U, 0U, 100U));
    Begin();
    Run(1550U);
    EXPECT_EQ(Times(0x205U).size(), 6U);
    EXPECT_EQ(Control(5U, 5U, 0U), NmtAnswer::kTaken);
    Run(1000U);
    EXPECT_EQ(Times(0x205U).size(), 6U);
    EXPECT_EQ(Control(5U, 5U, 1U), NmtAnswer::kTaken);
    Run(1000U);
    EXPECT_EQ(Times(0x205U).size(), 6U);
    Run(1U);
    EXPECT_EQ(Times(0x205U).size(), 7U);
}

TEST_F(El6751StartTest, SyncOnlyIfAnyPdoOfAnyListedSlaveIsSynchronous)
{
    Verifies(req::SRS_ELM_032);
    setup.sync_period_us = 10000U;
    AddBox(5U);
    AddBox(6U);
    setups[6].assignment = 0U;
    Rx(6U, MakePdo(1U, 0x206U, 1U, 1U, 0U, 0U)); // Not in the network.
    Tx(5U, MakePdo(1U, 0x185U, 255U, 1U, 0U, 0U));
    for (const std::uint8_t type : Octets{253U, 254U, 255U})
    {
        tx[5][0].type = type;
        Begin();
        Run(50U);
        EXPECT_TRUE(Times(0x80U).empty()) << int{type};
    }
    for (const std::uint8_t type : Octets{0U, 1U, 240U, 252U})
    {
        tx[5][0].type = type;
        sent.clear();
        const std::uint32_t begin_us = us;
        Begin();
        Run(35U);
        const std::vector<std::uint32_t> syncs = Times(0x80U);
        ASSERT_EQ(syncs.size(), 4U) << int{type};
        EXPECT_EQ(syncs[0] - begin_us, 1000U);
        EXPECT_EQ(syncs[1] - begin_us, 11000U);
        EXPECT_EQ(syncs[2] - begin_us, 21000U);
        EXPECT_EQ(syncs[3] - begin_us, 31000U);
        for (const Sent& one : sent)
        {
            const bool is_sync = one.frame.identifier == 0x80U;
            EXPECT_TRUE(!is_sync || ((one.frame.length_bytes == 0U) && (one.frame.kind == FrameKind::kData)));
        }
    }
    setup.sync_period_us = 0U;
    sent.clear();
    Begin();
    Run(50U);
    EXPECT_TRUE(Times(0x80U).empty());
}

TEST_F(El6751StartTest, ALateCycleShiftsNoLaterSync)
{
    Verifies(req::SRS_ELM_032);
    setup.sync_period_us = 10000U;
    AddBox(5U);
    Rx(5U, MakePdo(1U, 0x205U, 0U, 1U, 0U, 0U));
    Begin();
    Run(12U);
    step_us = 23000U;
    RunUs(23000U);
    step_us = 1000U;
    Run(20U);
    EXPECT_EQ(Times(0x80U), (std::vector<std::uint32_t>{1000U, 11000U, 35000U, 41000U, 51000U}));
}

TEST_F(El6751StartTest, BusOffIsNodeState11OfEverySlaveAndAfterwardsEverythingBegins)
{
    Verifies(req::SRS_ELM_044);
    setup.sync_period_us = 10000U;
    AddBox(5U);
    AddBox(6U);
    Rx(5U, MakePdo(1U, 0x205U, 1U, 1U, 0U, 0U));
    Begin();
    Run(1500U);
    ASSERT_EQ(Code(5U), 0);
    sent.clear();
    const auto set = [this](const ControllerState state)
    {
        return Do(
            [&]
            {
                el.OnController(state, Now());
                return true;
            });
    };
    EXPECT_TRUE(set(ControllerState::kBusOff));
    EXPECT_EQ(Code(5U), 11);
    EXPECT_EQ(Code(6U), 11);
    EXPECT_EQ(el.MasterState(), 3);
    Run(5000U);
    EXPECT_TRUE(sent.empty());
    EXPECT_EQ(Code(5U), 11);
    EXPECT_TRUE(set(ControllerState::kRunning));
    EXPECT_EQ(Code(5U), 8);
    Run(20U);
    EXPECT_EQ(Code(5U), 0);
    EXPECT_EQ(Nmt(), (Log{"6500:82 00", "6504:01 06", "6506:01 05", "6506:01 00"}));
}

TEST_F(El6751StartTest, WhileTheManagerIsBusOffNobodyIsSupervised)
{
    Verifies(req::SRS_ELM_044);
    AddBox(5U);
    boxes[5].guard_time_ms = 100U;
    boxes[5].life_time_factor = 3U;
    Begin();
    Run(500U);
    ASSERT_EQ(Code(5U), 0);
    told.clear();
    // When the slave falls silent while the manager is off the bus
    static_cast<void>(Do(
        [&]
        {
            el.OnController(ControllerState::kBusOff, Now());
            return true;
        }));
    slaves[5]->heartbeat_us = 0U;
    Run(5000U);
    // Then its silence is no loss, whatever else it is
    EXPECT_EQ(told[5], (Log{"11"}));
    EXPECT_EQ(el.Cause(NodeId{5U}), 0);
    static_cast<void>(Do(
        [&]
        {
            el.OnController(ControllerState::kRunning, Now());
            return true;
        }));
    Run(50U);
    EXPECT_EQ(told[5], (Log{"11", "8", "0"}));
}

TEST_F(El6751StartTest, AHoldLastsBehindBootUpAndBusOff)
{
    Verifies(req::SRS_ELM_060);
    // Given a start-up of some ms, and an order in each of them
    AddBox(5U);
    for (std::uint32_t at_ms = 0U; at_ms < 3U; ++at_ms)
    {
        Begin();
        Run(at_ms);
        ASSERT_EQ(Code(5U), 8) << at_ms;
        EXPECT_EQ(Do([this] { return el.Command(NmtCommand::kPreOperational, NodeId{5U}, Now()); }), NmtAnswer::kTaken);
        sent.clear();
        Run(1000U);
        EXPECT_EQ(Commands(), (Log{})) << at_ms;
        EXPECT_EQ(Code(5U), 12) << at_ms;
        // When it restarts, and the manager was off the bus, it is asked anew, and not started
        slaves[5]->Power(Now().us);
        Run(100U);
        EXPECT_EQ(Code(5U), 12) << at_ms;
        for (const ControllerState state : {ControllerState::kBusOff, ControllerState::kRunning})
        {
            static_cast<void>(Do(
                [&]
                {
                    el.OnController(state, Now());
                    return true;
                }));
            Run(100U);
        }
        EXPECT_EQ(Commands(), (Log{"82 00"})) << at_ms;
        EXPECT_EQ(Code(5U), 12) << at_ms;
        EXPECT_FALSE(Of(5U).is_started) << at_ms;
        // But by order
        EXPECT_EQ(Do([this] { return el.Command(NmtCommand::kStart, NodeId{5U}, Now()); }), NmtAnswer::kTaken);
        Run(100U);
        EXPECT_EQ(Code(5U), 0) << at_ms;
    }
}

TEST_F(El6751StartTest, AStartOrderedWhileTheManagerIsBusOffEndsTheHold)
{
    Verifies(req::SRS_ELM_060);
    // Given a slave that runs, and is held while the manager is off the bus
    AddBox(5U);
    Begin();
    Run(100U);
    ASSERT_EQ(Code(5U), 0);
    const auto set = [this](const ControllerState state)
    {
        static_cast<void>(Do(
            [&]
            {
                el.OnController(state, Now());
                return true;
            }));
    };
    const auto order = [this](const NmtCommand command)
    { return Do([&] { return el.Command(command, NodeId{5U}, Now()); }); };
    set(ControllerState::kBusOff);
    Run(50U);
    EXPECT_EQ(order(NmtCommand::kPreOperational), NmtAnswer::kTaken);
    Run(50U);
    // When its start is ordered before the bus is back, then the start-up behind starts it
    EXPECT_EQ(order(NmtCommand::kStart), NmtAnswer::kTaken);
    Run(50U);
    set(ControllerState::kRunning);
    Run(500U);
    EXPECT_EQ(Code(5U), 0);
    EXPECT_TRUE(Of(5U).is_started);
}

TEST_F(El6751StartTest, AControllerThatDoesNotStartIsNodeState13)
{
    Verifies(req::SRS_ELM_045);
    AddBox(5U);
    const auto set = [this](const ControllerState state)
    {
        return Do(
            [&]
            {
                el.OnController(state, Now());
                return true;
            });
    };
    EXPECT_TRUE(set(ControllerState::kAbsent));
    EXPECT_TRUE(sent.empty());
    Begin();
    EXPECT_EQ(Code(5U), 13);
    Run(3000U);
    EXPECT_EQ(Code(5U), 13);
    EXPECT_TRUE(sent.empty());
    EXPECT_EQ(el.MasterState(), 3);
    EXPECT_TRUE(set(ControllerState::kRunning));
    Run(20U);
    EXPECT_EQ(Code(5U), 0);
    EXPECT_EQ(Nmt(), (Log{"3000:82 00", "3003:01 05", "3003:01 00"}));
}

TEST_F(El6751StartTest, TooLittleRoomForThePdosStartsNothing)
{
    Verifies(req::SRS_ELM_033);
    AddBox(5U);
    for (std::uint16_t i = 1U; i <= 65U; ++i)
    {
        Tx(5U, MakePdo(i, 0x180U + i, 255U, 1U, 0U, 0U));
    }
    Begin();
    Run(100U);
    EXPECT_TRUE(sent.empty());
    EXPECT_EQ(el.MasterState(), 4);
}

TEST_F(El6751StartTest, AfterEndNothingIsSentAndNothingIsTaken)
{
    Verifies(req::SRS_ELM_001);
    AddBox(5U);
    Rx(5U, MakePdo(1U, 0x205U, 255U, 1U, 0U, 10U));
    Begin();
    Run(2000U);
    el.End();
    sent.clear();
    slaves[5]->Power(Now().us);
    Run(3000U);
    EXPECT_TRUE(sent.empty());
    EXPECT_EQ(el.MasterState(), 0);
    EXPECT_EQ(Control(5U, 5U, 1U), NmtAnswer::kNotActive);
    EXPECT_EQ(el.Command(NmtCommand::kStart, NodeId{5U}, Now()), NmtAnswer::kNotActive);
    EXPECT_FALSE(el.Boot(NodeId{5U}, Now()));
}

} // namespace
} // namespace counterpoint::cia302
