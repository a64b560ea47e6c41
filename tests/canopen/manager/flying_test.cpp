// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// A manager with a flying master and a profile that does nothing: what it does with the role that was negotiated.
#include "canopen/manager/manager.hpp"
#include "verification/trace/ids/flying_master.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <string>
#include <vector>

namespace counterpoint::cia302
{
namespace
{

using Lines = std::vector<std::string>;

/// Tells when it is to lead the network.
class IdleProfile final : public StartUp
{
  public:
    explicit IdleProfile(std::vector<std::string>& log) : log_(log)
    {
    }
    void Begin(const Instant /*now*/) noexcept override
    {
        log_.emplace_back("leads");
    }
    void End() noexcept override
    {
        log_.emplace_back("leads no more");
    }
    void OnFrame(const CanFrame& /*frame*/, const Instant /*now*/) noexcept override
    {
    }
    void OnCycle(const Instant /*now*/) noexcept override
    {
    }
    void OnRoom(const Instant /*now*/) noexcept override
    {
        ++rooms;
    }
    void OnNodeEvent(const NodeId /*node*/, const NodeEvent /*event*/, const Instant /*now*/) noexcept override
    {
    }
    [[nodiscard]] NmtAnswer Command(const NmtCommand /*command*/, const NodeId /*node*/,
                                    const Instant /*now*/) noexcept override
    {
        return NmtAnswer::kTaken;
    }
    [[nodiscard]] bool Boot(const NodeId /*node*/, const Instant /*now*/) noexcept override
    {
        return true;
    }
    [[nodiscard]] bool Configure(const NodeId /*node*/, const Instant /*now*/) noexcept override
    {
        return true;
    }
    [[nodiscard]] NodeStatus Status(const NodeId /*node*/) const noexcept override
    {
        return NodeStatus{};
    }
    [[nodiscard]] std::int16_t MasterState() const noexcept override
    {
        return 0;
    }

    int rooms{0}; ///< How often it was offered room in the sink.

  private:
    std::vector<std::string>& log_;
};

/// Node 5 of level 1, own heartbeat each 1000 ms, cycle 1 ms; nobody watches the master by 1016h but the flying master.
/// What leaves and what happens is written down; heartbeats without their time.
class ManagerFlying : public ::testing::Test, public cia301::FrameSink, public ManagerListener
{
  protected:
    void Use(const NegotiationBy by)
    {
        times.priority = 1U;
        manager.Use(profile);
        manager.Role().Use(flying, by);
    }
    void RunTo(const std::uint32_t ms)
    {
        while (now_ms < ms)
        {
            ++now_ms;
            manager.OnCycle(Now());
        }
    }
    void Hear(const std::uint32_t identifier, const std::vector<std::uint8_t>& data = {})
    {
        CanFrame frame{identifier, FrameKind::kData, CanPortId::kFirst, static_cast<std::uint8_t>(data.size()), {}};
        std::copy(data.begin(), data.end(), frame.data);
        manager.OnFrame(frame, Now());
    }
    /// Since the last call.
    Lines Log()
    {
        Lines log{};
        log.swap(log_);
        return log;
    }
    [[nodiscard]] Instant Now() const
    {
        return Instant{now_ms * 1000U};
    }

    bool Send(const CanFrame& frame) noexcept override
    {
        const bool is_taken = refuses == 0U;
        refuses -= is_taken ? 0U : 1U;
        std::array<char, 32> text{};
        std::snprintf(text.data(), text.size(), "%u %03X", static_cast<unsigned>(now_ms),
                      static_cast<unsigned>(frame.identifier));
        std::string line = text.data();
        for (std::uint8_t i = 0U; i < frame.length_bytes; ++i)
        {
            std::snprintf(text.data(), text.size(), " %02X", static_cast<unsigned>(frame.data[i]));
            line += text.data();
        }
        if (is_taken)
        {
            log_.push_back(line);
        }
        return is_taken;
    }
    void OnNodeEvent(const NodeId /*node*/, const NodeEvent /*event*/, const Instant /*now*/) noexcept override
    {
    }
    void OnNodeStatus(const NodeId /*node*/, const Instant /*now*/) noexcept override
    {
    }
    void OnMasterState(const std::int16_t /*state*/, const Instant /*now*/) noexcept override
    {
    }
    void OnNmtSent(const NmtRequest& /*request*/, const Instant /*now*/) noexcept override
    {
    }
    void OnGate(const NodeId /*node*/, const GateState /*state*/, const Instant /*now*/) noexcept override
    {
    }
    void OnEmergency(const NodeId /*node*/, const EmergencyRecord& /*emergency*/,
                     const Instant /*now*/) noexcept override
    {
    }
    void OnDuplicate(const NodeId /*node*/, const Instant /*now*/) noexcept override
    {
    }
    void OnFlyingMaster(const FlyingEvent event, const MasterClaim& claim, const Instant /*now*/) noexcept override
    {
        log_.push_back("event " + std::to_string(static_cast<int>(event)) + " " + std::to_string(claim.level) + "/" +
                       std::to_string(claim.node.value));
    }
    void OnNegotiationRefused(const FlyingStart reason, const Instant /*now*/) noexcept override
    {
        log_.push_back(std::to_string(now_ms) + " refused " + std::to_string(static_cast<int>(reason)));
    }
    void OnInitialising(const Instant /*now*/) noexcept override
    {
        log_.push_back(std::to_string(now_ms) + " initialising");
    }

    std::vector<std::string> log_{};
    std::uint32_t now_ms{0U};
    std::uint32_t refuses{0U};
    std::array<SlaveSetup, kNodeRoom> slaves{};
    NetworkSetup setup{NodeId{5U}, 0x21U, 0U, 0U, 0U, slaves.data()};
    FlyingMasterTimes times{DefaultTimes(NodeId{5U})};
    FlyingMasterOptions options{DefaultFlyingMaster()};
    std::array<NodeRecord, kNodeRoom> records{};
    std::array<WatchedNode, kNodeRoom> watched{};
    std::array<GateState, kNodeRoom> gates{};
    std::array<NmtRequest, 8U> commands{};
    std::array<SafetySlot, 1U> safety{};
    SdoLanes<2U> lanes{*this, SdoTimes{500'000U, 3U}};
    IdleProfile profile{log_};
    Manager manager{ManagerParts{setup, *this, *this,
                                 ManagerRoom{records.data(),
                                             watched.data(),
                                             gates.data(),
                                             {commands.data(), 8U},
                                             {safety.data(), 1U},
                                             lanes.All(),
                                             SdoTimes{500'000U, 3U}},
                                 1000U}};
    FlyingMaster flying{FlyingMasterParts{setup, times, options, *this, manager.Role()}};
};

TEST_F(ManagerFlying, NegotiationOnTheApplicationsCallWithWhatItWrote)
{
    Verifies(req::SRS_FLY_007);
    Verifies(req::SRS_FLY_027);
    Verifies(req::SRS_FLY_002);
    Use(NegotiationBy::kApplication);
    manager.Begin(Now());
    RunTo(10'000U);
    EXPECT_EQ(Log(), Lines{"0 initialising"});
    EXPECT_EQ(manager.OwnState(), cia301::NodeState::kInitialising);
    // When it wrote a slot relation that cannot work, and one that can
    FlyingMasterObject object(times);
    EXPECT_EQ(object.Write(4U, 1270U), cia301::SdoAbort::kNone);
    EXPECT_EQ(manager.Role().StartNegotiation(Now()), FlyingStart::kSlots);
    EXPECT_EQ(object.Write(4U, 2000U), cia301::SdoAbort::kNone);
    EXPECT_EQ(object.Write(2U, 300U), cia301::SdoAbort::kNone);
    EXPECT_EQ(manager.Role().StartNegotiation(Now()), FlyingStart::kStarted);
    EXPECT_EQ(manager.Role().StartNegotiation(Now()), FlyingStart::kNotInitialising);
    RunTo(20'000U);
    // Then the power-on reset ends in INITIALISATION again, and nothing happens before the next call
    EXPECT_EQ(Log(), (Lines{"10300 073", "10400 000 82 00", "event 3 0/0", "10400 initialising"}));
    EXPECT_EQ(manager.Role().StartNegotiation(Now()), FlyingStart::kStarted);
    RunTo(22'450U);
    // 20000 + 300 + 100 + 1 x 2000 + 5 x 10
    EXPECT_EQ(Log(), (Lines{"20300 073", "20400 072", "22450 071 01 05", "event 4 1/5", "leads", "22450 705 00"}));
}

TEST_F(ManagerFlying, RoomInTheSinkIsOfferedToTheProfileThatLeads)
{
    Verifies(req::SRS_ELM_230);
    Use(NegotiationBy::kManager);
    manager.Begin(Now());
    RunTo(2000U);
    Hear(0x710U, {0x05U});
    EXPECT_EQ(profile.rooms, 0);
    RunTo(4000U);
    ASSERT_TRUE(manager.IsActive());
    const int before = profile.rooms;
    Hear(0x710U, {0x05U});
    EXPECT_EQ(profile.rooms, before + 1);
    RunTo(4001U);
    EXPECT_EQ(profile.rooms, before + 2);
}

TEST_F(ManagerFlying, WhatTheActiveMasterOwesLeavesWithTheFirstRoom)
{
    Verifies(req::SRS_MGR_231);
    Use(NegotiationBy::kManager);
    manager.Begin(Now());
    RunTo(4000U);
    ASSERT_TRUE(manager.IsActive());
    Log();
    // When somebody asks who is master, and the sink is full
    refuses = 1'000'000U;
    Hear(0x073U);
    RunTo(4100U);
    EXPECT_EQ(Log(), Lines{});
    // Then the answer leaves with the next frame, whatever it is, and once
    refuses = 0U;
    Hear(0x710U, {0x05U});
    Hear(0x710U, {0x05U});
    EXPECT_EQ(Log(), Lines{"4100 071 01 05"});
    // And so does what it sends again and again, with the heartbeat behind it
    refuses = 1'000'000U;
    RunTo(9000U);
    refuses = 0U;
    Hear(0x710U, {0x05U});
    Hear(0x710U, {0x05U});
    EXPECT_EQ(Log(), (Lines{"9000 076", "9000 705 7F"}));
    // When it is not the active master any more, nothing is owed
    refuses = 1'000'000U;
    Hear(0x073U);
    RunTo(9100U);
    Hear(0x071U, {0x00U, 0x02U});
    refuses = 0U;
    Hear(0x710U, {0x05U});
    EXPECT_FALSE(manager.IsActive());
    for (const std::string& line : Log())
    {
        EXPECT_EQ(line.find("071 01"), std::string::npos) << line;
    }
}

TEST_F(ManagerFlying, AnActiveMasterWithoutACyclicMessageOwesNothing)
{
    Verifies(req::SRS_MGR_231);
    Use(NegotiationBy::kManager);
    times.detection_cycle = 0U;
    manager.Begin(Now());
    RunTo(4000U);
    ASSERT_TRUE(manager.IsActive());
    Log();
    refuses = 1'000'000U;
    RunTo(4800U);
    refuses = 0U;
    Hear(0x710U, {0x05U});
    EXPECT_EQ(Log(), Lines{"4800 705 7F"});
}

TEST_F(ManagerFlying, ValuesThatCannotWorkAreToldOnceAndMayBeCorrected)
{
    Verifies(req::SRS_FLY_027);
    Use(NegotiationBy::kManager);
    times.priority_slot = 1270U;
    manager.Begin(Now());
    RunTo(2000U);
    EXPECT_EQ(Log(), (Lines{"0 initialising", "1 refused 4"}));
    times.priority_slot = 1271U;
    RunTo(2501U);
    EXPECT_EQ(Log(), Lines{"2501 073"});
}

TEST_F(ManagerFlying, WithoutAFlyingMasterThereIsNoNegotiation)
{
    Verifies(req::SRS_FLY_027);
    manager.Use(profile);
    EXPECT_EQ(manager.Role().StartNegotiation(Now()), FlyingStart::kInvalid);
}

// t [ms]  501  540 (slave of 0/9)  2040 lost     2540  2640  4190 = 2640 + 1500 + 50
//         073  boot-up             INITIALISING  073   072   071, boot-up
TEST_F(ManagerFlying, WhoNegotiatesAfterALossIsInitialisingAndBootsUpAgain)
{
    Verifies(req::SRS_FLY_028);
    Use(NegotiationBy::kManager);
    manager.Begin(Now());
    RunTo(540U);
    Hear(0x71U, {0U, 9U});
    RunTo(541U);
    EXPECT_EQ(Log(), (Lines{"0 initialising", "501 073", "event 1 0/9", "541 705 00"}));
    Hear(0U, {1U, 0U});
    EXPECT_EQ(manager.OwnState(), cia301::NodeState::kOperational);
    // Given a heartbeat of its own, then a master that was silent for 1500 ms since its claim
    RunTo(2039U);
    EXPECT_EQ(Log(), (Lines{"542 705 05", "1542 705 05"}));
    RunTo(2041U);
    EXPECT_EQ(manager.OwnState(), cia301::NodeState::kInitialising);
    static_cast<void>(Log());
    RunTo(4190U);
    // Then no heartbeat leaves until it has a role, and the boot-up message comes first
    EXPECT_EQ(Log(), (Lines{"2540 073", "2640 072", "4190 071 01 05", "event 4 1/5", "leads", "4190 705 00"}));
    EXPECT_EQ(manager.OwnState(), cia301::NodeState::kPreOperational);
}

TEST_F(ManagerFlying, ARaceOrRestartAtAForceEndsTheLeadAtOnce)
{
    Verifies(req::SRS_MGR_002);
    Verifies(req::SRS_MGR_212);
    for (const ForceReaction reaction : {ForceReaction::kRace, ForceReaction::kRestart, ForceReaction::kResetAll})
    {
        SCOPED_TRACE(static_cast<int>(reaction));
        options.on_force = reaction;
        Use(NegotiationBy::kManager);
        if (!manager.IsActive())
        {
            manager.Begin(Now());
            RunTo(now_ms + 3000U);
        }
        ASSERT_TRUE(manager.IsActive());
        // When 076h is heard and no frame can leave
        refuses = 1U;
        Hear(0x76U);
        // Then it commands nobody any more
        EXPECT_FALSE(manager.IsActive());
        EXPECT_EQ(manager.Role().Command(NmtCommand::kStart, NodeId{9U}, Now()), NmtAnswer::kNotActive);
        refuses = 0U;
        RunTo(now_ms + 3000U);
        EXPECT_TRUE(manager.IsActive());
    }
}

TEST_F(ManagerFlying, OffTheBusNoRoleIsKeptAndNoneNegotiatedBeforeItIsBack)
{
    Verifies(req::SRS_FLY_150);
    Use(NegotiationBy::kManager);
    manager.Begin(Now());
    RunTo(3000U);
    ASSERT_TRUE(manager.IsActive());
    static_cast<void>(Log());
    // When the controller of the active master goes bus-off, told twice
    manager.OnBus(false, Now());
    manager.OnBus(false, Now());
    // Then it commands nobody at once, and nothing is tried before the bus is back
    EXPECT_FALSE(manager.IsActive());
    EXPECT_EQ(manager.Role().Command(NmtCommand::kStart, NodeId{9U}, Now()), NmtAnswer::kNotActive);
    RunTo(8000U);
    EXPECT_EQ(Log(), (Lines{"leads no more", "3000 initialising"}));
    EXPECT_EQ(manager.Role().StartNegotiation(Now()), FlyingStart::kNoBus);
    manager.OnBus(true, Now());
    RunTo(10'151U);
    // Then it asks, and resets nobody: 8001 + 500, + 100, + 1 x 1500 + 5 x 10
    EXPECT_EQ(Log(), (Lines{"8501 073", "8601 072", "10151 071 01 05", "event 4 1/5", "leads", "10151 705 00"}));
}

TEST_F(ManagerFlying, OffTheBusAManagerWithoutAFlyingMasterLeadsOn)
{
    Verifies(req::SRS_FLY_150);
    manager.Use(profile);
    manager.Begin(Now());
    manager.OnBus(false, Now());
    RunTo(10U);
    EXPECT_TRUE(manager.IsActive());
}

TEST_F(ManagerFlying, ResettingItselfEndsTheRoleAndResettingAllDoesNot)
{
    Verifies(req::SRS_FLY_151);
    Use(NegotiationBy::kManager);
    manager.Begin(Now());
    RunTo(3000U);
    ASSERT_TRUE(manager.IsActive());
    NmtMaster& nmt = manager.ProfileParts().nmt;
    static_cast<void>(Log());
    // When it resets all nodes, or another one
    EXPECT_EQ(nmt.Request(NmtCommand::kResetCommunication, kAllNodes, Now()), NmtAnswer::kTaken);
    EXPECT_EQ(nmt.Request(NmtCommand::kResetNode, NodeId{9U}, Now()), NmtAnswer::kTaken);
    RunTo(3010U);
    // Then it stays the master
    EXPECT_TRUE(manager.IsActive());
    static_cast<void>(Log());
    // When it resets itself
    EXPECT_EQ(nmt.Request(NmtCommand::kResetNode, NodeId{5U}, Now()), NmtAnswer::kTaken);
    RunTo(5161U);
    // Then it asks as anybody else: 3011 + 500, + 100, + 1 x 1500 + 5 x 10
    EXPECT_EQ(Log(), (Lines{"leads no more", "3011 initialising", "3511 073", "3611 072", "5161 071 01 05",
                            "event 4 1/5", "leads", "5161 705 00"}));
}

TEST_F(ManagerFlying, WhatIsTwiceSaidIsDoneOnce)
{
    Verifies(req::SRS_MGR_002);
    Use(NegotiationBy::kManager);
    manager.OnBus(false, Now()); // Before it has begun there is nothing to reset.
    manager.OnBus(true, Now());
    manager.Begin(Now());
    RunTo(3000U);
    ASSERT_TRUE(manager.IsActive());
    static_cast<void>(Log());
    const MasterClaim own{1U, NodeId{5U}};
    manager.Role().OnFlyingMaster(FlyingEvent::kMasterMode, own, Now());
    // Told something that ends no role, it is still the master
    manager.Role().OnFlyingMaster(FlyingEvent::kConfigurationError, own, Now());
    EXPECT_TRUE(manager.IsActive());
    EXPECT_EQ(Log(), (Lines{"event 4 1/5", "event 5 1/5"}));
    // And obeys nobody: whoever commands all, or this device
    Hear(0U, {0x02U, 5U});
    Hear(0U, {0x02U, 0U});
    EXPECT_NE(manager.OwnState(), cia301::NodeState::kStopped);
}

TEST_F(ManagerFlying, AsSlaveItObeysCommandsAndWatchesItsMaster)
{
    Verifies(req::SRS_MGR_002);
    Verifies(req::SRS_MGR_210);
    slaves[3].heartbeat = HeartbeatSetup{200U, 100U, Arming::kImmediately};
    Use(NegotiationBy::kManager);
    manager.Begin(Now());
    RunTo(10U);
    Hear(0x071U, {0U, 3U}); // A master of a higher priority.
    RunTo(100U);
    ASSERT_FALSE(manager.IsActive());
    static_cast<void>(Log());
    EXPECT_FALSE(manager.Role().Boot(NodeId{9U}, Now()));
    EXPECT_FALSE(manager.Role().Resume(NodeId{9U}, Now()));
    for (const std::uint8_t command : {std::uint8_t{0x80U}, std::uint8_t{0U}, std::uint8_t{0x55U}})
    {
        Hear(0U, {command, 5U});
        EXPECT_EQ(manager.OwnState(), cia301::NodeState::kPreOperational);
    }
    Hear(0x706U, {5U}); // A node that was never heard.
    EXPECT_FALSE(manager.IsActive());
    // When the master is silent, then it negotiates
    RunTo(2500U);
    const Lines log = Log();
    EXPECT_NE(std::find(log.begin(), log.end(), "leads"), log.end());
}

TEST_F(ManagerFlying, BegunWhileItNegotiatesItGoesOn)
{
    Verifies(req::SRS_FLY_002);
    Use(NegotiationBy::kManager);
    manager.Begin(Now());
    RunTo(600U);
    ASSERT_EQ(manager.Role().StartNegotiation(Now()), FlyingStart::kNotInitialising);
    manager.Begin(Now());
    RunTo(4000U);
    const Lines log = Log();
    EXPECT_NE(std::find(log.begin(), log.end(), "leads"), log.end());
    EXPECT_EQ(std::count_if(log.begin(), log.end(),
                            [](const std::string& line) { return line.find("refused") != std::string::npos; }),
              0);
}

TEST_F(ManagerFlying, WhatIsWrittenToASafetySlaveIsTheConcernOfTheMaster)
{
    Verifies(req::SRS_MGR_002);
    static constexpr ExpectedObject kExpected[]{{{0x1301U, 1U}, 1U, false}};
    static constexpr SafetyExpectation kExpectation{kExpected, 1U};
    // Given a manager that knows a safety slave, and is the slave of another one
    slaves[9].assignment = kInNetwork | kBootSlave;
    slaves[9].safety = &kExpectation;
    Manager other{ManagerParts{setup, *this, *this,
                               ManagerRoom{records.data(),
                                           watched.data(),
                                           gates.data(),
                                           {commands.data(), 8U},
                                           {safety.data(), 1U},
                                           lanes.All(),
                                           SdoTimes{500'000U, 3U}},
                               1000U}};
    FlyingMaster its{FlyingMasterParts{setup, times, options, *this, other.Role()}};
    other.Use(profile);
    other.Role().Use(its, NegotiationBy::kManager);
    times.priority = 1U;
    other.Begin(Now());
    const auto hear = [this, &other](const std::uint32_t identifier, const std::vector<std::uint8_t>& data)
    {
        CanFrame frame{identifier, FrameKind::kData, CanPortId::kFirst, static_cast<std::uint8_t>(data.size()), {}};
        std::copy(data.begin(), data.end(), frame.data);
        other.OnFrame(frame, Now());
        other.OnCycle(Now());
    };
    hear(0x071U, {0U, 3U});
    ASSERT_FALSE(other.IsActive());
    // When somebody writes its safety configuration, then nothing is presumed of it
    hear(0x589U, {0x60U, 0x01U, 0x13U, 0x01U, 0U, 0U, 0U, 0U});
    EXPECT_EQ(other.Gate().State(NodeId{9U}), GateState::kClosed);
    EXPECT_EQ(other.Table().Record(NodeId{9U}).signs, 0U);
}

TEST_F(ManagerFlying, ItWatchesItsMasterByTheConsumerTimeOfTheNetwork)
{
    Verifies(req::SRS_MGR_210);
    // Given a preset that leaves it to the manager, and 200 ms for node 3
    options.watch = MasterWatch::kApplication;
    slaves[3].heartbeat = HeartbeatSetup{200U, 100U, Arming::kFirstHeartbeat};
    Use(NegotiationBy::kManager);
    manager.Begin(Now());
    RunTo(10U);
    Hear(0x071U, {0U, 3U});
    RunTo(100U);
    ASSERT_FALSE(manager.IsActive());
    static_cast<void>(Log());
    // When its heartbeat comes each 200 ms, then it stays slave
    for (std::uint32_t ms = 100U; ms <= 1700U; ms += 200U)
    {
        RunTo(ms);
        Hear(0x703U, {5U});
    }
    RunTo(2390U);
    EXPECT_EQ(Log(), Lines{"1012 705 7F"}); // Its own, until it begins anew.
    // And when the next one does not come until 1900 ms, it asks for a master 500 ms later
    RunTo(2410U);
    EXPECT_EQ(Log().size(), 1U);
    RunTo(6000U);
    EXPECT_TRUE(manager.IsActive());
}

TEST_F(ManagerFlying, WithoutAConsumerTimeNobodyWatchesTheMaster)
{
    Verifies(req::SRS_MGR_211);
    // Given a preset that leaves it to the manager, which has no time for node 3
    options.watch = MasterWatch::kApplication;
    Use(NegotiationBy::kManager);
    manager.Begin(Now());
    RunTo(10U);
    Hear(0x071U, {0U, 3U});
    RunTo(100U);
    ASSERT_FALSE(manager.IsActive());
    Hear(0x703U, {5U});
    static_cast<void>(Log());
    // When it is silent for a minute, then this one stays slave
    RunTo(60'000U);
    EXPECT_FALSE(manager.IsActive());
    const Lines log = Log();
    EXPECT_TRUE(std::all_of(log.begin(), log.end(),
                            [](const std::string& line) { return line.find(" 705 7F") != std::string::npos; }));
}

/// Tells nobody what the negotiation does.
class QuietListener final : public ManagerListener
{
  public:
    void OnNodeEvent(NodeId, NodeEvent, Instant) noexcept override
    {
    }
    void OnNodeStatus(NodeId, Instant) noexcept override
    {
    }
    void OnMasterState(std::int16_t, Instant) noexcept override
    {
    }
    void OnNmtSent(const NmtRequest&, Instant) noexcept override
    {
    }
    void OnGate(NodeId, GateState, Instant) noexcept override
    {
    }
    void OnEmergency(NodeId, const EmergencyRecord&, Instant) noexcept override
    {
    }
    void OnDuplicate(NodeId, Instant) noexcept override
    {
    }
    void OnFlyingMaster(FlyingEvent, const MasterClaim&, Instant) noexcept override
    {
    }
};

TEST_F(ManagerFlying, AListenerNeedNotCareForTheNegotiation)
{
    Verifies(req::SRS_FLY_027);
    QuietListener quiet;
    Manager other{ManagerParts{setup, *this, quiet,
                               ManagerRoom{records.data(),
                                           watched.data(),
                                           gates.data(),
                                           {commands.data(), 8U},
                                           {safety.data(), 1U},
                                           lanes.All(),
                                           SdoTimes{500'000U, 3U}},
                               1000U}};
    FlyingMaster its{FlyingMasterParts{setup, times, options, *this, other.Role()}};
    other.Use(profile);
    other.Role().Use(its, NegotiationBy::kManager);
    times.priority = 1U;
    FlyingMasterObject object(times);
    EXPECT_EQ(object.Write(4U, 1270U), cia301::SdoAbort::kNone); // Slots that cannot work.
    other.Begin(Now());
    other.OnCycle(Now());
    EXPECT_TRUE(other.Role().IsInitialising());
    EXPECT_FALSE(other.IsActive());
}

} // namespace
} // namespace counterpoint::cia302
