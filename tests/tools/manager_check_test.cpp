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
             {"manager", "--can", "udp:239.74.163.91:43191", "--network", network, "--log", network}})
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

} // namespace
} // namespace counterpoint::tools
