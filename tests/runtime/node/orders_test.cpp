// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/canopen/cia306/folder_of_files.hpp"
#include "tests/runtime/node/bench.hpp"
#include "tests/runtime/node/troubled_bus.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <initializer_list>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

// Orders of a person to a node, and what the node tells of what comes to it.
namespace counterpoint::tools::test
{
namespace
{
const std::string kPlainFile = std::string(COUNTERPOINT_SOURCE) + "/tests/runtime/data/plain.dcf";

class NodeOrdersTest : public cia306::test::FolderTest
{
  protected:
    static void ExpectTold(Bench& bench, const std::string& text)
    {
        const std::string told = bench.Told();
        EXPECT_NE(told.find(text), std::string::npos) << text << "\n" << told;
    }
};

TEST_F(NodeOrdersTest, AReadIsToldWithWhatTheServerAnswers)
{
    Verifies(req::SRS_NODE_012);
    Bench bench(kPlainFile);
    // Given a server without this node, then one that answers two bytes
    bench.Order("read 9 0x1000:00");
    bench.Order("read 6 0x2000:01");
    bench.Order("read 6 0x2000:02");
    bench.Cycle();
    bench.Receive(0x586U, {0x4BU, 0x00U, 0x20U, 0x01U, 0x34U, 0x12U, 0U, 0U});
    bench.Cycle();
    // And one whose answer of ten bytes comes in segments
    bench.Order("read 6 0x2001:00");
    bench.Cycle();
    bench.Receive(0x586U, {0x41U, 0x01U, 0x20U, 0x00U, 10U, 0U, 0U, 0U});
    bench.Cycle();
    bench.Receive(0x586U, {0x00U, 1U, 2U, 3U, 4U, 5U, 6U, 7U});
    bench.Cycle();
    bench.Receive(0x586U, {0x19U, 8U, 9U, 10U, 0U, 0U, 0U, 0U});
    bench.Cycle();
    ExpectTold(bench, "read: no SDO client of node 9, expected 0x1280 to 0x12FF with both COB-IDs valid and this "
                      "node-ID in sub-index 3");
    ExpectTold(bench, "read: a transfer with node 6 runs, expected its end");
    ExpectTold(bench, "read node 6 0x2000:01 = 4660, 2 bytes: 34 12");
    ExpectTold(bench, "read node 6 0x2001:00 = 10 bytes: 01 02 03 04 05 06 07 08 09 0A");
}

// Given a rule for 2000h:01, then an input of it, which would last for no cycle, is refused; one beside it is taken.
TEST_F(NodeOrdersTest, AnInputThatARuleComputesIsRefused)
{
    Verifies(req::SRS_NODE_710);
    Bench bench(std::string(COUNTERPOINT_SOURCE) + "/examples/emergency_stop/controller.dcf");
    runtime::LogicRule rule;
    rule.target = {0x2000U, 1U};
    rule.inputs = {{0x2200U, 1U}};
    ASSERT_EQ(bench.Device().App().AddRule(rule), runtime::RuleFinding::kNone);
    bench.Order("set 0x2000:01 7");
    ExpectTold(bench, "set: 0x2000:01 is what a rule of the script computes, expected an object that no rule sets");
    bench.Order("set 0x2000:02 9");
    EXPECT_NE(bench.Device().App().Values().find("0x2000:02=9"), std::string::npos) << bench.Device().App().Values();
}

TEST_F(NodeOrdersTest, AWriteIsToldWithItsEnd)
{
    Verifies(req::SRS_NODE_012);
    Bench bench(kPlainFile);
    bench.Order("write 9 0x2000:01 1 2");
    bench.Order("write 6 0x2000:01 513 2");
    bench.Cycle();
    bench.Receive(0x586U, {0x60U, 0x00U, 0x20U, 0x01U, 0U, 0U, 0U, 0U});
    bench.Cycle();
    // When the server refuses, or does not answer for a second
    bench.Order("write 6 0x2000:01 513 2");
    bench.Cycle();
    bench.Receive(0x586U, {0x80U, 0x00U, 0x20U, 0x01U, 0x02U, 0x00U, 0x01U, 0x06U});
    bench.Cycle();
    bench.Order("write 6 0x2000:02 1 1");
    for (int cycle = 0; cycle < 220; ++cycle)
    {
        bench.Cycle();
    }
    ExpectTold(bench, "write: no SDO client of node 9, expected ");
    ExpectTold(bench, "write node 6 0x2000:01: done");
    ExpectTold(bench, "write node 6 0x2000:01: 0601 0002h by the server");
    ExpectTold(bench, "write node 6 0x2000:02: 0504 0000h by this node");
}

TEST_F(NodeOrdersTest, TheTimeOfDayIsSentWhereTheFileSaysSo)
{
    Verifies(req::SRS_NODE_012);
    // Given a producer of TIME in PRE-OPERATIONAL
    Bench bench(kPlainFile);
    bench.Order("time");
    bench.Cycle();
    bench.Receive(0x100U, {0xDCU, 0x05U, 0U, 0U, 2U, 0U});
    bench.Receive(0x086U, {0x30U, 0x81U, 0x11U, 0U, 0U, 0U, 0U, 0xAAU});
    bench.Cycle();
    // When it is stopped, then it says that it sends none, once
    bench.Command(2U);
    bench.Order("time");
    const std::string refused = "time: not sent, expected 0x1012:00 with bit 30, and PRE-OPERATIONAL or OPERATIONAL";
    const std::string told = bench.Told();
    EXPECT_NE(told.find("time 1500 ms of day 2"), std::string::npos) << told;
    EXPECT_NE(told.find("emergency of node 6: 0x8130, register 0x11, 00 00 00 00 AA"), std::string::npos) << told;
    EXPECT_NE(told.find(refused), std::string::npos) << told;
    EXPECT_EQ(told.find(refused), told.rfind(refused)) << told;
    // A device without TIME never does
    Bench sensor(FileWith("sensor", {{"5F04", "0"}}));
    sensor.Order("time");
    ExpectTold(sensor, refused);
}

TEST_F(NodeOrdersTest, AnAcknowledgeOfWhatIsSentIsTold)
{
    Verifies(req::SRS_NODE_660);
    Bench sensor(FileWith("sensor", {{"5F04", "0"}}));
    sensor.Start();
    sensor.Order("ack 1");
    ExpectTold(sensor, "ack: SRDO 1 is sent, expected one that is received");
    // And one of what is received is not
    Bench actuator(FileWith("actuator", {{"5F04", "0"}}));
    actuator.Start();
    actuator.Order("ack 1");
    EXPECT_EQ(actuator.Told().find("ack:"), std::string::npos);
}

TEST_F(NodeOrdersTest, HelpAndTheStateWithAnOpenOutputAreTold)
{
    Verifies(req::SRS_NODE_003);
    Bench bench(FileWith("actuator", {{"5F04", "0"}}));
    bench.Start();
    bench.Order("gfc");
    for (int cycle = 0; cycle < 6; ++cycle)
    {
        bench.Receive(0x103U, {1U, 2U});
        bench.Receive(0x104U, {0xFEU, 0xFDU});
        bench.Cycle();
        EXPECT_TRUE(cycle != 2 || bench.Device().Acknowledge(1U, bench.NowNs()));
    }
    bench.Order("state");
    bench.Order("help");
    bench.Order("nmt start 7");
    bench.Command(128U);
    bench.Order("gfc");
    ExpectTold(bench, "; SRDO 1 released, output open; 0x2200:01=1 0x2200:02=2");
    ExpectTold(bench, "  gfc                  send the global fail-safe command\n");
    ExpectTold(bench, "gfc: refused, expected OPERATIONAL, a valid configuration and 1300h = 1");
}

TEST_F(NodeOrdersTest, ACommandThatTheBusDoesNotTakeIsTold)
{
    Verifies(req::SRS_NODE_003);
    std::ostringstream out;
    runtime::NodeReport report(out, runtime::ReportForm::kText, 0U);
    auto services = std::make_unique<TroubledBus>();
    TroubledBus& bus = *services;
    runtime::NodePorts ports(std::make_unique<TroubledBus>(), std::move(services));
    runtime::NodeSettings settings;
    settings.dcf = kPlainFile;
    settings.cycle_us = 5000U;
    settings.has_self_tests = false;
    runtime::NodeDevice device(settings, ports, report);
    ASSERT_TRUE(device.PowerOn({Instant{0U}, Instant{0U}}, 1000000U));
    runtime::NodeOrders orders(ports, report);
    bus.sent.clear();
    EXPECT_TRUE(orders.Carry(runtime::ParseOrder("nmt start 7"), device, {{Instant{0U}, Instant{0U}}, 1000000U}));
    ASSERT_EQ(bus.sent.size(), 1U);
    EXPECT_EQ(bus.sent[0].identifier, 0U);
    EXPECT_EQ(bus.sent[0].data[0], 1U);
    EXPECT_EQ(bus.sent[0].data[1], 7U);
    bus.answer = host::SendResult::kQueueFull;
    EXPECT_TRUE(orders.Carry(runtime::ParseOrder("nmt start 7"), device, {{Instant{0U}, Instant{0U}}, 1000000U}));
    static_cast<void>(report.Finish());
    EXPECT_NE(out.str().find("nmt: the bus takes no frame now"), std::string::npos) << out.str();
}

TEST_F(NodeOrdersTest, NumbersOfEightBytesAndOfNoServiceAreSetAndTold)
{
    Verifies(req::SRS_NODE_054);
    using cia306::test::VariableText;
    Bench bench(File("a.dcf", "[DeviceInfo]\nVendorName=t\n[DeviceComissioning]\nNodeID=5\n" +
                                  VariableText("2000", "0x1B", "0") + VariableText("2001", "2", "0") +
                                  VariableText("2002", "1", "0")));
    bench.Order("set 0x2000:00 18446744073709551615");
    bench.Order("set 0x2001:00 -3");
    bench.Order("set 0x2002:00 1");
    bench.Order("get 0x2000:00");
    bench.Order("get 0x2001:00");
    bench.Order("get 0x2002:00");
    ExpectTold(bench, "0x2000:00 = 18446744073709551615\n");
    ExpectTold(bench, "0x2001:00 = -3\n");
    ExpectTold(bench, "0x2002:00 = 1\n");
}

TEST_F(NodeOrdersTest, AnObjectIsToldByItsDataType)
{
    Verifies(req::SRS_NODE_552);
    using cia306::test::VariableText;
    const std::string bytes_of_300 = "0" + std::string(599U, '1');
    const std::string text = "[DeviceInfo]\nVendorName=t\n[DeviceComissioning]\nNodeID=5\n" +
                             VariableText("2000", "0x8", "1.5") + VariableText("2001", "0x11", "-0.1") +
                             VariableText("2002", "0x9", "winch one") + VariableText("2003", "0xA", "DE AD BE EF") +
                             VariableText("2004", "0xA", "010203040506070809") + VariableText("2005", "0xA", "") +
                             VariableText("2006", "0xB",
                                          "\xC3\xBC\xE2\x82\xAC\xF0\x9D\x84\x9E"
                                          "A") +
                             VariableText("2007", "0xA", bytes_of_300) +
                             VariableText("2008", "0x9", std::string(257U, 'x')) + VariableText("2009", "0x8", "0") +
                             VariableText("200A", "0xF", "0102");
    Bench bench(File("a.dcf", text));
    bench.Order("set 0x2009:00 0x7F800000");
    for (const char* const object :
         {"2000", "2001", "2002", "2003", "2004", "2005", "2006", "2007", "2008", "2009", "200A", "3333"})
    {
        bench.Order(std::string("get 0x") + object + ":00");
    }
    ExpectTold(bench, "0x2000:00 = 1.5\n");
    ExpectTold(bench, "0x2001:00 = -0.1\n");
    ExpectTold(bench, "0x2002:00 = 'winch one'\n");
    ExpectTold(bench, "0x2003:00 = 4 bytes: DE AD BE EF\n");
    ExpectTold(bench, "0x2004:00 = 9 bytes: 01 02 03 04 05 06 07 08 09\n");
    ExpectTold(bench, "0x2005:00 = 0 bytes\n");
    ExpectTold(bench, "0x2006:00 = '\xC3\xBC\xE2\x82\xAC\xF0\x9D\x84\x9E"
                      "A'\n");
    ExpectTold(bench, "0x2007:00 = 300 bytes: 01 11 ");
    ExpectTold(bench, " 11 11 and more\n");
    ExpectTold(bench, "0x2008:00 = '" + std::string(256U, 'x') + "' and more, 257 bytes\n");
    ExpectTold(bench, "0x2009:00 = inf\n");
    ExpectTold(bench, "0x200A:00 = 4 bytes: 30 31 30 32\n");
    ExpectTold(bench, "get: 0x3333:00: 0602 0000h");
}

TEST_F(NodeOrdersTest, AnApplicationThatSendsDoesSoInOperationalAlone)
{
    Verifies(req::SRS_NODE_025);
    Bench bench(FileWith("sensor", {{"5F03sub1", "0"}, {"5F04", "0"}}));
    bench.Start();
    bench.Order("set 0x2000:01 5");
    bench.Cycle();
    bench.Cycle();
    const std::size_t sent = bench.SentWith(0x101U).size();
    EXPECT_GE(sent, 1U);
    bench.Command(128U);
    for (int cycle = 0; cycle < 20; ++cycle)
    {
        bench.Cycle();
    }
    EXPECT_LE(bench.SentWith(0x101U).size(), sent + 1U);
}

TEST_F(NodeOrdersTest, AFileWithTwoControllersWantsTwoOfTheHost)
{
    Verifies(req::SRS_NODE_014);
    EXPECT_THROW(Bench(FileWith("sensor", {{"5F00sub10", "2"}, {"5F04", "0"}})), cia306::InputError);
}

TEST_F(NodeOrdersTest, AStoreThatCannotBeOneIsRefusedWithItsName)
{
    Verifies(req::SRS_NODE_009);
    try
    {
        const Bench bench(kPlainFile, ::testing::TempDir());
        ADD_FAILURE() << "expected a refusal";
    }
    catch (const cia306::InputError& error)
    {
        const std::string text = error.what();
        EXPECT_EQ(text.find(::testing::TempDir() + ": error: the store "), 0U) << text;
        EXPECT_NE(text.find(", expected "), std::string::npos) << text;
    }
}

// Given an RPDO that was saved with an identifier which a new file gives to emergencies, then the device does without
// it.
TEST_F(NodeOrdersTest, ASavedValueThatDoesNotGoWithTheOthersIsTold)
{
    Verifies(req::SRS_NODE_030);
    using cia306::test::VariableText;
    const auto list = [](const std::string& index) { return "[" + index + "]\nParameterName=x\nObjectType=9\n"; };
    const std::string objects =
        "[DeviceInfo]\nVendorName=t\n[DeviceComissioning]\nNodeID=5\n" + VariableText("1000", "7", "0") + list("1010") +
        VariableText("1010sub0", "5", "1") + VariableText("1010sub1", "7", "1") + list("1400") +
        VariableText("1400sub0", "5", "2") + VariableText("1400sub1", "7", "0x205") +
        VariableText("1400sub2", "5", "254") + list("1600") + VariableText("1600sub0", "5", "1") +
        VariableText("1600sub1", "7", "0x20000008") +
        "[2000]\nParameterName=x\nObjectType=7\nDataType=5\nAccessType=rw\nDefaultValue=1\nPDOMapping=1\n";
    const std::string store = Path("node.store");
    {
        Bench bench(File("a.dcf", objects), store);
        EXPECT_EQ(bench.Download(0x1400U, 1U, 0x80000205U, 4U), 0U);
        EXPECT_EQ(bench.Download(0x1400U, 1U, 0x300U, 4U), 0U);
        bench.Store(0x1010U, 0x65766173U);
    }
    {
        Bench same(File("a.dcf", objects), store);
        const std::string told = same.Told();
        EXPECT_EQ(told.find("saved value"), std::string::npos) << told;
    }
    Bench bench(File("b.dcf", objects + "[1014]\nParameterName=x\nObjectType=7\nDataType=7\nAccessType=const\n"
                                        "DefaultValue=0x300\n"),
                store);
    ExpectTold(bench, store + ": warning: 0x1400:01: the device does without the saved value, expected one that goes "
                              "with the others");
}

// What the kernel tells its application is a line; what it counts of its flow is none.
TEST_F(NodeOrdersTest, WhatTheKernelTellsIsALine)
{
    Verifies(req::SRS_NODE_004);
    std::ostringstream out;
    runtime::NodeReport report(out, runtime::ReportForm::kText, 0U);
    const std::string name = cia306::test::SourceFolder() + "/examples/emergency_stop/controller.dcf";
    const cia306::Device file = cia306::ReadDeviceFile(name);
    const runtime::DeviceModel model(name, std::nullopt);
    runtime::NodeApplication application(model, file, report);
    application.OnSrdoEvent(CommunicationIndex{0x1301U});
    application.OnFlow({});
    static_cast<void>(report.Finish());
    EXPECT_EQ(out.str(), "");
    runtime::NodeReport next(out, runtime::ReportForm::kText, 0U);
    runtime::NodeApplication other(model, file, next);
    other.OnGfc();
    other.OnGfcNotFollowed();
    other.OnConfigurationInvalid(CommunicationIndex{0x1302U});
    other.OnSrdoError(CommunicationIndex{0x1302U}, SrdoCause::kSct);
    other.OnDeviceFault({DeviceFault::kApplication, 0U, 1U});
    EXPECT_TRUE(other.TakeInvalid());
    EXPECT_FALSE(other.TakeInvalid());
    static_cast<void>(next.Finish());
    EXPECT_EQ(out.str(), "  0.000000 s  global fail-safe command received\n"
                         "  0.000000 s  no SRDO followed the own global fail-safe command\n"
                         "  0.000000 s  configuration of SRDO 2 does not hold: SRDOs are off\n"
                         "  0.000000 s  SRDO 2: sct\n"
                         "  0.000000 s  device safe state: application\n");
    // And it follows rules
    runtime::LogicRule rule;
    rule.target = {0x2000U, 1U};
    rule.operation = runtime::LogicOperation::kCopy;
    rule.inputs = {{0x2200U, 1U}};
    EXPECT_EQ(other.AddRule(rule), runtime::RuleFinding::kNone);
}

// A pair without a stamp opens the output, and takes no time that anybody could tell.
TEST_F(NodeOrdersTest, FramesWithoutAStampHaveNoLatency)
{
    Verifies(req::SRS_NODE_008);
    Bench bench(FileWith("actuator", {{"5F04", "0"}}));
    bench.Start();
    for (int cycle = 0; cycle < 6; ++cycle)
    {
        const Instant now{static_cast<std::uint32_t>(bench.NowNs() / 1000U)};
        bench.Device().OnFrame(FrameOf(0x103U, {1U, 2U}, 0U), CanPortId::kFirst, {now, now});
        bench.Device().OnFrame(FrameOf(0x104U, {0xFEU, 0xFDU}, 0U), CanPortId::kFirst, {now, now});
        bench.Cycle();
        EXPECT_TRUE(cycle != 2 || bench.Device().Acknowledge(1U, bench.NowNs()));
    }
    EXPECT_EQ(bench.Device().Outputs().Open(), 1U);
    EXPECT_EQ(bench.Device().Outputs().Latency().Count(), 0U);
}
} // namespace
} // namespace counterpoint::tools::test
