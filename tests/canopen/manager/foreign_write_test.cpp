// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Somebody else writes into a safety slave while the manager reads it, before the start and behind it.
#include "tests/canopen/manager/rig.hpp"
#include "verification/trace/ids/manager.hpp"

namespace counterpoint::cia302
{
namespace
{

/// What somebody else writes by SDO, expedited.
CanFrame Write(const std::uint16_t index, const std::uint8_t sub, const std::uint8_t bytes, const std::uint16_t value)
{
    const auto command = static_cast<std::uint8_t>(0x23U | ((4U - bytes) << 2U));
    return CanFrame{0x605U,
                    FrameKind::kData,
                    CanPortId::kFirst,
                    8U,
                    {command, static_cast<std::uint8_t>(index & 0xFFU), static_cast<std::uint8_t>(index >> 8U), sub,
                     static_cast<std::uint8_t>(value & 0xFFU), static_cast<std::uint8_t>(value >> 8U), 0U, 0U}};
}

/// A request of somebody else to the slave.
CanFrame Request(const std::uint8_t command, const std::uint16_t index, const std::uint8_t sub)
{
    CanFrame frame = Write(index, sub, 1U, 0U);
    frame.data[0] = command;
    return frame;
}

/// The manager hears an answer of the slave to somebody else.
CanFrame Answer(const std::uint8_t command, const std::uint16_t index, const std::uint8_t sub)
{
    CanFrame frame = Write(index, sub, 1U, 0U);
    frame.identifier = 0x585U;
    frame.data[0] = command;
    return frame;
}

/// Given a safety slave 5 that leaves 13FEh as it is when its configuration is written.
class ForeignWriteTest : public ManagerRig, public ::testing::WithParamInterface<Profile>
{
  public:
    ForeignWriteTest()
    {
        Add(5U);
        MakeSafe(5U);
    }
    /// Until `cycles` after the reading begins.
    void RunIntoReading(const std::uint32_t cycles)
    {
        for (int i = 0; (i < 9000) && (Gate() != GateState::kBusy); ++i)
        {
            Run(1U);
        }
        EXPECT_EQ(Gate(), GateState::kBusy);
        Run(cycles);
    }
    /// Cycles from the begin of the reading to its end.
    std::uint32_t Rest()
    {
        std::uint32_t cycles = 0U;
        for (; (cycles < 100U) && (Gate() == GateState::kBusy); ++cycles)
        {
            Run(1U);
        }
        return cycles;
    }
    /// The manager hears a request that the slave has not answered yet.
    void Ask(const CanFrame& request)
    {
        devices.front()->is_sdo_mute = true;
        Put(request);
        devices.front()->is_sdo_mute = false;
    }
    [[nodiscard]] std::uint16_t Finding() const
    {
        return manager->Gate().Finding(NodeId{5U}).object.index;
    }
    /// Somebody writes behind the reading, while the start waits for the inhibit time: it is not started.
    void WriteWhileTheStartWaits(const CanFrame& write)
    {
        setup.inhibit_100us = 10000U;
        Begin(GetParam());
        bool is_waiting = false;
        for (int i = 0; (i < 9000) && !is_waiting; ++i)
        {
            Run(1U);
            is_waiting = (Gate() == GateState::kOpen) && (manager->ProfileParts().nmt.Waiting() > 0U);
        }
        EXPECT_TRUE(is_waiting);
        Put(write);
        EXPECT_EQ(Gate(), GateState::kClosed);
        Run(6000U);
        EXPECT_EQ(Running(5U), 0);
        EXPECT_TRUE(starts.empty());
        EXPECT_EQ(Gate(), GateState::kDiffers);
    }
    /// A slave that the application is to start, without heartbeat and guarding: somebody else starts it and then
    /// writes.
    void ExpectFoundBehindForeignStart(const CanFrame& write, const std::uint16_t index)
    {
        setup.start_up |= kApplicationStartsSlaves;
        box.is_started = false;
        setups[5].el6751 = &box;
        Begin(GetParam());
        Run(6000U);
        Put(Nmt(NmtCommand::kStart, 5U));
        Run(3000U);
        EXPECT_EQ(Running(5U), 1);
        EXPECT_EQ(Gate(), GateState::kOpen);
        EXPECT_TRUE(starts.empty());
        Put(write);
        Run(3000U);
        EXPECT_EQ(Running(5U), 0);
        EXPECT_EQ(Gate(), GateState::kDiffers);
        EXPECT_EQ(Finding(), index);
    }
    /// At each instant of the reading and behind it: somebody writes, and the slave is not left running.
    void ExpectFound(const CanFrame& wrong, const CanFrame& right, const std::uint16_t index, const std::uint32_t last)
    {
        Begin(GetParam());
        for (std::uint32_t cycles = 0U; cycles < last; ++cycles)
        {
            RunIntoReading(cycles);
            Put(wrong);
            Run(6000U);
            EXPECT_EQ(Running(5U), 0) << cycles;
            EXPECT_EQ(Gate(), GateState::kDiffers) << cycles;
            EXPECT_EQ(Finding(), index) << cycles;
            // And where it is put right, the next start-up starts it
            Put(Nmt(NmtCommand::kPreOperational, 5U));
            Put(right);
            EXPECT_TRUE(manager->Role().Boot(NodeId{5U}, Now()));
        }
        Run(6000U);
        EXPECT_EQ(Running(5U), 1);
    }

    El6751Slave box{};
};

TEST_P(ForeignWriteTest, OfATimeIsFoundAtEachInstantOfTheReadingAndBehindIt)
{
    Verifies(req::SRS_SFS_011);
    Verifies(req::SRS_SFS_219);
    ExpectFound(Write(0x1301U, 2U, 2U, 26U), Write(0x1301U, 2U, 2U, 25U), 0x1301U, 24U);
}

TEST_P(ForeignWriteTest, OfASignatureIsFoundAtEachInstantOfTheReadingAndBehindIt)
{
    Verifies(req::SRS_SFS_011);
    Verifies(req::SRS_SFS_219);
    ExpectFound(Write(0x13FFU, 1U, 2U, 0x1235U), Write(0x13FFU, 1U, 2U, 0x1234U), 0x13FFU, 24U);
}

TEST_P(ForeignWriteTest, OfTheGfcIsFoundAtEachInstantOfTheReading)
{
    Verifies(req::SRS_SFS_011);
    Verifies(req::SRS_SFS_220);
    ExpectFound(Write(0x1300U, 0U, 1U, 0U), Write(0x1300U, 0U, 1U, 1U), 0x1300U, 10U);
}

TEST_P(ForeignWriteTest, WhileTheStartWaitsIsFound)
{
    Verifies(req::SRS_SFS_011);
    WriteWhileTheStartWaits(Write(0x1301U, 3U, 1U, 21U));
    EXPECT_EQ(Finding(), 0x1301U);
}

TEST_P(ForeignWriteTest, OfTheGfcWhileTheStartWaitsIsFound)
{
    Verifies(req::SRS_SFS_011);
    WriteWhileTheStartWaits(Write(0x1300U, 0U, 1U, 0U));
    EXPECT_EQ(Finding(), 0x1300U);
}

TEST_P(ForeignWriteTest, OfTheSameValueOrToTheStoreBeginsTheReadingAnew)
{
    Verifies(req::SRS_SFS_011);
    Begin(GetParam());
    RunIntoReading(0U);
    const std::uint32_t whole = Rest();
    EXPECT_GT(whole, 10U);
    const CanFrame writes[] = {Write(0x1301U, 2U, 2U, 25U), Answer(0x60U, 0x1010U, 1U), Answer(0x60U, 0x1011U, 4U),
                               Answer(0x60U, 0x13C0U, 0U), Answer(0xA4U, 0x1381U, 0U)};
    for (const CanFrame& write : writes)
    {
        Run(6000U);
        EXPECT_EQ(Running(5U), 1);
        EXPECT_TRUE(manager->Role().Boot(NodeId{5U}, Now()));
        RunIntoReading(8U);
        Put(write);
        EXPECT_GE(Rest(), whole - 1U);
    }
    Run(6000U);
    EXPECT_EQ(Running(5U), 1);
}

// Given a download that somebody began before the reading, then its end within the reading is the write.
TEST_P(ForeignWriteTest, OfWhatWasBegunBeforeTheReadingBeginsItAnew)
{
    Verifies(req::SRS_SFS_011);
    Begin(GetParam());
    RunIntoReading(0U);
    const std::uint32_t whole = Rest();
    const CanFrame begins[] = {Answer(0x60U, 0x1301U, 2U), Answer(0x60U, 0x13FFU, 1U), Answer(0xA4U, 0x1381U, 0U)};
    const CanFrame ends[] = {Answer(0x20U, 0U, 0U), Answer(0x30U, 0U, 0U), Answer(0xA1U, 0U, 0U)};
    for (std::size_t kind = 0U; kind < 3U; ++kind)
    {
        Run(6000U);
        EXPECT_EQ(Running(5U), 1);
        EXPECT_TRUE(manager->Role().Boot(NodeId{5U}, Now()));
        RunIntoReading(2U);
        Put(begins[kind]);
        RunIntoReading(8U);
        Put(ends[kind]);
        EXPECT_GE(Rest(), whole - 1U) << kind;
    }
    // A segment of another object is none
    Run(6000U);
    EXPECT_TRUE(manager->Role().Boot(NodeId{5U}, Now()));
    RunIntoReading(2U);
    Put(Answer(0x60U, 0x1F50U, 1U));
    RunIntoReading(8U);
    Put(Answer(0x20U, 0U, 0U));
    EXPECT_EQ(Rest(), whole - 10U);
}

TEST_P(ForeignWriteTest, WhatIsNoWriteOfTheConfigurationDisturbsNothing)
{
    Verifies(req::SRS_SFS_221);
    Begin(GetParam());
    RunIntoReading(0U);
    const std::uint32_t whole = Rest();
    CanFrame other = Answer(0x60U, 0x1301U, 2U);
    other.identifier = 0x586U;
    CanFrame is_short = Answer(0x60U, 0x1301U, 2U);
    is_short.length_bytes = 7U;
    // An abort, a value that was read, the ends of a block, another object, another node, no SDO
    const CanFrame frames[] = {Answer(0x80U, 0x1400U, 2U),
                               Answer(0x4BU, 0x1400U, 2U),
                               Answer(0xA2U, 0x1301U, 2U),
                               Answer(0xA1U, 0x1301U, 2U),
                               Answer(0x60U, 0x1017U, 0U),
                               Answer(0x60U, 0x1400U, 0U),
                               Answer(0x60U, 0x12FFU, 0U),
                               other,
                               is_short};
    for (const CanFrame& frame : frames)
    {
        Run(6000U);
        EXPECT_EQ(Running(5U), 1);
        EXPECT_TRUE(manager->Role().Boot(NodeId{5U}, Now()));
        RunIntoReading(8U);
        Put(frame);
        EXPECT_EQ(Rest(), whole - 8U) << int{frame.data[0]};
    }
}

TEST_P(ForeignWriteTest, OfATimeOfASlaveThatSomebodyElseStartedIsFound)
{
    Verifies(req::SRS_SFS_006);
    Verifies(req::SRS_SFS_150);
    Verifies(req::SRS_SFS_219);
    ExpectFoundBehindForeignStart(Write(0x1301U, 2U, 2U, 26U), 0x1301U);
}

// The manager has not started it: nothing of what was read counts behind the write.
TEST_P(ForeignWriteTest, OfTheGfcOfASlaveThatSomebodyElseStartedIsFound)
{
    Verifies(req::SRS_SFS_006);
    Verifies(req::SRS_SFS_150);
    Verifies(req::SRS_SFS_219);
    ExpectFoundBehindForeignStart(Write(0x1300U, 0U, 1U, 0U), 0x1300U);
}

TEST_P(ForeignWriteTest, OfTheGfcOfASlaveThatRunsIsItsRight)
{
    Verifies(req::SRS_SFS_219);
    Begin(GetParam());
    Run(6000U);
    EXPECT_EQ(Running(5U), 1);
    Put(Write(0x1300U, 0U, 1U, 0U));
    Put(Answer(0x60U, 0x1010U, 1U));
    Run(3000U);
    EXPECT_EQ(Running(5U), 1);
    EXPECT_EQ(Gate(), GateState::kOpen);
    // But what a device takes before its start alone was written before: it is read, and here it differs
    Put(Write(0x1301U, 4U, 1U, 3U));
    Run(3000U);
    EXPECT_EQ(Running(5U), 0);
    EXPECT_EQ(Gate(), GateState::kDiffers);
    EXPECT_EQ(Finding(), 0x1300U);
}

// Given a start that waits for the inhibit time, then a write that is asked for goes before it.
TEST_P(ForeignWriteTest, AStartDoesNotLeaveBehindARequest)
{
    Verifies(req::SRS_MGR_320);
    setup.inhibit_100us = 10000U;
    Begin(GetParam());
    for (int i = 0; (i < 9000) && !((Gate() == GateState::kOpen) && (manager->ProfileParts().nmt.Waiting() > 0U)); ++i)
    {
        Run(1U);
    }
    ASSERT_EQ(Gate(), GateState::kOpen);
    ASSERT_TRUE(starts.empty());
    Ask(Write(0x1301U, 3U, 1U, 21U));
    EXPECT_EQ(Gate(), GateState::kClosed);
    // The device refused it, as far as is known: it is read, and started
    Run(6000U);
    EXPECT_EQ(Running(5U), 1);
}

TEST_P(ForeignWriteTest, ARequestBeginsTheReadingAnew)
{
    Verifies(req::SRS_MGR_320);
    Begin(GetParam());
    RunIntoReading(0U);
    const std::uint32_t whole = Rest();
    // Expedited, in segments, in blocks, with the segment and the end of a block that were begun before
    const CanFrame requests[] = {Write(0x1301U, 2U, 2U, 26U), Write(0x1300U, 0U, 1U, 0U),  Request(0x21U, 0x13FFU, 1U),
                                 Request(0x20U, 0x1010U, 1U), Request(0xC6U, 0x1381U, 0U), Request(0x23U, 0x1011U, 4U)};
    for (const CanFrame& request : requests)
    {
        Run(6000U);
        EXPECT_EQ(Running(5U), 1);
        EXPECT_TRUE(manager->Role().Boot(NodeId{5U}, Now()));
        RunIntoReading(8U);
        Ask(request);
        EXPECT_GE(Rest(), whole - 1U) << int{request.data[0]};
    }
    const CanFrame ends[] = {Request(0x0DU, 0U, 0U), Request(0x1DU, 0U, 0U), Request(0xC1U, 0U, 0U)};
    for (const CanFrame& end : ends)
    {
        Run(6000U);
        EXPECT_TRUE(manager->Role().Boot(NodeId{5U}, Now()));
        RunIntoReading(2U);
        Put(Answer(0x60U, 0x1301U, 2U));
        RunIntoReading(8U);
        Ask(end);
        EXPECT_GE(Rest(), whole - 1U) << int{end.data[0]};
    }
}

TEST_P(ForeignWriteTest, ARequestThatWritesNoConfigurationDisturbsNothing)
{
    Verifies(req::SRS_MGR_320);
    Begin(GetParam());
    RunIntoReading(0U);
    const std::uint32_t whole = Rest();
    CanFrame other = Write(0x1301U, 2U, 2U, 26U);
    other.identifier = 0x606U;
    CanFrame is_short = Write(0x1301U, 2U, 2U, 26U);
    is_short.length_bytes = 7U;
    CanFrame is_long = Write(0x1301U, 2U, 2U, 26U);
    is_long.kind = FrameKind::kExtended;
    // A question, an abort, the answer to a block that is read, other objects, another node, no SDO
    const CanFrame frames[] = {Request(0x40U, 0x1301U, 2U),
                               Request(0x80U, 0x1301U, 2U),
                               Request(0xA2U, 0x1301U, 2U),
                               Request(0x2BU, 0x1017U, 0U),
                               Request(0x2BU, 0x12FFU, 0U),
                               Request(0x2BU, 0x1400U, 0U),
                               other,
                               is_short,
                               is_long};
    for (const CanFrame& frame : frames)
    {
        Run(6000U);
        EXPECT_EQ(Running(5U), 1);
        EXPECT_TRUE(manager->Role().Boot(NodeId{5U}, Now()));
        RunIntoReading(8U);
        Ask(frame);
        EXPECT_EQ(Rest(), whole - 8U) << int{frame.data[0]};
    }
    // Nor does one to a slave that runs: it refuses
    Run(6000U);
    EXPECT_EQ(Running(5U), 1);
    Ask(Write(0x1301U, 2U, 2U, 26U));
    EXPECT_EQ(Gate(), GateState::kOpen);
    Run(1000U);
    EXPECT_EQ(Running(5U), 1);
    EXPECT_EQ(Gate(), GateState::kOpen);
}

INSTANTIATE_TEST_SUITE_P(Profiles, ForeignWriteTest, ::testing::ValuesIn(kProfiles));

} // namespace
} // namespace counterpoint::cia302
