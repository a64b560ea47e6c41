// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Channel B alone: a direction that does not fit the objects of its mapping, by whatever way the two came together.
// Slots 0 and 2 are consumers, 1 is a producer.
#include "tests/channel_b/rig.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <memory>

namespace counterpoint
{
namespace
{

/// Signed as it is, without Validate.
void Sign(Rig& rig, SlotIndex slot)
{
    rig.Store(slot, ConfigField::kSignature, rig.Voice().Recheck(slot).signature);
}

/// As after power-on, when a stored image is taken that was not valid: every value, but no Validate.
std::unique_ptr<Rig> Restored(std::uint8_t direction_of_slot_0)
{
    auto rig = std::make_unique<Rig>(ReleasePolicy::kAutomatic);
    rig->Start();
    rig->Voice().Restart(rig->Config());
    for (SlotIndex slot = 0U; slot < kRigSlots; ++slot)
    {
        rig->Store(slot, ConfigField::kSct, 50U);
        rig->Store(slot, ConfigField::kSrvt, 20U);
        rig->Store(slot, ConfigField::kCobId1, 0x101U + (2U * slot));
        rig->Store(slot, ConfigField::kCobId2, 0x102U + (2U * slot));
        for (std::uint8_t sub = 1U; sub <= kRigCounts[slot]; ++sub)
        {
            rig->Store(slot, ConfigField::kMapEntry, kRigMaps[slot][sub - 1U], sub);
        }
        rig->Store(slot, ConfigField::kMapCount, kRigCounts[slot]);
        rig->Store(slot, ConfigField::kDirection, (slot == 0U) ? direction_of_slot_0 : kRigDirections[slot]);
        Sign(*rig, slot);
    }
    return rig;
}

/// A5h is stored and OPERATIONAL entered: the slot is neither consumer nor producer.
void ExpectOff(Rig& rig, SlotIndex slot)
{
    rig.Store(0U, ConfigField::kConfigurationValid, kConfigurationValidValue);
    static_cast<void>(rig.Leave());
    static_cast<void>(rig.Enter());
    EXPECT_EQ(rig.Voice().View(slot).state, SrdoState::kOff);
    EXPECT_EQ(rig.Voice().Prepare(slot).status, PrepareStatus::kNotProducer);
}

TEST(ChannelBDirection, OneThatNoLongerFitsIsRefusedAndStaysOff)
{
    Verifies(req::SRS_CFG_027);
    Verifies(req::SRS_CFG_030);
    Verifies(req::SRS_CONS_002);
    // Given a device that is set up
    const auto rig = std::make_unique<Rig>(ReleasePolicy::kAutomatic);
    rig->Start();
    ASSERT_EQ(rig->Voice().Recheck(0U).fault, ConfigFault::kNone);
    // when the consumer becomes a producer and the producer a consumer, their mappings as they were, both signed
    rig->Store(0U, ConfigField::kDirection, 1U);
    rig->Store(1U, ConfigField::kDirection, 2U);
    Sign(*rig, 0U);
    Sign(*rig, 1U);
    // then each check says so, and neither is active
    EXPECT_EQ(rig->Voice().Recheck(0U).fault, ConfigFault::kTable);
    EXPECT_EQ(rig->Voice().Recheck(1U).fault, ConfigFault::kTable);
    EXPECT_EQ(rig->Voice().Validate(0U).fault, ConfigFault::kMapping);
    EXPECT_EQ(rig->Voice().Validate(1U).fault, ConfigFault::kMapping);
    ExpectOff(*rig, 0U);
    ExpectOff(*rig, 1U);
    EXPECT_EQ(rig->Voice().Recheck(0U).fault, ConfigFault::kTable);
}

TEST(ChannelBDirection, ThereAndBackWantsAnotherValidate)
{
    Verifies(req::SRS_CFG_030);
    Verifies(req::SRS_CONS_002);
    // Given a direction that did not fit for a moment and is as it was, its signature right
    const auto rig = std::make_unique<Rig>(ReleasePolicy::kAutomatic);
    rig->Start();
    rig->Store(0U, ConfigField::kDirection, 1U);
    rig->Store(0U, ConfigField::kDirection, 2U);
    // when nobody validates it, then it stays off
    EXPECT_EQ(rig->Voice().Recheck(0U).fault, ConfigFault::kTable);
    ExpectOff(*rig, 0U);
    // when somebody does, then it is a consumer again
    EXPECT_EQ(rig->Voice().Validate(0U).fault, ConfigFault::kNone);
    static_cast<void>(rig->Leave());
    static_cast<void>(rig->Enter());
    EXPECT_EQ(rig->Voice().View(0U).state, SrdoState::kWaiting);
}

TEST(ChannelBDirection, OneThatDoesNotFitInARestoredImageIsRefused)
{
    Verifies(req::SRS_CFG_027);
    Verifies(req::SRS_CFG_030);
    Verifies(req::SRS_CONS_002);
    // Given values that were stored after power-on, the direction of slot 0 being that of a producer
    const auto rig = Restored(1U);
    // when 13FEh is A5h without a check, then it is off, and each check says so
    ExpectOff(*rig, 0U);
    EXPECT_EQ(rig->Voice().Recheck(0U).fault, ConfigFault::kTable);
    EXPECT_EQ(rig->Voice().Validate(0U).fault, ConfigFault::kMapping);
    ExpectOff(*rig, 0U);
    // and its objects hold what the set-up before power-on wrote: nothing was written by a mapping that does not fit
    EXPECT_EQ(rig->Value(2U), 0xFFFFFFFFU);
}

TEST(ChannelBDirection, OneThatFitsInARestoredImageWantsValidateToo)
{
    Verifies(req::SRS_CFG_030);
    Verifies(req::SRS_CONS_002);
    const auto rig = Restored(2U);
    ExpectOff(*rig, 0U);
    EXPECT_EQ(rig->Voice().Recheck(0U).fault, ConfigFault::kTable);
    EXPECT_EQ(rig->Voice().Validate(0U).fault, ConfigFault::kNone);
    static_cast<void>(rig->Leave());
    static_cast<void>(rig->Enter());
    EXPECT_EQ(rig->Voice().View(0U).state, SrdoState::kWaiting);
}

TEST(ChannelBDirection, FlippedBehindTheChecksStaysOff)
{
    Verifies(req::SRS_CONS_024);
    Verifies(req::SRS_CONS_002);
    // Given a device that is set up, when a bit of a direction flips before OPERATIONAL: it is then neither 1 nor 2
    using RigStorage = channel_b::StorageFor<kRigSlots, kRigEntries>;
    const auto rig = std::make_unique<Rig>(ReleasePolicy::kAutomatic);
    for (SlotIndex slot = 0U; slot < kRigSlots; ++slot)
    {
        for (std::uint32_t bit = 0U; bit < 8U; ++bit)
        {
            rig->Start();
            std::uint8_t& direction = rig->Bytes()[offsetof(RigStorage, image) + (std::size_t{slot} * 16U)];
            ASSERT_EQ(direction, kRigDirections[slot]);
            direction = static_cast<std::uint8_t>(direction ^ (1U << bit));
            static_cast<void>(rig->Enter());
            // then the slot is off and takes no pair
            EXPECT_EQ(rig->Voice().View(slot).state, SrdoState::kOff) << bit;
            rig->Pair(slot, 0x5AU);
            EXPECT_EQ(rig->Cycle().released, 0U) << bit;
            EXPECT_EQ(rig->Voice().Prepare(slot).status, PrepareStatus::kNotProducer) << bit;
        }
    }
}

} // namespace
} // namespace counterpoint
