// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/file/device_reader.hpp"
#include "runtime/node/device.hpp"
#include "runtime/node/trial.hpp"
#include "tests/canopen/cia306/folder_of_files.hpp"
#include "tests/tools/echo_bus.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/ids/pdo.hpp"
#include "verification/trace/verifies.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

// The objects of services are those of the file: which sub-indices there are, who may write them, what they are.
namespace counterpoint::runtime
{
namespace
{
using cia301::SdoAbort;

constexpr std::uint64_t kNsPerMs = 1000000U;

/// A section of a data element: its type by number, its access, its value (empty: none).
std::string Element(const std::string& section, const char* const type, const char* const access,
                    const std::string& value)
{
    return "[" + section + "]\nDataType=" + type + "\nAccessType=" + access + "\n" +
           (value.empty() ? "" : "DefaultValue=" + value + "\n");
}

/// A section of a record.
std::string Record(const std::string& section)
{
    return "[" + section + "]\nObjectType=9\n";
}

const std::string kHead = "[DeviceInfo]\nVendorName=test\n[DeviceComissioning]\nNodeID=5\n" +
                          Element("1000", "7", "ro", "0") + Element("1001", "5", "ro", "") +
                          "[2000]\nDataType=5\nAccessType=rw\nDefaultValue=17\nPDOMapping=1\n";

class FileObjectsTest : public cia306::test::FolderTest
{
  protected:
    /// A node of this file, switched on: PRE-OPERATIONAL.
    void Start(const std::string& objects, const std::string& store = "")
    {
        StartFile(File("node.dcf", kHead + objects), store);
    }
    void StartFile(const std::string& file, const std::string& store = "")
    {
        device.reset();
        NodeSettings settings;
        settings.dcf = file;
        settings.store = store;
        settings.has_self_tests = false;
        device = std::make_unique<NodeDevice>(settings, ports, report);
        now_ns += kNsPerMs;
        ASSERT_TRUE(device->PowerOn({Instant{0U}, Instant{0U}}, now_ns));
    }
    /// As a client reads: little-endian, at most 4 bytes.
    [[nodiscard]] std::uint32_t Read(const ObjectAddress& object)
    {
        std::uint8_t bytes[4U]{};
        EXPECT_EQ(device->Assembly().Dictionary().Read(object, {bytes, 4U}).abort, SdoAbort::kNone)
            << cia306::ObjectName(object.index, object.sub);
        return bytes[0] | (std::uint32_t{bytes[1]} << 8U) | (std::uint32_t{bytes[2]} << 16U) |
               (std::uint32_t{bytes[3]} << 24U);
    }
    [[nodiscard]] SdoAbort ReadAbort(const ObjectAddress& object)
    {
        std::uint8_t bytes[4U]{};
        return device->Assembly().Dictionary().Read(object, {bytes, 4U}).abort;
    }
    /// As a client writes.
    [[nodiscard]] SdoAbort Write(const ObjectAddress& object, const std::uint32_t value, const std::uint32_t size_bytes)
    {
        const std::uint8_t bytes[4U]{
            static_cast<std::uint8_t>(value & 0xFFU), static_cast<std::uint8_t>((value >> 8U) & 0xFFU),
            static_cast<std::uint8_t>((value >> 16U) & 0xFFU), static_cast<std::uint8_t>(value >> 24U)};
        return device->Assembly().Dictionary().Write(object, {bytes, size_bytes});
    }
    /// Or, with 1011h, restores.
    void Save(const ObjectAddress& object = {0x1010U, 1U}, const std::uint32_t word = 0x65766173U)
    {
        SdoAbort abort = Write(object, word, 4U);
        for (int i = 0; i < 100000 && abort == SdoAbort::kPending; ++i)
        {
            now_ns += kNsPerMs;
            device->Serve({Instant{0U}, Instant{0U}}, now_ns);
            std::this_thread::sleep_for(std::chrono::microseconds(10));
            abort = device->Assembly().Dictionary().WriteNumberAgain(object, word, 4U);
        }
        ASSERT_EQ(abort, SdoAbort::kNone);
    }
    /// What a device of this file does without, as check has it.
    [[nodiscard]] std::vector<std::string> Tried(const std::string& objects)
    {
        return TriedFile(kHead + objects);
    }
    [[nodiscard]] std::vector<std::string> TriedFile(const std::string& text)
    {
        std::vector<std::string> lines;
        for (const cia306::Finding& finding : TryDevice(cia306::ReadDeviceFile(File("tried.dcf", text)), std::nullopt))
        {
            lines.push_back(finding.object + ": " + finding.text);
        }
        return lines;
    }
    [[nodiscard]] std::string Told()
    {
        device.reset();
        static_cast<void>(report.Finish());
        return out.str();
    }

    std::ostringstream out{};
    NodeReport report{out, ReportForm::kText, 0U};
    NodePorts ports{std::make_unique<tools::test::EchoBus>(false, 0U),
                    std::make_unique<tools::test::EchoBus>(false, 0U)};
    std::unique_ptr<NodeDevice> device{};
    std::uint64_t now_ns{kNsPerMs};
};

struct Constant
{
    ObjectAddress object;
    std::uint32_t value;
    std::uint32_t size_bytes;
};

TEST_F(FileObjectsTest, AConstantOfAServiceHasTheValueOfTheFileAndTakesNone)
{
    Verifies(req::SRS_NODE_037);
    for (const char* const access : {"const", "ro"})
    {
        // Given a file in which all that services have cannot be written
        const auto fixed = [access](const std::string& section, const char* const type, const std::string& value)
        { return Element(section, type, access, value); };
        Start(fixed("1005", "7", "0x90") + fixed("1014", "7", "0x86") + fixed("1015", "6", "30") + Record("1016") +
              fixed("1016sub0", "5", "1") + fixed("1016sub1", "7", "0x00060064") + fixed("1017", "6", "100") +
              Record("1029") + fixed("1029sub0", "5", "1") + fixed("1029sub1", "5", "2") + Record("1400") +
              fixed("1400sub0", "5", "2") + fixed("1400sub1", "7", "0x205") + fixed("1400sub2", "5", "1") +
              Record("1600") + fixed("1600sub0", "5", "1") + fixed("1600sub1", "7", "0x20000008") + Record("1800") +
              fixed("1800sub0", "5", "2") + fixed("1800sub1", "7", "0x40000185") + fixed("1800sub2", "5", "1") +
              Record("1A00") + fixed("1A00sub0", "5", "1") + fixed("1A00sub1", "7", "0x20000008"));
        const std::vector<Constant> constants{
            {{0x1005U, 0U}, 0x90U, 4U},       {{0x1014U, 0U}, 0x86U, 4U},       {{0x1015U, 0U}, 30U, 2U},
            {{0x1016U, 0U}, 1U, 1U},          {{0x1016U, 1U}, 0x00060064U, 4U}, {{0x1017U, 0U}, 100U, 2U},
            {{0x1029U, 0U}, 1U, 1U},          {{0x1029U, 1U}, 2U, 1U},          {{0x1400U, 0U}, 2U, 1U},
            {{0x1400U, 1U}, 0x205U, 4U},      {{0x1400U, 2U}, 1U, 1U},          {{0x1600U, 0U}, 1U, 1U},
            {{0x1600U, 1U}, 0x20000008U, 4U}, {{0x1800U, 0U}, 2U, 1U},          {{0x1800U, 1U}, 0x40000185U, 4U},
            {{0x1800U, 2U}, 1U, 1U},          {{0x1A00U, 0U}, 1U, 1U},          {{0x1A00U, 1U}, 0x20000008U, 4U},
        };
        // Then each reads as in the file, and refuses a write, be it the same value
        for (const Constant& one : constants)
        {
            EXPECT_EQ(Read(one.object), one.value) << access << " " << std::hex << one.object.index;
            EXPECT_EQ(Write(one.object, one.value, one.size_bytes), SdoAbort::kReadOnly)
                << access << " " << std::hex << one.object.index;
        }
        // And the services work with it
        device::Services& services = device->Assembly().Services();
        EXPECT_EQ(services.emergency.CobId(), 0x86U);
        EXPECT_EQ(services.producer.PeriodMs(), 100U);
        EXPECT_EQ(services.consumer.Value(1U), 0x00060064U);
        EXPECT_EQ(services.tpdos.FetchSetting(1U, 2U).value, 1U);
        EXPECT_EQ(services.tpdos.FetchMapping(1U, 0U).value, 1U);
        EXPECT_EQ(services.rpdos.FetchMapping(1U, 0U).value, 1U);
    }
    EXPECT_EQ(Told().find("warning"), std::string::npos) << out.str();
}

TEST_F(FileObjectsTest, AWriteOnlyObjectOfAServiceIsNotRead)
{
    Verifies(req::SRS_NODE_037);
    Start(Element("1017", "6", "wo", "100"));
    EXPECT_EQ(ReadAbort({0x1017U, 0U}), SdoAbort::kWriteOnly);
    EXPECT_EQ(device->Assembly().Services().producer.PeriodMs(), 100U);
    EXPECT_EQ(Write({0x1017U, 0U}, 200U, 2U), SdoAbort::kNone);
    EXPECT_EQ(device->Assembly().Services().producer.PeriodMs(), 200U);
}

TEST_F(FileObjectsTest, AnotherIdentifierOfTheDefaultSdoIsTold)
{
    Verifies(req::SRS_NODE_037);
    Start(Record("1200") + Element("1200sub0", "5", "const", "2") + Element("1200sub1", "7", "const", "0x605") +
          Element("1200sub2", "7", "ro", "0x5A0"));
    EXPECT_EQ(Read({0x1200U, 1U}), 0x605U);
    EXPECT_EQ(Read({0x1200U, 2U}), 0x585U);
    const std::string told = Told();
    EXPECT_NE(told.find("0x1200:02: the device does without this value, expected the identifier of the default SDO"),
              std::string::npos)
        << told;
    EXPECT_EQ(told.find("0x1200:01"), std::string::npos) << told;
}

TEST_F(FileObjectsTest, SubIndicesAreThoseOfTheFile)
{
    Verifies(req::SRS_NODE_038);
    // Given records with fewer and more sub-indices than the services have
    Start(Record("1016") + Element("1016sub0", "5", "rw", "2") + Element("1016sub1", "7", "rw", "0") +
          Element("1016sub2", "7", "rw", "0") + Record("1029") + Element("1029sub0", "5", "const", "7") +
          Element("1029sub1", "5", "rw", "1") + Element("1029sub7", "5", "rw", "9") + Record("1400") +
          Element("1400sub0", "5", "ro", "2") + Element("1400sub1", "7", "rw", "0x80000205") +
          Element("1400sub2", "5", "rw", "254") + Record("1401") + Element("1401sub0", "5", "const", "6") +
          Element("1401sub1", "7", "rw", "0x80000305") + Element("1401sub2", "5", "rw", "254") +
          Element("1401sub6", "5", "rw", "3") + Record("1800") + Element("1800sub0", "5", "ro", "5") +
          Element("1800sub1", "7", "rw", "0xC0000185") + Element("1800sub2", "5", "rw", "254") +
          Element("1800sub3", "6", "rw", "10") + Element("1800sub4", "5", "rw", "4") +
          Element("1800sub5", "6", "ro", "50") + Record("1801") + Element("1801sub0", "5", "ro", "") +
          Element("1801sub1", "7", "rw", "0xC0000285") + Element("1801sub2", "5", "rw", "1") +
          Element("1801sub6", "5", "rw", "7"));
    // Then sub-index 0 is that of the file, or the highest there is where the file gives none
    EXPECT_EQ(Read({0x1016U, 0U}), 2U);
    EXPECT_EQ(Read({0x1029U, 0U}), 7U);
    EXPECT_EQ(Read({0x1400U, 0U}), 2U);
    EXPECT_EQ(Read({0x1401U, 0U}), 6U);
    EXPECT_EQ(Read({0x1800U, 0U}), 5U);
    EXPECT_EQ(Read({0x1801U, 0U}), 6U);
    // And takes no other value, even if the file lets it be written
    EXPECT_EQ(Write({0x1016U, 0U}, 2U, 1U), SdoAbort::kNone);
    EXPECT_EQ(Write({0x1016U, 0U}, 1U, 1U), SdoAbort::kReadOnly);
    EXPECT_EQ(Write({0x1400U, 0U}, 2U, 1U), SdoAbort::kReadOnly);
    // And what the file has not is not there
    const std::vector<ObjectAddress> missing{{0x1016U, 3U}, {0x1029U, 2U}, {0x1400U, 3U}, {0x1400U, 5U},
                                             {0x1401U, 5U}, {0x1800U, 6U}, {0x1801U, 3U}, {0x1801U, 5U}};
    for (const ObjectAddress& object : missing)
    {
        EXPECT_EQ(ReadAbort(object), SdoAbort::kSubUnknown) << std::hex << object.index;
        EXPECT_EQ(Write(object, 0U, 1U), SdoAbort::kSubUnknown) << std::hex << object.index;
    }
    // And what it has and no service uses is there, with value and access
    EXPECT_EQ(Read({0x1800U, 4U}), 4U);
    EXPECT_EQ(Write({0x1800U, 4U}, 5U, 1U), SdoAbort::kNone);
    EXPECT_EQ(Read({0x1800U, 4U}), 5U);
    EXPECT_EQ(Read({0x1401U, 6U}), 3U);
    EXPECT_EQ(Read({0x1029U, 7U}), 9U);
    // And what a service uses is the service's
    EXPECT_EQ(device->Assembly().Services().tpdos.FetchSetting(1U, 3U).value, 10U);
    EXPECT_EQ(device->Assembly().Services().tpdos.FetchSetting(1U, 5U).value, 50U);
    EXPECT_EQ(Write({0x1800U, 5U}, 60U, 2U), SdoAbort::kReadOnly);
    EXPECT_EQ(device->Assembly().Services().tpdos.FetchSetting(2U, 6U).value, 7U);
    EXPECT_EQ(Told().find("warning"), std::string::npos) << out.str();
}

// CiA 301 has groups 1 to 4 in 1010h; a file may have more of them
TEST_F(FileObjectsTest, AGroupThatTheStoreHasNotIsNotSaved)
{
    Verifies(req::SRS_NODE_038);
    Start(Record("1010") + Element("1010sub0", "5", "ro", "5") + Element("1010sub1", "7", "rw", "1") +
              Element("1010sub5", "7", "rw", "1"),
          Path("node.store"));
    EXPECT_EQ(Read({0x1010U, 0U}), 5U);
    EXPECT_EQ(Read({0x1010U, 1U}), 1U);
    EXPECT_EQ(Read({0x1010U, 5U}), 0U);
    EXPECT_EQ(Write({0x1010U, 5U}, 0x65766173U, 4U), SdoAbort::kNotStored);
    EXPECT_EQ(ReadAbort({0x1010U, 2U}), SdoAbort::kSubUnknown);
}

// A CompactSubObj gives all sub-indices one access right, their number, too
TEST_F(FileObjectsTest, ANumberOfSubIndicesThatWasSavedIsLoaded)
{
    Verifies(req::SRS_NODE_038);
    Verifies(req::SRS_NODE_030);
    const std::string objects = Record("1010") + Element("1010sub0", "5", "ro", "1") +
                                Element("1010sub1", "7", "rw", "1") + "[1016]\nObjectType=8\nDataType=7\n" +
                                "AccessType=rw\nCompactSubObj=2\n" + Element("1014", "7", "rw", "0xA0");
    Start(objects, Path("node.store"));
    EXPECT_EQ(Read({0x1016U, 0U}), 2U);
    EXPECT_EQ(Write({0x1016U, 1U}, 0x00060064U, 4U), SdoAbort::kNone);
    Save();
    Start(objects, Path("node.store"));
    EXPECT_EQ(Read({0x1014U, 0U}), 0xA0U);
    EXPECT_EQ(Read({0x1016U, 0U}), 2U);
    EXPECT_EQ(Read({0x1016U, 1U}), 0x00060064U);
    EXPECT_EQ(Told().find("warning"), std::string::npos) << out.str();
}

TEST_F(FileObjectsTest, ABooleanOfAPdoMayBeAByte)
{
    Verifies(req::SRS_NODE_017);
    // Given a TPDO with a BOOLEAN of 8 bits, then it is on; one of 2 bits is told, with the PDO
    const auto pdo = [](const std::string& mapping)
    {
        return "[2001]\nDataType=1\nAccessType=rw\nDefaultValue=1\nPDOMapping=1\n" + Record("1800") +
               Element("1800sub0", "5", "const", "2") + Element("1800sub1", "7", "rw", "0x40000185") +
               Element("1800sub2", "5", "rw", "254") + Record("1A00") + Element("1A00sub0", "5", "rw", "1") +
               Element("1A00sub1", "7", "rw", mapping);
    };
    Start(pdo("0x20010008"));
    EXPECT_EQ(Read({0x1800U, 1U}), 0x40000185U);
    EXPECT_EQ(Read({0x1A00U, 1U}), 0x20010008U);
    Start(pdo("0x20010002"));
    EXPECT_EQ(Read({0x1800U, 1U}), 0xC0000185U);
    const std::string told = Told();
    EXPECT_NE(told.find("0x1A00:01: the device does without this field of 2 bit, expected 1 or 8 bit, the length of "
                        "0x2001:00"),
              std::string::npos)
        << told;
    EXPECT_NE(told.find("0x1800:01: the device has turned this PDO off"), std::string::npos) << told;
}

// 101h to 180h are of SRDOs alone, 180h the last one; 181h is free, and so is 600h between two ranges of the default
// SDOs
TEST_F(FileObjectsTest, APdoWithTheIdentifierOfAnotherServiceIsToldWithIt)
{
    Verifies(req::SRS_NODE_017);
    const auto pdo = [](const std::string& cob_id)
    {
        return "[2001]\nDataType=5\nAccessType=rw\nDefaultValue=1\nPDOMapping=1\n" + Record("1800") +
               Element("1800sub0", "5", "const", "2") + Element("1800sub1", "7", "rw", cob_id) +
               Element("1800sub2", "5", "rw", "254") + Record("1A00") + Element("1A00sub0", "5", "rw", "1") +
               Element("1A00sub1", "7", "rw", "0x20010008");
    };
    const std::string off = "0x1800:01: the device has turned this PDO off, expected ";
    const std::pair<const char*, std::string> rows[] = {
        {"0x7F", "another identifier than 0x07F, which is one of NMT and GFC"},
        {"0x40000109", "another identifier than 0x109, which is one of SRDOs"},
        {"0x180", "another identifier than 0x180, which is one of SRDOs"},
        {"0x582", "another identifier than 0x582, which is one of the default SDOs"},
        {"0x67F", "another identifier than 0x67F, which is one of the default SDOs"},
        {"0x6E0", "another identifier than 0x6E0, which is one that CiA 301 reserves"},
        {"0x702", "another identifier than 0x702, which is one of error control and LSS"},
        {"0x20000185", "an identifier of 11 bit"},
        {"0x800", "an identifier of 11 bit"}};
    for (const auto& [cob_id, expected] : rows)
    {
        EXPECT_EQ(Tried(pdo(cob_id)), std::vector<std::string>{off + expected});
    }
    for (const char* const free : {"0x100", "0x181", "0x600", "0x6DF"})
    {
        EXPECT_EQ(Tried(pdo(free)), std::vector<std::string>{}) << free;
    }
}

/// A PDO of one byte; `kind` 14 receives, 18 sends.
std::string OneByte(const unsigned kind, const unsigned number, const std::string& cob_id)
{
    const std::string mapping = kind == 14U ? "160" : "1A0";
    const std::string at = std::to_string(kind) + "0" + std::to_string(number);
    const std::string map = mapping + std::to_string(number);
    return Record(at) + Element(at + "sub0", "5", "const", "2") + Element(at + "sub1", "7", "rw", cob_id) +
           Element(at + "sub2", "5", "rw", "254") + Record(map) + Element(map + "sub0", "5", "rw", "1") +
           Element(map + "sub1", "7", "rw", "0x20000008");
}

// Its frames would be read as emergencies, 0000h among them, as SYNC, TIME or SDO
TEST_F(FileObjectsTest, APdoWithAnIdentifierThatTheDeviceUsesElsewhereIsOffAndToldWithItsObject)
{
    Verifies(req::SRS_NODE_017);
    Verifies(req::SRS_PDO_009);
    const auto reason = [](const char* const object, const char* const identifier, const std::string& owner)
    {
        return std::vector<std::string>{std::string(object) +
                                        ":01: the device has turned this PDO off, expected another identifier than " +
                                        identifier + ", which is that of " + owner};
    };
    const std::string server =
        Record("1201") + Element("1201sub1", "7", "rw", "0x240") + Element("1201sub2", "7", "rw", "0x241");
    const std::string client =
        Record("1280") + Element("1280sub1", "7", "rw", "0x250") + Element("1280sub2", "7", "rw", "0x251");
    const std::string emergencies = Record("1028") + Element("1028sub1", "7", "rw", "0x230");
    struct Row
    {
        std::string others;
        const char* identifier;
        const char* owner;
    };
    for (const Row& row :
         {Row{"", "0x085", "the emergencies of this device"}, Row{"", "0x080", "SYNC"},
          Row{Element("1014", "7", "rw", "$NODEID+0x80"), "0x085", "0x1014:00"},
          Row{Element("1014", "7", "rw", "0x200"), "0x200", "0x1014:00"},
          Row{Element("1005", "7", "rw", "0x210"), "0x210", "0x1005:00"},
          Row{Element("1012", "7", "rw", "0x80000100"), "0x100", "0x1012:00"},
          Row{Element("1012", "7", "rw", "0x40000220"), "0x220", "0x1012:00"}, Row{emergencies, "0x230", "0x1028:01"},
          Row{server, "0x240", "0x1201:01"}, Row{server, "0x241", "0x1201:02"}, Row{client, "0x250", "0x1280:01"},
          Row{client, "0x251", "0x1280:02"}})
    {
        EXPECT_EQ(Tried(row.others + OneByte(18U, 0U, row.identifier)), reason("0x1800", row.identifier, row.owner));
        EXPECT_EQ(Tried(row.others + OneByte(14U, 0U, row.identifier)), reason("0x1400", row.identifier, row.owner));
    }
    // Of two with one identifier the first keeps it, and a received one before one that is sent
    EXPECT_EQ(Tried(OneByte(18U, 0U, "0x185") + OneByte(18U, 1U, "0x185")), reason("0x1801", "0x185", "0x1800:01"));
    EXPECT_EQ(Tried(OneByte(14U, 0U, "0x185") + OneByte(18U, 0U, "0x185")), reason("0x1800", "0x185", "0x1400:01"));
    // What is off takes no identifier, and one frame may be received by two PDOs
    for (const std::string& free : {Element("1014", "7", "rw", "0x80000085") + OneByte(18U, 0U, "0x85"),
                                    Element("1012", "7", "rw", "0x100") + OneByte(18U, 0U, "0x100"),
                                    OneByte(18U, 0U, "0x80000185") + OneByte(18U, 1U, "0x185"),
                                    OneByte(14U, 0U, "0x185") + OneByte(14U, 1U, "0x185")})
    {
        EXPECT_EQ(Tried(free), std::vector<std::string>{}) << free;
    }
}

TEST_F(FileObjectsTest, NoClientGivesAPdoAndAnotherServiceOneIdentifier)
{
    Verifies(req::SRS_PDO_009);
    Start(Element("1005", "7", "rw", "0x80") + Element("1012", "7", "rw", "0x100") +
          Element("1014", "7", "rw", "0x80000085") + Record("1028") + Element("1028sub1", "7", "rw", "0x80000000") +
          Record("1201") + Element("1201sub1", "7", "rw", "0x80000000") + Element("1201sub2", "7", "rw", "0x80000000") +
          OneByte(14U, 0U, "0x80000205") + OneByte(14U, 1U, "0x80000305") + OneByte(18U, 0U, "0x185") +
          OneByte(18U, 1U, "0x80000285"));
    // The identifier of a PDO is given to no other service, to no TPDO and to no RPDO
    const std::pair<ObjectAddress, std::uint32_t> others[] = {
        {{0x1005U, 0U}, 0x185U}, {{0x1012U, 0U}, 0x80000185U}, {{0x1014U, 0U}, 0x185U}, {{0x1028U, 1U}, 0x185U},
        {{0x1201U, 1U}, 0x185U}, {{0x1201U, 2U}, 0x185U},      {{0x1400U, 1U}, 0x185U}, {{0x1801U, 1U}, 0x185U}};
    for (const auto& [object, cob_id] : others)
    {
        EXPECT_EQ(Write(object, cob_id, 4U), SdoAbort::kValueRange) << cia306::ObjectName(object.index, object.sub);
    }
    // Another one, or the same one without a role, is taken; then no PDO gets it
    EXPECT_EQ(Write({0x1012U, 0U}, 0x185U, 4U), SdoAbort::kNone);
    EXPECT_EQ(Write({0x1014U, 0U}, 0x85U, 4U), SdoAbort::kNone);
    EXPECT_EQ(Write({0x1801U, 1U}, 0x85U, 4U), SdoAbort::kValueRange);
    EXPECT_EQ(Write({0x1400U, 1U}, 0x80U, 4U), SdoAbort::kValueRange);
    // The own one again, and RPDOs share theirs
    EXPECT_EQ(Write({0x1800U, 1U}, 0x185U, 4U), SdoAbort::kNone);
    EXPECT_EQ(Write({0x1400U, 1U}, 0x205U, 4U), SdoAbort::kNone);
    EXPECT_EQ(Write({0x1401U, 1U}, 0x205U, 4U), SdoAbort::kNone);
    EXPECT_EQ(Write({0x1801U, 1U}, 0x205U, 4U), SdoAbort::kValueRange);
    EXPECT_EQ(Write({0x1801U, 1U}, 0x80000205U, 4U), SdoAbort::kNone);
}

// The heartbeat runs; what was wrong is that the device was said to do without the value
TEST_F(FileObjectsTest, AnObjectOfAServiceWithAnotherDataTypeIsToldWithBothLengths)
{
    Verifies(req::SRS_NODE_340);
    EXPECT_EQ(
        Tried(Element("1017", "7", "rw", "100")),
        std::vector<std::string>{"0x1017:00: data type of 32 bit, expected one of 16 bit, which the device has here"});
    EXPECT_EQ(
        Tried(Element("1014", "6", "rw", "$NODEID+0x80")),
        std::vector<std::string>{"0x1014:00: data type of 16 bit, expected one of 32 bit, which the device has here"});
    EXPECT_EQ(Tried(Element("1017", "6", "rw", "100")), std::vector<std::string>{});
    // Also where the device has a value of its own, or the file has none
    const auto told = [](const char* const object, const unsigned own, const unsigned expected)
    {
        return std::vector<std::string>{std::string(object) + ": data type of " + std::to_string(own) +
                                        " bit, expected one of " + std::to_string(expected) +
                                        " bit, which the device has here"};
    };
    EXPECT_EQ(Tried(Element("1017", "7", "rw", "")), told("0x1017:00", 32U, 16U));
    EXPECT_EQ(Tried(Element("1003", "6", "rw", "")), told("0x1003:00", 16U, 8U));
    EXPECT_EQ(Tried(Record("1010") + Element("1010sub1", "5", "rw", "1")), told("0x1010:01", 8U, 32U));
    EXPECT_EQ(Tried(Record("1011") + Element("1011sub1", "5", "rw", "1")), told("0x1011:01", 8U, 32U));
    EXPECT_EQ(Tried(Record("1200") + Element("1200sub1", "6", "ro", "$NODEID+0x600")), told("0x1200:01", 16U, 32U));
    EXPECT_EQ(TriedFile(std::regex_replace(kHead, std::regex("\\[1001\\]\nDataType=5"), "[1001]\nDataType=6")),
              told("0x1001:00", 16U, 8U));
    // Where there is nothing to be read, and beside a value that is left out or refused
    EXPECT_EQ(Tried(Record("1003") + Element("1003sub1", "6", "ro", "")), told("0x1003:01", 16U, 32U));
    const auto last = [this](const std::string& objects)
    {
        const std::vector<std::string> lines = Tried(objects);
        return (lines.size() == 2U) ? std::vector<std::string>{lines[1]} : lines;
    };
    EXPECT_EQ(last(Element("1017", "7", "rw", "0x10000")), told("0x1017:00", 32U, 16U));
    EXPECT_EQ(last(Element("1012", "6", "rw", "0x40000100")), told("0x1012:00", 16U, 32U));
    EXPECT_EQ(last(Record("1028") + Element("1028sub1", "6", "rw", "0x80000081")), told("0x1028:01", 16U, 32U));
}

TEST_F(FileObjectsTest, AnObjectOfAServiceHasTheLengthOfTheServiceForItsClients)
{
    Verifies(req::SRS_NODE_043);
    Start(Element("1005", "6", "rw", "0x80") + Record("1010") + Element("1010sub1", "5", "rw", "1") +
          Element("1014", "6", "rw", "$NODEID+0x80") + Element("1017", "7", "rw", "100") + Record("1029") +
          Element("1029sub1", "6", "rw", "1"));
    // The numbers of the file are there
    EXPECT_EQ(Read({0x1005U, 0U}), 0x80U);
    EXPECT_EQ(Read({0x1014U, 0U}), 0x85U);
    EXPECT_EQ(Read({0x1017U, 0U}), 100U);
    EXPECT_EQ(Read({0x1029U, 1U}), 1U);
    // A client writes with the length that it reads, and with no other
    EXPECT_EQ(Write({0x1017U, 0U}, 200U, 2U), SdoAbort::kNone);
    EXPECT_EQ(Write({0x1017U, 0U}, 300U, 4U), SdoAbort::kTooLong);
    EXPECT_EQ(Read({0x1017U, 0U}), 200U);
    EXPECT_EQ(Write({0x1005U, 0U}, 0x90U, 4U), SdoAbort::kNone);
    EXPECT_EQ(Write({0x1005U, 0U}, 0x80U, 2U), SdoAbort::kTooShort);
    EXPECT_EQ(Write({0x1029U, 1U}, 2U, 1U), SdoAbort::kNone);
    EXPECT_EQ(Write({0x1029U, 1U}, 1U, 2U), SdoAbort::kTooLong);
    EXPECT_EQ(Write({0x1010U, 1U}, 0x65766173U, 4U), SdoAbort::kNotStored); // Without --store.
}

TEST_F(FileObjectsTest, WhatIsNoNumberOfTheServiceIsRefused)
{
    Verifies(req::SRS_NODE_043);
    Verifies(req::SRS_NODE_030);
    // -1 as INTEGER8 and INTEGER32; 'd', '32', '100' as VISIBLE_STRING; 3200 as OCTET_STRING; 10 as REAL32
    const std::vector<std::pair<std::string, std::string>> values{
        {"2", "-1"}, {"4", "-1"}, {"9", "d"}, {"9", "32"}, {"9", "100"}, {"0xA", "3200"}, {"8", "10"}};
    for (const auto& [type, value] : values)
    {
        SCOPED_TRACE(testing::Message() << type << " " << value);
        const std::vector<std::string> lines = Tried(Element("1017", type.c_str(), "rw", value.c_str()));
        const std::string refused = "0x1017:00: the device refuses this value with abort code 0x0607001";
        EXPECT_TRUE(std::any_of(lines.begin(), lines.end(),
                                [&refused](const std::string& line) { return line.rfind(refused, 0U) == 0U; }));
        Start(Element("1017", type.c_str(), "rw", value.c_str()));
        EXPECT_EQ(Read({0x1017U, 0U}), 0U);
    }
    Start(Element("1017", "2", "rw", "100"));
    EXPECT_EQ(Read({0x1017U, 0U}), 100U);
    Start(Element("1017", "1", "rw", "1"));
    EXPECT_EQ(Read({0x1017U, 0U}), 1U);
}

// An SRDO has the length of its object, which is one bit: what check says with both lengths the device says with a code
TEST_F(FileObjectsTest, ABooleanOfAnSrdoIsOneBit)
{
    Verifies(req::SRS_NODE_001);
    StartFile(std::string(COUNTERPOINT_SOURCE) + "/tests/canopen/cia306/data/bits.dcf");
    EXPECT_EQ(Write({0x1301U, 1U}, 0U, 1U), SdoAbort::kNone);
    EXPECT_EQ(Write({0x1381U, 0U}, 0U, 1U), SdoAbort::kNone);
    EXPECT_EQ(Write({0x1381U, 1U}, 0x60200108U, 4U), SdoAbort::kNotMappable);
    EXPECT_EQ(Write({0x1381U, 1U}, 0x60200101U, 4U), SdoAbort::kNone);
}

// 2001h begins above 0, 2002h below it, 2003h within its limits, 2004h has its value from the file
TEST_F(FileObjectsTest, ANumberWithoutValueBeginsWithTheLimitNextToZero)
{
    Verifies(req::SRS_NODE_045);
    const std::string objects =
        Record("1010") + Element("1010sub0", "5", "const", "1") + Element("1010sub1", "7", "rw", "1") + Record("1011") +
        Element("1011sub1", "7", "rw", "1") + Element("2001", "6", "rw", "") + "LowLimit=50\nHighLimit=200\n" +
        Element("2002", "3", "rw", "") + "LowLimit=-300\nHighLimit=-2\n" + Element("2003", "3", "rw", "") +
        "LowLimit=-5\nHighLimit=5\n" + Element("2004", "6", "rw", "60") + "LowLimit=50\n";
    Start(objects, Path("node.store"));
    EXPECT_EQ(Read({0x2001U, 0U}), 50U);
    EXPECT_EQ(Read({0x2002U, 0U}), 0xFFFEU);
    EXPECT_EQ(Read({0x2003U, 0U}), 0U);
    EXPECT_EQ(Read({0x2004U, 0U}), 60U);
    // What is read may be written back, and saved
    EXPECT_EQ(Write({0x2001U, 0U}, 50U, 2U), SdoAbort::kNone);
    EXPECT_EQ(Write({0x2001U, 0U}, 49U, 2U), SdoAbort::kValueLow);
    EXPECT_EQ(Write({0x2002U, 0U}, 0xFFFEU, 2U), SdoAbort::kNone);
    EXPECT_EQ(Write({0x2002U, 0U}, 0xFFFFU, 2U), SdoAbort::kValueHigh);
    Save();
    Start(objects, Path("node.store"));
    EXPECT_EQ(Read({0x2001U, 0U}), 50U);
    EXPECT_EQ(Read({0x2002U, 0U}), 0xFFFEU);
    // Also behind a restore
    EXPECT_EQ(Write({0x2001U, 0U}, 60U, 2U), SdoAbort::kNone);
    Save();
    Save({0x1011U, 1U}, 0x64616F6CU);
    Start(objects, Path("node.store"));
    EXPECT_EQ(Read({0x2001U, 0U}), 50U);
    EXPECT_EQ(Told().find("warning"), std::string::npos) << out.str();
}

// 0030h is BIT1, 0036h BIT7, 0037h BIT8; the type 0041h of the file has 12 bits
TEST_F(FileObjectsTest, ANumberTakesNoMoreThanTheBitsOfItsType)
{
    Verifies(req::SRS_NODE_045);
    struct Number
    {
        ObjectAddress object;
        std::uint32_t highest;
        std::uint32_t size_bytes;
    };
    Start("[0041]\nObjectType=5\nDataType=7\nAccessType=const\nDefaultValue=12\n" +
          Element("2001", "0x0030", "rw", "1") + Element("2002", "0x0036", "rw", "") +
          Element("2003", "0x0041", "rw", "0xABC") + Element("2004", "0x0032", "rw", "") + "HighLimit=5\n" +
          Element("2005", "0x0037", "rw", ""));
    const std::vector<Number> numbers{
        {{0x2001U, 0U}, 1U, 1U}, {{0x2002U, 0U}, 0x7FU, 1U}, {{0x2003U, 0U}, 0xFFFU, 2U}, {{0x2004U, 0U}, 5U, 1U}};
    for (const Number& number : numbers)
    {
        EXPECT_EQ(Write(number.object, number.highest, number.size_bytes), SdoAbort::kNone);
        EXPECT_EQ(Write(number.object, number.highest + 1U, number.size_bytes), SdoAbort::kValueHigh);
        EXPECT_EQ(Read(number.object), number.highest);
    }
    EXPECT_EQ(Write({0x2005U, 0U}, 0xFFU, 1U), SdoAbort::kNone);
    EXPECT_EQ(Told().find("warning"), std::string::npos) << out.str();
}
} // namespace
} // namespace counterpoint::runtime
