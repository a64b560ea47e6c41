// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// All masters of one network know the same network: what differs, and what of it does not go together.
#include "runtime/manager/check.hpp"
#include "runtime/network_files/file.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/canopen/cia306/folder_of_files.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/verifies.hpp"

#include <memory>
#include <string>
#include <vector>

namespace counterpoint::tools
{
namespace
{
using cia306::test::Changed;
using cia306::test::NetworkFile;

class MastersComparedTest : public cia306::test::FolderTest
{
  protected:
    /// Differences and warnings, a line each.
    struct Told
    {
        std::string out;
        std::string err;
    };
    static Told Check(const std::vector<std::string>& files)
    {
        std::vector<std::unique_ptr<network_plan::LoadedNetwork>> networks;
        std::vector<const network_plan::LoadedNetwork*> masters;
        for (const std::string& file : files)
        {
            networks.push_back(std::make_unique<network_plan::LoadedNetwork>(runtime::ReadNetworkFile(file, 0U)));
            masters.push_back(networks.back().get());
        }
        return {Joined(runtime::DifferencesOf(masters)), Joined(runtime::WarningsOf(masters))};
    }
    static std::string Joined(const std::vector<std::string>& lines)
    {
        std::string joined;
        for (const std::string& line : lines)
        {
            joined += line + "\n";
        }
        return joined;
    }
    /// Two masters, 2 and 5, of which each has the other one and these slaves.
    std::string Master(const std::string& node, const std::string& keys, const std::string& slaves)
    {
        const std::string other = (node == "2") ? "5" : "2";
        return File("master_" + node + ".yaml",
                    "manager: {node: " + node + ", heartbeat: 200 ms, flying: {}" + keys + "}\nslaves: [{node: " +
                        other + ", boot: false, mandatory: false, consumer: 500 ms}, " + slaves + "]\n");
    }
};

TEST_F(MastersComparedTest, MastersThatSuperviseInAnotherWayAreNamed)
{
    Verifies(req::SRS_MGR_009);
    // Given the same slave with the same consumer time, another heartbeat and another arming
    const auto network = [](const std::string& node, const std::string& other, const std::string& slave)
    {
        return "manager: {node: " + node + ", flying: {priority: 1}}\nslaves:\n  - {node: " + other +
               ", boot: false}\n  - {node: 96, configure: false, consumer: 500 ms, " + slave + "}\n";
    };
    const std::string two = File("two.yaml", network("2", "5", "heartbeat: 100 ms"));
    const std::string five = File("five.yaml", network("5", "2", "heartbeat: 200 ms, arming: boot_up"));
    const Told differs = Check({two, five});
    EXPECT_NE(differs.out.find(five + ":4: heartbeat (0x1017) of node 96 is 0xC8, expected 0x64 as in " + two + ":4\n"),
              std::string::npos)
        << differs.out;
    EXPECT_NE(differs.out.find(five + ":4: arming of node 96 is 0x2, expected 0x1 as in " + two + ":4\n"),
              std::string::npos)
        << differs.out;
}

TEST_F(MastersComparedTest, AllMastersOfANetworkAreCompared)
{
    Verifies(req::SRS_MGR_009);
    Verifies(req::SRS_MGR_153);
    const auto network = [this](const std::string& name, const std::string& manager, const std::string& slaves)
    { return File(name, "manager: {heartbeat: 200 ms, " + manager + "}\nslaves: [" + slaves + "]\n"); };
    const std::string two = network("two.yaml", "node: 2, flying: {priority: 0}", "{node: 5}, {node: 9}, {node: 96}");
    const std::string five = network("five.yaml", "node: 5, flying: {priority: 1}", "{node: 2}, {node: 96}");
    // Given a second and a third master with one node-ID, and a first one that lists a node in its place
    const std::string twin = network("twin.yaml", "node: 5, flying: {priority: 2}", "{node: 2}, {node: 9}, {node: 96}");
    const Told same = Check({two, five, twin});
    EXPECT_EQ(same.out, twin + ":1: node-ID of the manager is 5, expected another one than in the files before\n" +
                            five + ":1: no node 9, expected it as in " + two + ":2\n");
    // Given a third master that the second one does not know, that is no flying master, and whose slots overlap
    const std::string nine = network("nine.yaml", "node: 9, sdo_tries: 2", "{node: 2}, {node: 5}, {node: 96}");
    const std::string slots =
        network("slots.yaml", "node: 9, flying: {level_slot: 1270 ms}", "{node: 2}, {node: 5}, {node: 96}");
    const Told unknown = Check({two, five, nine});
    EXPECT_EQ(unknown.out, five + ":1: no node 9, expected the other master in the network list\n" + nine +
                               ":1: 0x1F80:00 is 0x1, expected bit 5: a flying master\n" + nine +
                               ":1: 0x1F80:00 is 0x1, expected 0x21 as in " + two + ":1\n" + nine +
                               ":1: sdo_tries is 0x2, expected 0x0 as in " + two + ":1\n");
    const Told overlap = Check({two, slots});
    EXPECT_EQ(overlap.out, slots +
                               ":1: 0x1F90:04 is 0x4F6 with 0x1F90:05 0xA, expected more than 127 times the latter, "
                               "which is above 0\n" +
                               slots + ":1: 0x1F90:04 is 0x4F6, expected 0x5DC as in " + two + ":1\n");
}

TEST_F(MastersComparedTest, WhatProfilesAndSafetyAskForIsCompared)
{
    Verifies(req::SRS_MGR_009);
    const auto network = [this](const std::string& name, const std::string& node, const std::string& other,
                                const std::string& slave, const std::string& times)
    {
        return File(name, "manager: {node: " + node + ", heartbeat: 200 ms, profile: el6751, flying: {}, el6751: {" +
                              times + "}}\nslaves: [{node: " + other +
                              "}, {node: 95, dcf: " + NetworkFile("slave.dcf") + slave + "}]\n");
    };
    const std::string two = network("two.yaml", "2", "5", ", write_safety: true", "input_shift: 500 us");
    const std::string five = network("five.yaml", "5", "2", ", el6751: {restart: by_hand}", "input_shift: 600 us");
    const Told differs = Check({two, five});
    EXPECT_EQ(differs.out, five + ":2: restart of node 95 is 0x1, expected 0x0 as in " + two + ":2\n" + five +
                               ":1: el6751 input_shift is 0x258, expected 0x1F4 as in " + two + ":1\n" + five +
                               ":2: write_safety of node 95 is 0x0, expected 0x1 as in " + two + ":2\n");
}

/// Everything that two files can say differently, one key a line.
TEST_F(MastersComparedTest, EachKeyIsComparedAndNamedAtItsLine)
{
    Verifies(req::SRS_MGR_009);
    const std::string manager = "manager:\n  node: 2\n  heartbeat: 200 ms\n";
    const std::string flying = "  flying:\n    priority: 0\n";
    const std::string slaves = "slaves:\n  - {node: 5, boot: false, mandatory: false, consumer: 500 ms}\n"
                               "  - node: 96\n";
    const std::string first = File("first.yaml", manager + flying + slaves);
    const std::string other = "manager:\n  node: 5\n  heartbeat: 200 ms\n";
    const std::string others = "slaves:\n  - {node: 2, boot: false, mandatory: false, consumer: 500 ms}\n"
                               "  - node: 96\n";
    struct Case
    {
        const char* of_manager;
        const char* of_flying;
        const char* of_slave;
        const char* told; ///< FILE:LINE of the second file, without it; then as in the first one's line.
        const char* line;
    };
    const Case cases[] = {
        {"  start_up: 0x23\n", "", "", ":4: 0x1F80:00 is 0x23, expected 0x21", ":2"},
        {"  boot_time: 3 s\n", "", "", ":4: 0x1F89:00 is 0xBB8, expected 0x0", ":2"},
        {"  inhibit: 2 ms\n", "", "", ":4: 0x102A:00 is 0x14, expected 0x0", ":2"},
        {"  sync: 10 ms\n", "", "", ":4: 0x1006:00 is 0x2710, expected 0x0", ":2"},
        {"  sdo_timeout: 90 ms\n", "", "", ":4: sdo_timeout is 0x5A, expected 0x0", ":2"},
        {"", "    timeout: 90 ms\n", "", ":6: 0x1F90:01 is 0x5A, expected 0x64", ":4"},
        {"", "    delay: 90 ms\n", "", ":6: 0x1F90:02 is 0x5A, expected 0x1F4", ":4"},
        {"", "    level_slot: 2 s\n", "", ":6: 0x1F90:04 is 0x7D0, expected 0x5DC", ":4"},
        {"", "    node_slot: 9 ms\n", "", ":6: 0x1F90:05 is 0x9, expected 0xA", ":4"},
        {"", "", "    assignment: 0x07\n", ":9: 0x1F81:60 is 0x7, expected 0xD", ":8"},
        {"", "", "    device_type: 9\n", ":9: 0x1F84:60 is 0x9, expected 0x0", ":8"},
        {"", "", "    vendor_id: 9\n", ":9: 0x1F85:60 is 0x9, expected 0x0", ":8"},
        {"", "", "    product_code: 9\n", ":9: 0x1F86:60 is 0x9, expected 0x0", ":8"},
        {"", "", "    revision: 9\n", ":9: 0x1F87:60 is 0x9, expected 0x0", ":8"},
        {"", "", "    serial: 9\n", ":9: 0x1F88:60 is 0x9, expected 0x0", ":8"},
        {"", "", "    date: 9\n", ":9: 0x1F26:60 is 0x9, expected 0x0", ":8"},
        {"", "", "    time: 9\n", ":9: 0x1F27:60 is 0x9, expected 0x0", ":8"},
        {"", "", "    consumer: 9 ms\n", ":9: heartbeat consumer (0x1016) of node 96 is 0x9, expected 0x0", ":8"},
        {"", "", "    arming: boot_up\n", ":9: arming of node 96 is 0x2, expected 0x1", ":8"},
    };
    for (const Case& one : cases)
    {
        const std::string second = File("second.yaml", other + one.of_manager + "  flying:\n    priority: 2\n" +
                                                           one.of_flying + others + one.of_slave);
        const Told differs = Check({first, second});
        EXPECT_EQ(differs.out, second + one.told + " as in " + first + one.line + "\n");
    }
    // Given other times that each master may have for itself, nothing is told
    const std::string own = File("own.yaml", other +
                                                 "  flying: {priority: 1, detect: 9 s, restarts: 1, watch_time: "
                                                 "900 ms, preset: so1114}\n" +
                                                 others);
    const Told equal = Check({first, own});
    EXPECT_EQ(equal.out, "");
}

TEST_F(MastersComparedTest, EachObjectOfASafetyExpectationIsCompared)
{
    Verifies(req::SRS_MGR_009);
    // Given two masters that know another SCT, and so another signature, of one relay
    const std::string actuator = cia306::test::ExampleText("actuator");
    static_cast<void>(File("relay.dcf", actuator));
    static_cast<void>(File(
        "late.dcf", Changed(actuator, {{"DefaultValue=50\nParameterValue=50", "DefaultValue=50\nParameterValue=25"},
                                       {"0x9FCB", "0x07D8"}})));
    const auto network = [this](const std::string& node, const std::string& other, const std::string& dcf)
    {
        return File("net_" + node + ".yaml",
                    "manager: {node: " + node + ", heartbeat: 200 ms, flying: {priority: 1}}\nslaves: [{node: " +
                        other + ", boot: false, mandatory: false, consumer: 500 ms}, {node: 33, dcf: " + dcf + "}]\n");
    };
    const std::string two = network("2", "5", "relay.dcf");
    const std::string five = network("5", "2", "late.dcf");
    const Told differs = Check({two, five});
    EXPECT_NE(differs.out.find("0x1301:02 of node 33 (safety) is 0x19, expected 0x32"), std::string::npos)
        << differs.out;
    EXPECT_NE(differs.out.find("0x13FF:01 of node 33 (safety) is 0x7D8, expected 0x9FCB"), std::string::npos)
        << differs.out;
    EXPECT_EQ(differs.out.find("0x1301:03"), std::string::npos) << differs.out;
}

TEST_F(MastersComparedTest, OutputsAndProfilesAreCompared)
{
    Verifies(req::SRS_MGR_009);
    const auto network = [this](const std::string& name, const std::string& manager, const std::string& other,
                                const std::string& outputs)
    {
        return File(name, "manager: {heartbeat: 200 ms, sync: 10 ms, flying: {}, " + manager +
                              "}\nslaves:\n  - {node: " + other +
                              "}\n  - node: 5\n    dcf: " + NetworkFile("managed_faults/io.dcf") + "\n" + outputs);
    };
    const std::string two =
        network("two.yaml", "node: 2, profile: el6751", "3", "    outputs: [{pdo: 1, data: \"00\"}]\n");
    // Given outputs of zeros that are said in one file only, and others
    const Told equal = Check({two, network("none.yaml", "node: 3, profile: el6751", "2", "")});
    EXPECT_EQ(equal.out, "");
    const std::string three =
        network("three.yaml", "node: 3, profile: el6751", "2", "    outputs: [{pdo: 1, data: \"02\"}]\n");
    const Told differs = Check({two, three});
    EXPECT_EQ(differs.out, three + ":6: output of RxPDO 1 of node 5 is 02, expected zeros as in " + two + ":6\n");
    // Given another profile
    const std::string plc = network("plc.yaml", "node: 3, profile: plc_designer", "2", "");
    const Told other = Check({two, plc});
    EXPECT_NE(other.out.find(plc + ":1: profile is plc_designer, expected el6751 as in " + two + ":1\n"),
              std::string::npos)
        << other.out;
}

TEST_F(MastersComparedTest, WhatDoesNotWorkTogetherIsNamed)
{
    Verifies(req::SRS_MGR_153);
    Verifies(req::SRS_MGR_154);
    const auto network = [this](const std::string& name, const std::string& text, const std::string& slave)
    { return File(name, "manager:\n  heartbeat: 800 ms\n" + text + "slaves:\n  - {" + slave + "}\n  - node: 96\n"); };
    // Given a master that is watched by 600 ms, by 700 ms, or by nobody, though its heartbeat comes each 800 ms
    const std::string two = network("two.yaml", "  node: 2\n  flying:\n    cyclic: negotiation\n",
                                    "node: 5, boot: false, mandatory: false");
    const std::string by_entry = network("five.yaml", "  node: 5\n  flying: {}\n", "node: 2, consumer: 600 ms");
    const std::string by_time =
        network("time.yaml", "  node: 5\n  flying:\n    watch_time: 700 ms\n    standby: races\n", "node: 2");
    const std::string by_none = network("none.yaml", "  node: 5\n  flying: {preset: so1114}\n", "node: 2");
    const Told entry = Check({two, by_entry});
    EXPECT_EQ(entry.out, by_entry +
                             ":6: master 2 is watched by 600 ms, expected more than the 800 ms of its heartbeat "
                             "in " +
                             two + ":2\n");
    const Told time = Check({two, by_time});
    EXPECT_EQ(time.out, by_time +
                            ":5: master 2 is watched by 700 ms, expected more than the 800 ms of its heartbeat "
                            "in " +
                            two + ":2\n" + by_time +
                            ":6: standby is races, expected ignores or asks beside cyclic negotiation of " + two +
                            ":5: such masters elect without end\n");
    const std::string deaf =
        network("deaf.yaml", "  node: 5\n  flying:\n    cyclic: negotiation\n    claim_heard: ignores\n",
                "node: 2, boot: false, mandatory: false, consumer: 900 ms");
    const Told never = Check({two, deaf});
    EXPECT_EQ(never.out, deaf + ":6: claim_heard is ignores, expected compares beside cyclic negotiation of " + two +
                             ":5: two such masters never end\n");
    // And 076h of the one that ignores 071h ends it
    const std::string forces = network("forces.yaml", "  node: 5\n  flying:\n    claim_heard: ignores\n",
                                       "node: 2, boot: false, mandatory: false, consumer: 900 ms");
    EXPECT_EQ(Check({two, forces}).out.find("claim_heard"), std::string::npos);
    // Then what may be meant is a warning
    const Told none = Check({two, by_none});
    EXPECT_EQ(none.out, "");
    EXPECT_EQ(none.err, by_none +
                            ":6: master 2 is a mandatory slave: when it fails, the start-up of this one does not "
                            "end before it is back\n" +
                            by_none + ":6: nobody watches master 2: when it fails, this one stays slave\n");
}

TEST_F(MastersComparedTest, WhatTheEl6751ProfileSendsIsCompared)
{
    Verifies(req::SRS_MGR_009);
    const auto network =
        [this](const std::string& name, const std::string& node, const std::string& profile, const std::string& slave)
    {
        const std::string other = (node == "2") ? "5" : "2";
        return File(name, "manager: {node: " + node + ", heartbeat: 100 ms, flying: {}, " + profile +
                              "}\nslaves: [{node: " + other + "}, {node: 6, dcf: io.dcf" + slave + "}]\n");
    };
    std::string text = cia306::ReadTextFile(NetworkFile("managed_faults/io.dcf"));
    text.replace(text.find("NodeID=5"), 8U, "NodeID=6");
    static_cast<void>(File("io.dcf", text));
    const std::string el6751 = "profile: el6751, sync: 10 ms";
    const std::string two = network("two.yaml", "2", el6751, "");
    const std::string same = network("same.yaml", "5", el6751, ", outputs: [{pdo: 1, data: 00}]");
    const std::string five = network("five.yaml", "5", el6751, ", outputs: [{pdo: 1, data: A1}]");
    const std::string plc = network("plc.yaml", "5", "profile: plc_designer", "");
    EXPECT_EQ(Check({two, same}).out, "");
    const Told differs = Check({two, five});
    EXPECT_EQ(differs.out, five + ":2: output of RxPDO 1 of node 6 is A1, expected zeros as in " + two + ":2\n");
    // Profiles by name, once; the rows of one write what is a list for the other one
    const Told other = Check({two, plc});
    EXPECT_NE(other.out.find(plc + ":1: profile is plc_designer, expected el6751 as in " + two + ":1\n"),
              std::string::npos)
        << other.out;
    EXPECT_EQ(other.out.find("profile data"), std::string::npos) << other.out;
    EXPECT_NE(
        other.out.find(plc + ":2: 0x1F22:06 is 112 bytes with other contents, expected 0 bytes as in " + two + ":2\n"),
        std::string::npos)
        << other.out;
}

TEST_F(MastersComparedTest, WhatThePlcDesignerProfileSaysOfASlaveIsCompared)
{
    Verifies(req::SRS_MGR_009);
    const std::string profile = ", profile: plc_designer";
    const std::string two = Master("2", profile, "{node: 96, plc_designer: {optional: false, reset_node: true}}");
    const std::string five = Master("5", profile, "{node: 96, plc_designer: {optional: true, reset_node: false}}");
    EXPECT_EQ(Check({two, five}).out, five + ":2: optional of node 96 is 0x1, expected 0x0 as in " + two + ":2\n" +
                                          five + ":2: reset_node of node 96 is 0x0, expected 0x1 as in " + two +
                                          ":2\n");
    const std::string same = Master("5", profile, "{node: 96, plc_designer: {optional: false, reset_node: true}}");
    EXPECT_EQ(Check({two, same}).out, "");
}

TEST_F(MastersComparedTest, PdosOfTheEl6751ProfileAreComparedByTheirObjects)
{
    Verifies(req::SRS_MGR_009);
    // Given two masters that know another type of RxPDO 1 of one slave
    const std::string io = cia306::ReadTextFile(NetworkFile("managed_faults/io.dcf"));
    const std::string type =
        "[1400sub2]\nParameterName=Transmission type\nObjectType=0x7\nDataType=0x0005\nAccessType=rw\n"
        "DefaultValue=255\nParameterValue=";
    static_cast<void>(File("io.dcf", Changed(io, {{"NodeID=5", "NodeID=6"}})));
    static_cast<void>(File("other.dcf", Changed(io, {{"NodeID=5", "NodeID=6"}, {type + "1\n", type + "255\n"}})));
    const std::string profile = ", profile: el6751, sync: 10 ms";
    const std::string two = Master("2", profile, "{node: 6, dcf: io.dcf}");
    const std::string five = Master("5", profile, "{node: 6, dcf: other.dcf}");
    const std::string told = Check({two, five}).out;
    EXPECT_NE(told.find(five + ":2: 0x1400:02 of node 6 is 0xFF, expected 0x1 as in " + two + ":2\n"),
              std::string::npos)
        << told;
}

TEST_F(MastersComparedTest, AnExpectationThatOneMasterHasAloneIsNamed)
{
    Verifies(req::SRS_MGR_009);
    static_cast<void>(File("relay.dcf", cia306::test::ExampleText("actuator")));
    // Given a slave that is a safety slave to one of two masters
    const std::string with = Master("2", "", "{node: 33, dcf: relay.dcf}");
    const std::string without = Master("5", "", "{node: 33}");
    const std::string second = Check({with, without}).out;
    EXPECT_NE(
        second.find(without + ":2: 0x1301:02 of node 33 (safety) is absent, expected 0x32 as in " + with + ":2\n"),
        std::string::npos)
        << second;
    const std::string first = Check({without, with}).out;
    EXPECT_NE(first.find(with + ":2: 0x1301:02 of node 33 (safety) is 0x32, expected absent as in " + without + ":2\n"),
              std::string::npos)
        << first;
}

TEST_F(MastersComparedTest, AnotherProgramIsNamedByItsSize)
{
    Verifies(req::SRS_MGR_009);
    static_cast<void>(File("old.bin", "old"));
    static_cast<void>(File("new.bin", "newer"));
    const std::string two =
        Master("2", "", "{node: 96, software: {identification: 7, program: old.bin, update: true}}");
    const std::string five =
        Master("5", "", "{node: 96, software: {identification: 7, program: new.bin, update: true}}");
    EXPECT_EQ(Check({two, five}).out,
              five + ":2: 0x1F58:60 is 5 bytes with other contents, expected 3 bytes as in " + two + ":2\n");
}

// No reader lets such a level through, a plan of a program may have it.
TEST_F(MastersComparedTest, ALevelThatThereIsNotIsNamed)
{
    Verifies(req::SRS_MGR_009);
    network_plan::NetworkPlan plan = runtime::ReadNetworkFile(Master("2", "", "{node: 96}"), 0U);
    plan.manager.flying->priority = std::uint16_t{3U};
    const network_plan::LoadedNetwork two(plan);
    const network_plan::LoadedNetwork five(runtime::ReadNetworkFile(Master("5", "", "{node: 96}"), 0U));
    EXPECT_EQ(Joined(runtime::DifferencesOf({&two, &five})),
              Path("master_2.yaml") + ":1: 0x1F90:03 is 0x3, expected at most 0x2\n");
}

TEST_F(MastersComparedTest, AMasterThatIsNoneHasItsTimesComparedToo)
{
    Verifies(req::SRS_MGR_009);
    const auto network = [this](const std::string& name, const std::string& manager, const std::string& other)
    { return File(name, "manager: {heartbeat: 200 ms, " + manager + "}\nslaves: [{node: " + other + "}]\n"); };
    // Given times of the first one, and a second one that is no flying master: it has the usual ones
    const std::string two = network("two.yaml", "node: 2, flying: {timeout: 150 ms}", "5");
    const std::string five = network("five.yaml", "node: 5", "2");
    EXPECT_EQ(Check({two, five}).out, five + ":1: 0x1F80:00 is 0x1, expected bit 5: a flying master\n" + five +
                                          ":1: 0x1F90:01 is 0x64, expected 0x96 as in " + two + ":1\n" + five +
                                          ":1: 0x1F80:00 is 0x1, expected 0x21 as in " + two + ":1\n");
}

TEST_F(MastersComparedTest, AWatchOfTwiceTheOwnHeartbeatIsOneWhereThereIsAHeartbeat)
{
    Verifies(req::SRS_MGR_153);
    const auto network = [this](const std::string& node, const std::string& keys, const std::string& watch)
    {
        return File("net_" + node + ".yaml",
                    "manager:\n  node: " + node + "\n" + keys + "  flying:\n    watch: " + watch +
                        "\nslaves:\n  - {node: " + (node == "2" ? "5" : "2") + ", boot: false, mandatory: false}\n");
    };
    const std::string two = network("2", "  heartbeat: 800 ms\n", "application");
    // Given 2 x 400 ms, which is not more than the 800 ms of the other one
    const std::string at_once = network("5", "  heartbeat: 400 ms\n", "twice_producer");
    EXPECT_EQ(Check({two, at_once}).out, at_once +
                                             ":4: master 2 is watched by 800 ms, expected more than the 800 ms of its "
                                             "heartbeat in " +
                                             two + ":3\n");
    EXPECT_EQ(Check({two, network("5", "  heartbeat: 401 ms\n", "twice_producer")}).out, "");
    // And 1500 ms where it sends none
    EXPECT_EQ(Check({two, network("5", "", "twice_producer")}).out, "");
}

TEST_F(MastersComparedTest, WhatAllMastersAreWarnedOfIsToldOnce)
{
    Verifies(req::SRS_MGR_154);
    static_cast<void>(File(
        "relay.dcf", Changed(cia306::test::ExampleText("actuator"), {{"ParameterValue=0xA5", "ParameterValue=0x00"}})));
    const std::string two = Master("2", "", "{node: 33, dcf: relay.dcf}");
    const std::string five = Master("5", "", "{node: 33, dcf: relay.dcf}");
    EXPECT_EQ(Check({two, five}).err,
              Path("relay.dcf") +
                  ":309:16: warning: 0x13FE:00: 0x00 keeps node 33 from being started until somebody "
                  "declares its configuration valid, expected 0xA5, or write_safety: true in the network "
                  "file\n");
}

TEST_F(MastersComparedTest, ASlaveThatOneMasterDoesNotHaveIsNamedAtBoth)
{
    Verifies(req::SRS_MGR_009);
    const std::string two = Master("2", "", "{node: 96}");
    const std::string five = Master("5", "", "{node: 95}");
    EXPECT_EQ(Check({two, five}).out, two + ":1: no node 95, expected it as in " + five + ":2\n" + five +
                                          ":1: no node 96, expected it as in " + two + ":2\n");
}

TEST_F(MastersComparedTest, APermissionToWriteThatTheSecondMasterHasAloneIsNamed)
{
    Verifies(req::SRS_MGR_009);
    static_cast<void>(File("relay.dcf", cia306::test::ExampleText("actuator")));
    const std::string two = Master("2", "", "{node: 33, dcf: relay.dcf}");
    const std::string five = Master("5", "", "{node: 33, dcf: relay.dcf, write_safety: true}");
    EXPECT_EQ(Check({two, five}).out, five + ":2: write_safety of node 33 is 0x1, expected 0x0 as in " + two + ":2\n");
}

TEST_F(MastersComparedTest, WhatIsSaidToEndlessElectionsDependsOnBothMasters)
{
    Verifies(req::SRS_MGR_153);
    const auto network = [this](const std::string& node, const std::string& flying)
    {
        return File("net_" + node + ".yaml", "manager: {node: " + node + ", heartbeat: 200 ms, flying: {" + flying +
                                                 "}}\nslaves: [{node: " + (node == "2" ? "5" : "2") +
                                                 ", boot: false, mandatory: false, consumer: 500 ms}]\n");
    };
    // Given a master that ignores 071h, or whose standby races, beside one that sends 076h
    const std::string two = network("2", "cyclic: force");
    EXPECT_EQ(Check({two, network("5", "claim_heard: ignores")}).out, "");
    EXPECT_EQ(Check({two, network("5", "standby: races")}).out, "");
    const std::string cyclic = network("2", "cyclic: negotiation");
    const std::string races = network("5", "standby: races");
    EXPECT_EQ(Check({cyclic, races}).out,
              races +
                  ":1: standby is races, expected ignores or asks beside cyclic negotiation "
                  "of " +
                  cyclic + ":1: such masters elect without end\n");
}
} // namespace
} // namespace counterpoint::tools
