// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/safety_core/kernel/rig.hpp"

namespace counterpoint
{
namespace
{

class Facade : public Rig
{
};

// 02h 32 00 14 01 01 00 00 02 01 00 00 02 01 10 01 00 22 02 10 01 00 23
TEST_F(Facade, SignatureIsThatOfBothChannels)
{
    Verifies(req::SRS_KRN_015);
    Verifies(req::SRS_CFG_010);
    Configure();
    const SignReply reply = kernel.Sign(CommunicationIndex{0x1301U});
    EXPECT_EQ(reply.result, Result::kSuccessful);
    EXPECT_EQ(reply.signature, Read(0x13FFU, 1U));
    EXPECT_EQ(kernel.Sign(CommunicationIndex{0x1302U}).result, Result::kNotExist);
}

TEST_F(Facade, SignaturesThatDifferAreADisagreement)
{
    Verifies(req::SRS_KRN_015);
    Configure();
    b.signature_flip = 2U;
    EXPECT_EQ(kernel.Sign(CommunicationIndex{0x1301U}).result, Result::kDeviceFault);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
    EXPECT_EQ(kernel.DeviceState().slot, 0U);
}

TEST_F(Facade, StateOfEachSrdo)
{
    Verifies(req::SRS_KRN_015);
    Operate();
    EXPECT_EQ(kernel.GetState(CommunicationIndex{0x1302U}).result, Result::kNotExist);
    EXPECT_EQ(kernel.GetState(CommunicationIndex{0x1301U}).state, SrdoState::kWaiting);
    EXPECT_EQ(kernel.GetState(CommunicationIndex{0x1303U}).state, SrdoState::kProducer);
    EXPECT_EQ(kernel.GetState(CommunicationIndex{0x1304U}).state, SrdoState::kOff);
    ReceivePair();
    Cycle();
    const StateReply reply = kernel.GetState(CommunicationIndex{0x1301U});
    EXPECT_EQ(reply.result, Result::kSuccessful);
    EXPECT_EQ(reply.state, SrdoState::kReleased);
    EXPECT_EQ(reply.first_cause, SrdoCause::kNone);
    EXPECT_EQ(reply.error_count, 0U);
}

TEST_F(Facade, StateThatTheChannelsDoNotShareIsFaulted)
{
    Verifies(req::SRS_KRN_015);
    Operate();
    ReceivePair();
    Cycle();
    real_b.Demote(0U);
    EXPECT_EQ(kernel.GetState(CommunicationIndex{0x1301U}).state, SrdoState::kFaulted);
}

} // namespace
} // namespace counterpoint
