// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/selftest/memory_signature.hpp"

#include "tests/safety_core/selftest/support.hpp"
#include "verification/trace/ids/selftest.hpp"
#include "verification/trace/verifies.hpp"

#include <array>
#include <cstdint>

namespace counterpoint::selftest
{
namespace
{

/// "12345678" in two words at 1000h, low byte first: CRC-32 9AE0DAAFh; four words of zeroes behind it.
class MemorySignatureTest : public ::testing::Test
{
  protected:
    MemorySignatureTest()
    {
        memory.Write(0x1000U, 0x3433'3231U);
        memory.Write(0x1004U, 0x3837'3635U);
    }
    void Restart(const std::uint16_t slice_words, const SignatureSource source, const std::uint32_t expected)
    {
        signature.Restart(SignatureSetup{{spans.data(), count}, slice_words, source, expected});
    }
    SliceResult Slice()
    {
        return signature.Slice(memory);
    }

    host::ArrayMemory memory{0x1000U, 6U};
    std::array<hal::MemorySpan, 2> spans{hal::MemorySpan{0x1000U, 2U}, hal::MemorySpan{0x1008U, 4U}};
    std::uint8_t count{1U};
    MemorySignature signature{};
};

TEST_F(MemorySignatureTest, IsCrc32OfTheWordsLowByteFirst)
{
    Verifies(req::SRS_STS_001);
    // Given two words in one slice
    Restart(2U, SignatureSource::kGiven, 0x9AE0'DAAFU);
    EXPECT_EQ(signature.SlicesAPass(), 1U);
    // When a pass is done, then it passes, with the published value
    EXPECT_EQ(Slice(), SliceResult::kPassed);
    EXPECT_EQ(signature.Value(), 0x9AE0'DAAFU);
    EXPECT_EQ(signature.Done(), 1U);
}

TEST_F(MemorySignatureTest, EveryRemainderOfFourBitsIsUsed)
{
    Verifies(req::SRS_STS_001);
    // Given six words on whose way each of the 16 remainders is used; the value is that of any other CRC-32
    const std::array<std::uint32_t, 6> words{0x0001'0203U, 0x0405'0607U, 0x0809'0A0BU,
                                             0x0C0D'0E0FU, 0xFFFF'FFFFU, 0x0000'0000U};
    for (std::uint32_t word = 0U; word < 6U; ++word)
    {
        memory.Write(0x1000U + (4U * word), words[word]);
    }
    spans[0].words = 6U;
    Restart(6U, SignatureSource::kGiven, 0x8A7F'A94AU);
    EXPECT_EQ(Slice(), SliceResult::kPassed);
    EXPECT_EQ(signature.Value(), 0x8A7F'A94AU);
}

TEST_F(MemorySignatureTest, SlicesAndSpansDoNotChangeIt)
{
    Verifies(req::SRS_STS_001);
    // Given the same words as two spans
    spans = {hal::MemorySpan{0x1000U, 1U}, hal::MemorySpan{0x1004U, 1U}};
    count = 2U;
    Restart(7U, SignatureSource::kGiven, 0x9AE0'DAAFU);
    EXPECT_EQ(signature.SlicesAPass(), 2U);
    // When a pass is done, then a slice ends with its span, and the value is the same, again and again
    for (std::uint32_t pass = 0U; pass < 3U; ++pass)
    {
        EXPECT_EQ(Slice(), SliceResult::kContinues);
        EXPECT_EQ(Slice(), SliceResult::kPassed);
    }
    EXPECT_EQ(signature.Done(), 6U);
    // Given six words in slices of four: 4 + 2, by spans 2 | 4 one each
    spans = {hal::MemorySpan{0x1000U, 6U}, hal::MemorySpan{0x1000U, 5U}};
    Restart(4U, SignatureSource::kTaken, 0U);
    EXPECT_EQ(signature.SlicesAPass(), 4U);
    EXPECT_EQ(Slice(), SliceResult::kContinues);
    EXPECT_EQ(Slice(), SliceResult::kContinues);
    EXPECT_EQ(Slice(), SliceResult::kContinues);
    EXPECT_EQ(Slice(), SliceResult::kPassed);
}

TEST_F(MemorySignatureTest, RestartBeginsWithTheFirstSpan)
{
    Verifies(req::SRS_STS_001);
    // Given a pass, and the first of two spans once more
    spans = {hal::MemorySpan{0x1000U, 1U}, hal::MemorySpan{0x1004U, 1U}};
    count = 2U;
    Restart(7U, SignatureSource::kGiven, 0x9AE0'DAAFU);
    EXPECT_EQ(Slice(), SliceResult::kContinues);
    EXPECT_EQ(Slice(), SliceResult::kPassed);
    EXPECT_EQ(Slice(), SliceResult::kContinues);
    // When it is started again, then there is no value yet, and a pass is both spans
    Restart(7U, SignatureSource::kGiven, 0x9AE0'DAAFU);
    EXPECT_EQ(signature.Value(), 0U);
    EXPECT_EQ(signature.Done(), 0U);
    EXPECT_EQ(Slice(), SliceResult::kContinues);
    EXPECT_EQ(Slice(), SliceResult::kPassed);
}

TEST_F(MemorySignatureTest, EachFlippedBitIsFoundAndThePassAfterStartsAnew)
{
    Verifies(req::SRS_STS_001);
    Verifies(req::SRS_STS_003);
    spans[0].words = 6U;
    Restart(3U, SignatureSource::kTaken, 0U);
    EXPECT_EQ(Slice(), SliceResult::kContinues);
    EXPECT_EQ(Slice(), SliceResult::kPassed);
    for (std::uint32_t bit = 0U; bit < 192U; ++bit)
    {
        // When one bit is flipped, then the pass fails
        const hal::Address place = 0x1000U + (4U * (bit / 32U));
        const std::uint32_t flip = std::uint32_t{1U} << (bit % 32U);
        memory.Write(place, memory.Read(place) ^ flip);
        EXPECT_EQ(Slice(), SliceResult::kContinues);
        EXPECT_EQ(Slice(), SliceResult::kFailed) << "bit " << bit;
        // and when it is back, the next one passes
        memory.Write(place, memory.Read(place) ^ flip);
        EXPECT_EQ(Slice(), SliceResult::kContinues);
        EXPECT_EQ(Slice(), SliceResult::kPassed) << "bit " << bit;
    }
}

TEST_F(MemorySignatureTest, ChangeBehindThePositionIsFoundByTheNextPass)
{
    Verifies(req::SRS_STS_003);
    Restart(1U, SignatureSource::kGiven, 0x9AE0'DAAFU);
    // Given the first word was read
    EXPECT_EQ(Slice(), SliceResult::kContinues);
    // When it changes then, then this pass ends well and the next does not
    memory.Write(0x1000U, 0U);
    EXPECT_EQ(Slice(), SliceResult::kPassed);
    EXPECT_EQ(Slice(), SliceResult::kContinues);
    EXPECT_EQ(Slice(), SliceResult::kFailed);
}

TEST_F(MemorySignatureTest, ExpectedValueIsGivenOrTakenOnce)
{
    Verifies(req::SRS_STS_002);
    // Given another expected value, then the first pass fails
    Restart(2U, SignatureSource::kGiven, 0x9AE0'DAAEU);
    EXPECT_EQ(Slice(), SliceResult::kFailed);
    // Given that it is to be taken, then the first pass takes it and the next compares
    Restart(2U, SignatureSource::kTaken, 0U);
    EXPECT_EQ(Slice(), SliceResult::kPassed);
    EXPECT_EQ(Slice(), SliceResult::kPassed);
    memory.Write(0x1004U, 0U);
    EXPECT_EQ(Slice(), SliceResult::kFailed);
    EXPECT_EQ(Slice(), SliceResult::kFailed);
    // Given neither, then it fails though the value would fit
    memory.Write(0x1004U, 0x3837'3635U);
    Restart(2U, SignatureSource::kInvalid, 0x9AE0'DAAFU);
    EXPECT_EQ(Slice(), SliceResult::kFailed);
}

TEST_F(MemorySignatureTest, WhatCannotBeUsedHasNoSlices)
{
    Verifies(req::SRS_STS_210);
    const auto slices = [this](const hal::MemorySpan& span, const std::uint8_t number, const std::uint16_t words)
    {
        spans[0] = span;
        count = number;
        Restart(words, SignatureSource::kTaken, 0U);
        return signature.SlicesAPass();
    };
    EXPECT_EQ(slices({0x1000U, 2U}, 1U, 1U), 2U);
    EXPECT_EQ(slices({0x1000U, 2U}, 1U, 0U), 0U);
    EXPECT_EQ(slices({0x1000U, 0U}, 1U, 1U), 0U);
    EXPECT_EQ(slices({0x1002U, 1U}, 1U, 1U), 0U);
    EXPECT_EQ(slices({0x1000U, 2U}, 0U, 1U), 0U);
}

TEST_F(MemorySignatureTest, PositionOutsideOfTheSpansIsNotRead)
{
    Verifies(req::SRS_STS_001);
    // Given zero-filled memory instead of a started signature, then it fails
    EXPECT_EQ(Slice(), SliceResult::kFailed);
    // Given a position at the second of two words
    Restart(1U, SignatureSource::kGiven, 0x9AE0'DAAFU);
    EXPECT_EQ(Slice(), SliceResult::kContinues);
    // When the span's length is corrupted to one word, then it fails
    spans[0].words = 1U;
    EXPECT_EQ(Slice(), SliceResult::kFailed);
    EXPECT_EQ(signature.Done(), 1U);
}

} // namespace
} // namespace counterpoint::selftest
