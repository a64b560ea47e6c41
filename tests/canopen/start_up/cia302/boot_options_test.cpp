// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Options of slaves and the moments at which they count.
#include "tests/canopen/start_up/boot_rig.hpp"
#include "verification/trace/ids/nmt_master.hpp"

#include <algorithm>

namespace counterpoint::cia302
{
namespace
{

using cia301::NodeState;

class BootOptionsTest : public BootRig
{
  public:
    [[nodiscard]] bool Has(const std::string& event) const
    {
        return std::find(events.begin(), events.end(), event) != events.end();
    }
};

// Given two slaves that are not there, when one of them is supervised at once, then its loss is told when its consumer
// time is over, once, and of the other one nothing.
TEST_F(BootOptionsTest, WhoIsSupervisedAtOnceIsLostThoughItNeverCame)
{
    Verifies(req::SRS_NMM_022);
    setups[5].assignment = kMust;
    setups[5].heartbeat = HeartbeatSetup{300U, 100U, Arming::kImmediately};
    setups[6].assignment = kMust;
    setups[6].heartbeat = HeartbeatSetup{300U, 100U, Arming::kFirstHeartbeat};
    Begin();
    Run(3000U);
    EXPECT_EQ(events, (std::vector<std::string>{"301:5 4"}));
    EXPECT_EQ(table.RequestValue(NodeId{5U}), 1U);
    EXPECT_EQ(Letter(5U), "-"); // It is asked for as ever.
    EXPECT_EQ(Step(), MasterStep::kBooting);
}

// Given slaves that boot up and send no heartbeat and answer no SDO, when one of them is supervised from its boot-up
// message on, then that one is told as lost.
TEST_F(BootOptionsTest, WhoIsSupervisedFromItsBootUpIsLostWhileItBoots)
{
    Verifies(req::SRS_NMM_022);
    Add(5U, kBoot).is_sdo_mute = true;
    setups[5].heartbeat = HeartbeatSetup{200U, 100U, Arming::kBootUp};
    Add(6U, kBoot).is_sdo_mute = true;
    setups[6].heartbeat = HeartbeatSetup{200U, 100U, Arming::kFirstHeartbeat};
    Begin();
    Run(1000U);
    EXPECT_EQ(events, (std::vector<std::string>{"1:5 1", "1:6 1", "202:5 4"}));
    // A second boot-up message begins the time anew
    slaves[5]->Power(Now());
    Run(300U);
    EXPECT_TRUE(Has("1001:5 1"));
    EXPECT_TRUE(Has("1202:5 4"));
}

// Given safety slaves that are listed and not to be booted, then they are verified all the same, and not started.
TEST_F(BootOptionsTest, ASafetySlaveThatIsNotToBeBootedIsVerified)
{
    Verifies(req::SRS_BOOT_012);
    Add(5U, kInNetwork);
    Protect(5U);
    Begin();
    Run(2000U);
    EXPECT_EQ(gate.verifications, 1);
    EXPECT_EQ(Commands(), (std::vector<std::string>{"0:82 00"}));
    EXPECT_EQ(slaves[5]->State(), NodeState::kPreOperational);
}

// Given four slaves that are reset by their restored defaults, when the inhibit time lets the last reset leave after
// 1.6 s, then none of them fails: the time of its boot-up message begins with its reset.
TEST_F(BootOptionsTest, ResetsThatWaitForTheInhibitTimeTakeNothingFromTheBootUpTime)
{
    Verifies(req::SRS_BOOT_009);
    setup.inhibit_100us = 4000U;
    for (const std::uint8_t node : {std::uint8_t{5U}, std::uint8_t{6U}, std::uint8_t{7U}, std::uint8_t{8U}})
    {
        Add(node, kMust | kRestoreDefaults).Put32(0x1011U, 1U, 0U);
        setups.at(node).restore_sub = 1U;
    }
    Begin();
    Run(6000U);
    for (const std::uint8_t node : {std::uint8_t{5U}, std::uint8_t{6U}, std::uint8_t{7U}, std::uint8_t{8U}})
    {
        EXPECT_EQ(Letter(node), "-");
        EXPECT_EQ(slaves[node]->State(), NodeState::kOperational);
        EXPECT_EQ(slaves[node]->resets, 3); // Power-on, network, defaults.
    }
    const std::vector<std::string> commands = Commands();
    EXPECT_EQ(commands.at(1), "400:81 05");
    EXPECT_EQ(commands.at(4), "1600:81 08");
}

// Given a concise DCF that says more entries than it has, or has a byte too many, then its slave is not touched.
TEST_F(BootOptionsTest, NothingIsWrittenOfADamagedConciseDcf)
{
    Verifies(req::SRS_BOOT_010);
    Octets dcf{};
    AddEntry(dcf, 0x1018U, 4U, {1U, 2U, 3U, 4U});
    AddEntry(dcf, 0x1018U, 3U, {1U, 2U, 3U, 4U});
    Octets more = dcf;
    more[0] = 3U;
    Octets longer = dcf;
    longer.push_back(0U);
    Octets past = dcf;
    past[7] = 20U; // Size of the first entry.
    const Octets half(3U, 0U);
    const Octets none(4U, 0U);
    const Octets* const all[6] = {&dcf, &more, &longer, &past, &half, &none};
    for (std::uint8_t i = 0U; i < 6U; ++i)
    {
        const auto node = static_cast<std::uint8_t>(5U + i);
        Add(node, kMust);
        setups.at(node).concise_dcf = Bytes{all[i]->data(), static_cast<std::uint32_t>(all[i]->size())};
    }
    Begin();
    Run(50U);
    for (const std::uint8_t node : {std::uint8_t{6U}, std::uint8_t{7U}, std::uint8_t{8U}, std::uint8_t{9U}})
    {
        EXPECT_EQ(Letter(node), "J");
        EXPECT_EQ(Of(node).object.index, 0x1F22U);
        EXPECT_EQ(Of(node).object.sub, node);
        EXPECT_TRUE(slaves[node]->writes.empty());
    }
    EXPECT_EQ(Letter(5U), "-");
    EXPECT_EQ(slaves[5]->writes.size(), 2U);
    EXPECT_EQ(Letter(10U), "-");
}

// Given a running slave, when its configuration alone is asked for and resets it, then it runs again.
TEST_F(BootOptionsTest, WhoIsResetByItsNewConfigurationIsStartedAgain)
{
    Verifies(req::SRS_NMM_153);
    FakeSlave& slave = Add(5U, kMust | kRestoreDefaults);
    slave.Put32(0x1011U, 1U, 0U);
    slave.heartbeat_ms = 50U;
    setups[5].restore_sub = 1U;
    setups[5].heartbeat = HeartbeatSetup{150U, 50U, Arming::kFirstHeartbeat};
    Begin();
    Run(500U);
    EXPECT_EQ(slave.State(), NodeState::kOperational);
    EXPECT_TRUE(start_up.Configure(NodeId{5U}, Now()));
    Run(500U);
    EXPECT_EQ(slave.resets, 4); // Power-on, network, defaults, and defaults again.
    EXPECT_EQ(slave.State(), NodeState::kOperational);
    EXPECT_EQ(Letter(5U), "-");
    EXPECT_TRUE(Of(5U).is_started);
    // One that an order holds is reset, and not started again
    EXPECT_EQ(start_up.Command(NmtCommand::kPreOperational, NodeId{5U}, Now()), NmtAnswer::kTaken);
    EXPECT_TRUE(start_up.Configure(NodeId{5U}, Now()));
    Run(500U);
    EXPECT_EQ(slave.resets, 5);
    EXPECT_EQ(slave.State(), NodeState::kPreOperational);
    EXPECT_FALSE(Of(5U).is_started);
    // One of another vendor gets its configuration, and nothing else
    setups[5].vendor_id = 0x2BU;
    EXPECT_TRUE(start_up.Boot(NodeId{5U}, Now()));
    Run(500U);
    EXPECT_EQ(Letter(5U), "D");
    EXPECT_TRUE(start_up.Configure(NodeId{5U}, Now()));
    Run(500U);
    EXPECT_EQ(Letter(5U), "D");
    EXPECT_EQ(slave.State(), NodeState::kPreOperational);
}

// Given a slave that restarts whenever it is programmed, then it is programmed three times, and again by order.
TEST_F(BootOptionsTest, ASlaveThatRestartsInItsUpdateIsNotUpdatedWithoutEnd)
{
    Verifies(req::SRS_BOOT_007);
    const Octets program(300U, 0x5AU);
    FakeSlave& slave = Add(5U, kBoot | kVerifySoftware | kMayUpdateSoftware);
    slave.Put32(0x1F56U, 1U, 0x54U);
    slave.Put8(0x1F51U, 1U, 1U);
    setups[5].software.identification = 0x55U;
    setups[5].software.program = Bytes{program.data(), 300U};
    Begin();
    const auto updates = [this, &slave](int cycles)
    {
        int count = 0;
        for (int i = 0; i < cycles; ++i)
        {
            slave.is_sdo_mute = (slave.writes.size() > 0U);
            if (slave.is_sdo_mute) // The program is stopped: it restarts.
            {
                ++count;
                slave.writes.clear();
                slave.is_sdo_mute = false;
                slave.Power(Now());
            }
            slave.mute_after_writes = 1U;
            Run(1U);
        }
        return count;
    };
    EXPECT_EQ(updates(3000), 3);
    EXPECT_EQ(Letter(5U), "I");
    EXPECT_EQ(Of(5U).object.index, 0x1F56U);
    slave.Power(Now());
    EXPECT_EQ(updates(1000), 0); // A further restart changes nothing,
    EXPECT_TRUE(start_up.Boot(NodeId{5U}, Now()));
    EXPECT_EQ(updates(3000), 3); // an order does.
}

// Given a command 71.6 minutes ago, when the counter of time has come round, then the next one does not wait.
TEST_F(BootOptionsTest, AnInhibitTimeThatIsLongOverStaysOver)
{
    Verifies(req::SRS_NMM_001);
    setup.inhibit_100us = 1000U;
    EXPECT_EQ(nmt.Request(NmtCommand::kStop, NodeId{5U}, Instant{0U}), NmtAnswer::kTaken);
    nmt.OnCycle(Instant{0x4000'0000U});
    nmt.OnCycle(Instant{0x8000'0000U});
    wire.clear();
    EXPECT_EQ(nmt.Request(NmtCommand::kStop, NodeId{5U}, Instant{50'000U}), NmtAnswer::kTaken);
    EXPECT_EQ(wire.size(), 1U);
    EXPECT_EQ(nmt.Waiting(), 0U);
}

// Given an optional slave, when it is pulled, then it is missing, also behind the reset that it did not hear.
TEST_F(BootOptionsTest, AnOptionalSlaveThatIsGoneIsMissing)
{
    Verifies(req::SRS_BOOT_002);
    Add(5U, kBoot).heartbeat_ms = 50U;
    setups[5].heartbeat = HeartbeatSetup{150U, 50U, Arming::kFirstHeartbeat};
    Begin();
    Run(500U);
    EXPECT_EQ(table.RequestValue(NodeId{5U}), 5U);
    slaves[5]->Unplug();
    Run(2000U);
    EXPECT_EQ(table.RequestValue(NodeId{5U}), 1U);
    slaves[5]->Power(Now());
    Run(500U);
    EXPECT_EQ(table.RequestValue(NodeId{5U}), 5U);
}

// Given a mandatory slave of another vendor, when it is made an optional one, then the master goes on without it.
TEST_F(BootOptionsTest, WhoIsMandatoryNoMoreHaltsNothing)
{
    Verifies(req::SRS_BOOT_016);
    Add(5U, kMust).Put32(0x1018U, 1U, 0x2BU);
    Add(6U, kMust);
    Begin();
    Run(50U);
    EXPECT_EQ(Step(), MasterStep::kHalted);
    setups[5].assignment = kBoot;
    Run(2U);
    EXPECT_EQ(Step(), MasterStep::kOperational);
    EXPECT_EQ(Letter(5U), "D");
    EXPECT_EQ(slaves[5]->State(), NodeState::kPreOperational);
}

// Given slaves that were stopped, one of which is heard, when their start-up is asked for, then they run again.
TEST_F(BootOptionsTest, WhoIsStoppedIsMadePreOperationalToBeBooted)
{
    Verifies(req::SRS_BOOT_004);
    Add(5U, kMust).heartbeat_ms = 50U;
    setups[5].heartbeat = HeartbeatSetup{150U, 50U, Arming::kFirstHeartbeat};
    Add(6U, kMust);
    Begin();
    Run(200U);
    for (const std::uint8_t node : {std::uint8_t{5U}, std::uint8_t{6U}})
    {
        EXPECT_EQ(start_up.Command(NmtCommand::kStop, NodeId{node}, Now()), NmtAnswer::kTaken);
        Run(100U);
        EXPECT_EQ(slaves[node]->State(), NodeState::kStopped);
        EXPECT_FALSE(start_up.Configure(NodeId{node}, Now())); // Nobody would answer.
        EXPECT_TRUE(start_up.Boot(NodeId{node}, Now()));
        Run(200U);
        EXPECT_EQ(slaves[node]->State(), NodeState::kOperational);
        EXPECT_EQ(Letter(node), "-");
    }
}

// Given a slave that refuses 1000h, then it is asked again, and is not missing.
TEST_F(BootOptionsTest, WhoRefusesIsThere)
{
    Verifies(req::SRS_BOOT_004);
    Add(5U, kMust).refused[0x100000U] = SdoAbort::kHardware;
    Begin();
    Run(500U);
    EXPECT_EQ(table.RequestValue(NodeId{5U}), 127U);
    EXPECT_EQ(Of(5U).abort, SdoAbort::kHardware);
    slaves[5]->refused.clear();
    Run(600U);
    EXPECT_EQ(Letter(5U), "-");
    EXPECT_EQ(slaves[5]->State(), NodeState::kOperational);
}

} // namespace
} // namespace counterpoint::cia302
