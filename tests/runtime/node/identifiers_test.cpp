// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/file/device_reader.hpp"
#include "runtime/node/trial.hpp"
#include "tests/canopen/cia306/folder_of_files.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <optional>
#include <string>
#include <vector>

// Identifiers of the services of one file: each has its own.
namespace counterpoint::runtime
{
namespace
{
/// A section of a data element: its type by number, its access, its value.
std::string Element(const std::string& section, const char* const type, const char* const access,
                    const std::string& value)
{
    return "[" + section + "]\nDataType=" + type + "\nAccessType=" + access + "\nDefaultValue=" + value + "\n";
}

/// A section of a record.
std::string Record(const std::string& section)
{
    return "[" + section + "]\nObjectType=9\n";
}

const std::string kHead = "[DeviceInfo]\nVendorName=test\n[DeviceComissioning]\nNodeID=5\n" +
                          Element("1000", "7", "ro", "0") + Element("1001", "5", "ro", "0");

class IdentifiersTest : public cia306::test::FolderTest
{
  protected:
    /// What the device says of a file with these objects, each with its object.
    [[nodiscard]] std::vector<std::string> Tried(const std::string& objects)
    {
        std::vector<std::string> lines;
        const std::string file = File("tried.dcf", kHead + objects);
        for (const cia306::Finding& finding : TryDevice(cia306::ReadDeviceFile(file), std::nullopt))
        {
            lines.push_back(finding.object + ": " + finding.text);
        }
        return lines;
    }
};

// A SYNC would be read as an emergency, an emergency as a request of an SDO
TEST_F(IdentifiersTest, TwoServicesWithOneIdentifierAreToldWithTheNamesOfAll)
{
    Verifies(req::SRS_NODE_050);
    const auto shared = [](const char* const object, const char* const identifier, const std::string& owners)
    {
        return std::vector<std::string>{std::string(object) + ": COB-ID " + identifier + " is in use by " + owners +
                                        ", too, and the device keeps all, expected an identifier of its own"};
    };
    const auto element = [](const char* const index, const char* const value)
    { return Element(index, "7", "rw", value); };
    const auto pair = [&](const std::string& index, const char* const request, const char* const answer)
    { return Record(index) + element((index + "sub1").c_str(), request) + element((index + "sub2").c_str(), answer); };
    const std::string sync = element("1005", "0x240");
    const std::string time = element("1012", "0x80000240");
    const std::string emergency = element("1014", "0x240");
    EXPECT_EQ(Tried(sync + emergency), shared("0x1014:00", "0x240", "0x1005:00"));
    EXPECT_EQ(Tried(sync + time), shared("0x1012:00", "0x240", "0x1005:00"));
    EXPECT_EQ(Tried(time + emergency), shared("0x1014:00", "0x240", "0x1012:00"));
    EXPECT_EQ(Tried(emergency + pair("1201", "0x240", "0x241")), shared("0x1201:01", "0x240", "0x1014:00"));
    EXPECT_EQ(Tried(pair("1201", "0x250", "0x240") + pair("1280", "0x240", "0x251")),
              shared("0x1280:01", "0x240", "0x1201:02"));
    EXPECT_EQ(Tried(pair("1201", "0x240", "0x240")), shared("0x1201:02", "0x240", "0x1201:01"));
    EXPECT_EQ(Tried(sync + Record("1028") + element("1028sub1", "0x240")), shared("0x1028:01", "0x240", "0x1005:00"));
    // What the device has without an object
    EXPECT_EQ(Tried(element("1014", "0x80")), shared("0x1014:00", "0x080", "SYNC"));
    EXPECT_EQ(Tried(element("1005", "0x85")), shared("0x1005:00", "0x085", "the emergencies of this device"));
    EXPECT_EQ(Tried(pair("1280", "0x605", "0x586")),
              shared("0x1280:01", "0x605", "the default SDO server of this device"));
    // Three of them
    std::vector<std::string> both = shared("0x1012:00", "0x240", "0x1005:00");
    both.push_back(shared("0x1014:00", "0x240", "0x1005:00 and 0x1012:00").front());
    EXPECT_EQ(Tried(sync + time + emergency), both);
    // What is off has no identifier, and a list of all devices has this one, too
    for (const std::string& free :
         {sync + element("1014", "0x80"), sync + element("1014", "0x80000240"), sync + element("1012", "0x240"),
          Record("1028") + element("1028sub1", "0x85") + element("1014", "0x85"),
          Record("1028") + element("1028sub1", "0x85"), sync + pair("1201", "0x80000240", "0x80000240")})
    {
        EXPECT_EQ(Tried(free), std::vector<std::string>{}) << free;
    }
}

TEST_F(IdentifiersTest, ARefusedIdentifierIsToldWithWhoseItIs)
{
    Verifies(req::SRS_NODE_153);
    const auto refused = [](const char* const object, const std::string& expected)
    {
        return std::vector<std::string>{
            std::string(object) + ": the device refuses this value with abort code 0x06090030, expected " + expected};
    };
    struct Row
    {
        const char* identifier;
        const char* expected;
    };
    for (const Row& row : {Row{"0x000", "another identifier than 0x000, which is one of NMT and GFC"},
                           Row{"0x071", "another identifier than 0x071, which is one of NMT and GFC"},
                           Row{"0x101", "another identifier than 0x101, which is one of SRDOs"},
                           Row{"0x585", "another identifier than 0x585, which is one of the default SDOs"},
                           Row{"0x705", "another identifier than 0x705, which is one of error control and LSS"},
                           Row{"0x7E4", "another identifier than 0x7E4, which is one of error control and LSS"},
                           Row{"0x20000100", "an identifier of 11 bit"}})
    {
        EXPECT_EQ(Tried(Element("1014", "7", "rw", row.identifier)), refused("0x1014:00", row.expected));
        EXPECT_EQ(Tried(Element("1005", "7", "rw", row.identifier)), refused("0x1005:00", row.expected));
    }
    EXPECT_EQ(Tried(Record("1201") + Element("1201sub1", "7", "rw", "0x101") + Element("1201sub2", "7", "rw", "0x240")),
              refused("0x1201:01", "another identifier than 0x101, which is one of SRDOs"));
    // The identifier is free: it is something else
    EXPECT_EQ(Tried(Element("1014", "7", "rw", "0x40000240")), refused("0x1014:00", "one of the object's range"));
}
} // namespace
} // namespace counterpoint::runtime
