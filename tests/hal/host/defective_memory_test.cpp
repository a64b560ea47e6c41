// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/defective_memory.hpp"
#include "verification/trace/ids/selftest.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace counterpoint::host
{
namespace
{

/// Four words at 1000h; the victim is bit 3 of the second, the aggressor bit 7 of the third.
class DefectiveMemoryTest : public ::testing::Test
{
  protected:
    void Break(const CellDefect kind)
    {
        memory.Break(Defect{kind, Cell{0x1004U, 3U}, Cell{0x1008U, 7U}});
    }
    std::uint32_t Victim(const std::uint32_t value)
    {
        memory.Write(0x1004U, value);
        return memory.Read(0x1004U);
    }
    void Aggressor(const std::uint32_t value)
    {
        memory.Write(0x1008U, value);
    }

    ArrayMemory cells{0x1000U, 4U};
    DefectiveMemory memory{cells};
};

TEST_F(DefectiveMemoryTest, SoundCellsKeepWhatIsWritten)
{
    Verifies(req::SRS_STS_015);
    EXPECT_EQ(Victim(0xFFFF'FFFFU), 0xFFFF'FFFFU);
    EXPECT_EQ(memory.Exchange(0x1004U, 5U), 0xFFFF'FFFFU);
    EXPECT_EQ(memory.Read(0x1004U), 5U);
    EXPECT_EQ(memory.Accesses(), 5U);
    EXPECT_EQ(memory.StackPosition(), 0U);
}

TEST_F(DefectiveMemoryTest, ItsCellsAreReachedWithoutTheDefectToo)
{
    Verifies(req::SRS_STS_015);
    Break(CellDefect::kStuckAtZero);
    EXPECT_EQ(Victim(0x8U), 0U);
    EXPECT_EQ(cells.Exchange(0x1004U, 0xAU), 0U);
    EXPECT_EQ(cells.Read(0x1004U), 0xAU);
    EXPECT_EQ(memory.PlaceOf(&cells), 0U); // An array has no place of its own in a memory.
}

TEST_F(DefectiveMemoryTest, StuckAndHalfStuckCells)
{
    Verifies(req::SRS_STS_015);
    Break(CellDefect::kStuckAtZero);
    EXPECT_EQ(Victim(0xFFFF'FFFFU), 0xFFFF'FFF7U);
    Break(CellDefect::kStuckAtOne);
    EXPECT_EQ(Victim(0U), 8U);
    Break(CellDefect::kNone);
    EXPECT_EQ(Victim(0U), 0U);
    Break(CellDefect::kNoRise);
    EXPECT_EQ(Victim(0xFFU), 0xF7U);
    Break(CellDefect::kNone);
    EXPECT_EQ(Victim(0xFFU), 0xFFU);
    Break(CellDefect::kNoFall);
    EXPECT_EQ(Victim(0U), 8U);
}

TEST_F(DefectiveMemoryTest, CouplingByAChange)
{
    Verifies(req::SRS_STS_015);
    struct Expected
    {
        CellDefect kind;
        std::uint32_t zero_after_rise;
        std::uint32_t zero_after_fall;
        std::uint32_t one_after_rise;
        std::uint32_t one_after_fall;
    };
    constexpr Expected kExpected[] = {
        {CellDefect::kInvertsOnRise, 8U, 0U, 0U, 8U}, {CellDefect::kInvertsOnFall, 0U, 8U, 8U, 0U},
        {CellDefect::kSetsOnRise, 8U, 0U, 8U, 8U},    {CellDefect::kSetsOnFall, 0U, 8U, 8U, 8U},
        {CellDefect::kClearsOnRise, 0U, 0U, 0U, 8U},  {CellDefect::kClearsOnFall, 0U, 0U, 8U, 0U},
    };
    for (const Expected& expected : kExpected)
    {
        const auto after = [this, &expected](const std::uint32_t victim, const bool rises)
        {
            Break(CellDefect::kNone);
            Aggressor(rises ? 0U : 0x80U);
            EXPECT_EQ(Victim(victim), victim);
            Break(expected.kind);
            Aggressor(rises ? 0x80U : 0U);
            return memory.Read(0x1004U);
        };
        EXPECT_EQ(after(0U, true), expected.zero_after_rise) << static_cast<int>(expected.kind);
        EXPECT_EQ(after(0U, false), expected.zero_after_fall) << static_cast<int>(expected.kind);
        EXPECT_EQ(after(8U, true), expected.one_after_rise) << static_cast<int>(expected.kind);
        EXPECT_EQ(after(8U, false), expected.one_after_fall) << static_cast<int>(expected.kind);
    }
}

TEST_F(DefectiveMemoryTest, CouplingByAState)
{
    Verifies(req::SRS_STS_015);
    Break(CellDefect::kZeroWhileOne);
    Aggressor(0x80U);
    EXPECT_EQ(Victim(0xFFU), 0xF7U);
    Aggressor(0U);
    EXPECT_EQ(Victim(0xFFU), 0xFFU);
    Break(CellDefect::kZeroWhileZero);
    EXPECT_EQ(memory.Read(0x1004U), 0xF7U);
    Break(CellDefect::kOneWhileZero);
    EXPECT_EQ(Victim(0U), 8U);
    Break(CellDefect::kOneWhileOne);
    EXPECT_EQ(Victim(0U), 0U);
    Aggressor(0x80U);
    EXPECT_EQ(memory.Read(0x1004U), 8U);
}

TEST_F(DefectiveMemoryTest, WrongSelection)
{
    Verifies(req::SRS_STS_015);
    // Given four words 1, 2, 3, 4
    for (std::uint32_t word = 0U; word < 4U; ++word)
    {
        memory.Write(0x1000U + (4U * word), word + 1U);
    }
    // When line 2^3 selects 0, then the third is the first; when it selects 1, the first is the third
    memory.Break(Defect{CellDefect::kLineStuckAtZero, Cell{0x1000U, 3U}, Cell{0x1000U, 0U}});
    EXPECT_EQ(memory.Read(0x1008U), 1U);
    memory.Break(Defect{CellDefect::kLineStuckAtOne, Cell{0x1000U, 3U}, Cell{0x1000U, 0U}});
    EXPECT_EQ(memory.Read(0x1000U), 3U);
    // When the second is absent, then it reads as ones and keeps nothing
    Break(CellDefect::kNoCell);
    EXPECT_EQ(Victim(7U), 0xFFFF'FFFFU);
    // When the second is the third, then what is written to it is there
    Break(CellDefect::kAlias);
    EXPECT_EQ(Victim(9U), 9U);
    EXPECT_EQ(memory.Read(0x1008U), 9U);
    // When it is both, then both are written, and read together
    Break(CellDefect::kTwoCells);
    EXPECT_EQ(Victim(0xF0U), 0xF0U);
    EXPECT_EQ(memory.Read(0x1008U), 0xF0U);
    Aggressor(0x3CU);
    EXPECT_EQ(memory.Read(0x1004U), 0x30U);
}

} // namespace
} // namespace counterpoint::host
