// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The text's table of manual network management, commands, and safety slaves on every way to a start.
#include "tests/canopen/start_up/el6751/rig.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint8_t kStopped = 4U;
constexpr std::uint8_t kOperational = 5U;
constexpr std::uint8_t kPreOperational = 127U;

/// What a pair of ADS state and device state does in each state of the slave: NMT frames to node 5, state afterwards.
struct TableCase
{
    std::uint16_t ads_state;
    std::uint16_t device_state;
    std::uint8_t from;
    Log commands;
    std::uint8_t to;
};

class El6751ByHandTest : public El6751Rig
{
  public:
    /// Slave 5 in this state; heartbeat 100 ms x 3 with the parameter.
    void Prepare(const std::uint8_t state, const bool is_watched)
    {
        AddBox(5U);
        boxes[5].guard_time_ms = is_watched ? std::uint16_t{100U} : std::uint16_t{0U};
        boxes[5].life_time_factor = 3U;
        Begin();
        Run(250U);
        EXPECT_EQ(slaves[5]->state, kOperational);
        if (state == kStopped)
        {
            EXPECT_EQ(Control(5U, 6U, 0U), NmtAnswer::kTaken);
        }
        else if (state == kPreOperational)
        {
            EXPECT_EQ(Control(5U, 5U, 0U), NmtAnswer::kTaken);
        }
        Run(250U);
        EXPECT_EQ(slaves[5]->state, state);
        sent.clear();
        slaves[5]->log.clear();
    }
    void Check(const TableCase& one, const bool is_watched)
    {
        Prepare(one.from, is_watched);
        EXPECT_EQ(Control(5U, one.ads_state, one.device_state), NmtAnswer::kTaken);
        Run(250U);
        EXPECT_EQ(Commands(), one.commands);
        EXPECT_EQ(slaves[5]->state, one.to);
        const int code = (one.to == kOperational) ? 0 : ((one.to == kStopped) ? 1 : 12);
        EXPECT_EQ(Code(5U), code);
        // Whether the whole start-up was done
        EXPECT_EQ(Sdos(5U).size() > 0U, one.commands.front() == "82 05");
        // and nothing happens later
        Run(3000U);
        EXPECT_EQ(Commands(), one.commands);
    }
};

class El6751TableTest : public El6751ByHandTest, public ::testing::WithParamInterface<bool>
{
};

INSTANTIATE_TEST_SUITE_P(Watched, El6751TableTest, ::testing::Bool());

TEST_P(El6751TableTest, OperationalToPreOperational)
{
    Verifies(req::SRS_ELM_046);
    Check(TableCase{5U, 0U, kOperational, {"80 05"}, kPreOperational}, GetParam());
}

TEST_P(El6751TableTest, PreOperationalToOperational)
{
    Verifies(req::SRS_ELM_046);
    Check(TableCase{5U, 1U, kPreOperational, {"01 05"}, kOperational}, GetParam());
}

TEST_P(El6751TableTest, OperationalToStopped)
{
    Verifies(req::SRS_ELM_046);
    Check(TableCase{6U, 0U, kOperational, {"02 05"}, kStopped}, GetParam());
}

TEST_P(El6751TableTest, StoppedToOperationalWithResetCommunication)
{
    Verifies(req::SRS_ELM_046);
    Check(TableCase{5U, 1U, kStopped, {"82 05", "01 05"}, kOperational}, GetParam());
}

TEST_P(El6751TableTest, StoppedToOperationalWithoutResetCommunication)
{
    Verifies(req::SRS_ELM_046);
    Check(TableCase{5U, 3U, kStopped, {"01 05"}, kOperational}, GetParam());
}

TEST_P(El6751TableTest, PreOperationalToStopped)
{
    Verifies(req::SRS_ELM_046);
    Check(TableCase{6U, 0U, kPreOperational, {"02 05"}, kStopped}, GetParam());
}

TEST_P(El6751TableTest, StoppedToPreOperationalWithoutResetCommunication)
{
    Verifies(req::SRS_ELM_046);
    Check(TableCase{5U, 2U, kStopped, {"80 05"}, kPreOperational}, GetParam());
}

TEST_P(El6751TableTest, EverythingElseIsRefusedAndNothingIsSent)
{
    Verifies(req::SRS_ELM_047);
    const auto is_row = [](const std::uint8_t from, const std::uint16_t ads, const std::uint16_t device)
    {
        const bool is_run = (ads == 5U);
        const bool is_stop = (ads == 6U) && (device == 0U);
        return ((from == kOperational) && ((is_run && (device == 0U)) || is_stop)) ||
               ((from == kPreOperational) && ((is_run && (device == 1U)) || is_stop)) ||
               ((from == kStopped) && is_run && (device >= 1U) && (device <= 3U));
    };
    int refused = 0;
    for (const std::uint8_t from : {kOperational, kPreOperational, kStopped})
    {
        Prepare(from, GetParam());
        for (std::uint16_t ads = 0U; ads < 20U; ++ads)
        {
            for (std::uint16_t device = 0U; device < 6U; ++device)
            {
                if (!is_row(from, ads, device))
                {
                    EXPECT_EQ(Control(5U, ads, device), NmtAnswer::kWrong) << int{from} << ads << device;
                    ++refused;
                }
            }
        }
        Run(10U);
        EXPECT_TRUE(sent.empty());
        EXPECT_EQ(slaves[5]->state, from);
    }
    EXPECT_EQ(refused, (3 * 20 * 6) - 7);
}

TEST_F(El6751ByHandTest, NothingIsTakenForOthersOrWhileAStartUpRuns)
{
    Verifies(req::SRS_ELM_047);
    AddBox(5U);
    slaves[5]->Behave(0x1000U, 0U, Manner::kSilent);
    Begin();
    Run(10U);
    sent.clear();
    for (std::uint16_t device = 0U; device < 4U; ++device)
    {
        EXPECT_EQ(Control(5U, 5U, device), NmtAnswer::kWrong);
        EXPECT_EQ(Control(5U, 6U, device), NmtAnswer::kWrong);
        EXPECT_EQ(Control(6U, 5U, device), NmtAnswer::kWrong);
        EXPECT_EQ(Control(127U, 6U, device), NmtAnswer::kWrong);
        EXPECT_EQ(Control(0U, 6U, device), NmtAnswer::kWrong);
    }
    EXPECT_TRUE(sent.empty());
}

TEST_F(El6751ByHandTest, ASlaveHeldByHandThatRestartsIsConfiguredAndNotStarted)
{
    Verifies(req::SRS_ELM_002);
    Prepare(kPreOperational, true);
    slaves[5]->Power(Now().us);
    Run(50U);
    EXPECT_EQ(Sdos(5U), (Log{"r 1000:00", "w 1017:00 64 00", "w 1016:01 2C 01 7F 00"}));
    EXPECT_TRUE(Commands().empty());
    EXPECT_EQ(Code(5U), 12);
    // Its heartbeat may fail without a restart
    slaves[5]->heartbeat_us = 0U;
    Run(500U);
    EXPECT_EQ(Code(5U), 1);
    EXPECT_TRUE(Commands().empty());
    slaves[5]->Beat();
    Run(1U);
    EXPECT_EQ(Code(5U), 12);
}

TEST_F(El6751ByHandTest, ASlaveWhoseStartUpEndedCanBeStartedAndIsNotSupervised)
{
    Verifies(req::SRS_ELM_039);
    Verifies(req::SRS_ELM_046);
    AddBox(5U);
    boxes[5].guard_time_ms = 100U;
    boxes[5].life_time_factor = 3U;
    slaves[5]->Set(0x1000U, 0U, 0x192U);
    Begin();
    Run(50U);
    ASSERT_EQ(Code(5U), 5);
    EXPECT_EQ(Control(5U, 5U, 1U), NmtAnswer::kTaken);
    Run(5000U);
    EXPECT_EQ(Commands(), (Log{"82 00", "01 05", "01 00"}));
    EXPECT_EQ(Code(5U), 0);
}

TEST_F(El6751ByHandTest, ASlaveThatAnsweredNothingIsAskedBeforeItIsStarted)
{
    Verifies(req::SRS_ELM_046);
    // Given a slave that is held before it answered
    AddBox(5U);
    slaves[5]->Behave(0x1000U, 0U, Manner::kSilent);
    Begin();
    Run(10U);
    EXPECT_EQ(Do([&] { return el.Command(NmtCommand::kPreOperational, NodeId{5U}, Now()); }), NmtAnswer::kTaken);
    Run(10U);
    // When it is started
    EXPECT_EQ(Do([&] { return el.Command(NmtCommand::kStart, NodeId{5U}, Now()); }), NmtAnswer::kTaken);
    Run(5000U);
    // Then not before it answers
    EXPECT_EQ(Code(5U), 2);
    EXPECT_FALSE(el.Status(NodeId{5U}).is_started);
    slaves[5]->Behave(0x1000U, 0U, Manner::kGood);
    Run(5000U);
    EXPECT_EQ(Code(5U), 0);
    EXPECT_TRUE(el.Status(NodeId{5U}).is_started);
}

TEST_F(El6751ByHandTest, AStoppedSlaveThatAnsweredNothingIsResetBeforeItIsStarted)
{
    Verifies(req::SRS_ELM_046);
    // Given a slave that is stopped before it answered
    AddBox(5U);
    slaves[5]->Behave(0x1000U, 0U, Manner::kSilent);
    Begin();
    Run(10U);
    EXPECT_EQ(Do([&] { return el.Command(NmtCommand::kStop, NodeId{5U}, Now()); }), NmtAnswer::kTaken);
    Run(10U);
    // When it is started, then a reset comes first
    EXPECT_EQ(Do([&] { return el.Command(NmtCommand::kStart, NodeId{5U}, Now()); }), NmtAnswer::kTaken);
    Run(5000U);
    EXPECT_EQ(Commands(), (Log{"82 00", "02 05", "82 05"}));
    EXPECT_EQ(Code(5U), 2);
    EXPECT_FALSE(el.Status(NodeId{5U}).is_started);
}

TEST_F(El6751ByHandTest, NmtCommandsOfTheApplication)
{
    Verifies(req::SRS_ELM_046);
    Prepare(kOperational, false);
    const auto command = [this](const NmtCommand what, const std::uint8_t node)
    { return Do([&] { return el.Command(what, NodeId{node}, Now()); }); };
    EXPECT_EQ(command(NmtCommand::kStop, 5U), NmtAnswer::kTaken);
    EXPECT_EQ(Code(5U), 1);
    EXPECT_EQ(command(NmtCommand::kPreOperational, 0U), NmtAnswer::kTaken);
    EXPECT_EQ(Code(5U), 12);
    EXPECT_EQ(command(NmtCommand::kStart, 5U), NmtAnswer::kTaken);
    Run(10U);
    EXPECT_EQ(Code(5U), 0);
    EXPECT_EQ(command(NmtCommand::kResetNode, 5U), NmtAnswer::kTaken);
    EXPECT_EQ(Code(5U), 8);
    EXPECT_EQ(command(NmtCommand::kStart, 5U), NmtAnswer::kTaken); // follows the start-up
    Run(20U);
    EXPECT_EQ(Commands(), (Log{"02 05", "80 05", "01 05", "81 05", "01 05"}));
    EXPECT_TRUE(Do([this] { return el.Boot(NodeId{5U}, Now()); }));
    Run(20U);
    EXPECT_EQ(Commands(), (Log{"02 05", "80 05", "01 05", "81 05", "01 05", "82 05", "01 05"}));
    EXPECT_EQ(command(NmtCommand::kPreOperational, 127U), NmtAnswer::kTaken); // This device itself: nothing is sent.
    EXPECT_EQ(Commands().size(), 7U);
    EXPECT_EQ(command(NmtCommand::kStart, 9U), NmtAnswer::kWrong);
    EXPECT_EQ(command(NmtCommand::kInvalid, 5U), NmtAnswer::kWrong);
    EXPECT_FALSE(el.Boot(NodeId{9U}, Now()));
}

} // namespace
} // namespace counterpoint::cia302
