// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Channel B alone: what a corrupted record becomes, what Recheck finds, and what storage and Restart leave behind.
#include "tests/channel_b/rig.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/ids/kernel.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace counterpoint
{
namespace
{

constexpr std::uint64_t kData = 0x8877665544332211U;

/// Each bit alone, zero, all ones.
constexpr std::uint32_t kCorruptions = 10U;

std::uint8_t Corrupted(std::uint8_t byte, std::uint32_t kind)
{
    if (kind < 8U)
    {
        return static_cast<std::uint8_t>(byte ^ (1U << kind));
    }
    return (kind == 8U) ? std::uint8_t{0U} : std::uint8_t{0xFFU};
}

void ForEachCorruption(const std::function<void(std::size_t, std::uint32_t)>& run)
{
    for (std::size_t byte = 0U; byte < Rig::kByteCount; ++byte)
    {
        for (std::uint32_t kind = 0U; kind < kCorruptions; ++kind)
        {
            run(byte, kind);
        }
    }
}

void Release(Rig& rig)
{
    rig.Start();
    static_cast<void>(rig.Enter());
    rig.Pair(0U, kData);
    ASSERT_EQ(rig.Acknowledged().released & 1U, 1U);
}

TEST(ChannelBRecord, CorruptedWhileReleasedEndsFaultedWithItsOwnCause)
{
    Verifies(req::SRS_CONS_024);
    const auto rig = std::make_unique<Rig>();
    std::uint32_t invalid = 0U;
    ForEachCorruption(
        [&](std::size_t byte, std::uint32_t kind)
        {
            // Given a released consumer, when a byte of the storage changes
            Release(*rig);
            rig->Bytes()[byte] = Corrupted(rig->Bytes()[byte], kind);
            const CycleOutcome outcome = rig->Cycle();
            const SrdoView view = rig->Voice().View(0U);
            // then it is released with its pair, or faulted, or off
            const bool is_released = (outcome.released & 1U) != 0U;
            EXPECT_EQ(is_released, view.state == SrdoState::kReleased) << byte << " " << kind;
            EXPECT_TRUE(is_released || (view.state == SrdoState::kFaulted) || (view.state == SrdoState::kOff)) << byte;
            EXPECT_EQ(view.holds_pair, is_released ? 1U : 0U) << byte << " " << kind;
            if (view.first_cause == SrdoCause::kInvalid)
            {
                ++invalid;
                EXPECT_EQ(outcome.released & 1U, 0U) << byte << " " << kind;
                EXPECT_EQ(view.ordinal, 0U) << byte << " " << kind;
            }
            if ((outcome.signalled & view.signals & 1U) != 0U)
            {
                EXPECT_EQ(view.state, SrdoState::kFaulted) << byte << " " << kind;
                EXPECT_EQ(outcome.new_fault & 1U, 1U) << byte << " " << kind;
                // and no acknowledge releases what is corrupted
                rig->Pair(0U, kData);
                EXPECT_EQ(rig->Acknowledged().released & 1U, 0U) << byte << " " << kind;
            }
        });
    // There is more than one mark whose corruption is told as such.
    EXPECT_GE(invalid, 12U);
}

TEST(ChannelBRecord, CorruptedWhileSafeStaysSafe)
{
    Verifies(req::SRS_CONS_024);
    const auto rig = std::make_unique<Rig>();
    std::uint32_t told = 0U;
    ForEachCorruption(
        [&](std::size_t byte, std::uint32_t kind)
        {
            // Given a consumer that waits for its acknowledge with a pair, when a byte changes and nothing acknowledges
            rig->Start();
            static_cast<void>(rig->Enter());
            rig->Pair(0U, kData);
            static_cast<void>(rig->Cycle());
            rig->Bytes()[byte] = Corrupted(rig->Bytes()[byte], kind);
            // then it is not released
            EXPECT_EQ(rig->Cycle().released & 1U, 0U) << byte << " " << kind;
            told += ((rig->Voice().View(0U).signals & 1U) != 0U) ? 1U : 0U;
        });
    EXPECT_GE(told, 8U);
}

using RigStorage = channel_b::StorageFor<kRigSlots, kRigEntries>;

constexpr std::size_t kHeldAt = offsetof(RigStorage, held) + 2U;
constexpr std::size_t kGrantedAt = offsetof(RigStorage, granted) + 2U;
constexpr std::size_t kFirstCauseAt = offsetof(RigStorage, first_cause) + 2U;

/// Slot 2 is the only one of which something is told, and that is what no other fault is.
void ExpectOnlySlot2Invalid(const Rig& rig, const CycleOutcome& outcome, const SrdoView& view, std::size_t at)
{
    EXPECT_EQ(outcome.new_fault, 4U) << at;
    EXPECT_EQ(outcome.signalled, 4U) << at;
    EXPECT_EQ(outcome.faulted, 4U) << at;
    EXPECT_EQ(view.state, SrdoState::kFaulted) << at;
    EXPECT_EQ(view.signals, 1U) << at; // Bit of kInvalid.
    EXPECT_EQ(view.holds_pair, 0U) << at;
    EXPECT_TRUE(rig.AreCanariesAlive()) << at;
}

TEST(ChannelBRecord, FlippedMarkOfAReleasedConsumerIsToldOfItsOwnSlot)
{
    Verifies(req::SRS_CONS_024);
    const auto rig = std::make_unique<Rig>(ReleasePolicy::kAutomatic);
    for (const std::size_t at : {kHeldAt, kGrantedAt, kFirstCauseAt})
    {
        for (std::uint32_t bit = 0U; bit < 8U; ++bit)
        {
            // Given two released consumers, when a bit of a mark or of the cause of the second flips
            rig->Start();
            static_cast<void>(rig->Enter());
            rig->Pair(0U, kData);
            rig->Pair(2U, 0x5AU);
            ASSERT_EQ(rig->Cycle().released, 5U);
            rig->Bytes()[at] = Corrupted(rig->Bytes()[at], bit);
            const CycleOutcome outcome = rig->Cycle();
            // then that one is faulted, and the other one stays released
            ExpectOnlySlot2Invalid(*rig, outcome, rig->Voice().View(2U), at);
            EXPECT_EQ(outcome.released, 1U) << at << " " << bit;
            EXPECT_EQ(rig->Voice().View(0U).state, SrdoState::kReleased) << at << " " << bit;
            EXPECT_EQ(rig->Voice().View(0U).error_count, 0U) << at << " " << bit;
        }
    }
}

TEST(ChannelBRecord, FlippedMarkOfAWaitingConsumerIsToldOfItsOwnSlot)
{
    Verifies(req::SRS_CONS_024);
    const auto rig = std::make_unique<Rig>();
    for (const std::size_t at : {kHeldAt, kGrantedAt})
    {
        for (std::uint32_t bit = 0U; bit < 8U; ++bit)
        {
            // Given two consumers that wait for their acknowledge with a pair, when a bit of a mark of the second flips
            rig->Start();
            static_cast<void>(rig->Enter());
            rig->Pair(0U, kData);
            rig->Pair(2U, 0x5AU);
            ASSERT_EQ(rig->Cycle().waiting, 5U);
            rig->Bytes()[at] = Corrupted(rig->Bytes()[at], bit);
            const CycleOutcome outcome = rig->Cycle();
            // then that one is faulted, and the other one goes on waiting
            ExpectOnlySlot2Invalid(*rig, outcome, rig->Voice().View(2U), at);
            EXPECT_EQ(outcome.waiting, 1U) << at << " " << bit;
            EXPECT_EQ(rig->Voice().View(0U).error_count, 0U) << at << " " << bit;
        }
    }
}

TEST(ChannelBRecord, CauseOfAProducerIsDefinedForTheConsumerThatFollowsIt)
{
    Verifies(req::SRS_CONS_024);
    // Given a producer whose first cause is a wrong echo
    const auto rig = std::make_unique<Rig>(ReleasePolicy::kAutomatic);
    rig->Config().dummies = DummyMapping::kAllowed;
    rig->Start();
    static_cast<void>(rig->Enter());
    rig->Request();
    ASSERT_EQ(rig->Cycle().due, 2U);
    CanFrame normal = rig->Voice().Prepare(1U).normal;
    normal.data[0U] = static_cast<std::uint8_t>(normal.data[0U] ^ 1U);
    rig->Confirm(normal);
    ASSERT_EQ(rig->Voice().View(1U).first_cause, SrdoCause::kWrongEcho);
    static_cast<void>(rig->Leave());
    // when its slot becomes a consumer, which is released without an acknowledge
    rig->Store(1U, ConfigField::kDirection, 2U);
    ASSERT_EQ(rig->Map(1U, {0x63000120U, 0x63010120U, 0x00040020U, 0x00040020U}), ConfigFault::kNone);
    static_cast<void>(rig->Enter());
    rig->Pair(1U, kData);
    // then that cause is no corrupted one
    EXPECT_EQ(rig->Cycle().released, 2U);
    EXPECT_EQ(rig->Cycle().released, 2U);
    EXPECT_EQ(rig->Voice().View(1U).first_cause, SrdoCause::kWrongEcho);
}

TEST(ChannelBRecord, RecheckFindsEveryObjectThatIsNotTheMappedOne)
{
    Verifies(req::SRS_CFG_030);
    // Given a frame filled by two objects of 32 bits, when a byte changes before OPERATIONAL
    const auto rig = std::make_unique<Rig>(ReleasePolicy::kAutomatic);
    std::uint32_t found = 0U;
    std::uint32_t written = 0U;
    ForEachCorruption(
        [&](std::size_t byte, std::uint32_t kind)
        {
            rig->Start();
            rig->Put(2U, 0U);
            rig->Put(3U, 0U);
            rig->Bytes()[byte] = Corrupted(rig->Bytes()[byte], kind);
            const ConfigFault fault = rig->Voice().Recheck(0U).fault;
            found += (fault == ConfigFault::kTable) ? 1U : 0U;
            static_cast<void>(rig->Enter());
            rig->Pair(0U, kData);
            const bool is_released = (rig->Cycle().released & 1U) != 0U;
            const SrdoMask wrong = rig->Voice().Commit(Agreement{1U, 1U}, 0U);
            if (is_released)
            {
                // then it is found and never released, or the pair reaches its own objects
                ++written;
                EXPECT_EQ(fault, ConfigFault::kNone) << byte << " " << kind;
                EXPECT_EQ(rig->Value(2U), 0xBBCCDDEEU) << byte << " " << kind;
                EXPECT_EQ(rig->Value(3U), 0x778899AAU) << byte << " " << kind;
                EXPECT_EQ(wrong, 0U) << byte << " " << kind;
            }
            // and no other object is touched.
            for (const std::size_t other : {0U, 1U, 4U, 5U, 6U, 7U, 8U, 10U, 11U})
            {
                EXPECT_EQ(rig->Value(other), 0x66666666U) << byte << " " << kind << " " << other;
            }
        });
    EXPECT_GE(found, 4U * 16U);
    EXPECT_GE(written, 1000U);
}

/// What the check finds once the SRDO, as it is, has the right signature.
ConfigFault SignedAndRechecked(Rig& rig, SlotIndex slot)
{
    rig.Store(slot, ConfigField::kSignature, rig.Voice().Recheck(slot).signature);
    return rig.Voice().Recheck(slot).fault;
}

TEST(ChannelBRecord, FlippedEntryOfADummyIsFoundWhateverTheSignature)
{
    Verifies(req::SRS_CFG_030);
    Verifies(req::SRS_CFG_033);
    const auto rig = std::make_unique<Rig>();
    rig->Config().dummies = DummyMapping::kAllowed;
    for (std::uint32_t bit = 0U; bit < 64U; ++bit)
    {
        // Given a pair of dummies below a pair of objects, when a bit of a dummy's entry flips and that is signed
        rig->Start();
        ASSERT_EQ(rig->Map(0U, {0x00040020U, 0x00040020U, 0x60000120U, 0x60010120U}), ConfigFault::kNone);
        ASSERT_EQ(SignedAndRechecked(*rig, 0U), ConfigFault::kNone);
        std::uint8_t& byte = rig->Bytes()[offsetof(RigStorage, entries) + (bit / 8U)];
        byte = static_cast<std::uint8_t>(byte ^ (1U << (bit % 8U)));
        // then it is neither a dummy nor an object
        EXPECT_EQ(SignedAndRechecked(*rig, 0U), ConfigFault::kTable) << bit;
    }
}

TEST(ChannelBRecord, FlippedMapCountIsFoundWhateverTheSignature)
{
    Verifies(req::SRS_CFG_030);
    // Given a map count of 2 before entries that name objects as well, when its lowest bit flips and that is signed
    const auto rig = std::make_unique<Rig>();
    rig->Start();
    rig->Store(0U, ConfigField::kMapCount, 2U);
    ASSERT_EQ(rig->Validated(0U), ConfigFault::kNone);
    ASSERT_EQ(SignedAndRechecked(*rig, 0U), ConfigFault::kNone);
    std::uint8_t& count = rig->Bytes()[offsetof(RigStorage, image) + 12U];
    ASSERT_EQ(count, 2U);
    count = 3U;
    // then the entry that counts in addition has no object
    EXPECT_EQ(SignedAndRechecked(*rig, 0U), ConfigFault::kTable);
}

/// Everything that may happen to a device; what the channel answers, one number after the other.
std::vector<std::uint64_t> Trace(Rig& rig)
{
    std::vector<std::uint64_t> trace;
    const auto note = [&](const CycleOutcome& outcome)
    {
        for (const std::uint64_t value :
             {outcome.released, outcome.faulted, outcome.waiting, outcome.new_fault, outcome.fresh, outcome.due,
              outcome.refresh, outcome.signalled, std::uint64_t{outcome.cycle}, std::uint64_t{outcome.ordinal_sum},
              std::uint64_t{outcome.sct_checked}, std::uint64_t{outcome.is_tx}, std::uint64_t{outcome.is_invalid}})
        {
            trace.push_back(value);
        }
        for (SlotIndex slot = 0U; slot < kRigSlots; ++slot)
        {
            const SrdoView view = rig.Voice().View(slot);
            trace.push_back(view.data.low + (std::uint64_t{view.data.high} << 32U));
            trace.push_back(view.ordinal + (std::uint64_t{view.signals} << 32U));
            trace.push_back(std::uint64_t{view.error_count} + (static_cast<std::uint64_t>(view.state) << 32U));
            trace.push_back(static_cast<std::uint64_t>(view.first_cause) + (std::uint64_t{view.holds_pair} << 32U));
        }
        trace.push_back(rig.Voice().Commit(Agreement{outcome.released, outcome.released}, 0U));
        const Permit permit = rig.Voice().Answer(0x01020304U);
        trace.push_back(permit.mask + (std::uint64_t{permit.response} << 32U));
        for (std::size_t object = 0U; object < 12U; ++object)
        {
            trace.push_back(rig.Value(object));
        }
    };
    rig.Start();
    note(rig.Enter());
    rig.Pair(0U, kData);
    rig.Normal(2U, 0x5AU);
    rig.Request();
    note(rig.Cycle());
    note(rig.Acknowledged());
    rig.Inverse(2U, 0x5AU);
    rig.Pair(0U, ~kData);
    note(rig.Cycle());
    static_cast<void>(rig.Voice().Prepare(1U));
    const PreparedPair pair = rig.Voice().Prepare(1U);
    trace.push_back(static_cast<std::uint64_t>(pair.status));
    rig.Confirm(pair.normal);
    trace.push_back(rig.Voice().InverseFrame(1U).identifier);
    note(rig.Cycle(60000U));
    note(rig.Leave());
    note(rig.Enter());
    rig.Pair(0U, kData);
    rig.Pair(2U, 0x77U);
    note(rig.Acknowledged());
    rig.Normal(0U, kData);
    rig.Normal(0U, kData);
    rig.Request();
    note(rig.Cycle());
    static_cast<void>(rig.Voice().Prepare(1U));
    rig.Normal(2U, 0x12U);
    return trace;
}

TEST(ChannelBRecord, SecondStartBeginsAsTheFirst)
{
    Verifies(req::SRS_CFG_002);
    // Given what a channel does in memory that is zero
    const auto rig = std::make_unique<Rig>();
    const std::vector<std::uint64_t> first = Trace(*rig);
    // when it starts again in the midst of everything, then it does the same
    EXPECT_EQ(Trace(*rig), first);
    // and so in memory that holds anything
    static constexpr std::uint8_t kFills[] = {0xFFU, 0x5AU, 0xA5U, 0x93U, 0xC6U};
    for (const std::uint8_t fill : kFills)
    {
        rig->Fill(fill);
        EXPECT_EQ(Trace(*rig), first) << static_cast<std::uint32_t>(fill);
    }
}

TEST(ChannelBRecord, StorageOfExactlyTheDevicesSizeIsNotLeft)
{
    Verifies(req::SRS_KRN_020);
    Verifies(req::SRS_CFG_003);
    const auto rig = std::make_unique<Rig>();
    static_cast<void>(Trace(*rig));
    EXPECT_TRUE(rig->AreCanariesAlive());
    // Given addresses beside what exists, when they are stored, then nothing changes
    const std::vector<std::uint8_t> before(rig->Bytes(), &rig->Bytes()[Rig::kByteCount]);
    rig->Store(kRigSlots, ConfigField::kSct, 0xFFFFU);
    rig->Store(0xFFU, ConfigField::kMapEntry, 0xFFFFFFFFU, 1U);
    rig->Store(2U, ConfigField::kMapEntry, 0xFFFFFFFFU, 5U);
    rig->Store(0U, ConfigField::kMapEntry, 0xFFFFFFFFU, 0U);
    rig->Store(kRigSlots, ConfigField::kMapCount, 2U);
    rig->Store(kRigSlots, ConfigField::kSignature, 2U);
    EXPECT_EQ(std::vector<std::uint8_t>(rig->Bytes(), &rig->Bytes()[Rig::kByteCount]), before);
    EXPECT_EQ(rig->Voice().Load(ConfigAddress{kRigSlots, ConfigField::kMapCount, 0U}).value, 0U);
    // and the last of all is the last of the storage
    rig->Store(2U, ConfigField::kMapEntry, 0x12345678U, kRigEntries);
    EXPECT_EQ(rig->Voice().Load(ConfigAddress{2U, ConfigField::kMapEntry, kRigEntries}).value, 0x12345678U);
    EXPECT_TRUE(rig->AreCanariesAlive());
}

/// Static mapping of one object of each side.
ConfigFault StaticOf(Rig& rig, std::uint8_t bits)
{
    const std::uint32_t entries[] = {0x63000100U + bits, 0x63010100U + bits};
    rig.Config().granularity_bits = 1U;
    rig.SetFree(bits, MapAccess::kConsumer);
    rig.Setup(2U).map = StaticMap{entries, 2U};
    rig.Voice().Restart(rig.Config());
    rig.Voice().SetFields(2U, rig.FreeFields());
    rig.Store(2U, ConfigField::kCobId1, 0x105U);
    rig.Store(2U, ConfigField::kCobId2, 0x106U);
    rig.Store(2U, ConfigField::kDirection, 2U);
    rig.Store(2U, ConfigField::kSignature, rig.Voice().Validate(2U).signature);
    return rig.Voice().Validate(2U).fault;
}

TEST(ChannelBRecord, StaticMappingHasNoEntryBehindItsCount)
{
    Verifies(req::SRS_CFG_003);
    Verifies(req::SRS_CFG_032);
    // Given a static mapping of two in slot 2, beside dynamic ones of up to four entries
    static constexpr std::uint32_t kEntries[] = {0x62000108U, 0x62010108U, 0x63000120U, 0x63010120U};
    const auto rig = std::make_unique<Rig>();
    rig->Setup(2U).map = StaticMap{kEntries, 2U};
    rig->Start();
    const auto load = [&](SlotIndex slot, std::uint8_t sub)
    { return rig->Voice().Load(ConfigAddress{slot, ConfigField::kMapEntry, sub}).value; };
    EXPECT_EQ(load(2U, 2U), 0x62010108U);
    EXPECT_EQ(load(2U, 3U), 0U);
    EXPECT_EQ(load(2U, 4U), 0U);
    EXPECT_EQ(load(1U, 4U), 0x61010220U);
}

TEST(ChannelBRecord, DefaultConnectionSetIsThatOfSrdoOneWhereverItLies)
{
    Verifies(req::SRS_CFG_002);
    // Given a device of node-ID 33 with SRDO 1 in slot 1, when it starts
    const auto rig = std::make_unique<Rig>();
    rig->Config().node_id = 33U;
    rig->Setup(0U).number = 2U;
    rig->Setup(1U).number = 1U;
    rig->Voice().Restart(rig->Config());
    const auto load = [&](SlotIndex slot, ConfigField field)
    { return rig->Voice().Load(ConfigAddress{slot, field, 0U}).value; };
    // then that slot has the identifiers and the SCT, and the others none of them
    EXPECT_EQ(load(1U, ConfigField::kCobId1), 0x141U);
    EXPECT_EQ(load(1U, ConfigField::kCobId2), 0x142U);
    EXPECT_EQ(load(1U, ConfigField::kSct), 50U);
    for (const SlotIndex other : {SlotIndex{0U}, SlotIndex{2U}})
    {
        EXPECT_EQ(load(other, ConfigField::kCobId1), 0U);
        EXPECT_EQ(load(other, ConfigField::kCobId2), 0U);
        EXPECT_EQ(load(other, ConfigField::kSct), 25U);
    }
}

TEST(ChannelBRecord, StaticObjectsAreOfWholeBytes)
{
    Verifies(req::SRS_CFG_032);
    const auto rig = std::make_unique<Rig>();
    EXPECT_EQ(StaticOf(*rig, 1U), ConfigFault::kMapping);
    EXPECT_EQ(StaticOf(*rig, 7U), ConfigFault::kMapping);
    EXPECT_EQ(StaticOf(*rig, 8U), ConfigFault::kNone);
    EXPECT_EQ(StaticOf(*rig, 9U), ConfigFault::kMapping);
    EXPECT_EQ(StaticOf(*rig, 16U), ConfigFault::kNone);
    EXPECT_EQ(StaticOf(*rig, 17U), ConfigFault::kMapping);
    EXPECT_EQ(StaticOf(*rig, 32U), ConfigFault::kNone);
}

} // namespace
} // namespace counterpoint
