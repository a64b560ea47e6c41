// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/emergency/producer.hpp"
#include "verification/trace/ids/cia301.hpp"
#include "verification/trace/verifies.hpp"

#include <vector>

namespace counterpoint::cia301
{
namespace
{

using Octets = std::vector<std::uint8_t>;

class EmergencyTest : public ::testing::Test
{
  public:
    Octets Poll(NodeState state = NodeState::kOperational)
    {
        const FrameToSend sent = producer.Poll(state, Instant{now_us});
        identifier = sent.frame.identifier;
        return sent.is_present ? Octets(sent.frame.data, sent.frame.data + 8) : Octets{};
    }

    std::uint32_t now_us{0xFFFFFF00U};
    std::uint32_t identifier{0U};
    std::uint32_t history[8]{};
    EmergencyProducer producer{NodeId{5U}, ErrorHistory{history, 8U}};
    EmergencyError temperature{0x4210U, 0x08U, {1U, 2U, 3U, 4U, 5U}};
    EmergencyError voltage{0x3110U, 0x04U, {6U}};
};

TEST_F(EmergencyTest, AnErrorIsSentWhenItComesAndWhenItGoes)
{
    Verifies(req::SRS_EMCY_001);
    EXPECT_TRUE(Poll().empty());
    producer.Raise(temperature);
    producer.Raise(temperature); // already active
    EXPECT_EQ(producer.Register(), 0x09U);
    EXPECT_EQ(Poll(), (Octets{0x10U, 0x42U, 0x09U, 1U, 2U, 3U, 4U, 5U}));
    EXPECT_EQ(identifier, 0x85U);
    EXPECT_TRUE(Poll().empty());
    producer.Raise(voltage);
    EXPECT_EQ(Poll(), (Octets{0x10U, 0x31U, 0x0DU, 6U, 0U, 0U, 0U, 0U}));
    producer.Clear(0x1234U); // not active
    EXPECT_TRUE(Poll().empty());
    producer.Clear(0x4210U);
    EXPECT_EQ(Poll(), (Octets{0U, 0U, 0x05U, 0U, 0U, 0U, 0U, 0U}));
    producer.Clear(0x3110U);
    EXPECT_EQ(Poll(), (Octets{0U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}));
    EXPECT_EQ(producer.Register(), 0U);
}

TEST_F(EmergencyTest, TheHistoryHasTheNewestFirst)
{
    Verifies(req::SRS_EMCY_001);
    Verifies(req::SRS_EMCY_002);
    EXPECT_EQ(producer.History(0U).value, 0U);
    EXPECT_EQ(producer.History(1U).abort, SdoAbort::kNoData);
    EXPECT_EQ(producer.History(9U).abort, SdoAbort::kSubUnknown);
    producer.Raise(temperature);
    producer.Raise(voltage);
    EXPECT_EQ(producer.History(0U).value, 2U);
    EXPECT_EQ(producer.History(1U).value, 0x00063110U);
    EXPECT_EQ(producer.History(2U).value, 0x02014210U);
    EXPECT_EQ(producer.WriteHistory(1U), SdoAbort::kValueRange);
    EXPECT_EQ(producer.History(0U).value, 2U);
    EXPECT_EQ(producer.WriteHistory(0U), SdoAbort::kNone);
    EXPECT_EQ(producer.History(0U).value, 0U);
    // Ten errors one after the other: the eight newest are left
    for (std::uint16_t code = 1U; code <= 10U; ++code)
    {
        producer.Clear(0x4210U);
        producer.Raise(EmergencyError{code, 0U, {}});
        producer.Clear(code);
    }
    EXPECT_EQ(producer.History(0U).value, 8U);
    EXPECT_EQ(producer.History(1U).value, 10U);
    EXPECT_EQ(producer.History(8U).value, 3U);
}

TEST_F(EmergencyTest, TheHistoryIsAsLongAsItsRoom)
{
    Verifies(req::SRS_EMCY_009);
    std::uint32_t room[255] = {};
    for (const std::uint8_t count : {std::uint8_t{0U}, std::uint8_t{1U}, std::uint8_t{3U}, std::uint8_t{254U}})
    {
        EmergencyProducer other{NodeId{5U}, ErrorHistory{room, count}};
        for (std::uint16_t code = 1U; code <= 300U; ++code)
        {
            other.Raise(EmergencyError{code, 0U, {}});
            other.Clear(code);
        }
        EXPECT_EQ(other.History(0U).value, count);
        EXPECT_EQ(other.History(static_cast<std::uint8_t>(count + 1U)).abort, SdoAbort::kSubUnknown);
        EXPECT_TRUE(count == 0U || other.History(1U).value == 300U);
        EXPECT_TRUE(count == 0U || other.History(count).value == 301U - count);
        EXPECT_EQ(other.WriteHistory(0U), SdoAbort::kNone);
        EXPECT_EQ(other.History(0U).value, 0U);
    }
    // Sub-index 255 is none of a list
    EmergencyProducer longest{NodeId{5U}, ErrorHistory{room, 255U}};
    EXPECT_EQ(longest.History(254U).abort, SdoAbort::kNoData);
    EXPECT_EQ(longest.History(255U).abort, SdoAbort::kSubUnknown);
}

TEST_F(EmergencyTest, TheCobIdIsChecked)
{
    Verifies(req::SRS_EMCY_003);
    EXPECT_EQ(producer.CobId(), 0x85U);
    EXPECT_EQ(producer.WriteCobId(0x90U), SdoAbort::kValueRange); // on
    EXPECT_EQ(producer.WriteCobId(0x85U), SdoAbort::kNone);       // the same
    EXPECT_EQ(producer.WriteCobId(0x80000085U), SdoAbort::kNone);
    producer.Raise(temperature);
    EXPECT_TRUE(Poll().empty());
    EXPECT_EQ(producer.WriteCobId(0x40000090U), SdoAbort::kValueRange);
    EXPECT_EQ(producer.WriteCobId(0x20000090U), SdoAbort::kValueRange);
    EXPECT_EQ(producer.WriteCobId(0x00000800U), SdoAbort::kValueRange);
    for (const std::uint32_t wrong :
         {0x000U, 0x07FU, 0x101U, 0x180U, 0x581U, 0x5FFU, 0x601U, 0x67FU, 0x6E0U, 0x6FFU, 0x701U, 0x7FFU})
    {
        EXPECT_EQ(producer.WriteCobId(wrong), SdoAbort::kValueRange) << wrong;
        EXPECT_EQ(producer.WriteCobId(0x80000000U | wrong), SdoAbort::kValueRange) << wrong;
    }
    for (const std::uint32_t right : {0x080U, 0x100U, 0x181U, 0x580U, 0x600U, 0x680U, 0x6DFU, 0x700U})
    {
        EXPECT_EQ(producer.WriteCobId(0x80000000U | right), SdoAbort::kNone) << right;
    }
    EXPECT_EQ(producer.WriteCobId(0x90U), SdoAbort::kNone);
    EXPECT_EQ(Poll().size(), 8U);
    EXPECT_EQ(identifier, 0x90U);
    // Together with turning it off it may be another one
    EXPECT_EQ(producer.WriteCobId(0x80000091U), SdoAbort::kNone);
    EXPECT_EQ(producer.CobId(), 0x80000091U);
}

TEST_F(EmergencyTest, TheInhibitTimeIsKeptAndTheOrderToo)
{
    Verifies(req::SRS_EMCY_004);
    producer.SetInhibitTime(10U); // 1 ms
    EXPECT_EQ(producer.InhibitTime(), 10U);
    producer.Raise(temperature);
    producer.Raise(voltage);
    EXPECT_EQ(Poll()[1], 0x42U);
    now_us += 999U;
    EXPECT_TRUE(Poll().empty());
    now_us += 1U;
    EXPECT_EQ(Poll()[1], 0x31U);
    // Nine messages wait: the ninth is dropped
    for (std::uint16_t code = 1U; code <= 6U; ++code)
    {
        producer.Raise(EmergencyError{code, 0U, {}});
    }
    EXPECT_EQ(producer.Dropped(), 0U);
    producer.Clear(1U);
    producer.Clear(2U);
    EXPECT_EQ(producer.Dropped(), 0U);
    producer.Clear(3U);
    EXPECT_EQ(producer.Dropped(), 1U);
    now_us += 1000U;
    EXPECT_EQ(Poll()[0], 1U);
}

// Whoever hears all messages knows at their end what is wrong.
TEST_F(EmergencyTest, WhatFoundNoRoomIsToldBehindTheFullQueue)
{
    Verifies(req::SRS_EMCY_150);
    // Given an error that flickers until eight messages wait, then ends, and another one that comes
    for (int i = 0; i < 4; ++i)
    {
        producer.Raise(voltage);
        producer.Clear(0x3110U);
    }
    producer.Raise(temperature);
    producer.Raise(voltage);
    producer.Clear(0x3110U);
    EXPECT_EQ(producer.Dropped(), 3U);
    // When all are sent, then the end that found no room follows, and the error that is there
    for (int i = 0; i < 4; ++i)
    {
        EXPECT_EQ(Poll()[1], 0x31U);
        EXPECT_EQ(Poll(), (Octets{0x00U, 0x00U, 0x00U, 0U, 0U, 0U, 0U, 0U}));
    }
    EXPECT_EQ(Poll(), (Octets{0x00U, 0x00U, 0x09U, 0U, 0U, 0U, 0U, 0U}));
    EXPECT_EQ(Poll(), (Octets{0x10U, 0x42U, 0x09U, 1U, 2U, 3U, 4U, 5U}));
    EXPECT_TRUE(Poll().empty());
    // Nothing is told a second time
    producer.Clear(0x4210U);
    EXPECT_EQ(Poll(), (Octets{0x00U, 0x00U, 0x00U, 0U, 0U, 0U, 0U, 0U}));
    EXPECT_TRUE(Poll().empty());
    EXPECT_EQ(producer.Dropped(), 3U);
}

// Nine places, the last one for an urgent error.
TEST_F(EmergencyTest, WhatFoundNoRoomWaitsUntilThereIsSomeForIt)
{
    Verifies(req::SRS_EMCY_150);
    // Given eight messages that wait, two errors and an end that found no room, and an urgent error behind them
    for (int i = 0; i < 4; ++i)
    {
        producer.Raise(voltage);
        producer.Clear(0x3110U);
    }
    producer.Raise(voltage);
    producer.Clear(0x3110U);
    producer.Raise(voltage);
    producer.Raise(temperature);
    producer.Raise(EmergencyError{0x6100U, 0x80U, {0U, 7U}, 0U, EmergencyUrgency::kUrgent});
    // When one is sent, then only the place of the urgent error is free again; then one more each time
    for (int i = 0; i < 4; ++i)
    {
        EXPECT_EQ(Poll()[1], 0x31U);
        EXPECT_EQ(Poll()[1], 0x00U);
    }
    EXPECT_EQ(Poll()[1], 0x61U);
    EXPECT_EQ(Poll()[1], 0x00U);
    EXPECT_EQ(Poll()[1], 0x31U);
    EXPECT_EQ(Poll()[1], 0x42U);
    EXPECT_TRUE(Poll().empty());
}

TEST_F(EmergencyTest, AResetOfCommunicationForgetsWhatFoundNoRoom)
{
    Verifies(req::SRS_EMCY_150);
    Verifies(req::SRS_EMCY_008);
    for (int i = 0; i < 4; ++i)
    {
        producer.Raise(voltage);
        producer.Clear(0x3110U);
    }
    producer.Raise(voltage);
    producer.Raise(temperature);
    producer.Clear(0x3110U);
    producer.ResetCommunication(NodeId{5U});
    EXPECT_TRUE(Poll().empty());
    producer.Raise(voltage);
    EXPECT_EQ(Poll()[1], 0x31U);
    EXPECT_TRUE(Poll().empty());
}

TEST_F(EmergencyTest, MoreErrorsThanRoomAreCounted)
{
    Verifies(req::SRS_EMCY_004);
    for (std::uint16_t code = 1U; code <= 300U; ++code)
    {
        producer.Raise(EmergencyError{code, 0U, {}});
    }
    EXPECT_EQ(producer.Dropped(), 255U);
    EXPECT_EQ(producer.History(0U).value, 8U);
    for (std::uint8_t code = 1U; code <= 8U; ++code)
    {
        EXPECT_EQ(Poll()[0], code);
    }
    EXPECT_TRUE(Poll().empty());
}

TEST_F(EmergencyTest, TheOwnersRoomHoldsAsManyErrorsAndOneThatIsUrgent)
{
    Verifies(req::SRS_EMCY_010);
    EmergencyError active[41]{};
    EmergencyMessage waiting[41]{};
    EmergencyProducer large{NodeId{5U}, ErrorHistory{history, 8U}, EmergencyRoom{active, waiting, 41U}};
    const auto next = [&large]
    {
        const FrameToSend sent = large.Poll(NodeState::kOperational, Instant{0U});
        return sent.is_present ? (sent.frame.data[0] | (unsigned{sent.frame.data[1]} << 8U)) : 0xFFFFU;
    };
    for (std::uint16_t source = 1U; source <= 40U; ++source)
    {
        large.Raise(EmergencyError{0x8130U, 0x10U, {}, source});
    }
    EXPECT_EQ(large.Dropped(), 0U);
    // The 41st finds no room, an urgent one does
    large.Raise(EmergencyError{0x8130U, 0x10U, {}, 41U});
    EXPECT_EQ(large.Dropped(), 1U);
    large.Raise(EmergencyError{0x6100U, 0x80U, {}, 0U, EmergencyUrgency::kUrgent});
    EXPECT_EQ(large.Dropped(), 1U);
    EXPECT_EQ(large.Register(), 0x91U);
    for (int count = 0; count < 40; ++count)
    {
        EXPECT_EQ(next(), 0x8130U);
    }
    EXPECT_EQ(next(), 0x6100U);
    EXPECT_EQ(next(), 0xFFFFU);
    // With room again the lost one is told when it is raised again; the urgent one's place is used up till then
    large.Clear(0x8130U, 1U);
    large.Clear(0x8130U, 2U);
    EXPECT_EQ(next(), 0U);
    EXPECT_EQ(next(), 0U);
    large.Raise(EmergencyError{0x8130U, 0x10U, {}, 41U});
    EXPECT_EQ(next(), 0x8130U);
    EXPECT_EQ(large.Dropped(), 1U);
}

TEST_F(EmergencyTest, WithoutRoomTheProducerHasItsOwn)
{
    Verifies(req::SRS_EMCY_010);
    EmergencyProducer small{NodeId{5U}, ErrorHistory{history, 8U}, EmergencyRoom{nullptr, nullptr, 0U}};
    for (std::uint16_t source = 1U; source <= 9U; ++source)
    {
        small.Raise(EmergencyError{0x8130U, 0x10U, {}, source});
    }
    EXPECT_EQ(small.Dropped(), 1U);
    small.Raise(EmergencyError{0x6100U, 0x80U, {}, 0U, EmergencyUrgency::kUrgent});
    EXPECT_EQ(small.Dropped(), 1U);
    EXPECT_EQ(small.Register(), 0x91U);
}

TEST_F(EmergencyTest, AResetOfCommunicationTellsUrgentErrorsAgain)
{
    Verifies(req::SRS_EMCY_008);
    producer.Raise(temperature);
    producer.Raise(EmergencyError{0x6100U, 0x80U, {0U, 7U}, 0U, EmergencyUrgency::kUrgent});
    EXPECT_EQ(Poll(), (Octets{0x10U, 0x42U, 0x09U, 1U, 2U, 3U, 4U, 5U}));
    producer.ResetCommunication(NodeId{5U});
    EXPECT_TRUE(Poll(NodeState::kInitialising).empty());
    EXPECT_EQ(Poll(), (Octets{0x00U, 0x61U, 0x89U, 0U, 7U, 0U, 0U, 0U}));
    EXPECT_TRUE(Poll().empty());
    producer.Clear(0x6100U);
    EXPECT_EQ(Poll(), (Octets{0x00U, 0x00U, 0x09U, 0U, 0U, 0U, 0U, 0U}));
    producer.ResetCommunication(NodeId{5U});
    EXPECT_TRUE(Poll().empty());
    EXPECT_EQ(producer.History(0U).value, 2U);
}

TEST_F(EmergencyTest, MessagesWaitUntilStoppedIsLeft)
{
    Verifies(req::SRS_EMCY_005);
    producer.Raise(temperature);
    for (const NodeState state : {NodeState::kInvalid, NodeState::kInitialising, NodeState::kResetApplication,
                                  NodeState::kResetCommunication, NodeState::kStopped})
    {
        EXPECT_TRUE(Poll(state).empty());
    }
    EXPECT_EQ(Poll(NodeState::kPreOperational).size(), 8U);
}

} // namespace
} // namespace counterpoint::cia301
