// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Scenarios of networks that ask for what nobody can tell any more, or order what no manager there can do.
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/tools/command_run.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <algorithm>

namespace counterpoint::tools
{
namespace
{
using test::Answer;
using test::RunCommand;

class VainNetworkTest : public test::CommandTest
{
  protected:
    VainNetworkTest()
    {
        const std::string dcf = cia306::test::SourceFolder() + "/examples/emergency_stop/";
        const std::string slaves = "slaves:\n  - {node: 33, dcf: " + dcf + "actuator.dcf}\n  - {node: 5}\n";
        static_cast<void>(File("net.yaml", "manager: {node: 127}\n" + slaves));
        static_cast<void>(File("plc.yaml", "manager: {node: 127, profile: plc_designer}\n" + slaves));
        static_cast<void>(File("el.yaml", "manager: {node: 127, profile: el6751}\n" + slaves));
        static_cast<void>(File("fly.yaml", "manager: {node: 9, heartbeat: 200 ms, flying: {priority: 0}}\n" + slaves));
        static_cast<void>(File(
            "held.yaml", "manager: {node: 9, heartbeat: 200 ms, flying: {priority: 0, start: by_order}}\n" + slaves));
        devices_ =
            "nodes:\n  33: {dcf: " + dcf + "actuator.dcf}\n  2: {phase: 500 ms, dcf: " + dcf + "controller.dcf}\n";
    }
    [[nodiscard]] Answer AnswerTo(const std::string& network, const std::string& part,
                                  const std::vector<std::string>& options = {})
    {
        std::vector<std::string> words{"simulate", "--quiet"};
        words.insert(words.end(), options.begin(), options.end());
        words.push_back(File("s.yaml", "title: x\nduration: 2 s\nmanagers: [{network: " + network + "}]\n" + part +
                                           "\n" + devices_));
        return RunCommand(words);
    }
    void ExpectRefused(const std::string& network, const std::string& part, const std::string& message,
                       const std::vector<std::string>& options = {})
    {
        const Answer answer = AnswerTo(network, part, options);
        EXPECT_EQ(answer.status, 2) << part;
        EXPECT_EQ(answer.err.rfind(Path("s.yaml") + message, 0U), 0U) << part << "\n" << answer.err;
        EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
        EXPECT_EQ(answer.out, "") << part;
    }
    void ExpectTaken(const std::string& network, const std::string& part, const std::vector<std::string>& options = {})
    {
        const Answer answer = AnswerTo(network, part, options);
        EXPECT_EQ(answer.status, 0) << part << "\n" << answer.out << answer.err;
    }
    void ExpectOrderRefused(const std::string& network, const std::string& order, const std::string& message)
    {
        ExpectRefused(network, "events: [{at: 1 s, do: order, order: " + order + "}]",
                      ":4:38: error: order '" + order + "' " + message + "\n");
    }

    std::string devices_;
};

TEST_F(VainNetworkTest, AWindowBeginsBeforeTheEndOfTheRun)
{
    Verifies(req::SRS_SIM_585);
    for (const std::string that : {"event", "no_event"})
    {
        const std::string head = "expect: [{that: " + that + ", is: heartbeat_lost, from: ";
        ExpectRefused("net.yaml", head + "9 s}]",
                      ":4:10: error: a window from 9000 ms, not before the end of the run, expected 'from' below 2000 "
                      "ms\n");
        ExpectRefused("net.yaml", head + "2 s}]", ":4:10: error: a window from 2000 ms, not before the end of the run");
        // Also where the run ends earlier than it is written
        ExpectRefused("net.yaml", head + "1 s}]",
                      ":4:10: error: a window from 1000 ms, not before the end of the run, expected 'from' below 800 "
                      "ms\n",
                      {"--until", "800ms"});
        ExpectRefused("net.yaml", head + "1 s, until: 3 s}]", ":4:10: error: expectation at 3000 ms, after the end of");
    }
    ExpectTaken("net.yaml", "expect: [{that: no_event, is: heartbeat_lost, from: 1999 ms}]");
    ExpectTaken("net.yaml", "expect: [{that: no_event, is: heartbeat_lost, from: 1999 ms, until: 2 s}]");
}

TEST_F(VainNetworkTest, ADeviceIsLookedAtWhenItIsThere)
{
    Verifies(req::SRS_SIM_586);
    // Given device 2, which comes at 500 ms
    const std::string state = "expect: [{that: device, node: 2, is: ";
    ExpectRefused("net.yaml", state + "absent, at: 499 ms}]",
                  ":4:10: error: expectation at 499 ms, before node '2' comes, expected a time from 500 ms on\n");
    ExpectTaken("net.yaml", state + "pre-operational, at: 500 ms}]");
    ExpectTaken("net.yaml", state + "pre-operational}]");
    const std::string output = "expect: [{that: output, node: 2, is: closed, at: ";
    ExpectRefused("net.yaml", output + "100 ms}]", ":4:10: error: expectation at 100 ms, before node '2' comes");
    ExpectTaken("net.yaml", output + "500 ms}]");
    for (const std::string that :
         {"{that: safe, node: 2, srdo: 1, at: 200 ms}", "{that: released, node: 2, srdo: 1, at: 0}",
          "{that: value, node: 2, object: 0x2200:01, is: 0, at: 1 ms}"})
    {
        ExpectRefused("net.yaml", "expect: [" + that + "]", ":4:10: error: expectation at ");
    }
    ExpectTaken("net.yaml", "expect: [{that: safe, node: 2, srdo: 1, at: 501 ms}]");
}

TEST_F(VainNetworkTest, AManagerThatWasKilledIsAskedNothingMore)
{
    Verifies(req::SRS_MGR_585);
    const std::string killed = "events: [{at: 1 s, do: kill_manager, node: 9}, {at: 1200 ms, do: pull, node: 33}]\n";
    const std::string late = ":5:10: error: a time after manager 9 was killed (without 'at' it is the end of the "
                             "scenario), expected one up to 1000 ms\n";
    for (const std::string that : {"state, node: 33, is: operational", "letter, node: 33, is: none",
                                   "gate, node: 33, is: open", "finding, node: 33, is: none", "active, is: 'false'"})
    {
        ExpectRefused("fly.yaml", killed + "expect: [{that: " + that + ", at: 1001 ms}]", late);
        ExpectRefused("fly.yaml", killed + "expect: [{that: " + that + ", manager: 9}]", late);
    }
    for (const std::string that : {"event", "no_event"})
    {
        ExpectRefused(
            "fly.yaml", killed + "expect: [{that: " + that + ", is: heartbeat_lost, from: 1 s}]",
            ":5:10: error: a window that begins when manager 9 was killed already, expected 'from' below 1000 ms\n");
    }
    // What it knew until then, and what it had told
    ExpectTaken("fly.yaml", killed + "expect: [{that: letter, node: 33, is: none, at: 1 s}, {that: no_event, is: "
                                     "heartbeat_lost, from: 999 ms}, {that: flying, is: 3}]");
    // What is so, and what another one knows
    ExpectTaken("fly.yaml}, {network: net.yaml",
                killed + "expect: [{that: device, node: 33, is: absent}, {that: "
                         "no_event, is: emergency, manager: 127}]",
                {"--until", "1900ms"});
}

TEST_F(VainNetworkTest, AnEventThatLastsHasALength)
{
    Verifies(req::SRS_MGR_586);
    for (const std::string what : {"babble, identifier: 1", "bus_off", "no_controller", "emcy_storm, node: 5",
                                   "send, identifier: 1, every: 1 ms"})
    {
        ExpectRefused("net.yaml", "events: [{at: 1 s, do: " + what + ", until: 1 s}]",
                      ":4:10: error: an end at the beginning, expected a time after 'at' behind 'until'\n");
        ExpectRefused("net.yaml", "events: [{at: 1 s, do: " + what + ", until: 999 ms}]",
                      ":4:10: error: an end before the beginning, expected a time after 'at' behind 'until'\n");
        ExpectTaken("net.yaml", "events: [{at: 1 s, do: " + what + ", until: 1001 ms}]");
    }
    ExpectTaken("net.yaml", "events: [{at: 1 s, do: send, identifier: 1}]");
}

TEST_F(VainNetworkTest, AnOrderIsOneThatTheProfileHas)
{
    Verifies(req::SRS_MGR_587);
    ExpectOrderRefused("net.yaml", "control 33 5 1", "with the profile cia302, expected the profile el6751");
    ExpectOrderRefused("plc.yaml", "control 33 5 1", "with the profile plc_designer, expected the profile el6751");
    ExpectOrderRefused("net.yaml", "output 33 1 01", "with the profile cia302, expected the profile el6751");
    ExpectOrderRefused("el.yaml", "control 33 5 4",
                       "with ADS state 5 and device state 4, expected 5 and 0 to 3, or 6 and 0");
    ExpectOrderRefused("el.yaml", "control 33 6 1",
                       "with ADS state 6 and device state 1, expected 5 and 0 to 3, or 6 and 0");
    ExpectOrderRefused("el.yaml", "control 33 4 0",
                       "with ADS state 4 and device state 0, expected 5 and 0 to 3, or 6 and 0");
    ExpectTaken("el.yaml", "events: [{at: 1 s, do: order, order: control 33 5 3}]");
    ExpectTaken("el.yaml", "events: [{at: 1 s, do: order, order: control 33 6 0}]");
    const std::string plain = ", whose negotiation waits for no order, expected flying: {start: by_order}";
    ExpectOrderRefused("net.yaml", "negotiate", "at manager 127" + plain);
    ExpectOrderRefused("fly.yaml", "negotiate", "at manager 9" + plain);
    ExpectTaken("held.yaml", "events: [{at: 1 s, do: order, order: negotiate}]");
}

TEST_F(VainNetworkTest, AnOrderIsForANodeOfTheNetwork)
{
    Verifies(req::SRS_MGR_587);
    const std::string nobody = "for node 34, which is no slave of manager 127, expected one of its network file";
    for (const std::string order :
         {"start 34", "stop 34", "preop 34", "reset 34", "reset-comm 34", "boot 34", "write-safety 34"})
    {
        ExpectOrderRefused("net.yaml", order, nobody);
    }
    ExpectOrderRefused("el.yaml", "control 34 5 1", nobody);
    ExpectOrderRefused("el.yaml", "output 34 1 01", nobody);
    ExpectOrderRefused("net.yaml", "boot 127",
                       "for node 127, which is no slave of manager 127, expected one of its network "
                       "file");
    ExpectOrderRefused("net.yaml", "write-safety 5",
                       "for node 5, which has no safety configuration, expected a safety slave");
    for (const std::string order : {"start 33", "start all", "preop 127", "boot 5", "write-safety 33"})
    {
        ExpectTaken("net.yaml", "events: [{at: 1 s, do: order, order: " + order + "}]");
    }
}

TEST_F(VainNetworkTest, AnOrderIsForAnRxPdoOrAnObjectThatIsThere)
{
    Verifies(req::SRS_MGR_587);
    ExpectOrderRefused("el.yaml", "output 5 1 01",
                       "for RxPDO 1 of node 5, which it does not have, expected one that its DCF switches on and maps");
    static_cast<void>(File("io.yaml", "manager: {node: 127, profile: el6751, sync: 20 ms}\nslaves: [{node: 5, dcf: " +
                                          cia306::test::SourceFolder() +
                                          "/examples/networks/managed_faults/io.dcf}]\n"));
    ExpectOrderRefused("io.yaml", "output 5 1 01 02",
                       "for RxPDO 1 of node 5 with 2 bytes, expected 1 as its mapping has");
    ExpectTaken("io.yaml", "events: [{at: 1 s, do: order, order: output 5 1 01}]");
    ExpectOrderRefused("net.yaml", "set 0x9999:03 1",
                       "for 0x9999:03 of manager 127, expected a number that it has and that can be written");
    ExpectOrderRefused("net.yaml", "set 0x1000:00 1",
                       "for 0x1000:00 of manager 127, expected a number that it has and that can be written");
    ExpectTaken("net.yaml", "events: [{at: 1 s, do: order, order: 'set 0x1F82:21 4'}]");
    ExpectRefused("net.yaml", "events: [{at: 1 s, do: order, order: 'get 0x1F82:21'}]",
                  ":4:38: error: order 'get 0x1F82:21', which does nothing here");
}
} // namespace
} // namespace counterpoint::tools
