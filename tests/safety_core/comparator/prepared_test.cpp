// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/comparator/comparator.hpp"
#include "verification/trace/ids/kernel.hpp"
#include "verification/trace/verifies.hpp"

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <iterator>

namespace counterpoint
{
namespace
{

constexpr PreparedPair kPrepared{
    CanFrame{0x103U, FrameKind::kData, CanPortId::kFirst, 2U, {0x12U, 0x34U, 0U, 0U, 0U, 0U, 0U, 0U}},
    PrepareStatus::kReady};

TEST(ComparePrepared, EqualFramesAreEqual)
{
    Verifies(req::SRS_CMP_010);
    const PreparedPair other = kPrepared;
    EXPECT_EQ(Comparator::ComparePrepared(kPrepared, other), PreparedVerdict::kEqual);
    EXPECT_EQ(Comparator::ComparePrepared(PreparedPair{}, PreparedPair{}), PreparedVerdict::kEqual);
}

TEST(ComparePrepared, AnotherStatusKindControllerOrLengthIsADisagreement)
{
    Verifies(req::SRS_CMP_010);
    const auto disagrees = [](const PreparedPair& other)
    {
        EXPECT_EQ(Comparator::ComparePrepared(kPrepared, other), PreparedVerdict::kDisagreement);
        EXPECT_EQ(Comparator::ComparePrepared(other, kPrepared), PreparedVerdict::kDisagreement);
    };
    PreparedPair other = kPrepared;
    other.status = PrepareStatus::kNotProducer;
    disagrees(other);
    other = kPrepared;
    other.normal.kind = FrameKind::kRemote;
    disagrees(other);
    other = kPrepared;
    other.normal.port = CanPortId::kSecond;
    disagrees(other);
    other = kPrepared;
    other.normal.length_bytes = 3U;
    disagrees(other);
    // One that is not a producer hands out an empty frame: that is no question of inversion.
    disagrees(PreparedPair{CanFrame{}, PrepareStatus::kNotProducer});
}

TEST(ComparePrepared, EveryBitOfTheIdentifierIsADisagreementWhateverTheData)
{
    Verifies(req::SRS_CMP_010);
    for (std::uint32_t bit = 0U; bit < 32U; ++bit)
    {
        PreparedPair other = kPrepared;
        other.normal.identifier ^= 1U << bit;
        EXPECT_EQ(Comparator::ComparePrepared(kPrepared, other), PreparedVerdict::kDisagreement) << "bit " << bit;
        other.normal.data[0] = 0x13U;
        EXPECT_EQ(Comparator::ComparePrepared(kPrepared, other), PreparedVerdict::kDisagreement) << "bit " << bit;
    }
}

TEST(ComparePrepared, EveryBitOfTheDataAloneIsNotInverse)
{
    Verifies(req::SRS_CMP_010);
    for (std::uint32_t bit = 0U; bit < 64U; ++bit)
    {
        PreparedPair other = kPrepared;
        std::uint8_t& byte = other.normal.data[bit / 8U];
        byte = static_cast<std::uint8_t>(byte ^ (1U << (bit % 8U)));
        EXPECT_EQ(Comparator::ComparePrepared(kPrepared, other), PreparedVerdict::kNotInverse) << "bit " << bit;
        EXPECT_EQ(Comparator::ComparePrepared(other, kPrepared), PreparedVerdict::kNotInverse) << "bit " << bit;
        // and with another status or length as well it is more than that
        other.normal.length_bytes = 1U;
        EXPECT_EQ(Comparator::ComparePrepared(kPrepared, other), PreparedVerdict::kDisagreement) << "bit " << bit;
        other.normal.length_bytes = 2U;
        other.status = PrepareStatus::kInvalid;
        EXPECT_EQ(Comparator::ComparePrepared(kPrepared, other), PreparedVerdict::kDisagreement) << "bit " << bit;
    }
}

// Bytes are joined to words: a bit must not be covered by its neighbours, nor two equal bits of the halves cancel.
TEST(ComparePrepared, EveryBitIsSeenAmongFullAndEmptyBytes)
{
    Verifies(req::SRS_CMP_010);
    for (const std::uint8_t fill : std::initializer_list<std::uint8_t>{0x00U, 0xFFU})
    {
        PreparedPair full = kPrepared;
        std::fill(std::begin(full.normal.data), std::end(full.normal.data), fill);
        EXPECT_EQ(Comparator::ComparePrepared(full, full), PreparedVerdict::kEqual);
        for (std::uint32_t bit = 0U; bit < 64U; ++bit)
        {
            const std::uint32_t flip = 1U << (bit % 8U);
            PreparedPair other = full;
            other.normal.data[bit / 8U] = static_cast<std::uint8_t>(fill ^ flip);
            EXPECT_EQ(Comparator::ComparePrepared(full, other), PreparedVerdict::kNotInverse) << "bit " << bit;
            EXPECT_EQ(Comparator::ComparePrepared(other, full), PreparedVerdict::kNotInverse) << "bit " << bit;
            const std::uint32_t opposite = ((bit / 8U) + 4U) % 8U;
            other.normal.data[opposite] = static_cast<std::uint8_t>(fill ^ flip);
            EXPECT_EQ(Comparator::ComparePrepared(full, other), PreparedVerdict::kNotInverse) << "bit " << bit;
        }
    }
}

} // namespace
} // namespace counterpoint
