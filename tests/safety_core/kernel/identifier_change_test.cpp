// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// A COB-ID, or 1300h, is stored while a frame of before is still on its way.
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"

#include <cstdint>
#include <initializer_list>
#include <vector>

namespace counterpoint
{
namespace
{

/// Whether a cycle sees that OPERATIONAL was left before it is entered again.
enum class Between : std::uint8_t
{
    kNothing = 1U,
    kCycle = 2U,
};

class IdentifierChange : public Rig
{
  public:
    void ExpectWritten(const std::uint16_t index, const std::uint8_t sub, const std::uint32_t value,
                       const std::uint8_t size)
    {
        ASSERT_EQ(Write(index, sub, value, size), AbortCode::kNone);
    }

    /// Leaves OPERATIONAL, gives an SRDO other identifiers and enters it again.
    void ChangeIdentifiers(const std::uint8_t number, const std::uint32_t normal, const Between between)
    {
        const std::uint16_t index = static_cast<std::uint16_t>(0x1300U + number);
        kernel.SetNmtState(NmtState::kPreOperational);
        if (between == Between::kCycle)
        {
            Cycle();
        }
        const std::uint32_t direction = Read(index, 1U);
        ExpectWritten(index, 1U, 0U, 1U);
        ExpectWritten(index, 5U, normal, 4U);
        ExpectWritten(index, 6U, normal + 1U, 4U);
        ExpectWritten(index, 1U, direction, 1U);
        const SignReply reply = kernel.Sign(CommunicationIndex{index});
        ASSERT_EQ(reply.result, Result::kSuccessful);
        ExpectWritten(0x13FFU, number, reply.signature, 2U);
        ExpectWritten(0x13FEU, 0U, 0xA5U, 1U);
        kernel.SetNmtState(NmtState::kOperational);
    }

    void Confirm(CanFrame frame, const std::uint32_t identifier)
    {
        frame.identifier = identifier;
        now_us += 10U;
        kernel.OnConfirm(StampedFrame{frame, InstantPair{{now_us}, {now_us}}});
    }
};

// t      103h handed over    OPERATIONAL left, 107h/108h stored, entered again    103h confirmed
TEST_F(IdentifierChange, NormalFrameInFlightIsFollowedByNothing)
{
    Verifies(req::SRS_KRN_036);
    for (const Between between : {Between::kNothing, Between::kCycle})
    {
        ports.sent.clear();
        application.events.clear();
        application.errors.clear();
        Operate();
        Cycle();
        ASSERT_EQ(ports.sent.size(), 1U);
        const CanFrame old = ports.sent[0];
        ASSERT_EQ(old.identifier, 0x103U);
        ChangeIdentifiers(3U, 0x107U, between);
        Confirm(old, 0x103U);
        Confirm(old, 0x107U);
        Confirm(old, 0x104U);
        EXPECT_EQ(ports.sent.size(), 1U);
        Cycle();
        Confirm(old, 0x103U);
        EXPECT_EQ(ports.sent.size(), 1U);
        EXPECT_TRUE(application.events.empty());
        EXPECT_TRUE(CausesOf(0x1303U).empty());
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);

        // The next pair has the new identifiers alone
        Cycles(2U);
        ASSERT_EQ(ports.sent.size(), 2U);
        EXPECT_EQ(ports.sent[1].identifier, 0x107U);
        Confirm(old, 0x103U);
        EXPECT_EQ(ports.sent.size(), 2U);
        Confirm(ports.sent[1], 0x107U);
        ASSERT_EQ(ports.sent.size(), 3U);
        EXPECT_EQ(ports.sent[2].identifier, 0x108U);
        Confirm(ports.sent[2], 0x104U);
        EXPECT_TRUE(application.events.empty());
        Confirm(ports.sent[2], 0x108U);
        EXPECT_EQ(application.events, std::vector<std::uint16_t>{0x1303U});
        EXPECT_TRUE(CausesOf(0x1303U).empty());
    }
}

TEST_F(IdentifierChange, InverseFrameInFlightEndsNoPair)
{
    Verifies(req::SRS_KRN_036);
    for (const Between between : {Between::kNothing, Between::kCycle})
    {
        ports.sent.clear();
        application.events.clear();
        Operate();
        Cycle();
        ConfirmLast();
        ASSERT_EQ(ports.sent.size(), 2U);
        const CanFrame old = ports.sent[1];
        ChangeIdentifiers(3U, 0x107U, between);
        Confirm(old, 0x104U);
        Confirm(old, 0x108U);
        Cycle();
        Confirm(old, 0x104U);
        EXPECT_TRUE(application.events.empty());
        EXPECT_TRUE(CausesOf(0x1303U).empty());
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    }
}

// t      101h received    OPERATIONAL left, 105h/106h stored, entered again    102h or 106h received
TEST_F(IdentifierChange, NormalFrameOfTheOldIdentifierMakesNoPair)
{
    Verifies(req::SRS_KRN_220);
    for (const Between between : {Between::kNothing, Between::kCycle})
    {
        for (const std::uint32_t identifier : {0x102U, 0x106U})
        {
            application.events.clear();
            Operate();
            Receive(0x101U, {0x12U, 0x34U}, 100U);
            ChangeIdentifiers(1U, 0x105U, between);
            Receive(identifier, {0xEDU, 0xCBU}, 100U);
            Cycles(2U);
            EXPECT_EQ(Open(), 0U);
            EXPECT_EQ(NormalOut(), 0x7F01U);
            EXPECT_TRUE(application.events.empty());
            EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);

            // A pair of the old identifiers is nobody's, one of the new ones is
            ReceivePair();
            Cycle();
            EXPECT_EQ(Open(), 0U);
            Receive(0x105U, {0x56U, 0x78U}, 100U);
            Receive(0x106U, {0xA9U, 0x87U}, 100U);
            Cycle();
            EXPECT_EQ(Open(), 1U);
            EXPECT_EQ(NormalOut(), 0x7856U);
        }
    }
}

// The inverse frame of the producer's old pair has by now become an identifier of another SRDO of this device.
TEST_F(IdentifierChange, IdentifierOfAFrameInFlightMayGoToAConsumer)
{
    Verifies(req::SRS_KRN_036);
    Operate();
    Cycle();
    const CanFrame old = ports.sent[0];
    ChangeIdentifiers(3U, 0x107U, Between::kNothing);
    ChangeIdentifiers(1U, 0x103U, Between::kNothing);
    Confirm(old, 0x103U);
    Cycles(2U);
    Receive(0x104U, {0xEDU, 0xCBU}, 100U);
    Cycle();
    EXPECT_EQ(Open(), 0U);
    EXPECT_EQ(CausesOf(0x1301U).back(), SrdoCause::kInverseFirst);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

// t      GFC handed over     1300h = 0     confirmed    25 ms after it
TEST_F(IdentifierChange, GfcInFlightHasToBeFollowedThoughItIsSwitchedOff)
{
    Verifies(req::SRS_KRN_221);
    setups[1].form = ProducerForm::kApplicationSends;
    Operate();
    ASSERT_EQ(kernel.SendGfc(), Result::kSuccessful);
    ASSERT_EQ(ports.sent.size(), 1U);
    ExpectWritten(0x1300U, 0U, 0U, 1U);
    ConfirmLast();
    EXPECT_EQ(kernel.SendGfc(), Result::kGfcUnsupported);
    Cycles(25U);
    EXPECT_EQ(application.gfcs_not_followed, 0);
    Cycles(25U);
    EXPECT_EQ(application.gfcs_not_followed, 1);
    EXPECT_EQ(application.gfcs, 0);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

// What counts is 1300h when the frame is given to the kernel.
TEST_F(IdentifierChange, ReceivedGfcCountsByWhatIsStoredWhenItComes)
{
    Verifies(req::SRS_KRN_221);
    Operate();
    ReceivePair();
    Cycle();
    ASSERT_EQ(Open(), 1U);
    ExpectWritten(0x1300U, 0U, 0U, 1U);
    Receive(0x001U, {}, 100U);
    ExpectWritten(0x1300U, 0U, 1U, 1U);
    Cycle();
    EXPECT_EQ(Open(), 1U);
    EXPECT_EQ(application.gfcs, 0);
    Receive(0x001U, {}, 100U);
    ExpectWritten(0x1300U, 0U, 0U, 1U);
    Cycle();
    EXPECT_EQ(Open(), 0U);
    EXPECT_EQ(application.gfcs, 1);
}

} // namespace
} // namespace counterpoint
