// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What channel A resolves when a mapping is validated, and what it still knows of the mapping before.
#include "tests/channel_a/device.hpp"
#include "verification/conformance/static_row.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>

namespace counterpoint::channel_a_test
{
namespace
{

TEST(ChannelAMapping, OfOneObjectWritesNoOtherAfterOneOfTwo)
{
    Verifies(req::SRS_REL_002);
    Verifies(req::SRS_CFG_036);
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    // Given a mapping of two words that is then one of a word
    device.Start();
    device.Map(kConsumerSlot, kConsumed, 2U);
    ASSERT_EQ(device.Sign(kConsumerSlot).fault, ConfigFault::kNone);
    const std::uint8_t before[4] = {9U, 9U, 9U, 9U};
    std::memcpy(device.words[1], before, sizeof(before));
    // When a pair is released
    static_cast<void>(device.Cycle());
    device.Pair(4U, 0x11U);
    ASSERT_EQ(device.Cycle().released, kConsumerBit);
    device.Commit();
    // Then the first object has it, and the second one is left alone
    const std::uint8_t written[4] = {0x11U, 0x12U, 0x13U, 0x14U};
    EXPECT_EQ(std::memcmp(device.words[0], written, sizeof(written)), 0);
    EXPECT_EQ(std::memcmp(device.words[1], before, sizeof(before)), 0);
    // and a frame of the old length is none of it
    device.Pair(8U, 0x11U);
    EXPECT_EQ(device.channel.View(kConsumerSlot).state, SrdoState::kFaulted);
    EXPECT_EQ(device.channel.View(kConsumerSlot).first_cause, SrdoCause::kLength);
}

TEST(ChannelAMapping, OfOneObjectSendsNoOtherAfterOneOfTwo)
{
    Verifies(req::SRS_PROD_005);
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    device.Start();
    device.Map(kProducerSlot, kSent, 2U);
    ASSERT_EQ(device.Sign(kProducerSlot).fault, ConfigFault::kNone);
    std::memset(device.words[4], 0x21, 4U);
    std::memset(device.words[5], 0x77, 4U);
    static_cast<void>(device.Cycle());
    static_cast<void>(device.Cycle());
    const PreparedPair pair = device.channel.Prepare(kProducerSlot);
    const std::uint8_t sent[8] = {0x21U, 0x21U, 0x21U, 0x21U, 0U, 0U, 0U, 0U};
    EXPECT_EQ(pair.status, PrepareStatus::kReady);
    EXPECT_EQ(pair.normal.length_bytes, 4U);
    EXPECT_EQ(std::memcmp(pair.normal.data, sent, sizeof(sent)), 0);
}

// What a device does with a released pair and a pair to send.
struct Acts
{
    std::uint8_t written[8][4];
    CanFrame sent;

    [[nodiscard]] bool IsSame(const Acts& other) const
    {
        return (std::memcmp(written, other.written, sizeof(written)) == 0) &&
               (sent.length_bytes == other.sent.length_bytes) &&
               (std::memcmp(sent.data, other.sent.data, sizeof(sent.data)) == 0);
    }
};

Acts ActsOf(Device& device)
{
    for (std::uint8_t word = 0U; word < 8U; ++word)
    {
        std::memset(device.words[word], 0x30 + word, 4U);
    }
    device.Commit();
    Acts acts{};
    acts.sent = device.channel.Prepare(kProducerSlot).normal;
    std::memcpy(acts.written, device.words, sizeof(acts.written));
    return acts;
}

void Reach(Device& device)
{
    device.clock_us = 0U;
    device.Start();
    static_cast<void>(device.Cycle());
    device.Pair(8U, 0x11U);
    static_cast<void>(device.Cycle());
}

TEST(ChannelAMapping, OfAFullFrameIsConfirmedWordByWord)
{
    Verifies(req::SRS_CFG_030);
    // Given two objects of four bytes, released and to be sent
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    Reach(device);
    const CheckResult sound = device.channel.Recheck(kConsumerSlot);
    ASSERT_EQ(sound.fault, ConfigFault::kNone);
    const SrdoView view = device.channel.View(kConsumerSlot);
    const Acts expected = ActsOf(device);
    std::uint32_t misled = 0U;
    for (std::size_t bit = 0U; bit < (8U * FencedDevice::kByteCount); ++bit)
    {
        // When one bit flips
        Reach(device);
        std::uint8_t& byte = fenced->Bytes()[bit / 8U];
        byte = static_cast<std::uint8_t>(byte ^ (1U << (bit % 8U)));
        const bool is_found = (device.channel.Recheck(kConsumerSlot).fault != ConfigFault::kNone) ||
                              (device.channel.Recheck(kProducerSlot).fault != ConfigFault::kNone);
        // and other objects are written or other data sent, from data that did not change
        const SrdoView now = device.channel.View(kConsumerSlot);
        const bool has_data = (now.data.low == view.data.low) && (now.data.high == view.data.high);
        const Acts acts = ActsOf(device);
        const bool is_prepared = acts.sent.length_bytes != 0U;
        if (has_data && is_prepared && (now.state == SrdoState::kReleased) && !acts.IsSame(expected))
        {
            // then Recheck had found it
            EXPECT_TRUE(is_found) << "bit " << bit;
            misled += 1U;
        }
    }
    EXPECT_GE(misled, 32U) << "the places of the objects were among the bits";
    EXPECT_TRUE(fenced->IsIntact());
}

TEST(ChannelAMapping, OfStaticObjectsIsReadBack)
{
    Verifies(req::SRS_REL_011);
    Verifies(req::SRS_CFG_032);
    // Given two words that lie one behind the other, mapped for good and released
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    device.setups[kConsumerSlot].map = StaticMap{kConsumed, 4U};
    device.Start();
    device.channel.SetFields(kConsumerSlot, StaticFields{device.words[0], device.words[2]});
    ASSERT_EQ(device.Sign(kConsumerSlot).fault, ConfigFault::kNone);
    static_cast<void>(device.Cycle());
    device.Pair(8U, 0x11U);
    static_cast<void>(device.Cycle());
    constexpr Agreement kAgreed{kConsumerBit, kConsumerBit};
    EXPECT_EQ(device.channel.Commit(kAgreed, 0U), 0U);
    EXPECT_EQ(device.channel.Commit(kAgreed, kConsumerBit), 0U);
    for (std::uint8_t byte = 0U; byte < 8U; ++byte)
    {
        // When one of their bytes changes, then it is found
        std::uint8_t& changed = device.words[byte / 4U][byte % 4U];
        changed = static_cast<std::uint8_t>(changed ^ 0x40U);
        EXPECT_EQ(device.channel.Commit(kAgreed, kConsumerBit), kConsumerBit) << "byte " << +byte;
        changed = static_cast<std::uint8_t>(changed ^ 0x40U);
    }
    // and an inverse object is none of this channel's
    device.words[2][0] = 0x77U;
    EXPECT_EQ(device.channel.Commit(kAgreed, kConsumerBit), 0U);
}

/// Nine objects of one byte that lie one behind the other and nine inverse ones; eight of each are mapped for good.
struct StaticBytes
{
    explicit StaticBytes(Device& device)
    {
        for (std::uint8_t sub = 1U; sub <= 9U; ++sub)
        {
            objects[sub - 1U] = MappableObject{0x2300U, sub, 8U, MapAccess::kConsumer, &normal[sub - 1U]};
            objects[sub + 8U] = MappableObject{0x2301U, sub, 8U, MapAccess::kConsumer, &inverse[sub - 1U]};
            entries[2U * (sub - 1U)] = 0x23000008U | (std::uint32_t{sub} << 8U);
            entries[(2U * (sub - 1U)) + 1U] = 0x23010008U | (std::uint32_t{sub} << 8U);
        }
        device.config.objects = objects;
        device.config.object_count = 18U;
        device.setups[kConsumerSlot].map = StaticMap{entries, 16U};
        device.Start();
        device.channel.SetFields(kConsumerSlot, StaticFields{normal, inverse});
        EXPECT_EQ(device.Sign(kConsumerSlot).fault, ConfigFault::kNone);
        static_cast<void>(device.Cycle());
        device.Pair(8U, 0x11U);
        static_cast<void>(device.Cycle());
        EXPECT_EQ(device.channel.Commit(Agreement{kConsumerBit, kConsumerBit}, 0U), 0U);
    }

    std::uint8_t normal[9]{};
    std::uint8_t inverse[9]{};
    MappableObject objects[18]{};
    std::uint32_t entries[18]{};
};

TEST(ChannelAMapping, OfEightStaticBytesIsWrittenAndReadBack)
{
    Verifies(req::SRS_REL_011);
    Verifies(req::SRS_CFG_032);
    // Given a frame full of objects of one byte, released
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    StaticBytes bytes{device};
    constexpr std::uint8_t kWritten[9] = {0x11U, 0x12U, 0x13U, 0x14U, 0x15U, 0x16U, 0x17U, 0x18U, 0U};
    for (std::size_t place = 0U; place < 9U; ++place)
    {
        EXPECT_EQ(bytes.normal[place], kWritten[place]) << "byte " << place;
    }
    constexpr Agreement kAgreed{kConsumerBit, kConsumerBit};
    for (std::size_t place = 0U; place < 8U; ++place)
    {
        // When one of them changes, then it is found
        bytes.normal[place] = static_cast<std::uint8_t>(bytes.normal[place] ^ 1U);
        EXPECT_EQ(device.channel.Commit(kAgreed, kConsumerBit), kConsumerBit) << "byte " << place;
        bytes.normal[place] = static_cast<std::uint8_t>(bytes.normal[place] ^ 1U);
    }
    // and the object behind them is none of the mapping
    bytes.normal[8] = 0x19U;
    EXPECT_EQ(device.channel.Commit(kAgreed, kConsumerBit), 0U);
}

TEST(ChannelAMapping, OfMoreThan128StaticEntriesIsRefusedByTheirNumber)
{
    Verifies(req::SRS_CFG_026);
    Verifies(req::SRS_CFG_020);
    // Given objects of 8 bits one behind the other, registered, of which eight fill a frame
    conformance::StaticRow row;
    const auto storage = std::make_unique<channel_a::StorageFor<kMaxSrdoCount, kMaxMapEntries>>();
    channel_a::Channel channel{storage->Handle()};
    EXPECT_EQ(row.Validated(channel, 16U).fault, ConfigFault::kNone);
    // When 128 of them are mapped, then the number is none to find fault with, but the length
    const CheckResult most = row.Validated(channel, 128U);
    EXPECT_EQ(most.fault, ConfigFault::kLengthExceeded);
    // and two more are found before the length, and signed as 128
    const CheckResult more = row.Validated(channel, 130U);
    EXPECT_EQ(more.fault, ConfigFault::kMapping);
    EXPECT_EQ(more.signature, most.signature);
}

TEST(ChannelAMapping, OfStaticObjectsThatGrewIsUsedAsFarAsAFrameGoes)
{
    Verifies(req::SRS_CFG_030);
    Verifies(req::SRS_CFG_032);
    // Given a frame full of objects of one byte, released
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    const StaticBytes bytes{device};
    // When the program's table says that there is one more
    device.setups[kConsumerSlot].map.count = 18U;
    // Then the eight are read and not the ninth
    EXPECT_EQ(device.channel.Commit(Agreement{kConsumerBit, kConsumerBit}, kConsumerBit), 0U);
    // and Recheck finds the table
    EXPECT_EQ(device.channel.Recheck(kConsumerSlot).fault, ConfigFault::kSignature);
}

TEST(ChannelAMapping, OfAStepThatLeadsElsewhereIsReadThere)
{
    Verifies(req::SRS_REL_011);
    Verifies(req::SRS_CONS_024);
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    constexpr std::uint32_t kPlaceBits = 16U;
    for (std::uint32_t bit = 0U; bit < kPlaceBits; ++bit)
    {
        // Given a released pair that was written, when the place of an object flips to that of another one or of none
        Reach(device);
        EXPECT_EQ(device.channel.Commit(Agreement{kConsumerBit, kConsumerBit}, 0U), 0U);
        channel_a::Step& step = fenced->fence.storage.steps[1];
        step.normal = static_cast<std::uint16_t>(step.normal ^ (1U << bit));
        // Then the slot does not hold what was written
        EXPECT_EQ(device.channel.Commit(Agreement{kConsumerBit, kConsumerBit}, kConsumerBit), kConsumerBit)
            << "bit " << bit;
    }
}

TEST(ChannelAMapping, OfStaticObjectsOfOneAndNineBitsIsRefused)
{
    Verifies(req::SRS_CFG_032);
    static constexpr std::uint32_t kEntries[2][2] = {{0x22200101U, 0x22210101U}, {0x22200209U, 0x22210209U}};
    for (std::uint8_t kind = 0U; kind < 2U; ++kind)
    {
        const auto fenced = std::make_unique<FencedDevice>();
        Device& device = fenced->device;
        // Given a static mapping of an object that is no multiple of a byte, whose fields are those registered
        device.setups[0].map = StaticMap{kEntries[kind], 2U};
        device.Start();
        device.channel.SetFields(kConsumerSlot, StaticFields{device.bits[kind], device.bits[kind + 2U]});
        // Then it is refused
        EXPECT_EQ(device.Sign(kConsumerSlot).fault, ConfigFault::kMapping);
        // and dynamically it is not
        device.setups[0].map = StaticMap{};
        device.Start();
        device.Map(kConsumerSlot, kEntries[kind], 2U);
        EXPECT_EQ(device.Sign(kConsumerSlot).fault, ConfigFault::kNone);
    }
}

TEST(ChannelAMapping, OfADirectionThatItNoLongerFitsKeepsTheSlotOff)
{
    Verifies(req::SRS_CFG_003);
    Verifies(req::SRS_CFG_027);
    Verifies(req::SRS_CFG_030);
    Verifies(req::SRS_CONS_002);
    static constexpr std::uint8_t kOther[] = {kDirectionProducer, kDirectionConsumer};
    static constexpr std::uint8_t kOwn[] = {kDirectionConsumer, kDirectionProducer};
    for (SlotIndex slot = 0U; slot < kSlotCount; ++slot)
    {
        // Given a sound configuration, over which an image is loaded with the other direction of one SRDO and 13FEh = 0
        const auto fenced = std::make_unique<FencedDevice>();
        Device& device = fenced->device;
        device.Start();
        device.Store(kNoSlot, ConfigField::kConfigurationValid, 0U);
        device.Store(slot, ConfigField::kDirection, kOther[slot]);
        // Then its mapping is refused, even if it is signed, and found by the cyclic check
        EXPECT_EQ(device.Sign(slot).fault, ConfigFault::kMapping);
        EXPECT_EQ(device.channel.Recheck(slot).fault, ConfigFault::kTable);
        // and it stays off in OPERATIONAL, the other one does not
        device.Store(kNoSlot, ConfigField::kConfigurationValid, 0xA5U);
        EXPECT_EQ(device.Cycle().is_invalid, 1U);
        EXPECT_EQ(device.channel.View(slot).state, SrdoState::kOff);
        EXPECT_EQ(device.channel.Prepare(slot).status, PrepareStatus::kNotProducer);
        // When the image has its own direction again, then it becomes active
        device.nmt = NmtState::kPreOperational;
        static_cast<void>(device.Cycle());
        device.Store(slot, ConfigField::kDirection, kOwn[slot]);
        EXPECT_EQ(device.Sign(slot).fault, ConfigFault::kNone);
        device.nmt = NmtState::kOperational;
        EXPECT_EQ(device.Cycle().is_invalid, 0U);
    }
}

// What Validate says of slot 1 beside slot 0, each with two entries of its own and its direction.
ConfigFault FaultBeside(Device& device, std::uint8_t direction_0, const std::uint32_t* entries_0,
                        std::uint8_t direction_1, const std::uint32_t* entries_1)
{
    device.Start();
    device.Store(0U, ConfigField::kDirection, direction_0);
    device.Map(0U, entries_0, 2U);
    device.Store(1U, ConfigField::kDirection, direction_1);
    device.Map(1U, entries_1, 2U);
    return device.Sign(1U).fault;
}

TEST(ChannelAMapping, OfAnObjectThatALowerSlotNamesIsRefused)
{
    Verifies(req::SRS_CFG_037);
    constexpr std::uint8_t kOff = kDirectionOff;
    constexpr std::uint8_t kProducer = kDirectionProducer;
    constexpr std::uint8_t kConsumer = kDirectionConsumer;
    static constexpr std::uint32_t kFirst[2] = {0x22000120U, 0x22010120U};
    static constexpr std::uint32_t kSecond[2] = {0x22000220U, 0x22010220U};
    static constexpr std::uint32_t kInverseOfBoth[2] = {0x22200109U, 0x22010120U};
    static constexpr std::uint32_t kShorter[2] = {0x22000108U, 0x22000308U};
    static constexpr std::uint32_t kToSend[2] = {0x22100120U, 0x22110120U};
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    // Two consumers of one object, the normal or the inverse one, whatever length the lower slot gives it
    EXPECT_EQ(FaultBeside(device, kConsumer, kFirst, kConsumer, kFirst), ConfigFault::kMapping);
    EXPECT_EQ(FaultBeside(device, kConsumer, kInverseOfBoth, kConsumer, kFirst), ConfigFault::kMapping);
    EXPECT_EQ(FaultBeside(device, kConsumer, kShorter, kConsumer, kFirst), ConfigFault::kMapping);
    // the lower slot is not the one that is named
    EXPECT_EQ(device.Sign(0U).fault, ConfigFault::kMapping) << "its own lengths are wrong";
    static_cast<void>(FaultBeside(device, kConsumer, kFirst, kConsumer, kFirst));
    EXPECT_EQ(device.Sign(0U).fault, ConfigFault::kNone);
    // a producer and a consumer, whichever is lower
    EXPECT_EQ(FaultBeside(device, kProducer, kFirst, kConsumer, kFirst), ConfigFault::kMapping);
    EXPECT_EQ(FaultBeside(device, kConsumer, kToSend, kProducer, kToSend), ConfigFault::kMapping);
    // But other objects, two producers, and a lower slot that is off, are as they should be
    EXPECT_EQ(FaultBeside(device, kConsumer, kFirst, kConsumer, kSecond), ConfigFault::kNone);
    EXPECT_EQ(FaultBeside(device, kProducer, kToSend, kProducer, kToSend), ConfigFault::kNone);
    EXPECT_EQ(FaultBeside(device, kOff, kFirst, kConsumer, kFirst), ConfigFault::kNone);
}

TEST(ChannelAMapping, OfSharedObjectsIsAskedOfTheEntriesThatCount)
{
    Verifies(req::SRS_CFG_037);
    static constexpr std::uint32_t kFirst[2] = {0x22000120U, 0x22010120U};
    static constexpr std::uint32_t kSecond[2] = {0x22000220U, 0x22010220U};
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    // Given an object of slot 1 in entry 16 of slot 0, the last one there is
    ASSERT_EQ(FaultBeside(device, kDirectionConsumer, kFirst, kDirectionConsumer, kSecond), ConfigFault::kNone);
    device.Store(0U, ConfigField::kMapEntry, 0U, 3U);
    device.Store(0U, ConfigField::kMapEntry, 0U, 4U);
    device.Store(0U, ConfigField::kMapEntry, 0x22010220U, 16U);
    // Then it counts with a map count of 16 and of more than there are, and not with 15
    device.Store(0U, ConfigField::kMapCount, 15U);
    EXPECT_EQ(device.channel.Validate(1U).fault, ConfigFault::kNone);
    device.Store(0U, ConfigField::kMapCount, 16U);
    EXPECT_EQ(device.channel.Validate(1U).fault, ConfigFault::kMapping);
    device.Store(0U, ConfigField::kMapCount, 255U);
    EXPECT_EQ(device.channel.Validate(1U).fault, ConfigFault::kMapping);
}

TEST(ChannelAMapping, OfSharedDummiesIsAllowed)
{
    Verifies(req::SRS_CFG_037);
    Verifies(req::SRS_CFG_033);
    static constexpr std::uint32_t kDummies[2] = {0x00050008U, 0x00050008U};
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    device.config.dummies = DummyMapping::kAllowed;
    EXPECT_EQ(FaultBeside(device, kDirectionConsumer, kDummies, kDirectionConsumer, kDummies), ConfigFault::kNone);
}

TEST(ChannelAMapping, OfASharedObjectIsNamedBeforeTheSignature)
{
    Verifies(req::SRS_CFG_020);
    Verifies(req::SRS_CFG_037);
    static constexpr std::uint32_t kFirst[2] = {0x22000120U, 0x22010120U};
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    static_cast<void>(FaultBeside(device, kDirectionConsumer, kFirst, kDirectionConsumer, kFirst));
    device.Store(1U, ConfigField::kSignature, 0U);
    EXPECT_EQ(device.channel.Validate(1U).fault, ConfigFault::kMapping);
}

TEST(ChannelAMapping, OfSharedObjectsIsAskedWhateverLengthIsNamed)
{
    Verifies(req::SRS_CFG_037);
    Verifies(req::SRS_CFG_033);
    static constexpr std::uint32_t kLong[2] = {0x220001A0U, 0x220101A0U};
    static constexpr std::uint32_t kFirst[2] = {0x22000120U, 0x22010120U};
    static constexpr std::uint32_t kDummies[2] = {0x00050008U, 0x00050008U};
    static constexpr std::uint32_t kLongDummies[2] = {0x00050010U, 0x00050010U};
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    device.config.dummies = DummyMapping::kAllowed;
    // Given an object that a lower slot names with 160 bits, then it is shared
    EXPECT_EQ(FaultBeside(device, kDirectionConsumer, kLong, kDirectionConsumer, kFirst), ConfigFault::kMapping);
    // and a dummy that a lower slot names with another length is not
    EXPECT_EQ(FaultBeside(device, kDirectionConsumer, kLongDummies, kDirectionConsumer, kDummies), ConfigFault::kNone);
}

TEST(ChannelAMapping, OfAnIndexBehindTheLastDummyIsNone)
{
    Verifies(req::SRS_CFG_033);
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    device.config.dummies = DummyMapping::kAllowed;
    device.Start();
    for (std::uint32_t length = 0U; length < 256U; ++length)
    {
        // Given entries of 0008h, when they have any length, then they are no dummies
        const std::uint32_t entries[4] = {0x22000120U, 0x22010120U, 0x00080000U | length, 0x00080000U | length};
        device.Map(kConsumerSlot, entries, 4U);
        EXPECT_EQ(device.Sign(kConsumerSlot).fault, ConfigFault::kMapping) << length << " bits";
    }
}

TEST(ChannelAMapping, OfDummiesAloneNeedsNoObjects)
{
    Verifies(req::SRS_CFG_033);
    static constexpr std::uint32_t kDummies[2] = {0x00050008U, 0x00050008U};
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    device.config.dummies = DummyMapping::kAllowed;
    device.config.objects = nullptr;
    device.config.object_count = 0U;
    device.Start();
    device.Map(kConsumerSlot, kDummies, 2U);
    EXPECT_EQ(device.Sign(kConsumerSlot).fault, ConfigFault::kNone);
}

TEST(ChannelAMapping, OfTwoFaultsInOneStepIsFound)
{
    Verifies(req::SRS_CFG_030);
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    Reach(device);
    // Given a step that leads to another object, and whose bits begin elsewhere
    fenced->fence.storage.steps[0].normal = 1U;
    fenced->fence.storage.steps[0].first_bit = 8U;
    EXPECT_EQ(device.channel.Recheck(kConsumerSlot).fault, ConfigFault::kTable);
}

TEST(ChannelAMapping, OfAStepBehindTheLastObjectLeadsNowhere)
{
    Verifies(req::SRS_CFG_030);
    Verifies(req::SRS_REL_002);
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    // Given what looks like the first object behind the last one, when a step leads there
    std::uint8_t behind[4] = {9U, 9U, 9U, 9U};
    device.config.object_count = 13U;
    device.objects[13] = device.objects[0];
    device.objects[13].place = behind;
    Reach(device);
    fenced->fence.storage.steps[0].normal = 13U;
    // Then the recheck finds it, and it is not written
    EXPECT_EQ(device.channel.Recheck(kConsumerSlot).fault, ConfigFault::kTable);
    EXPECT_EQ(device.channel.Commit(Agreement{kConsumerBit, kConsumerBit}, 0U), kConsumerBit);
    EXPECT_EQ(behind[0], 9U);
}

TEST(ChannelAMapping, OfAStepThatEndsBehindTheFrameIsNotWritten)
{
    Verifies(req::SRS_REL_002);
    Verifies(req::SRS_CONS_024);
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    Reach(device);
    // Given four bytes from byte 5 on, of eight
    fenced->fence.storage.steps[0].first_bit = 40U;
    EXPECT_EQ(device.channel.Commit(Agreement{kConsumerBit, kConsumerBit}, 0U), kConsumerBit);
    const std::uint8_t untouched[4] = {0U, 0U, 0U, 0U};
    EXPECT_EQ(std::memcmp(device.words[0], untouched, sizeof(untouched)), 0);
}

// What a second Commit finds of the consumer whose objects hold a pair, after a bit was flipped in each of two bytes.
SrdoMask FoundAfter(Device& device, std::uint8_t& one, std::uint8_t& other)
{
    device.Commit();
    EXPECT_EQ(device.channel.Answer(1U).mask, kConsumerBit);
    one = static_cast<std::uint8_t>(one ^ 4U);
    other = static_cast<std::uint8_t>(other ^ 4U);
    static_cast<void>(device.Cycle());
    return device.channel.Commit(Agreement{kConsumerBit, kConsumerBit}, kConsumerBit);
}

TEST(ChannelAMapping, OfObjectsWithTheSameBitFlippedTwiceIsFound)
{
    Verifies(req::SRS_REL_011);
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    // Given a pair in two objects, when the same bit flips in two bytes of one, or in a byte of each
    Reach(device);
    EXPECT_EQ(FoundAfter(device, device.words[0][0], device.words[0][1]), kConsumerBit);
    Reach(device);
    EXPECT_EQ(FoundAfter(device, device.words[0][0], device.words[1][0]), kConsumerBit);
}

TEST(ChannelAMapping, OfNineBitsIsWrittenAndConfirmedBitByBit)
{
    Verifies(req::SRS_REL_002);
    Verifies(req::SRS_REL_011);
    Verifies(req::SRS_CFG_036);
    static constexpr std::uint32_t kNineBits[2] = {0x22200209U, 0x22210209U};
    const auto fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
    // Given an object of nine bits before a byte of another one
    device.Start();
    device.Map(kConsumerSlot, kNineBits, 2U);
    ASSERT_EQ(device.Sign(kConsumerSlot).fault, ConfigFault::kNone);
    device.bits[1][1] = 0xFFU;
    device.bits[2][0] = 0xFFU;
    static_cast<void>(device.Cycle());
    device.Pair(2U, 0U);
    ASSERT_EQ(device.Cycle().released, kConsumerBit);
    device.Commit();
    // Then the bits above it are 0, and the byte behind it is left alone
    EXPECT_EQ(device.bits[1][0], 0U);
    EXPECT_EQ(device.bits[1][1], 1U);
    EXPECT_EQ(device.bits[2][0], 0xFFU);
    // and two wrong bits are found
    device.bits[1][0] = 3U;
    static_cast<void>(device.Cycle());
    EXPECT_EQ(device.channel.Commit(Agreement{kConsumerBit, kConsumerBit}, kConsumerBit), kConsumerBit);
}

} // namespace
} // namespace counterpoint::channel_a_test
