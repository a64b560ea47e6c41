// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// A further SDO server (1201h) and an SDO client of the dictionary (1281h) with a wire between them.
#include "canopen/cia301/sdo/client_port.hpp"
#include "canopen/cia301/sdo/server_port.hpp"
#include "tests/canopen/cia301/sdo_client_rig.hpp"
#include "verification/trace/ids/cia301.hpp"

namespace counterpoint::cia301
{
namespace
{

/// The server listens on 680h and answers on 6A0h.
class SdoSecondServerTest : public SdoClientRig
{
  public:
    static SdoAbort Write(NumberHook& hook, std::uint16_t index, std::uint8_t sub, std::uint32_t value)
    {
        const Octets bytes{static_cast<std::uint8_t>(value), static_cast<std::uint8_t>(value >> 8U),
                           static_cast<std::uint8_t>(value >> 16U), static_cast<std::uint8_t>(value >> 24U)};
        return hook.OnWrite({index, sub}, {bytes.data(), 4U});
    }
    /// Size in bits 32.., as read; the abort code apart.
    std::uint64_t Read(NumberHook& hook, std::uint16_t index, std::uint8_t sub)
    {
        std::uint8_t bytes[4] = {};
        const Reading reading = hook.OnRead({index, sub}, {bytes, 4U});
        abort = reading.abort;
        std::uint64_t value = reading.size_bytes;
        for (int place = 3; place >= 0; --place)
        {
            value = (value << 8U) | bytes[place];
        }
        return value;
    }
    void Connect()
    {
        EXPECT_EQ(Write(more, 0x1201U, 1U, 0x680U), SdoAbort::kNone);
        EXPECT_EQ(Write(more, 0x1201U, 2U, 0x6A0U), SdoAbort::kNone);
        EXPECT_EQ(Write(asks, 0x1281U, 1U, 0x680U), SdoAbort::kNone);
        EXPECT_EQ(Write(asks, 0x1281U, 2U, 0x6A0U), SdoAbort::kNone);
        EXPECT_EQ(Write(asks, 0x1281U, 3U, 5U), SdoAbort::kNone);
    }
    void CarryFurther(NodeState state = NodeState::kPreOperational)
    {
        const Moment moment{state, Instant{now_us}};
        for (int i = 0; i < 100; ++i)
        {
            asks.OnCycle(moment);
            more.OnCycle(moment);
            for (const CanFrame& frame : requests.frames)
            {
                more.OnFrame(frame, moment);
            }
            requests.frames.clear();
            for (const CanFrame& frame : answers.frames)
            {
                asks.OnFrame(frame, moment);
            }
            answers.frames.clear();
        }
    }
    bool Ask(std::uint16_t index)
    {
        return asks.Client().StartUpload({index, 0U}, Room{got.data(), 64U}, SdoMode::kNormal, Instant{now_us});
    }
    [[nodiscard]] SdoAbort Outcome()
    {
        return asks.Client().Outcome().abort;
    }

    SdoAbort abort{SdoAbort::kNone};
    SdoServerPort more{server, answers, SdoServerNumber{1U}};
    SdoClientPort asks{SdoClientPortParts{requests, 1U, 1000U, 5U}};
};

TEST_F(SdoSecondServerTest, TheServerIsOffUntilBothIdentifiersAreValid)
{
    Verifies(req::SRS_SDO_018);
    EXPECT_EQ(Read(more, 0x1201U, 0U), 0x100000003U);
    EXPECT_EQ(Read(more, 0x1201U, 1U), 0x480000000U);
    EXPECT_EQ(Read(more, 0x1201U, 2U), 0x480000000U);
    EXPECT_EQ(Read(more, 0x1201U, 3U), 0x100000000U);
    EXPECT_EQ(Write(more, 0x1201U, 1U, 0x680U), SdoAbort::kNone);
    EXPECT_FALSE(more.Wants(0x680U));
    EXPECT_EQ(Write(more, 0x1201U, 2U, 0x6A0U), SdoAbort::kNone);
    EXPECT_TRUE(more.Wants(0x680U));
    CanFrame frame{0x680U, FrameKind::kData, CanPortId::kFirst, 8U, {0x40U, 0x05U, 0x21U}};
    more.OnFrame(frame, {NodeState::kStopped, Instant{now_us}});
    EXPECT_TRUE(answers.frames.empty());
    more.OnFrame(frame, Now());
    EXPECT_EQ(answers.frames.at(0U).identifier, 0x6A0U);
    // The last one is that of 127Fh
    SdoServerPort last{server, answers, SdoServerNumber{127U}};
    EXPECT_EQ(Write(last, 0x127FU, 1U, 0x682U), SdoAbort::kNone);
    EXPECT_EQ(Write(last, 0x127FU, 2U, 0x6A2U), SdoAbort::kNone);
    EXPECT_EQ(Write(last, 0x1201U, 1U, 0x682U), SdoAbort::kObjectUnknown);
    EXPECT_TRUE(last.Wants(0x682U));
    // Reset communication: off again
    more.ResetCommunication(NodeId{5U});
    EXPECT_FALSE(more.Wants(0x680U));
    EXPECT_FALSE(more.Wants(0x605U));
}

TEST_F(SdoSecondServerTest, TheServersObjectIsChecked)
{
    Verifies(req::SRS_SDO_018);
    for (const std::uint32_t wrong : {0x605U, 0x585U, 0x101U, 0x701U, 0x000U, 0x40000680U, 0x20000680U, 0x800U})
    {
        EXPECT_EQ(Write(more, 0x1201U, 1U, wrong), SdoAbort::kValueRange) << wrong;
        EXPECT_EQ(Write(more, 0x1201U, 2U, wrong), SdoAbort::kValueRange) << wrong;
    }
    EXPECT_EQ(Write(more, 0x1201U, 3U, 128U), SdoAbort::kValueRange);
    EXPECT_EQ(Write(more, 0x1201U, 3U, 127U), SdoAbort::kNone);
    EXPECT_EQ(Write(more, 0x1201U, 0U, 3U), SdoAbort::kReadOnly);
    EXPECT_EQ(Write(more, 0x1201U, 4U, 3U), SdoAbort::kSubUnknown);
    EXPECT_EQ(Write(more, 0x1202U, 1U, 0x680U), SdoAbort::kObjectUnknown);
    // A valid identifier changes only by way of off
    EXPECT_EQ(Write(more, 0x1201U, 1U, 0x680U), SdoAbort::kNone);
    EXPECT_EQ(Write(more, 0x1201U, 1U, 0x681U), SdoAbort::kValueRange);
    EXPECT_EQ(Write(more, 0x1201U, 1U, 0x680U), SdoAbort::kNone);
    EXPECT_EQ(Write(more, 0x1201U, 1U, 0x80000680U), SdoAbort::kNone);
    EXPECT_EQ(Write(more, 0x1201U, 1U, 0x681U), SdoAbort::kNone);
    // Nothing changes while a transfer runs
    EXPECT_EQ(Write(more, 0x1201U, 2U, 0x6A0U), SdoAbort::kNone);
    domain_length = 20U;
    more.OnFrame(CanFrame{0x681U, FrameKind::kData, CanPortId::kFirst, 8U, {0x40U, 0x03U, 0x21U}}, Now());
    EXPECT_EQ(Write(more, 0x1201U, 2U, 0x800006A0U), SdoAbort::kDeviceState);
}

TEST_F(SdoSecondServerTest, AClientReadsFromTheServerOfItsObject)
{
    Verifies(req::SRS_SDC_011);
    Verifies(req::SRS_SDO_018);
    EXPECT_EQ(Read(asks, 0x1281U, 1U), 0x480000000U);
    EXPECT_FALSE(asks.IsConnected());
    Connect();
    EXPECT_TRUE(asks.IsConnected());
    EXPECT_EQ(asks.Server().value, 5U);
    EXPECT_TRUE(asks.Wants(0x6A0U));
    EXPECT_FALSE(asks.Wants(0x585U));
    EXPECT_TRUE(Ask(0x2105U));
    EXPECT_EQ(Write(asks, 0x1281U, 1U, 0x80000680U), SdoAbort::kDeviceState); // busy
    CarryFurther();
    EXPECT_EQ(asks.Client().State(), SdoClientState::kDone);
    // A client may use a default server; other identifiers of other services it may not
    EXPECT_EQ(Write(asks, 0x1281U, 1U, 0x80000680U), SdoAbort::kNone);
    EXPECT_FALSE(asks.IsConnected());
    EXPECT_EQ(Write(asks, 0x1281U, 1U, 0x607U), SdoAbort::kNone);
    EXPECT_EQ(Write(asks, 0x1281U, 2U, 0x806A0U), SdoAbort::kValueRange);
    EXPECT_EQ(Write(asks, 0x1281U, 2U, 0x800006A0U), SdoAbort::kNone);
    EXPECT_EQ(Write(asks, 0x1281U, 2U, 0x607U), SdoAbort::kValueRange);
    EXPECT_EQ(Write(asks, 0x1281U, 2U, 0x587U), SdoAbort::kNone);
    EXPECT_TRUE(Ask(0x2105U));
    EXPECT_EQ(requests.frames.back().identifier, 0x607U);
    EXPECT_EQ(Write(asks, 0x1280U, 1U, 0x607U), SdoAbort::kObjectUnknown);
}

TEST_F(SdoSecondServerTest, AClientGivesUpWithItsStateItsServerAndItsReset)
{
    Verifies(req::SRS_SDC_012);
    Connect();
    // Leaving for STOPPED
    EXPECT_TRUE(Ask(0x2105U));
    asks.OnCycle({NodeState::kStopped, Instant{now_us}});
    EXPECT_EQ(asks.Client().State(), SdoClientState::kAborted);
    EXPECT_EQ(Outcome(), SdoAbort::kDeviceState);
    CarryFurther();
    // The server boots while it is asked
    EXPECT_TRUE(Ask(0x2105U));
    asks.OnFrame(CanFrame{0x706U, FrameKind::kData, CanPortId::kFirst, 1U, {0U}}, Now());
    asks.OnFrame(CanFrame{0x705U, FrameKind::kData, CanPortId::kFirst, 1U, {5U}}, Now());
    EXPECT_EQ(asks.Client().State(), SdoClientState::kBusy);
    asks.OnFrame(CanFrame{0x705U, FrameKind::kData, CanPortId::kFirst, 1U, {0U}}, Now());
    EXPECT_EQ(Outcome(), SdoAbort::kNoConnection);
    // Reset communication: nothing is sent, and nobody is connected
    requests.frames.clear();
    EXPECT_TRUE(Ask(0x2105U));
    requests.frames.clear();
    asks.ResetCommunication(NodeId{9U});
    EXPECT_EQ(asks.Client().State(), SdoClientState::kAborted);
    asks.OnCycle(Now());
    EXPECT_TRUE(requests.frames.empty());
    EXPECT_FALSE(asks.IsConnected());
}

TEST_F(SdoSecondServerTest, AClientGivesUpInEachStateThatHasNoSdoAndInNoOther)
{
    Verifies(req::SRS_SDC_012);
    Connect();
    for (const NodeState state : {NodeState::kInitialising, NodeState::kStopped})
    {
        EXPECT_TRUE(Ask(0x2105U));
        // Given a transfer that goes on in PRE-OPERATIONAL and OPERATIONAL
        for (const NodeState other : {NodeState::kPreOperational, NodeState::kOperational})
        {
            asks.OnCycle({other, Instant{now_us}});
            EXPECT_EQ(asks.Client().State(), SdoClientState::kBusy);
        }
        // Then it ends in this state
        asks.OnCycle({state, Instant{now_us}});
        EXPECT_EQ(asks.Client().State(), SdoClientState::kAborted);
        EXPECT_EQ(static_cast<std::uint32_t>(Outcome()), 0x08000022U);
        CarryFurther();
    }
}

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

TEST_F(SdoServerPortTest, DataFramesOfItsIdentifierAreAnsweredInTwoStates)
{
    Verifies(req::SRS_SDO_016);
    const CanFrame request{0x605U, FrameKind::kData, CanPortId::kFirst, 8U, {0x40U, 0x05U, 0x21U}};
    const auto answered = [this](const CanFrame& frame, const NodeState state)
    {
        answers.frames.clear();
        port.OnFrame(frame, {state, Instant{now_us}});
        return answers.frames.size();
    };
    for (const NodeState state : {NodeState::kPreOperational, NodeState::kOperational})
    {
        // Given PRE-OPERATIONAL or OPERATIONAL, then the answer is on 580h + node-ID
        ASSERT_EQ(answered(request, state), 1U);
        EXPECT_EQ(answers.frames.front().identifier, 0x585U);
        EXPECT_EQ(answers.frames.front().kind, FrameKind::kData);
        // And neither a remote frame nor the identifiers beside it are answered
        CanFrame other = request;
        other.kind = FrameKind::kRemote;
        EXPECT_EQ(answered(other, state), 0U);
        for (const std::uint32_t identifier : {0x604U, 0x606U, 0x585U})
        {
            other = request;
            other.identifier = identifier;
            EXPECT_EQ(answered(other, state), 0U) << identifier;
        }
    }
    EXPECT_EQ(answered(request, NodeState::kInitialising), 0U);
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

TEST_F(SdoServerPortTest, TheRestOfASubBlockIsNoRequestHoweverLongTheStateHadNoSdo)
{
    Verifies(req::SRS_SDO_019);
    // Given a download of which one segment of four came, and a stop, by the state or by a reset
    for (const bool is_reset : {false, true})
    {
        Ask({0xC0U, 0x03U, 0x21U});
        EXPECT_EQ(answers.Next()[0], 0xA4U);
        Ask({0x01U});
        if (is_reset)
        {
            port.ResetCommunication(NodeId{5U});
        }
        for (int i = 0; i < 3; ++i)
        {
            port.OnCycle({NodeState::kStopped, Instant{now_us}});
            now_us += 10000U; // Ten times the time-out.
        }
        answers.frames.clear();
        // When SDO is allowed again, then what is left of the sub-block has no answer
        port.OnCycle(Now());
        Ask({0x02U});
        Ask({0x03U});
        EXPECT_TRUE(answers.frames.empty()) << is_reset;
        // half the time-out later it has
        now_us += 500U;
        port.OnCycle(Now());
        Ask({0x03U});
        EXPECT_EQ(answers.Next(), AbortOf(0U, 0U, 0x05040001U)) << is_reset;
    }
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
