// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Reports over a bus of which not all could be judged.
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
// Given a valid pair and nothing else, then what was asked holds; with an element that is none, or a lost frame, it
// does not, and each report says so.
TEST(MissedInputTest, IsInEachReportAndNothingHolds)
{
    Verifies(req::SRS_MON_581);
    const std::string folder = cia306::test::SourceFolder() + "/examples/emergency_stop/";
    const Network network{{{folder + "sensor.dcf", std::nullopt}}, std::nullopt};
    Analysis analysis{network, [](const Violation& /*violation*/) {}};
    analysis.Take(test::Frame(0, 0x101U, {1U, 2U}));
    analysis.Take(test::Frame(300, 0x102U, {0xFEU, 0xFDU}));
    const std::vector<Violation> none;
    Report report{network, analysis, none, "bus"};
    const auto summary = [&report]
    {
        std::ostringstream out;
        WriteSummary(report, out);
        return out.str();
    };
    const auto has = [](const std::string& text, const std::string& part)
    { return text.find(part) != std::string::npos; };
    report.missed.absences = 4U;
    EXPECT_FALSE(HasMissed(report));
    EXPECT_TRUE(Holds(report));
    EXPECT_FALSE(has(summary(), "malformed"));
    EXPECT_FALSE(has(HtmlReport(report), "malformed"));
    EXPECT_TRUE(has(JsonReport(report), "\"holds\": true"));
    EXPECT_TRUE(has(JsonReport(report), "\"malformed\": 0,\n  \"lost_frames\": 0,\n  \"absences\": 4,"));
    for (const Missed& missed : {Missed{3U, 0U, 0U}, Missed{0U, 2U, 0U}})
    {
        report.missed = missed;
        EXPECT_TRUE(HasMissed(report));
        EXPECT_FALSE(Holds(report));
        EXPECT_TRUE(has(JsonReport(report), "\"holds\": false"));
    }
    report.missed = {3U, 2U, 0U};
    const std::string told = "3 malformed elements and 2 lost frames: what was in them was not judged";
    EXPECT_TRUE(has(summary(), " 0 violations\n" + told + "\nSensor SRDO 1"));
    EXPECT_TRUE(has(HtmlReport(report), "<p class=\"bad\">" + told + "</p>"));
    EXPECT_TRUE(has(JsonReport(report), "\"malformed\": 3,\n  \"lost_frames\": 2,\n"));
}
} // namespace
} // namespace counterpoint::monitor
