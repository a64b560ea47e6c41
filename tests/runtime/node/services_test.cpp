// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/live/bus.hpp"
#include "tests/canopen/cia306/folder_of_files.hpp"
#include "tests/runtime/node/process.hpp"
#include "tests/runtime/stepped_time/stepped_time.hpp"
#include "verification/trace/ids/cia301.hpp"
#include "verification/trace/ids/comfort.hpp"
#include "verification/trace/ids/lss.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/ids/store.hpp"
#include "verification/trace/verifies.hpp"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <memory>
#include <sstream>
#include <unistd.h>

// What a live node has beside its SRDOs, in processes of their own on one bus.
namespace counterpoint::tools::test
{
namespace
{
const std::string kPlain = "../tests/runtime/data/plain.dcf";
using Octets = std::vector<std::uint8_t>;

std::string TextOf(const std::string& dcf)
{
    std::ifstream file(std::string(COUNTERPOINT_SOURCE) + "/examples/" + dcf);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::string Replaced(std::string text, const std::string& from, const std::string& to)
{
    const std::size_t place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    return (place == std::string::npos) ? text : text.replace(place, from.size(), to);
}

/// Somebody else on a bus of the test.
class Other
{
  public:
    explicit Other(const std::string& address) : bus_(host::OpenLiveBus(address))
    {
    }
    void Send(std::uint32_t identifier, const Octets& bytes)
    {
        host::LiveFrame frame;
        frame.identifier = identifier;
        frame.length_bytes = static_cast<std::uint8_t>(bytes.size());
        std::copy(bytes.begin(), bytes.end(), frame.data);
        EXPECT_EQ(bus_->Send(frame), host::SendResult::kSent);
    }
    /// A command of LSS.
    void Lss(Octets bytes)
    {
        bytes.resize(8U);
        Send(0x7E5U, bytes);
    }
    /// Frames of others with this identifier that came within `ms`, or until there are `enough`.
    std::vector<Octets> Hear(std::uint32_t identifier, int ms, std::size_t enough = 1U)
    {
        std::vector<Octets> heard;
        const std::uint64_t until_ns = NowNs() + static_cast<std::uint64_t>(ms) * 1000000U;
        while (heard.size() < enough && NowNs() < until_ns)
        {
            host::LiveFrame frame;
            if (!bus_->Receive(frame))
            {
                static_cast<void>(SteppedTime::Get().Wait(bus_->Descriptor(), until_ns));
            }
            else if (!frame.own && frame.identifier == identifier)
            {
                heard.emplace_back(frame.data, frame.data + frame.length_bytes);
            }
        }
        return heard;
    }

  private:
    std::unique_ptr<host::LiveBus> bus_;
};

class NodeServicesTest : public cia306::test::FolderTest
{
  protected:
    /// What 'get' says: the value, or the text of the problem.
    static nlohmann::json Get(NodeProcess& node, const std::string& object)
    {
        node.Type("get " + object);
        const NodeLine line = node.WaitFor([](const nlohmann::json& event)
                                           { return event["event"] == "object" || event["event"] == "problem"; });
        return line.event.contains("value") ? line.event["value"] : line.event["text"];
    }
};

TEST_F(NodeServicesTest, WhyTheKernelRefusesAStartIsTold)
{
    Verifies(req::SRS_EASE_007);
    // Given a granularity that there is not
    std::string text = TextOf("emergency_stop/sensor.dcf");
    const std::size_t object = text.find("[5F00subA]");
    text.replace(text.find("ParameterValue=8", object), 16U, "ParameterValue=3");
    const std::string file = File("slow.dcf", text);
    NodeProcess node({"--dcf", file, "--no-self-tests", "--no-input"});
    EXPECT_EQ(node.WaitFor("no_start").event["text"],
              "the kernel refuses this device: granularity (Not 1, 8, 16, 32 or 64)");
    EXPECT_EQ(node.End(), 1);
}

TEST_F(NodeServicesTest, APlainDeviceRunsWithoutASafetyPart)
{
    Verifies(req::SRS_NODE_016);
    Verifies(req::SRS_DEV_021);
    const auto node = StartNode(kPlain, {});
    node->Type("nmt start");
    EXPECT_FALSE(node->WaitFor(Event("nmt", "state", "operational")).event.is_null());
    EXPECT_EQ(Get(*node, "0x2000:00"), 7);
    EXPECT_EQ(Get(*node, "0x1001:00"), 0); // no emergency
    EXPECT_NE(Get(*node, "0x1300:00").get<std::string>().find("0602 0000h"), std::string::npos);
    EXPECT_NE(Get(*node, "0x13FE:00").get<std::string>().find("0602 0000h"), std::string::npos);
    node->Type("state");
    EXPECT_TRUE(node->WaitFor("state").event["srdos"].empty());
    node->Type("quit");
    EXPECT_EQ(node->End(), 0);
}

TEST_F(NodeServicesTest, ClientAndServersOfTheFileTalk)
{
    Verifies(req::SRS_NODE_012);
    Verifies(req::SRS_DEV_020);
    const auto five = StartNode(kPlain, {});
    const auto six = StartNode(kPlain, {"--node-id", "6"});
    // By the client of 1280h, at the default server of node 6
    five->Type("write 6 0x2000:00 42 1");
    EXPECT_EQ(five->WaitFor("written").event["abort"], 0);
    EXPECT_EQ(Get(*six, "0x2000:00"), 42);
    five->Type("read 6 0x2000:00");
    EXPECT_EQ(five->WaitFor("read").event["value"], 42);
    five->Type("read 6 0x2001:00");
    EXPECT_EQ(five->WaitFor("read").event["abort"], 0x06020000U);
    // By the client of 1281h, at the second server of node 5
    six->Type("read 5 0x1018:02");
    EXPECT_EQ(six->WaitFor("read").event["value"], 9);
    // Nobody is asked who is in no client's object, or does not answer
    five->Type("read 7 0x1000:00");
    EXPECT_FALSE(five->WaitFor("problem").event.is_null());
    six->Type("quit");
    EXPECT_EQ(six->End(), 0);
    five->Type("read 6 0x2000:00");
    EXPECT_EQ(five->WaitFor("read").event["abort"], 0x05040000U);
}

TEST_F(NodeServicesTest, TimesAndEmergenciesOfOthersAreLines)
{
    Verifies(req::SRS_NODE_012);
    Verifies(req::SRS_EMCY_009);
    const auto five = StartNode(kPlain, {});
    const auto six = StartNode(kPlain, {"--node-id", "6"});
    six->Type("time");
    const nlohmann::json time = five->WaitFor("time").event;
    EXPECT_GT(time["days"], 15000); // since 1984
    EXPECT_LT(time["ms"], 86400000);
    // A frame with an identifier that only node 6 has is its emergency 8150h, and node 5 hears of it
    Other other(OwnBus());
    other.Send(0x706U, {5U});
    const nlohmann::json emergency = five->WaitFor("emergency").event;
    EXPECT_EQ(emergency["node"], 6);
    EXPECT_EQ(emergency["code"], 0x8150);
    // 1003h has the twenty entries of the file
    EXPECT_EQ(Get(*six, "0x1003:00"), 1);
    EXPECT_EQ(Get(*six, "0x1003:01").get<unsigned>() & 0xFFFFU, 0x8150U);
    EXPECT_NE(Get(*six, "0x1003:14").get<std::string>().find("0800 0024h"), std::string::npos);
    EXPECT_NE(Get(*six, "0x1003:15").get<std::string>().find("0609 0011h"), std::string::npos);
    // A node that may not send times says so
    five->Type("set 0x1012:00 0x80000100");
    five->Type("time");
    EXPECT_FALSE(five->WaitFor("problem").event.is_null());
    const auto before = Get(*five, "0x1013:00").get<std::uint32_t>();
    SleepMs(20);
    EXPECT_GE(Get(*five, "0x1013:00").get<std::uint32_t>() - before, 20000U - 2U * kCycleUs);
}

/// Behind a node-ID by LSS: the self tests cover what they covered at the first start.
void ExpectAllSelfTestsTwice(const NodeProcess& node)
{
    std::vector<std::string> covered;
    for (const NodeLine& line : node.Lines())
    {
        if (line.event["event"] == "self_tests")
        {
            covered.push_back(line.event["covered"]);
        }
    }
    ASSERT_EQ(covered.size(), 2U);
    EXPECT_EQ(covered[1], covered[0]);
    EXPECT_NE(covered[1], "none");
}

TEST_F(NodeServicesTest, WithoutANodeIdThereIsOnlyLssAndThenANode)
{
    Verifies(req::SRS_NODE_150);
    Verifies(req::SRS_NODE_151);
    Verifies(req::SRS_NODE_152);
    Verifies(req::SRS_LSS_009);
    Verifies(req::SRS_NODE_161);
    const std::string file = File("none.dcf", Replaced(TextOf(kPlain), "NodeID=5\n", ""));
    const std::string store = Path("lss_store");
    std::remove(store.c_str());
    const std::vector<std::string> arguments{"--dcf", file,      "--cycle-us", std::to_string(kCycleUs),
                                             "--lss", "--store", store};
    NodeProcess node(arguments);
    EXPECT_EQ(node.WaitFor("start").event["node_id"], 0);
    Other other(OwnBus());
    other.Send(0x000U, {1U, 0U});
    EXPECT_FALSE(node.Tells(Event("nmt", "state", "pre_operational"), 300));
    // Somebody looks for nodes without a node-ID, gives it one, and has it kept
    other.Lss({0x4CU});
    EXPECT_EQ(other.Hear(0x7E4U, 2000).at(0U)[0], 0x50U);
    other.Lss({0x04U, 1U});
    other.Lss({0x11U, 9U});
    EXPECT_EQ(other.Hear(0x7E4U, 2000), (std::vector<Octets>{{0x11U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}}));
    other.Lss({0x13U, 0U, 2U}); // the bit rate is the system's
    EXPECT_EQ(other.Hear(0x7E4U, 2000), (std::vector<Octets>{{0x13U, 1U, 0U, 0U, 0U, 0U, 0U, 0U}}));
    other.Lss({0x17U});
    EXPECT_EQ(other.Hear(0x7E4U, 4000), (std::vector<Octets>{{0x17U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}}));
    other.Lss({0x04U, 0U});
    EXPECT_EQ(other.Hear(0x709U, 3000), (std::vector<Octets>{{0U}}));
    EXPECT_FALSE(node.WaitFor(Event("start", "node_id", 9)).event.is_null());
    EXPECT_EQ(Get(node, "0x1014:00"), 0x89);
    node.Type("quit");
    EXPECT_EQ(node.End(), 0);
    ExpectAllSelfTestsTwice(node);
    // The next start has it from the store
    NodeProcess again(arguments);
    EXPECT_FALSE(again.WaitFor(Event("nmt", "state", "pre_operational")).event.is_null());
    EXPECT_EQ(Get(again, "0x1014:00"), 0x89);
    again.Type("quit");
    EXPECT_EQ(again.End(), 0);
    // It begins with it, also where the command line gives another one, and tells of no device with another
    std::vector<std::string> more = arguments;
    more.insert(more.end(), {"--node-id", "11"});
    NodeProcess third(more);
    EXPECT_EQ(third.WaitFor("nmt").event["state"], "pre_operational");
    third.Type("quit");
    EXPECT_EQ(third.End(), 0);
    for (const NodeProcess* const restarted : {&again, &third})
    {
        std::vector<int> told;
        for (const NodeLine& line : restarted->Lines())
        {
            if (line.event["event"] == "start")
            {
                told.push_back(line.event["node_id"]);
            }
        }
        EXPECT_EQ(told, std::vector<int>{9});
    }
}

TEST_F(NodeServicesTest, TheOptionGivesLssToADeviceWhoseFileHasNone)
{
    Verifies(req::SRS_NODE_015);
    const std::string file = File("option_lss.dcf", TextOf(kPlain));
    const std::vector<std::string> without{"--dcf", file, "--cycle-us", std::to_string(kCycleUs)};
    std::vector<std::string> with = without;
    with.emplace_back("--lss");
    for (const std::vector<std::string>& words : {without, with})
    {
        NodeProcess node(words);
        EXPECT_EQ(node.WaitFor("start").event["node_id"], 5);
        Other other(OwnBus());
        // When somebody asks all for their node-ID
        other.Lss({0x04U, 1U});
        other.Lss({0x5EU});
        // Then it answers with the one of its file, or not at all
        const std::vector<Octets> answer{{0x5EU, 5U, 0U, 0U, 0U, 0U, 0U, 0U}};
        EXPECT_EQ(other.Hear(0x7E4U, 1000), (words == with) ? answer : std::vector<Octets>{});
        node.Type("quit");
        EXPECT_EQ(node.End(), 0);
    }
}

TEST_F(NodeServicesTest, TheStoredNodeIdGoesBeforeThoseOfCommandLineAndFile)
{
    Verifies(req::SRS_NODE_015);
    // Given a file with node-ID 5 that says that the device has LSS
    const std::string file = File("lss.dcf", Replaced(TextOf(kPlain), "LSS_Supported=0", "LSS_Supported=1"));
    const std::string store = Path("lss_kept");
    std::remove(store.c_str());
    const std::vector<std::string> arguments{"--dcf", file, "--cycle-us", std::to_string(kCycleUs), "--store", store};
    NodeProcess node(arguments);
    EXPECT_EQ(node.WaitFor("start").event["node_id"], 5);
    Other other(OwnBus());
    // When it gets another one by LSS, which is kept
    other.Lss({0x04U, 1U});
    other.Lss({0x11U, 9U});
    EXPECT_EQ(other.Hear(0x7E4U, 2000), (std::vector<Octets>{{0x11U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}}));
    other.Lss({0x17U});
    EXPECT_EQ(other.Hear(0x7E4U, 4000), (std::vector<Octets>{{0x17U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}}));
    node.Type("quit");
    EXPECT_EQ(node.End(), 0);
    // Then it is that one, whatever the file and the command line say
    std::vector<std::string> with_option = arguments;
    with_option.insert(with_option.end(), {"--node-id", "6"});
    for (const std::vector<std::string>& words : {arguments, with_option})
    {
        NodeProcess again(words);
        EXPECT_EQ(again.WaitFor("start").event["node_id"], 9);
        again.Type("quit");
        EXPECT_EQ(again.End(), 0);
    }
    std::remove(store.c_str());
}

TEST_F(NodeServicesTest, APdoThatDoesNotHoldIsTold)
{
    Verifies(req::SRS_NODE_017);
    const std::string file =
        File("pdo.dcf", Replaced(TextOf(kPlain), "DefaultValue=0x20000008", "DefaultValue=0x20010008"));
    NodeProcess node({"--dcf", file, "--cycle-us", std::to_string(kCycleUs)});
    const auto is_told = [](const nlohmann::json& event)
    {
        return event["event"] == "refused" && event["text"].get<std::string>().find(
                                                  "0x1800:01: the device has turned this PDO off") != std::string::npos;
    };
    EXPECT_TRUE(node.Tells(is_told, 5000));
}

TEST_F(NodeServicesTest, InverseFramesHaveAControllerOfTheirOwn)
{
    Verifies(req::SRS_NODE_014);
    for (const std::string& second : {OtherBus(), OwnBus()})
    {
        const auto sensor = StartNode("emergency_stop/sensor.dcf", {"--can2", second});
        const auto controller = StartNode("emergency_stop/controller.dcf", {"--can2", second});
        Other first_bus(OwnBus());
        Other second_bus(second);
        sensor->Type("set 0x2000:01 1");
        controller->Type("nmt start");
        sensor->Type("nmt start 1");
        EXPECT_FALSE(controller->WaitFor(Event("output", "open", true)).event.is_null());
        EXPECT_FALSE(controller->WaitFor(Event("value", "value", 1)).event.is_null());
        EXPECT_FALSE(first_bus.Hear(0x101U, 1000).empty());
        EXPECT_FALSE(second_bus.Hear(0x102U, 1000).empty());
        EXPECT_EQ(first_bus.Hear(0x102U, 200).empty(), second == OtherBus());
        EXPECT_EQ(second_bus.Hear(0x101U, 200).empty(), second == OtherBus());
        EXPECT_FALSE(controller->Tells(Event("output", "open", false), 500));
        controller->Type("quit");
        EXPECT_EQ(controller->End(), 0);
    }
}

// Given a store without a whole set, or with the values of another device, then the node says so and runs; a new one
// and its own are used without a word.
TEST_F(NodeServicesTest, AStoreThatCannotBeUsedIsTold)
{
    Verifies(req::SRS_NODE_011);
    constexpr std::size_t kStoreBytes = 524288U;
    const std::string everything = "../tests/runtime/data/everything.dcf";
    const std::string own = Path("own.store");
    for (int start = 0; start < 2; ++start)
    {
        auto node = StartNode(everything, {"--store", own});
        node->Type("set 0x1010:01 0x65766173");
        EXPECT_FALSE(node->Tells(Event("device_fault", "fault", "late_call"), 500));
        node->Type("quit");
        EXPECT_EQ(node->End(), 0);
        const auto& lines = node->Lines();
        EXPECT_TRUE(std::none_of(lines.begin(), lines.end(),
                                 [](const NodeLine& line) { return line.event["event"] == "store"; }));
    }
    const std::string wrong = File("wrong.store", std::string(kStoreBytes, '\x5A'));
    for (const std::string& dcf : {everything, std::string("emergency_stop/sensor.dcf")})
    {
        const std::string& store = (dcf == everything) ? wrong : own;
        auto node = StartNode(dcf, {"--store", store});
        node->Type("quit");
        EXPECT_EQ(node->End(), 0);
        const auto& lines = node->Lines();
        const auto told = std::find_if(lines.begin(), lines.end(),
                                       [](const NodeLine& line) { return line.event["event"] == "store"; });
        ASSERT_NE(told, lines.end()) << store;
        const std::string text = told->event["text"];
        EXPECT_EQ(text.find(store + ": warning: "), 0U) << text;
        EXPECT_NE(text.find(dcf == everything
                                ? "what was saved is damaged, expected the whole set that 1010h has saved last"
                                : "saved values are refused (0x4001:00, 0x4002:00, "),
                  std::string::npos)
            << text;
    }
}

// A value of more bytes than its object has is not cut off: of a variable, an SCT, a direction.
TEST_F(NodeServicesTest, AnOrderWhoseObjectCannotHoldTheValueChangesNothing)
{
    Verifies(req::SRS_NODE_003);
    auto node = StartNode("../tests/runtime/data/everything.dcf", {});
    for (const std::string& set : {std::string("0x4005:00 256"), std::string("0x1301:02 65596"),
                                   std::string("0x1301:01 258"), std::string("0x1017:00 65536")})
    {
        const std::string object = set.substr(0U, 9U);
        node->Type("get " + object);
        const int before = node->WaitFor("object").event["value"];
        node->Type("set " + set);
        const std::string text = node->WaitFor("problem").event["text"];
        EXPECT_EQ(text.find("set: " + object + " = " + set.substr(10U) + " refused with 0609 0031h"), 0U) << text;
        node->Type("get " + object);
        EXPECT_EQ(node->WaitFor("object").event["value"], before) << set;
    }
    // The greatest one is taken
    node->Type("set 0x1017:00 65535");
    node->Type("get 0x1017:00");
    EXPECT_EQ(node->WaitFor("object").event["value"], 65535);
    node->Type("quit");
    EXPECT_EQ(node->End(), 0);
}

// Two saves at once: the second one is refused, and the first one goes on to its end.
TEST_F(NodeServicesTest, AnOrderToSaveWithinASaveIsRefused)
{
    Verifies(req::SRS_STO_020);
    const std::string store = Path("twice.store");
    std::remove(store.c_str());
    auto node = StartNode("../tests/runtime/data/everything.dcf", {"--store", store});
    node->Type("set 0x4005:00 50");
    node->Type("set 0x1010:01 0x65766173");
    node->Type("set 0x1010:01 0x65766173");
    const std::string text = node->WaitFor("problem").event["text"];
    EXPECT_EQ(text.find("set: 0x1010:01 = 1702257011 refused with 0800 0021h"), 0U) << text;
    EXPECT_FALSE(node->Tells([](const nlohmann::json& event) { return event["event"] == "problem"; }, 700));
    node->Type("quit");
    EXPECT_EQ(node->End(), 0);
    node = StartNode("../tests/runtime/data/everything.dcf", {"--store", store});
    node->Type("get 0x4005:00");
    EXPECT_EQ(node->WaitFor("object").event["value"], 50);
    node->Type("quit");
    EXPECT_EQ(node->End(), 0);
    std::remove(store.c_str());
}

// Given a configuration that was saved, and a newer one: where a bit of the newer one has changed, neither the older
// one nor that of the file comes up valid, the node says so, and what is saved then counts again.
TEST_F(NodeServicesTest, ADamagedStoreNeverBringsAnOlderConfigurationBack)
{
    Verifies(req::SRS_STO_014);
    Verifies(req::SRS_NODE_011);
    constexpr std::streamoff kSecondBank = 262144;
    const std::string everything = "../tests/runtime/data/everything.dcf";
    const std::string store = Path("decayed.store");
    std::remove(store.c_str());
    const auto run = [&](const std::vector<std::string>& orders)
    {
        auto node = StartNode(everything, {"--store", store});
        node->Type("get 0x13FE:00");
        const int valid = node->WaitFor("object").event["value"];
        for (const std::string& order : orders)
        {
            node->Type(order);
        }
        EXPECT_FALSE(node->Tells(Event("device_fault", "fault", "late_call"), orders.empty() ? 1 : 700));
        node->Type("quit");
        EXPECT_EQ(node->End(), 0);
        std::string text{};
        for (const NodeLine& line : node->Lines())
        {
            text += (line.event["event"] == "store") ? line.event["text"].get<std::string>() : "";
        }
        return std::pair(valid, text);
    };
    EXPECT_EQ(run({"set 0x1010:01 0x65766173"}).first, 0xA5);
    EXPECT_EQ(run({"set 0x4005:00 50", "set 0x1010:01 0x65766173"}).first, 0xA5);
    EXPECT_EQ(run({}), std::pair(0xA5, std::string()));
    std::fstream file(store, std::ios::in | std::ios::out | std::ios::binary);
    file.seekg(kSecondBank + 200);
    const int byte = file.get();
    file.seekp(kSecondBank + 200);
    file.put(static_cast<char>(byte ^ 1));
    file.close();
    const std::string told = store +
                             ": warning: what was saved is damaged, expected the whole set that 1010h has "
                             "saved last; no older one is loaded, and 13FEh is not A5h until a configuration is "
                             "written and saved again";
    // A save of the manufacturer's values alone brings no safety configuration back
    EXPECT_EQ(run({"set 0x1010:04 0x65766173"}), std::pair(0, told));
    EXPECT_EQ(run({"set 0x1011:01 0x64616F6C"}), std::pair(0, told));
    EXPECT_EQ(run({}), std::pair(0xA5, std::string()));
    std::remove(store.c_str());
}

// Given an order whose line never ends, then it is not carried out, and the node runs on.
TEST_F(NodeServicesTest, AnOrderWithoutAnEndIsTold)
{
    Verifies(req::SRS_NODE_331);
    auto node = StartNode("emergency_stop/sensor.dcf", {});
    node->Type(std::string(5000U, 'x'));
    EXPECT_EQ(node->WaitFor("problem").event["text"],
              "an order of more than 1024 characters, expected at most so many in one line; it is left out");
    // And what stands behind its end is carried out, and one that comes whole is left out likewise
    node->Type(std::string(1500U, 'x') + "\n" + "get 0x1000:00" + std::string(1012U, ' ') + "\nnmt\n");
    EXPECT_EQ(node->WaitFor("problem").event["text"],
              "an order of more than 1024 characters, expected at most so many in one line; it is left out");
    EXPECT_EQ(node->WaitFor("nmt").event["state"], "pre_operational");
    // One of 1024 characters is none
    node->Type("get 0x1000:00" + std::string(1011U, ' ') + "\n");
    EXPECT_EQ(node->WaitFor("object").event["object"], "0x1000:00");
    node->Signal(SIGTERM);
    EXPECT_EQ(node->End(), 0);
}
} // namespace
} // namespace counterpoint::tools::test
