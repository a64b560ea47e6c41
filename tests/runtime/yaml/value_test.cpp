// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/yaml/value.hpp"
#include "tests/runtime/yaml/refusal.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::runtime
{
namespace
{
using test::RefusalOf;

const std::string kFile = "a.yaml";

/// The value of a document of one line, and how it is read.
class Value
{
  public:
    explicit Value(const std::string& text) : node_(ParseYaml(kFile, text))
    {
    }
    [[nodiscard]] YamlValue operator*() const
    {
        return {kFile, node_};
    }

  private:
    YamlNode node_;
};

std::string DurationRefusal(const std::string& text)
{
    return RefusalOf([&text] { return (*Value(text)).Duration(); });
}

std::string NumberRefusal(const std::string& text)
{
    return RefusalOf([&text] { return (*Value(text)).Number({5U, 20U}); });
}

TEST(YamlNumbers, AreDecimalOrHexadecimalWithinTheirRange)
{
    Verifies(req::SRS_SIM_010);
    EXPECT_EQ((*Value("5")).Number({5U, 20U}), 5U);
    EXPECT_EQ((*Value("0x14")).Number({5U, 20U}), 20U);
    EXPECT_EQ((*Value("0X0A")).Number({5U, 20U}), 10U);
    EXPECT_EQ((*Value("18446744073709551615")).Number({0U, 0xFFFFFFFFFFFFFFFFU}), 18446744073709551615U);
    EXPECT_EQ((*Value("4294967295")).Checked(), 4294967295U);
    for (const char* const text :
         {"4", "21", "0x", "0x4", "0x15", "x5", "-5", "+5", "5.0", "5 ", "1y0", "18446744073709551616", "''"})
    {
        const std::string shown = Shown((*Value(text)).Node().scalar);
        const bool is_plain = std::string(text) == "5 "; // YAML takes the blank away.
        EXPECT_EQ(NumberRefusal(text),
                  is_plain ? "" : "a.yaml:1:1: error: " + shown + ", expected a number from 5 to 20")
            << text;
    }
    EXPECT_EQ(NumberRefusal("[5]"), "a.yaml:1:1: error: a list, expected a number from 5 to 20");
    EXPECT_EQ(NumberRefusal("{a: 5}"), "a.yaml:1:1: error: a map, expected a number from 5 to 20");
    EXPECT_EQ(NumberRefusal("~"), "a.yaml:1:1: error: nothing, expected a number from 5 to 20");
}

TEST(YamlNumbers, HaveNoZeroBeforeThem)
{
    Verifies(req::SRS_NET_061);
    EXPECT_EQ(NumberRefusal("010"), "a.yaml:1:1: error: '010', expected a number from 5 to 20, without a zero before "
                                    "it: it may be octal");
    EXPECT_EQ((*Value("0")).Number({0U, 20U}), 0U);
    EXPECT_EQ(NumberRefusal("0a"), "a.yaml:1:1: error: '0a', expected a number from 5 to 20");
}

TEST(YamlTexts, AreOfOneLineOrOfSeveral)
{
    Verifies(req::SRS_SIM_010);
    EXPECT_EQ((*Value("some words")).Text("words"), "some words");
    EXPECT_EQ(RefusalOf([] { return (*Value("\"a\\nb\"")).Text("words"); }),
              "a.yaml:1:1: error: text with a line end or tabulator, expected words");
    EXPECT_EQ(RefusalOf([] { return (*Value("\"a\\tb\"")).Text("words"); }),
              "a.yaml:1:1: error: text with a line end or tabulator, expected words");
    EXPECT_EQ((*Value("\"a\\nb\"")).Paragraph("words"), "a\nb");
    EXPECT_EQ(RefusalOf([] { return (*Value("[a]")).Paragraph("words"); }),
              "a.yaml:1:1: error: a list, expected words");
    EXPECT_EQ((*Value("a")).FileName(), "a.yaml");
    EXPECT_EQ((*Value("a")).Where().file, "a.yaml");
    EXPECT_EQ((*Value("  a")).Where().place.column, 3U);
}

TEST(YamlLists, HaveItems)
{
    Verifies(req::SRS_SIM_010);
    const Value list("[7, 8]");
    const std::vector<YamlValue> items = (*list).Items("a list of numbers");
    ASSERT_EQ(items.size(), 2U);
    EXPECT_EQ(items[1].Number({0U, 9U}), 8U);
    EXPECT_EQ(RefusalOf([] { return (*Value("7")).Items("a list of numbers"); }),
              "a.yaml:1:1: error: '7', expected a list of numbers");
}

TEST(YamlTimes, HaveAUnit)
{
    Verifies(req::SRS_SIM_010);
    EXPECT_EQ((*Value("0")).Duration(), 0);
    EXPECT_EQ((*Value("0 ms")).Duration(), 0);
    EXPECT_EQ((*Value("100 us")).Duration(), 100000);
    EXPECT_EQ((*Value("0.001 us")).Duration(), 1);
    EXPECT_EQ((*Value("10ms")).Duration(), 10000000);
    EXPECT_EQ((*Value("2.5 s")).Duration(), 2500000000);
    EXPECT_EQ((*Value("0.000000001 s")).Duration(), 1);
    EXPECT_EQ((*Value("10000000 s")).Duration(), 10000000000000000);
    for (const std::string text :
         {"10000000.000000001 s", "10000001 s", "12345678901 s", "0.0001 us", "0.0000000001 s", "1. s", ".5 s", "-1 s",
          "-.5 s", "1.2.3 s", "1y2 s", "10", "10 min", "ms", "s 10", "1 e s", "00000000000000000000 us"})
    {
        EXPECT_EQ(DurationRefusal(text), "a.yaml:1:1: error: '" + text +
                                             "', expected a time with its unit such as 10 ms, 2.5 s or 100 us, at "
                                             "most 10000000 s");
    }
}

TEST(YamlTimes, LastOrGoEitherWay)
{
    Verifies(req::SRS_SIM_010);
    EXPECT_EQ((*Value("1 ms")).Lasting(), 1000000);
    EXPECT_EQ(RefusalOf([] { return (*Value("0 ms")).Lasting(); }),
              "a.yaml:1:1: error: '0 ms', expected a time above 0");
    EXPECT_EQ((*Value("1 ms")).SignedDuration(), 1000000);
    EXPECT_EQ((*Value("-1 ms")).SignedDuration(), -1000000);
    EXPECT_EQ((*Value("-1000 s")).SignedDuration(), -1000000000000);
    EXPECT_EQ(RefusalOf([] { return (*Value("-1000.1 s")).SignedDuration(); }),
              "a.yaml:1:1: error: '-1000.1 s', expected at most 1000 s either way");
    EXPECT_EQ(RefusalOf([] { return (*Value("1000.1 s")).SignedDuration(); }),
              "a.yaml:1:1: error: '1000.1 s', expected at most 1000 s either way");
    const std::string expected = ", expected a time with its unit such as 10 ms, 2.5 s or 100 us, at most 10000000 s";
    EXPECT_EQ(RefusalOf([] { return (*Value("[1]")).SignedDuration(); }), "a.yaml:1:1: error: a list" + expected);
    EXPECT_EQ(RefusalOf([] { return (*Value("''")).SignedDuration(); }), "a.yaml:1:1: error: ''" + expected);
}

TEST(YamlDrifts, AreWholePartsPerMillion)
{
    Verifies(req::SRS_SIM_010);
    EXPECT_EQ((*Value("-1000000")).PartsPerMillion(), -1000000);
    EXPECT_EQ((*Value("1000000")).PartsPerMillion(), 1000000);
    EXPECT_EQ((*Value("0")).PartsPerMillion(), 0);
    for (const std::string text : {"-1000001", "1000001", "1.5", "1 ppm", "0x10", "--1", ""})
    {
        EXPECT_EQ(RefusalOf([&text] { return (*Value("'" + text + "'")).PartsPerMillion(); }),
                  "a.yaml:1:1: error: '" + text + "', expected whole parts per million from -1000000 to 1000000");
    }
}

TEST(YamlObjects, HaveIndexAndSubIndex)
{
    Verifies(req::SRS_SIM_010);
    EXPECT_EQ((*Value("0x2000:01")).Object().index, 0x2000U);
    EXPECT_EQ((*Value("0X2000:1A")).Object().sub, 0x1AU);
    EXPECT_EQ((*Value("0xFFFF:FF")).Object().index, 0xFFFFU);
    for (const std::string text : {"2000:01", "0x2000", "0y2000:01", "1x2000:01", "0x", "0x:01",
                                   "0x2000:", "0x10000:01", "0x2000:100", "0xG000:01", "0x2000:G1"})
    {
        EXPECT_EQ(RefusalOf([&text] { return (*Value("'" + text + "'")).Object(); }),
                  "a.yaml:1:1: error: '" + text + "', expected an object such as 0x2000:01");
    }
}

TEST(YamlWords, AreThoseOfTheirTable)
{
    Verifies(req::SRS_SIM_010);
    constexpr Word<int> kWords[] = {{"released", 1}, {"safe", 2}};
    EXPECT_EQ((*Value("safe")).Choice(kWords), 2);
    EXPECT_EQ(RefusalOf([&kWords] { return (*Value("saef")).Choice(kWords); }),
              "a.yaml:1:1: error: 'saef' (did you mean 'safe'?), expected one of released, safe");
    EXPECT_EQ(RefusalOf([&kWords] { return (*Value("unheard-of")).Choice(kWords); }),
              "a.yaml:1:1: error: 'unheard-of', expected one of released, safe");
}
} // namespace
} // namespace counterpoint::runtime
