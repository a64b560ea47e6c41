// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Status byte of each SRDO and the handshake with the application.
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"

namespace counterpoint
{
namespace
{

constexpr CommunicationIndex kConsumer{0x1301U};
constexpr CommunicationIndex kProducer{0x1303U};

class Status : public Rig
{
  public:
    std::uint8_t StatusOf(const CommunicationIndex index)
    {
        const StatusReply reply = kernel.GetStatus(index);
        EXPECT_EQ(reply.result, Result::kSuccessful);
        return reply.status.value;
    }
    void Answer(const CommunicationIndex index, const std::uint8_t status)
    {
        EXPECT_EQ(kernel.SetStatus(index, StatusByte{status}), Result::kSuccessful);
    }
    /// Answers in the callbacks, as the reference's example does.
    void AnswerInCallbacks()
    {
        application.on_event = [this](CommunicationIndex index)
        {
            const std::uint8_t status = StatusOf(index);
            told.push_back(status);
            Answer(index, static_cast<std::uint8_t>(status | 0x30U));
        };
        application.on_error = [this](CommunicationIndex index)
        {
            const std::uint8_t status = StatusOf(index);
            told.push_back(status);
            Answer(index, static_cast<std::uint8_t>((status | 0x30U) ^ 0xC0U));
        };
    }
    /// A frame that is wrong in itself: inverse first.
    void ReceiveWrong()
    {
        Receive(0x102U, {0xEDU, 0xCBU}, 100U);
    }

    std::vector<std::uint8_t> told{};
};

TEST_F(Status, ResetValueAndUnknownSrdo)
{
    Verifies(req::SRS_KRN_021);
    Configure();
    EXPECT_EQ(StatusOf(kConsumer), 0x30U);
    EXPECT_EQ(StatusOf(kProducer), 0x30U);
    EXPECT_EQ(kernel.GetStatus(CommunicationIndex{0x1302U}).result, Result::kNotExist);
    EXPECT_EQ(kernel.SetStatus(CommunicationIndex{0x1302U}, StatusByte{0U}), Result::kNotExist);
}

TEST_F(Status, EveryPatternIsKeptForItsSrdoAlone)
{
    Verifies(req::SRS_KRN_021);
    Configure();
    for (std::uint32_t bits = 0U; bits < 16U; ++bits)
    {
        Answer(kConsumer, static_cast<std::uint8_t>((bits << 4U) | 0x0AU));
        EXPECT_EQ(StatusOf(kConsumer), bits << 4U);
        EXPECT_EQ(StatusOf(kProducer), 0x30U);
    }
}

TEST_F(Status, EventAndErrorAreAnnouncedBeforeTheCallback)
{
    Verifies(req::SRS_KRN_226);
    Verifies(req::SRS_KRN_006);
    Verifies(req::SRS_KRN_340);
    handshake = StatusHandshake::kRequired;
    AnswerInCallbacks();
    Operate();
    ReceivePair();
    Cycle();
    EXPECT_EQ(told, std::vector<std::uint8_t>{0x00U});
    EXPECT_EQ(StatusOf(kConsumer), 0x30U);
    ReceiveWrong();
    Cycle();
    EXPECT_EQ(told.back(), 0x50U);
    EXPECT_EQ(StatusOf(kConsumer), 0xB0U);
    // An event leaves bits 7-6 as they are
    ReceivePair();
    Cycle();
    EXPECT_EQ(told.back(), 0x80U);
    EXPECT_EQ(StatusOf(kConsumer), 0xB0U);
    Cycles(5U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

TEST_F(Status, ByteReleasesNothingAndHoldsNothingBack)
{
    Verifies(req::SRS_KRN_227);
    Operate();
    Answer(kConsumer, 0xFFU);
    Cycle();
    EXPECT_EQ(Open(), 0U);
    ReceivePair();
    Answer(kConsumer, 0x50U);
    Cycle();
    EXPECT_EQ(Open(), 1U);
}

TEST_F(Status, WithoutTheOptionNothingFollowsFromSilence)
{
    Verifies(req::SRS_KRN_344);
    Operate();
    ReceivePair();
    Cycles(20U);
    EXPECT_EQ(StatusOf(kConsumer), 0x00U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    EXPECT_EQ(Open(), 1U);
}

// t [cycle]   k OnSrdoEvent      k+1 not answered yet when its events are told
TEST_F(Status, UnansweredEventIsADeviceFaultAfterTheNextCycle)
{
    Verifies(req::SRS_KRN_022);
    Verifies(req::SRS_KRN_028);
    handshake = StatusHandshake::kRequired;
    Operate();
    ReceivePair();
    Cycle();
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    EXPECT_EQ(Open(), 1U);
    Cycle();
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kHandshake);
    EXPECT_EQ(kernel.DeviceState().slot, 0U);
    EXPECT_EQ(Open(), 0U);
    EXPECT_EQ(application.faults, std::vector<DeviceFault>{DeviceFault::kHandshake});
}

TEST_F(Status, AnswerBetweenTheCyclesIsInTime)
{
    Verifies(req::SRS_KRN_022);
    handshake = StatusHandshake::kRequired;
    Operate();
    for (std::uint32_t pair = 0U; pair < 5U; ++pair)
    {
        ReceivePair();
        Cycle();
        EXPECT_EQ(StatusOf(kConsumer), 0x00U);
        Answer(kConsumer, 0x30U);
    }
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    EXPECT_EQ(Open(), 1U);
}

TEST_F(Status, EventThatIsAnsweredLikeAnErrorAloneIsUnanswered)
{
    Verifies(req::SRS_KRN_343);
    handshake = StatusHandshake::kRequired;
    Operate();
    ReceivePair();
    Cycle();
    Answer(kConsumer, 0x20U); // bit 4 missing
    Cycle();
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kHandshake);
}

TEST_F(Status, ErrorIsAnsweredWithBothFields)
{
    Verifies(req::SRS_KRN_343);
    handshake = StatusHandshake::kRequired;
    Operate();
    ReceiveWrong();
    Cycle();
    EXPECT_EQ(StatusOf(kConsumer), 0x50U);
    Answer(kConsumer, 0x70U); // bits 7-6 still say that an error was told
    Cycle();
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kHandshake);
    EXPECT_EQ(kernel.DeviceState().slot, 0U);
}

// Bits 7-6 behind an error: 10 alone is an answer.
TEST_F(Status, ErrorIsAnsweredByTenInItsFieldAlone)
{
    Verifies(req::SRS_KRN_343);
    handshake = StatusHandshake::kRequired;
    const std::array<std::pair<std::uint8_t, DeviceFault>, 4> answers{{{0x30U, DeviceFault::kHandshake},
                                                                       {0x70U, DeviceFault::kHandshake},
                                                                       {0xB0U, DeviceFault::kNone},
                                                                       {0xF0U, DeviceFault::kHandshake}}};
    for (const auto& [answer, fault] : answers)
    {
        Operate();
        ReceiveWrong();
        Cycle();
        ASSERT_EQ(StatusOf(kConsumer), 0x50U);
        Answer(kConsumer, answer);
        EXPECT_EQ(StatusOf(kConsumer), answer);
        Cycle();
        EXPECT_EQ(kernel.DeviceState().fault, fault) << unsigned{answer};
    }
}

// An answer that is no answer does not make the error an event.
TEST_F(Status, WrongAnswerLeavesTheErrorToAnswer)
{
    Verifies(req::SRS_KRN_343);
    handshake = StatusHandshake::kRequired;
    Operate();
    ReceiveWrong();
    Cycle();
    Answer(kConsumer, 0x20U);
    Answer(kConsumer, 0x30U);
    Cycle();
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kHandshake);
}

// What was answered stays so, whatever the application writes then; only an announcement has to be answered.
TEST_F(Status, WhatIsWrittenBehindTheAnswerOpensNothing)
{
    Verifies(req::SRS_KRN_343);
    handshake = StatusHandshake::kRequired;
    Operate();
    Answer(kConsumer, 0x00U);
    Cycles(2U);
    ReceiveWrong();
    Cycle();
    Answer(kConsumer, 0xB0U);
    Answer(kConsumer, 0x90U);
    Cycles(2U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    EXPECT_EQ(StatusOf(kConsumer), 0x90U);
}

// Behind an event alone whatever does not say that an error was told: none, or an older one that was handled.
TEST_F(Status, EventNeedsNoAnswerInTheFieldOfErrors)
{
    Verifies(req::SRS_KRN_343);
    handshake = StatusHandshake::kRequired;
    Operate();
    for (const std::uint8_t answer : std::initializer_list<std::uint8_t>{0x30U, 0xB0U, 0xF0U})
    {
        ReceivePair();
        Cycle();
        Answer(kConsumer, answer);
    }
    Cycle();
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    ReceivePair();
    Cycle();
    Answer(kConsumer, 0x70U);
    Cycle();
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kHandshake);
}

TEST_F(Status, BitFiveMissingIsUnanswered)
{
    Verifies(req::SRS_KRN_343);
    handshake = StatusHandshake::kRequired;
    Operate();
    ReceiveWrong();
    Cycle();
    Answer(kConsumer, 0x90U);
    Cycle();
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kHandshake);
}

// t     7 normal handed over    7.1 confirmed    7.2 pair confirmed: OnSrdoEvent    8 cycle    9 cycle
TEST_F(Status, EventOfAProducerBetweenTwoCyclesHasTheSameTime)
{
    Verifies(req::SRS_KRN_022);
    handshake = StatusHandshake::kRequired;
    Operate();
    Cycle();
    ConfirmLast();
    ConfirmLast();
    EXPECT_EQ(StatusOf(kProducer), 0x00U);
    Cycle();
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    Cycle();
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kHandshake);
    EXPECT_EQ(kernel.DeviceState().slot, 1U);
}

TEST_F(Status, StartResetsTheBytes)
{
    Verifies(req::SRS_KRN_021);
    Operate();
    ReceivePair();
    Cycle();
    ASSERT_EQ(StatusOf(kConsumer), 0x00U);
    ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    EXPECT_EQ(StatusOf(kConsumer), 0x30U);
}

// call      OnEvent   TakeOverdue   TakeOverdue   TakeOverdue
// overdue             none          5             5
TEST(StatusStorage, WhatIsOverdueStaysSoUntilItIsAnswered)
{
    Verifies(req::SRS_KRN_022);
    SrdoStatus status{};
    status.OnEvent(5U);
    EXPECT_EQ(status.TakeOverdue(), kNoSlot);
    EXPECT_EQ(status.TakeOverdue(), 5U);
    EXPECT_EQ(status.TakeOverdue(), 5U);
    status.Answer(5U, StatusByte{0x30U});
    EXPECT_EQ(status.TakeOverdue(), kNoSlot);
}

TEST_F(Status, SecondEventIsAnnouncedAsTheFirstOne)
{
    Verifies(req::SRS_KRN_226);
    Operate();
    for (std::uint32_t pair = 0U; pair < 2U; ++pair)
    {
        ReceivePair();
        Cycle();
        EXPECT_EQ(StatusOf(kConsumer), 0x00U) << pair;
    }
}

// An answer is in bits 7 to 4 alone.
TEST(StatusStorage, LowBitsOfAnAnswerHaveNoMeaning)
{
    Verifies(req::SRS_KRN_343);
    for (std::uint8_t low = 0U; low < 16U; ++low)
    {
        SrdoStatus status{};
        status.OnError(5U);
        status.Answer(5U, StatusByte{static_cast<std::uint8_t>(0xB0U | low)});
        EXPECT_EQ(status.TakeOverdue(), kNoSlot);
        EXPECT_EQ(status.TakeOverdue(), kNoSlot) << unsigned{low};
    }
}

TEST(StatusStorage, AllSrdosTakeAtMostSixtyFourBytes)
{
    Verifies(req::SRS_KRN_228);
    EXPECT_LE(sizeof(SrdoStatus), 64U);
}

TEST(StatusStorage, LowestSlotThatIsOverdueIsNamed)
{
    Verifies(req::SRS_KRN_022);
    SrdoStatus status{};
    status.OnEvent(63U);
    status.OnError(7U);
    status.OnEvent(3U);
    EXPECT_EQ(status.TakeOverdue(), kNoSlot);
    EXPECT_EQ(status.TakeOverdue(), 3U);
    status.Answer(3U, StatusByte{0x30U});
    EXPECT_EQ(status.TakeOverdue(), 7U);
    status.Answer(7U, StatusByte{0xB0U});
    EXPECT_EQ(status.TakeOverdue(), 63U);
}

// Start that is told nothing of a handshake.
TEST_F(Status, HandshakeIsOffByDefault)
{
    Verifies(req::SRS_KRN_344);
    ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    a.on_outcome = [](CycleOutcome& outcome) { outcome.signalled = 1U; };
    a.more_signals = 2U;
    a.signals_slot = 0U;
    Cycle();
    a.on_outcome = nullptr;
    a.more_signals = 0U;
    EXPECT_EQ(StatusOf(kConsumer), 0x50U);
    Cycles(3U);
    EXPECT_EQ(StatusOf(kConsumer), 0x50U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

} // namespace
} // namespace counterpoint
