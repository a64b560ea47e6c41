// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Services of the file in the devices of a network with managers.
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/tools/command_run.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::tools
{
namespace
{
using test::Answer;
using test::RunCommand;

class ManagedServicesTest : public test::CommandTest
{
  protected:
    /// The shipped managed network with other files for its controller 2 and its plain device 5, and more.
    [[nodiscard]] Answer Simulate(const std::string& controller, const std::string& plain,
                                  const std::string& more) const
    {
        const std::string folder = cia306::test::SourceFolder() + "/examples/";
        const std::string scenario =
            "title: x\nduration: 4 s\nmanagers: [{network: " + folder +
            "networks/managed_faults/network.yaml}]\nnodes:\n  sensor: {dcf: " + folder +
            "emergency_stop/sensor.dcf}\n  controller: {dcf: " + File("controller.dcf", controller) +
            "}\n  actuator: {dcf: " + folder +
            "emergency_stop/actuator.dcf}\n  plain: {dcf: " + File("plain.dcf", plain) + "}\n";
        return RunCommand({"simulate", "--frames", File("scenario.yaml", scenario + more)});
    }
    static std::string Plain()
    {
        return cia306::ReadTextFile(cia306::test::SourceFolder() + "/examples/networks/managed_faults/io.dcf");
    }
    static bool Has(const std::string& text, const std::string& part)
    {
        return text.find(part) != std::string::npos;
    }
};

TEST_F(ManagedServicesTest, ADeviceHearsAnotherOneAndAnswersAtItsSecondServer)
{
    Verifies(req::SRS_SIM_061);
    using cia306::test::VariableText;
    // Given a plain device that consumes TIME and emergencies of node 33, and has a second SDO server
    const std::string more =
        VariableText("1012", "0x0007", "0x80000100") + "[1028]\nParameterName=e\nObjectType=0x8\nSubNumber=2\n\n" +
        VariableText("1028sub0", "0x0005", "33") + VariableText("1028sub21", "0x0007", "0xA1") +
        "[1201]\nParameterName=s\nObjectType=0x9\nSubNumber=3\n\n" + VariableText("1201sub0", "0x0005", "2") +
        VariableText("1201sub1", "0x0007", "0x685") + VariableText("1201sub2", "0x0007", "0x6A5");
    // When the relay loses its controller, a time comes, and somebody reads 1000h at that server
    const Answer answer = Simulate(cia306::test::ExampleText("controller"), Plain() + "\n" + more,
                                   "events:\n"
                                   "  - {at: 3200 ms, do: send, identifier: 0x100, data: 40 E2 01 00 10 27}\n"
                                   "  - {at: 3300 ms, do: send, identifier: 0x685, data: 40 00 10 00 00 00 00 00}\n"
                                   "power: [{at: 3 s, node: controller, off: 500 ms}]\n");
    // Then the plain device hears of both and answers
    EXPECT_TRUE(Has(answer.out, "plain        hears emergency of node 33: 0x8250, register 0x11, 01 06 00 00 00"))
        << answer.out << answer.err;
    EXPECT_TRUE(Has(answer.out, "plain        hears time 123456 ms of day 10000")) << answer.out;
    EXPECT_TRUE(Has(answer.out, "frame 0x6A5 [8] 43 00 10 00 91 01 03 00  from plain")) << answer.out;
}

TEST_F(ManagedServicesTest, ADeviceWithAnotherNodeIdIsSilentUntilItsSupplyReturns)
{
    Verifies(req::SRS_SIM_062);
    const std::string with_lss =
        cia306::test::Changed(cia306::test::ExampleText("controller"), {{"LSS_Supported=0", "LSS_Supported=1"}});
    // Given a controller with LSS and an open output; when it gets node-ID 9 and its communication is reset, and later
    // its supply is off for a moment
    const Answer answer =
        Simulate(with_lss, Plain(),
                 "events:\n  - {at: 3 s, do: send, identifier: 0x7E5, data: 04 01 00 00 00 00 00 00}\n"
                 "  - {at: 3010 ms, do: send, identifier: 0x7E5, data: 11 09 00 00 00 00 00 00}\n"
                 "  - {at: 3020 ms, do: send, identifier: 0x7E5, data: 04 00 00 00 00 00 00 00}\n"
                 "nmt: [{at: 3100 ms, node: controller, command: reset_communication}]\n"
                 "power: [{at: 3600 ms, node: controller, off: 50 ms}]\n"
                 "expect:\n  - {that: device, node: controller, is: operational, at: 3090 ms}\n"
                 "  - {that: output, node: controller, srdo: 1, is: open, at: 3090 ms}\n"
                 "  - {that: device, node: controller, is: initialising, at: 3500 ms}\n"
                 "  - {that: output, node: controller, srdo: 1, is: closed, at: 3110 ms}\n"
                 "  - {that: event, is: heartbeat_lost, node: controller, from: 3100 ms, until: 3500 ms}\n"
                 "  - {that: event, is: boot_up, node: controller, from: 3650 ms, until: 3660 ms}\n");
    // Then it is silent until it begins with the node-ID of its file again
    EXPECT_EQ(answer.status, 0) << answer.out << answer.err;
    EXPECT_TRUE(Has(answer.out, "frame 0x7E4 [8] 11 00 00 00 00 00 00 00  from controller")) << answer.out;
    EXPECT_TRUE(Has(answer.out, "controller   SILENT: LSS gave node-ID 9")) << answer.out;
    EXPECT_FALSE(Has(answer.out, "frame 0x709 ")) << answer.out;
}
} // namespace
} // namespace counterpoint::tools
