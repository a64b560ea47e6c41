// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/yaml/map.hpp"
#include "runtime/yaml/optional_values.hpp"
#include "tests/runtime/yaml/refusal.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::runtime
{
namespace
{
using test::RefusalOf;

const std::string kFile = "a.yaml";

std::string RefusalOfMap(const std::string& text)
{
    const YamlNode node = ParseYaml(kFile, text);
    return RefusalOf([&node] { return YamlMap(kFile, node, {"speed", "level"}).Find("speed").has_value(); });
}

TEST(YamlMaps, HaveKnownKeysOnce)
{
    Verifies(req::SRS_SIM_010);
    EXPECT_EQ(RefusalOfMap("{speed: 1, level: 2}"), "");
    EXPECT_EQ(RefusalOfMap("[speed]"), "a.yaml:1:1: error: a list, expected a map with speed, level");
    EXPECT_EQ(RefusalOfMap("{speed: 1, sped: 2}"),
              "a.yaml:1:12: error: unknown key 'sped' (did you mean 'speed'?), expected speed, level");
    EXPECT_EQ(RefusalOfMap("{other-than-these: 2}"),
              "a.yaml:1:2: error: unknown key 'other-than-these', expected speed, level");
    EXPECT_EQ(RefusalOfMap("level: 1\nspeed: 2\nlevel: 3\n"),
              "a.yaml:3:1: error: key 'level' twice, expected each key once");
}

TEST(YamlMaps, FindTheirValues)
{
    Verifies(req::SRS_SIM_010);
    const YamlNode node = ParseYaml(kFile, "level:\n  - 1\nspeed: 7\n");
    const YamlMap map(kFile, node, {"speed", "level", "sign"});
    EXPECT_EQ(map.Require("speed").Number({0U, 9U}), 7U);
    EXPECT_FALSE(map.Find("sign").has_value());
    EXPECT_EQ(RefusalOf([&map] { return map.Require("sign").Checked(); }),
              "a.yaml:1:1: error: no key 'sign', expected it here");
    EXPECT_EQ(map.Value().Where().place.line, 1U);
    // A single value has its own place, a list that of its key
    EXPECT_EQ(map.Places().at("speed").column, 8U);
    EXPECT_EQ(map.Places().at("level").line, 1U);
    EXPECT_EQ(map.Places().count("sign"), 0U);
}

TEST(YamlMaps, SetWhatTheyHave)
{
    Verifies(req::SRS_SIM_010);
    const YamlNode node = ParseYaml(kFile, "{count: 200, time: 7 ms, on: 'true'}");
    const YamlMap map(kFile, node, {"count", "time", "on", "other"});
    std::uint8_t count = 1U;
    TakeNumber(map, "count", count, 1U);
    EXPECT_EQ(count, 200U);
    std::optional<std::uint16_t> time_ms;
    TakeMs(map, "time", time_ms);
    EXPECT_EQ(time_ms, 7U);
    bool is_on = false;
    TakeWord(map, "on", is_on, kTruthWords);
    EXPECT_TRUE(is_on);
    std::string text;
    TakePart(kFile, map, "count", text,
             [](const std::string& file, const YamlValue& value) { return file + " " + value.Text("a text"); });
    EXPECT_EQ(text, "a.yaml 200");
    // What is not there stays as it is
    TakeNumber(map, "other", count, 1U);
    TakeMs(map, "other", time_ms);
    TakeWord(map, "other", is_on, kTruthWords);
    TakePart(kFile, map, "other", text,
             [](const std::string& file, const YamlValue& value) { return file + " " + value.Text("a text"); });
    EXPECT_EQ(count, 200U);
    EXPECT_EQ(time_ms, 7U);
    EXPECT_TRUE(is_on);
    EXPECT_EQ(text, "a.yaml 200");
}

TEST(YamlMaps, RefuseWhatDoesNotFit)
{
    Verifies(req::SRS_SIM_010);
    const auto refusal = [](const std::string& time)
    {
        const YamlNode node = ParseYaml(kFile, "{time: " + time + "}");
        std::optional<std::uint8_t> part;
        return RefusalOf(
            [&]
            {
                TakeMs(YamlMap(kFile, node, {"time"}), "time", part);
                return part;
            });
    };
    const std::string line =
        "a.yaml:1:8: error: a time that its object cannot hold, expected whole milliseconds, at most 255";
    EXPECT_EQ(refusal("255 ms"), "");
    EXPECT_EQ(refusal("256 ms"), line);
    EXPECT_EQ(refusal("254.5 ms"), line);
    const YamlNode node = ParseYaml(kFile, "{count: 256}");
    std::uint8_t count = 1U;
    EXPECT_EQ(RefusalOf(
                  [&]
                  {
                      TakeNumber(YamlMap(kFile, node, {"count"}), "count", count, 1U);
                      return count;
                  }),
              "a.yaml:1:9: error: '256', expected a number from 1 to 255");
    EXPECT_EQ(count, 1U);
}
} // namespace
} // namespace counterpoint::runtime
