// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Every single bit of the storage of channel B flipped, in every phase, beside a sound other channel and comparator.
#include "verification/conformance/flip_rig.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/ids/conformance.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint
{
namespace
{

class ChannelBFlipped : public ::testing::TestWithParam<std::uint32_t>
{
};

TEST_P(ChannelBFlipped, AutomaticGrantsNothingWrong)
{
    Verifies(req::SRS_CONS_024);
    Verifies(req::SRS_CNF_030);
    // Given each phase, when any one bit of the storage flips, then nothing is granted that is not the last valid pair
    const conformance::FlipResult result =
        conformance::FlipEveryBit(conformance::Party::kB, ReleasePolicy::kAutomatic, GetParam());
    EXPECT_EQ(result.complaints, 0U) << result.first;
    // and the device still works after it
    EXPECT_EQ(result.granted, result.runs);
}

TEST_P(ChannelBFlipped, InterlockGrantsNothingWrong)
{
    Verifies(req::SRS_CONS_024);
    Verifies(req::SRS_CNF_030);
    const conformance::FlipResult result =
        conformance::FlipEveryBit(conformance::Party::kB, ReleasePolicy::kInterlock, GetParam());
    EXPECT_EQ(result.complaints, 0U) << result.first;
    EXPECT_EQ(result.granted, result.runs);
}

TEST_P(ChannelBFlipped, StaticMappingGrantsNothingWrong)
{
    Verifies(req::SRS_CONS_024);
    Verifies(req::SRS_CNF_030);
    Verifies(req::SRS_CFG_032);
    // Given static mappings and late detection, when any one bit flips, fields and copies of the setup included
    const conformance::FlipResult result = conformance::FlipEveryBit(conformance::Party::kB, ReleasePolicy::kAutomatic,
                                                                     GetParam(), conformance::RigKind::kFixed);
    EXPECT_EQ(result.complaints, 0U) << result.first;
    EXPECT_EQ(result.granted, result.runs);
}

TEST_P(ChannelBFlipped, BitsAndDummiesGrantNothingWrong)
{
    Verifies(req::SRS_CONS_024);
    Verifies(req::SRS_CNF_030);
    Verifies(req::SRS_CFG_033);
    // Given objects of 3 and 12 bits and a dummy pair
    const conformance::FlipResult result = conformance::FlipEveryBit(conformance::Party::kB, ReleasePolicy::kInterlock,
                                                                     GetParam(), conformance::RigKind::kBits);
    EXPECT_EQ(result.complaints, 0U) << result.first;
    EXPECT_EQ(result.granted, result.runs);
}

TEST_P(ChannelBFlipped, FilledMemoryGrantsNothing)
{
    Verifies(req::SRS_CONS_024);
    Verifies(req::SRS_CNF_030);
    static constexpr std::uint8_t kFills[] = {0x00U, 0xFFU, 0x5AU, 0xA5U, 0xA6U};
    static constexpr conformance::RigKind kKinds[] = {conformance::RigKind::kBytes, conformance::RigKind::kFixed,
                                                      conformance::RigKind::kBits};
    for (const conformance::RigKind kind : kKinds)
    {
        for (const std::uint8_t fill : kFills)
        {
            const conformance::FlipResult result =
                conformance::FillStorage(conformance::Party::kB, ReleasePolicy::kAutomatic, GetParam(), fill, kind);
            EXPECT_EQ(result.complaints, 0U) << result.first;
            EXPECT_EQ(result.granted, result.runs);
        }
    }
}

TEST(ChannelBFlippedEntries, AreFoundByTheTableWhateverTheSignature)
{
    Verifies(req::SRS_CFG_030);
    Verifies(req::SRS_CNF_030);
    for (const conformance::RigKind kind : {conformance::RigKind::kBytes, conformance::RigKind::kBits})
    {
        // Given a configured device, when a bit of an entry flips and the result is signed, then the table finds it
        const conformance::FlipResult result = conformance::FlipSignedEntries(conformance::Party::kB, kind);
        EXPECT_EQ(result.complaints, 0U) << result.first;
        EXPECT_GE(result.granted, 4U * 32U);
    }
}

INSTANTIATE_TEST_SUITE_P(Phases, ChannelBFlipped, ::testing::Range(0U, conformance::kPhaseCount));

} // namespace
} // namespace counterpoint
