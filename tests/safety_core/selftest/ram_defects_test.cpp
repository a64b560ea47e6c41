// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The RAM test over cells with each simulated defect: every one has to be found within one pass.
#include "safety_core/selftest/ram_test.hpp"
#include "tests/safety_core/selftest/support.hpp"
#include "verification/trace/ids/selftest.hpp"
#include "verification/trace/verifies.hpp"

#include <cstdint>

namespace counterpoint::selftest
{
namespace
{

using host::Cell;
using host::CellDefect;
using host::Defect;

constexpr hal::Address kFirst = 0x2000'0000U;

class RamDefects : public ::testing::Test
{
  protected:
    /// Whether one pass over the words finds the defect.
    bool IsFound(const Defect& defect, const std::uint32_t words, const std::uint8_t slice_words)
    {
        const hal::MemorySpan span{kFirst, words};
        test.Restart(RamSetup{{&span, 1U}, &workspace, slice_words});
        memory.Break(defect);
        const std::uint32_t slices = test.SlicesAPass(ports);
        bool is_found = false;
        for (std::uint32_t slice = 0U; slice < slices; ++slice)
        {
            is_found = (test.Slice(ports) == SliceResult::kFailed) || is_found;
        }
        memory.Break(Defect{});
        return is_found;
    }
    static Cell At(const std::uint32_t word, const std::uint32_t bit)
    {
        return Cell{kFirst + (4U * word), static_cast<std::uint8_t>(bit)};
    }

    host::ArrayMemory cells{kFirst, 1024U};
    host::DefectiveMemory memory{cells};
    WatchedLock lock{};
    RamPorts ports{memory, lock};
    RamWorkspace workspace{};
    RamTest test{};
};

TEST_F(RamDefects, SoundCellsPass)
{
    Verifies(req::SRS_STS_010);
    EXPECT_FALSE(IsFound(Defect{}, 16U, 5U));
    EXPECT_FALSE(IsFound(Defect{}, 1024U, 16U));
}

TEST_F(RamDefects, EachStuckOrHalfStuckCell)
{
    Verifies(req::SRS_STS_010);
    Verifies(req::SRS_STS_214);
    for (const CellDefect kind :
         {CellDefect::kStuckAtZero, CellDefect::kStuckAtOne, CellDefect::kNoRise, CellDefect::kNoFall})
    {
        for (std::uint32_t cell = 0U; cell < 512U; ++cell)
        {
            const Cell victim = At(cell / 32U, cell % 32U);
            ASSERT_TRUE(IsFound(Defect{kind, victim, victim}, 16U, 5U)) << static_cast<int>(kind) << " " << cell;
        }
    }
}

// Victim and aggressor: every bit of three words with every other bit of them, twelve kinds.
TEST_F(RamDefects, EachCouplingWithinASlice)
{
    Verifies(req::SRS_STS_010);
    Verifies(req::SRS_STS_214);
    std::uint32_t defects = 0U;
    for (auto number = static_cast<std::uint8_t>(CellDefect::kInvertsOnRise);
         number <= static_cast<std::uint8_t>(CellDefect::kOneWhileOne); ++number)
    {
        const auto kind = static_cast<CellDefect>(number);
        ASSERT_NE(kind, CellDefect::kNone);
        for (std::uint32_t victim = 0U; victim < 96U; ++victim)
        {
            for (std::uint32_t aggressor = 0U; aggressor < 96U; ++aggressor)
            {
                if (victim != aggressor)
                {
                    const Defect defect{kind, At(victim / 32U, victim % 32U), At(aggressor / 32U, aggressor % 32U)};
                    ASSERT_TRUE(IsFound(defect, 3U, 3U)) << int{number} << " " << victim << " " << aggressor;
                    ++defects;
                }
            }
        }
    }
    EXPECT_EQ(defects, 91200U);
}

TEST_F(RamDefects, CouplingOfNeighboursAcrossTheEdgeOfASlice)
{
    Verifies(req::SRS_STS_011);
    // Given windows of two words: every pair of neighbours is one of them
    for (std::uint32_t word = 0U; word < 15U; ++word)
    {
        EXPECT_TRUE(IsFound(Defect{CellDefect::kInvertsOnRise, At(word, 3U), At(word + 1U, 3U)}, 16U, 2U)) << word;
        EXPECT_TRUE(IsFound(Defect{CellDefect::kSetsOnFall, At(word + 1U, 9U), At(word, 4U)}, 16U, 2U)) << word;
    }
}

TEST_F(RamDefects, EachStuckAddressLine)
{
    Verifies(req::SRS_STS_011);
    // Given 1024 words: lines 2^2 to 2^11
    for (std::uint8_t line = 2U; line < 12U; ++line)
    {
        const Cell victim{kFirst, line};
        EXPECT_TRUE(IsFound(Defect{CellDefect::kLineStuckAtZero, victim, victim}, 1024U, 5U)) << int{line};
        EXPECT_TRUE(IsFound(Defect{CellDefect::kLineStuckAtOne, victim, victim}, 1024U, 5U)) << int{line};
    }
}

TEST_F(RamDefects, WrongSelectionOfAWord)
{
    Verifies(req::SRS_STS_010);
    Verifies(req::SRS_STS_214);
    for (std::uint32_t word = 0U; word < 15U; ++word)
    {
        EXPECT_TRUE(IsFound(Defect{CellDefect::kNoCell, At(word, 0U), At(word, 0U)}, 16U, 5U)) << word;
        for (const CellDefect kind : {CellDefect::kAlias, CellDefect::kTwoCells})
        {
            EXPECT_TRUE(IsFound(Defect{kind, At(word, 0U), At(word + 1U, 0U)}, 16U, 5U)) << word;
            EXPECT_TRUE(IsFound(Defect{kind, At(word + 1U, 0U), At(word, 0U)}, 16U, 5U)) << word;
        }
    }
}

TEST_F(RamDefects, CouplingOfWordsThatNeverMeetIsTheKnownLimit)
{
    Verifies(req::SRS_STS_011);
    // Given two words that are neither neighbours nor differ in one line alone: 1 and 7
    EXPECT_FALSE(IsFound(Defect{CellDefect::kOneWhileOne, At(1U, 0U), At(7U, 31U)}, 16U, 2U));
}

} // namespace
} // namespace counterpoint::selftest
