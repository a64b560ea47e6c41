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
    std::uint8_t* const beside = record.grants.complements.at;
    EXPECT_EQ(FoundByRecheck(device, &beside[static_cast<std::size_t>(channel_a::Grant::kLength)], 1U), 8U);
    EXPECT_EQ(FoundByRecheck(device, &beside[static_cast<std::size_t>(channel_a::Grant::kResolved)], 1U), 8U);
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

channel_a::Record& RecordOf(FencedDevice& fenced, SlotIndex slot)
{
    return fenced.fence.storage.records[slot];
}

// Flips a bit of what stands beside a grant.
void Corrupt(channel_a::Record& record, channel_a::Grant grant)
{
    std::uint8_t& beside = record.grants.complements.at[static_cast<std::size_t>(grant)];
    beside = static_cast<std::uint8_t>(beside ^ 1U);
}

void SetState(channel_a::Record& record, std::uint8_t state)
{
    record.grants.Set(channel_a::Grant::kState, state);
}

// Both slots as consumers of one object of four bytes: 111h and 112h, 101h and 102h.
void MakeTwoConsumers(Device& device)
{
    device.Store(kProducerSlot, ConfigField::kDirection, kDirectionConsumer);
    device.Map(kConsumerSlot, &kConsumed[0], 2U);
    device.Map(kProducerSlot, &kConsumed[2], 2U);
    ASSERT_EQ(device.Sign(kConsumerSlot).fault, ConfigFault::kNone);
    ASSERT_EQ(device.Sign(kProducerSlot).fault, ConfigFault::kNone);
}

void ReleaseTwoConsumers(Device& device)
{
    device.Start();
    MakeTwoConsumers(device);
    static_cast<void>(device.Cycle());
    device.Pair(4U, 0x11U);
    device.Frame(0x101U, 4U, 0x21U);
    device.Frame(0x102U, 4U, 0x21U, true);
    ASSERT_EQ(device.Cycle().released, kConsumerBit | kProducerBit);
    ASSERT_EQ(device.channel.Commit(Agreement{3U, 3U}, 0U), 0U);
}

TEST(ChannelARecord, OfEveryFlippedGrantIsCorrupted)
{
    Verifies(req::SRS_CONS_024);
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    for (std::size_t bit = 0U; bit < 64U; ++bit)
    {
        // Given a released consumer, when any bit of a grant flips, or of what stands beside it, then it grants nothing
        Release(device);
        channel_a::Grants& grants = RecordOf(*fenced, kConsumerSlot).grants;
        const std::uint8_t flip = static_cast<std::uint8_t>(1U << (bit % 8U));
        grants.values.at[bit / 8U] = static_cast<std::uint8_t>(grants.values.at[bit / 8U] ^ flip);
        EXPECT_EQ(device.channel.View(kConsumerSlot).state, SrdoState::kFaulted) << "bit " << bit;
        grants.values.at[bit / 8U] = static_cast<std::uint8_t>(grants.values.at[bit / 8U] ^ flip);
        ASSERT_EQ(device.channel.View(kConsumerSlot).state, SrdoState::kReleased) << "bit " << bit;
        grants.complements.at[bit / 8U] = static_cast<std::uint8_t>(grants.complements.at[bit / 8U] ^ flip);
        EXPECT_EQ(device.channel.View(kConsumerSlot).state, SrdoState::kFaulted) << "bit " << bit;
        EXPECT_EQ(device.Cycle().released, 0U) << "bit " << bit;
    }
}

TEST(ChannelARecord, OfOneSlotThatIsCorruptedLeavesTheOtherAlone)
{
    Verifies(req::SRS_CONS_024);
    Verifies(req::SRS_CONS_023);
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    // Given a released consumer in slot 0 with its second pair, when the record of the producer in slot 1 is corrupted
    Release(device);
    device.Pair(8U, 0x21U);
    Corrupt(RecordOf(*fenced, kProducerSlot), channel_a::Grant::kLength);
    const CycleOutcome outcome = device.Cycle();
    // Then slot 1 alone is at fault
    EXPECT_EQ(outcome.released, kConsumerBit);
    EXPECT_EQ(outcome.faulted, kProducerBit);
    EXPECT_EQ(outcome.new_fault, kProducerBit);
    EXPECT_EQ(outcome.fresh, kConsumerBit);
    EXPECT_EQ(outcome.ordinal_sum, 2U);
    EXPECT_EQ(device.channel.View(kConsumerSlot).ordinal, 2U);
}

TEST(ChannelARecord, OfAConsumerThatIsCorruptedHoldsNothing)
{
    Verifies(req::SRS_CONS_024);
    Verifies(req::SRS_CONS_025);
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    for (const channel_a::Grant grant : {channel_a::Grant::kState, channel_a::Grant::kLength})
    {
        Release(device);
        Corrupt(RecordOf(*fenced, kConsumerSlot), grant);
        if (grant == channel_a::Grant::kState)
        {
            EXPECT_EQ(device.channel.Held(kConsumerSlot).holds_pair, 0U) << "before the next cycle";
        }
        EXPECT_EQ(device.Cycle().ordinal_sum, 0U);
        const SrdoView view = device.channel.View(kConsumerSlot);
        EXPECT_EQ(view.ordinal, 0U);
        EXPECT_EQ(view.data.low | view.data.high, 0U);
        EXPECT_EQ(view.holds_pair, 0U);
        EXPECT_EQ(device.channel.Held(kConsumerSlot).holds_pair, 0U);
    }
}

TEST(ChannelARecord, OfAStateThatIsNoneIsCorrupted)
{
    Verifies(req::SRS_CONS_024);
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    for (const std::uint8_t value : {std::uint8_t{15U}, std::uint8_t{16U}, std::uint8_t{0xFFU}})
    {
        // Given a value behind the last state, beside its complement, then nothing is held or released
        Release(device);
        SetState(RecordOf(*fenced, kConsumerSlot), value);
        EXPECT_EQ(device.channel.View(kConsumerSlot).state, SrdoState::kFaulted);
        EXPECT_EQ(device.channel.Held(kConsumerSlot).holds_pair, 0U);
        // and it is told when SCT is over
        const CycleOutcome outcome = device.Cycle(kSctUs);
        EXPECT_EQ(outcome.released, 0U);
        EXPECT_EQ(outcome.faulted, kConsumerBit);
    }
}

TEST(ChannelARecord, OfAStateThatNothingActiveHasDoesNotEnterOperational)
{
    Verifies(req::SRS_CONS_024);
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    // Given states of active SRDOs while nothing is active, each beside its complement
    device.nmt = NmtState::kPreOperational;
    device.Start();
    static_cast<void>(device.Cycle());
    SetState(RecordOf(*fenced, kConsumerSlot), static_cast<std::uint8_t>(channel_a::State::kReleasedHeld));
    SetState(RecordOf(*fenced, kProducerSlot), static_cast<std::uint8_t>(channel_a::State::kInverseAwaited));
    // When OPERATIONAL is entered, then neither becomes active
    device.nmt = NmtState::kOperational;
    const CycleOutcome outcome = device.Cycle();
    EXPECT_EQ(outcome.released | outcome.waiting, 0U);
    EXPECT_EQ(device.channel.View(kConsumerSlot).state, SrdoState::kFaulted);
    EXPECT_EQ(device.channel.View(kProducerSlot).state, SrdoState::kFaulted);
    EXPECT_EQ(device.channel.Prepare(kProducerSlot).status, PrepareStatus::kNotProducer);
}

TEST(ChannelARecord, OfAnSrdoThatIsOffIsCorruptedUntilRestart)
{
    Verifies(req::SRS_CONS_024);
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    device.nmt = NmtState::kPreOperational;
    device.Start();
    static_cast<void>(device.Cycle());
    // Given a record that is corrupted while nothing is active, then no mask shows it and nobody is told
    Corrupt(RecordOf(*fenced, kConsumerSlot), channel_a::Grant::kLength);
    const CycleOutcome outcome = device.Cycle();
    EXPECT_EQ(outcome.faulted | outcome.new_fault | outcome.signalled, 0U);
    EXPECT_EQ(device.channel.View(kConsumerSlot).error_count, 0U);
    // When the bit flips back and the slot is validated, then it stays corrupted
    Corrupt(RecordOf(*fenced, kConsumerSlot), channel_a::Grant::kLength);
    EXPECT_EQ(device.channel.View(kConsumerSlot).state, SrdoState::kFaulted);
    static_cast<void>(device.Sign(kConsumerSlot));
    EXPECT_EQ(device.channel.View(kConsumerSlot).state, SrdoState::kFaulted);
    // and does not become active
    device.nmt = NmtState::kOperational;
    EXPECT_EQ(device.Cycle().waiting, 0U);
    EXPECT_EQ(device.channel.View(kConsumerSlot).state, SrdoState::kFaulted);
}

TEST(ChannelARecord, OfAWrongOrdinalIsForgottenWithOperational)
{
    Verifies(req::SRS_CONS_023);
    Verifies(req::SRS_CONS_025);
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    // Given an ordinal of 1 that has become 3
    Release(device);
    RecordOf(*fenced, kConsumerSlot).ordinal = 3U;
    RecordOf(*fenced, kProducerSlot).ordinal = 3U;
    // When OPERATIONAL is left and entered, then each begins with 0, and so does their sum
    device.nmt = NmtState::kPreOperational;
    static_cast<void>(device.Cycle());
    EXPECT_EQ(device.channel.View(kProducerSlot).ordinal, 0U);
    device.nmt = NmtState::kOperational;
    EXPECT_EQ(device.Cycle().ordinal_sum, 0U);
    EXPECT_EQ(device.channel.View(kConsumerSlot).ordinal, 0U);
}

TEST(ChannelARecord, OfAConsumerInAnySlotReportsThatOperationalIsLeft)
{
    Verifies(req::SRS_CONS_019);
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    ReleaseTwoConsumers(device);
    device.nmt = NmtState::kPreOperational;
    EXPECT_EQ(device.Cycle().new_fault, kConsumerBit | kProducerBit);
}

TEST(ChannelARecord, OfAProducerThatBecomesAConsumerHasNoLimitOfBefore)
{
    Verifies(req::SRS_CONS_022);
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    device.setups[kProducerSlot].form = ProducerForm::kProviderCalled;
    // Given a producer that was called, which is made a consumer outside OPERATIONAL
    Release(device);
    device.nmt = NmtState::kPreOperational;
    static_cast<void>(device.Cycle());
    MakeTwoConsumers(device);
    static_cast<void>(device.Cycle(60000U));
    // When OPERATIONAL is entered more than SCT after it was left, then it waits
    device.nmt = NmtState::kOperational;
    EXPECT_EQ(device.Cycle().waiting, kConsumerBit | kProducerBit);
    EXPECT_EQ(device.channel.View(kProducerSlot).error_count, 0U);
}

TEST(ChannelARecord, OfAValidatedConsumerLosesItsOwnPermitAlone)
{
    Verifies(req::SRS_REL_002);
    Verifies(req::SRS_REL_010);
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    ReleaseTwoConsumers(device);
    ASSERT_EQ(device.channel.Answer(1U).mask, kConsumerBit | kProducerBit);
    // When slot 1 is validated, which writes its safe value, then slot 0 keeps its permit
    ASSERT_EQ(device.channel.Validate(kProducerSlot).fault, ConfigFault::kNone);
    EXPECT_EQ(device.channel.Answer(1U).mask, kConsumerBit);
}

TEST(ChannelARecord, OfAnObjectThatWasOverwrittenNamesItsSlot)
{
    Verifies(req::SRS_REL_011);
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    ReleaseTwoConsumers(device);
    device.words[1][0] = 0U;
    static_cast<void>(device.Cycle());
    EXPECT_EQ(device.channel.Commit(Agreement{3U, 3U}, 3U), kProducerBit);
}

TEST(ChannelARecord, OfAPairBehindTheCycleIsWrittenBesideTheOneBefore)
{
    Verifies(req::SRS_REL_002);
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    device.Start();
    static_cast<void>(device.Cycle());
    // Given a pair that was not written yet, when another one comes behind the cycle, then Commit writes it
    device.Pair(8U, 0x11U);
    ASSERT_EQ(device.Cycle().released, kConsumerBit);
    device.Pair(8U, 0x21U);
    device.Commit();
    EXPECT_EQ(device.words[0][0], 0x21U);
    EXPECT_EQ(device.channel.Answer(1U).mask, kConsumerBit);
}

TEST(ChannelARecord, OfALateFrameIsWatchedThoughNothingElseIsToBeDone)
{
    Verifies(req::SRS_TIME_009);
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    device.setups[0].detection = SrvtDetection::kLate;
    device.Start();
    static_cast<void>(device.Cycle());
    // Given a consumer whose waiting past SCT has been told, and a normal frame
    for (std::uint32_t time = 0U; time < 3U; ++time)
    {
        static_cast<void>(device.Cycle(60000U));
    }
    const std::uint32_t begin_us = device.clock_us;
    device.Frame(0x111U, 8U, 0x11U);
    // When the counter has gone round once
    for (std::uint32_t step = 0U; step < 16U; ++step)
    {
        static_cast<void>(device.Cycle(0x10000000U));
    }
    ASSERT_EQ(device.clock_us, begin_us);
    // Then its inverse frame is late
    device.Frame(0x112U, 8U, 0x11U, true);
    EXPECT_EQ(device.channel.View(kConsumerSlot).first_cause, SrdoCause::kSrvt);
    EXPECT_EQ(device.Cycle().released, 0U);
}

TEST(ChannelARecord, BehindTheLastSlotIsNobodys)
{
    Verifies(req::SRS_CFG_003);
    Verifies(req::SRS_CONS_024);
    // Given room for three SRDOs, a device with two, and a third record that awaits 101h
    const auto storage = std::make_unique<channel_a::StorageFor<3U>>();
    Device device{storage->Handle()};
    device.Start();
    device.Store(kNoSlot, ConfigField::kGfcParameter, 1U);
    static_cast<void>(device.Cycle());
    channel_a::Record& behind = storage->records[2];
    behind = storage->records[kProducerSlot];
    SetState(behind, static_cast<std::uint8_t>(channel_a::State::kNormalAwaited));
    behind.frame_since = Instant{device.clock_us};
    behind.held = channel_a::Bytes{{0U, 1U, 2U, 3U, 4U, 5U, 6U, 7U}};
    behind.todo = 0x80U;
    // When a value is stored for it, a GFC concerns every slot, and a corrupted look-up leads to it
    device.Store(2U, ConfigField::kSct, 7U);
    device.Frame(0x001U, 0U, 0U);
    static_cast<void>(device.Cycle());
    storage->look_up[0x101U % channel_a::kLookUpSize] = 2U;
    const Confirmation confirmation =
        device.channel.OnConfirm(Device::FrameOf(0x101U, 8U, 0U, false), Instant{device.clock_us});
    // Then it is left alone, and confirms nothing
    EXPECT_EQ(device.channel.View(kConsumerSlot).first_cause, SrdoCause::kGfc);
    EXPECT_EQ(behind.values.sct_ms, 50U);
    EXPECT_EQ(behind.todo, 0x80U);
    EXPECT_EQ(confirmation.step, ConfirmStep::kNone);
    EXPECT_EQ(confirmation.slot, kNoSlot);
}

TEST(ChannelARecord, LookUpEndsWithTheLastIdentifier)
{
    Verifies(req::SRS_CONS_001);
    // Given a look-up before a byte that nobody may write, when OPERATIONAL is entered
    const auto storage = std::make_unique<channel_a::StorageFor<kSlotCount>>();
    std::uint8_t look_up[channel_a::kLookUpSize + 1U] = {};
    look_up[channel_a::kLookUpSize] = 0xC3U;
    channel_a::Storage handle = storage->Handle();
    handle.look_up = look_up;
    Device device{handle};
    device.Start();
    static_cast<void>(device.Cycle());
    // Then every identifier has its place, and no other one is written
    EXPECT_EQ(look_up[0x111U % channel_a::kLookUpSize], kConsumerSlot);
    EXPECT_EQ(look_up[0x102U % channel_a::kLookUpSize], kProducerSlot);
    EXPECT_EQ(look_up[channel_a::kLookUpSize - 1U], kNoSlot);
    EXPECT_EQ(look_up[channel_a::kLookUpSize], 0xC3U);
}

} // namespace
} // namespace counterpoint::channel_a_test
