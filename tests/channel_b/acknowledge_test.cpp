// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The level of the acknowledge inputs: what two calls agreed upon, and what a flipped bit makes of it.
#include "channel_b/acknowledge.hpp"
#include "tests/channel_b/rig.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <vector>

namespace counterpoint
{
namespace
{

TEST(ChannelBAcknowledge, RisesWithTheSecondOfTwoCallsThatGiveOne)
{
    Verifies(req::SRS_REL_005);
    // Given inputs that are 1 from the start, then nothing rises
    channel_b::Acknowledge acknowledge;
    EXPECT_EQ(acknowledge.Follow(~SrdoMask{0U}), 0U);
    EXPECT_EQ(acknowledge.Follow(~SrdoMask{0U}), 0U);
    // when they read 0 twice and 1 twice, then they rise with the second 1, once
    EXPECT_EQ(acknowledge.Follow(0U), 0U);
    EXPECT_EQ(acknowledge.Follow(0U), 0U);
    EXPECT_EQ(acknowledge.Follow(~SrdoMask{0U}), 0U);
    EXPECT_EQ(acknowledge.Follow(~SrdoMask{0U}), ~SrdoMask{0U});
    EXPECT_EQ(acknowledge.Follow(~SrdoMask{0U}), 0U);
}

TEST(ChannelBAcknowledge, FollowsEachInputByItself)
{
    Verifies(req::SRS_REL_005);
    // Given inputs 0: low, then high; 1: low for one call only; 2: never two calls alike; 3: high for one call only;
    // 63: low, a glitch, low, then high
    struct Step
    {
        SrdoMask inputs;
        SrdoMask rising;
    };
    static constexpr SrdoMask kLast = SrdoMask{1U} << 63U;
    static constexpr Step kSteps[] = {
        {0x02U, 0U},            // 0, 3 and 63 read 0; so does 2
        {0x04U, 0U},            // 0, 3 and 63 are low; 1 reads 0
        {0x0AU | kLast, 0U},    // 3 and 63 read 1 once; 1 was never low
        {0x07U, 0U},            // 0 reads 1; 3 and 63 read 0 again
        {0x03U | kLast, 1U},    // 0 rises
        {0x07U | kLast, kLast}, // 63 rises; 2 never did
        {0x07U | kLast, 0U},    // 2 is high as it always was
    };
    channel_b::Acknowledge acknowledge;
    for (const Step& step : kSteps)
    {
        EXPECT_EQ(acknowledge.Follow(step.inputs), step.rising) << step.inputs;
    }
}

TEST(ChannelBAcknowledge, OneFlippedBitIsNoEdge)
{
    Verifies(req::SRS_REL_005);
    Verifies(req::SRS_CONS_024);
    static const std::vector<std::vector<SrdoMask>> kHistories = {
        {~SrdoMask{0U}, ~SrdoMask{0U}}, // High.
        {0U, 0U},                       // Low.
        {0U, 0U, 0U, 0U, ~SrdoMask{0U}, ~SrdoMask{0U}, ~SrdoMask{0U}},
    };
    constexpr std::size_t kBits = 8U * sizeof(channel_b::Acknowledge);
    EXPECT_GE(kBits, 192U);
    for (const std::vector<SrdoMask>& history : kHistories)
    {
        for (std::size_t bit = 0U; bit < kBits; ++bit)
        {
            // Given a level that has been told, when a bit of the record flips and the inputs stay
            channel_b::Acknowledge acknowledge;
            for (const SrdoMask inputs : history)
            {
                static_cast<void>(acknowledge.Follow(inputs));
            }
            std::uint8_t bytes[sizeof(channel_b::Acknowledge)];
            std::memcpy(bytes, &acknowledge, sizeof(bytes));
            bytes[bit / 8U] = static_cast<std::uint8_t>(bytes[bit / 8U] ^ (1U << (bit % 8U)));
            std::memcpy(&acknowledge, bytes, sizeof(bytes));
            // then nothing rises
            for (std::uint32_t call = 0U; call < 4U; ++call)
            {
                EXPECT_EQ(acknowledge.Follow(history.back()), 0U) << bit << " " << call;
            }
        }
    }
}

TEST(ChannelBAcknowledge, OneFlippedBitBeforeTheFirstCallIsNoEdge)
{
    Verifies(req::SRS_REL_005);
    Verifies(req::SRS_CONS_024);
    constexpr std::size_t kBits = 8U * sizeof(channel_b::Acknowledge);
    for (std::size_t bit = 0U; bit < kBits; ++bit)
    {
        // Given a record that followed nothing yet, when a bit of it flips
        channel_b::Acknowledge acknowledge;
        std::uint8_t bytes[sizeof(channel_b::Acknowledge)];
        std::memcpy(bytes, &acknowledge, sizeof(bytes));
        bytes[bit / 8U] = static_cast<std::uint8_t>(bytes[bit / 8U] ^ (1U << (bit % 8U)));
        std::memcpy(&acknowledge, bytes, sizeof(bytes));
        // then inputs that are 1 from the start are no edge
        for (std::uint32_t call = 0U; call < 4U; ++call)
        {
            EXPECT_EQ(acknowledge.Follow(~SrdoMask{0U}), 0U) << bit << " " << call;
        }
    }
}

/// A consumer that holds a pair and waits for its acknowledge.
void Hold(Rig& rig)
{
    rig.Start();
    static_cast<void>(rig.Enter());
    rig.Pair(0U, 0x0123456789ABCDEFU);
    EXPECT_EQ(rig.Cycle().waiting & 1U, 1U);
}

TEST(ChannelBAcknowledge, LevelOfOneCallReleasesNothing)
{
    Verifies(req::SRS_REL_005);
    Verifies(req::SRS_REL_004);
    const auto rig = std::make_unique<Rig>();
    Hold(*rig);
    // When the input reads 1 in one call, then in two
    rig->Read(1U);
    EXPECT_EQ(rig->Cycle().released, 0U);
    rig->Read(0U);
    EXPECT_EQ(rig->Cycle().released, 0U);
    rig->Read(1U);
    EXPECT_EQ(rig->Cycle().released, 0U);
    // then the second of the two releases
    EXPECT_EQ(rig->Cycle().released, 1U);
    // and a 0 of one call is not the beginning of another edge
    rig->Normal(0U, 1U);
    rig->Normal(0U, 1U);
    EXPECT_EQ(rig->Cycle().faulted, 1U);
    rig->Pair(0U, 1U);
    rig->Read(0U);
    EXPECT_EQ(rig->Cycle().released, 0U);
    rig->Read(1U);
    EXPECT_EQ(rig->Cycle().released, 0U);
    EXPECT_EQ(rig->Cycle().released, 0U);
}

TEST(ChannelBAcknowledge, LevelIsFollowedBeforeOperational)
{
    Verifies(req::SRS_REL_005);
    // Given a level that rose before OPERATIONAL, then it is no edge behind it
    const auto rig = std::make_unique<Rig>();
    rig->Start();
    static_cast<void>(rig->Cycle());
    rig->Read(1U);
    static_cast<void>(rig->Cycle());
    static_cast<void>(rig->Cycle());
    static_cast<void>(rig->Enter());
    rig->Pair(0U, 1U);
    EXPECT_EQ(rig->Cycle().released, 0U);
    EXPECT_EQ(rig->Cycle().released, 0U);
    // and one whose second call is the one that enters waits for its pair
    rig->Start();
    static_cast<void>(rig->Cycle());
    rig->Read(1U);
    static_cast<void>(rig->Cycle());
    static_cast<void>(rig->Enter());
    rig->Pair(0U, 1U);
    EXPECT_EQ(rig->Cycle().released, 1U);
}

TEST(ChannelBAcknowledge, WaitsFromTheCallThatSeesTheEdge)
{
    Verifies(req::SRS_REL_005);
    // Given a window of 5 ms and an edge, when the pair comes with the call 5 ms later, or 1 us after that
    for (const std::uint32_t late_us : {0U, 1U})
    {
        const auto rig = std::make_unique<Rig>();
        rig->Config().acknowledge_window_us = 5000U;
        rig->Start();
        static_cast<void>(rig->Enter());
        static_cast<void>(rig->Acknowledged());
        for (std::uint32_t call = 0U; call < 4U; ++call)
        {
            static_cast<void>(rig->Cycle());
        }
        rig->Pair(0U, 1U); // 20 us.
        EXPECT_EQ(rig->Cycle(980U + late_us).released, (late_us == 0U) ? 1U : 0U);
    }
}

} // namespace
} // namespace counterpoint
