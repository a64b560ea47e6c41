// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// How a flying master that does not lead watches the one that does, and what is told of the negotiation.
#include "tests/canopen/manager/flying_rig.hpp"
#include "verification/trace/ids/flying_master.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::cia302
{
namespace
{

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

TEST_F(ManagerFlying, TheLossOfAMasterThatNobodyElseWatchesIsToldOnce)
{
    Verifies(req::SRS_MGR_473);
    // Given a master that is in no network list, watched by the flying master alone, for 1500 ms
    Use(NegotiationBy::kManager);
    manager.Begin(Now());
    RunTo(10U);
    Hear(0x071U, {0U, 3U});
    RunTo(100U);
    ASSERT_FALSE(manager.IsActive());
    // When it is silent since its claim
    RunTo(10U + 1500U - 1U);
    EXPECT_EQ(lost, "");
    RunTo(10'000U);
    EXPECT_EQ(lost, "1510 node 3; ");
    EXPECT_EQ(manager.Table().Record(NodeId{3U}).state, SlaveState::kMissing);
    EXPECT_TRUE(manager.IsActive());
}

TEST_F(ManagerFlying, TheLossOfAMasterWithAConsumerTimeIsToldOnce)
{
    Verifies(req::SRS_MGR_473);
    // Given a consumer time of 200 ms for the master, from its claim on
    slaves[3].heartbeat = HeartbeatSetup{200U, 100U, Arming::kImmediately};
    Use(NegotiationBy::kManager);
    manager.Begin(Now());
    RunTo(10U);
    Hear(0x071U, {0U, 3U});
    RunTo(10'000U);
    EXPECT_EQ(lost, "211 node 3; ");
    EXPECT_TRUE(manager.IsActive());
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
    // Nor for commands that are dropped with the role
    ManagerListener& listener = quiet;
    listener.OnNmtUnsent({NmtCommand::kStop, NodeId{5U}}, Now());
    EXPECT_TRUE(other.Role().IsInitialising());
}

} // namespace
} // namespace counterpoint::cia302
