// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// One scenario under several start-up profiles.
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/tools/command_run.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"
#include "verification/trace/verifies.hpp"

#include <nlohmann/json.hpp>

namespace counterpoint::tools
{
namespace
{
using test::Answer;
using test::RunCommand;

/// A network with keys of two profiles, whose own profile is the third one.
class ProfileNetworkTest : public test::CommandTest
{
  protected:
    ProfileNetworkTest()
    {
        static_cast<void>(File("net.yaml", "manager: {node: 127, heartbeat: 200 ms, boot_time: 5 s, sync: 10 ms, "
                                           "profile: plc_designer}\nslaves: [{node: 33, dcf: " +
                                               Relay() + "}]\n"));
    }
    static std::string Relay()
    {
        return cia306::test::SourceFolder() + "/examples/emergency_stop/actuator.dcf";
    }
    /// The relay is pulled under one profile only.
    [[nodiscard]] std::string Scenario() const
    {
        return File("s.yaml", "title: Relay\nduration: 8 s\nmanagers: [{network: net.yaml}]\n"
                              "profiles: [cia302, el6751]\nnodes: {33: {dcf: " +
                                  Relay() +
                                  "}}\nevents:\n"
                                  "  - {at: 7 s, do: pull, node: 33, profile: el6751}\n"
                                  "expect:\n"
                                  "  - {that: device, node: 33, is: operational, at: 6900 ms}\n"
                                  "  - {that: letter, node: 33, is: none, profile: cia302}\n"
                                  "  - {that: device, node: 33, is: operational, profile: [cia302]}\n"
                                  "  - {that: code, node: 33, is: 0, at: 6900 ms, profile: el6751}\n"
                                  "  - {that: device, node: 33, is: absent, profile: el6751}\n");
    }
    void ExpectRefused(const std::string& text, const std::string& message) const
    {
        const std::string file = File("bad.yaml", "duration: 1 s\n" + text + "\nnodes: {33: {dcf: " + Relay() + "}}\n");
        const Answer answer = RunCommand({"simulate", file});
        EXPECT_EQ(answer.status, 2) << text;
        EXPECT_EQ(answer.err, file + message + "\n");
    }
};

TEST_F(ProfileNetworkTest, TheFirstProfileRunsUnlessAnotherOneIsChosen)
{
    Verifies(req::SRS_SIM_059);
    Verifies(req::SRS_NET_006);
    const Answer first = RunCommand({"simulate", Scenario()});
    EXPECT_EQ(first.status, 0) << first.out;
    EXPECT_NE(first.out.find("\n3 of 3 expectations hold, profile cia302\n"), std::string::npos) << first.out;
    const Answer other = RunCommand({"simulate", Scenario(), "--profile", "el6751"});
    EXPECT_EQ(other.status, 0) << other.out;
    EXPECT_NE(other.out.find("\n3 of 3 expectations hold, profile el6751\n"), std::string::npos) << other.out;
    // Keys of the network file that only another profile looks at are meant for that one
    EXPECT_EQ(first.err + other.err, "");
}

TEST_F(ProfileNetworkTest, WhatIsWrittenTellsWhichProfileRan)
{
    Verifies(req::SRS_SIM_059);
    const auto text = [this](const char* const name) { return cia306::ReadTextFile(Path(name)); };
    const std::vector<std::string> files{"--quiet", "--json", Path("o.json"), "--html", Path("o.html")};
    std::vector<std::string> words{"simulate", Scenario(), "--profile", "el6751"};
    words.insert(words.end(), files.begin(), files.end());
    EXPECT_EQ(RunCommand(words).status, 0);
    EXPECT_EQ(nlohmann::json::parse(text("o.json")).at("profile"), "el6751");
    EXPECT_NE(text("o.html").find("s.yaml, profile el6751, seed 1"), std::string::npos);
    // The same of a sweep
    words.insert(words.end(), {"--sweep", "seed=1:2:1"});
    EXPECT_EQ(RunCommand(words).status, 0);
    EXPECT_EQ(nlohmann::json::parse(text("o.json")).at("profile"), "el6751");
    EXPECT_NE(text("o.html").find("s.yaml, profile el6751: 2 of 2"), std::string::npos);
}

TEST_F(ProfileNetworkTest, AnExtendedScenarioIsWrittenForItsOwnProfiles)
{
    Verifies(req::SRS_SIM_059);
    const std::string base = Scenario();
    const auto told = [this, &base](const std::string& more)
    { return RunCommand({"simulate", File("more.yaml", "extends: " + base + "\n" + more)}).out; };
    EXPECT_NE(told("title: x\n").find("3 of 3 expectations hold, profile cia302\n"), std::string::npos);
    EXPECT_NE(told("profiles: el6751\n").find("3 of 3 expectations hold, profile el6751\n"), std::string::npos);
}

TEST_F(ProfileNetworkTest, AnUnknownProfileIsRefused)
{
    Verifies(req::SRS_SIM_059);
    const auto refusal = [](const std::string& file, const std::string& profile)
    {
        const Answer answer = RunCommand({"simulate", file, "--profile", profile});
        EXPECT_EQ(answer.status, 2);
        return answer.err;
    };
    EXPECT_EQ(refusal(Scenario(), "plc_designer"),
              "--profile: error: 'plc_designer', expected one of cia302, el6751\n");
    EXPECT_EQ(refusal(Scenario(), ""),
              "counterpoint: --profile: an empty value, expected a text; expected a command line "
              "as told by 'counterpoint simulate --help'\n");
    EXPECT_EQ(refusal(cia306::test::SourceFolder() + "/examples/emergency_stop/00_no_fault.yaml", "cia302"),
              "--profile: error: 'cia302', expected a scenario with 'profiles'\n");
    const std::string managers = "managers: [{network: net.yaml}]\n";
    ExpectRefused(managers + "profiles: [cia302, cia301]",
                  ":3:20: error: 'cia301' (did you mean 'cia302'?), expected one of cia302, el6751, plc_designer");
    ExpectRefused(managers + "profiles: []", ":3:11: error: an empty list, expected one profile or more");
    ExpectRefused(managers + "profiles: [el6751, el6751]",
                  ":3:20: error: 'el6751' a second time, expected each profile once");
    ExpectRefused("profiles: cia302", ":2:11: error: profiles without managers, expected the key 'managers', too");
    ExpectRefused(managers + "profiles: cia302\nevents: [{at: 0 s, do: pull, node: 33, profile: el6751}]",
                  ":4:49: error: profile 'el6751', expected one of its 'profiles': cia302");
    ExpectRefused(managers + "expect: [{that: state, node: 33, is: missing, profile: cia302}]",
                  ":3:56: error: profile 'cia302', expected a scenario with 'profiles'");
    ExpectRefused(managers + "profiles: cia302\nexpect: [{that: state, node: 33, is: missing, profile: []}]",
                  ":4:56: error: an empty list, expected one profile or more");
}

using StartOfAllTest = test::CommandTest;

TEST_F(StartOfAllTest, AStartOfAllThatSomeSlavesCannotTakeNamesThem)
{
    Verifies(req::SRS_PLC_150);
    Verifies(req::SRS_PLC_151);
    // Given slave 5 that waits for its start, 6 of another type and 7, optional and absent
    const std::string io = cia306::test::SourceFolder() + "/examples/networks/managed_faults/io.dcf";
    static_cast<void>(File("net.yaml", "manager: {node: 127, profile: plc_designer, start_up: 0x9}\nslaves:\n"
                                       "  - {node: 5, device_type: 0x30191}\n  - {node: 6, device_type: 0x30192}\n"
                                       "  - {node: 7, mandatory: false}\n"));
    const std::string scenario =
        File("scenario.yaml", "title: Start of all\nduration: 5 s\nmanagers: [{network: net.yaml}]\nnodes:\n"
                              "  5: {dcf: " +
                                  io + "}\n  6: {dcf: " + io +
                                  "}\nevents:\n  - {at: 100 ms, do: order, order: start all}\n"
                                  "  - {at: 4 s, do: order, order: start all}\n"
                                  "  - {at: 4500 ms, do: order, order: start 6}\n"
                                  "expect:\n  - {that: device, node: 5, is: operational}\n");
    const Answer answer = RunCommand({"simulate", scenario});
    EXPECT_EQ(answer.status, 0) << answer.out << answer.err;
    for (const char* const text :
         {"order start all: not taken by node 5 (2: settles), node 6 (2: settles), node 7 (1: waits for boot-up), "
          "expected each in state 4, 5 or 99\n",
          "order start all: taken, but not by node 6 (98: device type differs), node 7 (97: optional, absent), "
          "expected "
          "each in state 4, 5 or 99\n",
          "order start 6: not taken by node 6 (98: device type differs), expected each in state 4, 5 or 99\n"})
    {
        EXPECT_NE(answer.out.find(text), std::string::npos) << answer.out;
    }
}
} // namespace
} // namespace counterpoint::tools
