// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/nmt/slave.hpp"
#include "canopen/cia301/objects/service_table.hpp"
#include "verification/trace/ids/cia301.hpp"
#include "verification/trace/ids/kernel.hpp"
#include "verification/trace/verifies.hpp"

#include <array>

namespace counterpoint::cia301
{
namespace
{

constexpr std::array<NodeState, 3> kRunning{NodeState::kPreOperational, NodeState::kOperational, NodeState::kStopped};

class NmtSlaveTest : public ::testing::Test
{
  public:
    static CanFrame Command(std::uint8_t command, std::uint8_t node)
    {
        return CanFrame{0U, FrameKind::kData, CanPortId::kFirst, 2U, {command, node}};
    }
    /// A slave of node 5 in one of the running states.
    static NmtSlave In(NodeState state)
    {
        NmtSlave slave{NodeId{5U}, StartUp{false, 0U}};
        for (int i = 0; i < 3; ++i)
        {
            static_cast<void>(slave.Advance());
        }
        if (state == NodeState::kOperational)
        {
            slave.OnFrame(Command(1U, 5U));
        }
        else if (state == NodeState::kStopped)
        {
            slave.OnFrame(Command(2U, 5U));
        }
        EXPECT_EQ(slave.State(), state);
        return slave;
    }
};

TEST_F(NmtSlaveTest, PowerOnPassesTheSubStatesAndSendsOneBootUp)
{
    Verifies(req::SRS_NMT_001);
    Verifies(req::SRS_NMT_002);
    NmtSlave slave{NodeId{5U}, StartUp{false, 0U}};
    EXPECT_EQ(slave.State(), NodeState::kInitialising);
    EXPECT_FALSE(slave.Advance().is_present);
    EXPECT_EQ(slave.State(), NodeState::kResetApplication);
    EXPECT_FALSE(slave.Advance().is_present);
    EXPECT_EQ(slave.State(), NodeState::kResetCommunication);
    const FrameToSend boot_up = slave.Advance();
    EXPECT_EQ(slave.State(), NodeState::kPreOperational);
    ASSERT_TRUE(boot_up.is_present);
    EXPECT_EQ(boot_up.frame.identifier, 0x705U);
    EXPECT_EQ(boot_up.frame.kind, FrameKind::kData);
    EXPECT_EQ(boot_up.frame.length_bytes, 1U);
    EXPECT_EQ(boot_up.frame.data[0], 0U);
    EXPECT_FALSE(slave.Advance().is_present);
    EXPECT_EQ(slave.State(), NodeState::kPreOperational);
}

TEST_F(NmtSlaveTest, TheFiveCommandsInEachState)
{
    Verifies(req::SRS_NMT_003);
    Verifies(req::SRS_NMT_002);
    for (const NodeState state : kRunning)
    {
        for (const std::uint8_t node : {std::uint8_t{0U}, std::uint8_t{5U}})
        {
            NmtSlave slave = In(state);
            slave.OnFrame(Command(1U, node));
            EXPECT_EQ(slave.State(), NodeState::kOperational);
            EXPECT_FALSE(slave.Advance().is_present); // INITIALISATION was not left: no boot-up message.
            slave = In(state);
            slave.OnFrame(Command(2U, node));
            EXPECT_EQ(slave.State(), NodeState::kStopped);
            EXPECT_FALSE(slave.Advance().is_present);
            slave = In(state);
            slave.OnFrame(Command(128U, node));
            EXPECT_EQ(slave.State(), NodeState::kPreOperational);
            EXPECT_FALSE(slave.Advance().is_present);
            slave = In(state);
            slave.OnFrame(Command(129U, node));
            EXPECT_EQ(slave.State(), NodeState::kResetApplication);
            EXPECT_FALSE(slave.Advance().is_present);
            EXPECT_EQ(slave.State(), NodeState::kResetCommunication);
            EXPECT_TRUE(slave.Advance().is_present);
            slave = In(state);
            slave.OnFrame(Command(130U, node));
            EXPECT_EQ(slave.State(), NodeState::kResetCommunication);
            EXPECT_TRUE(slave.Advance().is_present);
        }
    }
}

TEST_F(NmtSlaveTest, TwoCommandsOneAfterTheOtherAreBothObeyed)
{
    Verifies(req::SRS_NMT_003);
    NmtSlave slave = In(NodeState::kPreOperational);
    slave.OnFrame(Command(1U, 5U));
    slave.OnFrame(Command(2U, 5U));
    EXPECT_EQ(slave.State(), NodeState::kStopped);
}

TEST_F(NmtSlaveTest, WhatIsNoCommandChangesNothing)
{
    Verifies(req::SRS_NMT_004);
    NmtSlave slave = In(NodeState::kPreOperational);
    CanFrame frame = Command(1U, 5U);
    for (std::uint8_t length = 0U; length <= 8U; ++length)
    {
        frame.length_bytes = (length == 2U) ? std::uint8_t{9U} : length;
        slave.OnFrame(frame);
    }
    frame.length_bytes = 2U;
    for (const FrameKind kind : {FrameKind::kInvalid, FrameKind::kRemote, FrameKind::kExtended,
                                 FrameKind::kExtendedRemote, FrameKind::kFlexibleDataRate})
    {
        frame.kind = kind;
        slave.OnFrame(frame);
    }
    frame.kind = FrameKind::kData;
    frame.identifier = 1U;
    slave.OnFrame(frame);
    slave.OnFrame(Command(1U, 6U));
    slave.OnFrame(Command(1U, 133U));
    for (std::uint32_t command = 0U; command < 256U; ++command)
    {
        const bool is_known = (command == 1U) || (command == 2U) || ((command >= 128U) && (command <= 130U));
        if (!is_known)
        {
            slave.OnFrame(Command(static_cast<std::uint8_t>(command), 5U));
        }
    }
    EXPECT_EQ(slave.State(), NodeState::kPreOperational);
    // In INITIALISATION nothing is obeyed
    NmtSlave fresh{NodeId{5U}, StartUp{false, 0U}};
    for (const NodeState state :
         {NodeState::kInitialising, NodeState::kResetApplication, NodeState::kResetCommunication})
    {
        for (const std::uint8_t command : std::array<std::uint8_t, 5>{1U, 2U, 128U, 129U, 130U})
        {
            fresh.OnFrame(Command(command, 5U));
            EXPECT_EQ(fresh.State(), state) << int{command};
        }
        static_cast<void>(fresh.Advance());
    }
}

TEST_F(NmtSlaveTest, ASelfStartingSlaveBecomesOperational)
{
    Verifies(req::SRS_NMT_005);
    const auto state_with = [](bool is_present, std::uint32_t value)
    {
        NmtSlave slave{NodeId{5U}, StartUp{is_present, value}};
        static_cast<void>(slave.Advance());
        static_cast<void>(slave.Advance());
        EXPECT_TRUE(slave.Advance().is_present);
        return slave.State();
    };
    EXPECT_EQ(state_with(true, 0x00000000U), NodeState::kOperational);
    EXPECT_EQ(state_with(true, 0x00000008U), NodeState::kOperational);
    EXPECT_EQ(state_with(true, 0x00000004U), NodeState::kPreOperational);
    EXPECT_EQ(state_with(true, 0x00000001U), NodeState::kPreOperational);
    EXPECT_EQ(state_with(false, 0x00000000U), NodeState::kPreOperational);
}

TEST_F(NmtSlaveTest, TheDeviceLeavesOperationalByItselfAndNothingElse)
{
    Verifies(req::SRS_NMT_007);
    for (std::uint8_t to = 0U; to <= 7U; ++to)
    {
        NmtSlave slave = In(NodeState::kOperational);
        const bool may_leave = (to == 4U) || (to == 6U);
        EXPECT_EQ(slave.Leave(static_cast<NodeState>(to)), may_leave);
        EXPECT_EQ(slave.State(), may_leave ? static_cast<NodeState>(to) : NodeState::kOperational);
        NmtSlave fresh{NodeId{5U}, StartUp{false, 0U}};
        EXPECT_FALSE(fresh.Leave(static_cast<NodeState>(to)));
        EXPECT_EQ(fresh.State(), NodeState::kInitialising);
        for (const NodeState from : {NodeState::kPreOperational, NodeState::kStopped})
        {
            NmtSlave other = In(from);
            EXPECT_FALSE(other.Leave(static_cast<NodeState>(to)));
            EXPECT_EQ(other.State(), from);
        }
    }
}

TEST_F(NmtSlaveTest, StatesOfKernelAndErrorControl)
{
    Verifies(req::SRS_NMT_008);
    Verifies(req::SRS_KRN_027);
    constexpr std::array<NmtState, 8> kKernel{
        NmtState::kInitialising,   NmtState::kInitialising, NmtState::kInitialising, NmtState::kInitialising,
        NmtState::kPreOperational, NmtState::kOperational,  NmtState::kStopped,      NmtState::kInitialising};
    for (std::uint8_t state = 0U; state < 8U; ++state)
    {
        EXPECT_EQ(KernelState(static_cast<NodeState>(state)), kKernel[state]);
    }
}

/// Each cell of the table: service, then INITIALISATION, PRE-OPERATIONAL, OPERATIONAL, STOPPED.
struct Row
{
    Service service;
    bool allowed[4];
};

using ServiceTable = ::testing::TestWithParam<Row>;

TEST_P(ServiceTable, EachCell)
{
    Verifies(req::SRS_NMT_006);
    const Row& row = GetParam();
    EXPECT_EQ(IsAllowed(row.service, NodeState::kInitialising), row.allowed[0]);
    EXPECT_EQ(IsAllowed(row.service, NodeState::kResetApplication), row.allowed[0]);
    EXPECT_EQ(IsAllowed(row.service, NodeState::kResetCommunication), row.allowed[0]);
    EXPECT_EQ(IsAllowed(row.service, NodeState::kPreOperational), row.allowed[1]);
    EXPECT_EQ(IsAllowed(row.service, NodeState::kOperational), row.allowed[2]);
    EXPECT_EQ(IsAllowed(row.service, NodeState::kStopped), row.allowed[3]);
    EXPECT_FALSE(IsAllowed(row.service, NodeState::kInvalid));
    EXPECT_FALSE(IsAllowed(row.service, static_cast<NodeState>(7U)));
}

INSTANTIATE_TEST_SUITE_P(
    Services, ServiceTable,
    ::testing::Values(Row{Service::kInvalid, {false, false, false, false}},
                      Row{Service::kPdo, {false, false, true, false}}, Row{Service::kSrdo, {false, false, true, false}},
                      Row{Service::kGfc, {false, false, true, false}}, Row{Service::kSdo, {false, true, true, false}},
                      Row{Service::kSync, {false, true, true, false}}, Row{Service::kTime, {false, true, true, false}},
                      Row{Service::kEmergency, {false, true, true, false}},
                      Row{Service::kBootUp, {true, false, false, false}},
                      Row{Service::kErrorControl, {false, true, true, true}},
                      Row{Service::kNmt, {false, true, true, true}}, Row{Service::kLss, {false, true, true, true}},
                      Row{static_cast<Service>(12U), {false, false, false, false}}));

} // namespace
} // namespace counterpoint::cia301
