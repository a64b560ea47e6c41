// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The gate in front of a real kernel device: what it reads, what opens it, and what a slave that lies gets.
#include "tests/canopen/cia302/safety_gate/rig.hpp"
#include "verification/trace/ids/manager.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr NodeId kSlave{2U};

class SafetyGateTest : public GateRig
{
  protected:
    void SetUp() override
    {
        Start();
        Cycle();
        Expect(Configuration());
    }
    GateState Verified()
    {
        gate.Verify(kSlave, Instant{now_us});
        Finish();
        return gate.State(kSlave);
    }
};

/// Puts another value into the answer about one object.
std::function<bool(CanFrame&)> Lie(const std::uint16_t index, const std::uint8_t sub, const std::uint8_t change)
{
    return [=](CanFrame& frame)
    {
        const bool is_it = (frame.data[0] != 0x80U) && (frame.data[1] == (index & 0xFFU)) &&
                           (frame.data[2] == (index >> 8U)) && (frame.data[3] == sub);
        frame.data[4] = is_it ? static_cast<std::uint8_t>(frame.data[4] ^ change) : frame.data[4];
        return true;
    };
}

TEST_F(SafetyGateTest, OpensWhenEveryObjectIsAsExpected)
{
    Verifies(req::SRS_SFS_001);
    Verifies(req::SRS_SFS_002);
    EXPECT_EQ(gate.State(kSlave), GateState::kClosed);
    EXPECT_FALSE(gate.MayStart(kSlave));
    // When the gate has read
    EXPECT_EQ(Verified(), GateState::kOpen);
    // Then it asked for 13FEh, for 1300h, sub-index 0 and six settings, count and entries of each SRDO, the signatures,
    // and for 1300h and 13FEh again
    EXPECT_TRUE(written.empty());
    ASSERT_EQ(read.size(), 2U + 2U + (3U * 7U) + (3U + 3U + 1U) + 4U);
    EXPECT_EQ(read.front().index, 0x13FEU);
    EXPECT_EQ(read[1].index, 0x1300U);
    EXPECT_EQ(read[2].index, 0x1301U);
    EXPECT_EQ(read[2].sub, 0U);
    EXPECT_EQ(read[read.size() - 2U].index, 0x1300U);
    EXPECT_EQ(read.back().index, 0x13FEU);
    EXPECT_TRUE(gate.MayStart(kSlave));
}

TEST_F(SafetyGateTest, NamesEachObjectThatDiffers)
{
    Verifies(req::SRS_SFS_001);
    Verifies(req::SRS_SFS_003);
    for (const ExpectedObject& object : expected)
    {
        // Given a slave that has another value in this one object
        on_answer = Lie(object.address.index, object.address.sub, 0x10U);
        EXPECT_EQ(Verified(), GateState::kDiffers);
        const GateFinding finding = gate.Finding(kSlave);
        EXPECT_EQ(finding.object.index, object.address.index);
        EXPECT_EQ(finding.object.sub, object.address.sub);
        EXPECT_EQ(finding.abort, SdoAbort::kNone);
        EXPECT_EQ(finding.expected, object.value);
        EXPECT_EQ(finding.read, object.value ^ 0x10U);
        EXPECT_FALSE(gate.MayStart(kSlave));
    }
}

TEST_F(SafetyGateTest, AConfigurationThatIsNotValidIsNamedFirst)
{
    Verifies(req::SRS_SFS_001);
    Verifies(req::SRS_SFS_003);
    // Given a real change: SCT of SRDO 1 from 50 ms to 60 ms, which clears 13FEh
    ASSERT_EQ(Download(0x1301U, 2U, 60U, 2U), 0U);
    EXPECT_EQ(Verified(), GateState::kDiffers);
    EXPECT_EQ(gate.Finding(kSlave).object.index, 0x13FEU);
    EXPECT_EQ(gate.Finding(kSlave).expected, 0xA5U);
    EXPECT_EQ(gate.Finding(kSlave).read, 0U);
    // When somebody signs it and declares it valid, it still is not what was expected
    ASSERT_EQ(Download(0x13FFU, 1U, core.Sign(CommunicationIndex{0x1301U}).signature, 2U), 0U);
    ASSERT_EQ(Download(0x13FEU, 0U, 0xA5U, 1U), 0U);
    EXPECT_EQ(Verified(), GateState::kDiffers);
    EXPECT_EQ(gate.Finding(kSlave).object.index, 0x1301U);
    EXPECT_EQ(gate.Finding(kSlave).object.sub, 2U);
    EXPECT_EQ(gate.Finding(kSlave).expected, 50U);
    EXPECT_EQ(gate.Finding(kSlave).read, 60U);
}

TEST_F(SafetyGateTest, AChangeWhileItReadsIsFound)
{
    Verifies(req::SRS_SFS_002);
    // Given that 1301h was read already
    gate.Verify(kSlave, Instant{now_us});
    Pass(20U);
    ASSERT_EQ(gate.State(kSlave), GateState::kBusy);
    // When somebody changes it behind the gate's back
    ASSERT_EQ(Store(0x1301U, 3U, 30U, 1U), AbortCode::kNone);
    Finish();
    // Then the last look at 13FEh finds it
    EXPECT_EQ(gate.State(kSlave), GateState::kDiffers);
    EXPECT_EQ(gate.Finding(kSlave).object.index, 0x13FEU);
}

TEST_F(SafetyGateTest, AnotherGfcWhileItReadsIsFound)
{
    Verifies(req::SRS_SFS_220);
    // Given that 1300h was read already
    gate.Verify(kSlave, Instant{now_us});
    Pass(20U);
    ASSERT_EQ(gate.State(kSlave), GateState::kBusy);
    // When somebody changes it, which leaves 13FEh as it is
    const std::uint32_t before = Has(0x1300U, 0U);
    ASSERT_EQ(Store(0x1300U, 0U, 1U - before, 1U), AbortCode::kNone);
    ASSERT_EQ(Has(0x13FEU, 0U), 0xA5U);
    Finish();
    // Then the second look at it finds it
    EXPECT_EQ(gate.State(kSlave), GateState::kDiffers);
    EXPECT_EQ(gate.Finding(kSlave).object.index, 0x1300U);
    EXPECT_EQ(gate.Finding(kSlave).read, 1U - before);
}

TEST_F(SafetyGateTest, AForeignWriteBeginsTheReadingAnew)
{
    Verifies(req::SRS_SFS_011);
    gate.Verify(kSlave, Instant{now_us});
    Pass(20U);
    const std::size_t before = read.size();
    EXPECT_TRUE(gate.OnWritten(kSlave, ObjectAddress{0x1303U, 2U}));
    EXPECT_FALSE(gate.OnWritten(NodeId{3U}, ObjectAddress{0x1303U, 2U})); // No safety slave.
    Finish();
    EXPECT_EQ(gate.State(kSlave), GateState::kOpen);
    // All is asked for from the beginning: 36 objects behind those before, and the one that was under way
    EXPECT_GE(read.size(), before + 36U);
}

TEST_F(SafetyGateTest, AValueOfAnotherLengthDiffers)
{
    Verifies(req::SRS_SFS_003);
    Verifies(req::SRS_SFS_004);
    // Given a slave whose 1301h:02 has four bytes with the same number
    on_answer = [](CanFrame& frame)
    {
        const bool is_it = (frame.data[1] == 0x01U) && (frame.data[2] == 0x13U) && (frame.data[3] == 2U);
        frame.data[0] = is_it ? std::uint8_t{0x43U} : frame.data[0];
        return true;
    };
    EXPECT_EQ(Verified(), GateState::kDiffers);
    EXPECT_EQ(gate.Finding(kSlave).object.sub, 2U);
    EXPECT_EQ(gate.Finding(kSlave).read, 50U);
    EXPECT_EQ(gate.Finding(kSlave).abort, SdoAbort::kLengthMismatch);
}

TEST_F(SafetyGateTest, AnAbortIsADifference)
{
    Verifies(req::SRS_SFS_003);
    Verifies(req::SRS_SFS_004);
    // Given a slave without SRDO 2, which is expected
    std::vector<ExpectedObject> list = Configuration();
    const auto place = std::find_if(list.begin(), list.end(),
                                    [](const ExpectedObject& object) { return object.address.index == 0x1303U; });
    std::vector<ExpectedObject> second{};
    for (std::uint8_t sub = 1U; sub <= 6U; ++sub)
    {
        second.push_back({{0x1302U, sub}, 0U, false});
    }
    list.insert(place, second.begin(), second.end());
    const auto mapping = std::find_if(list.begin(), list.end(),
                                      [](const ExpectedObject& object) { return object.address.index == 0x1383U; });
    list.insert(mapping, ExpectedObject{{0x1382U, 0U}, 0U, false});
    const auto signature = std::find_if(list.begin(), list.end(), [](const ExpectedObject& object)
                                        { return (object.address.index == 0x13FFU) && (object.address.sub == 3U); });
    list.insert(signature, ExpectedObject{{0x13FFU, 2U}, 0U, false});
    Expect(list);
    EXPECT_EQ(Verified(), GateState::kFailed);
    EXPECT_EQ(gate.Finding(kSlave).object.index, 0x1302U);
    EXPECT_EQ(gate.Finding(kSlave).abort, SdoAbort::kObjectUnknown);
}

TEST_F(SafetyGateTest, OneLostAnswerIsAskedForAgainThreeAreSilence)
{
    Verifies(req::SRS_SFS_003);
    Verifies(req::SRS_SFS_004);
    int lost = 0;
    int to_lose = 2;
    on_answer = [&](CanFrame& frame)
    {
        const bool is_it = (frame.data[1] == 0x03U) && (frame.data[2] == 0x13U) && (frame.data[3] == 5U);
        const bool is_lost = is_it && (lost < to_lose);
        lost += is_lost ? 1 : 0;
        return !is_lost;
    };
    EXPECT_EQ(Verified(), GateState::kOpen);
    EXPECT_EQ(lost, 2);
    lost = 0;
    to_lose = 3;
    EXPECT_EQ(Verified(), GateState::kFailed);
    EXPECT_EQ(gate.Finding(kSlave).object.index, 0x1303U);
    EXPECT_EQ(gate.Finding(kSlave).object.sub, 5U);
    EXPECT_EQ(gate.Finding(kSlave).abort, SdoAbort::kTimeOut);
}

TEST_F(SafetyGateTest, ALateAnswerCountsForNothing)
{
    Verifies(req::SRS_SFS_004);
    // Given a slave with another SCT whose answers to that question come 150 ms late, after the next try began
    std::vector<CanFrame> late{};
    int seen = 0;
    on_answer = [&](CanFrame& frame)
    {
        const bool is_it = (frame.data[1] == 0x01U) && (frame.data[2] == 0x13U) && (frame.data[3] == 2U);
        seen += is_it ? 1 : 0;
        if (is_it && (seen == 1))
        {
            late.push_back(frame);
        }
        return !is_it || (seen != 1);
    };
    bool has_given_up = false;
    on_request = [&](CanFrame& frame)
    {
        has_given_up = has_given_up || (frame.data[0] == 0x80U);
        return true;
    };
    gate.Verify(kSlave, Instant{now_us});
    while (!has_given_up)
    {
        Pass(1U);
    }
    // When the late answer comes, with another value than the present one
    ASSERT_EQ(late.size(), 1U);
    late[0].data[4] = 0x77U;
    pool.OnFrame(late[0], Instant{now_us});
    Finish();
    EXPECT_EQ(gate.State(kSlave), GateState::kOpen);
}

TEST_F(SafetyGateTest, WhatWasVerifiedEndsWithTheSlavesRestart)
{
    Verifies(req::SRS_SFS_002);
    ASSERT_EQ(Verified(), GateState::kOpen);
    // When the slave boots up, is reset or lost, its owner closes the gate
    gate.Close(kSlave);
    EXPECT_EQ(gate.State(kSlave), GateState::kClosed);
    EXPECT_FALSE(gate.MayStart(kSlave));
    // And in the middle of a verification as well: nothing of it counts
    gate.Verify(kSlave, Instant{now_us});
    Pass(10U);
    gate.Close(kSlave);
    Pass(200U);
    EXPECT_EQ(gate.State(kSlave), GateState::kClosed);
    // Then only a whole new verification opens it
    EXPECT_EQ(Verified(), GateState::kOpen);
}

TEST_F(SafetyGateTest, DamagedMemoryGrantsNothing)
{
    Verifies(req::SRS_SFS_154);
    ASSERT_EQ(Verified(), GateState::kOpen);
    for (std::uint32_t bit = 0U; bit < 32U; ++bit)
    {
        slots[0].permit ^= (1U << bit);
        EXPECT_FALSE(gate.MayStart(kSlave));
        slots[0].permit ^= (1U << bit);
    }
    slots[0].permit = 0U;
    EXPECT_FALSE(gate.MayStart(kSlave));
    slots[0].permit = 0xFFFFFFFFU;
    EXPECT_FALSE(gate.MayStart(kSlave));
    // A whole record of zeros, and one of which the node-ID or the check is another
    ASSERT_EQ(Verified(), GateState::kOpen);
    const SafetySlot whole = slots[0];
    slots[0] = SafetySlot{};
    EXPECT_FALSE(gate.MayStart(kSlave));
    for (std::uint32_t bit = 0U; bit < 8U; ++bit)
    {
        slots[0] = whole;
        slots[0].node.value = static_cast<std::uint8_t>(slots[0].node.value ^ (1U << bit));
        EXPECT_FALSE(gate.MayStart(kSlave)) << bit;
    }
    slots[0] = whole;
    slots[0].check = SafetyCheck{};
    EXPECT_FALSE(gate.MayStart(kSlave));
    slots[0] = whole;
    slots[0].is_doubted = true;
    EXPECT_FALSE(gate.MayStart(kSlave));
    slots[0] = whole;
    EXPECT_TRUE(gate.MayStart(kSlave));
}

TEST_F(SafetyGateTest, OthersMayAlwaysStartASlaveWithoutRoomNever)
{
    Verifies(req::SRS_SFS_002);
    EXPECT_TRUE(gate.MayStart(NodeId{3U}));
    slaves[3].assignment = kInNetwork;
    EXPECT_TRUE(gate.MayStart(NodeId{3U}));
    slaves[3].safety = &expectation; // After the gate was made: there is no slot for it.
    EXPECT_FALSE(gate.MayStart(NodeId{3U}));
    gate.Verify(NodeId{3U}, Instant{now_us});
    EXPECT_EQ(gate.State(NodeId{3U}), GateState::kFailed);
    EXPECT_EQ(gate.Finding(NodeId{3U}).abort, SdoAbort::kOutOfMemory);
}

TEST_F(SafetyGateTest, AnOperationalSlaveIsReadAsWell)
{
    Verifies(req::SRS_SFS_006);
    Command(1U);
    Cycles(2U);
    ASSERT_EQ(device.State(), cia301::NodeState::kOperational);
    EXPECT_EQ(Verified(), GateState::kOpen);
}

class SafetyWriteTest : public GateRig
{
  protected:
    void SetUp() override
    {
        Start();
        Cycle();
        Expect(Configuration());
    }
    GateState Written()
    {
        EXPECT_TRUE(gate.Write(kSlave, Instant{now_us}));
        Finish();
        return gate.State(kSlave);
    }
    /// Another configuration with its right signature, while the expectation is kept.
    void Disarrange()
    {
        ASSERT_EQ(Download(0x1301U, 1U, 0U, 1U), 0U);
        ASSERT_EQ(Download(0x1301U, 2U, 77U, 2U), 0U);
        ASSERT_EQ(Download(0x1301U, 5U, 0x121U, 4U), 0U);
        ASSERT_EQ(Download(0x1301U, 6U, 0x122U, 4U), 0U);
        ASSERT_EQ(Download(0x1381U, 0U, 0U, 1U), 0U);
        ASSERT_EQ(Download(0x13FFU, 1U, 0x1234U, 2U), 0U);
        ASSERT_EQ(Has(0x13FEU, 0U), 0U);
    }
};

TEST_F(SafetyWriteTest, WritesReadsBackAndDeclaresValid)
{
    Verifies(req::SRS_SFS_005);
    Disarrange();
    std::vector<std::uint8_t> flags{};
    on_request = [&flags](CanFrame& frame)
    {
        const bool is_flag = (frame.data[0] != 0x40U) && (frame.data[1] == 0xFEU) && (frame.data[2] == 0x13U);
        flags.insert(flags.end(), is_flag ? 1U : 0U, frame.data[4]);
        return true;
    };
    EXPECT_EQ(Written(), GateState::kOpen);
    EXPECT_EQ(flags, (std::vector<std::uint8_t>{0U, 0xA5U}));
    // Then the device has it all
    EXPECT_EQ(Has(0x13FEU, 0U), 0xA5U);
    EXPECT_EQ(Has(0x1301U, 1U), 2U);
    EXPECT_EQ(Has(0x1301U, 2U), 50U);
    EXPECT_EQ(Has(0x1301U, 5U), 0x101U);
    EXPECT_EQ(Has(0x1301U, 6U), 0x102U);
    EXPECT_EQ(Has(0x1381U, 0U), 2U);
    EXPECT_EQ(Has(0x1381U, 1U), 0x22000110U);
    EXPECT_EQ(Has(0x13FFU, 1U), core.Sign(CommunicationIndex{0x1301U}).signature);
    // And the order was: not valid, off, settings, mappings, on, signatures; valid only at the end
    ASSERT_GT(written.size(), 4U);
    EXPECT_EQ(written.front().index, 0x13FEU);
    EXPECT_EQ(written[1].index, 0x1301U);
    EXPECT_EQ(written[1].sub, 1U); // Sub-index 0 is never written.
    EXPECT_EQ(written[2].index, 0x1303U);
    EXPECT_EQ(written[3].index, 0x1304U);
    EXPECT_EQ(written.back().index, 0x13FEU);
    EXPECT_EQ(written[written.size() - 2U].index, 0x13FFU);
    // And everything was read back, 1300h and 13FEh at the end
    EXPECT_EQ(read.size(), expected.size() + 2U);
}

TEST_F(SafetyWriteTest, WhatTheSlaveRefusesEndsIt)
{
    Verifies(req::SRS_SFS_211);
    // Given an expectation with an identifier that no SRDO may have
    for (ExpectedObject& object : expected)
    {
        object.value = ((object.address.index == 0x1303U) && (object.address.sub == 5U)) ? 0x203U : object.value;
    }
    EXPECT_EQ(Written(), GateState::kFailed);
    EXPECT_EQ(gate.Finding(kSlave).object.index, 0x1303U);
    EXPECT_EQ(gate.Finding(kSlave).object.sub, 5U);
    EXPECT_EQ(gate.Finding(kSlave).abort, SdoAbort::kValueRange);
    EXPECT_EQ(Has(0x13FEU, 0U), 0U);
    EXPECT_FALSE(gate.MayStart(kSlave));
}

TEST_F(SafetyWriteTest, WhatDoesNotReadBackIsNotDeclaredValid)
{
    Verifies(req::SRS_SFS_211);
    // Given a slave that takes 1303h:02 and keeps something else
    on_answer = [](CanFrame& frame)
    {
        const bool is_it = (frame.data[0] == 0x4BU) && (frame.data[1] == 0x03U) && (frame.data[3] == 2U);
        frame.data[4] = is_it ? std::uint8_t{9U} : frame.data[4];
        return true;
    };
    EXPECT_EQ(Written(), GateState::kDiffers);
    EXPECT_EQ(gate.Finding(kSlave).object.index, 0x1303U);
    EXPECT_EQ(gate.Finding(kSlave).read, 9U);
    EXPECT_EQ(Has(0x13FEU, 0U), 0U);
}

TEST_F(SafetyWriteTest, AWrongSignatureIsRefusedByTheSlave)
{
    Verifies(req::SRS_SFS_211);
    for (ExpectedObject& object : expected)
    {
        const bool is_it = (object.address.index == 0x13FFU) && (object.address.sub == 3U);
        object.value = is_it ? (object.value ^ 1U) : object.value;
    }
    EXPECT_EQ(Written(), GateState::kFailed);
    EXPECT_EQ(gate.Finding(kSlave).object.index, 0x13FEU);
    EXPECT_EQ(gate.Finding(kSlave).abort, SdoAbort::kIncompatible);
    EXPECT_EQ(Has(0x13FEU, 0U), 0U);
}

TEST_F(SafetyWriteTest, AnOperationalSlaveTakesNothing)
{
    Verifies(req::SRS_SFS_212);
    Command(1U);
    Cycles(2U);
    EXPECT_EQ(Written(), GateState::kFailed);
    EXPECT_EQ(gate.Finding(kSlave).object.index, 0x13FEU);
    EXPECT_EQ(gate.Finding(kSlave).abort, SdoAbort::kDeviceState);
    EXPECT_EQ(Has(0x13FEU, 0U), 0xA5U);
}

TEST_F(SafetyWriteTest, AnswersToItsOwnWritesAreNoForeignOnes)
{
    Verifies(req::SRS_SFS_221);
    int own = 0;
    on_answer = [this, &own](CanFrame& frame)
    {
        const auto index = static_cast<std::uint16_t>(frame.data[1] | (frame.data[2] << 8U));
        const bool is_write = (frame.data[0] == 0x60U);
        own += is_write ? 1 : 0;
        EXPECT_FALSE(is_write && gate.OnWritten(kSlave, ObjectAddress{index, frame.data[3]}));
        return true;
    };
    EXPECT_EQ(Written(), GateState::kOpen);
    EXPECT_GT(own, 20);
    // When it is open, no write is its own any more
    EXPECT_TRUE(gate.OnWritten(kSlave, ObjectAddress{0x13FEU, 0U}));
}

TEST_F(SafetyWriteTest, AForeignWriteWhileItReadsBackBeginsItAnew)
{
    Verifies(req::SRS_SFS_011);
    // Given that everything was written and reading back has begun
    ASSERT_TRUE(gate.Write(kSlave, Instant{now_us}));
    for (int i = 0; (i < 200) && read.empty(); ++i)
    {
        Pass(1U);
    }
    const std::size_t before = written.size();
    EXPECT_TRUE(gate.OnWritten(kSlave, ObjectAddress{0x1301U, 2U}));
    Finish();
    EXPECT_EQ(gate.State(kSlave), GateState::kOpen);
    // All of it again behind the abort of what was being read, and 13FEh := A5h once, at the end
    EXPECT_EQ(written.size(), before + 1U + before + 1U);
}

// What it wrote last is no exception: behind the reading of it nobody would look again.
TEST_F(SafetyWriteTest, AForeignWriteOfWhatWasWrittenLastBeginsItAnew)
{
    Verifies(req::SRS_SFS_121);
    for (const ObjectAddress& last : {ObjectAddress{0x13FFU, 3U}, ObjectAddress{0x13FEU, 0U}})
    {
        // Given that it has read this object back, and the answer to a write of it by somebody else comes directly
        // behind
        int heard = 0;
        on_answer = [this, &heard, &last](CanFrame& frame)
        {
            const auto index = static_cast<std::uint16_t>(frame.data[1] | (frame.data[2] << 8U));
            const bool is_upload = ((frame.data[0] & 0xE0U) == 0x40U);
            if (is_upload && (heard == 0) && (index == last.index) && (frame.data[3] == last.sub))
            {
                ++heard;
                EXPECT_TRUE(gate.OnWritten(kSlave, last)) << std::hex << last.index;
            }
            return true;
        };
        written.clear();
        // Then all of it is written again: 13FEh is cleared twice and set once or twice; one is the abort of its
        // reading
        EXPECT_EQ(Written(), GateState::kOpen);
        EXPECT_EQ(heard, 1);
        const auto is_flag = [](const ObjectAddress& each) { return each.index == 0x13FEU; };
        EXPECT_EQ(std::count_if(written.begin(), written.end(), is_flag), (last.index == 0x13FEU) ? 5 : 3);
    }
}

TEST_F(SafetyWriteTest, WhileItDeclaresValidAnAnswerToThatAloneIsItsOwn)
{
    Verifies(req::SRS_SFS_011);
    Verifies(req::SRS_SFS_221);
    Verifies(req::SRS_SFS_121);
    for (const ObjectAddress& other : {ObjectAddress{0x13FEU, 1U}, ObjectAddress{0x13FFU, 3U}})
    {
        // Given the answer to 13FEh := A5h, and behind it one to a write of something else
        int heard = 0;
        on_answer = [this, &heard, &other](CanFrame& frame)
        {
            const bool is_flag = (frame.data[0] == 0x60U) && (frame.data[1] == 0xFEU) && (frame.data[2] == 0x13U);
            if (is_flag && (heard == 0) && (Has(0x13FEU, 0U) == 0xA5U))
            {
                ++heard;
                EXPECT_FALSE(gate.OnWritten(kSlave, ObjectAddress{0x13FEU, 0U}));
                EXPECT_TRUE(gate.OnWritten(kSlave, other)) << std::hex << other.index;
            }
            return true;
        };
        // Then all of it is written again
        EXPECT_EQ(Written(), GateState::kOpen);
        EXPECT_EQ(heard, 1);
    }
}

TEST_F(SafetyWriteTest, FixedObjectsAreComparedNotWritten)
{
    Verifies(req::SRS_SFS_210);
    for (ExpectedObject& object : expected)
    {
        object.is_fixed = object.is_fixed || (object.address.index == 0x1383U);
    }
    EXPECT_EQ(Written(), GateState::kOpen);
    for (const ObjectAddress& address : written)
    {
        EXPECT_NE(address.index, 0x1383U);
    }
}

TEST_F(SafetyWriteTest, WhatIsNoExpectationOpensNothing)
{
    Verifies(req::SRS_SFS_007);
    const std::vector<ExpectedObject> whole = Configuration();
    EXPECT_TRUE(IsUsable(expectation));
    // Given an expectation without one of its parts (1300h, 1301h:00 and the count of signatures are none)
    for (std::size_t left_out = 0U; left_out < whole.size(); ++left_out)
    {
        std::vector<ExpectedObject> list = whole;
        list.erase(list.begin() + static_cast<std::ptrdiff_t>(left_out));
        Expect(list);
        const ObjectAddress address = whole[left_out].address;
        const bool is_highest_sub = (address.sub == 0U) && ((address.index < 0x1381U) || (address.index == 0x13FFU));
        const bool is_optional = (address.index == 0x1300U) || is_highest_sub;
        EXPECT_EQ(IsUsable(expectation), is_optional) << std::hex << address.index << ":" << int{address.sub};
    }
    // Or with a duplicate, an object that is none, a value that is too long
    Expect(whole);
    expected.insert(expected.begin() + 3, expected[3]);
    EXPECT_FALSE(IsUsable(SafetyExpectation{expected.data(), static_cast<std::uint16_t>(expected.size())}));
    Expect(whole);
    expected[1].address = ObjectAddress{0x1301U, 7U};
    EXPECT_FALSE(IsUsable(expectation));
    Expect(whole);
    expected[1].value = 0x100U;
    EXPECT_FALSE(IsUsable(expectation));
    EXPECT_FALSE(IsUsable(SafetyExpectation{nullptr, 1U}));
    EXPECT_FALSE(IsUsable(SafetyExpectation{whole.data(), 0U}));
    // An entry above the count of its mapping is one where it is fixed
    Expect(whole);
    const auto above = std::find_if(expected.begin(), expected.end(),
                                    [](const ExpectedObject& object) { return object.address.index == 0x1383U; });
    expected.insert(above, ExpectedObject{{0x1381U, 9U}, 0U, false});
    EXPECT_FALSE(IsUsable(SafetyExpectation{expected.data(), static_cast<std::uint16_t>(expected.size())}));
    const auto it = std::find_if(expected.begin(), expected.end(),
                                 [](const ExpectedObject& object) { return object.address.sub == 9U; });
    it->is_fixed = true;
    EXPECT_TRUE(IsUsable(SafetyExpectation{expected.data(), static_cast<std::uint16_t>(expected.size())}));
    // When what is none is used nevertheless, nothing is asked and nothing opens
    Expect({});
    gate.Verify(kSlave, Instant{now_us});
    EXPECT_EQ(gate.State(kSlave), GateState::kFailed);
    EXPECT_EQ(gate.Finding(kSlave).object.index, 0U);
    Pass(50U);
    EXPECT_TRUE(read.empty());
}

} // namespace
} // namespace counterpoint::cia302
