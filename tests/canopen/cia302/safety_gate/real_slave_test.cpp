// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The CiA 302-2 start-up in front of a whole safety device: real kernel, real services, real gate.
#include "canopen/start_up/cia302/start_up.hpp"
#include "tests/canopen/cia302/safety_gate/rig.hpp"
#include "verification/trace/ids/nmt_master.hpp"

namespace counterpoint::cia302
{
namespace
{

using cia301::NodeState;

constexpr NodeId kSlave{2U};

/// Node 2 is the device, node 1 the manager. One cycle is 1 ms.
class RealSlaveTest : public GateRig, public NodeListener, public NmtListener, public StartUpListener
{
  public:
    RealSlaveTest()
    {
        slaves[2].assignment = kInNetwork | kBootSlave | kMandatory;
        slaves[2].heartbeat = HeartbeatSetup{100U, 20U, Arming::kFirstHeartbeat};
        stored_heartbeat_ms = 20U;
        nmt.SetActive(true);
    }
    bool Send(const CanFrame& frame) noexcept override
    {
        out.push_back(frame);
        return true;
    }
    void OnNodeEvent(NodeId node, NodeEvent event, Instant now) noexcept override
    {
        const bool is_loss = (event == NodeEvent::kHeartbeatLost) || (event == NodeEvent::kGuardLost);
        if (event == NodeEvent::kBootUp)
        {
            pool.OnBootUp(node);
        }
        if (is_loss || (event == NodeEvent::kBootUp))
        {
            gate.Close(node);
        }
        start_up.OnNodeEvent(node, event, now);
    }
    void OnNmtSent(const NmtRequest&, Instant) noexcept override
    {
    }
    void OnNodeStatus(NodeId, Instant) noexcept override
    {
    }
    void OnMasterState(std::int16_t, Instant) noexcept override
    {
    }

    void Live(std::uint32_t milliseconds)
    {
        for (std::uint32_t i = 0U; i < milliseconds; ++i)
        {
            Cycle();
            const Instant now{now_us};
            for (; heard < ports.sent.size(); ++heard)
            {
                const CanFrame frame = ports.sent[heard];
                table.OnFrame(frame, now);
                pool.OnFrame(frame, now);
                start_up.OnFrame(frame, now);
            }
            table.OnCycle(now);
            pool.OnCycle(now);
            gate.OnCycle(now);
            start_up.OnCycle(now);
            nmt.OnCycle(now);
            std::vector<CanFrame> frames{};
            frames.swap(out);
            for (const CanFrame& frame : frames)
            {
                starts += ((frame.identifier == 0U) && (frame.data[0] == 1U)) ? 1 : 0;
                Frame(frame.identifier, device::Octets(frame.data, frame.data + frame.length_bytes));
            }
        }
    }
    void Power()
    {
        Start();
        Cycle();
        Expect(Configuration());
    }

    std::vector<CanFrame> out{};
    std::size_t heard{0U};
    int starts{0};
    std::array<NodeRecord, kNodeRoom> nodes{};
    std::array<NmtRequest, 16> queue{};
    std::array<BootRecord, kNodeRoom> boots{};
    NodeTable table{NodeTableParts{nodes.data(), setup, *this, *this}};
    NmtMaster nmt{NmtMasterParts{setup, NmtQueueRoom{queue.data(), 16U}, *this, table, *this, gate}};
    Cia302StartUp start_up{StartUpParts{setup, table, nmt, pool, gate, *this, *this}, boots.data()};
};

TEST_F(RealSlaveTest, IsResetVerifiedAndStarted)
{
    Verifies(req::SRS_BOOT_013);
    Verifies(req::SRS_BOOT_014);
    Power();
    const int resets = communication_resets;
    start_up.Begin(Instant{now_us});
    Live(400U);
    EXPECT_EQ(communication_resets, resets + 1);
    EXPECT_EQ(start_up.Status(kSlave).letter, '\0');
    EXPECT_EQ(start_up.Status(kSlave).step, StartUpStep::kDone);
    EXPECT_EQ(starts, 1);
    EXPECT_EQ(device.State(), NodeState::kOperational);
    EXPECT_EQ(start_up.MasterState(), static_cast<std::int16_t>(MasterStep::kOperational));
}

TEST_F(RealSlaveTest, WithOneOtherNumberStaysPreOperational)
{
    Verifies(req::SRS_BOOT_013);
    Power();
    // Given one expected number that the device does not have
    const auto sct = std::find_if(expected.begin(), expected.end(), [](const ExpectedObject& object)
                                  { return (object.address.index == 0x1301U) && (object.address.sub == 2U); });
    ASSERT_NE(sct, expected.end());
    const std::uint64_t had = sct->value;
    sct->value += 1U;
    start_up.Begin(Instant{now_us});
    Live(400U);
    // Then it is not started, and the object is named
    EXPECT_EQ(start_up.Status(kSlave).letter, 'J');
    EXPECT_EQ(start_up.Status(kSlave).step, StartUpStep::kSafety);
    EXPECT_EQ(start_up.Status(kSlave).object.index, 0x1301U);
    EXPECT_EQ(start_up.Status(kSlave).object.sub, 2U);
    EXPECT_EQ(start_up.Status(kSlave).expected, had + 1U);
    EXPECT_EQ(start_up.Status(kSlave).read, had);
    EXPECT_EQ(starts, 0);
    EXPECT_EQ(device.State(), NodeState::kPreOperational);
    // Neither by a command for all nor by one for it alone
    EXPECT_EQ(nmt.Request(NmtCommand::kStart, kAllNodes, Instant{now_us}), NmtAnswer::kNoBroadcast);
    EXPECT_EQ(start_up.Command(NmtCommand::kStart, kAllNodes, Instant{now_us}), NmtAnswer::kTaken);
    EXPECT_EQ(start_up.Command(NmtCommand::kStart, kSlave, Instant{now_us}), NmtAnswer::kTaken);
    Live(400U);
    EXPECT_EQ(starts, 0);
    // But when it is as expected
    sct->value = had;
    EXPECT_EQ(start_up.Command(NmtCommand::kStart, kSlave, Instant{now_us}), NmtAnswer::kTaken);
    Live(400U);
    EXPECT_EQ(starts, 1);
    EXPECT_EQ(device.State(), NodeState::kOperational);
}

TEST_F(RealSlaveTest, StartedBySomebodyElseWithAnotherConfigurationIsStopped)
{
    Verifies(req::SRS_BOOT_013);
    Verifies(req::SRS_BOOT_340);
    Verifies(req::SRS_BOOT_342);
    Power();
    expected.front().value += 1U;
    start_up.Begin(Instant{now_us});
    Live(400U);
    ASSERT_EQ(start_up.Status(kSlave).letter, 'J');
    // When another device starts it, and its heartbeat tells so
    Command(1U);
    Cycle();
    EXPECT_EQ(device.State(), NodeState::kOperational);
    Live(400U);
    EXPECT_EQ(device.State(), NodeState::kStopped);
}

} // namespace
} // namespace counterpoint::cia302
