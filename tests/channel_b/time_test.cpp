// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Channel B alone: an instant that it remembers wrongly.
#include "tests/channel_b/rig.hpp"
#include "verification/trace/ids/channel_b.hpp"
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

constexpr std::size_t kWordBytes = 4U;
constexpr std::uint32_t kBits = 32U;

std::uint8_t* Object(Rig& rig)
{
    return reinterpret_cast<std::uint8_t*>(static_cast<channel_b::Channel*>(&rig.Voice()));
}

/// Where the channel keeps the instant of its last call. Every byte is looked at, those between the members as well: a
/// rig whose object is looked at is static, so that all of them are 0 before it is constructed.
std::vector<std::size_t> InstantsOf(Rig& rig)
{
    std::vector<std::size_t> places;
    for (std::size_t at = 0U; at < sizeof(channel_b::Channel); at += kWordBytes)
    {
        std::uint32_t word = 0U;
        std::memcpy(&word, Object(rig) + at, kWordBytes);
        if (word == rig.Now())
        {
            places.push_back(at);
        }
    }
    return places;
}

void Change(Rig& rig, std::size_t at, std::uint32_t set, std::uint32_t turned)
{
    std::uint32_t word = 0U;
    std::memcpy(&word, Object(rig) + at, kWordBytes);
    word = (word | set) ^ turned;
    std::memcpy(Object(rig) + at, &word, kWordBytes);
}

/// Slot 0 is released, slot 1 produces.
void Work(Rig& rig)
{
    rig.Start();
    static_cast<void>(rig.Enter());
    rig.Pair(0U, 0x0123456789ABCDEFU);
    ASSERT_EQ(rig.Acknowledged().released, 1U);
}

TEST(ChannelBTime, FlippedBitOfTheLastInstantEndsOperationalUntilRestart)
{
    Verifies(req::SRS_CHB_190);
    static Rig rig;
    Work(rig);
    const std::vector<std::size_t> places = InstantsOf(rig);
    ASSERT_EQ(places.size(), 2U);
    for (const std::size_t at : places)
    {
        for (std::uint32_t bit = 0U; bit < kBits; ++bit)
        {
            // Given a released consumer and a producer, when a bit of the instant flips
            Work(rig);
            Change(rig, at, 0U, 1U << bit);
            // then the next call is outside OPERATIONAL,
            const CycleOutcome outcome = rig.Cycle();
            EXPECT_EQ(outcome.not_operational, 1U) << at << " " << bit;
            EXPECT_EQ(outcome.new_fault, 5U) << at << " " << bit;
            EXPECT_EQ(outcome.released, 0U) << at << " " << bit;
            EXPECT_EQ(outcome.is_tx, 0U) << at << " " << bit;
            // and those that follow,
            EXPECT_EQ(rig.Cycle().not_operational, 1U) << at << " " << bit;
            static_cast<void>(rig.Leave());
            EXPECT_EQ(rig.Enter().not_operational, 1U) << at << " " << bit;
            // and a Restart begins anew, however wrong it was
            Change(rig, at, 0U, 1U << bit);
            rig.Start();
            EXPECT_EQ(rig.Enter().not_operational, 0U) << at << " " << bit;
            EXPECT_EQ(rig.Cycle().is_tx, 1U) << at << " " << bit;
        }
    }
}

TEST(ChannelBTime, StuckBitOfTheLastInstantIsFoundBeforeARefreshIsLate)
{
    Verifies(req::SRS_CHB_190);
    static Rig rig;
    Work(rig);
    for (const std::size_t at : InstantsOf(rig))
    {
        // Given calls each millisecond, when bit 8 of the instant is stuck at 1: 256 us that do not go by, in half of
        // the calls
        Work(rig);
        std::uint32_t calls = 0U;
        for (bool is_running = true; is_running && (calls < 25U); ++calls)
        {
            Change(rig, at, 0x100U, 0U);
            is_running = rig.Cycle().not_operational == 0U;
        }
        // then it is found as soon as the bit should be 0, at most 11 calls later: in 1 ms the lowest nine bits go back
        // by 24
        EXPECT_LE(calls, 12U) << at;
    }
}

TEST(ChannelBTime, CallsOfAnyDistanceAddUpAcrossTheWrap)
{
    Verifies(req::SRS_CHB_190);
    // Given a device 65 ms before its counter wraps, when calls come at once, in time and late, beyond the wrap
    const auto rig = std::make_unique<Rig>();
    Work(*rig);
    for (const std::uint32_t elapsed_us : {0U, 1U, 1500U, 40000U, 60000U, 0x7FFFFFFFU, 0x80000000U, 0xFFFFFFFFU, 1000U})
    {
        // then none of them is outside OPERATIONAL
        EXPECT_EQ(rig->Cycle(elapsed_us).not_operational, 0U) << elapsed_us;
    }
}

} // namespace
} // namespace counterpoint
