// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// manager --check: all masters of one network know the same network.
#include "canopen/cia306/text/text_file.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/tools/command_run.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::tools
{
namespace
{
using cia306::test::Changed;
using cia306::test::NetworkFile;
using test::Answer;
using test::RunCommand;

class ManagerCheckTest : public test::CommandTest
{
  protected:
    /// Two masters that know the relay, as changed, with more keys of it.
    Answer CheckRelay(const std::string& more, const std::vector<cia306::test::Change>& changes)
    {
        static_cast<void>(File("relay.dcf", Changed(cia306::test::ExampleText("actuator"), changes)));
        std::vector<std::string> words{"manager", "--check"};
        for (const char* const node : {"2", "5"})
        {
            const std::string other = (std::string(node) == "2") ? "5" : "2";
            words.push_back(File("net_" + other + ".yaml", "manager: {node: " + std::string(node) +
                                                               ", heartbeat: 200 ms, flying: {priority: 1}}\nslaves: "
                                                               "[{node: " +
                                                               other +
                                                               ", boot: false, mandatory: false, consumer: 500 ms}, "
                                                               "{node: 33, dcf: relay.dcf" +
                                                               more + "}]\n"));
        }
        return RunCommand(words);
    }
};

TEST_F(ManagerCheckTest, EqualMastersPassOthersAreNamed)
{
    Verifies(req::SRS_MGR_009);
    Verifies(req::SRS_EDS_036);
    const Answer equal = RunCommand({"manager", "--check", NetworkFile("master_2.yaml"), NetworkFile("master_5.yaml")});
    EXPECT_EQ(equal.status, 0) << equal.out;
    EXPECT_EQ(equal.out, "");
    // Given a second master with another time-out, another slave and another expectation
    const std::string other =
        File("other.yaml", "manager: {node: 5, heartbeat: 200 ms, flying: {priority: 2, timeout: 150 ms}}\n"
                           "slaves:\n"
                           "  - {node: 2, boot: false, mandatory: false, consumer: 500 ms}\n"
                           "  - {node: 95, dcf: " +
                               NetworkFile("slave.dcf") + ", serial: 7}\n  - {node: 96}\n");
    const Answer differs = RunCommand({"manager", "--check", NetworkFile("master_2.yaml"), other});
    EXPECT_EQ(differs.status, 1);
    const std::string first = NetworkFile("master_2.yaml");
    // Then the key that decides is named in both files; where a value comes from the DCF, the key of that
    EXPECT_EQ(differs.out, other + ":1: 0x1F90:01 is 0x96, expected 0x64 as in " + first + ":2\n" + other +
                               ":4: 0x1F88:5F is 0x7, expected 0x21 as in " + first + ":5\n" + first +
                               ":2: no node 96, expected it as in " + other + ":5\n");
}

TEST_F(ManagerCheckTest, MastersThatSuperviseInAnotherWayAreNamed)
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
    const Answer differs = RunCommand({"manager", "--check", two, five});
    EXPECT_EQ(differs.status, 1);
    EXPECT_NE(differs.out.find(five + ":4: heartbeat (0x1017) of node 96 is 0xC8, expected 0x64 as in " + two + ":4\n"),
              std::string::npos)
        << differs.out;
    EXPECT_NE(differs.out.find(five + ":4: arming of node 96 is 0x2, expected 0x1 as in " + two + ":4\n"),
              std::string::npos)
        << differs.out;
}

TEST_F(ManagerCheckTest, AllMastersOfANetworkAreCompared)
{
    Verifies(req::SRS_MGR_009);
    Verifies(req::SRS_MGR_153);
    const auto network = [this](const std::string& name, const std::string& manager, const std::string& slaves)
    { return File(name, "manager: {heartbeat: 200 ms, " + manager + "}\nslaves: [" + slaves + "]\n"); };
    const std::string two = network("two.yaml", "node: 2, flying: {priority: 0}", "{node: 5}, {node: 9}, {node: 96}");
    const std::string five = network("five.yaml", "node: 5, flying: {priority: 1}", "{node: 2}, {node: 96}");
    // Given a second and a third master with one node-ID, and a first one that lists a node in its place
    const std::string twin = network("twin.yaml", "node: 5, flying: {priority: 2}", "{node: 2}, {node: 9}, {node: 96}");
    const Answer same = RunCommand({"manager", "--check", two, five, twin});
    EXPECT_EQ(same.status, 1);
    EXPECT_EQ(same.out, twin + ":1: node-ID of the manager is 5, expected another one than in the files before\n" +
                            five + ":1: no node 9, expected it as in " + two + ":2\n");
    // Given a third master that the second one does not know, that is no flying master, and whose slots overlap
    const std::string nine = network("nine.yaml", "node: 9, sdo_tries: 2", "{node: 2}, {node: 5}, {node: 96}");
    const std::string slots =
        network("slots.yaml", "node: 9, flying: {level_slot: 1270 ms}", "{node: 2}, {node: 5}, {node: 96}");
    const Answer unknown = RunCommand({"manager", "--check", two, five, nine});
    EXPECT_EQ(unknown.status, 1);
    EXPECT_EQ(unknown.out, five + ":1: no node 9, expected the other master in the network list\n" + nine +
                               ":1: 0x1F80:00 is 0x1, expected bit 5: a flying master\n" + nine +
                               ":1: 0x1F80:00 is 0x1, expected 0x21 as in " + two + ":1\n" + nine +
                               ":1: sdo_tries is 0x2, expected 0x0 as in " + two + ":1\n");
    const Answer overlap = RunCommand({"manager", "--check", two, slots});
    EXPECT_EQ(overlap.out, slots +
                               ":1: 0x1F90:04 is 0x4F6 with 0x1F90:05 0xA, expected more than 127 times the latter, "
                               "which is above 0\n" +
                               slots + ":1: 0x1F90:04 is 0x4F6, expected 0x5DC as in " + two + ":1\n");
}

TEST_F(ManagerCheckTest, WhatProfilesAndSafetyAskForIsCompared)
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
    const Answer differs = RunCommand({"manager", "--check", two, five});
    EXPECT_EQ(differs.status, 1) << differs.err;
    EXPECT_EQ(differs.out, five + ":2: restart of node 95 is 0x1, expected 0x0 as in " + two + ":2\n" + five +
                               ":1: el6751 input_shift is 0x258, expected 0x1F4 as in " + two + ":1\n" + five +
                               ":2: write_safety of node 95 is 0x0, expected 0x1 as in " + two + ":2\n");
}

/// Everything that two files can say differently, one key a line.
TEST_F(ManagerCheckTest, EachKeyIsComparedAndNamedAtItsLine)
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
        const Answer differs = RunCommand({"manager", "--check", first, second});
        EXPECT_EQ(differs.status, 1) << one.told;
        EXPECT_EQ(differs.out, second + one.told + " as in " + first + one.line + "\n");
    }
    // Given other times that each master may have for itself, nothing is told
    const std::string own = File("own.yaml", other +
                                                 "  flying: {priority: 1, detect: 9 s, restarts: 1, watch_time: "
                                                 "900 ms, preset: so1114}\n" +
                                                 others);
    const Answer equal = RunCommand({"manager", "--check", first, own});
    EXPECT_EQ(equal.status, 0) << equal.out;
}

TEST_F(ManagerCheckTest, EachObjectOfASafetyExpectationIsCompared)
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
    const Answer differs = RunCommand({"manager", "--check", two, five});
    EXPECT_EQ(differs.status, 1) << differs.err;
    EXPECT_NE(differs.out.find("0x1301:02 of node 33 (safety) is 0x19, expected 0x32"), std::string::npos)
        << differs.out;
    EXPECT_NE(differs.out.find("0x13FF:01 of node 33 (safety) is 0x7D8, expected 0x9FCB"), std::string::npos)
        << differs.out;
    EXPECT_EQ(differs.out.find("0x1301:03"), std::string::npos) << differs.out;
}

TEST_F(ManagerCheckTest, OutputsAndProfilesAreCompared)
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
    const Answer equal =
        RunCommand({"manager", "--check", two, network("none.yaml", "node: 3, profile: el6751", "2", "")});
    EXPECT_EQ(equal.status, 0) << equal.out << equal.err;
    const std::string three =
        network("three.yaml", "node: 3, profile: el6751", "2", "    outputs: [{pdo: 1, data: \"02\"}]\n");
    const Answer differs = RunCommand({"manager", "--check", two, three});
    EXPECT_EQ(differs.status, 1) << differs.err;
    EXPECT_EQ(differs.out, three + ":6: output of RxPDO 1 of node 5 is 02, expected zeros as in " + two + ":6\n");
    // Given another profile
    const std::string plc = network("plc.yaml", "node: 3, profile: plc_designer", "2", "");
    const Answer other = RunCommand({"manager", "--check", two, plc});
    EXPECT_NE(other.out.find(plc + ":1: profile is plc_designer, expected el6751 as in " + two + ":1\n"),
              std::string::npos)
        << other.out;
}

TEST_F(ManagerCheckTest, WhatDoesNotWorkTogetherIsNamed)
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
    const Answer entry = RunCommand({"manager", "--check", two, by_entry});
    EXPECT_EQ(entry.status, 1);
    EXPECT_EQ(entry.out, by_entry +
                             ":6: master 2 is watched by 600 ms, expected more than the 800 ms of its heartbeat "
                             "in " +
                             two + ":2\n");
    const Answer time = RunCommand({"manager", "--check", two, by_time});
    EXPECT_EQ(time.out, by_time +
                            ":5: master 2 is watched by 700 ms, expected more than the 800 ms of its heartbeat "
                            "in " +
                            two + ":2\n" + by_time +
                            ":6: standby is races, expected ignores or asks beside cyclic negotiation of " + two +
                            ":5: such masters elect without end\n");
    const std::string deaf =
        network("deaf.yaml", "  node: 5\n  flying:\n    cyclic: negotiation\n    claim_heard: ignores\n",
                "node: 2, boot: false, mandatory: false, consumer: 900 ms");
    const Answer never = RunCommand({"manager", "--check", two, deaf});
    EXPECT_EQ(never.out, deaf + ":6: claim_heard is ignores, expected compares beside cyclic negotiation of " + two +
                             ":5: two such masters never end\n");
    // And 076h of the one that ignores 071h ends it
    const std::string forces = network("forces.yaml", "  node: 5\n  flying:\n    claim_heard: ignores\n",
                                       "node: 2, boot: false, mandatory: false, consumer: 900 ms");
    EXPECT_EQ(RunCommand({"manager", "--check", two, forces}).out.find("claim_heard"), std::string::npos);
    // Then what may be meant is a warning
    const Answer none = RunCommand({"manager", "--check", two, by_none});
    EXPECT_EQ(none.status, 0) << none.out;
    EXPECT_EQ(none.err, by_none +
                            ":6: master 2 is a mandatory slave: when it fails, the start-up of this one does not "
                            "end before it is back\n" +
                            by_none + ":6: nobody watches master 2: when it fails, this one stays slave\n");
}

TEST_F(ManagerCheckTest, AnExpectationThatASafetySlaveCannotMeetIsTold)
{
    Verifies(req::SRS_NET_004);
    Verifies(req::SRS_NET_151);
    const std::string dcf = Path("relay.dcf");
    const std::vector<cia306::test::Change> invalid{{"ParameterValue=0xA5", "ParameterValue=0x00"}};
    const std::vector<cia306::test::Change> roomy{
        {"Highest sub-index supported\nObjectType=0x7\nDataType=0x0005\nAccessType=const\nDefaultValue=1\n"
         "PDOMapping=0\n\n[13FFsub1]",
         "Highest sub-index supported\nObjectType=0x7\nDataType=0x0005\nAccessType=const\nDefaultValue=3\n"
         "PDOMapping=0\n\n[13FFsub1]"}};
    // Each is told once, though both masters know the slave
    EXPECT_EQ(CheckRelay("", {}).err, "");
    EXPECT_EQ(CheckRelay("", invalid).err,
              dcf + ":309:16: warning: 0x13FE:00: 0x00 keeps node 33 from being started until "
                    "somebody declares its configuration "
                    "valid, expected 0xA5, or write_safety: true in the network file\n");
    EXPECT_EQ(CheckRelay("", invalid).status, 0);
    EXPECT_EQ(CheckRelay(", write_safety: true", invalid).err, "");
    EXPECT_EQ(CheckRelay("", roomy).err,
              dcf + ":322:14: warning: 0x13FF:00: room for 3 signatures, and the highest SRDO of "
                    "the file is 1: what node 33 has in "
                    "the others is not read, expected them in the file\n");
    // What is no configuration at all is refused
    const Answer unsigned_one = CheckRelay("", {{"ParameterValue=0x9FCB", "ParameterValue=0x9FCC"}});
    EXPECT_EQ(unsigned_one.status, 2);
    EXPECT_EQ(unsigned_one.err.rfind(dcf + ":309:16: error: 0x13FE:00: 0xA5 marks a configuration with errors", 0U), 0U)
        << unsigned_one.err;
    const Answer flagless =
        CheckRelay("", {{"7=0x13FE\n8=0x13FF", "7=0x13FF"},
                        {"[OptionalObjects]\nSupportedObjects=8", "[OptionalObjects]\nSupportedObjects=7"},
                        {"[13FE]\nParameterName=Configuration valid\nObjectType=0x7\nDataType=0x0005\n"
                         "AccessType=rw\nDefaultValue=0x00\nParameterValue=0xA5\nPDOMapping=0\n",
                         ""}});
    EXPECT_EQ(flagless.status, 2);
    EXPECT_NE(flagless.err.find(": error: 0x13FE:00: the configuration valid flag is missing"), std::string::npos)
        << flagless.err;
}

TEST_F(ManagerCheckTest, WhatSlavesCannotMeetIsToldWhenTheManagerRunsToo)
{
    Verifies(req::SRS_NET_060);
    Verifies(req::SRS_NET_151);
    const std::string sensor = cia306::test::ExampleText("sensor");
    const std::string own = File("sensor.dcf", sensor);
    const std::string copy =
        File("copy.dcf", Changed(sensor, {{"NodeID=1\n", "NodeID=3\n"}, {"0x66596575", "0x570CC1BD"}}));
    const std::string relay = File(
        "relay.dcf", Changed(cia306::test::ExampleText("actuator"), {{"ParameterValue=0xA5", "ParameterValue=0"}}));
    const std::string network =
        File("net.yaml", "manager: {node: 127}\nslaves: [{node: 1, dcf: sensor.dcf}, {node: 3, dcf: copy.dcf}, "
                         "{node: 33, dcf: relay.dcf}]\n");
    const std::string pair = copy + ":206:16: warning: 0x1301:01: sends 0x101 and 0x102, which node 1 SRDO 1 sends, "
                                    "too, expected one producer\n";
    const std::string flag = relay + ":309:16: warning: 0x13FE:00: ";
    // Given a check, and a run that ends before the bus is opened
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"manager", "--check", network, File("other.yaml", "manager: {node: 126}\nslaves: [{node: 127}]\n")},
             {"manager", "--can", "udp:239.74.163.91:43191", "--network", network, "--log", ""}})
    {
        const Answer answer = RunCommand(words);
        EXPECT_NE(answer.err.find(pair), std::string::npos) << words[1] << answer.err;
        EXPECT_NE(answer.err.find(flag), std::string::npos) << words[1] << answer.err;
    }
}

TEST_F(ManagerCheckTest, AnEmergencyOfASafetySlaveThatIsNotHeardOrNotKnownIsTold)
{
    Verifies(req::SRS_NET_151);
    const std::string dcf = Path("relay.dcf");
    // What is switched off
    EXPECT_EQ(CheckRelay("", {{"DefaultValue=$NODEID+0x80", "DefaultValue=0x800000A1"}}).err,
              dcf + ":109:14: warning: 0x1014:00: 0x800000A1 switches off the emergencies of node 33, which counts as "
                    "good in its safe state, expected an identifier without bit 31\n");
    // An identifier of 29 bits, or with a reserved bit, is not heard
    for (const std::string identifier : {"0x200000A1", "0x400000A1", "0x00000800"})
    {
        EXPECT_EQ(CheckRelay("", {{"DefaultValue=$NODEID+0x80", "DefaultValue=" + identifier}}).err,
                  dcf + ":109:14: warning: 0x1014:00: " + identifier +
                      ": the emergencies of node 33 are not heard, and it counts as good in its safe state, expected "
                      "0x001 to 0x7FF\n");
    }
    // Nor is it known whose emergency it is where two slaves have one identifier, the usual one of node 34 here
    const std::vector<cia306::test::Change> taken{{"DefaultValue=$NODEID+0x80", "DefaultValue=0xA2"}};
    const auto told = [&](const std::string& net)
    {
        return dcf + ":109:14: warning: 0x1014:00: 0x0A2 of node 33 is that of node 34, too (" + Path(net) +
               ":2:98): whose emergencies come with it is not known, expected one for each\n";
    };
    EXPECT_EQ(CheckRelay("}, {node: 34", taken).err, told("net_5.yaml") + told("net_2.yaml"));
    EXPECT_EQ(CheckRelay("}, {node: 35", taken).err, "");
}

TEST_F(ManagerCheckTest, WhatTheEl6751ProfileSendsIsCompared)
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
    EXPECT_EQ(RunCommand({"manager", "--check", two, same}).status, 0);
    const Answer differs = RunCommand({"manager", "--check", two, five});
    EXPECT_EQ(differs.status, 1) << differs.err;
    EXPECT_EQ(differs.out, five + ":2: output of RxPDO 1 of node 6 is A1, expected zeros as in " + two + ":2\n");
    // Profiles by name, once; the rows of one write what is a list for the other one
    const Answer other = RunCommand({"manager", "--check", two, plc});
    EXPECT_NE(other.out.find(plc + ":1: profile is plc_designer, expected el6751 as in " + two + ":1\n"),
              std::string::npos)
        << other.out;
    EXPECT_EQ(other.out.find("profile data"), std::string::npos) << other.out;
    EXPECT_NE(
        other.out.find(plc + ":2: 0x1F22:06 is 112 bytes with other contents, expected 0 bytes as in " + two + ":2\n"),
        std::string::npos)
        << other.out;
}

} // namespace
} // namespace counterpoint::tools
