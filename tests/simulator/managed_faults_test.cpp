// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Faults in the devices of a network with managers, and the options of simulate there.
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/tools/command_run.hpp"
#include "verification/trace/ids/crosslink.hpp"
#include "verification/trace/ids/hal.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/ids/store.hpp"
#include "verification/trace/verifies.hpp"

#include <nlohmann/json.hpp>

namespace counterpoint::tools
{
namespace
{

using test::Answer;
using test::RunCommand;

bool Has(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

class ManagedFaultsTest : public test::CommandTest
{
  protected:
    static std::string Shipped(const std::string& name)
    {
        return cia306::test::SourceFolder() + "/examples/networks/managed_faults/" + name;
    }
    static std::string Family(const std::string& name)
    {
        return cia306::test::SourceFolder() + "/tests/simulator/scenarios/managed_faults/" + name + ".yaml";
    }
    /// The shipped network with more, beside it by its whole path.
    [[nodiscard]] Answer Simulate(const std::string& more, const std::vector<std::string>& options = {}) const
    {
        std::vector<std::string> arguments{"simulate",
                                           File("more.yaml", "extends: " + Shipped("base.yaml") + "\n" + more)};
        arguments.insert(arguments.end(), options.begin(), options.end());
        return RunCommand(arguments);
    }
};

class ShippedFault : public ManagedFaultsTest, public ::testing::WithParamInterface<const char*>
{
};

TEST_P(ShippedFault, IsFoundInTimeAndToldToTheManager)
{
    Verifies(req::SRS_SIM_060);
    Verifies(req::SRS_MGR_012);
    // Given a scenario of one family of faults; when it runs, then what it expects of output and manager comes
    const Answer answer =
        RunCommand({"simulate", "--quiet", cia306::test::SourceFolder() + "/" + GetParam() + ".yaml"});
    EXPECT_EQ(answer.status, 0) << answer.out << answer.err;
}

INSTANTIATE_TEST_SUITE_P(Families, ShippedFault,
                         ::testing::Values("examples/networks/managed_faults/base",
                                           "examples/networks/managed_faults/channel",
                                           "tests/simulator/scenarios/managed_faults/frames",
                                           "tests/simulator/scenarios/managed_faults/clock",
                                           "tests/simulator/scenarios/managed_faults/memory",
                                           "tests/simulator/scenarios/managed_faults/self_test",
                                           "tests/simulator/scenarios/managed_faults/permits"),
                         [](const ::testing::TestParamInfo<const char*>& family)
                         {
                             const std::string path(family.param);
                             return path.substr(path.rfind('/') + 1U);
                         });

TEST_F(ManagedFaultsTest, AWrongLimitFailsTheScenario)
{
    Verifies(req::SRS_SIM_060);
    // Given a fault of memory, which is found within 1008 ms, judged by the limit of a channel
    const std::string fault = "faults:\n  - {fault: bit_flip, name: flip, node: actuator, part: channel_a, at: 3 s,\n"
                              "     config: {srdo: 1, field: sct}, bit: 4}\nexpect:\n"
                              "  - {that: safe_within, node: actuator, srdo: 1, fault: flip, ";
    const Answer wrong = Simulate(fault + "limit: channel}\n", {"--quiet"});
    EXPECT_EQ(wrong.status, 1);
    EXPECT_TRUE(Has(wrong.out, "FAILED  actuator SRDO 1 safe within 8 ms")) << wrong.out << wrong.err;
    // And with its own one
    EXPECT_EQ(Simulate(fault + "limit: configuration}\n", {"--quiet"}).status, 0);
}

TEST_F(ManagedFaultsTest, InOperationalTheBusSavesAndRestoresNothing)
{
    Verifies(req::SRS_STO_008);
    // Given a device with 1010h and 1011h
    std::string text = cia306::ReadTextFile(Shipped("io.dcf"));
    for (const std::string section : {"[1010", "[1011"})
    {
        text += "\n" + section + "]\nObjectType=8\nSubNumber=2\n" + section +
                "sub0]\nDataType=5\nAccessType=const\nDefaultValue=1\n" + section +
                "sub1]\nDataType=7\nAccessType=rw\nDefaultValue=1\n";
    }
    const auto request = [](const char* const at, const std::string& bytes)
    { return std::string("  - {fault: insertion, at: ") + at + ", identifier: 0x606, data: [" + bytes + "]}\n"; };
    const std::string save = "0x23, 0x10, 0x10, 1, 0x73, 0x61, 0x76, 0x65";
    const std::string load = "0x23, 0x11, 0x10, 1, 0x6C, 0x6F, 0x61, 0x64";
    // When the bus writes and reads both while it is OPERATIONAL, and writes them while it is PRE-OPERATIONAL
    const Answer answer = Simulate("nodes: {store: {dcf: " + File("store.dcf", text) +
                                       ", node_id: 6}}\nnmt:\n  - {at: 2900 ms, node: store, command: start}\n"
                                       "  - {at: 3500 ms, node: store, command: enter_pre_operational}\nfaults:\n" +
                                       request("3 s", save) + request("3010 ms", load) +
                                       request("3020 ms", "0x40, 0x10, 0x10, 1, 0, 0, 0, 0") +
                                       request("3030 ms", "0x40, 0x11, 0x10, 1, 0, 0, 0, 0") + request("3600 ms", save),
                                   {"--quiet", "--candump", Path("bus.log")});
    EXPECT_EQ(answer.status, 0) << answer.out << answer.err;
    // Then each write is refused with 0800 0022h, both can be read, and behind it only the store is missing
    const std::string log = cia306::ReadTextFile(Path("bus.log"));
    std::string answers;
    for (std::size_t place = log.find(" 586#"); place != std::string::npos; place = log.find(" 586#", place + 1U))
    {
        answers += log.substr(place + 5U, 16U) + "\n";
    }
    EXPECT_EQ(answers, "8010100122000008\n8011100122000008\n4310100100000000\n4311100100000000\n"
                       "8010100120000008\n");
}

TEST_F(ManagedFaultsTest, WhatHappensToDevicesHappensBesideAManager)
{
    Verifies(req::SRS_SIM_060);
    // Given NMT, power, GFC, controllers and a processor that stands still
    const Answer answer =
        Simulate("nmt:\n  - {at: 3 s, node: plain, command: stop}\n"
                 "  - {at: 3100 ms, node: sensor, command: reset_node}\n"
                 "power: [{at: 3300 ms, node: controller, off: 50 ms}]\n"
                 "gfc: [{at: 3200 ms, node: sensor}]\n"
                 "faults:\n  - {fault: unplugged, node: plain, at: 3500 ms}\n"
                 "  - {fault: standstill, node: actuator, at: 3600 ms}\n"
                 "expect:\n  - {that: device, node: plain, is: stopped, at: 3050 ms}\n"
                 "  - {that: event, is: boot_up, node: sensor, from: 3100 ms, until: 3101 ms}\n"
                 "  - {that: device, node: controller, is: absent, at: 3320 ms}\n"
                 "  - {that: event, is: boot_up, node: controller, from: 3350 ms, until: 3351 ms}\n"
                 "  - {that: event, is: heartbeat_lost, node: actuator, from: 3600 ms, until: 3900 ms}\n"
                 "  - {that: output, node: actuator, srdo: 1, is: closed}\n");
    // Then the devices do so, and the manager hears of it; the base's own last look at two of them does not hold then
    EXPECT_TRUE(Has(answer.out, "holds   device of node plain is stopped")) << answer.out << answer.err;
    EXPECT_TRUE(Has(answer.out, "holds   event boot_up of node sensor")) << answer.out;
    EXPECT_TRUE(Has(answer.out, "holds   device of node controller is absent at 3320 ms")) << answer.out;
    EXPECT_TRUE(Has(answer.out, "holds   event boot_up of node controller")) << answer.out;
    EXPECT_TRUE(Has(answer.out, "holds   event heartbeat_lost of node actuator")) << answer.out;
    EXPECT_TRUE(Has(answer.out, "holds   output of node actuator SRDO 1 is closed")) << answer.out;
}

TEST_F(ManagedFaultsTest, ADeviceThatComesBackHasLostItsSupplyAndForgottenAll)
{
    Verifies(req::SRS_SIM_211);
    Verifies(req::SRS_SIM_212);
    // Given a relay whose output was open, that is told to stop, and of which somebody changes the safety configuration
    const std::string given = "events:\n  - {at: 2910 ms, do: order, order: preop 33}\n"
                              "  - {at: 2950 ms, do: store, node: actuator, object: 0x1301:02, value: 77}\n";
    const std::string before = "expect:\n  - {that: released, node: actuator, srdo: 1, at: 2900 ms}\n";
    for (const char* const events :
         {"  - {at: 3 s, do: pull, node: actuator}\n  - {at: 3100 ms, do: insert, node: actuator}\n",
          "  - {at: 3100 ms, do: reset, node: actuator}\n",
          "  - {at: 3100 ms, do: replace, node: actuator, serial: 33}\n"})
    {
        // When it comes back
        const Answer answer =
            Simulate(given + events + "  - {at: 3300 ms, do: order, order: start 33}\n" + before +
                         "  - {that: event, is: boot_up, node: actuator, from: 3100 ms, until: 3200 ms}\n"
                         "  - {that: safe, node: actuator, srdo: 1, at: 3101 ms}\n"
                         "  - {that: gate, node: 33, is: open}\n"
                         "  - {that: device, node: actuator, is: operational, at: 3900 ms}\n"
                         "  - {that: safe, node: actuator, srdo: 1, at: 3990 ms}\n",
                     {"--quiet"});
        // Then it has the configuration of its file, and its output waits for somebody who acknowledges
        EXPECT_EQ(answer.status, 0) << events << answer.out << answer.err;
    }
    // And one that was never away has the other one
    const Answer kept = Simulate(given + "  - {at: 3100 ms, do: order, order: start 33}\n" + before +
                                     "  - {that: gate, node: 33, is: differs}\n",
                                 {"--quiet"});
    EXPECT_EQ(kept.status, 0) << kept.out << kept.err;
    const Answer pulled = Simulate("events:\n  - {at: 3 s, do: pull, node: actuator}\n"
                                   "expect:\n  - {that: device, node: actuator, is: absent}\n",
                                   {"--quiet"});
    EXPECT_EQ(pulled.status, 0) << pulled.out << pulled.err;
}

TEST_F(ManagedFaultsTest, AStoreThatTheDeviceRefusesIsToldAndDoesNotHold)
{
    Verifies(req::SRS_SIM_480);
    const std::string store = "{do: store, node: actuator, object: 0x1301:02, value: 77, at: ";
    const std::string expect = "expect: [{that: device, node: actuator, is: operational}]\n";
    // Given a relay that is OPERATIONAL, when somebody changes its safety configuration
    const Answer refused = Simulate("events: [" + store + "3 s}]\n" + expect);
    // Then it is told that the relay refuses that, and the scenario does not hold
    EXPECT_EQ(refused.status, 1) << refused.err;
    const std::string what = "0x1301:02 = 77: refused, 0800 0022h (not in the present state)";
    EXPECT_TRUE(Has(refused.out, "somebody stores " + what)) << refused.out;
    EXPECT_TRUE(Has(refused.out, "FAILED  store into actuator at 3000 ms is taken: " + what)) << refused.out;
    EXPECT_TRUE(Has(refused.out, "4 of 5 expectations hold")) << refused.out;
    // And one that is taken is told too
    const Answer taken = Simulate("events: [{do: order, order: preop 33, at: 2900 ms},\n  " + store + "3 s}]\n" +
                                  "expect: [{that: device, node: actuator, is: pre-operational}]\n");
    EXPECT_EQ(taken.status, 0) << taken.out << taken.err;
    EXPECT_TRUE(Has(taken.out, "somebody stores 0x1301:02 = 77\n")) << taken.out;
    EXPECT_TRUE(Has(taken.out, "4 of 4 expectations hold")) << taken.out;
    // And so is the one that a device cannot take that stands still
    const Answer still =
        Simulate("faults: [{fault: standstill, node: actuator, at: 2 s}]\nevents: [" + store + "3 s}]\n");
    EXPECT_EQ(still.status, 1) << still.err;
    EXPECT_TRUE(Has(still.out, "is taken: 0x1301:02 = 77: refused, 0800 0000h")) << still.out;
}

TEST_F(ManagedFaultsTest, ADeviceOfTwoCpusIsManaged)
{
    Verifies(req::SRS_SIM_210);
    Verifies(req::SRS_LNK_011);
    const std::string folder = cia306::test::SourceFolder() + "/examples/";
    const std::string nodes = "title: x\nduration: 3 s\nmanagers: [{network: " + Shipped("network.yaml") +
                              "}]\nnodes:\n  1: {dcf: " + folder + "emergency_stop/sensor.dcf}\n  2: {dcf: " + folder +
                              "emergency_stop/controller.dcf}\n  5: {dcf: " + folder +
                              "networks/managed_faults/io.dcf}\n" + "  relay: {dcf: " + folder +
                              "emergency_stop/actuator.dcf, structure: two_cpu}\n";
    // Given a relay of two CPUs, when the manager starts it and its supply goes later
    const std::string good =
        File("two.yaml", nodes + "events: [{at: 2 s, do: pull, node: relay}]\nexpect:\n"
                                 "  - {that: device, node: relay, is: operational, at: 1900 ms}\n"
                                 "  - {that: gate, node: 33, is: open, at: 1900 ms}\n"
                                 "  - {that: released, node: 2, srdo: 1, at: 100 ms}\n"
                                 "  - {that: event, is: heartbeat_lost, node: 33, from: 2 s, until: 2300 ms}\n"
                                 "  - {that: device, node: relay, is: absent}\n");
    const Answer answer = RunCommand({"simulate", "--quiet", good});
    EXPECT_EQ(answer.status, 0) << answer.out << answer.err;
    // Then boot-up, heartbeat and answers to SDOs are from the first CPU, and none is from the second one
    const std::string frames = RunCommand({"simulate", "--frames", good}).out;
    EXPECT_TRUE(Has(frames, "frame 0x721 [1] 00  from relay.a")) << frames;
    EXPECT_TRUE(Has(frames, "frame 0x721 [1] 05  from relay.a")) << frames;
    EXPECT_TRUE(Has(frames, "frame 0x5A1 [8] 43 18 10 04 21 00 00 00  from relay.a")) << frames;
    EXPECT_FALSE(Has(frames, "from relay.b")) << frames;
    // And it is reset at any moment of the cycles of its CPUs
    for (const char* const at : {"2000000", "2000250", "2000500", "2000750"})
    {
        const Answer reset = RunCommand(
            {"simulate", "--quiet",
             File("reset.yaml", nodes + "events: [{at: " + at + " us, do: order, order: reset 33}]\nexpect:\n" +
                                    "  - {that: device_fault, node: relay, is: none}\n" +
                                    "  - {that: device, node: relay, is: operational}\n")});
        EXPECT_EQ(reset.status, 0) << at << reset.out << reset.err;
    }
    // A second one of it would need a link of its own
    const std::string bad = File("bad.yaml", nodes + "events: [{at: 2 s, do: duplicate, node: relay}]\n");
    const Answer refused = RunCommand({"simulate", "--quiet", bad});
    EXPECT_EQ(refused.status, 2);
    EXPECT_TRUE(
        Has(refused.err, "bad.yaml:9:10: error: a duplicate of a device with two CPUs, expected a device with one"))
        << refused.err;
}

TEST_F(ManagedFaultsTest, ManagerAndDeviceAreToldThatTheBusIsOff)
{
    Verifies(req::SRS_MGR_012);
    // Given a controller of a device that errors on the wire put off the bus, and comes back
    const Answer answer =
        Simulate("faults: [{fault: bus_off, node: plain, at: 3 s, until: 3050 ms}]\n"
                 "expect: [{that: event, is: emergency, node: plain, from: 3050 ms, until: 3100 ms},\n"
                 "  {that: device, node: plain, is: pre-operational}]\n");
    // Then it has left OPERATIONAL, and says so as soon as it can
    EXPECT_TRUE(Has(answer.out, "holds   event emergency of node plain")) << answer.out << answer.err;
    EXPECT_TRUE(Has(answer.out, "holds   device of node plain is pre-operational")) << answer.out;
}

TEST_F(ManagedFaultsTest, HeartbeatsThatWaitedMakeNoSecondDevice)
{
    Verifies(req::SRS_DEV_024);
    Verifies(req::SRS_BUS_017);
    // Given a device that could send nothing for a second
    for (const char* const fault :
         {"unplugged, node: actuator", "bus_off, node: actuator", "babbling, identifier: 0x001"})
    {
        const Answer answer =
            Simulate("duration: 6 s\nprofiles: [plc_designer]\nfaults: [{fault: " + std::string(fault) +
                         ", at: 3 s, until: 4500 ms}]\n"
                         "expect: [{that: no_event, is: duplicate}]\n",
                     {"--quiet"});
        // Then the manager that counts signs of life does not take it for two
        EXPECT_TRUE(!Has(answer.out, "FAILED  no event duplicate") && answer.status != 2)
            << fault << answer.out << answer.err;
    }
}

TEST_F(ManagedFaultsTest, WhatIsOrderedIsNoDetection)
{
    Verifies(req::SRS_SIM_067);
    const std::string expect = "expect: [{that: safe_within, fault: x, node: actuator, srdo: 1},\n"
                               "  {that: detected_by, fault: x, node: actuator, by: nobody}]\n";
    // Given a frame that nobody misses, and a manager that stops the device while the limit runs
    const std::string lost = "faults: [{fault: insertion, name: x, receiver: plain, identifier: 0x7F0, at: 3 s}]\n";
    const Answer stopped = Simulate(lost + "events: [{at: 3001 ms, do: order, order: stop 33}]\n" + expect);
    // Then neither the closed output nor its cause is the fault's
    EXPECT_TRUE(Has(stopped.out, "FAILED  actuator SRDO 1 safe within")) << stopped.out << stopped.err;
    EXPECT_TRUE(Has(stopped.out, ": closed by a command or without supply at 300")) << stopped.out;
    EXPECT_TRUE(Has(stopped.out, "holds   detected at actuator by nobody")) << stopped.out;
    // Nor when it is reset, pulled or switched off
    for (const char* const other :
         {"nmt: [{at: 3001 ms, node: actuator, command: reset_node}]\n",
          "events: [{at: 3001 ms, do: pull, node: actuator}]\n", "power: [{at: 3001 ms, node: actuator, off: 1 s}]\n"})
    {
        const Answer answer = Simulate(lost + other + expect);
        EXPECT_TRUE(Has(answer.out, ": closed by a command or without supply at 3001")) << answer.out << answer.err;
        EXPECT_TRUE(Has(answer.out, "holds   detected at actuator by nobody")) << answer.out;
    }
    // But what the device notices itself is, even if a command follows
    const Answer found = Simulate("faults: [{fault: not_called, name: x, node: actuator, part: channel_a, at: 3 s}]\n"
                                  "events: [{at: 3500 ms, do: order, order: stop 33}]\n"
                                  "expect: [{that: safe_within, fault: x, node: actuator, srdo: 1}]\n");
    EXPECT_TRUE(Has(found.out, "holds   actuator SRDO 1 safe within")) << found.out << found.err;
}

TEST_F(ManagedFaultsTest, OutputOfADeviceThatIsNotThereIsClosed)
{
    Verifies(req::SRS_MGR_155);
    const Answer answer = Simulate("events: [{at: 3 s, do: pull, node: actuator}]\n"
                                   "expect: [{that: output, node: actuator, is: closed}]\n");
    EXPECT_TRUE(Has(answer.out, "holds   output of node actuator SRDO 1 is closed")) << answer.out << answer.err;
}

TEST_F(ManagedFaultsTest, SupplyEventsOfADeviceAreApart)
{
    Verifies(req::SRS_SIM_065);
    const std::string power = "power: [{at: 3 s, node: actuator, off: 500 ms}]\n";
    for (const char* const action : {"pull", "insert", "reset", "replace, serial: 1", "duplicate", "acknowledge",
                                     "store, object: 0x1017:00, value: 50"})
    {
        const std::string word = std::string(action).substr(0U, std::string(action).find(','));
        // Given something that happens to the device during its power cycle, then it is refused
        const std::string events = std::string("events: [{node: actuator, do: ") + action + ", at: ";
        const Answer refused = Simulate(power + events + "3200 ms}]\n");
        EXPECT_EQ(refused.status, 2) << refused.out;
        EXPECT_TRUE(Has(refused.err, "more.yaml:3:10: error: " + word +
                                         " of device actuator during its power cycle, expected a time from 3500 ms on"))
            << refused.err;
    }
    EXPECT_NE(Simulate(power + "events: [{at: 3500 ms, do: pull, node: actuator}]\n", {"--quiet"}).status, 2);
    // Nor does a power cycle take a supply that is not there
    for (const char* const other :
         {"power: [{at: 3100 ms, node: actuator, off: 1 s}]\nevents: [{at: 3 s, do: pull, "
          "node: actuator}]\n",
          "power: [{at: 3100 ms, node: actuator, off: 1 s},\n  {at: 3 s, node: actuator, off: "
          "500 ms}]\n"})
    {
        const Answer refused = Simulate(other);
        EXPECT_EQ(refused.status, 2) << refused.out;
        EXPECT_TRUE(
            Has(refused.err, "more.yaml:2:9: error: power cycle of device actuator, which has no supply, expected "))
            << refused.err;
    }
}

TEST_F(ManagedFaultsTest, NobodyUsesADeviceWithoutSupply)
{
    Verifies(req::SRS_SIM_066);
    const std::string power = "power: [{at: 3 s, node: actuator, off: 500 ms}]\n";
    const std::vector<std::pair<std::string, std::string>> uses{
        {"acknowledge: [{at: 3200 ms, node: actuator, srdo: 1, pulse: 50 ms}]\n", "3:15: error: acknowledge"},
        {"nmt: [{at: 3200 ms, node: actuator, command: start}]\n", "3:7: error: NMT event"},
        {"gfc: [{at: 3200 ms, node: actuator}]\n", "3:7: error: GFC"}};
    for (const auto& [use, what] : uses)
    {
        // Given somebody who uses the device while it is off, then that is refused
        const Answer refused = Simulate(power + use);
        EXPECT_EQ(refused.status, 2) << refused.out;
        EXPECT_TRUE(Has(refused.err, "more.yaml:" + what +
                                         " of device actuator at 3200 ms, which has no supply then, expected a time at "
                                         "which it has one"))
            << refused.err;
    }
    // But not of all devices, nor an acknowledge that is still pressed when the supply comes
    EXPECT_NE(Simulate(power + "nmt: [{at: 3200 ms, node: all, command: start}]\n", {"--quiet"}).status, 2);
    EXPECT_NE(
        Simulate(power + "acknowledge: [{at: 3450 ms, node: actuator, srdo: 1, pulse: 60 ms}]\n", {"--quiet"}).status,
        2);
    // And where the base has it, it is told
    const Answer told = Simulate("power: [{at: 2400 ms, node: actuator, off: 1 s}]\n", {"--quiet"});
    EXPECT_TRUE(Has(
        told.err, "base.yaml:22:5: warning: acknowledge of device actuator at 2500 ms does nothing, the device has no "
                  "supply then, expected a time at which it has one"))
        << told.err;
}

TEST_F(ManagedFaultsTest, EveryOptionWorks)
{
    Verifies(req::SRS_MGR_012);
    Verifies(req::SRS_SIM_040);
    const std::string memory = Family("memory");
    // Given one fault that comes by chance, the seed decides when
    const std::string chance =
        "faults: [{fault: loss, name: lost, frames: {srdo: {node: actuator, srdo: 1}, from: 2600 ms, "
        "probability_ppm: 100000}}]\n";
    const std::string first = Simulate(chance, {"--seed", "1"}).out;
    EXPECT_EQ(first, Simulate(chance, {"--seed", "1"}).out);
    EXPECT_NE(first, Simulate(chance, {"--seed", "5"}).out);
    // --until ends the run and tells what it cut off
    const std::string flip = "faults: [{fault: bit_flip, name: SCT of channel A wrong, node: actuator, part: "
                             "channel_a, at: 3 s, config: {srdo: 1, field: sct}, bit: 4}]\n";
    const Answer cut = Simulate(flip, {"--quiet", "--until", "2950ms"});
    EXPECT_EQ(cut.status, 1) << cut.out;
    EXPECT_TRUE(Has(cut.err, "'SCT of channel A wrong' at 3000 ms does not happen")) << cut.err;
    // Unless a window of events would begin behind that
    const Answer behind = RunCommand({"simulate", "--quiet", "--until", "2950ms", memory});
    EXPECT_EQ(behind.status, 2);
    EXPECT_TRUE(Has(behind.err, "a window from 3000 ms, not before the end of the run")) << behind.err;
    // --frames shows frames of devices and of the manager
    const Answer frames = RunCommand({"simulate", "--frames", "--until", "3 s", Shipped("base.yaml")});
    EXPECT_TRUE(Has(frames.out, "frame 0x705 [1] 00  from plain")) << frames.out;
    EXPECT_TRUE(Has(frames.out, "frame 0x77F [1] 00  from manager 127")) << frames.out;
    // --sweep measures each
    const Answer sweep = RunCommand({"simulate", "--sweep", "faults.SCT of channel A wrong.bit=2:4:2", memory});
    EXPECT_EQ(sweep.status, 0) << sweep.out << sweep.err;
    EXPECT_TRUE(Has(sweep.out, "2 of 2 runs hold")) << sweep.out;
    // One page with devices, outputs, fault and the table of the manager; the same as JSON and as a capture
    const Answer all = RunCommand({"simulate", "--quiet", "--html", Path("page.html"), "--json", Path("run.json"),
                                   "--candump", Path("run.log"), memory});
    EXPECT_EQ(all.status, 0) << all.err;
    const std::string page = cia306::ReadTextFile(Path("page.html"));
    EXPECT_TRUE(Has(page, "\"name\":\"actuator\"") && Has(page, "SCT of channel A wrong") && Has(page, "Relay"));
    const nlohmann::json json = nlohmann::json::parse(cia306::ReadTextFile(Path("run.json")));
    EXPECT_EQ(json["nodes"].size(), 4U);
    EXPECT_EQ(json["managers"][0]["node"], 127);
    EXPECT_EQ(json["faults"][0]["kind"], "bit_flip");
    EXPECT_TRUE(Has(cia306::ReadTextFile(Path("run.log")), "can0 000#0121"));
}

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
};

TEST_F(ManagedServicesTest, ADeviceHearsAnotherOneAndAnswersAtItsSecondServer)
{
    Verifies(req::SRS_SIM_061);
    using cia306::test::VariableText;
    // Given a plain device that consumes TIME and emergencies of node 33, and has a second SDO server and an SDO client
    const std::string more =
        VariableText("1012", "0x0007", "0x80000100") + "[1028]\nParameterName=e\nObjectType=0x8\nSubNumber=2\n\n" +
        VariableText("1028sub0", "0x0005", "33") + VariableText("1028sub21", "0x0007", "0xA1") +
        "[1201]\nParameterName=s\nObjectType=0x9\nSubNumber=3\n\n" + VariableText("1201sub0", "0x0005", "2") +
        VariableText("1201sub1", "0x0007", "0x685") + VariableText("1201sub2", "0x0007", "0x6A5") +
        "[1280]\nParameterName=c\nObjectType=0x9\nSubNumber=4\n\n" + VariableText("1280sub0", "0x0005", "3") +
        VariableText("1280sub1", "0x0007", "0x606") + VariableText("1280sub2", "0x0007", "0x586") +
        VariableText("1280sub3", "0x0005", "6");
    // When the relay loses its controller, a time comes, and somebody reads 1000h at that server, and writes 1280h:01
    const Answer answer = Simulate(cia306::test::ExampleText("controller"), Plain() + "\n" + more,
                                   "events:\n"
                                   "  - {at: 3200 ms, do: send, identifier: 0x100, data: 40 E2 01 00 10 27}\n"
                                   "  - {at: 3300 ms, do: send, identifier: 0x685, data: 40 00 10 00 00 00 00 00}\n"
                                   "  - {at: 3400 ms, do: send, identifier: 0x685, data: 23 80 12 01 07 06 00 00}\n"
                                   "power: [{at: 3 s, node: controller, off: 500 ms}]\n");
    // Then the plain device hears of both and answers
    EXPECT_TRUE(Has(answer.out, "plain        hears emergency of node 33: 0x8250, register 0x11, 01 06 00 00 00"))
        << answer.out << answer.err;
    EXPECT_TRUE(Has(answer.out, "plain        hears time 123456 ms of day 10000")) << answer.out;
    EXPECT_TRUE(Has(answer.out, "frame 0x6A5 [8] 43 00 10 00 91 01 03 00  from plain")) << answer.out;
    // and its client, of which 1280h tells, takes no other COB-ID while its own are valid
    EXPECT_TRUE(Has(answer.out, "frame 0x6A5 [8] 80 80 12 01 30 00 09 06  from plain")) << answer.out;
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
