// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Safety slaves whose 1300h to 13FFh are the expected ones, and what these do not cover is not.
#include "canopen/cia306/text/text_file.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/tools/command_run.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::tools
{
namespace
{
using test::Answer;
using test::RunCommand;

/// The text with the first `from` behind the head of a section replaced.
std::string Having(std::string text, const std::string& section, const std::string& from, const std::string& to)
{
    const std::size_t place = text.find(from, text.find("[" + section + "]"));
    return text.replace(place, from.size(), to);
}

class ManagerParametersTest : public test::CommandTest
{
  protected:
    ManagerParametersTest() : dcf_(cia306::test::ExampleText("actuator"))
    {
        static_cast<void>(File("right.dcf", dcf_));
        static_cast<void>(File("zero.dcf", Having(dcf_, "5F04", "0x046FFAB7", "0")));
        // Automatic release instead of the restart interlock, and its digest
        const std::string automatic = Having(dcf_, "5F01sub1", "ParameterValue=0x00", "ParameterValue=0x5A");
        static_cast<void>(File("automatic.dcf", Having(automatic, "5F04", "0x046FFAB7", "0xD22348DA")));
        static_cast<void>(File("automatic_zero.dcf", Having(automatic, "5F04", "0x046FFAB7", "0")));
        const std::string kept = Having(dcf_, "5F02sub1", "ParameterValue=0x0000000000000000", "ParameterValue=0x7FFF");
        static_cast<void>(File("kept_zero.dcf", Having(kept, "5F04", "0x046FFAB7", "0")));
        static_cast<void>(
            File("late_zero.dcf", Having(Having(dcf_, "5F05sub1", "ParameterValue=0x00", "ParameterValue=0x3C"), "5F04",
                                         "0x046FFAB7", "0")));
    }
    /// A run of the device of one file under a manager that expects another one.
    Answer Run(const std::string& profile, const std::string& expected, const std::string& device,
               const std::string& expectations)
    {
        const std::string network = File("net.yaml", "manager: {node: 127, heartbeat: 100 ms, profile: " + profile +
                                                         "}\nslaves: [{node: 33, dcf: " + expected + "}]\n");
        return RunCommand(
            {"simulate", File("s.yaml", "title: x\nduration: 3 s\nmanagers: [{network: " + network +
                                            "}]\nnodes: {33: {dcf: " + device + "}}\nexpect:\n" + expectations)});
    }

    std::string dcf_;
};

const std::string kStarted = "  - {that: gate, node: 33, is: open, at: 2900 ms}\n"
                             "  - {that: device, node: 33, is: operational, at: 2900 ms}\n";
const std::string kRefused = "  - {that: gate, node: 33, is: differs, at: 2900 ms}\n";
const std::string kStart = "node 33: NMT start\n";

TEST_F(ManagerParametersTest, ADeviceWithAnotherReleasePolicyIsNotStartedUnderAnyProfile)
{
    Verifies(req::SRS_SFS_670);
    for (const char* const profile : {"cia302", "el6751", "plc_designer"})
    {
        const Answer right = Run(profile, "right.dcf", "right.dcf", kStarted);
        EXPECT_EQ(right.status, 0) << profile << "\n" << right.out << right.err;
        EXPECT_NE(right.out.find(kStart), std::string::npos) << right.out;
        const Answer other = Run(profile, "right.dcf", "automatic.dcf", kRefused);
        EXPECT_EQ(other.status, 0) << profile << "\n" << other.out << other.err;
        EXPECT_EQ(other.out.find(kStart), std::string::npos) << other.out;
        EXPECT_NE(other.out.find("0x5F04:00 is 0xD22348DA, expected 0x46FFAB7"), std::string::npos) << other.out;
    }
}

TEST_F(ManagerParametersTest, WithoutADigestPolicySafeValueAndDetectionAreCompared)
{
    Verifies(req::SRS_SFS_670);
    const Answer right = Run("cia302", "zero.dcf", "zero.dcf", kStarted);
    EXPECT_EQ(right.status, 0) << right.out << right.err;
    const std::pair<const char*, const char*> others[] = {
        {"automatic_zero.dcf", "0x5F01:01 is 0x5A, expected 0x0"},
        {"kept_zero.dcf", "0x5F02:01 is 0x7FFF, expected 0x0"},
        {"late_zero.dcf", "0x5F05:01 is 0x3C, expected 0x0"},
    };
    for (const auto& [device, told] : others)
    {
        const Answer other = Run("cia302", "zero.dcf", device, kRefused);
        EXPECT_EQ(other.status, 0) << device << "\n" << other.out << other.err;
        EXPECT_NE(other.out.find(told), std::string::npos) << other.out;
    }
}

TEST_F(ManagerParametersTest, TwoMastersThatExpectOtherParametersAreNamed)
{
    Verifies(req::SRS_MGR_009);
    const auto network = [this](const std::string& node, const std::string& other, const std::string& dcf)
    {
        return File("net_" + node + ".yaml",
                    "manager: {node: " + node + ", heartbeat: 200 ms, flying: {priority: 1}}\nslaves: [{node: " +
                        other + ", boot: false, mandatory: false, consumer: 500 ms}, {node: 33, dcf: " + dcf + "}]\n");
    };
    const std::string two = network("2", "5", "right.dcf");
    const Answer differs = RunCommand({"manager", "--check", two, network("5", "2", "automatic.dcf")});
    EXPECT_EQ(differs.status, 1) << differs.err;
    EXPECT_NE(differs.out.find("0x5F04:00 of node 33 (safety) is 0xD22348DA, expected 0x46FFAB7"), std::string::npos)
        << differs.out;
    const std::string three = network("2", "5", "zero.dcf");
    const Answer value = RunCommand({"manager", "--check", three, network("5", "2", "kept_zero.dcf")});
    EXPECT_EQ(value.status, 1) << value.err;
    EXPECT_NE(value.out.find("0x5F02:01 of node 33 (safety) is 0x7FFF, expected 0x0"), std::string::npos) << value.out;
}

// A value outside its type is left out with a warning by every command.
TEST_F(ManagerParametersTest, AFileThatCheckTakesWithAWarningIsTakenHereToo)
{
    Verifies(req::SRS_EDS_032);
    const std::string plain = cia306::ReadTextFile(cia306::test::SourceFolder() + "/tests/runtime/data/plain.dcf");
    static_cast<void>(File("odd.dcf", plain + "\n[2F00]\nParameterName=x\nObjectType=7\nDataType=6\nAccessType=rw\n"
                                              "DefaultValue=7\nParameterValue=70000\nPDOMapping=0\n"));
    const std::string network = File("odd.yaml", "manager: {node: 127}\nslaves: [{node: 5, dcf: odd.dcf}]\n");
    const Answer answer = RunCommand({"simulate", "--quiet",
                                      File("odd_run.yaml", "title: x\nduration: 1 s\nmanagers: [{network: " + network +
                                                               "}]\nnodes: {5: {dcf: odd.dcf}}\n")});
    EXPECT_EQ(answer.status, 0) << answer.out << answer.err;
    EXPECT_EQ(answer.err.find("error"), std::string::npos) << answer.err;
}
} // namespace
} // namespace counterpoint::tools
