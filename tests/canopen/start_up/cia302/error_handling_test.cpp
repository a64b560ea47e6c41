// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Losses of slaves, and their return.
#include "tests/canopen/start_up/boot_rig.hpp"
#include "verification/trace/ids/nmt_master.hpp"

#include <algorithm>

namespace counterpoint::cia302
{
namespace
{

using Lines = std::vector<std::string>;
using cia301::NodeState;

constexpr std::uint32_t kGuarded = (3U << 8U) | (100U << 16U);

/// Slaves 5 (mandatory) and 6 (optional) with a heartbeat of 50 ms, watched with 150 ms.
class ErrorHandlingTest : public BootRig
{
  public:
    void Start(std::uint32_t value)
    {
        setup.start_up = value;
        for (const std::uint8_t node : {std::uint8_t{5U}, std::uint8_t{6U}})
        {
            Add(node, (node == 5U) ? kMust : kBoot).heartbeat_ms = 50U;
            setups[node].heartbeat = HeartbeatSetup{150U, 50U, Arming::kFirstHeartbeat};
        }
        Begin();
        Run(200U);
        ASSERT_EQ(Step(), MasterStep::kOperational);
        ASSERT_EQ(Commands().size(), 3U);
        log.clear();
        own.clear();
    }
    /// Commands without their times.
    [[nodiscard]] Lines Told() const
    {
        Lines told{};
        for (const std::string& command : Commands())
        {
            told.push_back(command.substr(command.find(':') + 1U));
        }
        return told;
    }
};

TEST_F(ErrorHandlingTest, LostSlaveAloneIsResetAndBootedWhenItComesBack)
{
    Verifies(req::SRS_BOOT_017);
    Verifies(req::SRS_BOOT_018);
    Start(kIsMaster);
    slaves[5]->Unplug();
    Run(160U);
    EXPECT_EQ(Told(), (Lines{"81 05"}));
    EXPECT_FALSE(Of(5U).is_started);
    EXPECT_EQ(table.RequestValue(NodeId{5U}), 0U);
    Run(5000U);
    EXPECT_EQ(Told(), (Lines{"81 05"})); // Once.
    EXPECT_EQ(table.RequestValue(NodeId{5U}), 1U);
    slaves[5]->Power(Now());
    Run(200U);
    EXPECT_EQ(Told(), (Lines{"81 05", "01 05"}));
    EXPECT_EQ(Letter(5U), "-");
    EXPECT_EQ(slaves[6]->State(), NodeState::kOperational);
    EXPECT_EQ(slaves[6]->resets, 2); // Power-on and the reset of the start.
}

TEST_F(ErrorHandlingTest, ReplacedSlaveIsNotStarted)
{
    Verifies(req::SRS_BOOT_018);
    Start(kIsMaster);
    slaves[5]->Unplug();
    Run(500U);
    slaves[5]->Put32(0x1018U, 4U, 0x9999U);
    slaves[5]->Power(Now());
    Run(200U);
    EXPECT_EQ(Letter(5U), "O");
    EXPECT_EQ(Of(5U).expected, 0x1234U);
    EXPECT_EQ(Of(5U).read, 0x9999U);
    EXPECT_EQ(slaves[5]->State(), NodeState::kPreOperational);
}

TEST_F(ErrorHandlingTest, LostMandatorySlaveResetsAllWithBit4)
{
    Verifies(req::SRS_BOOT_017);
    Start(kIsMaster | kResetAllOnError);
    slaves[5]->heartbeat_ms = 0U;
    slaves[5]->Unplug();
    Run(160U);
    EXPECT_EQ(Told(), (Lines{"81 00", "01 06"}));
    ASSERT_EQ(own.size(), 1U);
    EXPECT_EQ(own[0].command, NmtCommand::kResetNode);
    EXPECT_EQ(Step(), MasterStep::kBooting);
    slaves[5]->heartbeat_ms = 50U;
    slaves[5]->Power(Now());
    Run(300U);
    EXPECT_EQ(Step(), MasterStep::kOperational);
    EXPECT_EQ(slaves[5]->State(), NodeState::kOperational);
    EXPECT_EQ(slaves[6]->State(), NodeState::kOperational);
}

TEST_F(ErrorHandlingTest, LostMandatorySlaveStopsAllWithBit6WhateverBit4Says)
{
    Verifies(req::SRS_BOOT_017);
    Start(kIsMaster | kResetAllOnError | kStopAllOnError);
    slaves[5]->Unplug();
    Run(2000U);
    EXPECT_EQ(Told(), (Lines{"02 00"}));
    ASSERT_EQ(own.size(), 1U);
    EXPECT_EQ(own[0].command, NmtCommand::kStop);
    EXPECT_EQ(Step(), MasterStep::kStopped);
    EXPECT_EQ(slaves[6]->State(), NodeState::kStopped);
    // Nothing goes on by itself, Begin starts anew
    slaves[5]->Power(Now());
    Run(2000U);
    EXPECT_EQ(Told(), (Lines{"02 00"}));
    start_up.Begin(Now());
    Run(200U);
    EXPECT_EQ(Step(), MasterStep::kOperational);
}

TEST_F(ErrorHandlingTest, LostOptionalSlaveIsResetAloneWhateverTheBitsSay)
{
    Verifies(req::SRS_BOOT_017);
    Start(kIsMaster | kResetAllOnError | kStopAllOnError);
    slaves[6]->Unplug();
    Run(3000U);
    EXPECT_EQ(Told(), (Lines{"81 06"}));
    EXPECT_EQ(Step(), MasterStep::kOperational);
    EXPECT_EQ(Of(6U).step, StartUpStep::kWaitBootUp);
}

TEST_F(ErrorHandlingTest, ReactionsWaitForRoomInTheQueue)
{
    Verifies(req::SRS_BOOT_017);
    Verifies(req::SRS_NMM_005);
    Start(kIsMaster | kStopAllOnError);
    FillQueue();
    EXPECT_EQ(nmt.Waiting(), 256U);
    slaves[5]->Unplug();
    static_cast<void>(nmt.Request(NmtCommand::kPreOperational, NodeId{99U}, Now()));
    Run(600U);
    EXPECT_EQ(Told().back(), "02 00");
    EXPECT_EQ(Step(), MasterStep::kStopped);
}

TEST_F(ErrorHandlingTest, GuardedSlaveThatNeverAnswersEndsWithALetter)
{
    Verifies(req::SRS_BOOT_011);
    // Given slaves that are told to be guarded and answer no remote frame: one mandatory, one not
    Add(7U, kBoot | kGuarded).heartbeat_ms = 60000U; // Guarding rests while there is a heartbeat.
    Add(8U, kBoot | kMandatory | kGuarded).heartbeat_ms = 60000U;
    Begin();
    // Supervision begins behind the configuration
    for (int left = 100; (left > 0) && (Of(8U).step != StartUpStep::kErrorControl); --left)
    {
        EXPECT_EQ(Count(0x708U), 0);
        Run(1U);
    }
    EXPECT_EQ(Of(8U).step, StartUpStep::kErrorControl);
    EXPECT_EQ(Letter(8U), "-");
    // Within 3 x 100 ms an answer has to come
    Run(299U);
    EXPECT_EQ(Letter(8U), "-");
    Run(2U);
    EXPECT_EQ(Letter(8U), "K");
    Run(9600U);
    // Then none of them was started, nor reset behind the reset of all
    EXPECT_EQ(Letter(7U), "K");
    EXPECT_EQ(Letter(8U), "K");
    EXPECT_EQ(Of(8U).step, StartUpStep::kErrorControl);
    EXPECT_EQ(Commands(), (Lines{"0:82 00"}));
    EXPECT_EQ(Step(), MasterStep::kHalted);
    // And nobody asks them on
    const int asked = Count(0x707U);
    Run(2000U);
    EXPECT_EQ(Count(0x707U), asked);
}

TEST_F(ErrorHandlingTest, GuardedSlaveThatAnswersLateIsStartedBehindItsFirstAnswer)
{
    Verifies(req::SRS_BOOT_011);
    Add(7U, kBoot | kMandatory | kGuarded);
    Begin();
    Run(20U);
    EXPECT_EQ(Letter(7U), "-");
    EXPECT_EQ(table.Record(NodeId{7U}).watch, Watch::kGuarding);
    EXPECT_TRUE(Of(7U).is_started);
}

TEST_F(ErrorHandlingTest, GuardedSlaveIsLostAfterItsRetries)
{
    Verifies(req::SRS_NMM_023);
    Verifies(req::SRS_BOOT_011);
    Add(7U, kBoot | kGuarded);
    Begin();
    Run(1000U);
    EXPECT_EQ(slaves[7]->State(), NodeState::kOperational);
    EXPECT_EQ(table.Record(NodeId{7U}).state, SlaveState::kOperational);
    log.clear();
    slaves[7]->Unplug();
    Run(250U);
    EXPECT_TRUE(Told().empty());
    Run(160U);
    EXPECT_EQ(Told(), (Lines{"81 07"}));
    slaves[7]->Power(Now());
    Run(1000U);
    EXPECT_EQ(slaves[7]->State(), NodeState::kOperational);
}

TEST_F(ErrorHandlingTest, SlaveThatDoesNotToggleIsLost)
{
    Verifies(req::SRS_NMM_024);
    Add(7U, kBoot | kGuarded).is_toggle_stuck = true;
    Begin();
    Run(1000U);
    // Given boot-up (1) and first answer (2)
    ASSERT_GE(events.size(), 6U);
    // Then one toggle error (7), two misses (5) and the loss (6)
    events.resize(6U);
    EXPECT_EQ(events, (Lines{"1:7 1", "1:7 2", "101:7 7", "201:7 5", "301:7 5", "401:7 6"}));
}

// The first answer behind each boot-up message is right: it is lost three times, and ends at its fourth boot.
TEST_F(ErrorHandlingTest, SlaveThatNeverTogglesIsNotResetForEver)
{
    Verifies(req::SRS_BOOT_026);
    Add(7U, kBoot | kGuarded).is_toggle_stuck = true;
    Begin();
    Run(5000U);
    EXPECT_EQ(Letter(7U), "K");
    EXPECT_EQ(Of(7U).step, StartUpStep::kErrorControl);
    EXPECT_EQ(Of(7U).abort, SdoAbort::kToggle);
    EXPECT_EQ(slaves[7]->State(), NodeState::kPreOperational);
    const Lines resets{"82 00", "01 07", "81 07", "01 07", "81 07", "01 07", "81 07"};
    EXPECT_EQ(Told(), resets);
    Run(5000U);
    EXPECT_EQ(Told(), resets);
    // When it is repaired and boots up by itself, then it is started and stays
    slaves[7]->is_toggle_stuck = false;
    slaves[7]->Power(Now());
    Run(5000U);
    EXPECT_EQ(Letter(7U), "-");
    EXPECT_EQ(slaves[7]->State(), NodeState::kOperational);
    // And from then on a loss by the toggle bit is the first one again
    slaves[7]->is_toggle_stuck = true;
    log.clear();
    Run(600U);
    EXPECT_EQ(Told(), (Lines{"81 07", "01 07"}));
}

TEST_F(ErrorHandlingTest, MandatorySlaveThatNeverTogglesDoesNotResetAllForEver)
{
    Verifies(req::SRS_BOOT_026);
    setup.start_up = kIsMaster | kResetAllOnError;
    Add(7U, kBoot | kMandatory | kGuarded).is_toggle_stuck = true;
    Begin();
    Run(20000U);
    EXPECT_EQ(Letter(7U), "K");
    EXPECT_EQ(Step(), MasterStep::kHalted);
    const Lines told = Told();
    EXPECT_EQ(std::count(told.begin(), told.end(), "81 00") + std::count(told.begin(), told.end(), "82 00"), 4);
}

TEST_F(ErrorHandlingTest, NodesThatAreNotListedMayComeAndGo)
{
    Verifies(req::SRS_BOOT_017);
    Start(kIsMaster);
    Add(9U, 0U).heartbeat_ms = 20U;
    slaves[9]->Power(Now());
    Run(100U);
    slaves[9]->Unplug();
    Run(1000U);
    EXPECT_TRUE(Told().empty());
    EXPECT_EQ(Letter(9U), "A");
}

TEST_F(ErrorHandlingTest, ResetByTheApplicationBootsTheSlaveAnew)
{
    Verifies(req::SRS_BOOT_023);
    Start(kIsMaster);
    EXPECT_EQ(start_up.Command(NmtCommand::kResetNode, NodeId{5U}, Now()), NmtAnswer::kTaken);
    Run(200U);
    EXPECT_EQ(Told(), (Lines{"81 05", "01 05"}));
    // and of all
    EXPECT_EQ(start_up.Command(NmtCommand::kResetCommunication, NodeId{0U}, Now()), NmtAnswer::kTaken);
    Run(200U);
    EXPECT_EQ(slaves[5]->State(), NodeState::kOperational);
    EXPECT_EQ(slaves[6]->State(), NodeState::kOperational);
    EXPECT_EQ(Step(), MasterStep::kOperational);
    // A slave that was reset and does not come back is missed, though nothing supervises it
    slaves[5]->boot_ms = 100000U;
    EXPECT_EQ(start_up.Command(NmtCommand::kResetNode, NodeId{5U}, Now()), NmtAnswer::kTaken);
    Run(1400U);
    EXPECT_EQ(table.RequestValue(NodeId{5U}), 1U);
    EXPECT_TRUE(Of(5U).is_busy);
}

} // namespace
} // namespace counterpoint::cia302
