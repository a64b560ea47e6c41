// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Two devices with one node-ID and no heartbeat, and single devices that must not be taken for two.
#include "tests/canopen/manager/rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"

namespace counterpoint::cia302
{
namespace
{

CanFrame Sdo(const std::uint32_t identifier, const std::uint8_t command, const std::uint16_t index,
             const std::uint8_t sub)
{
    const auto low = static_cast<std::uint8_t>(index & 0xFFU);
    const auto high = static_cast<std::uint8_t>(index >> 8U);
    return CanFrame{identifier, FrameKind::kData, CanPortId::kFirst, 8U, {command, low, high, sub, 0U, 0U, 0U, 0U}};
}

CanFrame Guarding(const FrameKind kind, const std::uint8_t byte)
{
    return CanFrame{0x705U, kind, CanPortId::kFirst, 1U, {byte, 0U, 0U, 0U, 0U, 0U, 0U, 0U}};
}

class DuplicateTest : public ManagerRig, public ::testing::WithParamInterface<Profile>
{
};

TEST_P(DuplicateTest, TwoDevicesWithoutHeartbeatAreFoundByTheirAnswers)
{
    Verifies(req::SRS_MGR_015);
    Verifies(req::SRS_MGR_010);
    // Given a single device 6, and two devices 5 of which the second one boots 3 ms later, each with one object to
    // write
    const Octets list{1U, 0U, 0U, 0U, 0x00U, 0x20U, 0U, 1U, 0U, 0U, 0U, 0x77U};
    Add(5U);
    Add(5U).boot_ms = 4U;
    Add(6U);
    for (const auto& device : devices)
    {
        device->Put8(0x2000U, 0U, 0U);
        setups.at(device->node).concise_dcf = Bytes{list.data(), static_cast<std::uint32_t>(list.size())};
    }
    Begin(GetParam());
    Run(6000U);
    // Then 5 is told, once in this start-up, and 6 is started
    EXPECT_TRUE(IsSuspected(5U));
    EXPECT_FALSE(IsSuspected(6U));
    EXPECT_EQ(Running(6U), 1);
}

TEST_P(DuplicateTest, ASafetySlaveThatMayBeTwoIsNotStartedUntilAReset)
{
    Verifies(req::SRS_MGR_226);
    Verifies(req::SRS_SFS_151);
    // Given two devices 5 with the configuration that is expected, both of them
    Add(5U);
    FakeSlave& second = Add(5U);
    second.boot_ms = 4U;
    MakeSafe(5U);
    Begin(GetParam());
    Run(6000U);
    // Then neither runs, by no order either, and the gate says why
    EXPECT_EQ(Running(5U), 0);
    static_cast<void>(Order(NmtCommand::kStart, 5U));
    Run(3000U);
    EXPECT_EQ(Running(5U), 0);
    EXPECT_EQ(starts, (std::vector<std::string>{}));
    EXPECT_EQ(Gate(), GateState::kFailed);
    EXPECT_EQ(manager->Gate().Finding(NodeId{5U}).object.index, 0U);
    EXPECT_EQ(manager->Gate().Finding(NodeId{5U}).abort, SdoAbort::kGeneral);
    // When one is taken away and the other is reset, then it is verified and started
    second.Unplug();
    static_cast<void>(Order(NmtCommand::kResetNode, 5U));
    Run(6000U);
    EXPECT_EQ(Running(5U), 1);
    EXPECT_EQ(Gate(), GateState::kOpen);
}

TEST_P(DuplicateTest, WhatASinkDidNotTakeIsSentLater)
{
    Verifies(req::SRS_MGR_001);
    // Given a sink that takes nothing in every second half of 100 ms, in the whole start-up of a safety slave
    Add(5U).heartbeat_ms = 100U;
    MakeSafe(5U);
    Add(6U);
    is_sink_full = true;
    Begin(GetParam());
    for (int i = 0; i < 80; ++i)
    {
        is_sink_full = !is_sink_full;
        Run(50U);
    }
    // Then each of them runs, by one start of its own or of all
    EXPECT_EQ(Running(5U), 1);
    EXPECT_EQ(Running(6U), 1);
    EXPECT_EQ(Gate(), GateState::kOpen);
}

TEST_P(DuplicateTest, OneDeviceIsNeverTakenForTwo)
{
    Verifies(req::SRS_MGR_223);
    // Given one that never boots up by itself, one that answers nothing, a safety slave and one that is reset often
    Add(5U).has_boot_up = false;
    Add(6U).is_sdo_mute = true;
    Add(7U);
    MakeSafe(7U);
    Begin(GetParam());
    Run(4000U);
    for (int i = 0; i < 10; ++i)
    {
        static_cast<void>(Order(NmtCommand::kResetCommunication, 7U));
        Run(700U);
    }
    EXPECT_EQ(duplicates, (std::vector<std::uint8_t>{}));
}

INSTANTIATE_TEST_SUITE_P(Each, DuplicateTest, ::testing::ValuesIn(kProfiles));

TEST_P(DuplicateTest, OneThatRefusesItsHeartbeatTimeIsNoDuplicateByItsOwn)
{
    Verifies(req::SRS_MGR_083);
    // Given a heartbeat time of 1 s that one device refuses, which keeps its own 100 ms
    const Octets list{1U, 0U, 0U, 0U, 0x17U, 0x10U, 0U, 2U, 0U, 0U, 0U, 0xE8U, 0x03U};
    FakeSlave& device = Add(5U);
    device.Put(0x1017U, 0U, {100U, 0U});
    device.refused[cia301::KeyOf(0x1017U, 0U)] = SdoAbort::kReadOnly;
    device.heartbeat_ms = 100U;
    setups.at(5U).heartbeat = HeartbeatSetup{2000U, 1000U, Arming::kFirstHeartbeat};
    setups.at(5U).concise_dcf = Bytes{list.data(), static_cast<std::uint32_t>(list.size())};
    MakeSafe(5U);
    Begin(GetParam());
    Run(12000U);
    // Then nothing is concluded of it; PLC Designer, to which an abort is an answer, has started it
    EXPECT_FALSE(IsSuspected(5U));
    EXPECT_EQ(Running(5U), (GetParam() == Profile::kPlcDesigner) ? 1 : 0);
    // When somebody writes the time, and it is taken, but the heartbeats come as before, then they are too many
    Put(Sdo(0x605U, 0x2BU, 0x1017U, 0U));
    Put(Sdo(0x585U, 0x60U, 0x1017U, 0U));
    Run(4000U);
    EXPECT_EQ(IsSuspected(5U), GetParam() == Profile::kPlcDesigner);
    EXPECT_EQ(Running(5U), 0);
}

class RefusedTest : public ManagerRig
{
};

TEST_F(RefusedTest, UnderPlcDesignerOneThatRanIsInState4)
{
    Verifies(req::SRS_PLC_031);
    Add(6U);
    MakeSafe(6U);
    Begin(Profile::kPlcDesigner);
    Run(3000U);
    ASSERT_EQ(Running(6U), 1);
    ASSERT_EQ(manager->Status(NodeId{6U}).code, 5);
    // When three questions were answered by two devices, then it is stopped, which is no state 5
    for (std::uint16_t index = 0x2000U; index < 0x2003U; ++index)
    {
        Put(Sdo(0x606U, 0x40U, index, 0U)); // The device aborts it,
        Put(Sdo(0x586U, 0x43U, index, 0U)); // and another one has it.
    }
    Run(100U);
    EXPECT_EQ(Running(6U), 0);
    EXPECT_EQ(manager->Status(NodeId{6U}).code, 4);
    EXPECT_EQ(manager->Status(NodeId{6U}).step, StartUpStep::kSafety);
}

class SecondAnswerTest : public ManagerRig
{
  public:
    SecondAnswerTest()
    {
        Add(6U);
    }
    /// Node 5 is asked for an object by somebody and answers so many times.
    void Ask(const std::uint16_t index, const int answers, const std::uint8_t answer = 0x43U)
    {
        Put(Sdo(0x605U, 0x40U, index, 0U));
        for (int i = 0; i < answers; ++i)
        {
            Put(Sdo(0x585U, answer, index, 0U));
        }
    }
};

TEST_F(SecondAnswerTest, ThreeSdoRequestsInARow)
{
    Verifies(req::SRS_MGR_015);
    Begin(Profile::kCia302);
    // Two in a row are not enough, and one that is answered once begins the count anew
    Ask(0x2000U, 2);
    Ask(0x2001U, 3);
    Ask(0x2002U, 1);
    Ask(0x2003U, 2);
    Ask(0x2004U, 2);
    EXPECT_FALSE(IsSuspected(5U));
    Ask(0x2005U, 2, 0x80U);
    EXPECT_EQ(duplicates, (std::vector<std::uint8_t>{5U}));
    // Told once
    Ask(0x2006U, 2);
    EXPECT_EQ(duplicates, (std::vector<std::uint8_t>{5U}));
}

TEST_F(SecondAnswerTest, WhatASingleDeviceSendsIsNoSecondAnswer)
{
    Verifies(req::SRS_MGR_223);
    Begin(Profile::kCia302);
    for (std::uint16_t i = 0U; i < 10U; ++i)
    {
        const auto index = static_cast<std::uint16_t>(0x2000U + i);
        // A request that was repeated, and two late answers
        Put(Sdo(0x605U, 0x40U, index, 0U));
        Ask(index, 2);
        // An answer that begins a segmented upload, and the abort of a server that gave it up
        Put(Sdo(0x605U, 0x40U, index, 1U));
        Put(Sdo(0x585U, 0x41U, index, 1U));
        Put(Sdo(0x585U, 0x80U, index, 1U));
        // Segments of a block upload that look like answers
        Put(Sdo(0x605U, 0xA4U, index, 2U));
        Put(Sdo(0x585U, 0x43U, index, 2U));
        Put(Sdo(0x585U, 0x43U, index, 2U));
        // A late answer to another object
        Put(Sdo(0x605U, 0x40U, index, 3U));
        Put(Sdo(0x585U, 0x43U, index, 0U));
        Put(Sdo(0x585U, 0x43U, index, 3U));
    }
    EXPECT_EQ(duplicates, (std::vector<std::uint8_t>{}));
}

/// An emergency message of node 5.
CanFrame Emergency(const std::uint16_t code, const std::uint8_t error_register)
{
    return CanFrame{0x85U,
                    FrameKind::kData,
                    CanPortId::kFirst,
                    8U,
                    {static_cast<std::uint8_t>(code & 0xFFU), static_cast<std::uint8_t>(code >> 8U), error_register, 0U,
                     0U, 0U, 0U, 0U}};
}

TEST_F(SecondAnswerTest, AFaultIsThatOfTheNodeWhoseIdentifierItHas)
{
    Verifies(req::SRS_MGR_025);
    // Given a node with the identifier that is that of node 16 elsewhere, and one that sends none
    setups[5].emergency_id = 0x90U;
    setups[7].emergency_id = 0x80000087U;
    Begin(Profile::kCia302);
    const auto fault = [this](const std::uint8_t node) { return manager->Watched().Of(NodeId{node}).fault; };
    CanFrame frame = Emergency(0x6100U, 0x81U);
    for (const std::uint32_t identifier : {0x85U, 0x87U, 0x90U, 0x86U})
    {
        frame.identifier = identifier;
        Put(frame);
    }
    EXPECT_EQ(fault(5U), 0x6100U);
    EXPECT_EQ(fault(6U), 0x6100U);
    EXPECT_EQ(fault(7U), 0U);
    EXPECT_EQ(fault(16U), 0U);
    EXPECT_EQ(manager->Watched().Of(NodeId{5U}).emergency.count, 1U);
}

TEST_F(SecondAnswerTest, AFaultOfTheDeviceIsKeptUntilItEnds)
{
    Verifies(req::SRS_MGR_025);
    Begin(Profile::kCia302);
    const auto fault = [this] { return manager->Watched().Of(NodeId{5U}).fault; };
    // Given errors of the bus, and of voltage and temperature, which are none of the device's parts
    Put(Emergency(0x8130U, 0x11U));
    Put(Emergency(0x4FFFU, 0x01U));
    Put(Emergency(0x8000U, 0x01U));
    EXPECT_EQ(fault(), 0U);
    // When its safe state is told, and something else behind it
    Put(Emergency(0x6100U, 0x81U));
    Put(Emergency(0x8130U, 0x91U));
    Put(Emergency(0x5000U, 0x91U));
    EXPECT_EQ(fault(), 0x6100U);
    // And one error ends, but not all
    Put(Emergency(0x0000U, 0x81U));
    EXPECT_EQ(fault(), 0x6100U);
    // Then all do, or the device boots
    Put(Emergency(0x0000U, 0x00U));
    EXPECT_EQ(fault(), 0U);
    for (const std::uint16_t code : {std::uint16_t{0x5000U}, std::uint16_t{0x6300U}, std::uint16_t{0x7FFFU}})
    {
        Put(Emergency(code, 0x81U));
        EXPECT_EQ(fault(), code);
        Put(CanFrame{0x705U, FrameKind::kData, CanPortId::kFirst, 1U, {0U}});
        EXPECT_EQ(fault(), 0U);
    }
}

TEST_F(SecondAnswerTest, GuardingAnswersOfTwo)
{
    Verifies(req::SRS_MGR_015);
    Begin(Profile::kCia302);
    // Given remote frames that are answered twice, with the toggle bit in every other cycle
    const auto guard = [this](const std::uint8_t byte, const int answers)
    {
        Put(Guarding(FrameKind::kRemote, 0U));
        for (int i = 0; i < answers; ++i)
        {
            Put(Guarding(FrameKind::kData, byte));
        }
    };
    guard(0x05U, 2);
    guard(0x85U, 2);
    guard(0x05U, 2);
    EXPECT_FALSE(IsSuspected(5U));
    // One answer alone begins the count anew
    guard(0x85U, 1);
    guard(0x05U, 2);
    guard(0x85U, 2);
    EXPECT_FALSE(IsSuspected(5U));
    guard(0x05U, 2);
    EXPECT_EQ(duplicates, (std::vector<std::uint8_t>{5U}));
}

TEST_F(SecondAnswerTest, HeartbeatsOfANodeThatIsAskedByRemoteFramesAreNone)
{
    Verifies(req::SRS_MGR_223);
    Begin(Profile::kCia302);
    for (int i = 0; i < 50; ++i)
    {
        Put(Guarding(FrameKind::kRemote, 0U));
        Put(Guarding(FrameKind::kData, 0x05U));
        Put(Guarding(FrameKind::kData, 0x05U));
    }
    EXPECT_EQ(duplicates, (std::vector<std::uint8_t>{}));
}

TEST_F(SecondAnswerTest, TwoBootUpMessagesAfterEachOfThreeResets)
{
    Verifies(req::SRS_MGR_015);
    Begin(Profile::kCia302);
    const auto reset = [this](const std::uint8_t node, const int boot_ups)
    {
        Put(CanFrame{0U, FrameKind::kData, CanPortId::kFirst, 2U, {0x82U, node, 0U, 0U, 0U, 0U, 0U, 0U}});
        for (int i = 0; i < boot_ups; ++i)
        {
            Put(Guarding(FrameKind::kData, 0U));
        }
    };
    reset(5U, 2);
    reset(0U, 2);
    reset(6U, 0);
    EXPECT_FALSE(IsSuspected(5U));
    reset(5U, 2);
    EXPECT_EQ(duplicates, (std::vector<std::uint8_t>{5U}));
}

TEST_F(SecondAnswerTest, OneDeviceThatBootsOnceForEachOfTwoResets)
{
    Verifies(req::SRS_MGR_223);
    Begin(Profile::kCia302);
    const CanFrame reset{0U, FrameKind::kData, CanPortId::kFirst, 2U, {0x82U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}};
    Put(reset);
    Put(Guarding(FrameKind::kData, 0U));
    // Given managers that elect again and again: each resets all, the second reset before the first boot-up message
    for (int i = 0; i < 20; ++i)
    {
        Put(reset);
        Put(reset);
        Put(Guarding(FrameKind::kData, 0U));
        Put(Guarding(FrameKind::kData, 0U));
        Run(500U);
    }
    EXPECT_EQ(duplicates, (std::vector<std::uint8_t>{}));
    // When one boot is made of two resets, then the second boot-up messages behind the next ones count all the same
    Put(reset);
    Put(reset);
    Put(Guarding(FrameKind::kData, 0U));
    for (int i = 0; i < 3; ++i)
    {
        Put(reset);
        Put(Guarding(FrameKind::kData, 0U));
        EXPECT_FALSE(IsSuspected(5U)) << i;
        Put(Guarding(FrameKind::kData, 0U));
    }
    EXPECT_EQ(duplicates, (std::vector<std::uint8_t>{5U}));
}

TEST_F(SecondAnswerTest, WhatWasLostIsNoQuestionThatWasAnsweredTwice)
{
    Verifies(req::SRS_MGR_223);
    Begin(Profile::kCia302);
    const CanFrame reset{0U, FrameKind::kData, CanPortId::kFirst, 2U, {0x82U, 5U, 0U, 0U, 0U, 0U, 0U, 0U}};
    // Given a host that is starved: of each second reset, request and remote frame it loses what asked
    for (int i = 0; i < 5; ++i)
    {
        Put(reset);
        Put(Guarding(FrameKind::kData, 0U));
        Ask(0x2000U, 1);
        manager->OnLost(Now());
        Put(Guarding(FrameKind::kData, 0U));
        Put(Sdo(0x585U, 0x43U, 0x2000U, 0U));
        Run(100U);
    }
    EXPECT_EQ(duplicates, (std::vector<std::uint8_t>{}));
}

TEST_F(SecondAnswerTest, AResetOfWhomeverEndsTheSuspicion)
{
    Verifies(req::SRS_MGR_226);
    Verifies(req::SRS_SFS_151);
    MakeSafe(6U);
    Begin(Profile::kCia302);
    Run(100U);
    EXPECT_EQ(Gate(6U), GateState::kOpen);
    for (std::uint16_t index = 0x2000U; index < 0x2003U; ++index)
    {
        Put(Sdo(0x606U, 0x40U, index, 0U)); // The device aborts it,
        Put(Sdo(0x586U, 0x43U, index, 0U)); // and another one has it.
    }
    EXPECT_EQ(duplicates, (std::vector<std::uint8_t>{6U}));
    EXPECT_EQ(Gate(6U), GateState::kFailed);
    Put(CanFrame{0U, FrameKind::kData, CanPortId::kFirst, 2U, {0x82U, 6U, 0U, 0U, 0U, 0U, 0U, 0U}});
    Run(200U);
    EXPECT_EQ(Gate(6U), GateState::kOpen);
    EXPECT_EQ(Running(6U), 1);
}

TEST_F(SecondAnswerTest, AnErrorControlMessageWithTheManagersOwnNodeId)
{
    Verifies(req::SRS_MGR_224);
    Begin(Profile::kCia302);
    for (const std::uint8_t byte : {std::uint8_t{0x00U}, std::uint8_t{0x05U}, std::uint8_t{0x7FU}})
    {
        duplicates.clear();
        Begin(Profile::kCia302);
        Put(CanFrame{0x77FU, FrameKind::kData, CanPortId::kFirst, 1U, {byte}});
        EXPECT_EQ(duplicates, (std::vector<std::uint8_t>{127U})) << int{byte};
    }
}

TEST_F(SecondAnswerTest, AnAnswerWithTheManagersOwnNodeId)
{
    Verifies(req::SRS_MGR_224);
    Begin(Profile::kCia302);
    Put(Sdo(0x5FFU, 0x43U, 0x1000U, 0U));
    EXPECT_EQ(duplicates, (std::vector<std::uint8_t>{127U}));
}

TEST_F(SecondAnswerTest, WithoutKnowingWhatItSentTheManagerSuspectsNobody)
{
    Verifies(req::SRS_MGR_223);
    is_echo_heard = false;
    Add(5U);
    Add(5U).boot_ms = 4U;
    Begin(Profile::kCia302);
    Run(2000U);
    EXPECT_EQ(duplicates, (std::vector<std::uint8_t>{}));
}

} // namespace
} // namespace counterpoint::cia302
