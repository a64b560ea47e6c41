// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What the RAM test writes, word for word, and where windows and lines of spans lie that begin at no round address.
#include "safety_core/selftest/ram_test.hpp"

#include "tests/safety_core/selftest/support.hpp"
#include "verification/trace/ids/selftest.hpp"
#include "verification/trace/verifies.hpp"

#include <array>
#include <cstdint>
#include <initializer_list>
#include <utility>
#include <vector>

namespace counterpoint::selftest
{
namespace
{

/// Cells that keep what they were told; two of the exchanges may give a wrong bit 0.
class LoggedMemory final : public hal::MemoryAccess
{
  public:
    [[nodiscard]] std::uint32_t Read(const hal::Address place) const noexcept override
    {
        return cells[(place - first) / 4U] ^ ((place == misread) ? 1U : 0U);
    }
    void Write(const hal::Address place, const std::uint32_t value) noexcept override
    {
        cells[(place - first) / 4U] = value;
    }
    [[nodiscard]] std::uint32_t Exchange(const hal::Address place, const std::uint32_t value) noexcept override
    {
        const bool is_wrong = (log.size() == wrong[0]) || (log.size() == wrong[1]);
        log.emplace_back(place, value);
        return std::exchange(cells[(place - first) / 4U], value) ^ (is_wrong ? 1U : 0U);
    }
    [[nodiscard]] hal::Address StackPosition() const noexcept override
    {
        return 0x80000000U;
    }
    [[nodiscard]] hal::Address PlaceOf(const void* const /*object*/) const noexcept override
    {
        return 0x90000000U;
    }
    /// Different places of the log, in the order of their first use.
    [[nodiscard]] std::vector<hal::Address> Places() const
    {
        std::vector<hal::Address> places;
        for (const auto& entry : log)
        {
            bool is_known = false;
            for (const hal::Address place : places)
            {
                is_known = is_known || (place == entry.first);
            }
            if (!is_known)
            {
                places.push_back(entry.first);
            }
        }
        return places;
    }

    hal::Address first{0x1000U};
    std::array<std::uint32_t, 64> cells{};
    std::vector<std::pair<hal::Address, std::uint32_t>> log{};
    std::array<std::size_t, 2> wrong{SIZE_MAX, SIZE_MAX}; ///< By their number in the log.
    hal::Address misread{0U};                             ///< Where Read gives a wrong bit 0.
};

class RamPatterns : public ::testing::Test
{
  protected:
    void Restart(const hal::MemorySpan& given, const std::uint8_t slice_words)
    {
        span = given;
        test.Restart(RamSetup{{&span, 1U}, &workspace, slice_words});
        memory.log.clear();
    }
    /// Places that each slice of one pass touches.
    std::vector<std::vector<hal::Address>> Pass()
    {
        std::vector<std::vector<hal::Address>> slices;
        const std::uint32_t count = test.SlicesAPass(ports);
        for (std::uint32_t slice = 0U; slice < count; ++slice)
        {
            memory.log.clear();
            const SliceResult expected = ((slice + 1U) == count) ? SliceResult::kPassed : SliceResult::kContinues;
            EXPECT_EQ(test.Slice(ports), expected) << slice;
            slices.push_back(memory.Places());
        }
        return slices;
    }

    LoggedMemory memory{};
    WatchedLock lock{};
    RamPorts ports{memory, lock};
    RamWorkspace workspace{};
    hal::MemorySpan span{0U, 0U};
    RamTest test{};
};

using Slices = std::vector<std::vector<hal::Address>>;

// The background of a word is its address times 9E3779B1h: at 1000h 779B1000h, at 1004h F078F6C4h.
TEST_F(RamPatterns, MarchWritesBackgroundAndInverseUpAndDown)
{
    Verifies(req::SRS_STS_010);
    memory.cells[0] = 0xC0DE0000U;
    memory.cells[1] = 0xC0DE0001U;
    Restart({0x1000U, 2U}, 2U);
    EXPECT_EQ(test.Slice(ports), SliceResult::kContinues);
    const std::vector<std::pair<hal::Address, std::uint32_t>> march{
        {0x1000U, 0x779B1000U}, {0x1004U, 0xF078F6C4U},                                                 // Saved.
        {0x1000U, 0x8864EFFFU}, {0x1004U, 0x0F87093BU},                                                 // Up.
        {0x1000U, 0x779B1000U}, {0x1004U, 0xF078F6C4U}, {0x1004U, 0x0F87093BU}, {0x1000U, 0x8864EFFFU}, // Down.
        {0x1004U, 0xF078F6C4U}, {0x1000U, 0x779B1000U}};
    ASSERT_EQ(memory.log.size(), 50U);
    for (std::size_t number = 0U; number < march.size(); ++number)
    {
        EXPECT_EQ(memory.log[number].first, march[number].first) << number;
        EXPECT_EQ(memory.log[number].second, march[number].second) << number;
    }
    // Then each word through all backgrounds and their inverses, and what it held
    const std::array<std::uint32_t, 19> backgrounds{0x00000000U, 0xFFFFFFFFU, 0x00000000U, 0x55555555U, 0xAAAAAAAAU,
                                                    0x55555555U, 0x33333333U, 0xCCCCCCCCU, 0x33333333U, 0x0F0F0F0FU,
                                                    0xF0F0F0F0U, 0x0F0F0F0FU, 0x00FF00FFU, 0xFF00FF00U, 0x00FF00FFU,
                                                    0x0000FFFFU, 0xFFFF0000U, 0x0000FFFFU, 0x00000000U};
    for (std::size_t number = 0U; number < 19U; ++number)
    {
        EXPECT_EQ(memory.log[10U + number].first, 0x1000U) << number;
        EXPECT_EQ(memory.log[10U + number].second, backgrounds[number]) << number;
        EXPECT_EQ(memory.log[29U + number].first, 0x1004U) << number;
        EXPECT_EQ(memory.log[29U + number].second, backgrounds[number]) << number;
    }
    EXPECT_EQ(memory.log[48], (std::pair<hal::Address, std::uint32_t>{0x1000U, 0xC0DE0000U}));
    EXPECT_EQ(memory.log[49], (std::pair<hal::Address, std::uint32_t>{0x1004U, 0xC0DE0001U}));
}

// A window of two words has 50 exchanges, the first two of which save what it holds.
TEST_F(RamPatterns, TwoWrongReadingsDoNotCancelEachOther)
{
    Verifies(req::SRS_STS_214);
    for (std::size_t one = 2U; one < 50U; ++one)
    {
        for (std::size_t other = one + 1U; other < 50U; ++other)
        {
            Restart({0x1000U, 2U}, 2U);
            memory.wrong = {one, other};
            EXPECT_EQ(test.Slice(ports), SliceResult::kFailed) << one << ' ' << other;
        }
    }
}

// What was put back is read, and nothing else is.
TEST_F(RamPatterns, WordThatIsNotReadBackAsItWasFails)
{
    Verifies(req::SRS_STS_010);
    Verifies(req::SRS_STS_214);
    for (const hal::Address place : {hal::Address{0x1000U}, hal::Address{0x1004U}})
    {
        Restart({0x1000U, 2U}, 2U);
        memory.misread = place;
        EXPECT_EQ(test.Slice(ports), SliceResult::kFailed) << place;
    }
    Restart({0x1000U, 2U}, 2U);
    memory.misread = 0x1008U;
    EXPECT_EQ(test.Slice(ports), SliceResult::kContinues);
}

// A span that begins at 100Ch: words 0Ch 10h 14h 18h 1Ch 20h 24h. Windows of four share a word; line 4 leads from 10h,
// line 8 from 10h, line 16 from 0Ch, line 32 from nothing that is inside.
TEST_F(RamPatterns, SpanThatBeginsAtNoRoundAddress)
{
    Verifies(req::SRS_STS_011);
    Restart({0x100CU, 7U}, 4U);
    EXPECT_EQ(Pass(), (Slices{{0x100CU, 0x1010U, 0x1014U, 0x1018U},
                              {0x1018U, 0x101CU, 0x1020U, 0x1024U},
                              {0x1010U, 0x1014U},
                              {0x1010U, 0x1018U},
                              {0x100CU, 0x101CU}}));
}

TEST_F(RamPatterns, LastWindowHasTheWordsThatAreLeft)
{
    Verifies(req::SRS_STS_011);
    // Given six words at 1004h in windows of four: 4 and the three from the shared one on
    Restart({0x1004U, 6U}, 4U);
    EXPECT_EQ(Pass(), (Slices{{0x1004U, 0x1008U, 0x100CU, 0x1010U},
                              {0x1010U, 0x1014U, 0x1018U},
                              {0x1008U, 0x100CU},
                              {0x1004U, 0x100CU},
                              {0x1004U, 0x1014U}}));
    // Given as many words as a window has, and one more
    Restart({0x1008U, 4U}, 4U);
    EXPECT_EQ(Pass(), (Slices{{0x1008U, 0x100CU, 0x1010U, 0x1014U}, {0x1008U, 0x100CU}}));
    Restart({0x1008U, 5U}, 4U);
    EXPECT_EQ(Pass(), (Slices{{0x1008U, 0x100CU, 0x1010U, 0x1014U},
                              {0x1014U, 0x1018U},
                              {0x1008U, 0x100CU},
                              {0x1010U, 0x1018U},
                              {0x1008U, 0x1018U}}));
    // Given one word
    Restart({0x103CU, 1U}, 16U);
    EXPECT_EQ(Pass(), (Slices{{0x103CU}}));
}

// Whatever its first address: each word is in a window, neighbours share one, each line has a pair if it has one.
TEST_F(RamPatterns, EverySpanIsCoveredAndLeftAsItWas)
{
    Verifies(req::SRS_STS_011);
    Verifies(req::SRS_STS_010);
    for (std::uint32_t begin = 0U; begin < 20U; ++begin)
    {
        for (std::uint32_t words = 1U; words < 20U; ++words)
        {
            for (std::uint32_t word = 0U; word < 64U; ++word)
            {
                memory.cells[word] = 0xC0DE0000U + word;
            }
            Restart({0x1000U + (4U * begin), words}, 5U);
            std::array<std::uint32_t, 64> touched{};
            for (const std::vector<hal::Address>& slice : Pass())
            {
                for (const hal::Address place : slice)
                {
                    ++touched[(place - 0x1000U) / 4U];
                }
            }
            for (std::uint32_t word = 0U; word < 64U; ++word)
            {
                const bool is_inside = (word >= begin) && (word < (begin + words));
                EXPECT_EQ(touched[word] != 0U, is_inside) << begin << ' ' << words << ' ' << word;
                EXPECT_EQ(memory.cells[word], 0xC0DE0000U + word) << begin << ' ' << words << ' ' << word;
            }
        }
    }
}

} // namespace
} // namespace counterpoint::selftest
