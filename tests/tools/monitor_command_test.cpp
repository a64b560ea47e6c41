// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/text/text_file.hpp"
#include "hal/host/live/bus.hpp"
#include "tests/canopen/cia306/check_text.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/hal/host/live_server_rig.hpp"
#include "tests/runtime/stepped_time/stepped_process.hpp"
#include "tests/tools/command_run.hpp"
#include "verification/trace/ids/monitor.hpp"
#include "verification/trace/verifies.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace counterpoint::tools
{
namespace
{
using test::Answer;
using test::RunCommand;

std::string Example(const std::string& name)
{
    return cia306::test::SourceFolder() + "/examples/emergency_stop/" + name + ".dcf";
}

class MonitorCommandTest : public test::CommandTest
{
  protected:
    /// Four pairs of the sensor, the third of which is not inverse.
    [[nodiscard]] std::string Recording() const
    {
        std::string text;
        for (int pair = 0; pair < 4; ++pair)
        {
            const std::string head = "(10.0" + std::to_string(25 * pair + 100).substr(1U);
            text += head + "000) can0 101#0102\n" + head + "200) can0 102#FEF" + (pair == 2 ? "C" : "D") + "\n";
        }
        return File("bus.log", text);
    }
    [[nodiscard]] static Answer Monitor(const std::vector<std::string>& arguments)
    {
        std::vector<std::string> all{"monitor"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        all.insert(all.end(), {"--dcf", Example("sensor"), Example("controller")});
        return RunCommand(all);
    }
    /// As a program of its own on a live bus.
    [[nodiscard]] static std::vector<std::string> Watching(const std::string& address, const std::string& seconds)
    {
        return {
            COUNTERPOINT_PROGRAM, "monitor", "--can", address, "--for", seconds, "--json", "--dcf", Example("sensor"),
            Example("controller")};
    }
};

TEST_F(MonitorCommandTest, TellsViolationsAndASummary)
{
    Verifies(req::SRS_MON_005);
    Verifies(req::SRS_MON_010);
    Verifies(req::SRS_MON_011);
    const Answer answer = Monitor({Recording()});
    EXPECT_EQ(answer.status, 1);
    EXPECT_EQ(answer.err, "");
    EXPECT_EQ(
        answer.out,
        "10.050200 not inverse: Sensor SRDO 1 -> Controller SRDO 1 (101h, 102h): bit 8: normal 01 02, inverse FE FC\n"
        "8 frames, 8 SRDO; 0.075200 s; 1 violations\n"
        "Sensor SRDO 1 -> Controller SRDO 1 (101h, 102h): 3 pairs, 1 violations, 1 not inverse\n"
        "  cycle  least 25 ms, mean 37.5 ms, greatest 50 ms, limit 50 ms, margin 0 ms\n"
        "  SRVT   least 0.2 ms, mean 0.2 ms, greatest 0.2 ms, limit 20 ms, margin 19.8 ms\n"
        "Controller SRDO 2 -> nobody here (103h, 104h): 0 pairs, 0 violations\n"
        "  cycle  none measured, limit 50 ms\n"
        "  SRVT   none measured, limit 20 ms\n");
}

// A second sensor sends the pair of the first one; controllers with 24 bits for 16, with 103h's partner beside 101h,
// and with an SCT as short as the refresh time. The chain itself has nothing to tell.
TEST_F(MonitorCommandTest, TellsWhereFilesContradictEachOther)
{
    Verifies(req::SRS_MON_400);
    Verifies(req::SRS_MON_020);
    using cia306::test::ExampleText;
    const std::string sensor = Example("sensor");
    const std::string at = Path("other.dcf");
    const auto told = [this, &sensor](const std::string& text, const std::vector<std::string>& more)
    {
        std::vector<std::string> line{"monitor", Recording(), "--dcf", sensor, File("other.dcf", text) + "=90"};
        line.insert(line.end(), more.begin(), more.end());
        const Answer answer = RunCommand(line);
        EXPECT_EQ(answer.status, 1);
        return more.empty() ? answer.err : answer.out;
    };
    EXPECT_EQ(Monitor({Recording()}).err, "");
    const std::string same = told(ExampleText("sensor"), {});
    EXPECT_NE(same.find(": warning: 0x1301:01: sends 0x101 and 0x102, which Sensor SRDO 1 sends, too, expected one "
                        "producer\n"),
              std::string::npos)
        << same;
    EXPECT_EQ(same.rfind(at + ":", 0U), 0U) << same;

    const std::string controller = ExampleText("controller");
    EXPECT_EQ(told(controller, {}), "");
    const auto changed = [&controller](const std::string& name, const std::string& value)
    {
        const std::size_t key = controller.find("ParameterValue=", controller.find("[" + name + "]"));
        const std::size_t end = controller.find('\n', key);
        return controller.substr(0U, key) + "ParameterValue=" + value + controller.substr(end);
    };
    EXPECT_NE(told(changed("1301sub2", "25"), {})
                  .find(": warning: 0x1301:02: SCT 25 ms, while Sensor SRDO 1 has a refresh time of 25 ms, expected an "
                        "SCT above it\n"),
              std::string::npos);
    // An SCT above it contradicts nobody; only the signature, which was made of 50 ms, is told with its line,
    // [SRS_MON_400]
    EXPECT_NE(told(changed("1301sub2", "26"), {})
                  .find(at + ":453:16: warning: 0x13FF:01: signature 0xE3BF of SRDO 1 of Controller, expected 0x9066: "
                             "a device refuses this file, so that the one on the bus may have another\n"),
              std::string::npos);
    // and nothing where it is signed again.
    EXPECT_EQ(told(cia306::test::SignedAgain(changed("1301sub2", "26"), 90U), {}), "");
    // The status is that of the violations: none
    const std::string good = File("good.log", "(1.000000) can0 101#0102\n(1.000200) can0 102#FEFD\n");
    const Answer clean =
        RunCommand({"monitor", good, "--dcf", sensor, File("other.dcf", changed("1301sub2", "25")) + "=90"});
    EXPECT_EQ(clean.status, 0) << clean.out;
    EXPECT_NE(clean.err.find(": warning: 0x1301:02: SCT 25 ms"), std::string::npos) << clean.err;
    EXPECT_NE(told(changed("1381sub0", "2"), {})
                  .find(": warning: 0x1381:00: 8 bits mapped, while Sensor SRDO 1 maps 16, expected the same length\n"),
              std::string::npos);
    const auto document = nlohmann::json::parse(told(changed("1301sub2", "10"), {"--json"}));
    ASSERT_EQ(document["warnings"].size(), 2U);
    EXPECT_EQ(document["warnings"][0]["object"], "0x13FF:01");
    EXPECT_EQ(document["warnings"][0]["file"], at);
    EXPECT_EQ(document["warnings"][1]["object"], "0x1301:02");
    EXPECT_EQ(document["warnings"][1]["file"], at);
}

// The controller's configuration is not valid: nobody consumes the sensor's pair, and nobody here sends 103h.
TEST_F(MonitorCommandTest, WatchesNoSrdoOfAConfigurationThatIsNotValid)
{
    Verifies(req::SRS_MON_021);
    const auto invalid = [this](const std::string& name, const std::string& value)
    {
        std::string text = cia306::test::ExampleText(name);
        const std::size_t key = text.find("ParameterValue=0xA5", text.find("[13FE]"));
        return File(name + ".dcf", text.replace(key, 19U, "ParameterValue=" + value));
    };
    const std::string controller = invalid("controller", "0");
    const std::string log = File("two.log", "(1.000000) can0 101#0102\n(1.000200) can0 102#FEFD\n"
                                            "(1.001000) can0 001#\n(1.002000) can0 103#01\n(2.000000) can0 701#05\n");
    const Answer one = RunCommand({"monitor", log, "--frames", "--dcf", Example("sensor"), controller});
    EXPECT_EQ(one.err.rfind(controller + ":", 0U), 0U) << one.err;
    EXPECT_NE(one.err.find(": warning: 0x13FE:00: 0x00, so that no SRDO of Controller is active and none is watched, "
                           "expected 0xA5 where the device was declared valid\n"),
              std::string::npos)
        << one.err;
    EXPECT_NE(one.out.find("Sensor SRDO 1 -> nobody here (101h, 102h)"), std::string::npos) << one.out;
    EXPECT_NE(one.out.find("103h [1] 01  SRDO normal, of Controller SRDO 2, which is not active\n"), std::string::npos)
        << one.out;
    EXPECT_EQ(one.out.find("(103h, 104h)"), std::string::npos) << one.out;
    // Of the two only the sensor may send the GFC: its refresh time is 25 ms.
    EXPECT_NE(one.out.find("1.026000 GFC not followed: "), std::string::npos) << one.out;

    const std::string sensor = invalid("sensor", "0x01");
    const Answer none = RunCommand({"monitor", log, "--dcf", sensor, controller});
    EXPECT_EQ(none.status, 2);
    EXPECT_NE(none.err.find(": warning: 0x13FE:00: 0x01, so that no SRDO of Sensor is active"), std::string::npos);
    EXPECT_NE(none.err.find(sensor + ": error: no SRDO that is active in any of the files, expected at least one to "
                                     "watch, which is on and has 0xA5 in 13FEh, or --frames\n"),
              std::string::npos)
        << none.err;
    // But with --frames they are shown, as of nobody who is active
    const Answer shown = RunCommand({"monitor", log, "--frames", "--dcf", sensor, controller});
    EXPECT_EQ(shown.status, 0) << shown.err;
    EXPECT_NE(shown.out.find("101h [2] 01 02  SRDO normal, of Sensor SRDO 1, which is not active\n"), std::string::npos)
        << shown.out;
    const auto document =
        nlohmann::json::parse(RunCommand({"monitor", log, "--json", "--dcf", Example("sensor"), controller}).out);
    ASSERT_EQ(document["warnings"].size(), 1U);
    EXPECT_EQ(document["warnings"][0]["object"], "0x13FE:00");
    ASSERT_EQ(document["srdos"].size(), 1U);
    EXPECT_EQ(document["srdos"][0]["consumer"], nullptr);
}

TEST_F(MonitorCommandTest, FramesInWords)
{
    Verifies(req::SRS_MON_004);
    const std::string file = File("one.log", "(1.000000) can0 701#05\n");
    const Answer answer = Monitor({file, "--frames"});
    EXPECT_EQ(answer.status, 1); // No pair of the chain came.
    EXPECT_EQ(
        answer.out.rfind("1.000000 701h [1] 05  error control Sensor is OPERATIONAL\n1 frames, 1 error control", 0U),
        0U)
        << answer.out;
}

// Without a DCF, with one of a plain device: the frames are read all the same, and nothing is watched.
TEST_F(MonitorCommandTest, FramesNeedNoFile)
{
    Verifies(req::SRS_MON_019);
    const std::string file = File("one.log", "(1.000000) can0 721#05\n(1.100000) can0 101#05\n");
    const std::string plain = cia306::test::SourceFolder() + "/tests/runtime/data/plain.dcf";
    for (const std::vector<std::string>& files : {std::vector<std::string>{}, {"--dcf", plain + "=5"}})
    {
        std::vector<std::string> line{"monitor", file, "--frames"};
        line.insert(line.end(), files.begin(), files.end());
        const Answer answer = RunCommand(line);
        EXPECT_EQ(answer.status, 0) << answer.err;
        EXPECT_NE(answer.out.find("1.000000 721h [1] 05  error control node 33 is OPERATIONAL\n"), std::string::npos)
            << answer.out;
        EXPECT_NE(answer.out.find("1.100000 101h [1] 05  SRDO normal, of no file\n"), std::string::npos) << answer.out;
        EXPECT_NE(answer.out.find("0.100000 s; no SRDO was watched\n"), std::string::npos) << answer.out;
        // Without --frames there is nothing to do
        line.erase(line.begin() + 2);
        EXPECT_EQ(RunCommand(line).status, 2);
    }
}

TEST_F(MonitorCommandTest, AnswersAsJson)
{
    Verifies(req::SRS_MON_011);
    const Answer answer = Monitor({Recording(), "--json"});
    EXPECT_EQ(answer.status, 1);
    const auto document = nlohmann::json::parse(answer.out);
    EXPECT_EQ(document["holds"], false);
    EXPECT_EQ(document["frames"], 8);
    ASSERT_EQ(document["violations"].size(), 1U);
    EXPECT_EQ(document["violations"][0]["time_s"], 10.0502);
    EXPECT_EQ(document["violations"][0]["cause"], "not inverse");
    EXPECT_EQ(document["srdos"][0]["pairs"], 3);
    EXPECT_EQ(document["srdos"][0]["causes"]["not inverse"], 1);
    EXPECT_EQ(document["srdos"][0]["srvt"]["max_ms"], 0.2);
    EXPECT_EQ(document["srdos"][0]["cycle"]["margin_ms"], 0.0);
    const auto refusal = nlohmann::json::parse(Monitor({File("bad.log", "x\n"), "--json"}).out);
    EXPECT_EQ(refusal["error"]["line"], 1);
}

// The sensor's pair has both ends in the files, the controller's one: nobody here consumes it.
TEST_F(MonitorCommandTest, AnSrdoThatNeverCameDoesNotHold)
{
    Verifies(req::SRS_MON_240);
    const std::string pair = "(1.100000) can0 101#0102\n(1.100200) can0 102#FEFD\n";
    const std::string report = "(1.200000) can0 103#0102\n(1.200200) can0 104#FEFD\n";
    const std::string silent = "  no valid pair came, expected at least one\n";
    // Given none of both
    const std::string none = File("none.log", "(1.000000) can0 701#05\n");
    const Answer nothing = Monitor({none, "--html", Path("page.html")});
    EXPECT_EQ(nothing.status, 1);
    EXPECT_NE(nothing.out.find("; 0 violations\n"), std::string::npos) << nothing.out;
    EXPECT_NE(nothing.out.find(silent), nothing.out.rfind(silent)) << nothing.out;
    const std::string page = cia306::ReadTextFile(Path("page.html"));
    EXPECT_NE(page.find("<p class=\"bad\">no valid pair came</p>"), std::string::npos);
    const auto document = nlohmann::json::parse(Monitor({none, "--json"}).out);
    EXPECT_EQ(document["holds"], false);
    EXPECT_EQ(document["violation_count"], 0);
    EXPECT_EQ(document["silent"], nlohmann::json::parse("[0, 1]"));
    // The one without the other end alone
    const auto other = nlohmann::json::parse(Monitor({File("other.log", report), "--json"}).out);
    EXPECT_EQ(other["holds"], false);
    EXPECT_EQ(other["silent"], nlohmann::json::parse("[0]"));
    // The one that has both
    const Answer good = Monitor({File("good.log", pair), "--html", Path("page.html")});
    EXPECT_EQ(good.status, 0) << good.out;
    EXPECT_EQ(good.out.find(silent), std::string::npos) << good.out;
    EXPECT_EQ(cia306::ReadTextFile(Path("page.html")).find("no valid pair came"), std::string::npos);
    const auto holds = nlohmann::json::parse(Monitor({File("good.log", pair), "--json"}).out);
    EXPECT_EQ(holds["holds"], true);
    EXPECT_EQ(holds["silent"], nlohmann::json::array());
    // A producer alone, whose pair came, and one whose pair did not
    EXPECT_EQ(RunCommand({"monitor", File("good.log", pair), "--dcf", Example("sensor")}).status, 0);
    EXPECT_EQ(RunCommand({"monitor", File("other.log", report), "--dcf", Example("sensor")}).status, 1);
}

TEST_F(MonitorCommandTest, FramesInWordsAreInTheDocument)
{
    Verifies(req::SRS_MON_241);
    const std::string file = File("two.log", "(1.000000) can0 701#05\n(1.500000) can0 001#\n");
    const auto document = nlohmann::json::parse(Monitor({file, "--frames", "--json"}).out);
    ASSERT_EQ(document["frame_texts"].size(), 2U);
    EXPECT_EQ(document["frame_texts"][0]["time_s"], 1.0);
    EXPECT_EQ(document["frame_texts"][0]["text"], "701h [1] 05  error control Sensor is OPERATIONAL");
    EXPECT_EQ(document["frame_texts"][1]["time_s"], 1.5);
    EXPECT_FALSE(nlohmann::json::parse(Monitor({file, "--json"}).out).contains("frame_texts"));
    // Of more than 100 000 the first ones
    std::string text;
    for (int frame = 0; frame < 100001; ++frame)
    {
        text += "(1.000000) can0 701#05\n";
    }
    const auto many = nlohmann::json::parse(RunCommand({"monitor", File("many.log", text), "--frames", "--json"}).out);
    EXPECT_EQ(many["frames"], 100001);
    EXPECT_EQ(many["frame_texts"].size(), 100000U);
}

TEST_F(MonitorCommandTest, WritesAPageThatNeedsNoOtherFile)
{
    Verifies(req::SRS_MON_011);
    EXPECT_EQ(Monitor({Recording(), "--html", Path("page.html")}).status, 1);
    const std::string page = cia306::ReadTextFile(Path("page.html"));
    EXPECT_EQ(page.rfind("<!DOCTYPE html>", 0U), 0U);
    for (const char* reference : {"http", "src=", "href=", "url(", "@import", "<script"})
    {
        EXPECT_EQ(page.find(reference), std::string::npos) << reference;
    }
    EXPECT_NE(page.find("<svg"), std::string::npos);
    EXPECT_NE(page.find("limit 50 ms"), std::string::npos);
    EXPECT_NE(page.find("<td>not inverse</td>"), std::string::npos);
    // No chart, table or name is wider than a narrow page: they scroll, and a name is broken.
    EXPECT_NE(page.find("figure{margin:.5rem 0;max-width:min(31rem,100%);overflow-x:auto}"), std::string::npos);
    EXPECT_NE(page.find(".scroll{overflow-x:auto}"), std::string::npos);
    EXPECT_NE(page.find("<div class=\"scroll\"><table>"), std::string::npos);
    EXPECT_NE(page.find("h1,h2{overflow-wrap:anywhere}"), std::string::npos);
}

TEST_F(MonitorCommandTest, BadInputIsOneLine)
{
    Verifies(req::SRS_MON_001);
    Verifies(req::SRS_MON_002);
    const Answer bad = Monitor({File("bad.log", "(1.000000) can0 101#01\n(1.000000) can0 101#0\n")});
    EXPECT_EQ(bad.status, 2);
    EXPECT_EQ(bad.err, Path("bad.log") + ":2:21: error: line '(1.000000) can0 101#0', expected 0 to 8 bytes of two "
                                         "hexadecimal digits\n");
    EXPECT_EQ(Monitor({}).status, 2);
    EXPECT_EQ(Monitor({Path("none.log")}).status, 2);
    EXPECT_EQ(RunCommand({"monitor", Recording()}).status, 2);
    EXPECT_EQ(RunCommand({"monitor", Recording(), "--can", "can0", "--dcf", Example("sensor")}).status, 2);
    EXPECT_EQ(RunCommand({"monitor", Recording(), "--dcf", Example("sensor") + "=128"}).status, 2);
    EXPECT_EQ(RunCommand({"monitor", Recording(), "--dcf", Example("sensor"), Example("sensor")}).status, 2);
    // What would be ignored is refused: a name that no frame has, an option that belongs to the other source
    const Answer nothing = Monitor({Recording(), "--interface", "can9"});
    EXPECT_EQ(nothing.status, 2);
    EXPECT_EQ(nothing.err, Path("bus.log") + ": error: no frame of interface 'can9', expected --interface with one of "
                                             "the recording\n");
    EXPECT_EQ(Monitor({Recording(), "--interface", "can0"}).status, 1);
    EXPECT_EQ(Monitor({Recording(), "--interface", ""}).status, 2);
    EXPECT_EQ(Monitor({Recording(), "--for", "1"}).status, 2);
    EXPECT_EQ(Monitor({"--can", "udp:239.74.163.3:43199", "--interface", "can0", "--for", "1"}).status, 2);
    const Answer own = Monitor({Recording(), "--html", Path("bus.log")});
    EXPECT_EQ(own.status, 2);
    EXPECT_EQ(own.err, Path("bus.log") + ": error: --html is a file that is read, expected another one\n");
    EXPECT_EQ(Monitor({Path("bus.log")}).status, 1);
    const Answer other = RunCommand({"monitor", "--can", "nothing:here", "--dcf", Example("sensor")});
    EXPECT_EQ(other.status, 2);
    EXPECT_EQ(std::count(other.err.begin(), other.err.end(), '\n'), 1) << other.err;
}

// Given two interfaces, one of which is silent while the other goes on, then nobody takes the frames of the second for
// those of the first, and the times of both are told.
TEST_F(MonitorCommandTest, FramesOfOtherInterfacesAreToldInEveryOutput)
{
    Verifies(req::SRS_MON_041);
    const std::string two = File("two.log", "(1.000000) can0 101#0102\n(1.000200) can0 102#FEFD\n"
                                            "(1.025000) can1 101#0102\n(1.025200) can1 102#FEFD\n"
                                            "(1.050000) can1 101#0102\n");
    const Answer answer = Monitor({two, "--html", Path("page.html")});
    EXPECT_EQ(answer.status, 0) << answer.err;
    const std::string told =
        "3 frames of other interfaces were not judged, the last at 1.050000; judged: 'can0', until 1.000200";
    EXPECT_EQ(answer.out.rfind("2 frames, 2 SRDO; 0.000200 s; 0 violations\n" + told + "\n", 0U), 0U) << answer.out;
    EXPECT_NE(cia306::ReadTextFile(Path("page.html"))
                  .find("<p>3 frames of other interfaces were not judged, the last at 1.050000; judged: "),
              std::string::npos);
    const auto document = nlohmann::json::parse(Monitor({two, "--interface", "can1", "--json"}).out);
    EXPECT_EQ(document["interface"], "can1");
    EXPECT_EQ(document["frames"], 3);
    EXPECT_EQ(document["other_frames"], 2);
    EXPECT_EQ(document["other_last_s"], 1.0002);
    const auto alone = nlohmann::json::parse(Monitor({Recording(), "--json"}).out);
    EXPECT_EQ(alone["interface"], "can0");
    EXPECT_EQ(alone["other_frames"], 0);
    EXPECT_TRUE(alone["other_last_s"].is_null());
    EXPECT_EQ(Monitor({Recording()}).out.find("other interfaces"), std::string::npos);
}

// Given a capture of all interfaces whose packets do not tell of which one they are, then that is a warning everywhere.
TEST_F(MonitorCommandTest, ACaptureThatDoesNotTellInterfacesApartIsAWarning)
{
    Verifies(req::SRS_MON_042);
    Verifies(req::SRS_MON_043);
    std::string bytes("\xD4\xC3\xB2\xA1\2\0\4\0\0\0\0\0\0\0\0\0\0\0\4\0\x71\0\0\0", 24U);
    bytes += std::string("\1\0\0\0\0\0\0\0\x1A\0\0\0\x1A\0\0\0", 16U) + std::string(14U, '\0') +
             std::string("\0\x0C\1\1\0\0\2\0\0\0\1\2", 12U);
    const std::string cooked = File("any.pcap", bytes);
    const std::string doubt =
        "link type 113 (SLL) does not tell interfaces apart: what is judged as one bus may be several";
    const Answer answer = Monitor({cooked, "--html", Path("page.html")});
    EXPECT_EQ(answer.status, 1); // No pair came.
    EXPECT_EQ(answer.err, cooked + ": warning: " + doubt + "\n");
    EXPECT_EQ(answer.out.rfind("1 frames, 1 SRDO; ", 0U), 0U) << answer.out;
    EXPECT_NE(cia306::ReadTextFile(Path("page.html")).find("<p class=\"bad\">" + doubt), std::string::npos);
    const Answer json = Monitor({cooked, "--json"});
    EXPECT_EQ(json.err, "");
    const auto document = nlohmann::json::parse(json.out);
    EXPECT_TRUE(document["interface"].is_null());
    ASSERT_EQ(document["warnings"].size(), 1U);
    EXPECT_EQ(document["warnings"][0]["file"], cooked);
    EXPECT_EQ(document["warnings"][0]["message"], doubt);
    // It has no interface that could be asked for
    const Answer refused = Monitor({cooked, "--interface", "can0"});
    EXPECT_EQ(refused.status, 2);
    EXPECT_EQ(refused.out, "");
    EXPECT_EQ(refused.err,
              cooked + ": error: --interface 'can0' with pcap of link type 113, which tells of no frame its interface, "
                       "expected no --interface, or a recording of candump, pcapng or link type 276 (SLL2)\n");
}

TEST_F(MonitorCommandTest, WhatIsNoFileIsRefused)
{
    Verifies(req::SRS_MON_001);
    for (const std::string& path : {std::string("/dev/zero"), Path(""), Path("none.log")})
    {
        const Answer answer = Monitor({path});
        EXPECT_EQ(answer.status, 2) << path;
        EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
    }
}

// Given a recording with nothing in it, or packed, then nobody is told that no violation was found.
TEST_F(MonitorCommandTest, ARecordingWithoutFramesIsRefused)
{
    Verifies(req::SRS_MON_001);
    const auto error_of = [this](const std::string& bytes)
    {
        const Answer answer = Monitor({File("some.log", bytes)});
        EXPECT_EQ(answer.status, 2);
        return answer.err.substr(Path("some.log").size());
    };
    EXPECT_EQ(error_of(""), ": error: it is empty, expected a recording of candump -l, pcap or pcapng\n");
    EXPECT_EQ(error_of("\n\r\n"), ": error: no CAN frame in it, expected a recording with at least one\n");
    EXPECT_EQ(error_of("\x1F\x8B\x08"), ": error: it is compressed (gzip), expected the recording itself, unpacked\n");
}

// Given a server of the bus that ends and comes back, then the monitor tells both and goes on.
TEST_F(MonitorCommandTest, GoesOnWhenALiveBusIsBack)
{
    Verifies(req::SRS_MON_018);
    const std::string group = "udp:239.74.163.5:43" + std::to_string(200 + ::getpid() % 700);
    auto server = std::make_unique<host::RunningServer>(group);
    const std::uint16_t port = server->Port();
    const std::string address = server->Address("can0");
    test::SteppedProcess monitor(Watching(address, "4"), Path("errors"));
    test::SleepMs(700);
    server.reset();
    test::SleepMs(300);
    server = std::make_unique<host::RunningServer>(group, port);
    test::SleepMs(1500);
    host::LiveFrame frame;
    frame.identifier = 0x705U;
    static_cast<void>(host::OpenLiveBus(group)->Send(frame));
    const std::string told = monitor.ReadAll();
    EXPECT_EQ(monitor.End(), 1) << told; // No pair came.
    EXPECT_EQ(cia306::ReadTextFile(Path("errors")), "counterpoint monitor: " + address +
                                                        " went down; nothing is judged until it is back\n" +
                                                        "counterpoint monitor: " + address + " is back\n");
    EXPECT_EQ(nlohmann::json::parse(told)["frames"], 1);
}

TEST_F(MonitorCommandTest, WiresharkShowsSrdoAndGfc)
{
    Verifies(req::SRS_MON_015);
    Verifies(req::SRS_MON_045);
    const std::string source = cia306::test::SourceFolder();
    const int status = std::system((source + "/tests/tools/wireshark_test.sh " + source).c_str());
    if (WEXITSTATUS(status) == 77)
    {
        GTEST_SKIP() << "tshark is not installed";
    }
    EXPECT_EQ(status, 0);
}

TEST_F(MonitorCommandTest, WatchesALiveBus)
{
    Verifies(req::SRS_MON_001);
    // Given a node that sends pairs every 25 ms, and one of them without its inverse frame
    const std::string address = "udp:239.74.163.2:43" + std::to_string(200 + ::getpid() % 700);
    const auto bus = host::OpenLiveBus(address);
    // When it is watched for a second
    test::SteppedProcess monitor(Watching(address, "1"));
    test::SleepMs(10);
    for (int pair = 0; pair < 40; ++pair)
    {
        host::LiveFrame frame;
        frame.identifier = 0x101U;
        frame.length_bytes = 2U;
        frame.data[0] = 1U;
        frame.data[1] = 2U;
        static_cast<void>(bus->Send(frame));
        frame.identifier = 0x102U;
        frame.data[0] = 0xFEU;
        frame.data[1] = 0xFDU;
        if (pair != 20)
        {
            static_cast<void>(bus->Send(frame));
        }
        test::SleepMs(25);
    }
    const std::string told = monitor.ReadAll();
    // Then the pairs are counted, and the missing frame is found
    const auto document = nlohmann::json::parse(told);
    EXPECT_EQ(monitor.End(), 1) << told;
    EXPECT_EQ(document["srdos"][0]["pairs"], 39);
    EXPECT_EQ(document["srdos"][0]["causes"]["SRVT expired"], 1);
}

// Given a bus without frames, then SIGTERM ends the watching as Ctrl-C does: with a summary.
TEST_F(MonitorCommandTest, ASummaryFollowsASignal)
{
    Verifies(req::SRS_MON_001);
    for (const int number : {SIGINT, SIGTERM})
    {
        // Before the command catches it, it does nothing.
        static_cast<void>(std::signal(number, [](int) {}));
        std::atomic<bool> is_over{false};
        std::thread asking(
            [number, &is_over]
            {
                while (!is_over)
                {
                    std::this_thread::sleep_for(std::chrono::milliseconds(50));
                    static_cast<void>(::kill(::getpid(), number));
                }
            });
        const std::string port = std::to_string(200 + ::getpid() % 700);
        const auto begun = std::chrono::steady_clock::now();
        const Answer answer = Monitor({"--can", "udp:239.74.163.3:43" + port, "--for", "600", "--json"});
        is_over = true;
        asking.join();
        static_cast<void>(std::signal(number, SIG_DFL));
        EXPECT_EQ(answer.status, 1) << answer.err; // No pair came.
        const auto document = nlohmann::json::parse(answer.out);
        EXPECT_EQ(document["violation_count"], 0);
        EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(500));
        EXPECT_TRUE(document["first_s"].is_null() && document["last_s"].is_null()) << answer.out; // No frame came.
    }
}

TEST_F(MonitorCommandTest, SigtermEndsItWhereNobodyReads)
{
    Verifies(req::SRS_MON_001);
    // Given a monitor whose output is a full pipe
    std::array<int, 2U> unread{};
    ASSERT_EQ(::pipe2(unread.data(), O_NONBLOCK), 0);
    const std::string piece(4096U, 'x');
    while (::write(unread[1], piece.data(), piece.size()) > 0)
    {
    }
    ASSERT_EQ(::fcntl(unread[1], F_SETFL, 0), 0);
    std::vector<std::string> words = Watching("udp:239.74.163.3:43" + std::to_string(200 + ::getpid() % 700), "600");
    std::vector<char*> line;
    for (std::string& word : words)
    {
        line.push_back(word.data());
    }
    line.push_back(nullptr);
    const pid_t monitor = ::fork();
    if (monitor == 0)
    {
        static_cast<void>(::dup2(unread[1], STDOUT_FILENO));
        static_cast<void>(::execv(line[0], line.data()));
        ::_exit(127);
    }
    ASSERT_GT(monitor, 0);
    std::this_thread::sleep_for(std::chrono::seconds(3)); // Until it catches signals.
    ASSERT_EQ(::waitpid(monitor, nullptr, WNOHANG), 0);
    // When it is told to end
    const auto begun = std::chrono::steady_clock::now();
    ASSERT_EQ(::kill(monitor, SIGTERM), 0);
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    ASSERT_EQ(::kill(monitor, SIGTERM), 0); // Which changes nothing.
    int status = 0;
    ASSERT_EQ(::waitpid(monitor, &status, 0), monitor);
    const auto took = std::chrono::steady_clock::now() - begun;
    // Then it waits two seconds for a reader and ends with status 2
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 2);
    EXPECT_GE(took, std::chrono::milliseconds(1900));
    EXPECT_LT(took, std::chrono::seconds(30)); // Of a busy machine.
    static_cast<void>(::close(unread[0]));
    static_cast<void>(::close(unread[1]));
}
} // namespace
} // namespace counterpoint::tools
