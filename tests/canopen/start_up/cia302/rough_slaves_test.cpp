// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Slaves that are pulled, put back, fall silent and restart at random, and orders in between: whatever happened, in the
// end all run, and no safety slave ever gets a start that was not earned.
#include "tests/canopen/start_up/boot_rig.hpp"
#include "verification/trace/ids/nmt_master.hpp"

#include <random>

namespace counterpoint::cia302
{
namespace
{

using cia301::NodeState;

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
    Verifies(req::SRS_NMM_003);
    Verifies(req::SRS_NMM_004);
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
    // Then they run, and so does the master
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
