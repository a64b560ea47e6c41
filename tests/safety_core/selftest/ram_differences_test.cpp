// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Words that read wrong once each: however many there are, they do not hide each other.
#include "safety_core/selftest/ram_test.hpp"

#include "hal/host/memory.hpp"
#include "tests/safety_core/selftest/support.hpp"
#include "verification/trace/ids/selftest.hpp"
#include "verification/trace/verifies.hpp"

#include <cstdint>
#include <initializer_list>
#include <vector>

namespace counterpoint::selftest
{
namespace
{

/// Good cells that are read wrong, in bit 0, at two of all accesses.
class TwiceWrongMemory final : public hal::MemoryAccess
{
  public:
    TwiceWrongMemory(const std::uint32_t first_wrong, const std::uint32_t second_wrong)
        : first_(first_wrong), second_(second_wrong)
    {
    }
    [[nodiscard]] std::uint32_t Read(const hal::Address place) const noexcept override
    {
        return cells_.Read(place) ^ Wrong();
    }
    void Write(const hal::Address place, const std::uint32_t value) noexcept override
    {
        cells_.Write(place, value);
    }
    [[nodiscard]] std::uint32_t Exchange(const hal::Address place, const std::uint32_t value) noexcept override
    {
        return cells_.Exchange(place, value) ^ Wrong();
    }
    [[nodiscard]] hal::Address StackPosition() const noexcept override
    {
        return 0x80000000U;
    }
    [[nodiscard]] hal::Address PlaceOf(const void* const /*object*/) const noexcept override
    {
        return 0x90000000U;
    }

    mutable std::uint32_t accesses{0U};

  private:
    [[nodiscard]] std::uint32_t Wrong() const noexcept
    {
        const bool is_wrong = (accesses == first_) || (accesses == second_);
        ++accesses;
        return is_wrong ? 1U : 0U;
    }

    host::ArrayMemory cells_{0x1000U, 3U};
    std::uint32_t first_;
    std::uint32_t second_;
};

constexpr std::uint32_t kNever = 0xFFFFFFFFU;

// One window of three words: 3 accesses that take what is there, 4 * 3 of the march, 3 * 19 of the backgrounds, 3 that
// give it back and 3 that look.
constexpr std::uint32_t kAccesses = 78U;

/// What the first slice says, and how often it reads; the lines have two words, which no background runs through.
SliceResult FirstSlice(TwiceWrongMemory& memory)
{
    WatchedLock lock{};
    RamWorkspace workspace{};
    const std::vector<hal::MemorySpan> spans{{0x1000U, 3U}};
    RamTest test{};
    test.Restart(RamSetup{{spans.data(), 1U}, &workspace, 3U});
    return test.Slice(RamPorts{memory, lock});
}

TEST(RamDifferences, TwoHideNoneOfEachOther)
{
    Verifies(req::SRS_STS_010);
    TwiceWrongMemory sound{kNever, kNever};
    EXPECT_EQ(FirstSlice(sound), SliceResult::kContinues);
    EXPECT_EQ(sound.accesses, kAccesses);
    for (std::uint32_t first = 3U; first < kAccesses; ++first)
    {
        for (std::uint32_t second = first; second < kAccesses; ++second)
        {
            TwiceWrongMemory memory{first, second};
            EXPECT_EQ(FirstSlice(memory), SliceResult::kFailed) << first << ", " << second;
        }
    }
}

// Two words of a line: 2 + 4 * 2 + 2 + 2.
TEST(RamDifferences, LineRunsThroughNoBackgrounds)
{
    Verifies(req::SRS_STS_011);
    TwiceWrongMemory memory{kNever, kNever};
    WatchedLock lock{};
    RamWorkspace workspace{};
    const std::vector<hal::MemorySpan> spans{{0x1000U, 3U}};
    RamTest test{};
    test.Restart(RamSetup{{spans.data(), 1U}, &workspace, 3U});
    EXPECT_EQ(test.Slice(RamPorts{memory, lock}), SliceResult::kContinues);
    memory.accesses = 0U;
    EXPECT_EQ(test.Slice(RamPorts{memory, lock}), SliceResult::kContinues);
    EXPECT_EQ(memory.accesses, 14U);
}

} // namespace
} // namespace counterpoint::selftest
