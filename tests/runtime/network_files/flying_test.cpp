// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Flying masters in network files: who is one, with which times and which behaviour.
#include "canopen/cia306/text/input_error.hpp"
#include "canopen/network_plan/loaded_network.hpp"
#include "runtime/manager/station.hpp"
#include "runtime/network_files/file.hpp"
#include "runtime/yaml/document.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/canopen/cia306/folder_of_files.hpp"
#include "verification/trace/ids/flying_master.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::tools
{
namespace
{
using cia302::CyclicMessage;
using cia302::EqualLevel;
using cia302::ForceReaction;
using cia302::LossReaction;
using cia302::MasterWatch;
using cia302::StandbyReaction;
using cia306::test::ExampleText;
using network_plan::LoadedNetwork;

class NetworkFlyingTest : public cia306::test::FolderTest
{
  protected:
    /// The controller of the example with 1F80h and, of 1F90h, sub-index 1, 3 and `slot_sub`.
    void WriteManager(const std::string& start_up, const std::string& level, const std::string& slot_sub = "4",
                      const std::string& slot = "1500") const
    {
        std::string dcf = ExampleText("controller");
        const std::size_t place = dcf.find("[OptionalObjects]\nSupportedObjects=");
        const std::size_t begin = dcf.find("SupportedObjects=", place) + 17U;
        const std::size_t end = dcf.find('\n', begin);
        const int count = std::stoi(dcf.substr(begin, end - begin));
        dcf.insert(dcf.find("\n\n", begin),
                   "\n" + std::to_string(count + 1) + "=0x1F80\n" + std::to_string(count + 2) + "=0x1F90");
        dcf.replace(begin, end - begin, std::to_string(count + 2));
        const auto variable = [](const std::string& section, const std::string& type, const std::string& value)
        {
            return "\n[" + section + "]\nParameterName=x\nObjectType=0x7\nDataType=" + type +
                   "\nAccessType=rw\nParameterValue=" + value + "\nPDOMapping=0\n";
        };
        dcf += variable("1F80", "0x0007", start_up) + "\n[1F90]\nParameterName=x\nObjectType=0x8\nSubNumber=4\n" +
               variable("1F90sub0", "0x0005", "6") + variable("1F90sub1", "0x0006", "150") +
               variable("1F90sub3", "0x0006", level) + variable("1F90sub" + slot_sub, "0x0006", slot);
        static_cast<void>(File("manager.dcf", dcf));
    }
    [[nodiscard]] std::string Net(const std::string& manager) const
    {
        return File("net.yaml", "manager: {node: 2, heartbeat: 200 ms, " + manager + "}\nslaves: [{node: 9}]\n");
    }
    [[nodiscard]] cia302::FlyingMasterOptions Options(const std::string& flying) const
    {
        return runtime::ReadNetworkFile(Net("flying: {" + flying + "}"), 0U).manager.flying->options;
    }
};

TEST_F(NetworkFlyingTest, EachVariantByItself)
{
    Verifies(req::SRS_FLY_029);
    EXPECT_EQ(Options("cyclic: negotiation").cyclic, CyclicMessage::kNegotiation);
    EXPECT_EQ(Options("preset: so1114, cyclic: force").cyclic, CyclicMessage::kForce);
    EXPECT_EQ(Options("on_force: reset_all").on_force, ForceReaction::kResetAll);
    EXPECT_EQ(Options("on_force: race").on_force, ForceReaction::kRace);
    EXPECT_EQ(Options("on_force: restart").on_force, ForceReaction::kRestart);
    EXPECT_EQ(Options("equal_level: lower_node_forces").equal_level, EqualLevel::kLowerNodeForces);
    EXPECT_EQ(Options("on_loss: reset_all").on_loss, LossReaction::kResetAll);
    EXPECT_EQ(Options("on_loss: race").on_loss, LossReaction::kRace);
    EXPECT_EQ(Options("watch: twice_producer").watch, MasterWatch::kTwiceProducer);
    EXPECT_EQ(Options("watch: application").watch, MasterWatch::kApplication);
    EXPECT_EQ(Options("preset: so1114, watch: installed").watch, MasterWatch::kInstalled);
    EXPECT_EQ(Options("watch_time: 700 ms").watch_ms, 700U);
    EXPECT_EQ(Options("standby: asks").standby, StandbyReaction::kAsks);
    EXPECT_EQ(Options("standby: races").standby, StandbyReaction::kRaces);
    EXPECT_EQ(Options("preset: so1114, standby: ignores").standby, StandbyReaction::kIgnores);
    EXPECT_TRUE(Options("negotiates: pre_operational").negotiates_pre_operational);
    EXPECT_TRUE(Options("race_heard: keeps_slot").keeps_slot);
    EXPECT_TRUE(Options("claim_heard: ignores").ignores_claims);
    EXPECT_TRUE(Options("answers_boot_up: true").answers_boot_up);
    EXPECT_EQ(Options("restarts: 0").max_restarts, 0U);
    EXPECT_EQ(Options("preset: so1114, restarts: 7").max_restarts, 7U);
    // Given none, everything is as in the preset
    EXPECT_EQ(Options("priority: 1").max_restarts, 3U);
    EXPECT_EQ(Options("preset: so1114").standby, StandbyReaction::kAsks);
}

TEST_F(NetworkFlyingTest, UnknownWordsAndTimesAreRefusedAtTheirPlace)
{
    Verifies(req::SRS_FLY_029);
    Verifies(req::SRS_NET_004);
    const auto refusal = [this](const std::string& flying)
    {
        try
        {
            static_cast<void>(Options(flying));
        }
        catch (const runtime::YamlError& error)
        {
            const std::string text = error.what();
            return text.substr(text.find("net.yaml") + 8U);
        }
        return std::string("accepted");
    };
    EXPECT_EQ(refusal("cyclic: 0x76"), ":1:56: error: '0x76', expected one of force, negotiation");
    EXPECT_EQ(refusal("standby: sleeps"), ":1:57: error: 'sleeps', expected one of ignores, asks, races");
    EXPECT_EQ(refusal("watch_time: 0 ms"), ":1:60: error: a master that is lost at once, expected a time above 0");
    EXPECT_EQ(refusal("restarts: 256").substr(0U, 15U), ":1:58: error: '");
    EXPECT_EQ(refusal("on_lost: race").substr(0U, 14U), ":1:48: error: ");
}

TEST_F(NetworkFlyingTest, StartUpValueDecidesNotTheDictionary)
{
    Verifies(req::SRS_FLY_030);
    // Given 1F90h in the DCF, once with and once without bit 5 of 1F80h
    WriteManager("0x21", "1");
    const LoadedNetwork flies(runtime::ReadNetworkFile(Net("dcf: manager.dcf"), 0U));
    ASSERT_TRUE(flies.Plan().manager.flying);
    EXPECT_EQ(flies.Plan().manager.flying->timeout_ms, std::uint16_t{150U});
    EXPECT_EQ(flies.Plan().manager.flying->priority, std::uint16_t{1U});
    EXPECT_EQ(flies.Setup().start_up, 0x21U);
    WriteManager("0x01", "1");
    const LoadedNetwork rests(runtime::ReadNetworkFile(Net("dcf: manager.dcf"), 0U));
    EXPECT_FALSE(rests.Plan().manager.flying);
    EXPECT_EQ(rests.Setup().start_up, 0x01U);
    // When the network file asks for it, the values of the DCF count where it says nothing
    const LoadedNetwork asked(runtime::ReadNetworkFile(Net("dcf: manager.dcf, flying: {priority: 0}"), 0U));
    ASSERT_TRUE(asked.Plan().manager.flying);
    EXPECT_EQ(asked.Plan().manager.flying->timeout_ms, std::uint16_t{150U});
    EXPECT_EQ(asked.Plan().manager.flying->priority, std::uint16_t{0U});
    EXPECT_EQ(asked.Setup().start_up, 0x21U);
    // Given the bit in the network file alone
    const LoadedNetwork bit(runtime::ReadNetworkFile(Net("start_up: 0x21"), 0U));
    EXPECT_TRUE(bit.Plan().manager.flying);
    EXPECT_TRUE(bit.Warnings().empty());
}

TEST_F(NetworkFlyingTest, ReservedPriorityInTheDcfIsRefusedWithItsLine)
{
    Verifies(req::SRS_FLY_030);
    Verifies(req::SRS_NET_004);
    WriteManager("0x21", "3");
    try
    {
        const LoadedNetwork net(runtime::ReadNetworkFile(Net("dcf: manager.dcf"), 0U));
        FAIL() << "accepted";
    }
    catch (const cia306::InputError& error)
    {
        const std::string text = error.what();
        EXPECT_NE(text.find("manager.dcf:"), std::string::npos) << text;
        EXPECT_NE(text.find("0x1F90:03: 0x3, expected at most 0x2"), std::string::npos) << text;
    }
}

TEST_F(NetworkFlyingTest, SlotsThatOverlapAreRefusedWhereTheyStand)
{
    Verifies(req::SRS_NET_231);
    const auto refusal = [](const std::string& file)
    {
        LoadedNetwork net(runtime::ReadNetworkFile(file, 0U));
        std::string text;
        try
        {
            const runtime::ManagerStation station(
                net, [](const CanFrame&) { return true; }, [](const runtime::ManagerEvent&) {});
        }
        catch (const cia306::InputError& error)
        {
            text = error.what();
        }
        return text;
    };
    const auto wrong = [](const std::string& level, const std::string& node)
    {
        return ": error: level slot " + level + " ms with node slot " + node +
               " ms, expected a level slot above 127 node slots, which are above 0";
    };
    // In the manager's DCF: 1F90h:04, or :05
    WriteManager("0x21", "0", "4", "100");
    const std::string level = refusal(Net("dcf: manager.dcf"));
    EXPECT_EQ(level.find(Path("manager.dcf") + ":"), 0U) << level;
    EXPECT_NE(level.find(wrong("100", "10")), std::string::npos) << level;
    WriteManager("0x21", "0", "5", "12");
    const std::string node = refusal(Net("dcf: manager.dcf"));
    EXPECT_EQ(node.find(Path("manager.dcf") + ":"), 0U) << node;
    EXPECT_NE(node.find(wrong("1500", "12")), std::string::npos) << node;
    // In the network file, which goes before the DCF
    EXPECT_EQ(refusal(Net("dcf: manager.dcf, flying: {level_slot: 200 ms}")),
              Path("net.yaml") + ":1:10" + wrong("200", "12"));
    EXPECT_EQ(refusal(Net("dcf: manager.dcf, flying: {node_slot: 13 ms}")),
              Path("net.yaml") + ":1:10" + wrong("1500", "13"));
}

TEST_F(NetworkFlyingTest, AFlyingMasterWithoutHeartbeatIsWarnedOf)
{
    Verifies(req::SRS_FLY_340);
    const std::string file = File("net.yaml", "manager: {node: 2, flying: {priority: 1}}\nslaves: [{node: 9}]\n");
    const LoadedNetwork net(runtime::ReadNetworkFile(file, 0U));
    ASSERT_EQ(net.Warnings().size(), 1U);
    EXPECT_EQ(net.Warnings()[0],
              file + ":1:20: warning: a flying master without heartbeat, which its standbys lose again and again: "
                     "expected a heartbeat above 0 ms");
}

TEST_F(NetworkFlyingTest, TimesThatDoNotGoTogetherAreWarnedOfAtTheirLine)
{
    Verifies(req::SRS_FLY_340);
    const auto warnings = [this](const std::string& flying, const std::string& slave)
    {
        const std::string file = File("net.yaml", "manager:\n  node: 2\n  heartbeat: 500 ms\n  flying:\n" + flying +
                                                      "slaves: [" + slave + "]\n");
        const LoadedNetwork net(runtime::ReadNetworkFile(file, 0U));
        std::string all;
        for (const std::string& warning : net.Warnings())
        {
            all += warning.substr(file.size()) + "|";
        }
        return all;
    };
    const std::string slave = "{node: 9}";
    // Given a time for missing the master that is its heartbeat's, and one above it
    const std::string lost = " for masters with a heartbeat each 500 ms as this one: their standbys lose them again "
                             "and again, expected a longer one|";
    EXPECT_EQ(warnings("    watch_time: 500 ms\n", slave), ":5:17: warning: watch_time 500 ms" + lost);
    EXPECT_EQ(warnings("    watch_time: 501 ms\n", slave), "");
    EXPECT_EQ(warnings("    watch_time: 500 ms\n    watch: application\n", slave), "");
    EXPECT_EQ(warnings("    watch_time: 500 ms\n    watch: twice_producer\n", slave), "");
    // Given a node slot in which a cycle of 1 ms and the frames of 125 kbit/s do not fit
    EXPECT_EQ(
        warnings("    priority: 1\n    node_slot: 7 ms\n", slave),
        ":6:16: warning: node_slot 7 ms: with a cycle of 1 ms and 125 kbit/s a failover may take longer than computed, "
        "expected at least 8 ms|");
    EXPECT_EQ(warnings("    node_slot: 8 ms\n", slave), "");
    // Given standbys that race whenever the master sends its cyclic message
    EXPECT_EQ(warnings("    cyclic: negotiation\n    standby: races\n", slave),
              ":6:14: warning: standby races with cyclic negotiation: masters like this one elect without end, "
              "expected another "
              "word for one of them|");
    EXPECT_EQ(warnings("    standby: races\n", slave), "");
    // Given masters that hear of each other by 071h alone, and ignore it
    EXPECT_EQ(warnings("    cyclic: negotiation\n    claim_heard: ignores\n", slave),
              ":6:18: warning: claim_heard ignores with cyclic negotiation: two masters like this one never end, "
              "expected another "
              "word for one of them|");
    EXPECT_EQ(warnings("    claim_heard: ignores\n", slave), "");
}

TEST_F(NetworkFlyingTest, TheUsualWatchTimeIsWarnedOfWhereItCounts)
{
    Verifies(req::SRS_FLY_340);
    const auto count = [this](const std::string& slave)
    {
        const std::string file =
            File("net.yaml", "manager: {node: 2, heartbeat: 2 s, flying: {}}\nslaves: [{node: 9" + slave + "}]\n");
        return LoadedNetwork(runtime::ReadNetworkFile(file, 0U)).Warnings().size();
    };
    EXPECT_EQ(count(""), 1U);
    EXPECT_EQ(count(", consumer: 3 s"), 0U);
}
} // namespace
} // namespace counterpoint::tools
