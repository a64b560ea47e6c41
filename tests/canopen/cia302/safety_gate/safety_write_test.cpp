// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The full procedure that writes a safety configuration, into a real kernel device; and expectations that are none.
#include "tests/canopen/cia302/safety_gate/rig.hpp"
#include "verification/trace/ids/manager.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr NodeId kSlave{2U};

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
    EXPECT_EQ(written[1].sub, 1U);
    EXPECT_EQ(written[2].index, 0x1303U);
    EXPECT_EQ(written[3].index, 0x1304U);
    EXPECT_EQ(written.back().index, 0x13FEU);
    EXPECT_EQ(written[written.size() - 2U].index, 0x13FFU);
    // And everything was read back
    EXPECT_EQ(read.size(), expected.size() + 1U);
}

TEST_F(SafetyWriteTest, WhatTheSlaveRefusesEndsIt)
{
    Verifies(req::SRS_SFS_005);
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
    Verifies(req::SRS_SFS_005);
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
    Verifies(req::SRS_SFS_005);
    for (ExpectedObject& object : expected)
    {
        const bool is_it = (object.address.index == 0x13FFU) && (object.address.sub == 3U);
        object.value = is_it ? (object.value ^ 1U) : object.value;
    }
    EXPECT_EQ(Written(), GateState::kFailed);
    EXPECT_EQ(gate.Finding(kSlave).object.index, 0x13FEU);
    EXPECT_EQ(gate.Finding(kSlave).abort, SdoAbort::kIncompatible);
}

TEST_F(SafetyWriteTest, AnOperationalSlaveTakesNothing)
{
    Verifies(req::SRS_SFS_005);
    Command(1U);
    Cycles(2U);
    EXPECT_EQ(Written(), GateState::kFailed);
    EXPECT_EQ(gate.Finding(kSlave).object.index, 0x13FEU);
    EXPECT_EQ(gate.Finding(kSlave).abort, SdoAbort::kDeviceState);
    EXPECT_EQ(Has(0x13FEU, 0U), 0xA5U);
}

TEST_F(SafetyWriteTest, FixedObjectsAreComparedNotWritten)
{
    Verifies(req::SRS_SFS_005);
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
    // Given an expectation without one of its parts (1300h and the count of signatures are none)
    for (std::size_t left_out = 0U; left_out < whole.size(); ++left_out)
    {
        std::vector<ExpectedObject> list = whole;
        list.erase(list.begin() + static_cast<std::ptrdiff_t>(left_out));
        Expect(list);
        const ObjectAddress address = whole[left_out].address;
        const bool is_optional = (address.index == 0x1300U) || ((address.index == 0x13FFU) && (address.sub == 0U));
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
    // When it is used nevertheless, nothing is asked and nothing opens
    Expect({});
    gate.Verify(kSlave, Instant{now_us});
    EXPECT_EQ(gate.State(kSlave), GateState::kFailed);
    EXPECT_EQ(gate.Finding(kSlave).object.index, 0U);
    Pass(50U);
    EXPECT_TRUE(read.empty());
}

} // namespace
} // namespace counterpoint::cia302
