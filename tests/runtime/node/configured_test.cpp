// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/edit/srdo_edit.hpp"
#include "canopen/cia306/text/text_file.hpp"
#include "tests/runtime/node/bench.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

// Devices that their file leaves unconfigured, configured over SDO as SO-1059 1.2 tells, and then started.
namespace counterpoint::tools::test
{
namespace
{

/// An example of the emergency stop without the ParameterValues of these sections, and with other ones.
std::string FileWithout(const std::string& example, const std::set<std::string>& sections,
                        const std::map<std::string, std::string>& values = {})
{
    std::ifstream file(FileWith(example, values));
    std::string section;
    std::ostringstream text;
    for (std::string line; std::getline(file, line);)
    {
        section = (line.rfind('[', 0U) == 0U) ? line.substr(1U, line.find(']') - 1U) : section;
        const bool is_value = line.rfind("ParameterValue=", 0U) == 0U;
        text << ((is_value && sections.count(section) != 0U) ? "" : line + "\n");
    }
    const std::string name = ::testing::TempDir() + example + "_unconfigured.dcf";
    std::ofstream(name) << text.str();
    return name;
}

const std::set<std::string> kAllOfSrdo1{"1301sub1", "1301sub2", "1301sub3", "1301sub5", "1301sub6", "1381sub0",
                                        "1381sub1", "1381sub2", "1381sub3", "1381sub4", "13FE",     "13FFsub1"};

TEST(NodeConfiguredTest, AProducerThatWasConfiguredOverSdoSendsItsInputs)
{
    Verifies(req::SRS_NODE_019);
    Verifies(req::SRS_DEV_017);
    // Once called by the kernel as the file says, once sent by the application
    std::set<std::string> with_form = kAllOfSrdo1;
    with_form.insert("5F03sub1");
    for (const std::set<std::string>& sections : {kAllOfSrdo1, with_form})
    {
        Bench bench(FileWithout("sensor", sections));
        runtime::NodeDevice& device = bench.Device();
        EXPECT_FALSE(device.App().SetInput({0x2000U, 1U}, 1U));
        bench.Configure(1U, 25U, 0x101U, {0x20000108U, 0x21000108U, 0x20000208U, 0x21000208U}, 0xB631U);
        bench.Start();
        ASSERT_TRUE(device.App().SetInput({0x2000U, 1U}, 0x12U));
        ASSERT_TRUE(device.App().SetInput({0x2000U, 2U}, 0x34U));
        EXPECT_FALSE(device.App().SetInput({0x2000U, 2U}, 0x100U)); // Above its 8 bits.
        for (int cycle = 0; cycle < 41; ++cycle)                    // 205 ms
        {
            bench.Cycle();
        }
        // Then a pair is sent every 25 ms, and nothing is wrong at the end
        const std::vector<unsigned> normal = bench.SentWith(0x101U);
        EXPECT_GE(normal.size(), 8U);
        EXPECT_LE(normal.size(), 10U);
        ASSERT_FALSE(normal.empty());
        EXPECT_EQ(normal.back(), 0x3412U);
        ASSERT_FALSE(bench.SentWith(0x102U).empty());
        EXPECT_EQ(bench.SentWith(0x102U).back(), 0xCBEDU);
        EXPECT_EQ(device.Assembly().Core().DeviceState().fault, DeviceFault::kNone);
        const std::string told = bench.Told();
        EXPECT_NE(told.find("SRDO 1 producer 0x101, every 25 ms"), std::string::npos) << told;
    }
}

TEST(NodeConfiguredTest, AConsumerThatWasConfiguredOverSdoShowsItsOutputs)
{
    Verifies(req::SRS_NODE_019);
    Verifies(req::SRS_DEV_017);
    // Once with nothing of SRDO 1 in the file, once with a mapping whose direction is open
    for (const std::set<std::string>& sections : {kAllOfSrdo1, std::set<std::string>{"1301sub1", "13FE", "13FFsub1"}})
    {
        Bench bench(FileWithout("actuator", sections));
        runtime::NodeDevice& device = bench.Device();
        if (sections.size() == kAllOfSrdo1.size())
        {
            bench.Configure(2U, 50U, 0x103U, {0x22000108U, 0x23000108U, 0x22000208U, 0x23000208U}, 0x9FCBU);
        }
        else
        {
            EXPECT_EQ(bench.Download(0x1301U, 1U, 2U, 1U), 0U);
            EXPECT_EQ(bench.Download(0x13FFU, 1U, 0x9FCBU, 2U), 0U);
            EXPECT_EQ(bench.Download(0x13FEU, 0U, 0xA5U, 1U), 0U);
        }
        bench.Start();
        for (int cycle = 0; cycle < 6; ++cycle)
        {
            bench.Receive(0x103U, {1U, 2U});
            bench.Receive(0x104U, {0xFEU, 0xFDU});
            bench.Cycle();
            EXPECT_TRUE(cycle != 2 || device.Acknowledge(1U, bench.NowNs()));
        }
        EXPECT_EQ(device.Outputs().Open(), 1U);
        EXPECT_EQ(device.App().Values(), "0x2200:01=1 0x2200:02=2");
        EXPECT_FALSE(device.App().SetInput({0x2200U, 1U}, 1U));
        const std::string told = bench.Told();
        EXPECT_NE(told.find("value 0x2200:02 = 2"), std::string::npos) << told;
        EXPECT_NE(told.find("SRDO 1 consumer 0x103, safe within 81.5 ms of the last good normal frame"),
                  std::string::npos)
            << told;
    }
}

// SCT 50 ms: without a pair the consumer holds what 5F02h says, whether its mapping is of the file or not.
TEST(NodeConfiguredTest, AConsumerThatWasConfiguredOverSdoTakesItsSafeValues)
{
    Verifies(req::SRS_NODE_019);
    // Given safe values 3 and 4 in a file that has nothing else of SRDO 1
    const std::string file = FileWithout("actuator", kAllOfSrdo1, {{"5F02sub1", "0x0403"}, {"5F04", "0"}});
    Bench bench(file);
    runtime::NodeDevice& device = bench.Device();
    bench.Configure(2U, 50U, 0x103U, {0x22000108U, 0x23000108U, 0x22000208U, 0x23000208U}, 0x9FCBU);
    bench.Start();
    for (int cycle = 0; cycle < 6; ++cycle)
    {
        bench.Receive(0x103U, {1U, 2U});
        bench.Receive(0x104U, {0xFEU, 0xFDU});
        bench.Cycle();
        EXPECT_TRUE(cycle != 2 || device.Acknowledge(1U, bench.NowNs()));
    }
    EXPECT_EQ(device.App().Values(), "0x2200:01=1 0x2200:02=2");
    // When pairs stop, then 20 cycles of 5 ms later the objects hold the safe values
    for (int cycle = 0; cycle < 20; ++cycle)
    {
        bench.Cycle();
    }
    EXPECT_EQ(device.App().Values(), "0x2200:01=3 0x2200:02=4");
}

// A change is sent at once, with the new value, wherever in the refresh time it comes; the next pair is a refresh
// later.
TEST(NodeConfiguredTest, AnApplicationThatSendsSendsItsNewValue)
{
    Verifies(req::SRS_NODE_025);
    for (int place = 0; place < 6; ++place)
    {
        Bench bench(FileWith("sensor", {{"5F03sub1", "0x00"}, {"5F04", "0"}}));
        bench.Start();
        for (int cycle = 0; cycle < 20 + place; ++cycle)
        {
            bench.Cycle();
        }
        const std::size_t before = bench.SentWith(0x101U).size();
        ASSERT_TRUE(bench.Device().App().SetInput({0x2000U, 1U}, 1U));
        for (int cycle = 0; cycle < 4; ++cycle) // The confirmation of the normal frame comes with the next one.
        {
            bench.Cycle();
        }
        const std::vector<unsigned> normal = bench.SentWith(0x101U);
        ASSERT_GT(normal.size(), before) << place;
        EXPECT_EQ(normal[before], 1U) << place;
        EXPECT_EQ(bench.SentWith(0x102U).back(), 0xFFFEU) << place;
        // Then one every 5 cycles, counted from the change
        for (int cycle = 0; cycle < 25; ++cycle)
        {
            bench.Cycle();
        }
        EXPECT_EQ(bench.SentWith(0x101U).size(), normal.size() + 5U) << place;
        EXPECT_EQ(bench.SentWith(0x101U).back(), 1U) << place;
    }
}

// Refresh 25 ms, cycle 5 ms: wherever in the refresh time an input changes, the next pair has the new value.
TEST(NodeConfiguredTest, AProviderDeliversTheInputsAsTheyAre)
{
    Verifies(req::SRS_NODE_041);
    for (int place = 0; place < 6; ++place)
    {
        Bench bench(FileWith("sensor", {{"5F03sub1", "0x01"}, {"5F04", "0"}}));
        bench.Start();
        for (int cycle = 0; cycle < 20 + place; ++cycle)
        {
            bench.Cycle();
        }
        const std::size_t before = bench.SentWith(0x101U).size();
        ASSERT_TRUE(bench.Device().App().SetInput({0x2000U, 1U}, 1U));
        for (int cycle = 0; cycle < 8; ++cycle)
        {
            bench.Cycle();
        }
        const std::vector<unsigned> normal = bench.SentWith(0x101U);
        ASSERT_GT(normal.size(), before) << place;
        EXPECT_EQ(normal[before], 1U) << place;
    }
}

// Actuator: SCT 50 ms, SRVT 20 ms, output 1 ms; cycle 5 ms, 5 ms late; the clocks 0.5 ms apart in 100 ms. The normal
// frame that comes 50 ms after the last good one is waited for in early detection until SRVT is over.
TEST(NodeConfiguredTest, EachConsumerHasALimitOfItsOwn)
{
    Verifies(req::SRS_NODE_024);
    // Given a second consumer, of SCT 100 ms
    const std::string file = FileWith("actuator", {});
    cia306::SrdoPlan plan;
    plan.number = 2U;
    plan.sct_ms = 100U;
    plan.cob_id = 0x111U;
    plan.pairs = {cia306::PlannedPair{"", 0x0005U, std::nullopt, std::nullopt}};
    const cia306::IniDocument one = cia306::IniDocument::Parse(file, cia306::ReadTextFile(file));
    cia306::WriteTextFile(file, cia306::WithSrdo(one, plan, std::uint8_t{33U}).Text());
    Bench bench(file);
    const std::string told = bench.Told();
    EXPECT_NE(told.find("SRDO 1 consumer 0x103, safe within 81.5 ms of the last good normal frame"), std::string::npos)
        << told;
    EXPECT_NE(told.find("SRDO 2 consumer 0x111, safe within 132 ms of the last good normal frame"), std::string::npos)
        << told;
}

TEST(NodeConfiguredTest, TheLimitHoldsWhereTheNextNormalFrameStillCame)
{
    Verifies(req::SRS_NODE_024);
    struct Case
    {
        std::map<std::string, std::string> values;
        const char* told;
    };
    const std::vector<Case> cases{
        {{}, "SRDO 1 consumer 0x103, safe within 81.5 ms of the last good normal frame"},
        {{{"5F05sub1", "0x3C"}}, "SRDO 1 consumer 0x103, safe within 61.5 ms of the last good normal frame"},
        {{{"1301sub2", "65000"}, {"1301sub3", "250"}}, "safe within 65589 ms of the last good normal frame"},
        {{{"1301sub2", "65000"}, {"1301sub3", "250"}, {"5F00sub6", "99999"}}, ", without a limit"},
    };
    for (const Case& one : cases)
    {
        Bench bench(FileWith("actuator", one.values));
        const std::string told = bench.Told();
        EXPECT_NE(told.find(one.told), std::string::npos) << told;
    }
}

// The bench runs with 5 ms, the file with another cycle
TEST(NodeConfiguredTest, ADigestThatIsNotExpectedIsTold)
{
    Verifies(req::SRS_NODE_042);
    const std::string line = "no device digest is expected: cycle, node-ID or controllers are not those of the file";
    const auto told = [](const std::map<std::string, std::string>& values)
    {
        Bench bench(FileWith("actuator", values));
        return bench.Told();
    };
    EXPECT_NE(told({}).find(line + "\n"), std::string::npos) << told({});
    EXPECT_NE(told({{"5F04", "0x1"}}).find(line + ", whose 0x5F04:00 is not its digest\n"), std::string::npos);
    // None in the file, or the cycle of the file
    EXPECT_EQ(told({{"5F04", "0"}}).find(line), std::string::npos);
    EXPECT_EQ(told({{"5F00sub1", "5000"}}).find(line), std::string::npos);
    // With the cycle of the file, another node-ID
    const std::string file = FileWith("actuator", {{"5F00sub1", "5000"}});
    for (const auto& [node_id, is_told] : {std::pair(33, false), std::pair(34, true)})
    {
        Bench bench(file, "", runtime::ReportForm::kText, static_cast<std::uint8_t>(node_id));
        EXPECT_EQ(bench.Told().find(line) != std::string::npos, is_told) << node_id;
    }
    // With cycle and node-ID of the file, another number of controllers
    for (const bool has_second : {false, true})
    {
        std::ostringstream out;
        runtime::NodeReport report{out, runtime::ReportForm::kText, 0U};
        runtime::NodePorts ports{std::make_unique<EchoBus>(false, 0U), std::make_unique<EchoBus>(false, 0U),
                                 has_second ? std::make_unique<EchoBus>(false, 0U) : nullptr};
        runtime::NodeSettings settings;
        settings.dcf = file;
        settings.has_self_tests = false;
        runtime::NodeDevice device{settings, ports, report};
        device.TellStart("udp:1", 0U);
        static_cast<void>(report.Finish());
        EXPECT_EQ(out.str().find(line) != std::string::npos, has_second) << out.str();
    }
}

TEST(NodeConfiguredTest, ADigestThatIsNotExpectedRefusesNothing)
{
    Verifies(req::SRS_NODE_042);
    // Given a wrong digest in a file of the cycle of the bench, and in one of another cycle
    for (const bool is_other : {false, true})
    {
        Bench bench(FileWith("actuator", {{"5F00sub1", is_other ? "1000" : "5000"}, {"5F04", "0x1"}}));
        const ObjectReading valid = bench.Device().Assembly().Core().ReadObject({0x13FEU, 0U});
        EXPECT_EQ(ToValue(valid.data), is_other ? 0xA5U : 0U) << bench.Told();
    }
}

TEST(NodeConfiguredTest, AnSrdoThatWasSwitchedOffOverSdoHasNoInputs)
{
    Verifies(req::SRS_NODE_019);
    Bench bench(FileWithout("sensor", {}));
    runtime::NodeDevice& device = bench.Device();
    EXPECT_TRUE(device.App().SetInput({0x2000U, 1U}, 1U));
    EXPECT_EQ(bench.Download(0x1301U, 1U, 0U, 1U), 0U);
    const SignReply reply = device.Assembly().Core().Sign({0x1301U});
    EXPECT_EQ(bench.Download(0x13FFU, 1U, reply.signature, 2U), 0U);
    EXPECT_EQ(bench.Download(0x13FEU, 0U, 0xA5U, 1U), 0U);
    bench.Start();
    for (int cycle = 0; cycle < 20; ++cycle)
    {
        bench.Cycle();
    }
    EXPECT_TRUE(bench.SentWith(0x101U).empty());
    EXPECT_FALSE(device.App().SetInput({0x2000U, 1U}, 0U));
    EXPECT_EQ(device.App().Values(), "");
    const std::string told = bench.Told();
    EXPECT_NE(told.find("SRDO 1 off"), std::string::npos) << told;
}
} // namespace
} // namespace counterpoint::tools::test
