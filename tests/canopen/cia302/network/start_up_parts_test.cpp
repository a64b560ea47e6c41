// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What the parts of every start-up profile do by themselves: the objects in front of it, and the readings of the gate.
#include "canopen/cia302/network/objects.hpp"
#include "canopen/cia302/network/safety_reader.hpp"
#include "tests/canopen/start_up/boot_rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/nmt_master.hpp"

#include <map>
#include <utility>

namespace counterpoint::cia302
{
namespace
{

/// Says what the test wants to each command, and does nothing.
class SaidStartUp final : public StartUp
{
  public:
    void Begin(Instant) noexcept override
    {
    }
    void End() noexcept override
    {
    }
    void OnFrame(const CanFrame&, Instant) noexcept override
    {
    }
    void OnCycle(Instant) noexcept override
    {
    }
    void OnNodeEvent(NodeId, NodeEvent, Instant) noexcept override
    {
    }
    [[nodiscard]] NmtAnswer Command(NmtCommand, NodeId node, Instant) noexcept override
    {
        asked.push_back(node.value);
        const auto found = answers.find(node.value);
        return (found == answers.end()) ? NmtAnswer::kTaken : found->second;
    }
    [[nodiscard]] bool Boot(NodeId node, Instant) noexcept override
    {
        booted.push_back(node.value);
        return node.value != 7U;
    }
    [[nodiscard]] bool Configure(NodeId, Instant) noexcept override
    {
        return false;
    }
    [[nodiscard]] NodeStatus Status(NodeId) const noexcept override
    {
        return status;
    }
    [[nodiscard]] std::int16_t MasterState() const noexcept override
    {
        return 0;
    }

    std::map<std::uint8_t, NmtAnswer> answers{};
    std::vector<std::uint8_t> asked{};
    std::vector<std::uint8_t> booted{};
    NodeStatus status{};
};

using Nodes = std::vector<std::uint8_t>;

/// Slaves 5, 6 and 7 are listed; nobody is there.
class StartUpPartsTest : public BootRig
{
  public:
    StartUpPartsTest()
    {
        for (std::uint8_t node = 5U; node <= 7U; ++node)
        {
            setups[node].assignment = kBoot;
        }
    }
    SdoAbort Write(std::uint8_t sub, std::uint8_t value)
    {
        return objects.OnWrite(ObjectAddress{0x1F82U, sub}, Bytes{&value, 1U});
    }
    SdoAbort WriteAgain(std::uint8_t sub, std::uint8_t value)
    {
        return objects.OnWriteAgain(ObjectAddress{0x1F82U, sub}, Bytes{&value, 1U});
    }
    /// Node 5 says its state.
    void Says(std::uint8_t state)
    {
        table.OnFrame(CanFrame{0x705U, FrameKind::kData, CanPortId::kFirst, 1U, {state}}, Now());
    }
    /// NMT frames since the last call, command and node.
    std::vector<std::pair<int, int>> Left()
    {
        std::vector<std::pair<int, int>> left{};
        for (const CanFrame& frame : wire)
        {
            left.emplace_back(frame.data[0], frame.data[1]);
        }
        wire.clear();
        return left;
    }

    SaidStartUp said{};
    NetworkObjects objects{NetworkObjectParts{setup, &setup, setups.data(), table, said}};
    StartUpParts parts{setup, table, nmt, sdo, gate, *this, *this};
    SafetyReader reader{parts};
    SafetyReading reading{};
};

using Frames = std::vector<std::pair<int, int>>;

TEST_F(StartUpPartsTest, EachAnswerToACommandHasItsAbortCode)
{
    Verifies(req::SRS_NMM_210);
    const std::pair<NmtAnswer, SdoAbort> cases[] = {{NmtAnswer::kTaken, SdoAbort::kNone},
                                                    {NmtAnswer::kPartly, SdoAbort::kNone},
                                                    {NmtAnswer::kQueueFull, SdoAbort::kPending},
                                                    {NmtAnswer::kNotActive, SdoAbort::kDeviceState},
                                                    {NmtAnswer::kNoBroadcast, SdoAbort::kDeviceState},
                                                    {NmtAnswer::kNotVerified, SdoAbort::kDeviceState},
                                                    {NmtAnswer::kOtherDevice, SdoAbort::kDeviceState},
                                                    {NmtAnswer::kWrong, SdoAbort::kValueRange},
                                                    {NmtAnswer::kInvalid, SdoAbort::kValueRange}};
    for (const auto& [answer, abort] : cases)
    {
        said.answers[5U] = answer;
        EXPECT_EQ(Write(5U, 5U), abort) << static_cast<int>(answer);
        said.answers[0U] = answer;
        EXPECT_EQ(Write(0x80U, 5U), abort) << static_cast<int>(answer);
    }
}

TEST_F(StartUpPartsTest, ANodeWhoseStateDoesNotAllowACommandToEachKeepsNoOtherOneFromIt)
{
    Verifies(req::SRS_NMM_211);
    EXPECT_FALSE(said.IsLeftOut(NodeId{5U})); // By itself a profile leaves out nobody.
    said.answers[5U] = NmtAnswer::kWrong;
    EXPECT_EQ(Write(0x80U, 0x85U), SdoAbort::kNone);
    EXPECT_EQ(said.asked, (Nodes{5U, 6U, 7U}));
}

TEST_F(StartUpPartsTest, AnotherDeviceIsToldAtTheEndAlsoBehindAFullQueue)
{
    Verifies(req::SRS_NMM_211);
    Verifies(req::SRS_NMM_212);
    Verifies(req::SRS_SFS_009);
    Verifies(req::SRS_SFS_340);
    said.answers[5U] = NmtAnswer::kOtherDevice;
    said.answers[6U] = NmtAnswer::kQueueFull;
    EXPECT_EQ(Write(0x80U, 0x85U), SdoAbort::kPending);
    EXPECT_EQ(WriteAgain(0x80U, 0x85U), SdoAbort::kPending);
    said.answers[6U] = NmtAnswer::kTaken;
    EXPECT_EQ(WriteAgain(0x80U, 0x85U), SdoAbort::kDeviceState);
    EXPECT_EQ(said.asked, (Nodes{5U, 6U, 6U, 6U, 7U}));
    // The next one knows nothing of it
    said.answers[5U] = NmtAnswer::kTaken;
    EXPECT_EQ(Write(0x80U, 0x84U), SdoAbort::kNone);
}

TEST_F(StartUpPartsTest, WhoIsNotActiveTellsNobody)
{
    Verifies(req::SRS_NMM_210);
    said.answers[5U] = NmtAnswer::kNotActive;
    EXPECT_EQ(Write(0x80U, 0x84U), SdoAbort::kDeviceState);
    EXPECT_EQ(said.asked, (Nodes{5U}));
    said.answers.clear();
    EXPECT_EQ(Write(0x80U, 0x84U), SdoAbort::kNone); // From the first node on.
    EXPECT_EQ(said.asked, (Nodes{5U, 5U, 6U, 7U}));
}

TEST_F(StartUpPartsTest, AWriteThatWaitedIsDoneAsTheFirstTime)
{
    Verifies(req::SRS_NMM_010);
    const std::uint8_t number[4] = {13U, 0U, 0U, 0U};
    EXPECT_EQ(objects.OnWriteAgain(ObjectAddress{0x1F81U, 9U}, Bytes{number, 4U}), SdoAbort::kNone);
    EXPECT_EQ(setups[9].assignment, 13U);
}

TEST_F(StartUpPartsTest, ANodeThatIsInNoListAndWasHeardHasAState)
{
    Verifies(req::SRS_NMM_007);
    std::uint8_t value[4] = {};
    table.OnFrame(CanFrame{0x709U, FrameKind::kData, CanPortId::kFirst, 1U, {4U}}, Now());
    EXPECT_EQ(objects.OnRead(ObjectAddress{0x1F82U, 9U}, Room{value, 4U}).size_bytes, 1U);
    EXPECT_EQ(value[0], 4U);
    EXPECT_EQ(objects.OnRead(ObjectAddress{0x1F82U, 10U}, Room{value, 4U}).size_bytes, 1U);
    EXPECT_EQ(value[0], 0U);
}

TEST_F(StartUpPartsTest, AGuardTimeWithoutAFactorIsNoGuarding)
{
    Verifies(req::SRS_NMM_008);
    setups[5].assignment = kBoot | (100U << 16U);
    const std::uint8_t on = 1U;
    EXPECT_EQ(objects.OnWrite(ObjectAddress{0x1F83U, 5U}, Bytes{&on, 1U}), SdoAbort::kDeviceState);
    setups[5].assignment = kBoot | (100U << 16U) | (1U << 8U);
    EXPECT_EQ(objects.OnWrite(ObjectAddress{0x1F83U, 5U}, Bytes{&on, 1U}), SdoAbort::kNone);
}

TEST_F(StartUpPartsTest, AProfileWithoutARestOfItsOwnBootsAgain)
{
    Verifies(req::SRS_NMM_151);
    said.OnBusBack(Now());
    said.OnStartDropped(NodeId{5U}, Now());
    EXPECT_EQ(said.booted, Nodes{});
    EXPECT_TRUE(said.Resume(NodeId{5U}, Now()));
    EXPECT_FALSE(said.Resume(NodeId{7U}, Now()));
    EXPECT_EQ(said.booted, (Nodes{5U, 7U}));
    EXPECT_EQ(said.Identity(), IdentityRule::kCia302);
}

TEST_F(StartUpPartsTest, WhoIsBusyStoppedOrAnotherDeviceIsNotConfigurable)
{
    Verifies(req::SRS_NMM_150);
    const NodeId node{5U};
    EXPECT_TRUE(IsConfigurable(parts, said, node));
    said.status.is_busy = true;
    EXPECT_FALSE(IsConfigurable(parts, said, node));
    said.status.is_busy = false;
    // Another device counts of a safety slave alone
    said.status.is_other = true;
    EXPECT_TRUE(IsConfigurable(parts, said, node));
    Protect(5U);
    EXPECT_FALSE(IsConfigurable(parts, said, node));
    said.status.is_other = false;
    EXPECT_TRUE(IsConfigurable(parts, said, node));
    // It says so
    Says(4U);
    EXPECT_FALSE(IsConfigurable(parts, said, node));
    Says(127U);
    EXPECT_TRUE(IsConfigurable(parts, said, node));
    // Or was told so, until it has said twice that it is OPERATIONAL
    EXPECT_EQ(nmt.Request(NmtCommand::kStop, node, Now()), NmtAnswer::kTaken);
    EXPECT_FALSE(IsConfigurable(parts, said, node));
    Says(5U);
    EXPECT_FALSE(IsConfigurable(parts, said, node));
    Says(5U);
    EXPECT_TRUE(IsConfigurable(parts, said, node));
}

TEST_F(StartUpPartsTest, ASafetySlaveIsReadBeforeItsStart)
{
    Verifies(req::SRS_SFS_002);
    Protect(5U);
    const NodeId node{5U};
    EXPECT_EQ(reader.BeforeStart(reading, node, false, Now()), ReadingEnd::kBegun);
    EXPECT_EQ(gate.verifications, 1);
    EXPECT_EQ(reader.BeforeStart(reading, node, false, Now()), ReadingEnd::kWaits);
    gate.OnCycle(Now());
    EXPECT_EQ(reader.BeforeStart(reading, node, false, Now()), ReadingEnd::kOpen);
    // A gate that closes meanwhile reads once more, and may refuse
    gate.Close(node);
    gate.verdict = GateState::kDiffers;
    EXPECT_EQ(reader.BeforeStart(reading, node, false, Now()), ReadingEnd::kWaits);
    EXPECT_EQ(reader.BeforeStart(reading, node, false, Now()), ReadingEnd::kBegun);
    EXPECT_EQ(gate.verifications, 2);
    gate.OnCycle(Now());
    EXPECT_EQ(reader.BeforeStart(reading, node, false, Now()), ReadingEnd::kRefused);
    gate.states[5] = GateState::kFailed;
    EXPECT_EQ(reader.BeforeStart(reading, node, false, Now()), ReadingEnd::kRefused);
    EXPECT_EQ(Left(), Frames{});
}

TEST_F(StartUpPartsTest, AStoppedSlaveIsMadePreOperationalToBeRead)
{
    Verifies(req::SRS_SFS_002);
    Protect(5U);
    setup.inhibit_100us = 20U;
    const NodeId node{5U};
    // Given a command that keeps the next one waiting for 2 ms
    EXPECT_EQ(nmt.Request(NmtCommand::kStop, node, Now()), NmtAnswer::kTaken);
    EXPECT_EQ(reader.BeforeStart(reading, node, true, Now()), ReadingEnd::kWaits);
    // Then it is not read before it has the other one
    EXPECT_EQ(reader.BeforeStart(reading, node, true, Now()), ReadingEnd::kWaits);
    EXPECT_EQ(gate.verifications, 0);
    EXPECT_EQ(Left(), (Frames{{2, 5}}));
    ms += 2U;
    nmt.OnCycle(Now());
    EXPECT_EQ(Left(), (Frames{{128, 5}}));
    EXPECT_EQ(reader.BeforeStart(reading, node, true, Now()), ReadingEnd::kBegun);
    EXPECT_EQ(gate.verifications, 1);
    // A command for somebody else that waits keeps nobody from being read
    reading = SafetyReading{};
    EXPECT_EQ(reader.BeforeStart(reading, node, true, Now()), ReadingEnd::kWaits);
    EXPECT_EQ(nmt.Request(NmtCommand::kResetNode, NodeId{6U}, Now()), NmtAnswer::kTaken);
    EXPECT_EQ(nmt.Waiting(), 2U);
    ms += 2U;
    nmt.OnCycle(Now());
    EXPECT_EQ(nmt.Waiting(), 1U);
    EXPECT_EQ(reader.BeforeStart(reading, node, true, Now()), ReadingEnd::kBegun);
}

TEST_F(StartUpPartsTest, ACommandThatIsNotTakenIsTriedAgain)
{
    Verifies(req::SRS_SFS_002);
    Protect(5U);
    nmt.SetActive(false);
    EXPECT_EQ(reader.BeforeStart(reading, NodeId{5U}, true, Now()), ReadingEnd::kWaits);
    EXPECT_EQ(reader.BeforeStart(reading, NodeId{5U}, true, Now()), ReadingEnd::kWaits);
    EXPECT_EQ(gate.verifications, 0);
    nmt.SetActive(true);
    EXPECT_EQ(reader.BeforeStart(reading, NodeId{5U}, true, Now()), ReadingEnd::kWaits);
    EXPECT_EQ(Left(), (Frames{{128, 5}}));
    EXPECT_EQ(reader.BeforeStart(reading, NodeId{5U}, true, Now()), ReadingEnd::kBegun);
}

TEST_F(StartUpPartsTest, ASlaveThatRunsIsReadWhenItIsSuspect)
{
    Verifies(req::SRS_SFS_006);
    Protect(5U);
    const NodeId node{5U};
    EXPECT_EQ(reader.OfRunning(reading, node, false, Now()), ReadingEnd::kWaits);
    EXPECT_EQ(gate.verifications, 0);
    EXPECT_EQ(reader.OfRunning(reading, node, true, Now()), ReadingEnd::kBegun);
    EXPECT_EQ(reader.OfRunning(reading, node, true, Now()), ReadingEnd::kWaits); // It is being read.
    EXPECT_EQ(gate.verifications, 1);
    gate.OnCycle(Now());
    EXPECT_EQ(reader.OfRunning(reading, node, false, Now()), ReadingEnd::kOpen);
    EXPECT_TRUE(reading.was_checked);
    EXPECT_EQ(reader.OfRunning(reading, node, false, Now()), ReadingEnd::kWaits);
    // Another time it is not as expected
    gate.verdict = GateState::kFailed;
    EXPECT_EQ(reader.OfRunning(reading, node, true, Now()), ReadingEnd::kBegun);
    gate.OnCycle(Now());
    EXPECT_EQ(reader.OfRunning(reading, node, false, Now()), ReadingEnd::kRefused);
    EXPECT_FALSE(reading.was_checked);
}

TEST_F(StartUpPartsTest, WhoRunsAndCannotBeReadIsStoppedThenWoken)
{
    Verifies(req::SRS_SFS_006);
    const NodeId node{5U};
    bool is_unread = false;
    // No safety slave, or none that runs surely
    Says(5U);
    Says(5U);
    reader.StopUnread(is_unread, node, false, Now());
    Protect(5U);
    EXPECT_EQ(nmt.Request(NmtCommand::kPreOperational, node, Now()), NmtAnswer::kTaken);
    Says(5U);
    EXPECT_EQ(Left(), (Frames{{128, 5}}));
    reader.StopUnread(is_unread, node, false, Now());
    EXPECT_EQ(Left(), Frames{});
    // A second sign says so
    Says(5U);
    reader.StopUnread(is_unread, node, false, Now());
    EXPECT_EQ(Left(), (Frames{{2, 5}}));
    EXPECT_TRUE(is_unread);
    // At the next silence it is made PRE-OPERATIONAL; not taken, it is tried at the one behind that
    nmt.SetActive(false);
    reader.StopUnread(is_unread, node, true, Now());
    EXPECT_TRUE(is_unread);
    nmt.SetActive(true);
    reader.StopUnread(is_unread, node, true, Now());
    EXPECT_EQ(Left(), (Frames{{128, 5}}));
    EXPECT_FALSE(is_unread);
}

TEST_F(StartUpPartsTest, OnlyAnObjectThatSaysWhoASlaveIsMakesItAnotherDevice)
{
    Verifies(req::SRS_SFS_217);
    Protect(5U);
    gate.states[5] = GateState::kDiffers;
    const std::pair<std::uint16_t, bool> cases[] = {
        {std::uint16_t{0x1000U}, true}, {std::uint16_t{0x1018U}, true}, {std::uint16_t{0x13FEU}, false}};
    for (const auto& [index, is_other] : cases)
    {
        gate.finding.object = ObjectAddress{index, 0U};
        EXPECT_EQ(gate.IsOther(NodeId{5U}), is_other) << index;
    }
    // One that does not answer is no other device
    gate.finding.object = ObjectAddress{0x1000U, 0U};
    gate.states[5] = GateState::kFailed;
    EXPECT_FALSE(gate.IsOther(NodeId{5U}));
}

} // namespace
} // namespace counterpoint::cia302
