// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The demo of the reference's chapter 5 on a bus: flying master 2 (level 1, which does not watch the master), flying
// master 5 (level 2, which does) and slave 5Fh. Preset so1114, 125 kbit/s, cycle 1 ms.
#include "canopen/cia301/nmt/heartbeat_consumer.hpp"
#include "canopen/cia301/nmt/heartbeat_producer.hpp"
#include "canopen/cia302/flying_master/flying_master.hpp"
#include "hal/host/virtual/bus.hpp"
#include "verification/trace/ids/flying_master.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace counterpoint::cia302
{
namespace
{

using cia301::HeartbeatEvent;
using cia301::NodeState;
using Lines = std::vector<std::string>;

constexpr std::uint16_t kHeartbeatMs = 200U;
constexpr std::uint16_t kConsumerMs = 500U;

std::string Hex(const std::uint8_t value)
{
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "0x%02X", static_cast<unsigned>(value));
    return text.data();
}

std::string Prio(const std::uint8_t level, const std::uint8_t node, const char* const of_node)
{
    return "prio=" + std::to_string(level) + of_node + Hex(node) + ")";
}

/// What hangs on the bus: a port and the end of the power.
class DemoNode : public host::BusListener, public cia301::FrameSink
{
  public:
    DemoNode(host::VirtualBus& bus, const std::uint8_t node) : node_(NodeId{node}), producer(node_), bus_(bus)
    {
        index_ = bus.Attach(*this, host::NodeSetup{CanPortId::kFirst, 16U});
        bus.Disconnect(index_);
    }
    void SwitchOn()
    {
        bus_.Connect(index_);
        is_on = true;
    }
    void SwitchOff()
    {
        bus_.AbortAll(index_);
        bus_.Disconnect(index_);
        is_on = false;
    }
    bool Send(const CanFrame& frame) noexcept override
    {
        return bus_.Submit(index_, frame) == hal::TransmitStatus::kAccepted;
    }
    void OnConfirmed(const CanFrame& /*frame*/, host::BusTime /*at*/) override
    {
    }
    virtual void Cycle(Instant now) = 0;

    [[nodiscard]] Instant Now() const
    {
        return Instant{static_cast<std::uint32_t>(bus_.Now() / host::kMicrosecond)};
    }

    Lines log{};
    bool is_on{false};

  protected:
    void BootUp()
    {
        log.push_back("call NmtsSendBootup()");
        static_cast<void>(Send(cia301::ErrorControlFrame(node_, 0U)));
        producer.SetPeriod(kHeartbeatMs);
    }
    void Beat(const NodeState state, const Instant now)
    {
        const cia301::FrameToSend heartbeat = producer.Poll(state, now);
        if (heartbeat.is_present)
        {
            static_cast<void>(Send(heartbeat.frame));
        }
    }

    NodeId node_;
    cia301::HeartbeatProducer producer;

  private:
    host::VirtualBus& bus_;
    host::NodeIndex index_{0U};
};

/// The slave instance of demo_flyma_ext.
class DemoSlave final : public DemoNode
{
  public:
    using DemoNode::DemoNode;
    void OnReceived(const CanFrame& frame, host::BusTime /*at*/) override
    {
        slave_.OnFrame(frame);
    }
    void Cycle(const Instant now) override
    {
        const cia301::FrameToSend boot_up = slave_.Advance();
        if (boot_up.is_present)
        {
            BootUp();
        }
        Beat(slave_.State(), now);
    }

  private:
    cia301::NmtSlave slave_{NodeId{0x5FU}, cia301::StartUp{false, 0U}};
};

/// A flying master with the application of the demo, which may write 1016h when it became slave.
class DemoMaster final : public DemoNode, private FlyingMasterListener, private cia301::HeartbeatListener
{
  public:
    DemoMaster(host::VirtualBus& bus, const std::uint8_t node, const std::uint8_t level, const bool watches)
        : DemoNode(bus, node), times_(DefaultTimes(NodeId{node})),
          setup_{NodeId{node}, 0x21U, 0U, 0U, 0U, slaves_.data()},
          master(FlyingMasterParts{setup_, times_, options_, *this, *this}), watches_(watches)
    {
        times_.priority = level;
    }

    bool Send(const CanFrame& frame) noexcept override
    {
        if (frame.identifier == 0x73U)
        {
            log.push_back("send req ActMaDet");
        }
        return DemoNode::Send(frame);
    }
    void OnReceived(const CanFrame& frame, host::BusTime /*at*/) override
    {
        if ((frame.identifier == 0x71U) && (master.State() == FlyingState::kDetect))
        {
            log.push_back("resp ActMaDet recvd (" + Prio(frame.data[0], frame.data[1], ",nodeId="));
        }
        master.OnFrame(frame, Now());
        consumer_.OnFrame(frame, Now());
    }
    void Cycle(const Instant now) override
    {
        if (!has_begun_)
        {
            has_begun_ = true;
            static_cast<void>(master.Start(now));
        }
        master.OnCycle(now);
        consumer_.Poll(now);
        if (master.IsInitialising())
        {
            state_ = NodeState::kInitialising;
            producer.SetPeriod(0U);
        }
        else if (state_ == NodeState::kInitialising)
        {
            EnterRole(now);
        }
        else
        {
            Beat(state_, now);
        }
    }

  private:
    void EnterRole(const Instant /*now*/)
    {
        const bool is_master = master.IsActiveMaster();
        log.push_back(is_master ? "start as master!" : "start as slave!");
        if (!is_master && watches_)
        {
            // The master's node-ID above the time: 1016h of the device.
            const std::uint8_t watched = master.Master().node.value;
            log.push_back("start heartbeat control for node-ID " + Hex(watched));
            EXPECT_EQ(consumer_.Write(1U, (static_cast<std::uint32_t>(watched) << 16U) | kConsumerMs),
                      cia301::SdoAbort::kNone);
        }
        BootUp();
        state_ = is_master ? NodeState::kOperational : NodeState::kPreOperational;
        if (is_master)
        {
            log.push_back("NMT-Event 'Operational'");
        }
    }
    void OnFlyingMaster(const FlyingEvent event, const MasterClaim& claim, const Instant now) noexcept override
    {
        if (event == FlyingEvent::kSlaveMode)
        {
            log.push_back("Flying Master: slave mode (remote " + Prio(claim.level, claim.node.value, ", node-ID="));
        }
        else if (event == FlyingEvent::kForceNegotiation)
        {
            log.push_back("Flying Master: force negotiation");
        }
        else if (event == FlyingEvent::kPowerOnReset)
        {
            log.push_back("Flying Master: power-on reset");
        }
        else
        {
            log.push_back("Flying Master: master mode");
            master_since_us = now.us;
        }
    }
    void OnInitialising(const Instant now) noexcept override
    {
        // Reset communication clears what the application wrote.
        EXPECT_EQ(consumer_.Write(1U, 0U), cia301::SdoAbort::kNone);
        static_cast<void>(master.Start(now));
    }
    void OnHeartbeat(const NodeId node, const HeartbeatEvent event, const std::uint8_t state) noexcept override
    {
        if (event == HeartbeatEvent::kLost)
        {
            log.push_back("ErrCtrl: Node " + Hex(node.value) + " lost");
            lost_us = Now().us;
            master.OnHeartbeatLost(node, Now());
        }
        else if (event == HeartbeatEvent::kStarted)
        {
            log.push_back("ErrCtrl: Node " + Hex(node.value) + " State=" + Hex(state));
        }
        else
        {
            // Boot-up and other states are of no interest here.
        }
    }

    std::array<SlaveSetup, kNodeRoom> slaves_{};
    FlyingMasterTimes times_;
    FlyingMasterOptions options_{So1114FlyingMaster()};
    NetworkSetup setup_;
    cia301::SupervisedNode room_{};
    cia301::HeartbeatConsumer consumer_{cia301::SupervisedNodes{&room_, 1U}, *this};

  public:
    FlyingMaster master;
    std::uint32_t master_since_us{0U};
    std::uint32_t lost_us{0U};

  private:
    NodeState state_{NodeState::kInitialising};
    bool watches_;
    bool has_begun_{false};
};

class FlyingDemo : public ::testing::Test
{
  protected:
    /// Both masters with their priorities; all off.
    void Build(const std::uint8_t level_2, const bool watches_2, const std::uint8_t level_5)
    {
        two = std::make_unique<DemoMaster>(bus, std::uint8_t{2U}, level_2, watches_2);
        five = std::make_unique<DemoMaster>(bus, std::uint8_t{5U}, level_5, true);
        slave = std::make_unique<DemoSlave>(bus, std::uint8_t{0x5FU});
    }
    void RunTo(const std::int64_t ms)
    {
        while (now_ms < ms)
        {
            ++now_ms;
            bus.Advance(now_ms * host::kMillisecond);
            for (DemoNode* const node : std::array<DemoNode*, 3>{two.get(), five.get(), slave.get()})
            {
                if (node->is_on)
                {
                    node->Cycle(node->Now());
                }
            }
        }
    }

    host::VirtualBus bus{host::BitRate::k125k};
    std::unique_ptr<DemoMaster> two{};
    std::unique_ptr<DemoMaster> five{};
    std::unique_ptr<DemoSlave> slave{};
    std::int64_t now_ms{0};
};

TEST_F(FlyingDemo, AsPrinted)
{
    Verifies(req::SRS_FLY_005);
    Verifies(req::SRS_FLY_009);
    // Given demo_flyma, which is master when the device with both other instances is switched on
    Build(1U, false, 2U);
    two->SwitchOn();
    slave->SwitchOn();
    RunTo(4000);
    EXPECT_EQ(two->log, (Lines{"send req ActMaDet", "Flying Master: power-on reset", "send req ActMaDet",
                               "Flying Master: master mode", "start as master!", "call NmtsSendBootup()",
                               "NMT-Event 'Operational'"}));
    // Then the slave booted, and once more after the reset of all
    EXPECT_EQ(slave->log, (Lines{"call NmtsSendBootup()", "call NmtsSendBootup()"}));
    // When it is
    five->SwitchOn();
    RunTo(6000);
    // Then it finds the master, is slave, and the application starts supervision
    EXPECT_EQ(five->log, (Lines{"send req ActMaDet", "resp ActMaDet recvd (prio=1,nodeId=0x02)",
                                "Flying Master: slave mode (remote prio=1, node-ID=0x02)", "start as slave!",
                                "start heartbeat control for node-ID 0x02", "call NmtsSendBootup()",
                                "ErrCtrl: Node 0x02 State=0x05"}));
    RunTo(30'000);
    EXPECT_TRUE(two->master.IsActiveMaster());
    EXPECT_EQ(five->master.State(), FlyingState::kSlave);
}

TEST_F(FlyingDemo, TheBetterOneBecomesMasterAlsoWhenItIsSwitchedOnLater)
{
    Verifies(req::SRS_FLY_006);
    Build(1U, false, 2U);
    five->SwitchOn();
    slave->SwitchOn();
    RunTo(6000);
    ASSERT_TRUE(five->master.IsActiveMaster());
    five->log.clear();
    two->SwitchOn();
    RunTo(12'000);
    EXPECT_EQ(two->log, (Lines{"send req ActMaDet", "resp ActMaDet recvd (prio=2,nodeId=0x05)",
                               "Flying Master: force negotiation", "send req ActMaDet", "Flying Master: master mode",
                               "start as master!", "call NmtsSendBootup()", "NMT-Event 'Operational'"}));
    EXPECT_EQ(five->log, (Lines{"send req ActMaDet", "Flying Master: slave mode (remote prio=1, node-ID=0x02)",
                                "start as slave!", "start heartbeat control for node-ID 0x02", "call NmtsSendBootup()",
                                "ErrCtrl: Node 0x02 State=0x05"}));
}

TEST_F(FlyingDemo, MasterFailsAndTheOtherOneTakesOver)
{
    Verifies(req::SRS_FLY_012);
    Build(1U, false, 2U);
    two->SwitchOn();
    five->SwitchOn();
    slave->SwitchOn();
    RunTo(10'000);
    ASSERT_TRUE(two->master.IsActiveMaster());
    two->SwitchOff();
    RunTo(20'000);
    EXPECT_TRUE(five->master.IsActiveMaster());
    // 600 ms of detection, 2 x 1500 + 5 x 10 ms of waiting.
    EXPECT_EQ(five->master_since_us - five->lost_us, 3'650'000U);
}

TEST_F(FlyingDemo, SwappedPrioritiesWithoutSupervisionNode2StaysSlave)
{
    Verifies(req::SRS_FLY_012);
    Build(2U, false, 1U);
    two->SwitchOn();
    five->SwitchOn();
    slave->SwitchOn();
    RunTo(10'000);
    ASSERT_TRUE(five->master.IsActiveMaster());
    // The standby asks at each cyclic 072h of the master
    EXPECT_EQ(two->log.back(), "send req ActMaDet");
    two->log.clear();
    five->SwitchOff();
    RunTo(60'000);
    EXPECT_EQ(two->master.State(), FlyingState::kSlave);
    EXPECT_EQ(two->log, Lines{});
}

TEST_F(FlyingDemo, SwappedPrioritiesWithSupervisionNode2BecomesMaster)
{
    Verifies(req::SRS_FLY_012);
    Build(2U, true, 1U);
    two->SwitchOn();
    five->SwitchOn();
    slave->SwitchOn();
    RunTo(10'000);
    ASSERT_TRUE(five->master.IsActiveMaster());
    two->log.clear();
    five->SwitchOff();
    RunTo(20'000);
    EXPECT_EQ(two->log, (Lines{"ErrCtrl: Node 0x05 lost", "send req ActMaDet", "Flying Master: master mode",
                               "start as master!", "call NmtsSendBootup()", "NMT-Event 'Operational'"}));
    EXPECT_EQ(two->master_since_us - two->lost_us, 3'620'000U);
}

} // namespace
} // namespace counterpoint::cia302
