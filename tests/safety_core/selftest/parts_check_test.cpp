// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/selftest/parts_check.hpp"

#include "hal/host/memory.hpp"
#include "tests/safety_core/selftest/support.hpp"
#include "verification/trace/ids/selftest.hpp"
#include "verification/trace/verifies.hpp"

#include <array>
#include <cstdint>

namespace counterpoint::selftest
{
namespace
{

TEST(PartsCheck, EachFlippedBitOfATablePointerIsFound)
{
    Verifies(req::SRS_STS_040);
    // Given two polymorphic objects of this program
    host::HostMemory memory;
    WatchedLock first;
    WatchedLock second;
    const std::array<hal::Address, 2> places{memory.PlaceOf(&first), memory.PlaceOf(&second)};
    PartsCheck check;
    check.Restart(PartsSetup{places.data(), 2U}, memory);
    EXPECT_TRUE(check.IsUsable());
    EXPECT_EQ(check.Check(memory), SliceResult::kPassed);
    constexpr std::uint32_t kPointerBits = 8U * sizeof(void*);
    for (std::uint32_t bit = 0U; bit < (2U * kPointerBits); ++bit)
    {
        // When one bit of one pointer flips, then the check fails
        const hal::Address place = places[bit / kPointerBits] + (4U * ((bit % kPointerBits) / 32U));
        const std::uint32_t word = memory.Read(place);
        memory.Write(place, word ^ (std::uint32_t{1U} << (bit % 32U)));
        EXPECT_EQ(check.Check(memory), SliceResult::kFailed) << "bit " << bit;
        memory.Write(place, word);
    }
    // Then, when all is back, it passes
    EXPECT_EQ(check.Check(memory), SliceResult::kPassed);
    EXPECT_EQ(check.Done(), (2U * kPointerBits) + 2U);
}

TEST(PartsCheck, WhatCannotBeUsedFails)
{
    Verifies(req::SRS_STS_040);
    Verifies(req::SRS_STS_210);
    host::ArrayMemory memory(0x1000U, 64U);
    std::array<hal::Address, 17> places{};
    for (std::size_t part = 0U; part < places.size(); ++part)
    {
        places[part] = 0x1000U + (8U * part);
    }
    // Given zero-filled memory instead of a started check
    PartsCheck check;
    EXPECT_FALSE(check.IsUsable());
    EXPECT_EQ(check.Check(memory), SliceResult::kFailed);
    // Given 16, 17 and no parts
    check.Restart(PartsSetup{places.data(), 16U}, memory);
    EXPECT_TRUE(check.IsUsable());
    EXPECT_EQ(check.Check(memory), SliceResult::kPassed);
    for (const std::uint8_t count : {std::uint8_t{17U}, std::uint8_t{0U}})
    {
        check.Restart(PartsSetup{places.data(), count}, memory);
        EXPECT_FALSE(check.IsUsable());
        EXPECT_EQ(check.Check(memory), SliceResult::kFailed);
    }
    // Given one that is not aligned
    places[3] += 1U;
    check.Restart(PartsSetup{places.data(), 4U}, memory);
    EXPECT_FALSE(check.IsUsable());
    EXPECT_EQ(check.Check(memory), SliceResult::kFailed);
    // Given that it is behind the last one, then it does not count
    check.Restart(PartsSetup{places.data(), 3U}, memory);
    EXPECT_TRUE(check.IsUsable());
    EXPECT_EQ(check.Check(memory), SliceResult::kPassed);
    // Given a second one that is as far from a word, and the first one alone
    places[2] += 1U;
    check.Restart(PartsSetup{places.data(), 4U}, memory);
    EXPECT_FALSE(check.IsUsable());
    check.Restart(PartsSetup{places.data() + 2U, 1U}, memory);
    EXPECT_FALSE(check.IsUsable());
}

} // namespace
} // namespace counterpoint::selftest
