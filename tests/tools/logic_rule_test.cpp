// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/tools/command_run.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::tools
{
namespace
{

/// A device that sends 16 and 8 bits (2000h:01, 2001h:01) and receives as much (2200h:01, 2201h:01).
class LogicRuleTest : public test::CommandTest
{
  protected:
    LogicRuleTest() : device_(Path("device.dcf"))
    {
        const test::Answer made =
            test::RunCommand({"new", "--node-id", "33", "--produce", "16@0x121", "--produce", "8@0x123", "--consume",
                              "16@0x109", "--consume", "8@0x10B", "-o", device_});
        EXPECT_EQ(made.status, 0) << made.err;
    }
    /// What `node` says to a script of this rule.
    [[nodiscard]] test::Answer Node(const std::string& rule) const
    {
        const std::string script = File("node.yaml", "logic:\n  - {" + rule + "}\n");
        return test::RunCommand(
            {"node", "--no-input", "--can", "udp:239.74.163.2:43118", "--dcf", device_, "--script", script});
    }
    /// What `simulate` says to a scenario of this rule.
    [[nodiscard]] test::Answer Simulate(const std::string& rule) const
    {
        const std::string scenario = File("rule.yaml", "title: A rule\nbitrate: 500000\nduration: 10 ms\nnodes:\n"
                                                       "  device: {dcf: device.dcf}\nlogic:\n  - {node: device, " +
                                                           rule + "}\n");
        return test::RunCommand({"simulate", scenario});
    }

    std::string device_;
};

TEST_F(LogicRuleTest, AnInputOfAnotherLengthThanItsTargetIsRefused)
{
    Verifies(req::SRS_NODE_160);
    // Shorter and longer ones, alone and behind one that fits
    const std::string shorter = "set: 0x2000:01, op: copy, from: [0x2201:01]";
    const std::string longer = "set: 0x2001:01, op: not, from: [0x2200:01]";
    const std::string second = "set: 0x2001:01, op: and, from: [0x2201:01, 0x2200:01]";
    for (const std::string& rule : {shorter, longer, second})
    {
        const test::Answer node = Node(rule);
        EXPECT_EQ(node.status, 2);
        EXPECT_EQ(node.out, "");
        EXPECT_EQ(node.err, Path("node.yaml") + ":2:5: error: a rule with objects of different lengths, expected each "
                                                "object of 'from' as long as that of 'set'\n");
    }
    EXPECT_EQ(Simulate(shorter).err, Path("rule.yaml") + ":7:5: error: object 0x2201:01 of 8 bits, expected one of 16 "
                                                         "bits, as 0x2000:01 has\n");
    EXPECT_EQ(Simulate(longer).err, Path("rule.yaml") + ":7:5: error: object 0x2200:01 of 16 bits, expected one of 8 "
                                                        "bits, as 0x2001:01 has\n");
    EXPECT_EQ(Simulate(second).err, Path("rule.yaml") + ":7:5: error: object 0x2200:01 of 16 bits, expected one of 8 "
                                                        "bits, as 0x2001:01 has\n");
    EXPECT_EQ(Simulate(second).status, 2);
    // Equal lengths are taken
    EXPECT_EQ(Simulate("set: 0x2000:01, op: copy, from: [0x2200:01]").err, "");
    EXPECT_EQ(Simulate("set: 0x2001:01, op: or, from: [0x2201:01]").status, 0);
}

TEST_F(LogicRuleTest, WhatTheDeviceSendsIsNoInput)
{
    Verifies(req::SRS_NODE_710);
    const std::string sent = "set: 0x2000:01, op: copy, from: [0x2000:01]";
    EXPECT_EQ(Node(sent).status, 2);
    EXPECT_EQ(Node(sent).err, Path("node.yaml") + ":2:5: error: a rule with an object that is no pair of the device, "
                                                  "expected 'set' with a normal object that it sends, 'from' with "
                                                  "normal objects that it receives\n");
    EXPECT_EQ(Simulate(sent).status, 2);
}
} // namespace
} // namespace counterpoint::tools
