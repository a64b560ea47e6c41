// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What channel A makes of the acknowledge inputs, cycle by cycle, what it signals, and which limits it examines.
#include "tests/channel_a/device.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <initializer_list>
#include <memory>

namespace counterpoint::channel_a_test
{
namespace
{

class ChannelACycle : public ::testing::Test
{
  protected:
    void SetUp() override
    {
        fenced->device.setups[0].policy = ReleasePolicy::kInterlock;
        Start();
    }

    // Before the first cycle of a consumer that needs an acknowledge.
    void Start()
    {
        device.clock_us = 0U;
        device.nmt = NmtState::kOperational;
        device.acknowledge = 0U;
        device.Start();
    }

    // Whether the consumer is released by a cycle with this input and a pair before it.
    bool ReleasesWith(SrdoMask input)
    {
        device.acknowledge = input;
        const bool is_released = device.Cycle().released != 0U;
        device.Pair(8U, 0x11U);
        return is_released;
    }

    bool ReleasesWith(std::initializer_list<SrdoMask> inputs)
    {
        bool is_released = false;
        for (const SrdoMask input : inputs)
        {
            is_released = ReleasesWith(input) || is_released;
        }
        return is_released;
    }

    std::unique_ptr<FencedDevice> fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
};

TEST_F(ChannelACycle, TakesAnAcknowledgeThatLastsTwoCalls)
{
    Verifies(req::SRS_REL_005);
    // Given a level of 0, when 1 lasts one call, then nothing; when it lasts two, the second one releases
    EXPECT_FALSE(ReleasesWith({0U, 0U, 1U, 0U, 1U, 0U}));
    EXPECT_FALSE(ReleasesWith(1U));
    EXPECT_TRUE(ReleasesWith(1U));
}

TEST_F(ChannelACycle, TakesNoAcknowledgeFromALevelThatWasNotLow)
{
    Verifies(req::SRS_REL_005);
    // 1 from the beginning, and a 0 that lasts one call
    EXPECT_FALSE(ReleasesWith({1U, 1U, 1U, 0U, 1U, 1U, 1U}));
    // a 0 that lasts two
    EXPECT_FALSE(ReleasesWith({0U, 0U, 1U}));
    EXPECT_TRUE(ReleasesWith(1U));
}

TEST_F(ChannelACycle, TakesTheFirstCallForOneAfterA1)
{
    Verifies(req::SRS_REL_005);
    // One 0 in the first call is not yet a level
    EXPECT_FALSE(ReleasesWith({0U, 1U, 1U, 1U}));
    Start();
    EXPECT_FALSE(ReleasesWith({0U, 0U, 1U}));
    EXPECT_TRUE(ReleasesWith(1U));
}

TEST_F(ChannelACycle, FollowsTheLevelWhileNothingIsActive)
{
    Verifies(req::SRS_REL_005);
    // Given a level of 0 and a first 1 before OPERATIONAL, then the first call in it sees the edge
    device.nmt = NmtState::kPreOperational;
    EXPECT_FALSE(ReleasesWith({0U, 0U, 1U}));
    device.nmt = NmtState::kOperational;
    EXPECT_FALSE(ReleasesWith(1U));
    EXPECT_TRUE(ReleasesWith(1U)) << "with the pair that came then";
    // and an edge before it is forgotten
    Start();
    device.nmt = NmtState::kPreOperational;
    EXPECT_FALSE(ReleasesWith({0U, 0U, 1U, 1U}));
    device.nmt = NmtState::kOperational;
    EXPECT_FALSE(ReleasesWith({1U, 1U, 1U}));
}

TEST_F(ChannelACycle, FollowsTheLevelOfEverySlotApart)
{
    Verifies(req::SRS_REL_005);
    // Given the other slot's input one call ahead, then it is the own one that releases
    EXPECT_FALSE(ReleasesWith({0U, 0U, 2U, 3U}));
    EXPECT_TRUE(ReleasesWith(1U));
}

TEST_F(ChannelACycle, TakesNoFlippedLevelForAnAcknowledge)
{
    Verifies(req::SRS_REL_005);
    Verifies(req::SRS_CONS_024);
    constexpr std::size_t kVoice = sizeof(channel_a::Channel) - sizeof(channel_a::Voice);
    static constexpr std::size_t kMasks[] = {offsetof(channel_a::Voice, reading),
                                             offsetof(channel_a::Voice, high_levels),
                                             offsetof(channel_a::Voice, low_levels)};
    for (const std::size_t mask : kMasks)
    {
        for (std::size_t bit = 0U; bit < 64U; ++bit)
        {
            for (const SrdoMask input : {SrdoMask{0U}, SrdoMask{3U}})
            {
                // Given an input that stands still, when a bit of its level flips
                Start();
                EXPECT_FALSE(ReleasesWith({input, input, input}));
                std::uint8_t& byte = reinterpret_cast<std::uint8_t*>(&device.channel)[kVoice + mask + (bit / 8U)];
                byte = static_cast<std::uint8_t>(byte ^ (1U << (bit % 8U)));
                // Then nothing is released
                EXPECT_FALSE(ReleasesWith({input, input, input, input})) << "mask at " << mask << ", bit " << bit;
                // and an acknowledge still does it
                EXPECT_TRUE(ReleasesWith({0U, 0U, 1U, 1U})) << "mask at " << mask << ", bit " << bit;
            }
        }
    }
}

TEST_F(ChannelACycle, CommitsNoSlotThatThereIsNot)
{
    Verifies(req::SRS_REL_002);
    Verifies(req::SRS_CONS_024);
    constexpr std::size_t kCommitted =
        sizeof(channel_a::Channel) - sizeof(channel_a::Voice) + offsetof(channel_a::Voice, committed);
    for (std::size_t bit = 0U; bit < 64U; ++bit)
    {
        // Given two slots, none of them committed, when a bit of the mask of committed ones flips
        Start();
        static_cast<void>(device.Cycle());
        std::uint8_t& byte = reinterpret_cast<std::uint8_t*>(&device.channel)[kCommitted + (bit / 8U)];
        byte = static_cast<std::uint8_t>(byte ^ (1U << (bit % 8U)));
        device.words[0][0] = 0x77U; // Of the consumer.
        device.words[4][0] = 0x77U; // Of the producer.
        EXPECT_EQ(device.channel.Commit(Agreement{0U, 0U}, 0U), 0U) << "bit " << bit;
        // Then no object of another slot is written, and nothing that is not an object
        EXPECT_EQ(device.words[0][0], (bit == kConsumerSlot) ? 0U : 0x77U) << "bit " << bit;
        EXPECT_TRUE((device.words[4][0] == 0x77U) || (bit == kProducerSlot)) << "bit " << bit;
        EXPECT_TRUE(fenced->IsIntact()) << "bit " << bit;
        EXPECT_EQ(device.channel.Answer(1U).mask, 0U) << "bit " << bit;
    }
}

TEST_F(ChannelACycle, PermitsNoSlotByAFlippedBit)
{
    Verifies(req::SRS_REL_010);
    Verifies(req::SRS_CONS_024);
    constexpr std::size_t kVoice = sizeof(channel_a::Channel) - sizeof(channel_a::Voice);
    constexpr std::size_t kMasks[] = {offsetof(channel_a::Voice, permitted), offsetof(channel_a::Voice, refused)};
    device.setups[0].policy = ReleasePolicy::kAutomatic;
    for (const std::size_t mask : kMasks)
    {
        for (std::size_t bit = 0U; bit < 64U; ++bit)
        {
            std::uint8_t& byte = reinterpret_cast<std::uint8_t*>(&device.channel)[kVoice + mask + (bit / 8U)];
            // Given a released pair and no Commit, when a bit of what is permitted flips, then nothing is permitted
            Start();
            static_cast<void>(device.Cycle());
            device.Pair(8U, 0x11U);
            ASSERT_EQ(device.Cycle().released, kConsumerBit);
            byte = static_cast<std::uint8_t>(byte ^ (1U << (bit % 8U)));
            EXPECT_EQ(device.channel.Answer(1U).mask, 0U) << "mask at " << mask << ", bit " << bit;
            // and behind a Commit the slot of the bit loses its permit until the next one
            device.Commit();
            EXPECT_EQ(device.channel.Answer(1U).mask, kConsumerBit) << "mask at " << mask << ", bit " << bit;
            byte = static_cast<std::uint8_t>(byte ^ (1U << (bit % 8U)));
            EXPECT_EQ(device.channel.Answer(1U).mask, (bit == kConsumerSlot) ? 0U : kConsumerBit)
                << "mask at " << mask << ", bit " << bit;
            static_cast<void>(device.Cycle());
            device.Commit();
            EXPECT_EQ(device.channel.Answer(1U).mask, kConsumerBit) << "mask at " << mask << ", bit " << bit;
        }
    }
}

TEST_F(ChannelACycle, SignalsEveryFaultInTheCallThatReportsIt)
{
    Verifies(req::SRS_CONS_021);
    static_cast<void>(device.Cycle());
    // Given two inverse frames without a normal one, within SCT, in calls one after the other
    for (std::uint32_t time = 0U; time < 2U; ++time)
    {
        device.Frame(0x112U, 8U, 0x11U, true);
        const CycleOutcome outcome = device.Cycle();
        EXPECT_EQ(outcome.new_fault, kConsumerBit);
        EXPECT_EQ(outcome.signalled, kConsumerBit);
        EXPECT_EQ(device.channel.View(kConsumerSlot).signals,
                  std::uint32_t{1U} << static_cast<std::uint32_t>(SrdoCause::kInverseFirst));
    }
    // Then the next call has no signal
    EXPECT_EQ(device.Cycle().signalled, 0U);
    EXPECT_EQ(device.channel.View(kConsumerSlot).signals, 0U);
    // and one after SCT has it again
    static_cast<void>(device.Cycle(60000U));
    device.Frame(0x112U, 8U, 0x11U, true);
    EXPECT_EQ(device.Cycle().signalled, kConsumerBit);
}

TEST_F(ChannelACycle, SignalsEveryFaultOfAProducer)
{
    Verifies(req::SRS_PROD_009);
    Verifies(req::SRS_CONS_021);
    static_cast<void>(device.Cycle());
    for (std::uint32_t time = 0U; time < 2U; ++time)
    {
        device.request = kProducerBit;
        EXPECT_EQ(device.Cycle().due, kProducerBit);
        device.request = 0U;
        ASSERT_EQ(device.channel.Prepare(kProducerSlot).status, PrepareStatus::kReady);
        device.channel.OnTransmitFault(kProducerSlot, TransmitFault{SrdoCause::kTransmitQueue});
        EXPECT_EQ(device.Cycle().signalled & kProducerBit, kProducerBit);
        EXPECT_EQ(device.channel.View(kProducerSlot).signals,
                  std::uint32_t{1U} << static_cast<std::uint32_t>(SrdoCause::kTransmitQueue));
    }
    EXPECT_EQ(device.Cycle().signalled & kProducerBit, 0U);
    EXPECT_EQ(device.channel.View(kProducerSlot).signals, 0U);
}

TEST_F(ChannelACycle, SignalsWaitingPastSctOnce)
{
    Verifies(req::SRS_CONS_022);
    const std::uint32_t waiting = std::uint32_t{1U} << static_cast<std::uint32_t>(SrdoCause::kWaitingPastSct);
    static_cast<void>(device.Cycle());
    EXPECT_EQ(device.Cycle(50000U).signalled & kConsumerBit, 0U);
    EXPECT_EQ(device.Cycle(1U).signalled & kConsumerBit, kConsumerBit);
    EXPECT_EQ(device.channel.View(kConsumerSlot).signals, waiting);
    for (std::uint32_t time = 0U; time < 3U; ++time)
    {
        EXPECT_EQ(device.Cycle(60000U).signalled & kConsumerBit, 0U);
        EXPECT_EQ(device.channel.View(kConsumerSlot).signals, 0U);
    }
}

TEST_F(ChannelACycle, ForgetsAnEdgeThoughTheCounterGoesRound)
{
    Verifies(req::SRS_REL_005);
    Verifies(req::SRS_TIME_001);
    // Given a consumer of which nothing is to be told any more, and an edge without a pair
    for (std::uint32_t time = 0U; time < 4U; ++time)
    {
        static_cast<void>(device.Cycle(60000U));
    }
    device.acknowledge = kConsumerBit;
    static_cast<void>(device.Cycle());
    static_cast<void>(device.Cycle());
    // When the counter has gone round once and a pair comes within the window of the same reading
    for (std::uint32_t step = 0U; step < 16U; ++step)
    {
        static_cast<void>(device.Cycle(0x10000000U));
    }
    device.Pair(8U, 0x11U);
    // Then it is not released
    EXPECT_EQ(device.Cycle().released, 0U);
}

TEST_F(ChannelACycle, LeavesNoSlotInAMaskWithOperational)
{
    Verifies(req::SRS_CONS_023);
    constexpr std::size_t kOutcome =
        sizeof(channel_a::Channel) - sizeof(channel_a::Voice) + offsetof(channel_a::Voice, outcome);
    static constexpr std::size_t kMasks[] = {offsetof(CycleOutcome, released), offsetof(CycleOutcome, faulted),
                                             offsetof(CycleOutcome, waiting)};
    for (const std::size_t mask : kMasks)
    {
        // Given two SRDOs that are off in OPERATIONAL, and a mask that is corrupted so that it has both
        Start();
        device.Store(kConsumerSlot, ConfigField::kMapCount, 0U);
        device.Store(kProducerSlot, ConfigField::kMapCount, 0U);
        static_cast<void>(device.Cycle());
        SrdoMask both = kConsumerBit | kProducerBit;
        std::memcpy(&reinterpret_cast<std::uint8_t*>(&device.channel)[kOutcome + mask], &both, sizeof(both));
        // When OPERATIONAL is left, then no mask has one
        device.nmt = NmtState::kPreOperational;
        const CycleOutcome outcome = device.Cycle();
        EXPECT_EQ(outcome.released | outcome.faulted | outcome.waiting, 0U) << "mask at " << mask;
    }
}

TEST_F(ChannelACycle, HasNoLimitWhereItWaitsHoweverLong)
{
    Verifies(req::SRS_CONS_022);
    static_cast<void>(device.Cycle());
    // Given every bit of the counter set, 1000 + 2147483648 + 2147482647 us after its 0
    static_cast<void>(device.Cycle(2147483648U));
    EXPECT_EQ(device.Cycle(2147482647U).waiting, kConsumerBit);
    EXPECT_EQ(device.clock_us, 0xFFFFFFFFU);
    EXPECT_EQ(device.channel.View(kConsumerSlot).error_count, 0U);
}

// An inverse frame without a normal one, then a pair, both behind the call at 1 ms.
void CompleteBehindAFault(Device& device)
{
    static_cast<void>(device.Cycle());
    device.Frame(0x112U, 8U, 0x11U, true);
    device.Pair(8U, 0x21U);
}

std::uint32_t BitOf(SrdoCause cause)
{
    return std::uint32_t{1U} << static_cast<std::uint32_t>(cause);
}

// t       1000              61000                    61000    62000       111000     111001
//         fault, a pair     the fault alone is told  a pair   released    in time    SCT
TEST_F(ChannelACycle, HasNoSctForAPairBehindAFault)
{
    Verifies(req::SRS_CONS_013);
    Verifies(req::SRS_CONS_014);
    device.setups[0].policy = ReleasePolicy::kAutomatic;
    Start();
    // Given a pair behind a fault, which counts
    CompleteBehindAFault(device);
    EXPECT_EQ(device.channel.Held(kConsumerSlot).ordinal, 1U);
    // When the call that tells the fault comes later than SCT
    const CycleOutcome told = device.Cycle(60000U);
    // Then that is the only cause, and the pair is gone
    EXPECT_EQ(told.new_fault, kConsumerBit);
    EXPECT_EQ(told.faulted, kConsumerBit);
    EXPECT_EQ(told.ordinal_sum, 0U);
    EXPECT_EQ(device.channel.View(kConsumerSlot).signals, BitOf(SrdoCause::kInverseFirst));
    EXPECT_EQ(device.channel.View(kConsumerSlot).error_count, 1U);
    EXPECT_EQ(device.channel.Held(kConsumerSlot).holds_pair, 0U);
    // and of the next pair SCT runs
    device.Pair(8U, 0x31U);
    EXPECT_EQ(device.Cycle().released, kConsumerBit);
    EXPECT_EQ(device.Cycle(49000U).released, kConsumerBit);
    EXPECT_EQ(device.Cycle(1U).new_fault, kConsumerBit);
    EXPECT_EQ(device.channel.View(kConsumerSlot).signals, BitOf(SrdoCause::kSct));
}

// t       1000              61000                      62000              62000
//         fault, a pair     normal frame, no limit     fault is told      its inverse frame
TEST_F(ChannelACycle, HasNoSctAtAFrameForAPairBehindAFault)
{
    Verifies(req::SRS_CONS_013);
    Verifies(req::SRS_CONS_003);
    device.setups[0].policy = ReleasePolicy::kAutomatic;
    Start();
    CompleteBehindAFault(device);
    // When the next normal frame comes later than SCT, before the call that tells the fault
    device.clock_us = 61000U;
    device.Frame(0x111U, 8U, 0x31U);
    EXPECT_EQ(device.channel.View(kConsumerSlot).error_count, 1U);
    EXPECT_EQ(device.channel.Held(kConsumerSlot).ordinal, 1U);
    // Then the fault alone is told, and the frame stays pending
    EXPECT_EQ(device.Cycle().new_fault, kConsumerBit);
    EXPECT_EQ(device.channel.View(kConsumerSlot).signals, BitOf(SrdoCause::kInverseFirst));
    device.Frame(0x112U, 8U, 0x31U, true);
    EXPECT_EQ(device.channel.Held(kConsumerSlot).ordinal, 1U);
    EXPECT_EQ(device.Cycle().released, kConsumerBit);
    EXPECT_EQ(device.channel.View(kConsumerSlot).error_count, 1U);
}

TEST_F(ChannelACycle, HasSrvtForAFrameBehindAFault)
{
    Verifies(req::SRS_CONS_014);
    Verifies(req::SRS_CONS_013);
    // Given a fault, a pair and half of the next one, in calls that are SRVT apart, then a microsecond more
    for (const std::uint32_t elapsed_us : {20000U, 20001U})
    {
        Start();
        CompleteBehindAFault(device);
        device.Frame(0x111U, 8U, 0x31U);
        EXPECT_EQ(device.Cycle(elapsed_us).new_fault, kConsumerBit);
        EXPECT_EQ(device.channel.View(kConsumerSlot).error_count, (elapsed_us == 20000U) ? 1U : 2U);
    }
    EXPECT_EQ(device.channel.View(kConsumerSlot).signals, BitOf(SrdoCause::kInverseFirst) | BitOf(SrdoCause::kSrvt));
}

// t       1000                                 61000                     61000
//         fault, a pair, half of the next      the fault alone is told   inverse frame: later than SRVT
TEST_F(ChannelACycle, HasNoSctBehindAFaultWithLateDetection)
{
    Verifies(req::SRS_CONS_013);
    Verifies(req::SRS_TIME_009);
    device.setups[0].detection = SrvtDetection::kLate;
    Start();
    CompleteBehindAFault(device);
    device.Frame(0x111U, 8U, 0x31U);
    // When the call comes later than SCT of the pair, then it discards no pending frame
    EXPECT_EQ(device.Cycle(60000U).new_fault, kConsumerBit);
    EXPECT_EQ(device.channel.View(kConsumerSlot).signals, BitOf(SrdoCause::kInverseFirst));
    EXPECT_EQ(device.channel.View(kConsumerSlot).error_count, 1U);
    device.Frame(0x112U, 8U, 0x31U, true);
    EXPECT_EQ(device.Cycle().new_fault, kConsumerBit);
    EXPECT_EQ(device.channel.View(kConsumerSlot).signals, BitOf(SrdoCause::kSrvt) | BitOf(SrdoCause::kInverseFirst));
}

TEST_F(ChannelACycle, TellsALateCallBesideAPairBehindAFault)
{
    Verifies(req::SRS_CONS_015);
    Verifies(req::SRS_CONS_013);
    device.config.cycle_tolerance_us = 500U;
    Start();
    CompleteBehindAFault(device);
    // Where no limit runs, none has expired in a late call
    EXPECT_EQ(device.Cycle(60000U).new_fault, kConsumerBit);
    EXPECT_EQ(device.channel.View(kConsumerSlot).signals,
              BitOf(SrdoCause::kInverseFirst) | BitOf(SrdoCause::kLateCall));
}

TEST_F(ChannelACycle, ServesAtSctThoughAFlippedBitSaysThatAFaultCameBefore)
{
    Verifies(req::SRS_CONS_014);
    Verifies(req::SRS_CONS_024);
    device.setups[0].policy = ReleasePolicy::kAutomatic;
    for (std::uint32_t bit = 0U; bit < 32U; ++bit)
    {
        // Given a released pair of 1 ms and a bit of what is not told yet that flips, when the next pair comes at 2 ms
        Release(device);
        ASSERT_EQ(device.channel.View(kConsumerSlot).state, SrdoState::kReleased) << "bit " << bit;
        fenced->fence.storage.records[kConsumerSlot].unreported = std::uint32_t{1U} << bit;
        device.Pair(8U, 0x21U);
        // Then the consumer is safe when SCT of that is over
        EXPECT_EQ(device.Cycle(50001U).released, 0U) << "bit " << bit;
    }
}

} // namespace
} // namespace counterpoint::channel_a_test
