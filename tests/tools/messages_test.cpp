// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/cia306/check_text.hpp"
#include "tests/tools/command_run.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <regex>
#include <string>
#include <vector>

// One form of complaints about files, FILE:LINE:COLUMN: error|warning: WHAT, expected WHAT, whichever reader complains.
namespace counterpoint::tools
{
namespace
{
using cia306::test::Changed;
using cia306::test::ExampleText;
using test::Answer;
using test::RunCommand;

/// A file that is wrong, a command that reads it (FILE stands for its path), and the first thing that is said of it
/// behind the path.
struct Row
{
    std::vector<std::string> command;
    std::string name;
    std::string text;
    std::string said;
};

class MessagesTest : public test::CommandTest
{
  protected:
    /// What the command said, a line each.
    [[nodiscard]] std::vector<std::string> LinesOf(const Row& row) const
    {
        const std::string file = File(row.name, row.text);
        std::vector<std::string> command = row.command;
        for (std::string& word : command)
        {
            word = (word == "FILE") ? file : word;
        }
        const Answer answer = RunCommand(command);
        std::istringstream all(answer.err + answer.out);
        std::vector<std::string> lines;
        for (std::string line; std::getline(all, line);)
        {
            const bool is_complaint = line.rfind(file, 0U) == 0U;
            lines.insert(lines.end(), is_complaint ? 1U : 0U, is_complaint ? line.substr(file.size()) : "");
        }
        return lines;
    }

    void ExpectSaid(const std::vector<Row>& rows) const
    {
        const std::regex form("(:[0-9]+(:[0-9]+)?)?: (error: .+, expected .+|warning: .+)");
        for (const Row& row : rows)
        {
            const std::vector<std::string> lines = LinesOf(row);
            ASSERT_FALSE(lines.empty()) << row.name << " " << row.said;
            EXPECT_EQ(lines.front(), row.said);
            for (const std::string& line : lines)
            {
                EXPECT_TRUE(std::regex_match(line, form)) << line;
            }
        }
    }
};

std::string Sensor(const std::string& from, const std::string& to)
{
    return Changed(ExampleText("sensor"), {{from, to}});
}

TEST_F(MessagesTest, OfDeviceFiles)
{
    Verifies(req::SRS_EDS_036);
    Verifies(req::SRS_EDS_340);
    const std::string device = "[DeviceInfo]\nVendorName=x\n";
    const std::string object = "[1000]\nDataType=7\nAccessType=ro\n";
    const std::string no_info = ":1:1: warning: no section [DeviceInfo], expected one";
    ExpectSaid({
        {{"check", "FILE"},
         "a.dcf",
         "[1000]\n  DataType = door\n",
         ":2:14: error: 'DataType' is 'door', expected a number from 0 to 65535"},
        {{"sign", "FILE"},
         "a.dcf",
         "[1000]\n  DataType = door\n",
         ":2:14: error: 'DataType' is 'door', expected a number from 0 to 65535"},
        {{"generate", "FILE"},
         "a.dcf",
         "[1000\n",
         ":1:1: error: section '[1000' is not closed, expected ']' at its end"},
        {{"check", "FILE"}, "a.dcf", "[1000]\nDataType=7\n\x01", ":3:1: error: control byte 0x01, expected 8-bit text"},
        {{"check", "FILE"},
         "a.dcf",
         "\xEF\xBB\xBF k=1\n",
         ":1:2: error: key 'k' before the first section, expected a section such as [FileInfo] before it"},
        {{"check", "FILE"},
         "a.dcf",
         "[A]\n[B]\n\t[a]\n",
         ":3:2: error: section 'a' stands a second time, expected it once, as in line 1"},
        {{"check", "FILE"},
         "a.dcf",
         "[A]\nk=1\n K=1\n",
         ":3:2: error: key 'K' stands a second time in section 'A', expected it once, as in line 2"},
        {{"check", "FILE"}, "a.dcf", "", ":1:1: error: the file describes no object, expected sections such as [1000]"},
        {{"check", "FILE"}, "a.dcf", object, no_info},
        {{"check", "FILE"},
         "a.dcf",
         device + object + "[DeviceComissioning]\nNodeID=  0 ; none\n",
         ":1:1: warning: no SRDO, nothing of CANopen Safety is checked, expected communication parameters at 0x1301 to "
         "0x1340"},
        {{"check", "FILE"},
         "s.dcf",
         Sensor("ParameterValue=0xB631", "ParameterValue= 0xB632"),
         ":309:16: error: 0x13FE:00: 0xA5 marks a configuration with errors as valid, expected 0x00 until all of them "
         "are repaired"},
        {{"sign", "FILE"},
         "s.dcf",
         Sensor("ParameterValue=0x66596575", "ParameterValue=0"),
         ":627:16: warning: 0x5F04:00: no device digest; a wrong device parameter, 0x1300 included, is not found, "
         "expected the one that 'counterpoint sign' computes"},
    });
}

TEST_F(MessagesTest, DeviceWithoutNodeIdNamesEveryPlaceOfOne)
{
    Verifies(req::SRS_EDS_036);
    Verifies(req::SRS_EDS_340);
    const std::string file = File("s.dcf", Sensor("NodeID=1\n", ""));
    const std::string scenario = File("s.yaml", "title: s\nduration: 1 ms\nnodes:\n  s: {dcf: s.dcf}\n");
    EXPECT_EQ(RunCommand({"simulate", scenario}).err,
              file + ": error: no node-ID, expected NodeID in [DeviceComissioning], --node-id, or node_id in the "
                     "scenario\n");
}

TEST_F(MessagesTest, OfScenariosAndScripts)
{
    Verifies(req::SRS_EDS_036);
    Verifies(req::SRS_EDS_340);
    const std::string chain = cia306::test::SourceFolder() + "/examples/emergency_stop/chain.yaml";
    const std::string sensor = cia306::test::SourceFolder() + "/examples/emergency_stop/sensor.dcf";
    ExpectSaid({
        {{"simulate", "FILE"},
         "a.yaml",
         "title: x\nduration: 5\n",
         ":2:11: error: '5', expected a time with its unit such as 10 ms, 2.5 s or 100 us, at most 10000000 s"},
        {{"simulate", "FILE"},
         "a.yaml",
         "title: x\n\tnodes: 1\n",
         ":2:1: error: not YAML: illegal tab when looking for indentation, expected a YAML 1.2 document"},
        {{"simulate", "FILE"}, "a.yaml", "a: \xFF", ":1:4: error: byte 0xff, expected UTF-8 text"},
        {{"simulate", "FILE"},
         "a.yaml",
         "extends: " + chain + "\ninputs:\n  - {at: 9 s, node: sensor, object: 0x2000:01, value: 1}\n",
         ":3:5: error: input at 9000 ms, not before the end of the run, expected a time below 1000 ms"},
        {{"simulate", "FILE"},
         "a.yaml",
         "extends: " + chain + "\ninputs:\n  - {at: 9 ms, node: sensor, object: 0x2000:01, value: 300}\n",
         ":3:5: error: value 300 for object 0x2000:01, expected a value of 8 bits"},
        {{"simulate", "FILE"},
         "a.yaml",
         "extends: " + chain + "\ninputs:\n  - {at: 9 ms, node: sensor, object: 0x2999:01, value: 1}\n",
         ":3:5: error: object 0x2999:01 in " + sensor +
             ", expected a normal object that an SRDO of direction 1 is mapped to: 0x2000:01, 0x2000:02"},
        {{"simulate", "--quiet", "FILE"},
         "a.yaml",
         "extends: " + chain + "\nfaults:\n  - {fault: loss, frames: {identifier: 0x200}}\n",
         ":3:5: warning: fault 'loss' never happened, expected it within the run, or 'optional: true'"},
        {{"node", "--can", "udp:239.74.163.2:43113", "--dcf", sensor, "--store", "FILE"},
         "s.bin",
         "",
         ": error: the store has 0 bytes, expected two banks of 262144"},
        {{"node", "--can", "udp:239.74.163.2:43113", "--dcf", sensor, "--script", "FILE"},
         "s.yaml",
         "steps: [{at: 1 s, do: fly}]\n",
         ":1:23: error: 'fly' is no order, expected set, get, ack, gfc, nmt, state, read, write, time, help or quit"},
    });
}

// Which of two buses, and what kind of file
TEST_F(MessagesTest, NameTheOptionThatIsWrong)
{
    Verifies(req::SRS_NODE_051);
    const std::string sensor = cia306::test::SourceFolder() + "/examples/emergency_stop/sensor.dcf";
    const auto error = [&sensor](const std::string& first, const std::string& second)
    { return test::RunCommand({"node", "--can", first, "--can2", second, "--dcf", sensor}).err; };
    const std::string good = "udp:239.74.163.2:43113";
    EXPECT_EQ(error(good, "udp:1").rfind("counterpoint node: --can2: bus 'udp:1': ", 0U), 0U);
    EXPECT_EQ(error("udp:1", good).rfind("counterpoint node: --can: bus 'udp:1': ", 0U), 0U);
    EXPECT_EQ(error("udp:1", "udp:1").rfind("counterpoint node: --can: bus 'udp:1': ", 0U), 0U);
    EXPECT_EQ(test::RunCommand({"node", "--can", good, "--dcf", sensor, "--script", Path("none.yaml")}).err,
              Path("none.yaml") + ": error: no such file, expected a script of orders\n");
}

TEST_F(MessagesTest, OfNetworkFilesAndRecordings)
{
    Verifies(req::SRS_EDS_036);
    Verifies(req::SRS_EDS_340);
    const std::string sensor = cia306::test::SourceFolder() + "/examples/emergency_stop/sensor.dcf";
    const std::vector<std::string> manager{"manager", "--can", "udp:239.74.163.2:43113", "--network", "FILE"};
    const std::vector<std::string> monitor{"monitor", "FILE", "--dcf", sensor};
    ExpectSaid({
        {manager, "a.cpj", "[Topology]\nNodes=2 # two\nNode1Present=1\nNode1DCFName=none.dcf\n",
         ":4:14: error: there is no file '" + Path("none.dcf") + "', expected the DCF of node 1"},
        {manager, "a.cpj", "[Topology]\nNodes= two\n", ":2:8: error: Nodes='two', expected a number from 0 to 127"},
        {manager, "a.cpj", "[Topology]\n Node0Present=1\n",
         ":2:2: error: key 'Node0Present', expected a node-ID from 1 to 127 after Node"},
        {manager, "a.yaml", "manager: {node: 127}\nslaves: []\n",
         ":1:10: error: a network without slaves, expected at least one"},
        {manager, "a.yaml", "manager: {node: 0}\nslaves: [{node: 1}]\n",
         ":1:17: error: '0', expected a number from 1 to 127"},
        {manager, "a.yaml", "", ":1:1: error: no document, expected a map of keys and values"},
        {monitor, "a.log", "(1.000000) can0 101#1\n",
         ":1:21: error: line '(1.000000) can0 101#1', expected 0 to 8 bytes of two hexadecimal digits"},
        {monitor, "a.log", "\n(1.000000) can0 1xx#1\n",
         ":2:17: error: line '(1.000000) can0 1xx#1', expected an identifier of 3 or 8 hexadecimal digits"},
        {monitor, "a.log", "\x1F\x8B", ": error: it is compressed (gzip), expected the recording itself, unpacked"},
        {monitor, "a.pcap", "\xD4\xC3\xB2\xA1junk", ": error: file of 8 bytes, expected a pcap header of 24"},
    });
}
} // namespace
} // namespace counterpoint::tools
