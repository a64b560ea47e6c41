// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/variable.hpp"

#include "verification/trace/ids/kernel.hpp"
#include "verification/trace/verifies.hpp"

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <iterator>

namespace counterpoint
{
namespace
{

TEST(Variable, BytesAreInTheOrderOfTheWire)
{
    Verifies(req::SRS_KRN_016);
    std::uint8_t bytes[8] = {0U, 0U, 0U, 0U, 0U, 0U, 0U, 0xEEU};
    WriteVariable(VariablePlace{bytes, 32U}, VariableValue{0xFF12345678U});
    EXPECT_EQ(bytes[0], 0x78U);
    EXPECT_EQ(bytes[1], 0x56U);
    EXPECT_EQ(bytes[2], 0x34U);
    EXPECT_EQ(bytes[3], 0x12U);
    EXPECT_EQ(bytes[4], 0x00U);
    EXPECT_EQ(bytes[7], 0xEEU);
    EXPECT_EQ(ReadVariable(VariablePlace{bytes, 32U}).bits, 0x12345678U);
    EXPECT_EQ(ReadVariable(VariablePlace{bytes, 64U}).bits, 0xEE00000012345678U);
    EXPECT_EQ(ReadVariable(VariablePlace{bytes, 8U}).bits, 0x78U);
}

TEST(Variable, PairIsInverseOnlyIfEveryBitIs)
{
    Verifies(req::SRS_KRN_016);
    std::uint8_t normal[3] = {0x12U, 0x34U, 0xFFU};
    std::uint8_t inverse[3] = {0xEDU, 0xCBU, 0xFFU};
    // Given a pair of 16 bits; the third byte does not belong to it
    EXPECT_EQ(IsInversePair(VariablePlace{normal, 16U}, VariablePlace{inverse, 16U}), PairView::kInverse);
    // When any single bit of it is flipped
    for (std::uint32_t bit = 0U; bit < 16U; ++bit)
    {
        inverse[bit / 8U] = static_cast<std::uint8_t>(inverse[bit / 8U] ^ (1U << (bit % 8U)));
        EXPECT_EQ(IsInversePair(VariablePlace{normal, 16U}, VariablePlace{inverse, 16U}), PairView::kNotInverse)
            << "bit " << bit;
        inverse[bit / 8U] = static_cast<std::uint8_t>(inverse[bit / 8U] ^ (1U << (bit % 8U)));
    }
    // Then it is no pair; nor are variables of different length
    EXPECT_EQ(IsInversePair(VariablePlace{normal, 8U}, VariablePlace{inverse, 16U}), PairView::kNotInverse);
}

// 11 bits in two bytes.
TEST(Variable, EveryBitBelowTheLastByteCounts)
{
    Verifies(req::SRS_KRN_016);
    std::uint8_t normal[2] = {0x12U, 0x04U};
    for (std::uint32_t bit = 0U; bit < 8U; ++bit)
    {
        std::uint8_t inverse[2] = {static_cast<std::uint8_t>(0xEDU ^ (1U << bit)), 0x03U};
        EXPECT_EQ(IsInversePair(VariablePlace{normal, 11U}, VariablePlace{inverse, 11U}), PairView::kNotInverse) << bit;
    }
}

// 11 bits in two bytes: bits 3 to 7 of the second byte do not belong to it.
TEST(Variable, BitsAboveTheLengthAreIgnoredAndWrittenAsZero)
{
    Verifies(req::SRS_KRN_016);
    std::uint8_t bytes[3] = {0x34U, 0xFAU, 0xEEU};
    EXPECT_EQ(ReadVariable(VariablePlace{bytes, 11U}).bits, 0x234U);
    EXPECT_EQ(ReadVariable(VariablePlace{bytes, 1U}).bits, 0U);
    EXPECT_EQ(ReadVariable(VariablePlace{bytes, 3U}).bits, 4U);
    WriteVariable(VariablePlace{bytes, 11U}, VariableValue{0xFFFFU});
    EXPECT_EQ(bytes[0], 0xFFU);
    EXPECT_EQ(bytes[1], 0x07U);
    EXPECT_EQ(bytes[2], 0xEEU);
    WriteVariable(VariablePlace{bytes, 1U}, VariableValue{0xFEU});
    EXPECT_EQ(bytes[0], 0x00U);
    std::uint8_t normal = 0xF5U;
    std::uint8_t inverse = 0xFAU;
    EXPECT_EQ(IsInversePair(VariablePlace{&normal, 4U}, VariablePlace{&inverse, 4U}), PairView::kInverse);
    EXPECT_EQ(IsInversePair(VariablePlace{&normal, 5U}, VariablePlace{&inverse, 5U}), PairView::kNotInverse);
}

TEST(Variable, PairOfEachLengthIsInverseInItsBitsAlone)
{
    Verifies(req::SRS_KRN_016);
    constexpr std::uint64_t kValue = 0x0123456789ABCDEFU;
    for (std::uint8_t length = 1U; length <= 64U; ++length)
    {
        std::uint8_t normal[8];
        std::uint8_t inverse[8];
        WriteVariable(VariablePlace{normal, 64U}, VariableValue{kValue});
        for (std::uint32_t flipped = 0U; flipped < 64U; ++flipped)
        {
            WriteVariable(VariablePlace{inverse, 64U}, VariableValue{~kValue ^ (std::uint64_t{1U} << flipped)});
            EXPECT_EQ(IsInversePair(VariablePlace{normal, length}, VariablePlace{inverse, length}),
                      (flipped < length) ? PairView::kNotInverse : PairView::kInverse)
                << static_cast<int>(length) << " " << flipped;
        }
    }
}

// Length 255: 32 bytes would be its due.
TEST(Variable, LengthAboveSixtyFourCountsAsSixtyFour)
{
    Verifies(req::SRS_KRN_575);
    for (const std::uint8_t length : std::initializer_list<std::uint8_t>{64, 65, 71, 72, 128, 255})
    {
        // Given bytes behind the 8 of the variable
        std::uint8_t bytes[40];
        for (std::uint8_t& byte : bytes)
        {
            byte = 0xEEU;
        }
        WriteVariable(VariablePlace{bytes, length}, VariableValue{0x8123456789ABCDEFU});
        // Then they are as they were
        EXPECT_EQ(bytes[0], 0xEFU);
        EXPECT_EQ(bytes[7], 0x81U);
        for (std::uint32_t byte = 8U; byte < 40U; ++byte)
        {
            EXPECT_EQ(bytes[byte], 0xEEU) << static_cast<int>(length) << " " << byte;
        }
        EXPECT_EQ(ReadVariable(VariablePlace{bytes, length}).bits, 0x8123456789ABCDEFU) << static_cast<int>(length);
    }
}

TEST(Variable, LengthOfNothingTouchesNothing)
{
    Verifies(req::SRS_KRN_575);
    std::uint8_t byte = 0xEEU;
    EXPECT_EQ(ReadVariable(VariablePlace{&byte, 0U}).bits, 0U);
    EXPECT_EQ(ReadVariable(VariablePlace{nullptr, 0U}).bits, 0U);
    WriteVariable(VariablePlace{&byte, 0U}, VariableValue{0x12U});
    WriteVariable(VariablePlace{nullptr, 0U}, VariableValue{0x12U});
    EXPECT_EQ(byte, 0xEEU);
}

TEST(Variable, PairOfALengthThatThereIsNotIsNotInverse)
{
    Verifies(req::SRS_KRN_575);
    std::uint8_t normal[32];
    std::uint8_t inverse[32];
    for (std::uint32_t byte = 0U; byte < 32U; ++byte)
    {
        normal[byte] = 0x5AU;
        inverse[byte] = 0xA5U;
    }
    const auto view = [&normal, &inverse](const std::uint8_t length)
    { return IsInversePair(VariablePlace{normal, length}, VariablePlace{inverse, length}); };
    for (std::uint32_t length = 0U; length <= 255U; ++length)
    {
        const bool is_length = (length >= 1U) && (length <= 64U);
        EXPECT_EQ(view(static_cast<std::uint8_t>(length)), is_length ? PairView::kInverse : PairView::kNotInverse)
            << length;
    }
}

TEST(Variable, EachLengthReadsAndWritesItsBitsAlone)
{
    Verifies(req::SRS_KRN_016);
    for (std::uint32_t length = 1U; length <= 64U; ++length)
    {
        const std::uint64_t mask = ~std::uint64_t{0U} >> (64U - length);
        const std::uint32_t size = (length + 7U) / 8U;
        // Given bytes of ones, then so many are read
        std::uint8_t bytes[9];
        std::fill(std::begin(bytes), std::end(bytes), std::uint8_t{0xFFU});
        EXPECT_EQ(ReadVariable(VariablePlace{bytes, static_cast<std::uint8_t>(length)}).bits, mask) << length;
        // When ones are written, then the bits above the length are 0 in its last byte, and no further one is touched
        std::fill(std::begin(bytes), std::end(bytes), std::uint8_t{0x5AU});
        WriteVariable(VariablePlace{bytes, static_cast<std::uint8_t>(length)}, VariableValue{~std::uint64_t{0U}});
        for (std::uint32_t byte = 0U; byte < 9U; ++byte)
        {
            const std::uint32_t written = (byte < 8U) ? static_cast<std::uint32_t>((mask >> (8U * byte)) & 0xFFU) : 0U;
            EXPECT_EQ(bytes[byte], (byte < size) ? written : 0x5AU) << length << " " << byte;
        }
    }
}

} // namespace
} // namespace counterpoint
