// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The signature over the program that runs this test: its code, its constants, its tables of virtual functions.
#include "hal/host/memory.hpp"
#include "hal/host/program_image.hpp"
#include "safety_core/selftest/memory_signature.hpp"
#include "tests/safety_core/selftest/support.hpp"
#include "verification/trace/ids/selftest.hpp"
#include "verification/trace/verifies.hpp"

#include <cstdint>
#include <cstring>
#include <sys/mman.h>
#include <vector>

namespace counterpoint::selftest
{
namespace
{

/// Never called: its address is all that is used. Long enough for a byte in its midst.
[[gnu::noinline, gnu::used]] std::uint32_t NeverCalled(std::uint32_t value)
{
    for (std::uint32_t round = 0U; round < value; ++round)
    {
        value = (value * 1664525U) + 1013904223U;
    }
    return value;
}

[[gnu::used]] const std::uint32_t kTable[4] = {0x11111111U, 0x22222222U, 0x33333333U, 0x44444444U};

class Unused
{
  public:
    virtual std::uint32_t First() const
    {
        return 1U;
    }
    virtual ~Unused() = default;
};

class ProgramMemory : public ::testing::Test
{
  protected:
    ProgramMemory()
    {
        signature.Restart(SignatureSetup{
            {spans.data(), static_cast<std::uint8_t>(spans.size())}, 1024U, SignatureSource::kTaken, 0U});
        EXPECT_EQ(Pass(), SliceResult::kPassed);
    }
    SliceResult Pass()
    {
        SliceResult result = SliceResult::kInvalid;
        const std::uint32_t slices = signature.SlicesAPass();
        for (std::uint32_t slice = 0U; slice < slices; ++slice)
        {
            result = signature.Slice(memory);
        }
        return result;
    }
    /// One bit of the program, though it is not allowed to write there.
    static void Flip(const hal::Address place, const int protection)
    {
        const hal::Address page = place - (place % 4096U);
        ASSERT_EQ(mprotect(reinterpret_cast<void*>(page), 4096U, protection | PROT_WRITE), 0);
        volatile std::uint8_t& byte = *reinterpret_cast<volatile std::uint8_t*>(place);
        byte = static_cast<std::uint8_t>(byte ^ 0x10U);
        ASSERT_EQ(mprotect(reinterpret_cast<void*>(page), 4096U, protection), 0);
    }
    void FlipIsFound(const hal::Address place, const int protection)
    {
        Flip(place, protection);
        EXPECT_EQ(Pass(), SliceResult::kFailed);
        Flip(place, protection);
        EXPECT_EQ(Pass(), SliceResult::kPassed);
    }
    bool IsInImage(const hal::Address place) const
    {
        for (const hal::MemorySpan& span : spans)
        {
            if ((place >= span.first) && (place < (span.first + (hal::Address{span.words} * 4U))))
            {
                return true;
            }
        }
        return false;
    }

    host::HostMemory memory{};
    std::vector<hal::MemorySpan> spans{host::ReadOnlyImage()};
    MemorySignature signature{};
};

TEST_F(ProgramMemory, SoundProgramPassesAgainAndAgain)
{
    Verifies(req::SRS_STS_003);
    EXPECT_GE(spans.size(), 3U);
    EXPECT_EQ(Pass(), SliceResult::kPassed);
    EXPECT_EQ(Pass(), SliceResult::kPassed);
}

TEST_F(ProgramMemory, FlippedByteOfCodeIsFound)
{
    Verifies(req::SRS_STS_003);
    // Given a function of this program
    const hal::Address place = reinterpret_cast<hal::Address>(&NeverCalled) + 5U;
    ASSERT_TRUE(IsInImage(place));
    // When a bit of its code flips, then the next pass finds it; when it is back, the next pass is well
    FlipIsFound(place, PROT_READ | PROT_EXEC);
}

TEST_F(ProgramMemory, FlippedByteOfAConstantTableIsFound)
{
    Verifies(req::SRS_STS_003);
    const hal::Address place = reinterpret_cast<hal::Address>(&kTable[2]) + 1U;
    ASSERT_TRUE(IsInImage(place));
    FlipIsFound(place, PROT_READ);
}

TEST_F(ProgramMemory, FlippedByteOfATableOfVirtualFunctionsIsFound)
{
    Verifies(req::SRS_STS_003);
    // Given the table of a class of this program
    const Unused object{};
    hal::Address table = 0U;
    std::memcpy(&table, static_cast<const void*>(&object), sizeof table);
    ASSERT_TRUE(IsInImage(table));
    FlipIsFound(table + 8U, PROT_READ);
}

TEST_F(ProgramMemory, FlippedByteOfTheTableThatComputesTheSignatureIsFound)
{
    Verifies(req::SRS_STS_003);
    // Given the place of the 16 remainders in this program: the only one with their first four
    constexpr std::uint32_t kFirst[4] = {0x00000000U, 0x1DB71064U, 0x3B6E20C8U, 0x26D930ACU};
    std::vector<hal::Address> found;
    for (const hal::MemorySpan& span : spans)
    {
        for (std::uint32_t word = 0U; (word + 4U) <= span.words; ++word)
        {
            const hal::Address place = span.first + (hal::Address{word} * 4U);
            const bool fits = (memory.Read(place) == kFirst[0]) && (memory.Read(place + 4U) == kFirst[1]) &&
                              (memory.Read(place + 8U) == kFirst[2]) && (memory.Read(place + 12U) == kFirst[3]);
            // The word behind them tells the table of this room from the copy in this test.
            if (fits && (memory.Read(place + 16U) == 0x76DC4190U) && (memory.Read(place + 60U) == 0xBDBDF21CU))
            {
                found.push_back(place);
            }
        }
    }
    ASSERT_GE(found.size(), 1U);
    for (const hal::Address place : found)
    {
        FlipIsFound(place + 6U, PROT_READ);
    }
}

} // namespace
} // namespace counterpoint::selftest
