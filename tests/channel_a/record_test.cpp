// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What channel A makes of a corrupted record, of a pair that waited for a whole round of the counter, and of what an
// earlier start left behind.
#include "tests/channel_a/device.hpp"
#include "verification/conformance/hash.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace counterpoint::channel_a_test
{
namespace
{

constexpr std::uint32_t kBitOfInvalid = 1U; // Bit of cause 0.

void Release(Device& device)
{
    device.clock_us = 0U;
    device.nmt = NmtState::kOperational;
    device.Start();
    static_cast<void>(device.Cycle());
    device.Pair(8U, 0x11U);
    static_cast<void>(device.Cycle());
    device.Commit();
}

TEST(ChannelARecord, OfAConsumerThatIsCorruptedIsFaultedUntilRestart)
{
    Verifies(req::SRS_CONS_024);
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    std::uint32_t found = 0U;
    for (std::size_t bit = 0U; bit < (8U * FencedDevice::kByteCount); ++bit)
    {
        // Given a released consumer, when a bit flips that makes its record look corrupted
        Release(device);
        ASSERT_EQ(device.channel.View(kConsumerSlot).state, SrdoState::kReleased);
        std::uint8_t& byte = fenced->Bytes()[bit / 8U];
        byte = static_cast<std::uint8_t>(byte ^ (1U << (bit % 8U)));
        if (device.channel.View(kConsumerSlot).state != SrdoState::kFaulted)
        {
            continue;
        }
        found += 1U;
        // Then the next cycle reports the fault, and every other one, whatever comes in between
        for (std::uint32_t cycle = 0U; cycle < 3U; ++cycle)
        {
            const CycleOutcome outcome = device.Cycle();
            EXPECT_EQ(outcome.released, 0U) << "bit " << bit;
            EXPECT_EQ(outcome.faulted, kConsumerBit) << "bit " << bit;
            EXPECT_EQ(outcome.new_fault, kConsumerBit) << "bit " << bit;
            if (cycle == 0U)
            {
                EXPECT_EQ(outcome.signalled & kConsumerBit, kConsumerBit) << "bit " << bit;
                EXPECT_EQ(device.channel.View(kConsumerSlot).signals & kBitOfInvalid, kBitOfInvalid) << "bit " << bit;
            }
            EXPECT_EQ(device.channel.View(kConsumerSlot).state, SrdoState::kFaulted) << "bit " << bit;
            device.Commit();
            EXPECT_EQ(device.channel.Answer(1U).mask, 0U) << "bit " << bit;
            EXPECT_EQ(device.words[0][0], 0U) << "bit " << bit;
            device.Pair(8U, 0x21U);
        }
        // and it does not become active again
        device.nmt = NmtState::kPreOperational;
        static_cast<void>(device.Cycle());
        device.nmt = NmtState::kOperational;
        const CycleOutcome outcome = device.Cycle();
        EXPECT_EQ(outcome.released | outcome.waiting, 0U) << "bit " << bit;
    }
    EXPECT_GE(found, 64U) << "every grant was among the bits";
    EXPECT_TRUE(fenced->IsIntact());
}

TEST(ChannelARecord, OfAProducerThatIsCorruptedSendsNothing)
{
    Verifies(req::SRS_CONS_024);
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    std::uint32_t found = 0U;
    for (std::size_t bit = 0U; bit < (8U * FencedDevice::kByteCount); ++bit)
    {
        Release(device);
        ASSERT_EQ(device.channel.View(kProducerSlot).state, SrdoState::kProducer);
        std::uint8_t& byte = fenced->Bytes()[bit / 8U];
        byte = static_cast<std::uint8_t>(byte ^ (1U << (bit % 8U)));
        if (device.channel.View(kProducerSlot).state != SrdoState::kFaulted)
        {
            continue;
        }
        found += 1U;
        device.request = kProducerBit;
        const CycleOutcome outcome = device.Cycle();
        EXPECT_EQ(outcome.due, 0U) << "bit " << bit;
        EXPECT_EQ(outcome.signalled & kProducerBit, kProducerBit) << "bit " << bit;
        EXPECT_EQ(device.channel.View(kProducerSlot).signals, kBitOfInvalid) << "bit " << bit;
        EXPECT_EQ(device.Cycle().due, 0U) << "bit " << bit;
        device.request = 0U;
        EXPECT_EQ(device.channel.Prepare(kProducerSlot).status, PrepareStatus::kNotProducer) << "bit " << bit;
    }
    EXPECT_GE(found, 64U);
}

// Flips each bit of so many bytes in turn and counts those after which a recheck of the consumer finds its table wrong.
std::uint32_t FoundByRecheck(Device& device, std::uint8_t* bytes, std::size_t count)
{
    std::uint32_t found = 0U;
    for (std::size_t bit = 0U; bit < (8U * count); ++bit)
    {
        std::uint8_t& byte = bytes[bit / 8U];
        const std::uint8_t before = byte;
        byte = static_cast<std::uint8_t>(byte ^ (1U << (bit % 8U)));
        found += (device.channel.Recheck(kConsumerSlot).fault == ConfigFault::kTable) ? 1U : 0U;
        byte = before;
    }
    return found;
}

TEST(ChannelARecord, OfAMappingThatIsCorruptedIsFoundByTheRecheck)
{
    Verifies(req::SRS_CFG_030);
    // Given an SRDO with a resolved mapping
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    device.Start();
    ASSERT_EQ(device.channel.Recheck(kConsumerSlot).fault, ConfigFault::kNone);
    // When a bit flips of what was worked out of it, then the recheck finds each
    channel_a::Record& record = fenced->fence.storage.records[kConsumerSlot];
    std::uint8_t* const grants = record.grants.values.at;
    EXPECT_EQ(FoundByRecheck(device, record.mapped.at, 8U), 64U);
    EXPECT_EQ(FoundByRecheck(device, &record.spare_bits, 1U), 8U);
    EXPECT_EQ(FoundByRecheck(device, &record.total_bits, 1U), 8U);
    EXPECT_EQ(FoundByRecheck(device, &grants[static_cast<std::size_t>(channel_a::Grant::kLength)], 1U), 8U);
    EXPECT_EQ(FoundByRecheck(device, &grants[static_cast<std::size_t>(channel_a::Grant::kResolved)], 1U), 8U);
    EXPECT_EQ(FoundByRecheck(device, &fenced->fence.storage.steps[0].first_bit, 1U), 8U);
    // and nothing when all is as it was
    EXPECT_EQ(device.channel.Recheck(kConsumerSlot).fault, ConfigFault::kNone);
}

TEST(ChannelARecord, OfAFullMappingLeavesThatOfTheNextSlotAlone)
{
    Verifies(req::SRS_CFG_030);
    // Given room for four entries, and two SRDOs that need all of it
    const auto storage = std::make_unique<channel_a::StorageFor<kSlotCount, 4U>>();
    Device device{storage->Handle()};
    device.config.map_entries = 4U;
    device.Start();
    ASSERT_EQ(device.channel.Recheck(kProducerSlot).fault, ConfigFault::kNone);
    // When the first one is validated again, then the mapping of the second is what it was
    EXPECT_EQ(device.channel.Validate(kConsumerSlot).fault, ConfigFault::kNone);
    EXPECT_EQ(device.channel.Recheck(kProducerSlot).fault, ConfigFault::kNone);
}

TEST(ChannelARecord, OfALatePairDoesNotComeIntoTimeAgainWithTheCounter)
{
    Verifies(req::SRS_TIME_009);
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    device.setups[0].detection = SrvtDetection::kLate;
    device.Start();
    static_cast<void>(device.Cycle());
    // Given a normal frame, and calls until the counter has gone round (71 minutes) once
    const std::uint32_t begin_us = device.clock_us;
    device.Frame(0x111U, 8U, 0x11U);
    for (std::uint32_t step = 0U; step < 16U; ++step)
    {
        static_cast<void>(device.Cycle(0x10000000U));
    }
    ASSERT_EQ(device.clock_us, begin_us);
    // When its inverse frame comes then, or within SRVT of the same reading
    device.clock_us += kSrvtUs;
    device.Frame(0x112U, 8U, 0x11U, true);
    // Then it is late
    EXPECT_EQ(device.channel.View(kConsumerSlot).state, SrdoState::kFaulted);
    EXPECT_EQ(device.channel.View(kConsumerSlot).first_cause, SrdoCause::kSrvt);
    EXPECT_EQ(device.Cycle().released, 0U);
}

TEST(ChannelARecord, OfOneProducerStandsAlone)
{
    Verifies(req::SRS_PROD_012);
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    device.setups[kProducerSlot].form = ProducerForm::kProviderCalled;
    Release(device);
    static_cast<void>(device.channel.Prepare(kProducerSlot));
    device.channel.OnTransmitFault(kProducerSlot, TransmitFault{SrdoCause::kTransmitQueue});
    // Given the first refresh at 1.5 ms, seen at 2 ms, when the phase stands still for a cycle
    device.stand = kProducerBit;
    static_cast<void>(device.Cycle());
    device.stand = 0U;
    // Then the next refresh is due 51 ms after the first one
    EXPECT_EQ(device.Cycle(49000U).due, 0U);
    EXPECT_EQ(device.Cycle(500U).due, kProducerBit);
}

// A start with another mapping, a release, a pair in flight, faults and an acknowledge: whatever leaves something.
std::uint32_t Trace(Device& device)
{
    conformance::Hash hash;
    device.clock_us = 0U;
    device.acknowledge = 0U;
    device.nmt = NmtState::kOperational;
    device.channel.Restart(device.config);
    hash.AddOutcome(device.Cycle());
    for (SlotIndex slot = 0U; slot < kSlotCount; ++slot)
    {
        hash.AddView(device.channel.View(slot));
        hash.Add(static_cast<std::uint32_t>(device.channel.Validate(slot).fault));
        for (std::uint8_t sub = 1U; sub <= 16U; ++sub)
        {
            hash.Add(device.channel.Load(ConfigAddress{slot, ConfigField::kMapEntry, sub}).value);
        }
    }
    device.Configure(kConsumerSlot, kDirectionConsumer, 0x111U, kConsumed);
    device.Map(kConsumerSlot, kConsumed, 2U);
    hash.Add(static_cast<std::uint32_t>(device.Sign(kConsumerSlot).fault));
    device.Configure(kProducerSlot, kDirectionProducer, 0x101U, kSent);
    device.Store(kNoSlot, ConfigField::kConfigurationValid, 0xA5U);
    for (std::uint32_t round = 0U; round < 4U; ++round)
    {
        device.request = (round == 1U) ? kProducerBit : 0U;
        hash.AddOutcome(device.Cycle());
        hash.AddView(device.channel.View(kConsumerSlot));
        hash.AddView(device.channel.View(kProducerSlot));
        device.Commit();
        hash.Add(device.channel.Answer(round).response);
        device.Pair(4U, 0x11U);
        hash.Add(static_cast<std::uint32_t>(device.channel.Prepare(kProducerSlot).status));
    }
    device.acknowledge = kConsumerBit;
    device.Frame(0x112U, 4U, 0x11U, true);
    hash.AddOutcome(device.Cycle());
    device.Frame(0x111U, 4U, 0x11U);
    return hash.Value();
}

TEST(ChannelARecord, OfAStartBeforeIsForgottenByRestart)
{
    Verifies(req::SRS_CFG_002);
    Verifies(req::SRS_CFG_020);
    // Given memory full of anything, then the first start is as every other one, and nothing else is written
    std::uint32_t first = 0U;
    for (const std::uint8_t fill : {std::uint8_t{0U}, std::uint8_t{0xFFU}, std::uint8_t{0xA6U}})
    {
        const auto fenced = std::make_unique<FencedDevice>();
        for (std::size_t place = 0U; place < FencedDevice::kByteCount; ++place)
        {
            fenced->Bytes()[place] = fill;
        }
        first = (first == 0U) ? Trace(fenced->device) : first;
        EXPECT_EQ(Trace(fenced->device), first);
        EXPECT_EQ(Trace(fenced->device), first);
        EXPECT_TRUE(fenced->IsIntact());
    }
}

} // namespace
} // namespace counterpoint::channel_a_test
