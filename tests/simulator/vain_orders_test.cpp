// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What a scenario asks of devices that do not do it, or have nothing of it.
#include "tests/canopen/cia306/check_text.hpp"
#include "tests/tools/command_run.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <string>

namespace counterpoint::tools
{
namespace
{

using test::Answer;
using test::RunCommand;

class VainOrdersTest : public test::CommandTest
{
  protected:
    /// The emergency-stop chain with more.
    [[nodiscard]] Answer Simulate(const std::string& more) const
    {
        const std::string chain = cia306::test::SourceFolder() + "/examples/emergency_stop/chain.yaml";
        return RunCommand({"simulate", File("more.yaml", "extends: " + chain + "\n" + more), "--quiet"});
    }
};

const std::string kReleased = "expect: [{that: released, node: actuator, srdo: 1, at: 280 ms}]\n";

// Given a sensor that follows no GFC (1300h is 0), and one that is not OPERATIONAL yet, then the scenario does not
// hold.
TEST_F(VainOrdersTest, AGfcThatTheDeviceRefusesDoesNotHold)
{
    Verifies(req::SRS_SIM_660);
    const std::string quiet =
        File("quiet.dcf", cia306::test::WithValues(cia306::test::ExampleText("sensor"),
                                                   {{"1300", "ParameterValue", "0"}, {"5F04", "ParameterValue", "0"}}));
    const Answer off =
        RunCommand({"simulate", "--quiet",
                    File("off.yaml", "title: Off\nbitrate: 500000\nduration: 400 ms\nnodes: {sensor: {dcf: " + quiet +
                                         "}}\ngfc: [{at: 300 ms, node: sensor}]\n" + "expect: [{that: no_fault}]\n")});
    EXPECT_EQ(off.status, 1) << off.out << off.err;
    EXPECT_NE(off.out.find("FAILED  GFC of sensor at 300 ms is sent: refused: 1300h is 0"), std::string::npos)
        << off.out;
    const Answer early = Simulate("nmt: [{at: 290 ms, node: sensor, command: enter_pre_operational}]\n"
                                  "gfc: [{at: 300 ms, node: sensor}]\n" +
                                  kReleased);
    EXPECT_EQ(early.status, 1) << early.out << early.err;
    EXPECT_NE(early.out.find("FAILED  GFC of sensor at 300 ms is sent: refused: not OPERATIONAL"), std::string::npos)
        << early.out;
    // And one that is sent fails nothing
    const Answer sent = Simulate("gfc: [{at: 300 ms, node: sensor}]\n" + kReleased);
    EXPECT_EQ(sent.status, 0) << sent.out << sent.err;
    // Nor does one of a device in its safe state: that is what the scenario shows
    const Answer safe = Simulate("faults: [{fault: frozen, node: sensor, channel: a, at: 200 ms}]\n"
                                 "gfc: [{at: 400 ms, node: sensor}]\n" +
                                 kReleased);
    EXPECT_EQ(safe.out.find("GFC of"), std::string::npos) << safe.out;
}

// Given a device without SRDOs, then the time line says nothing of SRDOs and comparator.
TEST_F(VainOrdersTest, ADeviceWithoutSrdosHasNoLineOfThem)
{
    Verifies(req::SRS_SIM_661);
    const std::string plain = cia306::test::SourceFolder() + "/tests/runtime/data/plain.dcf";
    static_cast<void>(File("net.yaml", "manager: {node: 127}\nslaves: [{node: 5, dcf: " + plain + "}]\n"));
    const Answer answer = RunCommand(
        {"simulate", File("plain.yaml",
                          "title: Plain\nduration: 300 ms\nmanagers: [{network: net.yaml}]\nnodes: {5: {dcf: " + plain +
                              "}}\nexpect: [{that: device, node: 5, is: operational}]\n")});
    EXPECT_EQ(answer.status, 0) << answer.out << answer.err;
    EXPECT_EQ(answer.out.find("SRDO"), std::string::npos) << answer.out;
    EXPECT_EQ(answer.out.find("comparator"), std::string::npos) << answer.out;
    EXPECT_NE(answer.out.find("boot up"), std::string::npos) << answer.out << answer.err;
}

} // namespace
} // namespace counterpoint::tools
