// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The emergency-stop chain: controller (SCT 50 ms, SRVT 20 ms) listens to the sensor's 101h and 102h, actuator to the
// controller's 103h and 104h.
#include "canopen/monitor/report.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/canopen/monitor/recordings.hpp"
#include "verification/trace/ids/monitor.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace counterpoint::monitor
{
namespace
{
using test::Frame;

std::string Example(const std::string& name)
{
    return cia306::test::SourceFolder() + "/examples/emergency_stop/" + name + ".dcf";
}

bool Has(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

class ReportTest : public ::testing::Test
{
  protected:
    void Take(const Time us, const std::uint32_t identifier, const std::vector<std::uint8_t>& data)
    {
        analysis.Take(Frame(us, identifier, data));
    }
    void TakePair(const Time us, const std::uint32_t identifier, const Time srvt_us)
    {
        Take(us, identifier, {1U, 2U});
        Take(us + srvt_us, identifier + 1U, {0xFEU, 0xFDU});
    }
    [[nodiscard]] Report Whole() const
    {
        return {network, analysis, violations, "stop <1>.log", origin};
    }
    [[nodiscard]] std::string Summary() const
    {
        std::ostringstream out;
        WriteSummary(Whole(), out);
        return out.str();
    }

    Network network{
        {{Example("sensor"), std::nullopt}, {Example("controller"), std::nullopt}, {Example("actuator"), std::nullopt}},
        std::nullopt};
    std::vector<Violation> violations;
    Analysis analysis{network, [this](const Violation& violation) { violations.push_back(violation); }};
    Origin origin;
};

// Given two valid pairs of the sensor 60 ms apart, and a pair of the controller that is not inverse,
// when the summary is written, then it has each number, and a margin below 0 where the limit was passed.
TEST_F(ReportTest, TheSummaryHasPairsCausesTimesAndMargins)
{
    Verifies(req::SRS_MON_010);
    TakePair(0, 0x101U, 300);
    TakePair(60000, 0x101U, 500);
    Take(61000, 0x103U, {1U, 2U});
    Take(61200, 0x104U, {0xFFU, 0xFDU});
    Take(62000, 0x701U, {5U});
    EXPECT_EQ(Summary(), "7 frames, 6 SRDO, 1 error control; 0.062000 s; 2 violations\n"
                         "Sensor SRDO 1 -> Controller SRDO 1 (101h, 102h): 2 pairs, 1 violations, 1 SCT expired\n"
                         "  cycle  least 60 ms, mean 60 ms, greatest 60 ms, limit 50 ms, margin -10 ms\n"
                         "  SRVT   least 0.3 ms, mean 0.4 ms, greatest 0.5 ms, limit 20 ms, margin 19.5 ms\n"
                         "Controller SRDO 2 -> Actuator SRDO 1 (103h, 104h): 0 pairs, 1 violations, 1 not inverse\n"
                         "  cycle  none measured, limit 50 ms\n"
                         "  SRVT   least 0.2 ms, mean 0.2 ms, greatest 0.2 ms, limit 20 ms, margin 19.8 ms\n"
                         "  no valid pair came, expected at least one\n");
}

// Given files of sensor and controller alone, so that the controller's pair has one end in them,
// when a pair of the sensor comes, then the controller's may stay away; without any pair both are silent.
TEST_F(ReportTest, AnSrdoWithOneEndInTheFilesMayStaySilentBesideAnother)
{
    Verifies(req::SRS_MON_240);
    const Network part{{{Example("sensor"), std::nullopt}, {Example("controller"), std::nullopt}}, std::nullopt};
    Analysis of_part{part, [](const Violation& /*violation*/) {}};
    EXPECT_EQ(Silent(Report{part, of_part, violations, "log", origin}), (std::vector<std::size_t>{0U, 1U}));
    of_part.Take(Frame(0, 0x101U, {1U, 2U}));
    of_part.Take(Frame(300, 0x102U, {0xFEU, 0xFDU}));
    EXPECT_EQ(Silent(Report{part, of_part, violations, "log", origin}), std::vector<std::size_t>{});
}

// Given frames in words that were asked for, when the document is written, then it has each with its time;
// and none where nobody asked.
TEST_F(ReportTest, TheDocumentHasTheFramesInWordsThatWereAskedFor)
{
    Verifies(req::SRS_MON_241);
    const std::vector<FrameText> frames{{kSecond + (kSecond / 2), "NMT start node 5"}};
    Report report = Whole();
    EXPECT_FALSE(Has(JsonReport(report), "frame_texts"));
    report.frames = &frames;
    EXPECT_TRUE(Has(JsonReport(report), "\"time_s\": 1.5"));
    EXPECT_TRUE(Has(JsonReport(report), "\"text\": \"NMT start node 5\""));
}

TEST_F(ReportTest, TheSummaryTellsWhatWasNotJudged)
{
    Verifies(req::SRS_MON_041);
    TakePair(1000, 0x101U, 300);
    EXPECT_FALSE(Has(Summary(), "not judged"));
    origin = {"can0", 30U, 1476000000, ""};
    EXPECT_TRUE(Has(Summary(),
                    " 0 violations\n30 frames of other interfaces were not judged, the last at 1.476000; judged: "
                    "'can0', until 0.001300\nSensor SRDO 1"));
}

TEST(ReportWithoutSrdos, SaysThatNoneWasWatched)
{
    Verifies(req::SRS_MON_010);
    const Network network{{}, std::nullopt};
    Analysis analysis{network, [](const Violation&) {}};
    const std::vector<Violation> none;
    analysis.Take(Frame(0, 0x080U, {}));
    std::ostringstream out;
    WriteSummary({network, analysis, none, "x.log"}, out);
    EXPECT_EQ(out.str(), "1 frames, 1 SYNC; 0.000000 s; no SRDO was watched\n");
}

// A late consumer is named as such in each of the three.
TEST(ReportOfALateConsumer, NamesItsDetection)
{
    Verifies(req::SRS_MON_007);
    Verifies(req::SRS_MON_011);
    std::string text = cia306::test::ExampleText("controller");
    text.replace(text.find("ParameterValue=", text.find("[5F05sub1]")), 19U, "ParameterValue=0x3C");
    const Network network{{{test::Written("report_late.dcf", text), std::nullopt}}, std::nullopt};
    const Analysis analysis{network, [](const Violation&) {}};
    const std::vector<Violation> none;
    const Report report{network, analysis, none, "x.log"};
    std::ostringstream out;
    WriteSummary(report, out);
    EXPECT_TRUE(Has(out.str(), "nobody here -> Controller SRDO 1 (101h, 102h, late): 0 pairs, 0 violations\n"));
    EXPECT_TRUE(Has(out.str(), "Controller SRDO 2 -> nobody here (103h, 104h): 0 pairs, 0 violations\n"));
    EXPECT_TRUE(Has(JsonReport(report), "\"detection\": \"late\""));
    EXPECT_TRUE(
        Has(HtmlReport(report), "101h, 102h; late detection; 0 pairs; <span class=\"good\">no violation</span>"));
    EXPECT_TRUE(Has(HtmlReport(report), "<figcaption>Cycle, normal to normal frame: none measured</figcaption>"));
}

TEST_F(ReportTest, AViolationIsOneLine)
{
    Verifies(req::SRS_MON_005);
    Verifies(req::SRS_MON_016);
    // Given an inverse frame of wrong data, and a GFC that no SRDO follows
    TakePair(0, 0x101U, 300);
    Take(1000, 0x101U, {1U, 2U});
    Take(1200, 0x102U, {0xFFU, 0xFDU});
    Take(2000, 0x001U, {});
    analysis.Advance(40 * kMillisecond);
    ASSERT_EQ(violations.size(), 2U);
    EXPECT_EQ(
        ViolationText(network, violations[0]),
        "0.001200 not inverse: Sensor SRDO 1 -> Controller SRDO 1 (101h, 102h): bit 0: normal 01 02, inverse FF FD");
    EXPECT_EQ(ViolationText(network, violations[1]),
              "0.027000 GFC not followed: no SRDO of a device that may send it within 25 ms after the GFC at 0.002000");
}

// Given a second file that consumes the same pair, then both are named for what is wrong with the frames.
TEST(ReportOfTwoConsumers, NamesBoth)
{
    Verifies(req::SRS_MON_008);
    const std::string path =
        test::Written("report_second.dcf", cia306::test::Changed(cia306::test::ExampleText("controller"),
                                                                 {{"NodeName=Controller", "NodeName=Second"}}));
    const Network network{{{Example("controller"), std::nullopt}, {path, std::uint8_t{9U}}}, std::nullopt};
    std::vector<std::string> texts;
    Analysis analysis{network, [&](const Violation& violation) { texts.push_back(Watchers(network, violation)); }};
    analysis.Take(Frame(0, 0x101U, {1U}));
    EXPECT_EQ(texts, std::vector<std::string>{"nobody here -> Controller SRDO 1; nobody here -> Second SRDO 1"});
}

TEST_F(ReportTest, TheDocumentHasEachNumber)
{
    Verifies(req::SRS_MON_011);
    TakePair(0, 0x101U, 300);
    TakePair(60000, 0x101U, 500);
    std::string json = JsonReport(Whole());
    EXPECT_TRUE(Has(json,
                    "\"source\": \"stop <1>.log\",\n  \"holds\": false,\n  \"interface\": null,\n  \"frames\": 4,\n"
                    "  \"other_frames\": 0,\n  \"other_last_s\": null,\n  \"first_s\": 0.0,\n  \"last_s\": 0.0605,"));
    EXPECT_TRUE(Has(
        json, "\"violation_count\": 1,\n  \"violations\": [\n    {\n      \"time_s\": 0.05,\n      \"cause\": "
              "\"SCT expired\",\n      \"srdos\": [\n        0\n      ],\n      \"details\": \"no pair within 50 ms "
              "after the normal frame at 0.000000\"\n    }\n  ],\n  \"warnings\": [],"));
    EXPECT_TRUE(Has(json,
                    "\"causes\": {\n        \"SCT expired\": 1\n      },\n      \"cycle\": {\n        \"count\": 1,\n"
                    "        \"limit_ms\": 50.0,\n        \"min_ms\": 60.0,\n        \"mean_ms\": 60.0,\n        "
                    "\"max_ms\": 60.0,\n        \"margin_ms\": -10.0\n      }"));
    // Of a recording with another interface, and with a reason to doubt
    origin = {"can0", 30U, 1476000000, "it may be several"};
    json = JsonReport(Whole());
    EXPECT_TRUE(Has(json, "\"interface\": \"can0\""));
    EXPECT_TRUE(Has(json, "\"other_frames\": 30,\n  \"other_last_s\": 1.476,"));
    EXPECT_TRUE(Has(json,
                    "\"warnings\": [\n    {\n      \"file\": \"stop <1>.log\",\n      \"line\": 0,\n      \"column\": "
                    "0,\n      \"object\": \"\",\n      \"message\": \"it may be several\"\n    }\n  ]"));
}

// A time that is longer than SCT, one of 300 us, and one of 500 us: bars of 120 points, the longest beyond the limit.
TEST_F(ReportTest, ThePageHasHistogramsAndTheList)
{
    Verifies(req::SRS_MON_011);
    EXPECT_TRUE(Has(HtmlReport(Whole()),
                    "<h1>SRDOs of stop &lt;1&gt;.log</h1><p>0 frames in 0.000000 s: <span class=\"good\">no "
                    "violation</span></p><h2>Sensor SRDO 1 -&gt; Controller SRDO 1</h2>"));
    TakePair(0, 0x101U, 300);
    TakePair(60000, 0x101U, 500);
    Take(60600, 0x102U, {0xFEU, 0xFDU});
    std::string page = HtmlReport(Whole());
    EXPECT_TRUE(Has(page, "<p>5 frames in 0.060600 s: <span class=\"bad\">2 violations</span></p><h2>"));
    EXPECT_TRUE(Has(page, "2 pairs; <span class=\"bad\">1 inverse first, 1 SCT expired</span>"));
    EXPECT_TRUE(Has(page, "<figcaption>Cycle, normal to normal frame: least 60 ms, mean 60 ms, greatest 60 ms, margin "
                          "-10 ms</figcaption>"));
    EXPECT_TRUE(
        Has(page, "<rect class=\"over\" x=\"376\" y=\"10\" width=\"7\" height=\"120\"><title>1</title></rect>"));
    EXPECT_TRUE(Has(page, "<rect x=\"0\" y=\"10\" width=\"7\" height=\"120\"><title>2</title></rect>"));
    EXPECT_TRUE(Has(page, "<td class=\"n\">0.050000</td><td>SCT expired</td><td>Sensor SRDO 1 -&gt; Controller SRDO "
                          "1</td><td>no pair within 50 ms after the normal frame at 0.000000</td>"));
    EXPECT_FALSE(Has(page, "The first 2000."));
    EXPECT_FALSE(Has(page, "not judged"));
    origin = {"can0", 30U, 1476000000, "it <may> be several"};
    page = HtmlReport(Whole());
    EXPECT_TRUE(Has(page, "<p>30 frames of other interfaces were not judged, the last at 1.476000; judged: "));
    EXPECT_TRUE(Has(page, "<p class=\"bad\">it &lt;may&gt; be several</p>"));
}

TEST_F(ReportTest, ThePageListsTheFirstTwoThousand)
{
    Verifies(req::SRS_MON_011);
    for (Time us = 1; us <= 2001; ++us)
    {
        Take(us, 0x101U, {1U});
    }
    const std::string page = HtmlReport(Whole());
    EXPECT_TRUE(Has(page, "<span class=\"bad\">2001 violations</span>"));
    EXPECT_TRUE(Has(page, "<h2>Violations</h2><p>The first 2000.</p>"));
    EXPECT_TRUE(Has(page, "<td class=\"n\">0.002000</td>"));
    EXPECT_FALSE(Has(page, "<td class=\"n\">0.002001</td>"));
}

TEST(TimesOfASet, HaveAMeanOf0WhereThereIsNone)
{
    Verifies(req::SRS_MON_010);
    EXPECT_EQ(TimeStatistics{}.Mean(), 0);
}
} // namespace
} // namespace counterpoint::monitor
