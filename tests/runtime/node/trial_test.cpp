// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What a device refuses of its file, as `counterpoint check` finds it by trial.
#include "runtime/node/trial.hpp"

#include "canopen/cia306/file/device_reader.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/canopen/cia306/folder_of_files.hpp"
#include "verification/trace/ids/comfort.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <optional>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
namespace
{
using cia306::test::ExampleText;
using Findings = std::vector<std::string>;

std::string Number(const std::string& section, const std::string& type, const std::string& value,
                   const std::string& more = "")
{
    return "[" + section + "]\nParameterName=x\nObjectType=7\nAccessType=rw\nDataType=" + type +
           "\nDefaultValue=" + value + "\n" + more;
}

std::string RecordOf(const std::string& section)
{
    return "[" + section + "]\nParameterName=x\nObjectType=9\n";
}

const std::string kObjects = Number("1000", "7", "0") + Number("1001", "5", "0") +
                             Number("2000", "5", "1", "PDOMapping=1\n") + Number("2001", "5", "1") +
                             Number("2002", "1", "1") + Number("2003", "1", "1", "PDOMapping=1\n");
const std::string kNode = "[DeviceInfo]\nVendorName=test\n[DeviceComissioning]\nNodeID=5\n" + kObjects;

/// A PDO with one field: 14 and 16 receive, 18 and 1A send.
std::string Pdo(const std::string& kind, const std::string& map, const std::string& cob_id, const std::string& field)
{
    return RecordOf(kind) + Number(kind + "sub0", "5", "2") + Number(kind + "sub1", "7", cob_id) +
           Number(kind + "sub2", "5", "254") + RecordOf(map) + Number(map + "sub0", "5", "1") +
           Number(map + "sub1", "7", field);
}

class TrialTest : public cia306::test::FolderTest
{
  protected:
    [[nodiscard]] Findings Tried(const std::string& text, const std::optional<std::uint8_t> node_id = std::nullopt)
    {
        Findings lines;
        for (const cia306::Finding& finding : TryDevice(cia306::ReadDeviceFile(File("tried.dcf", text)), node_id))
        {
            lines.push_back((finding.severity == cia306::Severity::kError ? "error: " : "warning: ") + finding.object +
                            (finding.object.empty() ? "" : ": ") + finding.text);
        }
        return lines;
    }
    /// The first line of what is told of a field of a TPDO.
    [[nodiscard]] std::string OfField(const std::string& field)
    {
        for (const std::string& line : Tried(kNode + Pdo("1800", "1A00", "0x40000185", field)))
        {
            if (line.find("0x1A00:01: ") != std::string::npos)
            {
                return line.substr(line.find("expected ") + 9U);
            }
        }
        return "";
    }
};

TEST_F(TrialTest, SaysWhyAFieldOfAPdoIsNotMapped)
{
    Verifies(req::SRS_NODE_017);
    const auto unmappable = [](const std::string& object)
    { return "an object that may be mapped here, which " + object + " may not"; };
    EXPECT_EQ(OfField("0x20000008"), "");
    EXPECT_EQ(OfField("0x20000010"), "8 bit, the length of 0x2000:00");
    // No such object, no such sub-index, and one without PDOMapping
    EXPECT_EQ(OfField("0x29990008"), unmappable("0x2999:00"));
    EXPECT_EQ(OfField("0x20000108"), unmappable("0x2000:01"));
    EXPECT_EQ(OfField("0x20010008"), unmappable("0x2001:00"));
    // A BOOLEAN is a bit or a byte
    EXPECT_EQ(OfField("0x20030001"), "");
    EXPECT_EQ(OfField("0x20030008"), "");
    EXPECT_EQ(OfField("0x20030002"), "1 or 8 bit, the length of 0x2003:00");
    EXPECT_EQ(OfField("0x20020001"), unmappable("0x2002:00"));
    EXPECT_EQ(OfField("0x20020008"), unmappable("0x2002:00"));
}

TEST_F(TrialTest, NamesTheSubIndexThatAPdoDoesWithout)
{
    Verifies(req::SRS_NODE_017);
    // Given an RPDO with a field of another length
    EXPECT_EQ(
        Tried(kNode + Pdo("1400", "1600", "0x205", "0x20000010")),
        (Findings{"warning: 0x1400:01: the device has turned this PDO off, expected a mapping and settings that "
                  "hold",
                  "warning: 0x1600:00: the device does without this value, expected one that goes with the others",
                  "warning: 0x1600:01: the device does without this field of 16 bit, expected 8 bit, the length "
                  "of 0x2000:00"}));
}

TEST_F(TrialTest, NamesThePdoThatHasTheIdentifierOfAnotherOne)
{
    Verifies(req::SRS_NODE_017);
    // Given two RPDOs with one identifier, which they may have, then a TPDO with it
    const std::string both = Pdo("1400", "1600", "0x205", "0x20000008") + Pdo("1401", "1601", "0x205", "0x20000008");
    EXPECT_EQ(Tried(kNode + both), Findings{});
    EXPECT_EQ(Tried(kNode + both + Pdo("1800", "1A00", "0x40000205", "0x20000008")),
              (Findings{"warning: 0x1800:01: the device has turned this PDO off, expected another identifier than "
                        "0x205, which is that of 0x1400:01"}));
    // And an RPDO with the one of SYNC, another one before it
    EXPECT_EQ(Tried(kNode + Number("1005", "7", "0x240") + Pdo("1400", "1600", "0x205", "0x20000008") +
                    Pdo("1401", "1601", "0x240", "0x20000008")),
              (Findings{"warning: 0x1401:01: the device has turned this PDO off, expected another identifier than "
                        "0x240, which is that of 0x1005:00"}));
    EXPECT_EQ(Tried(kNode + Pdo("1400", "1600", "0x205", "0x20000008") + Pdo("1401", "1601", "0x80", "0x20000008")),
              (Findings{"warning: 0x1401:01: the device has turned this PDO off, expected another identifier than "
                        "0x080, which is that of SYNC"}));
}

// Both have their value from one line.
TEST_F(TrialTest, TellsEachRefusedValueOfACompactListOnce)
{
    Verifies(req::SRS_NODE_030);
    const std::string refused = ": the device refuses this value with abort code 0x06090030, expected another "
                                "identifier than 0x101, which is one of SRDOs";
    EXPECT_EQ(Tried(kNode + "[1201]\nParameterName=x\nObjectType=9\nDataType=7\nAccessType=rw\n"
                            "DefaultValue=0x101\nCompactSubObj=2\n"),
              (Findings{"warning: 0x1201:01" + refused, "warning: 0x1201:02" + refused}));
}

TEST_F(TrialTest, IsDoneWithTheNodeIdOfTheCommandLineOfTheFileOrAnyOther)
{
    Verifies(req::SRS_NODE_015);
    const std::string cob_id = Number("1014", "7", "$NODEID+0x80");
    EXPECT_EQ(Tried(kNode + cob_id), Findings{});
    EXPECT_EQ(Tried(kNode + cob_id, std::uint8_t{9U}), Findings{});
    // Of a file that names none
    EXPECT_EQ(Tried("[DeviceInfo]\nVendorName=test\n" + kObjects + cob_id), Findings{});
    EXPECT_EQ(Tried("[DeviceInfo]\nVendorName=test\nLSS_Supported=1\n" + kObjects + cob_id), Findings{});
}

TEST_F(TrialTest, HasAsManyControllersAsTheFile)
{
    Verifies(req::SRS_NODE_014);
    std::string text = ExampleText("sensor");
    const std::size_t port = text.find("ParameterValue=", text.find("[5F00sub10]\n"));
    text.replace(port, text.find('\n', port) - port, "ParameterValue=2");
    const std::size_t digest = text.find("ParameterValue=", text.find("[5F04]\n"));
    text.replace(digest, text.find('\n', digest) - digest, "ParameterValue=0");
    EXPECT_EQ(Tried(ExampleText("sensor")), Findings{});
    EXPECT_EQ(Tried(text), Findings{});
}

TEST_F(TrialTest, FindsWhatCannotBecomeADevice)
{
    Verifies(req::SRS_NODE_017);
    EXPECT_EQ(Tried(kNode + RecordOf("1800") + Number("1800sub1", "7", "0x185") + RecordOf("1A00") +
                    Number("1A00sub0", "5", "254")),
              (Findings{"error: 0x1A00:00 = 254, a multiplexed PDO, which is not built, expected a count of mapped "
                        "objects, 0 to 64"}));
}

// The tests take the tables of static mappings, too, and the smallest slices where there is much time.
TEST_F(TrialTest, TestsADeviceWithStaticMappingsAndOneWithMuchTime)
{
    Verifies(req::SRS_NODE_013);
    std::string text = ExampleText("sensor");
    const std::size_t interval = text.find("ParameterValue=", text.find("[5F00sub4]\n"));
    text.replace(interval, text.find('\n', interval) - interval, "ParameterValue=1000000");
    const std::size_t digest = text.find("ParameterValue=", text.find("[5F04]\n"));
    text.replace(digest, text.find('\n', digest) - digest, "ParameterValue=0");
    EXPECT_EQ(Tried(text), Findings{});
    EXPECT_EQ(Tried(cia306::test::FileText("static")), Findings{});
}

// Another program may do the same tests in less time: no error of the file.
TEST_F(TrialTest, WarnsOfAnIntervalThatIsTooShortForTheSelfTests)
{
    Verifies(req::SRS_NODE_013);
    std::string text = ExampleText("sensor");
    const std::size_t interval = text.find("ParameterValue=", text.find("[5F00sub4]\n"));
    text.replace(interval, text.find('\n', interval) - interval, "ParameterValue=60");
    const std::size_t digest = text.find("ParameterValue=", text.find("[5F04]\n"));
    text.replace(digest, text.find('\n', digest) - digest, "ParameterValue=0");
    const Findings told = Tried(text);
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(told[0].find("warning: the self tests do not fit into the diagnostic interval of "), 0U) << told[0];
    EXPECT_NE(told[0].find(" cycles, expected a longer one (0x5F00:04), or --no-self-tests"), std::string::npos)
        << told[0];
}
} // namespace
} // namespace counterpoint::runtime
