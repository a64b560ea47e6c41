// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Safety slaves in simulated networks of each profile: what is written to them, and what is not.
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/tools/command_run.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/nmt_master.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::tools
{
namespace
{
using test::Answer;
using test::RunCommand;

class ManagerSafetyTest : public test::CommandTest
{
  public:
    /// DCF of a device with another safeguard cycle time, rightly signed.
    std::string Other()
    {
        return File("other.dcf", cia306::test::Changed(cia306::test::ExampleText("actuator"),
                                                       {{"ParameterValue=50\n", "ParameterValue=51\n"},
                                                        {"ParameterValue=0x9FCB", "ParameterValue=0xC68D"}}));
    }
};

TEST_F(ManagerSafetyTest, EveryProfileWritesASafetyConfigurationButNotToAnotherDevice)
{
    Verifies(req::SRS_SFS_005);
    Verifies(req::SRS_SFS_009);
    const std::string dcf = cia306::test::SourceFolder() + "/examples/emergency_stop/actuator.dcf";
    for (const char* const profile : {"cia302", "el6751", "plc_designer"})
    {
        for (const bool is_other : {false, true})
        {
            // Given a safety slave with another configuration, as the expected device and as another one
            const std::string network =
                File("writing.yaml", "manager: {node: 127, heartbeat: 100 ms, profile: " + std::string(profile) +
                                         "}\nslaves: [{node: 33, dcf: " + dcf + ", write_safety: true" +
                                         (is_other ? ", serial: 5, device_type: 7" : "") + "}]\n");
            const std::string head = "title: x\nduration: 9 s\nmanagers: [{network: " + network +
                                     "}]\nnodes: {33: {dcf: " + dcf +
                                     "}}\nevents:\n  - {at: 2 s, do: order, order: preop 33}\n"
                                     "  - {at: 2100 ms, do: store, node: 33, object: \"0x1301:02\", value: 77}\n"
                                     "  - {at: 3 s, do: send, identifier: 0, data: \"01 21\"}\nexpect:\n";
            // When it is found OPERATIONAL, then it is written or not
            const std::string writes = "  - {that: event, is: write_safety, node: 33}\n"
                                       "  - {that: gate, node: 33, is: open}\n";
            const std::string does_not = "  - {that: no_event, is: write_safety, node: 33}\n";
            const Answer answer =
                RunCommand({"simulate", "--quiet", File("s.yaml", head + (is_other ? does_not : writes))});
            EXPECT_EQ(answer.status, 0) << profile << is_other << "\n" << answer.out << answer.err;
        }
    }
}

TEST_F(ManagerSafetyTest, WhatWasWrittenIsNotLostByTheStartUpBehindIt)
{
    Verifies(req::SRS_SFS_214);
    const std::string dcf = cia306::test::SourceFolder() + "/examples/emergency_stop/actuator.dcf";
    // Given a device that forgets at each reset what was written, and comes with another safeguard cycle time
    const std::string other = Other();
    struct Case
    {
        const char* profile;
        const char* more;
    };
    for (const Case& row :
         {Case{"cia302", ""}, Case{"cia302", ", keep_alive: true"}, Case{"el6751", ""}, Case{"plc_designer", ""}})
    {
        const std::string network =
            File("forgets.yaml", "manager: {node: 127, profile: " + std::string(row.profile) +
                                     "}\nslaves: [{node: 33, dcf: " + dcf + ", write_safety: true" + row.more + "}]\n");
        const std::string scenario = "title: x\nduration: 5 s\nmanagers: [{network: " + network +
                                     "}]\nnodes: {33: {dcf: " + other +
                                     "}}\nexpect:\n"
                                     "  - {that: event, is: write_safety, node: 33}\n"
                                     "  - {that: gate, node: 33, is: open}\n"
                                     "  - {that: device, node: 33, is: operational}\n";
        const Answer answer = RunCommand({"simulate", File("s.yaml", scenario)});
        EXPECT_EQ(answer.status, 0) << row.profile << row.more << "\n" << answer.out << answer.err;
        const std::size_t first = answer.out.find("writes the safety configuration");
        EXPECT_NE(first, std::string::npos);
        EXPECT_EQ(answer.out.find("writes the safety configuration", first + 1U), std::string::npos) << answer.out;
    }
}

TEST_F(ManagerSafetyTest, AWritingThatSomebodyInterruptsIsTakenUpUnlessByAStop)
{
    Verifies(req::SRS_SFS_213);
    const std::string dcf = cia306::test::SourceFolder() + "/examples/emergency_stop/actuator.dcf";
    const std::string other = Other();
    for (const char* const profile : {"cia302", "el6751", "plc_designer"})
    {
        for (const bool is_stop : {false, true})
        {
            // When a command of somebody else comes in the middle of the writing
            const std::string at = (std::string(profile) == "plc_designer") ? "525 ms" : "30 ms";
            const std::string network =
                File("interrupted.yaml", "manager: {node: 127, profile: " + std::string(profile) +
                                             "}\nslaves: [{node: 33, dcf: " + dcf + ", write_safety: true}]\n");
            const std::string scenario =
                "title: x\nduration: 4 s\nmanagers: [{network: " + network + "}]\nnodes: {33: {dcf: " + other +
                "}}\nevents:\n  - {at: " + at + ", do: send, identifier: 0, data: \"" + (is_stop ? "02" : "80") +
                " 21\"}\nexpect:\n  - {that: gate, node: 33, is: " + (is_stop ? "closed" : "open") +
                "}\n  - {that: device, node: 33, is: " + (is_stop ? "stopped" : "operational") + "}\n";
            const Answer answer = RunCommand({"simulate", File("s.yaml", scenario)});
            EXPECT_EQ(answer.status, 0) << profile << is_stop << "\n" << answer.out << answer.err;
        }
    }
}

TEST_F(ManagerSafetyTest, AWritingThatTheBootOfAllBreaksOffIsTakenUp)
{
    Verifies(req::SRS_SFS_213);
    const std::string folder = cia306::test::SourceFolder() + "/examples/emergency_stop/";
    // Given single resets, the last after 0.63 s, for the sake of a slave that is kept alive and is not there
    const std::string network = File("singly.yaml", "manager: {node: 127, inhibit: 5 ms}\nslaves:\n"
                                                    "  - {node: 2, dcf: " +
                                                        folder +
                                                        "controller.dcf, keep_alive: true, mandatory: false}\n"
                                                        "  - {node: 33, dcf: " +
                                                        folder + "actuator.dcf, write_safety: true}\n");
    const std::string scenario = "title: x\nduration: 4 s\nmanagers: [{network: " + network +
                                 "}]\nnodes: {33: {dcf: " + Other() +
                                 "}}\nexpect:\n  - {that: event, is: write_safety, node: 33}\n"
                                 "  - {that: gate, node: 33, is: open}\n"
                                 "  - {that: device, node: 33, is: operational}\n";
    const Answer answer = RunCommand({"simulate", File("s.yaml", scenario)});
    EXPECT_EQ(answer.status, 0) << answer.out << answer.err;
}

TEST_F(ManagerSafetyTest, BehindAStopOfAllTheWrittenSlaveWaitsForAnOrder)
{
    Verifies(req::SRS_BOOT_343);
    const std::string dcf = cia306::test::SourceFolder() + "/examples/emergency_stop/actuator.dcf";
    for (const bool is_ordered : {false, true})
    {
        // Given 1F80h bit 6, and a mandatory slave that differs
        const std::string network =
            File("stops.yaml",
                 "manager: {node: 127, start_up: 0x41}\nslaves: [{node: 33, dcf: " + dcf + ", write_safety: true}]\n");
        const std::string scenario =
            "title: x\nduration: 4 s\nmanagers: [{network: " + network + "}]\nnodes: {33: {dcf: " + Other() + "}}\n" +
            (is_ordered ? "events:\n  - {at: 2 s, do: order, order: start 33}\n" : "") +
            "expect:\n  - {that: event, is: write_safety, node: 33}\n  - {that: gate, node: 33, is: open}\n"
            "  - {that: device, node: 33, is: " +
            (is_ordered ? "operational" : "pre-operational") + "}\n";
        const Answer answer = RunCommand({"simulate", File("s.yaml", scenario)});
        EXPECT_EQ(answer.status, 0) << is_ordered << answer.out << answer.err;
    }
}

TEST_F(ManagerSafetyTest, NoOrderStartsOrWritesAnotherDevice)
{
    Verifies(req::SRS_SFS_009);
    Verifies(req::SRS_MGR_136);
    Verifies(req::SRS_SFS_340);
    const std::string dcf = cia306::test::SourceFolder() + "/examples/emergency_stop/actuator.dcf";
    for (const char* const profile : {"cia302", "el6751", "plc_designer"})
    {
        const std::string network =
            File("other.yaml", "manager: {node: 127, profile: " + std::string(profile) +
                                   "}\nslaves: [{node: 33, dcf: " + dcf + ", serial: 5, device_type: 7}]\n");
        const std::string scenario = "title: x\nduration: 6 s\nmanagers: [{network: " + network +
                                     "}]\nnodes: {33: {dcf: " + dcf +
                                     "}}\nevents:\n  - {at: 4 s, do: order, order: start 33}\n"
                                     "  - {at: 5 s, do: order, order: write-safety 33}\n"
                                     "  - {at: 5500 ms, do: order, order: start all}\nexpect:\n"
                                     "  - {that: device, node: 33, is: pre-operational}\n"
                                     "  - {that: gate, node: 33, is: closed}\n";
        const Answer answer = RunCommand({"simulate", File("s.yaml", scenario)});
        EXPECT_EQ(answer.status, 0) << profile << "\n" << answer.out << answer.err;
        EXPECT_NE(answer.out.find("order start 33: the start-up did not find the expected device at this node-ID, "
                                  "expected that one, and boot NODE"),
                  std::string::npos)
            << answer.out;
        EXPECT_NE(answer.out.find("order write-safety 33: node 33 is not known to be the expected device, expected "
                                  "that one, and boot NODE"),
                  std::string::npos)
            << answer.out;
        EXPECT_NE(answer.out.find("order start all: taken but for node 33: not known to be the expected device"),
                  std::string::npos)
            << answer.out;
    }
}

TEST_F(ManagerSafetyTest, EveryProfileRepairsAChangedGlobalFailSafeObject)
{
    Verifies(req::SRS_SFS_005);
    const std::string dcf = cia306::test::SourceFolder() + "/examples/emergency_stop/actuator.dcf";
    for (const char* const profile : {"cia302", "el6751", "plc_designer"})
    {
        const std::string network =
            File("gfc.yaml", "manager: {node: 127, profile: " + std::string(profile) +
                                 "}\nslaves: [{node: 33, dcf: " + dcf + ", write_safety: true}]\n");
        const std::string scenario = "title: x\nduration: 9 s\nmanagers: [{network: " + network +
                                     "}]\nnodes: {33: {dcf: " + dcf +
                                     "}}\nevents:\n  - {at: 3 s, do: order, order: preop 33}\n"
                                     "  - {at: 3100 ms, do: store, node: 33, object: \"0x1300:00\", value: 0}\n"
                                     "  - {at: 3200 ms, do: order, order: start 33}\nexpect:\n"
                                     "  - {that: event, is: write_safety, node: 33}\n"
                                     "  - {that: gate, node: 33, is: open}\n"
                                     "  - {that: device, node: 33, is: operational}\n";
        const Answer answer = RunCommand({"simulate", "--quiet", File("s.yaml", scenario)});
        EXPECT_EQ(answer.status, 0) << profile << "\n" << answer.out << answer.err;
    }
}
} // namespace
} // namespace counterpoint::tools
