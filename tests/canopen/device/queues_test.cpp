// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/device/outbox.hpp"
#include "canopen/device/safety_queue.hpp"
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/node.hpp"

#include <array>

namespace counterpoint::device
{
namespace
{

QueuedFrame ItemOf(const std::uint32_t identifier, const std::uint8_t byte = 0U,
                   const Origin origin = Origin::kReceived)
{
    QueuedFrame item{};
    item.frame.frame.identifier = identifier;
    item.frame.frame.kind = FrameKind::kData;
    item.frame.frame.data[0] = byte;
    item.origin = origin;
    return item;
}

/// The oldest frame, which leaves the queue; of no origin if there is none.
template <typename Queue> QueuedFrame Take(Queue& queue)
{
    QueuedFrame taken{};
    if (const QueuedFrame* const oldest = queue.Oldest(); oldest != nullptr)
    {
        taken = *oldest;
        queue.Drop();
    }
    return taken;
}

template <typename Queue> bool IsEmpty(Queue& queue)
{
    return queue.Oldest() == nullptr;
}

void Offer(SafetyQueue& queue, const QueuedFrame& item)
{
    queue.Offer(item.frame, item.origin);
}

TEST(FrameRingTest, KeepsOrderOverManyRounds)
{
    Verifies(req::SRS_DEV_007);
    std::array<QueuedFrame, 3> room{};
    FrameRing ring{FrameRoom{room.data(), 3U}};
    EXPECT_TRUE(IsEmpty(ring));
    std::uint8_t put = 0U;
    std::uint8_t taken = 0U;
    for (int round = 0; round < 100; ++round)
    {
        // Given a ring that is filled up, one is too many
        for (int count = 0; count < 3; ++count)
        {
            ASSERT_TRUE(ring.Put(ItemOf(1U, put).frame, Origin::kReceived));
            ++put;
        }
        ASSERT_FALSE(ring.Put(ItemOf(1U, 99U).frame, Origin::kReceived));
        // When one, two or three are taken, they come in order
        for (int count = 0; count <= (round % 3); ++count)
        {
            ASSERT_EQ(Take(ring).frame.frame.data[0], taken);
            ++taken;
        }
        for (int count = round % 3; count < 2; ++count)
        {
            ASSERT_EQ(Take(ring).frame.frame.data[0], taken);
            ++taken;
        }
        ASSERT_TRUE(IsEmpty(ring));
    }
}

class SafetyQueueTest : public ::testing::Test
{
  public:
    std::array<QueuedFrame, 4> room{};
    SafetyQueue queue{FrameRoom{room.data(), 4U}};
};

TEST_F(SafetyQueueTest, HasRoomForTwoFramesAnSrdoAndTwoMore)
{
    Verifies(req::SRS_DEV_007);
    EXPECT_TRUE(queue.HasRoomFor(1U));
    EXPECT_FALSE(queue.HasRoomFor(2U));
}

TEST_F(SafetyQueueTest, NothingButAdmittedDataFramesEnters)
{
    Verifies(req::SRS_DEV_007);
    queue.Admit(0x101U);
    queue.Admit(0x180U);
    queue.Admit(0x181U); // No SRDO has it.
    for (const std::uint32_t identifier : {0x102U, 0x17FU, 0x100U, 0x181U})
    {
        Offer(queue, ItemOf(identifier));
    }
    QueuedFrame remote = ItemOf(0x101U);
    remote.frame.frame.kind = FrameKind::kRemote;
    Offer(queue, remote);
    EXPECT_TRUE(IsEmpty(queue));
    Offer(queue, ItemOf(0x101U));
    Offer(queue, ItemOf(0x180U));
    EXPECT_EQ(Take(queue).frame.frame.identifier, 0x101U);
    EXPECT_EQ(Take(queue).frame.frame.identifier, 0x180U);
    queue.AdmitNone();
    Offer(queue, ItemOf(0x101U));
    EXPECT_TRUE(IsEmpty(queue));
    EXPECT_FALSE(queue.TakeLoss());
}

TEST_F(SafetyQueueTest, OneGfcAtATime)
{
    Verifies(req::SRS_DEV_007);
    // When a node sends GFC without end, and an own one is confirmed
    for (int count = 0; count < 100; ++count)
    {
        Offer(queue, ItemOf(0x001U));
    }
    Offer(queue, ItemOf(0x001U, 0U, Origin::kConfirmed));
    QueuedFrame wrong = ItemOf(0x001U);
    wrong.frame.frame.length_bytes = 1U;
    Offer(queue, wrong); // No GFC at all.
    wrong = ItemOf(0x001U);
    wrong.frame.frame.kind = FrameKind::kRemote;
    Offer(queue, wrong); // None either.
    // Then one waits, and the next one may come after it was taken
    EXPECT_EQ(Take(queue).origin, Origin::kReceived);
    EXPECT_TRUE(IsEmpty(queue));
    Offer(queue, ItemOf(0x001U));
    EXPECT_EQ(Take(queue).origin, Origin::kReceived);
    EXPECT_FALSE(queue.TakeLoss());
}

TEST_F(SafetyQueueTest, ALossIsToldOnce)
{
    Verifies(req::SRS_DEV_008);
    queue.Admit(0x101U);
    for (int count = 0; count < 4; ++count)
    {
        Offer(queue, ItemOf(0x101U));
    }
    EXPECT_FALSE(queue.TakeLoss());
    Offer(queue, ItemOf(0x101U));
    EXPECT_TRUE(queue.TakeLoss());
    EXPECT_FALSE(queue.TakeLoss());
    // A GFC that finds no room is lost, too, and the next one is let in
    Offer(queue, ItemOf(0x001U));
    EXPECT_TRUE(queue.TakeLoss());
    EXPECT_EQ(Take(queue).origin, Origin::kReceived);
    Offer(queue, ItemOf(0x001U));
    EXPECT_FALSE(queue.TakeLoss());
    queue.MarkLoss();
    EXPECT_TRUE(queue.TakeLoss());
}

class OutboxTest : public ::testing::Test
{
  public:
    void Fill(const std::uint32_t count)
    {
        for (std::uint32_t number = 0U; number < count; ++number)
        {
            ASSERT_TRUE(outbox.Send(FrameOf(0x200U + number)));
        }
    }
    static CanFrame FrameOf(const std::uint32_t identifier)
    {
        return CanFrame{identifier, FrameKind::kData, CanPortId::kFirst, 0U, {}};
    }
    RecordingPorts ports{};
    Outbox outbox{ports};
    ProcessSink process{outbox};
};

TEST_F(OutboxTest, TwoFramesAreUnderWayAtMost)
{
    Verifies(req::SRS_DEV_009);
    Fill(16U);
    EXPECT_FALSE(outbox.Send(CanFrame{}));
    outbox.Poll(Instant{0U});
    outbox.Poll(Instant{99999U});
    EXPECT_EQ(ports.sent.size(), 2U);
    // When one is confirmed, one follows, in order
    outbox.OnConfirm();
    outbox.Poll(Instant{1000U});
    ASSERT_EQ(ports.sent.size(), 3U);
    EXPECT_EQ(ports.sent[2].identifier, 0x202U);
    // When confirmations stay away for 100 ms, the next two go
    outbox.Poll(Instant{100999U});
    EXPECT_EQ(ports.sent.size(), 3U);
    outbox.Poll(Instant{101000U});
    EXPECT_EQ(ports.sent.size(), 5U);
}

TEST_F(OutboxTest, ProcessDataLeavePlacesAndOwnMessagesHaveTheirs)
{
    Verifies(req::SRS_DEV_150);
    for (int round = 0; round < 3; ++round) // The ring of twenty, at any place.
    {
        ports.sent.clear();
        // Given twelve PDOs, then a thirteenth finds no room, four transfers and no fifth do
        for (std::uint32_t number = 0U; number < 12U; ++number)
        {
            EXPECT_TRUE(process.Send(FrameOf(0x180U + number)));
        }
        EXPECT_FALSE(process.Send(FrameOf(0x18CU)));
        for (std::uint32_t number = 0U; number < 4U; ++number)
        {
            EXPECT_TRUE(outbox.Send(FrameOf(0x580U + number)));
        }
        EXPECT_FALSE(outbox.Send(FrameOf(0x584U)));
        // Three own messages, and a boot-up message behind them
        for (std::uint32_t number = 0U; number < 3U; ++number)
        {
            EXPECT_TRUE(outbox.HasOwnRoom());
            EXPECT_TRUE(outbox.SendOwn(FrameOf(0x700U + number)));
        }
        EXPECT_FALSE(outbox.HasOwnRoom());
        EXPECT_TRUE(outbox.SendOwn(FrameOf(0x703U)));
        EXPECT_FALSE(outbox.SendOwn(FrameOf(0x704U)));
        // When a PDO has gone, then its place is for a PDO or a transfer
        outbox.Poll(Instant{0U});
        ASSERT_EQ(ports.sent.size(), 2U);
        EXPECT_TRUE(outbox.Send(FrameOf(0x584U)));
        EXPECT_TRUE(process.Send(FrameOf(0x18CU)));
        EXPECT_FALSE(process.Send(FrameOf(0x18DU)));
        EXPECT_FALSE(outbox.Send(FrameOf(0x585U)));
        // And all of them leave in their order
        for (std::uint32_t turn = 0U; turn < 10U; ++turn)
        {
            outbox.OnConfirm();
            outbox.OnConfirm();
            outbox.Poll(Instant{1U});
        }
        std::vector<std::uint32_t> left;
        for (const CanFrame& frame : ports.sent)
        {
            left.push_back(frame.identifier);
        }
        EXPECT_EQ(left, (std::vector<std::uint32_t>{0x180U, 0x181U, 0x182U, 0x183U, 0x184U, 0x185U, 0x186U, 0x187U,
                                                    0x188U, 0x189U, 0x18AU, 0x18BU, 0x580U, 0x581U, 0x582U, 0x583U,
                                                    0x700U, 0x701U, 0x702U, 0x703U, 0x584U, 0x18CU}));
        outbox.OnConfirm();
        outbox.OnConfirm();
    }
}

TEST_F(OutboxTest, TransfersAloneHaveSixteenPlaces)
{
    Verifies(req::SRS_DEV_150);
    Fill(16U);
    EXPECT_FALSE(process.Send(FrameOf(0x180U)));
    outbox.Clear();
    Fill(16U);
    EXPECT_TRUE(outbox.HasOwnRoom());
}

TEST_F(OutboxTest, TellsWhetherTheNewestFrameOfAnIdentifierIsTheSame)
{
    Verifies(req::SRS_DEV_024);
    const auto send = [this](const std::uint8_t state)
    {
        CanFrame frame{};
        frame.identifier = 0x721U;
        frame.kind = FrameKind::kData;
        frame.port = CanPortId::kFirst;
        frame.length_bytes = 1U;
        frame.data[0] = state;
        ASSERT_TRUE(outbox.Send(frame));
    };
    EXPECT_FALSE(outbox.Waits(0x721U, 0x05U));
    // Given the ring half way round, a heartbeat in OPERATIONAL and something else behind it
    Fill(2U);
    outbox.Poll(Instant{0U});
    send(0x05U);
    Fill(1U);
    EXPECT_TRUE(outbox.Waits(0x721U, 0x05U));
    EXPECT_FALSE(outbox.Waits(0x721U, 0x7FU));
    EXPECT_FALSE(outbox.Waits(0x722U, 0x05U));
    // When another state follows, then that one counts
    send(0x7FU);
    EXPECT_FALSE(outbox.Waits(0x721U, 0x05U));
    EXPECT_TRUE(outbox.Waits(0x721U, 0x7FU));
    // When both have gone, nothing waits
    outbox.Poll(Instant{100000U});
    outbox.Poll(Instant{200000U});
    EXPECT_FALSE(outbox.Waits(0x721U, 0x7FU));
}

TEST_F(OutboxTest, WhatTheControllerDoesNotTakeWaits)
{
    Verifies(req::SRS_DEV_009);
    Fill(2U);
    ports.answer = hal::TransmitStatus::kQueueFull;
    outbox.Poll(Instant{0U});
    ports.answer = hal::TransmitStatus::kAccepted;
    outbox.Poll(Instant{0U});
    ASSERT_EQ(ports.sent.size(), 2U);
    EXPECT_EQ(ports.sent[0].identifier, 0x200U);
    // What it never will take does not block the others
    outbox.OnConfirm();
    outbox.OnConfirm();
    CanFrame wrong{};
    wrong.identifier = 0x900U;
    wrong.kind = FrameKind::kData;
    wrong.port = CanPortId::kFirst;
    ASSERT_TRUE(outbox.Send(wrong));
    Fill(1U);
    outbox.Poll(Instant{10U});
    EXPECT_EQ(ports.sent.size(), 3U);
    // Cleared, nothing is left
    Fill(3U);
    outbox.Clear();
    outbox.Poll(Instant{300000U});
    EXPECT_EQ(ports.sent.size(), 3U);
}

} // namespace
} // namespace counterpoint::device
