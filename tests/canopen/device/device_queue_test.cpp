// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/device/device_rig.hpp"
#include "verification/trace/ids/cia301.hpp"
#include "verification/trace/ids/node.hpp"

namespace counterpoint::device
{
namespace
{

using cia301::NodeState;

using DeviceQueueTest = DeviceRig;

// A bus that takes no more than the PDOs of the device: what it has to say of itself leaves all the same.
TEST_F(DeviceQueueTest, PdosHoldUpNeitherBootUpNorEmergencyNorAnswer)
{
    Verifies(req::SRS_DEV_150);
    Verifies(req::SRS_NMT_002);
    Run();
    Forget();
    const CanFrame pdo{0x182U, FrameKind::kData, CanPortId::kFirst, 0U, {}};
    const auto fill = [this, &pdo]
    {
        while (services.process.Send(pdo))
        {
        }
    };
    // Given PDOs that take each place as soon as it is free
    ports.answer = hal::TransmitStatus::kQueueFull;
    fill();
    core.DemandSafeState();
    Frame(0x602U, {0x40U, 0x01U, 0x10U, 0x00U, 0U, 0U, 0U, 0U});
    Cycles(2U);
    EXPECT_TRUE(Sent(0x182U).empty());
    ports.answer = hal::TransmitStatus::kAccepted;
    for (int cycle = 0; cycle < 20; ++cycle)
    {
        fill();
        Cycle();
    }
    EXPECT_EQ(Emergencies(), (std::vector<unsigned>{0x6200U}));
    ASSERT_EQ(Sent(0x582U).size(), 1U);
    EXPECT_EQ(Sent(0x582U)[0][0], 0x4FU);
    // When communication is reset, then the boot-up message comes
    Forget();
    ports.answer = hal::TransmitStatus::kQueueFull;
    fill();
    Command(130U);
    Cycles(2U);
    ports.answer = hal::TransmitStatus::kAccepted;
    for (int cycle = 0; cycle < 20; ++cycle)
    {
        fill();
        Cycle();
    }
    EXPECT_EQ(Sent(0x702U), (std::vector<Octets>{{0U}}));
}

TEST_F(DeviceQueueTest, WhatOperationalLeavesBehindIsNoPdo)
{
    Verifies(req::SRS_DEV_151);
    for (const std::uint8_t command : Octets{128U, 2U})
    {
        Run();
        Forget();
        // Given a PDO that the controller has, and PDOs, SYNC and SDO answers by turns that it does not take
        const auto frame_of = [](const std::uint32_t identifier, const std::uint8_t number)
        { return CanFrame{identifier, FrameKind::kData, CanPortId::kFirst, 1U, {number}}; };
        ASSERT_TRUE(services.process.Send(frame_of(0x182U, 9U)));
        Cycle();
        ports.answer = hal::TransmitStatus::kQueueFull;
        for (std::uint8_t number = 0U; number < 4U; ++number)
        {
            ASSERT_TRUE(services.process.Send(frame_of(0x182U, number)));
            ASSERT_TRUE(services.process.Send(frame_of(0x080U, number)));
            ASSERT_TRUE(services.process.Send(frame_of(0x282U, number)));
            ASSERT_TRUE(services.outbox.Send(frame_of(0x582U, number)));
        }
        // When OPERATIONAL is left, then the PDOs are gone but the controller's, and the others leave in their order
        Command(command);
        Cycle();
        ports.answer = hal::TransmitStatus::kAccepted;
        Cycles(12U);
        EXPECT_EQ(Sent(0x182U), (std::vector<Octets>{{9U}}));
        EXPECT_TRUE(Sent(0x282U).empty());
        EXPECT_EQ(Sent(0x080U), (std::vector<Octets>{{0U}, {1U}, {2U}, {3U}}));
        EXPECT_EQ(Sent(0x582U), (std::vector<Octets>{{0U}, {1U}, {2U}, {3U}}));
        EXPECT_EQ(IdentifiersSent(),
                  (std::vector<std::uint32_t>{0x182U, 0x080U, 0x582U, 0x080U, 0x582U, 0x080U, 0x582U, 0x080U, 0x582U}));
        // and their places are free again
        for (std::uint8_t number = 0U; number < 12U; ++number)
        {
            EXPECT_TRUE(services.process.Send(frame_of(0x080U, number)));
        }
        EXPECT_FALSE(services.process.Send(frame_of(0x080U, 12U)));
        device.PowerOff();
    }
}

// Answers of guarding take all own places but one, which is for an emergency.
TEST_F(DeviceQueueTest, QuestionsOfAMasterLeaveAPlaceForAnEmergency)
{
    Verifies(req::SRS_DEV_150);
    Run();
    Forget();
    // Given a controller that takes nothing, and questions without an end
    ports.answer = hal::TransmitStatus::kQueueFull;
    for (int question = 0; question < 20; ++question)
    {
        Remote(0x702U);
    }
    core.DemandSafeState();
    Cycles(2U);
    // When it takes them again, then the emergency is among them
    ports.answer = hal::TransmitStatus::kAccepted;
    Cycles(20U);
    ASSERT_FALSE(Emergencies().empty());
    EXPECT_EQ(Emergencies().front(), 0x6200U);
    EXPECT_LT(Sent(0x702U).size(), 20U);
}

TEST_F(DeviceQueueTest, OneHeartbeatOfAStateWaits)
{
    Verifies(req::SRS_DEV_024);
    Run();
    EXPECT_EQ(Download(0x1017U, 0U, 20U, 2U), 0U);
    Cycles(5U);
    Forget();
    // Given a controller that takes nothing while five heartbeats are due, and five more in another state
    ports.answer = hal::TransmitStatus::kQueueFull;
    Cycles(100U);
    Command(128U);
    Cycles(100U);
    // Then one of each state leaves
    ports.answer = hal::TransmitStatus::kAccepted;
    Cycles(4U);
    EXPECT_EQ(Sent(0x702U), (std::vector<Octets>{{5U}, {127U}}));
}

TEST_F(DeviceQueueTest, SafetyFramesReachTheKernelInTheirOrder)
{
    Verifies(req::SRS_DEV_006);
    Run();
    Pair();
    Cycle();
    ASSERT_EQ(core.GetState({0x1301U}).state, SrdoState::kReleased);
    // When a GFC comes, and the inverse frame before the normal one
    Frame(0x001U, {});
    Frame(0x102U, {0xEDU, 0xCBU});
    Frame(0x101U, {0x12U, 0x34U});
    Cycle();
    // Then the kernel has both of this cycle, and the pair in the order of the bus
    EXPECT_EQ(application.gfcs, 1);
    EXPECT_EQ(CausesOf(0x1301U), (std::vector<SrdoCause>{SrdoCause::kInverseFirst, SrdoCause::kGfc}));
    EXPECT_EQ(core.GetState({0x1301U}).state, SrdoState::kFaulted);
}

/// A value that is taken when the store has ended.
class StoreHook final : public cia301::WriteHook
{
  public:
    explicit StoreHook(const bool& is_storing) : is_storing_(is_storing)
    {
    }
    cia301::SdoAbort OnWrite(const ObjectAddress& /*address*/, const cia301::Bytes& /*value*/) noexcept override
    {
        return is_storing_ ? cia301::SdoAbort::kPending : cia301::SdoAbort::kNone;
    }

  private:
    const bool& is_storing_;
};

TEST_F(DeviceQueueTest, BusOffHasTheReactionOf1029h)
{
    Verifies(req::SRS_DEV_016);
    struct Row
    {
        std::uint8_t reaction;
        NodeState state;
    };
    for (const Row& row :
         {Row{0U, NodeState::kPreOperational}, Row{1U, NodeState::kOperational}, Row{2U, NodeState::kStopped}})
    {
        Run();
        EXPECT_EQ(Download(0x1029U, 1U, row.reaction, 1U), 0U);
        device.OnBus(BusCondition::kOff);
        Cycles(2U);
        EXPECT_EQ(device.State(), row.state) << int{row.reaction};
        device.PowerOff();
    }
}

TEST_F(DeviceQueueTest, ATransferThatWaitsForAStoreHasNoAnswerBehindAReset)
{
    Verifies(req::SRS_DEV_025);
    StoreHook hook{is_storing};
    for (const std::uint8_t command : Octets{129U, 130U, 0U})
    {
        Start();
        entries[11].write_hook = &hook;
        Forget();
        // Given a download that waits for a store
        is_storing = true;
        Frame(0x602U, {0x23U, 0x00U, 0x25U, 0U, 1U, 2U, 3U, 4U});
        Cycles(3U);
        EXPECT_TRUE(Sent(0x582U).empty());
        // When the device is reset, or not, and the store ends
        if (command != 0U)
        {
            Command(command);
        }
        Cycles(3U);
        is_storing = false;
        Cycles(3U);
        // Then it is answered in the device that was not reset alone
        EXPECT_EQ(Sent(0x582U).size(), (command == 0U) ? 1U : 0U) << int{command};
        EXPECT_EQ(device.State(), NodeState::kPreOperational) << int{command};
        device.PowerOff();
    }
}
} // namespace
} // namespace counterpoint::device
