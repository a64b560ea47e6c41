// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What a bus does to the start-up when nodes do not behave: two of one node-ID, babble, storms, anything at all.
#include "tests/canopen/start_up/boot_rig.hpp"
#include "verification/trace/ids/nmt_master.hpp"

#include <random>

namespace counterpoint::cia302
{
namespace
{

using cia301::NodeState;

class RoughBusTest : public BootRig
{
  public:
    /// Slaves 5 and 6, mandatory, one object each.
    void AddTwo()
    {
        AddEntry(dcf, 0x2000U, 0U, {0x77U});
        for (const std::uint8_t node : {std::uint8_t{5U}, std::uint8_t{6U}})
        {
            Add(node, kMust).Put8(0x2000U, 0U, 0U);
            setups[node].concise_dcf = Bytes{dcf.data(), static_cast<std::uint32_t>(dcf.size())};
        }
    }

    Octets dcf{};
};

/// The answer number `GetParam()` of the slaves gets lost, boot-up messages included.
class LostAnswerTest : public RoughBusTest, public ::testing::WithParamInterface<int>
{
};

TEST_P(LostAnswerTest, IsMadeUpFor)
{
    Verifies(req::SRS_NMM_031);
    Verifies(req::SRS_BOOT_002);
    AddTwo();
    lost_answer = GetParam();
    Begin();
    Run(1500U);
    EXPECT_EQ(slaves[5]->State(), NodeState::kOperational);
    EXPECT_EQ(slaves[6]->State(), NodeState::kOperational);
    EXPECT_EQ(slaves[5]->Get(0x2000U, 0U), (Octets{0x77U}));
    EXPECT_EQ(slaves[6]->Get(0x2000U, 0U), (Octets{0x77U}));
    EXPECT_EQ(Step(), MasterStep::kOperational);
    EXPECT_EQ(lost_answer, -1); // It was lost indeed.
}

INSTANTIATE_TEST_SUITE_P(Each, LostAnswerTest, ::testing::Range(0, 14));

TEST_F(RoughBusTest, TwoSlavesOfOneNodeId)
{
    Verifies(req::SRS_BOOT_005);
    AddTwo();
    // Given a second slave 5 with another serial number: two answers to each request
    auto& other = slaves[105];
    other = std::make_unique<FakeSlave>(std::uint8_t{5U}, *this);
    other->PutIdentity();
    other->Put32(0x1018U, 4U, 0x9999U);
    other->Put8(0x2000U, 0U, 0U);
    Begin();
    Run(500U);
    // Then the start-up ends for node 5, with the answer that came first or its contradiction, and goes on for node 6
    EXPECT_FALSE(Of(5U).is_busy);
    EXPECT_EQ(slaves[6]->State(), NodeState::kOperational);
    // With the first one gone, the other is found out
    slaves[5]->Unplug();
    other->Power(Now());
    Run(100U);
    EXPECT_EQ(Letter(5U), "O");
    EXPECT_EQ(Of(5U).read, 0x9999U);
    EXPECT_EQ(other->State(), NodeState::kPreOperational);
}

TEST_F(RoughBusTest, BabblingBootUpMessages)
{
    Verifies(req::SRS_BOOT_018);
    AddTwo();
    Begin();
    // When node 5 tells every millisecond, ten times, that it booted up
    for (int i = 0; i < 1000; ++i)
    {
        for (int k = 0; k < 10; ++k)
        {
            ToManager(cia301::ErrorControlFrame(NodeId{5U}, 0U));
        }
        Run(1U);
    }
    // Then the other is served
    EXPECT_EQ(slaves[6]->State(), NodeState::kOperational);
    EXPECT_LE(nmt.Waiting(), 256U);
    // and node 5 as soon as it holds its tongue
    Run(400U);
    EXPECT_EQ(slaves[5]->State(), NodeState::kOperational);
    EXPECT_EQ(Step(), MasterStep::kOperational);
}

TEST_F(RoughBusTest, EmergencyStormAndForeignIdentifiers)
{
    Verifies(req::SRS_BOOT_018);
    AddTwo();
    Begin();
    for (std::uint32_t i = 0U; i < 20000U; ++i)
    {
        CanFrame frame{0x085U, FrameKind::kData, CanPortId::kFirst, 8U, {0x00U, 0x10U, 1U, 0U, 0U, 0U, 0U, 0U}};
        frame.identifier = ((i & 1U) != 0U) ? (i % 0x580U) : 0x085U;
        ToManager(frame);
    }
    Run(50U);
    EXPECT_EQ(slaves[5]->State(), NodeState::kOperational);
    EXPECT_EQ(slaves[6]->State(), NodeState::kOperational);
}

TEST_F(RoughBusTest, AnyFramesAtAll)
{
    Verifies(req::SRS_BOOT_018);
    Verifies(req::SRS_NMM_032);
    AddTwo();
    Begin();
    std::mt19937 random{20261121U};
    constexpr std::uint32_t kServices[] = {0x580U, 0x700U, 0x600U, 0x080U, 0x000U, 0x180U};
    constexpr std::uint8_t kBytes[] = {0U, 4U, 5U, 127U, 0x80U, 0x43U, 0x60U, 0x41U, 0x20U};
    for (int i = 0; i < 100000; ++i)
    {
        CanFrame frame{};
        frame.identifier = kServices[random() % 6U] + (random() % 128U);
        frame.identifier = ((random() & 1U) != 0U) ? ((frame.identifier & 0x780U) | 5U) : frame.identifier;
        frame.kind = ((random() % 8U) != 0U) ? FrameKind::kData : FrameKind::kRemote;
        frame.port = CanPortId::kFirst;
        frame.length_bytes = static_cast<std::uint8_t>(random() % 9U);
        for (std::uint8_t& byte : frame.data)
        {
            byte = ((random() & 1U) != 0U) ? kBytes[random() % 9U] : static_cast<std::uint8_t>(random() & 0xFFU);
        }
        ToManager(frame);
        if ((i % 16) == 0)
        {
            Run(1U);
        }
    }
    // When it is quiet again, and the slaves are put in anew
    Run(2000U);
    slaves[5]->Power(Now());
    slaves[6]->Power(Now());
    Run(2000U);
    EXPECT_EQ(slaves[5]->State(), NodeState::kOperational);
    EXPECT_EQ(slaves[6]->State(), NodeState::kOperational);
    EXPECT_EQ(Letter(5U), "-");
}

// Slaves that are pulled, put back, fall silent and restart at random, and orders in between: whatever happened, in the
// end all run, and no safety slave ever gets a start that was not earned.

constexpr Arming kArmings[3] = {Arming::kFirstHeartbeat, Arming::kBootUp, Arming::kImmediately};
constexpr NmtCommand kCommands[5] = {NmtCommand::kStart, NmtCommand::kStop, NmtCommand::kPreOperational,
                                     NmtCommand::kResetNode, NmtCommand::kResetCommunication};

/// Slaves 1 to 8: mandatory or not, kept alive or not, with heartbeat, guarding or neither; 3 and 6 are safety slaves.
class RoughSlavesTest : public BootRig, public ::testing::WithParamInterface<std::uint32_t>
{
  public:
    void Populate()
    {
        AddEntry(dcf, 0x2000U, 0U, {0x77U});
        for (std::uint8_t node = 1U; node <= 8U; ++node)
        {
            FakeSlave& slave = Add(node, kBoot | (Chance(2U) ? kMandatory : 0U) | (Chance(4U) ? kKeepAlive : 0U));
            slave.Put8(0x2000U, 0U, 0U);
            setups[node].concise_dcf = Bytes{dcf.data(), static_cast<std::uint32_t>(dcf.size())};
            const bool has_heartbeat = Chance(2U);
            slave.heartbeat_ms = has_heartbeat ? 50U : 0U;
            setups[node].heartbeat.consumer_ms = has_heartbeat ? 150U : 0U;
            setups[node].heartbeat.arming = kArmings[Below(3U)];
            slave.Put32(0x1011U, 1U, 0U);
            setups[node].restore_sub = 1U;
            setups[node].assignment |= Chance(3U) ? kRestoreDefaults : 0U;
            setups[node].assignment |= (!has_heartbeat && Chance(2U)) ? ((3U << 8U) | (100U << 16U)) : 0U;
        }
        setups[3].safety = reinterpret_cast<const SafetyExpectation*>(&gate); // Only looked at whether it is there.
        setups[6].safety = setups[3].safety;
        setup.start_up = kIsMaster | (Chance(2U) ? kStartAllAtOnce : 0U) | (Chance(3U) ? kResetAllOnError : 0U);
    }
    std::uint32_t Below(std::uint32_t limit)
    {
        return static_cast<std::uint32_t>(random() % limit);
    }
    bool Chance(std::uint32_t one_in)
    {
        return Below(one_in) == 0U;
    }
    void Disturb()
    {
        FakeSlave& slave = *slaves.at(static_cast<std::uint8_t>(1U + Below(8U)));
        switch (Below(7U))
        {
        case 0U:
            slave.Unplug();
            break;
        case 1U:
            slave.Power(Now());
            break;
        case 2U:
            slave.is_sdo_mute = !slave.is_sdo_mute;
            break;
        case 3U:
            slave.boot_ms = 1U + Below(200U);
            break;
        case 4U:
            gate.verdict = Chance(2U) ? GateState::kOpen : GateState::kDiffers;
            break;
        case 5U:
            Order(NodeId{slave.node});
            break;
        default:
            lost_answer = static_cast<int>(Below(5U));
            break;
        }
    }
    /// What the application may ask for, or write.
    void Order(NodeId node)
    {
        switch (Below(5U))
        {
        case 0U:
            static_cast<void>(start_up.Configure(node, Now()));
            break;
        case 1U:
            static_cast<void>(start_up.Boot(node, Now()));
            break;
        case 2U:
            setup.inhibit_100us = static_cast<std::uint16_t>(Below(200U));
            break;
        case 3U:
            setups.at(node.value).assignment ^= kMandatory;
            break;
        default:
            static_cast<void>(start_up.Command(kCommands[Below(5U)], node, Now()));
            break;
        }
    }
    void OnNmtSent(const NmtRequest& request, Instant now) noexcept override
    {
        const bool is_start = (request.command == NmtCommand::kStart);
        EXPECT_FALSE(is_start && (request.node.value == 0U));
        EXPECT_TRUE(!is_start || gate.MayStart(request.node));
        BootRig::OnNmtSent(request, now);
    }

    std::mt19937 random{GetParam()};
    Octets dcf{};
};

TEST_P(RoughSlavesTest, AllRunInTheEnd)
{
    Verifies(req::SRS_BOOT_018);
    Verifies(req::SRS_BOOT_033);
    Verifies(req::SRS_NMM_003);
    Verifies(req::SRS_NMM_121);
    Populate();
    Begin();
    for (int i = 0; i < 100; ++i)
    {
        Disturb();
        Run(1U + Below(300U));
    }
    // When all are well again, and were switched off and on
    gate.verdict = GateState::kOpen;
    lost_answer = -1;
    setup.inhibit_100us = 0U;
    for (auto& [node, slave] : slaves)
    {
        slave->is_sdo_mute = false;
        slave->boot_ms = 5U;
        slave->Unplug();
    }
    Run(1000U);
    PowerAll();
    Run(4000U);
    // Then those that an order to stop holds do not run before their boot is ordered
    for (auto& [node, slave] : slaves)
    {
        if (boots.at(node).is_held)
        {
            EXPECT_EQ(slave->State(), NodeState::kPreOperational) << "slave " << int{node};
            EXPECT_TRUE(start_up.Boot(NodeId{node}, Now()));
        }
    }
    Run(2000U);
    // And the others do, and so does the master
    for (auto& [node, slave] : slaves)
    {
        EXPECT_EQ(slave->State(), NodeState::kOperational) << "slave " << int{node} << " " << Letter(node);
        EXPECT_EQ(slave->Get(0x2000U, 0U), (Octets{0x77U}));
        EXPECT_FALSE(Of(node).is_busy);
    }
    EXPECT_EQ(Step(), MasterStep::kOperational);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RoughSlavesTest, ::testing::Range(1U, 11U));

} // namespace
} // namespace counterpoint::cia302
