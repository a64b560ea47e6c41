// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Channel B alone: what Recheck finds besides signature and places.
#include "tests/channel_b/rig.hpp"
#include "verification/trace/ids/channel_b.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

namespace counterpoint
{
namespace
{

using RigStorage = channel_b::StorageFor<kRigSlots, kRigEntries>;

constexpr std::uint32_t kBitsOfAByte = 8U;
/// Of slot 2: its first entry, and the signature in its image.
constexpr std::size_t kNormalDummyAt = offsetof(RigStorage, entries) + (2U * kRigEntries * 4U);
constexpr std::size_t kSignatureAt = offsetof(RigStorage, image) + (2U * channel_b::kImageBytes) + 14U;

/// Bytes of one field of one slot.
struct Field
{
    std::string name;
    std::size_t at;
    std::size_t bytes;
};

std::vector<Field> LimitsOf(SlotIndex slot)
{
    return {{"limit", offsetof(RigStorage, limit) + (4U * slot), 4U},
            {"SRVT", offsetof(RigStorage, srvt_limit) + (4U * slot), 4U}};
}

std::vector<Field> LengthsOf(SlotIndex slot)
{
    return {{"mapped bits", offsetof(RigStorage, mapped) + (8U * slot), 8U},
            {"bytes", offsetof(RigStorage, length_bytes) + slot, 1U}};
}

/// How many of the single bits Recheck finds as kTable; nothing is found when the bit is right again.
std::uint32_t Found(Rig& rig, SlotIndex slot, const Field& field)
{
    std::uint32_t found = 0U;
    for (std::size_t at = field.at; at < (field.at + field.bytes); ++at)
    {
        for (std::uint32_t bit = 0U; bit < kBitsOfAByte; ++bit)
        {
            const std::uint8_t right = rig.Bytes()[at];
            rig.Bytes()[at] = static_cast<std::uint8_t>(right ^ (1U << bit));
            found += (rig.Voice().Recheck(slot).fault == ConfigFault::kTable) ? 1U : 0U;
            rig.Bytes()[at] = right;
            EXPECT_EQ(rig.Voice().Recheck(slot).fault, ConfigFault::kNone) << field.name << " " << at << " " << bit;
        }
    }
    return found;
}

TEST(ChannelBRecheck, FindsEachBitOfALengthThatIsNotThatOfTheEntries)
{
    Verifies(req::SRS_CHB_191);
    // Given a device that is configured, then one in OPERATIONAL: each bit of each slot is found
    const auto rig = std::make_unique<Rig>();
    rig->Start();
    for (const bool is_operational : {false, true})
    {
        if (is_operational)
        {
            static_cast<void>(rig->Enter());
        }
        for (SlotIndex slot = 0U; slot < kRigSlots; ++slot)
        {
            for (const Field& field : LengthsOf(slot))
            {
                EXPECT_EQ(Found(*rig, slot, field), 8U * field.bytes) << field.name << " " << std::uint32_t{slot};
            }
        }
    }
}

TEST(ChannelBRecheck, FindsADummyThatBecameAnotherOneOfMoreBits)
{
    Verifies(req::SRS_CHB_191);
    // Given a mapping of a dummy and an object of 8 bits each
    const auto rig = std::make_unique<Rig>();
    rig->Config().dummies = DummyMapping::kAllowed;
    rig->Start();
    ASSERT_EQ(rig->Map(2U, {0x00050008U, 0x00050008U, 0x62000108U, 0x62010108U}), ConfigFault::kNone);
    // when its normal dummy becomes one of 16 bits, which leads to no object either, and the stored signature fits it
    constexpr std::uint32_t kOther = 0x00060010U;
    std::memcpy(rig->Bytes() + kNormalDummyAt, &kOther, sizeof(kOther));
    const CheckResult unsigned_result = rig->Voice().Recheck(2U);
    ASSERT_EQ(unsigned_result.fault, ConfigFault::kSignature);
    rig->Bytes()[kSignatureAt] = static_cast<std::uint8_t>(unsigned_result.signature & 0xFFU);
    rig->Bytes()[kSignatureAt + 1U] = static_cast<std::uint8_t>(unsigned_result.signature >> 8U);
    // then the length that is kept is no longer that of the normal entries
    EXPECT_EQ(rig->Voice().Recheck(2U).fault, ConfigFault::kTable);
}

TEST(ChannelBRecheck, FindsEachBitOfALimitThatIsNotThatOfTheConfiguration)
{
    Verifies(req::SRS_CHB_192);
    // Given consumers and a producer in OPERATIONAL, and once it was left: each bit of each limit is found
    const auto rig = std::make_unique<Rig>();
    rig->Start();
    static_cast<void>(rig->Enter());
    for (const bool is_left : {false, true})
    {
        if (is_left)
        {
            static_cast<void>(rig->Leave());
        }
        for (SlotIndex slot = 0U; slot < kRigSlots; ++slot)
        {
            for (const Field& field : LimitsOf(slot))
            {
                EXPECT_EQ(Found(*rig, slot, field), 32U) << field.name << " " << std::uint32_t{slot};
            }
        }
    }
}

TEST(ChannelBRecheck, FindsBothLimitsWrongInTheSameBit)
{
    Verifies(req::SRS_CHB_192);
    const auto rig = std::make_unique<Rig>();
    rig->Start();
    static_cast<void>(rig->Enter());
    for (const Field& field : LimitsOf(0U))
    {
        rig->Bytes()[field.at] = static_cast<std::uint8_t>(rig->Bytes()[field.at] ^ 1U);
    }
    EXPECT_EQ(rig->Voice().Recheck(0U).fault, ConfigFault::kTable);
}

TEST(ChannelBRecheck, FindsALimitThatIsWrongBehindASecondEntering)
{
    Verifies(req::SRS_CHB_192);
    // Given OPERATIONAL that is left and entered again with the same configuration
    const auto rig = std::make_unique<Rig>();
    rig->Start();
    static_cast<void>(rig->Enter());
    static_cast<void>(rig->Leave());
    static_cast<void>(rig->Enter());
    // then each bit of a limit is found, as in the first one
    EXPECT_EQ(Found(*rig, 0U, LimitsOf(0U)[0U]), 32U);
}

TEST(ChannelBRecheck, ConfigurationOfTheNextOperationalIsNotComparedWithTheLimitsOfThisOne)
{
    Verifies(req::SRS_CHB_192);
    const auto rig = std::make_unique<Rig>();
    rig->Start();
    static_cast<void>(rig->Enter());
    // Given a slot that is active, when another SCT is stored and validated
    rig->Store(0U, ConfigField::kSct, 60U);
    EXPECT_EQ(rig->Validated(0U), ConfigFault::kNone);
    // then Recheck finds nothing before the next entering,
    EXPECT_EQ(rig->Voice().Recheck(0U).fault, ConfigFault::kNone);
    static_cast<void>(rig->Leave());
    EXPECT_EQ(rig->Voice().Recheck(0U).fault, ConfigFault::kNone);
    for (const Field& field : LimitsOf(0U))
    {
        EXPECT_EQ(Found(*rig, 0U, field), 0U) << field.name;
    }
    // and of the other slots, and behind the entering of this one too, what is wrong
    EXPECT_EQ(Found(*rig, 1U, LimitsOf(1U)[0U]), 32U);
    static_cast<void>(rig->Enter());
    EXPECT_EQ(Found(*rig, 0U, LimitsOf(0U)[0U]), 32U);
}

} // namespace
} // namespace counterpoint
