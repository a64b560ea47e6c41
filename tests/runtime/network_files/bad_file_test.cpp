// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Malformed network files: one precise line each, file:line, what is wrong, what was expected.
#include "canopen/cia306/text/input_error.hpp"
#include "canopen/network_plan/loaded_network.hpp"
#include "runtime/network_files/file.hpp"
#include "runtime/yaml/document.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/canopen/cia306/folder_of_files.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::tools
{
namespace
{
using cia306::test::Changed;
using cia306::test::ExampleText;

struct BadFile
{
    const char* text;
    const char* message; ///< Behind the name of the file.
};

constexpr BadFile kBadCpj[] = {
    {"", ":1:1: error: no section [Topology], expected a CPJ file of CiA 306-3"},
    {"[Net]\nNodes=1\n", ":2:1: error: no section [Topology], expected a CPJ file of CiA 306-3"},
    {"[Topology]\nNodes=1\nNode1Present=1\nNode1DCFName=sensor.dcf\n[Topology2]\nNodes=1\n",
     ":5:1: error: a second network [Topology2], expected one network a file"},
    {"[Topology]\nNode1Present=1\nNode1DCFName=sensor.dcf\n",
     ":1:1: error: no key Nodes in [Topology], expected Nodes=1"},
    {"[Topology]\nNodes=2\nNode1Present=1\nNode1DCFName=sensor.dcf\n",
     ":2:7: error: Nodes=2, and 1 nodes are present, expected equal numbers"},
    {"[Topology]\nNodes=1\nNode1Present=1\nNode1DCFName=sensor.dcf\nNode2Present=1\nNode2DCFName=manager.dcf\n",
     ":2:7: error: Nodes=1, and 2 nodes are present, expected equal numbers"},
    {"[Topology]\nNodes=1\nNode1Present=1\nNode1DCFName=sensor.dcf\nNode2Present\n",
     ":5:1: error: 'Node2Present' is no line of an EDS, expected [section], key=value or a comment that begins with "
     "';'"},
    {"[Topology]\nNodes=one\nNode1Present=1\nNode1DCFName=sensor.dcf\n",
     ":2:7: error: Nodes='one', expected a number from 0 to 127"},
    {"[Topology]\nNodes=1\nNode128Present=1\n",
     ":3:1: error: key 'Node128Present', expected a node-ID from 1 to 127 after Node"},
    {"[Topology]\nNodes=1\nNode0Present=1\n",
     ":3:1: error: key 'Node0Present', expected a node-ID from 1 to 127 after Node"},
    {"[Topology]\nNodes=1\nNode99999999999999999999Present=1\n",
     ":3:1: error: key 'Node99999999999999999999Present', expected a node-ID from 1 to 127 after Node"},
    {"[Topology]\nNodes=1\nNode1Present=2\nNode1DCFName=sensor.dcf\n",
     ":3:14: error: Node1Present='2', expected a number from 0 to 1"},
    {"[Topology]\nNodes=1\nNode1Present=1\n",
     ":3:14: error: node 1 is present and has no DCF, expected Node1DCFName=FILE"},
    {"[Topology]\nNodes=1\nNode1Present=1\nNode1DCFName=sensor.dcf\n",
     ":1:1: error: no node is the manager, expected CANopenManager=1 in [DeviceComissioning] of one DCF, or the option "
     "--node-id"},
    {"[Topology]\nNodes=1\nNode2Present=1\nNode2DCFName=manager.dcf\n",
     ":4:14: error: a network without slaves, expected at least one"},
    {"[Topology]\nNodes=2\nNode2Present=1\nNode2DCFName=manager.dcf\nNode3Present=1\nNode3DCFName=manager.dcf\n",
     ":6:14: error: a second manager, node 3 besides node 2, expected CANopenManager=1 in one DCF"},
    {"[Topology\nNodes=1\n", ":1:1: error: "},
};

constexpr BadFile kBadYaml[] = {
    {"", ":1:1: error: "},
    {"manager: {node: 127}\n", ":1:1: error: no key 'slaves', expected it here"},
    {"slaves: [{node: 1}]\n", ":1:1: error: no key 'manager', expected it here"},
    {"manager: {}\nslaves: [{node: 1}]\n", ": error: no node-ID of the manager, expected one from 1 to 127"},
    {"manager: {node: 0}\nslaves: [{node: 1}]\n", ":1:17: error: "},
    {"manager: {node: 128}\nslaves: [{node: 1}]\n", ":1:17: error: "},
    {"manager: {node: 127}\nslaves: []\n", ":1:10: error: a network without slaves, expected at least one"},
    {"manager: {node: 127}\nslaves: {node: 1}\n", ":2:9: error: "},
    {"manager: {node: 127}\nslaves: [{name: x}]\n", ":2:10: error: no key 'node', expected it here"},
    {"manager: {node: 127}\nslaves: [{node: 127}]\n",
     ":2:10: error: node 127 is the manager and a slave, expected different node-IDs"},
    {"manager: {node: 127}\nslaves: [{node: 1},\n {node: 1}]\n",
     ":3:2: error: node 1 a second time, expected each node once"},
    {"manager: {node: 127}\nslaves: [{node: 1, speed: 3}]\n",
     ":2:20: error: unknown key 'speed', expected node, name, dcf"},
    {"manager: {node: 127}\nslaves: [{node: 1, dcf: nobody.dcf}]\n", ":2:25: error: there is no file "},
    {"manager: {node: 127}\nslaves: [{node: 1, dcf: actuator.dcf}]\n",
     " is for node-ID 33, expected the DCF of node 1"},
    {"manager: {node: 127}\nslaves: [{node: 1, mandatory: yes}]\n", ":2:31: error: 'yes', expected one of true, false"},
    {"manager: {node: 127}\nslaves: [{node: 1, heartbeat: 100}]\n", ":2:31: error: "},
    {"manager: {node: 127}\nslaves: [{node: 1, heartbeat: 70 s}]\n",
     ":2:31: error: a time that its object cannot hold, expected whole milliseconds, at most 65535"},
    {"manager: {node: 127}\nslaves: [{node: 1, consumer: 100 us}]\n",
     ":2:30: error: a time that its object cannot hold, expected whole milliseconds, at most 65535"},
    {"manager: {node: 127}\nslaves: [{node: 1, arming: never}]\n",
     ":2:28: error: 'never', expected one of first_heartbeat, boot_up, immediately"},
    {"manager: {node: 127, start_up: 0x80}\nslaves: [{node: 1}]\n", ":1:32: error: "},
    {"manager: {node: 127, start_up: 0}\nslaves: [{node: 1}]\n",
     ":1:32: error: 0x0, expected bit 0: a manager is an NMT master"},
    {"manager: {node: 127, start_up: 0x22}\nslaves: [{node: 1}]\n",
     ":1:32: error: 0x22, expected bit 0: a manager is an NMT master"},
    {"manager: {node: 127, profile: codesys}\nslaves: [{node: 1}]\n",
     ":1:31: error: 'codesys', expected one of cia302, el6751, plc_designer"},
    {"manager: {node: 127, flying: {priority: 3}}\nslaves: [{node: 1}]\n", ":1:41: error: "},
    {"manager: {node: 127, sdo_timeout: 0 ms}\nslaves: [{node: 1}]\n", ":1:35: error: 0 ms, expected 1 ms to 1000 s"},
    {"manager: {node: 127, sdo_timeout: 4000 s}\nslaves: [{node: 1}]\n",
     ":1:35: error: 4000000 ms, expected 1 ms to 1000 s"},
    {"manager: {node: 127, sync: 999 us}\nslaves: [{node: 1}]\n",
     ":1:10: error: SYNC period (1006h) of 999 us, expected none, or at least 1000 us"},
    {"manager: {node: 127}\nslaves: [{node: 1, assignment: 0}]\n",
     ":2:32: error: 0x0, expected bit 0: a slave of the network"},
    {"manager: {node: 127}\nslaves: [{node: 1, dcf: .}]\n", " is a folder, expected a DCF"},
    {"manager: {node: 127, flying: {start: never}}\nslaves: [{node: 1}]\n",
     ":1:38: error: 'never', expected one of at_once, by_order"},
    {"manager: {node: 127, dcf: actuator.dcf}\nslaves: [{node: 1}]\n",
     " is for node-ID 33, expected the DCF of the manager, node 127"},
    {"manager: {node: 127, sdo_tries: 0}\nslaves: [{node: 1}]\n", ":1:33: error: "},
    {"manager: {node: 127}\nslaves: [{node: 1, guard_time: 100 ms}]\n",
     ":2:10: error: guard time 100 ms with retry factor 0, expected both above 0, or none"},
    {"manager: {node: 127}\nslaves: [{node: 1, assignment: 0x5, retry_factor: 3}]\n",
     ":2:10: error: guard time 0 ms with retry factor 3, expected both above 0, or none"},
    {"manager: {node: 127}\nslaves: [{node: 1, heartbeat: 500 ms, consumer: 500 ms}]\n",
     ":2:10: error: consumer time 500 ms of a heartbeat each 500 ms, expected a longer one"},
    {"manager: {node: 127}\nslaves: [{node: 1, heartbeat: 65535 ms}]\n",
     ":2:10: error: consumer time 65535 ms of a heartbeat each 65535 ms, expected a longer one"},
    {"manager: {node: 127}\nslaves: [{node: 1, write_safety: true}]\n",
     ":2:10: error: write_safety of node 1, which has no safety configuration, expected a DCF with an SRDO"},
    {"manager: {node: 127}\nslaves: [{node: 1, software: {update: false}}]\n",
     ":2:10: error: software of node 1 with nothing to compare, expected identification, date or time above 0"},
    {"manager: {node: 127}\nslaves: [{node: 1, software: {date: 1, update: true}}]\n",
     ":2:10: error: an update of the software of node 1 without a program, expected update: true and program: FILE"},
    {"manager: {node: 127}\nslaves: [{node: 1, software: {date: 1, program: sensor.dcf}}]\n",
     ":2:10: error: a program of node 1 that no update may load, expected update: true and program: FILE"},
    {"manager: {node: 127}\nslaves: [{node: 1, software: {date: 1, program: nobody.bin}}]\n",
     ":2:49: error: there is no file "},
    {"manager: {node: 127, node: 126}\nslaves: [{node: 1}]\n",
     ":1:22: error: key 'node' twice, expected each key once"},
    {"manager: {node: 127\n", ":"},
};

class BadNetworkTest : public cia306::test::FolderTest
{
  protected:
    BadNetworkTest()
    {
        static_cast<void>(File("sensor.dcf", ExampleText("sensor")));
        static_cast<void>(File("actuator.dcf", ExampleText("actuator")));
        static_cast<void>(
            File("manager.dcf", Changed(ExampleText("controller"), {{"CANopenManager=0", "CANopenManager=1"}})));
    }
    /// The one line that a person reads.
    static std::string Refusal(const std::string& path, const std::uint8_t manager = 0U)
    {
        try
        {
            const network_plan::LoadedNetwork net(runtime::ReadNetworkFile(path, manager));
        }
        catch (const cia306::InputError& error)
        {
            return error.what();
        }
        catch (const runtime::YamlError& error)
        {
            return error.what();
        }
        return "accepted";
    }
    void ExpectRefused(const std::string& name, const BadFile& bad)
    {
        const std::string path = File(name, bad.text);
        const std::string line = Refusal(path);
        EXPECT_EQ(line.rfind(path + ":", 0U), 0U) << bad.text << "\n" << line;
        EXPECT_NE(line.find(bad.message), std::string::npos) << bad.text << "\n" << line;
        EXPECT_NE(line.find(", expected "), std::string::npos) << bad.text << "\n" << line;
        EXPECT_EQ(line.find('\n'), std::string::npos) << line;
    }
};

TEST_F(BadNetworkTest, EachMalformedCpjHasItsLine)
{
    Verifies(req::SRS_NET_001);
    Verifies(req::SRS_NET_004);
    Verifies(req::SRS_NET_342);
    for (const BadFile& bad : kBadCpj)
    {
        ExpectRefused("net.cpj", bad);
    }
}

// Before, that slave was left out in a CPJ, and no longer verified before its start.
TEST_F(BadNetworkTest, ASlaveWithTheNodeIdOfTheCommandLineIsRefused)
{
    Verifies(req::SRS_NET_342);
    Verifies(req::SRS_NET_750);
    const std::string two = "[Topology]\nNodes=2\nNode1Present=1\nNode1DCFName=sensor.dcf\nNode33Present=1\n"
                            "Node33DCFName=actuator.dcf\n";
    const std::string cpj = File("net.cpj", two);
    EXPECT_EQ(Refusal(cpj, 33U), cpj + ":6:15: error: node 33 is the manager and a slave, expected different node-IDs");
    EXPECT_EQ(Refusal(cpj, 100U), "accepted");
    const std::string yaml = File("net.yaml", "manager: {node: 127}\nslaves: [{node: 33, dcf: actuator.dcf}]\n");
    EXPECT_EQ(Refusal(yaml, 33U),
              yaml + ":2:10: error: node 33 is the manager and a slave, expected different node-IDs");
    // With a manager in the file no slave takes its place
    const std::string three = File("net.cpj", "[Topology]\nNodes=3\nNode2Present=1\nNode2DCFName=manager.dcf\n" +
                                                  two.substr(two.find("Node1")));
    EXPECT_EQ(Refusal(three, 33U), three + ":4:14: error: node 2 is the manager by CANopenManager=1, and another "
                                           "node-ID is asked for, 33, expected node-ID 2, or CANopenManager=0");
    EXPECT_EQ(Refusal(three, 2U), "accepted");
}

TEST_F(BadNetworkTest, WhatACpjSaysBesideItsFormatIsTold)
{
    Verifies(req::SRS_NET_001);
    // Given a slip in a key, a node without its Present, a comment of another format and another section
    const std::string path = File(
        "net.cpj", "[Topology]\nNetNamme=x\nNodes=2\nNode1Present=1\nNode1DCFName=sensor.dcf\nNode1Refd=K1\n"
                   "Node2Present=1\nNode2DCFName=manager.dcf\n# three\nNode3Name=y\nNode3Presnt=1\n[Other]\na=1\n");
    // When it is read, then each is told with its line, and nothing else
    const network_plan::LoadedNetwork net(runtime::ReadNetworkFile(path, 0U));
    const std::vector<std::string> expected{
        path + ":9:1: warning: a comment with '#' is no part of CiA 306, expected ';'; it is ignored",
        path + ":12:1: warning: section [Other] is ignored, expected [Topology] alone",
        path + ":2:1: warning: key 'NetNamme' is ignored, expected NetName, Nodes, NodeNPresent, NodeNName or "
               "NodeNDCFName",
        path + ":11:1: warning: key 'Node3Presnt' is ignored, expected NetName, Nodes, NodeNPresent, NodeNName or "
               "NodeNDCFName",
        path + ":10:1: warning: node 3 without Node3Present is taken as absent, expected Node3Present=1 or 0"};
    EXPECT_EQ(net.Warnings(), expected);
    EXPECT_EQ(net.Slaves().size(), 1U);
}

TEST_F(BadNetworkTest, EachMalformedYamlHasItsLine)
{
    Verifies(req::SRS_NET_002);
    Verifies(req::SRS_NET_004);
    Verifies(req::SRS_NET_152);
    Verifies(req::SRS_NET_342);
    for (const BadFile& bad : kBadYaml)
    {
        ExpectRefused("net.yaml", bad);
    }
}

TEST_F(BadNetworkTest, ANumberThatMayBeOctalIsRefused)
{
    Verifies(req::SRS_NET_061);
    ExpectRefused("net.yaml",
                  {"manager: {node: 127}\nslaves: [{node: 010}]\n",
                   ":2:17: error: '010', expected a number from 1 to 127, without a zero before it: it may be "
                   "octal"});
    ExpectRefused("net.yaml", {"manager: {node: 127}\nslaves: [{node: 1, serial: 00}]\n",
                               ":2:28: error: '00', expected a number from 0 to 4294967295, without a zero before it"});
    // 0 alone and hexadecimal numbers mean one thing
    EXPECT_EQ(Refusal(File("net.yaml", "manager: {node: 127}\nslaves: [{node: 0x0A, serial: 0}]\n")), "accepted");
    // The longest heartbeat whose usual consumer time is above it
    EXPECT_EQ(Refusal(File("net.yaml", "manager: {node: 127}\nslaves: [{node: 1, heartbeat: 65534 ms}]\n")),
              "accepted");
}

// Given signed DCFs that each hold by themselves, then what they say differently of one pair of identifiers is told.
TEST_F(BadNetworkTest, SlavesWhoseSrdosContradictEachOtherAreTold)
{
    Verifies(req::SRS_NET_060);
    const auto warnings = [this](const std::string& slaves)
    {
        const std::string path = File("net.yaml", "manager: {node: 127}\nslaves: [" + slaves + "]\n");
        return network_plan::LoadedNetwork(runtime::ReadNetworkFile(path, 0U)).Warnings();
    };
    static_cast<void>(File("controller.dcf", ExampleText("controller")));
    const std::string chain = "{node: 1, dcf: sensor.dcf}, {node: 2, dcf: controller.dcf}, ";
    EXPECT_EQ(warnings(chain + "{node: 33, dcf: actuator.dcf}"), (std::vector<std::string>{}));
    // A copied DCF, signed for its node-ID
    const std::string copy =
        File("copy.dcf", Changed(ExampleText("sensor"), {{"NodeID=1\n", "NodeID=3\n"}, {"0x66596575", "0x570CC1BD"}}));
    EXPECT_EQ(
        warnings("{node: 1, dcf: sensor.dcf}, {node: 3, dcf: copy.dcf}"),
        (std::vector<std::string>{copy + ":206:16: warning: 0x1301:01: sends 0x101 and 0x102, which node 1 SRDO 1 "
                                         "sends, too, expected one producer"}));
    // One that is not declared valid may be at any time
    const std::string off =
        File("copy.dcf", Changed(ExampleText("sensor"), {{"NodeID=1\n", "NodeID=3\n"},
                                                         {"0x66596575", "0x570CC1BD"},
                                                         {"ParameterValue=0xA5", "ParameterValue=0x00"}}));
    const std::vector<std::string> both = warnings("{node: 1, dcf: sensor.dcf}, {node: 3, dcf: copy.dcf}");
    ASSERT_EQ(both.size(), 2U);
    EXPECT_EQ(both[1].rfind(off + ":206:16: warning: 0x1301:01: sends 0x101 and 0x102", 0U), 0U) << both[1];
    // An SCT as long as the refresh time, and fewer bits
    const std::string late = File(
        "late.dcf",
        Changed(ExampleText("actuator"),
                {{"DefaultValue=50\nParameterValue=50", "DefaultValue=50\nParameterValue=25"}, {"0x9FCB", "0x07D8"}}));
    EXPECT_EQ(
        warnings(chain + "{node: 33, dcf: late.dcf}"),
        (std::vector<std::string>{late + ":215:16: warning: 0x1301:02: SCT 25 ms, while node 2 SRDO 2 has a refresh "
                                         "time of 25 ms, expected an SCT above it"}));
    const std::string few =
        File("few.dcf",
             Changed(ExampleText("actuator"), {{"ParameterValue=4\n", "ParameterValue=2\n"}, {"0x9FCB", "0xE4D3"}}));
    EXPECT_EQ(
        warnings(chain + "{node: 33, dcf: few.dcf}"),
        (std::vector<std::string>{few + ":264:16: warning: 0x1381:00: 8 bits mapped, while node 2 SRDO 2 maps 16, "
                                        "expected the same length"}));
}

TEST_F(BadNetworkTest, AFileThatIsNotThereOrADcfThatIsNone)
{
    Verifies(req::SRS_NET_004);
    EXPECT_EQ(Refusal(Path("nobody.cpj")).rfind(Path("nobody.cpj") + ": error: there is no file ", 0U), 0U);
    EXPECT_EQ(Refusal(Path("nobody.yaml")).rfind(Path("nobody.yaml") + ": error: there is no file ", 0U), 0U);
    EXPECT_EQ(Refusal("/dev/zero"), "/dev/zero: error: '/dev/zero' is no regular file, expected a network file, CPJ or "
                                    "YAML");
    const std::string large = File("large.yaml", std::string(1048577U, '#'));
    EXPECT_EQ(Refusal(large), large + ": error: a network file of 1048577 bytes, expected at most 1048576");
    // Where a DCF cannot be opened, the line that names it is told
    const std::string device = File("d.cpj", "[Topology]\nNodes=1\nNode1Present=1\nNode1DCFName=/dev/zero\n");
    EXPECT_EQ(Refusal(device), device + ":4:14: error: '/dev/zero' is no regular file, expected the DCF of node 1");
    static_cast<void>(File("bad.dcf", "[FileInfo\n"));
    const std::string file = File("net.yaml", "manager: {node: 127}\nslaves: [{node: 1, dcf: bad.dcf}]\n");
    EXPECT_EQ(Refusal(file).rfind(Path("bad.dcf") + ":1:1: error: ", 0U), 0U) << Refusal(file);
}

TEST_F(BadNetworkTest, ASafetyConfigurationThatBreaksARuleIsNoExpectation)
{
    Verifies(req::SRS_NET_004);
    // Given a DCF whose signature is not that of its parameters
    static_cast<void>(
        File("bad.dcf", Changed(ExampleText("sensor"), {{"ParameterValue=0xB631", "ParameterValue=0xB632"}})));
    const std::string file = File("net.yaml", "manager: {node: 127}\nslaves: [{node: 1, dcf: bad.dcf}]\n");
    EXPECT_EQ(Refusal(file), Path("bad.dcf") + ":309:16: error: 0x13FE:00: 0xA5 marks a configuration with errors as "
                                               "valid, expected 0x00 until all of them are repaired");
}
} // namespace
} // namespace counterpoint::tools
