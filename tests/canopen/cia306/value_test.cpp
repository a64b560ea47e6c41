// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/file/value.hpp"
#include "canopen/cia306/text/utf16.hpp"

#include "canopen/cia306/file/data_type.hpp"
#include "canopen/cia306/text/number.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/ids/generate.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace counterpoint::cia306
{
namespace
{
constexpr std::uint16_t kBoolean = 0x0001U;
constexpr std::uint16_t kInteger8 = 0x0002U;
constexpr std::uint16_t kInteger16 = 0x0003U;
constexpr std::uint16_t kReal32 = 0x0008U;
constexpr std::uint16_t kVisibleString = 0x0009U;
constexpr std::uint16_t kTimeOfDay = 0x000CU;
constexpr std::uint16_t kInteger24 = 0x0010U;
constexpr std::uint16_t kReal64 = 0x0011U;
constexpr std::uint16_t kInteger40 = 0x0012U;
constexpr std::uint16_t kInteger64 = 0x0015U;
constexpr std::uint16_t kUnsigned24 = 0x0016U;
constexpr std::uint16_t kUnsigned56 = 0x001AU;

struct Case
{
    const char* text;
    std::uint16_t type;
    bool is_good;
    std::uint64_t bits;
};

void ExpectAll(const Case* begin, const Case* end)
{
    for (const Case* row = begin; row != end; ++row)
    {
        const ValueResult result = ParseValue(row->text, row->type, std::uint8_t{5U});
        EXPECT_EQ(result.value.has_value(), row->is_good) << row->text << " " << result.problem.expected;
        EXPECT_EQ(result.value.value_or(Value{}).bits, row->is_good ? row->bits : 0U) << row->text;
        EXPECT_EQ(result.problem.wrong.empty(), row->is_good) << row->text;
    }
}

TEST(Value, NumbersAreHexadecimalOctalOrDecimal)
{
    Verifies(req::SRS_EDS_006);
    const Case cases[] = {
        {"16", kUnsigned8, true, 16U},     {"0x10", kUnsigned8, true, 16U},   {"0X1f", kUnsigned8, true, 31U},
        {"020", kUnsigned8, true, 16U},    {"0", kUnsigned8, true, 0U},       {"00", kUnsigned8, true, 0U},
        {"+7", kUnsigned8, true, 7U},      {"08", kUnsigned8, false, 0U},     {"0x", kUnsigned8, false, 0U},
        {"0xG", kUnsigned8, false, 0U},    {"1 2", kUnsigned8, false, 0U},    {"-1", kUnsigned8, false, 0U},
        {"ten", kUnsigned8, false, 0U},    {"1.0", kUnsigned8, false, 0U},    {"--1", kInteger8, false, 0U},
        {"12h", kUnsigned8, false, 0U},    {"0x 1", kUnsigned8, false, 0U},   {"-", kInteger8, false, 0U},
        {"1e3", kUnsigned32, false, 0U},   {"0x1;", kUnsigned8, false, 0U},   {"-1", kInteger8, true, 0xFFU},
        {"+127", kInteger8, true, 127U},   {"-128", kInteger8, true, 0x80U},  {"-020", kInteger8, true, 0xF0U},
        {"-0x10", kInteger8, true, 0xF0U}, {"0XaB", kUnsigned8, true, 0xABU}, {"0xAb", kUnsigned8, true, 0xABU},
    };
    ExpectAll(std::begin(cases), std::end(cases));
}

TEST(Value, MinusZeroIsZeroAndSuffixesOfCAreLeftOut)
{
    Verifies(req::SRS_EDS_033);
    const Case cases[] = {
        {"-0", kUnsigned8, true, 0U},
        {"-0x00", kUnsigned32, true, 0U},
        {"-0", kInteger8, true, 0U},
        {"-1", kUnsigned32, false, 0U},
        {"255u", kUnsigned8, true, 255U},
        {"0xFFFFFFFFUL", kUnsigned32, true, 0xFFFFFFFFU},
        {"0xFFull", kUnsigned64, true, 0xFFU},
        {"12LU", kUnsigned8, true, 12U},
        {"-9223372036854775808LL", kInteger64, true, 0x8000000000000000U},
        {"9223372036854775807ll", kInteger64, true, 0x7FFFFFFFFFFFFFFFU},
        {"$NODEID+0x180U", kUnsigned32, true, 0x185U},
        {"0x180L+$NODEID", kUnsigned32, true, 0x185U},
        {"256U", kUnsigned8, false, 0U},
        {"1LLL", kUnsigned8, false, 0U},
        {"1UU", kUnsigned8, false, 0U},
        {"1 U", kUnsigned8, false, 0U},
        {"LL", kUnsigned8, false, 0U},
        {"-0LL", kUnsigned16, true, 0U},
        {"-0", kInteger64, true, 0U},
        {"7U", kInteger16, true, 7U},
        {"7l", kUnsigned8, true, 7U},
        {"7L", kUnsigned8, true, 7U},
        {"7ul", kUnsigned8, true, 7U},
        {"7lu", kUnsigned8, true, 7U},
        {"7ULL", kUnsigned8, true, 7U},
        {"7LLU", kUnsigned8, true, 7U},
        {"7llu", kUnsigned8, true, 7U},
    };
    ExpectAll(std::begin(cases), std::end(cases));
    EXPECT_FALSE(ParseUnsigned("7U", 255U)); // Of the structure
    EXPECT_EQ(ParseUnsigned("-0", 255U), 0U);
}

TEST(Value, TimesAreDaysAndMilliseconds)
{
    Verifies(req::SRS_EDS_034);
    const Case cases[] = {
        {"0 0", kTimeOfDay, true, 0U},
        {"15000 43200000", kTimeOfDay, true, 0x3A9802932E00U},
        {"1, 2", kTimeOfDay, true, 0x000100000002U},
        {"1,2", 0x000DU, true, 0x000100000002U},
        {"0xFFFF\t0x0FFFFFFF", 0x000DU, true, 0xFFFF0FFFFFFFU},
        {"0x3A9802932E00", kTimeOfDay, true, 0x3A9802932E00U}, // One number of 48 bits.
        {"64424509440000", 0x000DU, true, 0x3A9800000000U},
        {"0x1000000000000", kTimeOfDay, false, 0U},
        {"65536 0", kTimeOfDay, false, 0U},
        {"0 268435456", kTimeOfDay, false, 0U},
        {"1 2 3", kTimeOfDay, false, 0U},
        {"1,", kTimeOfDay, false, 0U},
        {"1,,2", kTimeOfDay, false, 0U},
        {"$NODEID", kTimeOfDay, false, 0U},
    };
    ExpectAll(std::begin(cases), std::end(cases));
}

TEST(Value, NumbersOfMoreThan64BitAreNone)
{
    Verifies(req::SRS_EDS_006);
    EXPECT_EQ(ParseNumber("18446744073709551615")->magnitude, 18446744073709551615U);
    EXPECT_FALSE(ParseNumber("18446744073709551616"));
    EXPECT_EQ(ParseNumber("0xFFFFFFFFFFFFFFFF")->magnitude, 18446744073709551615U);
    EXPECT_FALSE(ParseNumber("0x10000000000000000"));
    EXPECT_FALSE(ParseNumber(""));
    EXPECT_FALSE(ParseUnsigned("256", 255U));
    EXPECT_EQ(ParseUnsigned("255", 255U), 255U);
}

TEST(Value, FormulasOfTheNodeId)
{
    Verifies(req::SRS_EDS_007);
    const Case cases[] = {
        {"$NODEID", kUnsigned32, true, 5U},
        {"$NODEID+0x180", kUnsigned32, true, 0x185U},
        {"0x180+$NODEID", kUnsigned32, true, 0x185U},
        {"$nodeid + 384", kUnsigned32, true, 0x185U},
        {"0600 + $NodeId", kUnsigned32, true, 0x185U},
        {"$NODEID+0xFFFFFFFA", kUnsigned32, true, 0xFFFFFFFFU},
        {"$NODEID+0xFFFFFFFB", kUnsigned32, false, 0U},
        {"$NODEID+0xFFFFFFFFFFFFFFFF", 0x001BU, false, 0U},
        {"$NODEID+250", kUnsigned8, true, 255U},
        {"$NODEID+251", kUnsigned8, false, 0U},
        {"$NODEID+", kUnsigned32, false, 0U},
        {"+$NODEID", kUnsigned32, false, 0U},
        {"$NODEID+$NODEID", kUnsigned32, false, 0U},
        {"$NODEID+1+1", kUnsigned32, false, 0U},
        {"$NODEID-1", kUnsigned32, false, 0U},
        {"$NODEID+-1", kUnsigned32, false, 0U},
        {"2*$NODEID+0xFF", kUnsigned32, false, 0U},
        {"$NODE+1", kUnsigned32, false, 0U},
        {"$", kUnsigned32, false, 0U},
        {"NODEID+1", kUnsigned32, false, 0U},
        {"$NODEID1", kUnsigned32, false, 0U},
    };
    ExpectAll(std::begin(cases), std::end(cases));
}

TEST(Value, AFormulaWithoutNodeIdIsRefused)
{
    Verifies(req::SRS_EDS_008);
    const ValueResult result = ParseValue("$NODEID+0x180", kUnsigned32, std::nullopt);
    EXPECT_FALSE(result.value);
    EXPECT_EQ(result.problem.wrong, "value '$NODEID+0x180' needs the node-ID and there is none");
    EXPECT_EQ(result.problem.expected, "--node-id, or NodeID in [DeviceComissioning]");
    EXPECT_EQ(ParseValue("0x180", kUnsigned32, std::nullopt).value->bits, 0x180U);
}

TEST(Value, UnsignedTypesAndTheirLimits)
{
    Verifies(req::SRS_EDS_014);
    const Case cases[] = {
        {"1", kBoolean, true, 1U},
        {"2", kBoolean, false, 0U},
        {"true", kBoolean, false, 0U},
        {"255", kUnsigned8, true, 255U},
        {"256", kUnsigned8, false, 0U},
        {"65535", kUnsigned16, true, 65535U},
        {"65536", kUnsigned16, false, 0U},
        {"0xFFFFFF", kUnsigned24, true, 0xFFFFFFU},
        {"0x1000000", kUnsigned24, false, 0U},
        {"4294967295", kUnsigned32, true, 4294967295U},
        {"4294967296", kUnsigned32, false, 0U},
        {"0xFFFFFFFFFFFFFF", kUnsigned56, true, 0xFFFFFFFFFFFFFFU},
        {"0x100000000000000", kUnsigned56, false, 0U},
        {"0xFFFFFFFFFFFFFFFF", kUnsigned64, true, 0xFFFFFFFFFFFFFFFFU},
        {"0x10000000000000000", kUnsigned64, false, 0U},
        {"0xFFFFFFFFFFFF", kTimeOfDay, true, 0xFFFFFFFFFFFFU},
        {"0x1000000000000", kTimeOfDay, false, 0U},
    };
    ExpectAll(std::begin(cases), std::end(cases));
}

TEST(Value, SignedTypesAndTheirLimits)
{
    Verifies(req::SRS_EDS_014);
    const Case cases[] = {
        {"127", kInteger8, true, 0x7FU},
        {"128", kInteger8, false, 0U},
        {"-128", kInteger8, true, 0x80U},
        {"-129", kInteger8, false, 0U},
        {"0xFF", kInteger8, true, 0xFFU},
        {"0x100", kInteger8, false, 0U},
        {"-1", kInteger16, true, 0xFFFFU},
        {"-0x8000", kInteger16, true, 0x8000U},
        {"-0x8001", kInteger16, false, 0U},
        {"-1", kInteger24, true, 0xFFFFFFU},
        {"8388607", kInteger24, true, 0x7FFFFFU},
        {"8388608", kInteger24, false, 0U},
        {"-1", kInteger40, true, 0xFFFFFFFFFFU},
        {"-9223372036854775808", kInteger64, true, 0x8000000000000000U},
        {"-9223372036854775809", kInteger64, false, 0U},
        {"9223372036854775807", kInteger64, true, 0x7FFFFFFFFFFFFFFFU},
        {"9223372036854775808", kInteger64, false, 0U},
    };
    ExpectAll(std::begin(cases), std::end(cases));
}

TEST(Value, RealTypes)
{
    Verifies(req::SRS_EDS_014);
    const Case cases[] = {
        {"1", kReal32, true, 0x3F800000U},
        {"-2.5", kReal32, true, 0xC0200000U},
        {"1e-3", kReal32, true, 0x3A83126FU},
        {"0x3F800000", kReal32, true, 0x3F800000U},
        {"0x100000000", kReal32, false, 0U},
        {"1e40", kReal32, false, 0U},
        {"nan", kReal32, false, 0U},
        {"inf", kReal64, false, 0U},
        {"1,5", kReal32, false, 0U},
        {"+1.5", kReal64, true, 0x3FF8000000000000U},
        {"1e40", kReal64, true, 0x483D6329F1C35CA5U},
    };
    ExpectAll(std::begin(cases), std::end(cases));
}

TEST(Value, StringsAndUnknownTypesStayText)
{
    Verifies(req::SRS_EDS_014);
    EXPECT_EQ(ParseValue("0x1 $x", kVisibleString, std::nullopt).value->text, "0x1 $x");
    EXPECT_EQ(ParseValue("file.bin", kDomainType, std::nullopt).value->text, "file.bin");
    EXPECT_EQ(ParseValue("any", 0x0040U, std::nullopt).value->text, "any");
}

TEST(Value, AProblemNamesTheRange)
{
    Verifies(req::SRS_EDS_014);
    EXPECT_EQ(ProblemOf("256", kUnsigned8)->wrong, "value '256'");
    EXPECT_EQ(ProblemOf("256", kUnsigned8)->expected, "a number from 0 to 255 (UNSIGNED8)");
    EXPECT_EQ(ProblemOf("x", kUnsigned8)->expected, "a number from 0 to 255 (UNSIGNED8), or $NODEID+number");
    EXPECT_EQ(ProblemOf("-129", kInteger8)->expected, "a number from -128 to 127 (INTEGER8)");
    EXPECT_EQ(ProblemOf("x", kInteger64)->expected,
              "a number from -9223372036854775808 to 9223372036854775807 (INTEGER64)");
    EXPECT_EQ(ProblemOf("x", kReal32)->expected, "a decimal fraction, or its IEEE 754 pattern after 0x (REAL32)");
    EXPECT_FALSE(ProblemOf("$NODEID+0x80", kUnsigned32));
}

TEST(Value, UnicodeStringsAreUtf16)
{
    Verifies(req::SRS_GEN_340);
    using Octets = std::vector<std::uint8_t>;
    EXPECT_EQ(Utf16Of(""), Octets{});
    EXPECT_EQ(Utf16Of("Az"), (Octets{0x41U, 0U, 0x7AU, 0U}));
    // A letter of two bytes, the euro sign of three, a character beyond the first plane of four
    EXPECT_EQ(Utf16Of("\xC3\xA4"), (Octets{0xE4U, 0U}));
    EXPECT_EQ(Utf16Of("\xE2\x82\xAC"), (Octets{0xACU, 0x20U}));
    EXPECT_EQ(Utf16Of("\xF0\x9F\x98\x80"), (Octets{0x3DU, 0xD8U, 0x00U, 0xDEU}));
    // Bytes that are no UTF-8 are Latin-1
    EXPECT_EQ(Utf16Of("\xE4!"), (Octets{0xE4U, 0U, 0x21U, 0U}));
    EXPECT_EQ(Utf16Of("\xE2\x82"), (Octets{0xE2U, 0U, 0x82U, 0U}));
    EXPECT_EQ(Utf16Of("\xFF\xC0"), (Octets{0xFFU, 0U, 0xC0U, 0U}));
}

TEST(Value, EveryDataTypeHasItsLength)
{
    Verifies(req::SRS_EDS_014);
    const std::uint8_t lengths[] = {0U, 1U,  8U,  16U, 32U, 8U,  16U, 32U, 32U, 0U,  0U,  0U,  48U, 48U, 0U,
                                    0U, 24U, 64U, 40U, 48U, 56U, 64U, 24U, 0U,  40U, 48U, 56U, 64U, 0U};
    std::uint16_t code = 0U;
    for (const std::uint8_t bits : lengths)
    {
        EXPECT_EQ(DataTypeOf(code).bits, bits) << code;
        ++code;
    }
}
TEST(Value, WhatIsNoNumberOfItsTypeThoughItBeginsLikeOne)
{
    Verifies(req::SRS_EDS_014);
    const Case rows[] = {
        {"$NODEID", kBoolean, false, 0U}, // 5 is above 1.
        {"$NODEID", kInteger8 + 3U, true, 5U}, {"", kReal32, false, 0U},     {"+", kReal32, false, 0U},
        {"+1.0", kReal32, true, 0x3F800000U},  {"-0x1", kReal32, false, 0U}, {"0x1", kReal32, true, 1U},
        {"-1", kTimeOfDay, false, 0U},         {"-0", kTimeOfDay, true, 0U}};
    ExpectAll(std::begin(rows), std::end(rows));
    // What a structure holds stays text
    const DataType structure{"a structure (DEFSTRUCT)", DataKind::kStructure, 0U};
    EXPECT_EQ(ParseValue("1 2", structure, std::nullopt).value->text, "1 2");
}

} // namespace
} // namespace counterpoint::cia306
