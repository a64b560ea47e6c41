// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/sdo/server_port.hpp"
#include "tests/canopen/cia301/sdo_client_rig.hpp"
#include "verification/trace/ids/cia301.hpp"

namespace counterpoint::cia301
{
namespace
{

class SdoServerPortTest : public SdoClientRig
{
  public:
    void Ask(const Octets& bytes, NodeState state = NodeState::kPreOperational)
    {
        CanFrame frame{0x605U, FrameKind::kData, CanPortId::kFirst, 8U, {}};
        std::copy(bytes.begin(), bytes.end(), frame.data);
        port.OnFrame(frame, {state, Instant{now_us}});
    }
    std::uint32_t Value(std::uint16_t index, std::uint8_t sub)
    {
        std::uint8_t bytes[4] = {};
        const Reading reading = port.OnRead({index, sub}, {bytes, 4U});
        abort = reading.abort;
        return bytes[0] | (static_cast<std::uint32_t>(bytes[1]) << 8U);
    }

    SdoAbort abort{SdoAbort::kNone};
};

TEST_F(SdoServerPortTest, TheServersObjectShowsItsIdentifiers)
{
    Verifies(req::SRS_SDO_016);
    EXPECT_EQ(Value(0x1200U, 0U), 2U);
    EXPECT_EQ(Value(0x1200U, 1U), 0x605U);
    EXPECT_EQ(Value(0x1200U, 2U), 0x585U);
    static_cast<void>(Value(0x1200U, 3U));
    EXPECT_EQ(abort, SdoAbort::kSubUnknown);
    static_cast<void>(Value(0x1201U, 0U));
    EXPECT_EQ(abort, SdoAbort::kObjectUnknown);
    const std::uint8_t value[4] = {};
    EXPECT_EQ(port.OnWrite({0x1200U, 1U}, {value, 4U}), SdoAbort::kReadOnly);
    port.ResetCommunication(NodeId{6U});
    EXPECT_EQ(Value(0x1200U, 1U), 0x606U);
    Ask({0x40U, 0x05U, 0x21U});
    EXPECT_TRUE(answers.frames.empty()); // 605h is another's now
}

TEST_F(SdoServerPortTest, AnOpenTransferEndsWithTheState)
{
    Verifies(req::SRS_SDO_014);
    Verifies(req::SRS_SDO_016);
    domain_length = 20U;
    Ask({0x40U, 0x03U, 0x21U});
    EXPECT_EQ(answers.Next()[0], 0x41U);
    port.OnCycle({NodeState::kStopped, Instant{now_us}});
    EXPECT_EQ(answers.Next(), AbortOf(0x2103U, 0U, 0x08000022U));
    port.OnCycle({NodeState::kStopped, Instant{now_us}});
    EXPECT_TRUE(answers.frames.empty());
    Ask({0x40U, 0x05U, 0x21U}, NodeState::kStopped);
    EXPECT_TRUE(answers.frames.empty());
}

TEST_F(SdoServerPortTest, WhatTheSinkDoesNotTakeIsSentLaterInOrder)
{
    Verifies(req::SRS_SDO_016);
    domain_length = 20U;
    answers.room = 0;
    Ask({0xA0U, 0x03U, 0x21U, 0U, 127U});
    EXPECT_TRUE(answers.frames.empty());
    answers.room = 1;
    port.OnCycle(Now());
    EXPECT_EQ(answers.Next()[0], 0xC6U);
    Ask({0xA3U});
    for (const std::uint8_t number : Octets{0x01U, 0x02U, 0x83U})
    {
        EXPECT_TRUE(answers.frames.empty());
        answers.room = 1;
        port.OnCycle(Now());
        EXPECT_EQ(answers.Next()[0], number);
    }
}

} // namespace
} // namespace counterpoint::cia301
