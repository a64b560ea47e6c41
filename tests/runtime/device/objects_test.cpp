// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Objects of a file as the table of a dictionary: types, rights, values, limits.
#include "runtime/device/objects/objects.hpp"

#include "canopen/cia301/dictionary/no_objects.hpp"
#include "canopen/cia306/text/input_error.hpp"
#include "runtime/device/objects/cob_ids.hpp"
#include "runtime/device/objects/service_length.hpp"
#include "runtime/device/objects/service_objects.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
namespace
{
using cia301::Access;
using cia301::DataType;
using cia301::SdoAbort;
using Octets = std::vector<std::uint8_t>;

bool IsNobodys(std::uint16_t, std::uint8_t)
{
    return false;
}

/// A variable with these lines.
std::string Variable(const std::string& section, const std::string& type, const std::string& lines = "")
{
    return "[" + section + "]\nParameterName=x\nObjectType=7\nAccessType=rw\nDataType=" + type + "\n" + lines;
}

/// The objects of a text, in a dictionary.
struct Objects
{
    explicit Objects(const std::string& text, const DeviceObjects::IsKernels& is_kernels = &IsNobodys)
        : Objects(cia306::test::DeviceOf(text), is_kernels)
    {
    }
    explicit Objects(const cia306::Device& device, const DeviceObjects::IsKernels& is_kernels = &IsNobodys)
        : file(device), objects(file, 5U, is_kernels, 8192U)
    {
        objects.LoadApplication();
        objects.LoadCommunication();
        dictionary.SetNmtState(NmtState::kPreOperational);
    }
    [[nodiscard]] const cia301::Entry& At(const std::uint16_t index) const
    {
        const cia301::EntryTable& table = objects.Table();
        return *std::find_if(table.entries, table.entries + table.count,
                             [index](const cia301::Entry& entry) { return entry.index == index; });
    }
    [[nodiscard]] Octets Read(const ObjectAddress& object)
    {
        Octets bytes(64U);
        const cia301::Reading reading = dictionary.Read(object, {bytes.data(), 64U});
        EXPECT_EQ(reading.abort, SdoAbort::kNone) << object.index;
        bytes.resize(reading.size_bytes);
        return bytes;
    }
    [[nodiscard]] SdoAbort Write(const ObjectAddress& object, const Octets& bytes)
    {
        return dictionary.Write(object, {bytes.data(), static_cast<std::uint32_t>(bytes.size())});
    }
    /// What is left out of the file.
    [[nodiscard]] std::vector<std::string> Refusals() const
    {
        std::vector<std::string> lines;
        for (const cia306::Finding& finding : objects.Refusals())
        {
            lines.push_back(finding.object + ": " + finding.text);
        }
        return lines;
    }

    cia306::Device file;
    DeviceObjects objects;
    cia301::NoObjects none{};
    cia301::Dictionary dictionary{objects.Table(), none};
};

TEST(DeviceObjectsTest, HaveTheTypesOfTheFile)
{
    Verifies(req::SRS_NODE_001);
    const Objects objects(Variable("2000", "0x0010") + Variable("2001", "0x0031") + Variable("2002", "0x000E") +
                          Variable("2003", "0x0099") + "[2004]\nParameterName=x\nObjectType=7\nAccessType=rw\n");
    EXPECT_EQ(objects.At(0x2000U).type, DataType::kInteger24);
    EXPECT_EQ(objects.At(0x2000U).size_bytes, 3U);
    // BIT2 is a small number
    EXPECT_EQ(objects.At(0x2001U).type, DataType::kUnsigned8);
    EXPECT_EQ(objects.At(0x2001U).size_bytes, 1U);
    // What is no type is bytes
    EXPECT_EQ(objects.At(0x2002U).type, DataType::kOctetString);
    EXPECT_EQ(objects.At(0x2003U).type, DataType::kOctetString);
    EXPECT_EQ(objects.At(0x2004U).type, DataType::kOctetString);
}

TEST(DeviceObjectsTest, HaveNoEntryForADummyOrAStructureAsAWhole)
{
    Verifies(req::SRS_NODE_001);
    const Objects objects(Variable("0005", "5") + "[0040]\nParameterName=T\nObjectType=6\nSubNumber=1\n" +
                          Variable("0040sub0", "5") + Variable("2000", "0x0040") + Variable("2001", "5"));
    ASSERT_EQ(objects.objects.Table().count, 2U);
    EXPECT_EQ(objects.objects.Table().entries[0].index, 0x0040U);
    EXPECT_EQ(objects.objects.Table().entries[1].index, 0x2001U);
}

TEST(DeviceObjectsTest, HaveTheRightsOfTheFile)
{
    Verifies(req::SRS_NODE_001);
    const auto access = [](const std::string& word)
    {
        const Objects objects("[2000]\nParameterName=x\nObjectType=7\nDataType=5\n" + word);
        return objects.At(0x2000U).access;
    };
    EXPECT_EQ(access("AccessType=const\n"), Access::kConstant);
    EXPECT_EQ(access("AccessType=ro\n"), Access::kReadOnly);
    EXPECT_EQ(access("AccessType=wo\n"), Access::kWriteOnly);
    EXPECT_EQ(access("AccessType=rw\n"), Access::kReadWrite);
    EXPECT_EQ(access("AccessType=rwr\n"), Access::kReadWrite);
    EXPECT_EQ(access("AccessType=rww\n"), Access::kReadWrite);
    EXPECT_EQ(access(""), Access::kInvalid);
}

TEST(DeviceObjectsTest, HaveTheBytesOfAnOctetString)
{
    Verifies(req::SRS_NODE_001);
    const auto bytes = [](const std::string& text)
    {
        cia306::Device file = cia306::test::DeviceOf(Variable("2000", "0x000A", "DefaultValue=x\n"));
        file.objects.at(0x2000U).entries.at(0U).default_value.text = text;
        return Objects(file).Read({0x2000U, 0U});
    };
    EXPECT_EQ(bytes("0A1b"), (Octets{0x0AU, 0x1BU}));
    EXPECT_EQ(bytes("0A 1B"), (Octets{0x0AU, 0x1BU}));
    // An odd number of digits, another letter and nothing but spaces are texts
    EXPECT_EQ(bytes("0A1"), (Octets{'0', 'A', '1'}));
    EXPECT_EQ(bytes("0G"), (Octets{'0', 'G'}));
    EXPECT_EQ(bytes("  "), (Octets{' ', ' '}));
}

TEST(DeviceObjectsTest, HaveAUnicodeStringInUtf16)
{
    Verifies(req::SRS_NODE_001);
    Objects objects(Variable("2000", "0x000B", "DefaultValue=A\xE2\x82\xAC\n"));
    EXPECT_EQ(objects.Read({0x2000U, 0U}), (Octets{0x41U, 0x00U, 0xACU, 0x20U}));
}

TEST(DeviceObjectsTest, BeginWithTheLimitNextToZero)
{
    Verifies(req::SRS_NODE_045);
    Objects objects(Variable("2000", "2", "LowLimit=3\nHighLimit=9\n") + Variable("2001", "2", "HighLimit=-2\n") +
                    Variable("2002", "5", "HighLimit=9\n") + Variable("2003", "1", "LowLimit=1\n") +
                    Variable("2004", "9", "LowLimit=1\n"));
    EXPECT_EQ(objects.Read({0x2000U, 0U}), Octets{3U});
    EXPECT_EQ(objects.Read({0x2001U, 0U}), Octets{0xFEU});
    EXPECT_EQ(objects.Read({0x2002U, 0U}), Octets{0U});
    EXPECT_EQ(objects.Write({0x2002U, 0U}, {9U}), SdoAbort::kNone);
    EXPECT_EQ(objects.Write({0x2002U, 0U}, {10U}), SdoAbort::kValueHigh);
    // What is no number has none of them
    EXPECT_EQ(objects.Read({0x2003U, 0U}), Octets{0U});
    EXPECT_EQ(objects.Read({0x2004U, 0U}), Octets{});
    EXPECT_EQ(objects.Refusals(), std::vector<std::string>{});
}

TEST(DeviceObjectsTest, HaveTheirHighestSubIndexAsACountWhateverItsLimits)
{
    Verifies(req::SRS_NODE_038);
    Objects objects("[1016]\nParameterName=x\nObjectType=8\n" + Variable("1016sub0", "5", "LowLimit=1\n") +
                    Variable("1016sub1", "7") + Variable("1016sub2", "7") + "[1028]\nParameterName=x\nObjectType=8\n" +
                    Variable("1028sub0", "9") + Variable("1028sub1", "7"));
    EXPECT_EQ(objects.Read({0x1016U, 0U}), Octets{2U});
    // One that is a text has no place for it
    EXPECT_EQ(objects.Read({0x1028U, 0U}), Octets{});
}

TEST(DeviceObjectsTest, LeaveOutALimitThatTheirTypeCannotHave)
{
    Verifies(req::SRS_NODE_045);
    Verifies(req::SRS_EDS_032);
    Objects objects(Variable("2000", "5", "LowLimit=2\nHighLimit=256\n"));
    EXPECT_EQ(objects.Refusals(), (std::vector<std::string>{"0x2000:00: limit: value '256' is left out, expected a "
                                                            "number from 0 to 255 (UNSIGNED8)"}));
    EXPECT_EQ(objects.Write({0x2000U, 0U}, {1U}), SdoAbort::kValueLow);
    EXPECT_EQ(objects.Write({0x2000U, 0U}, {255U}), SdoAbort::kNone);
}

TEST(DeviceObjectsTest, BeginWithZeroForAValueThatTheirTypeCannotHave)
{
    Verifies(req::SRS_EDS_032);
    Objects objects(Variable("2000", "5", "DefaultValue=256\n"));
    EXPECT_EQ(objects.Refusals(),
              (std::vector<std::string>{"0x2000:00: value '256' is left out, expected a number from 0 "
                                        "to 255 (UNSIGNED8)"}));
    EXPECT_EQ(objects.Read({0x2000U, 0U}), Octets{0U});
    EXPECT_EQ(objects.Write({0x2000U, 0U}, {255U}), SdoAbort::kNone);
}

TEST(DeviceObjectsTest, OfTheKernelAreToldWhereAServiceHasThem)
{
    Verifies(req::SRS_NODE_044);
    const Objects objects(Variable("1017", "6") + Variable("2000", "5"),
                          [](std::uint16_t, std::uint8_t) { return true; });
    EXPECT_EQ(objects.objects.Table().count, 0U);
    EXPECT_EQ(objects.Refusals(), (std::vector<std::string>{
                                      "0x1017:00: a variable of SRDOs, so that the kernel has it and the service of "
                                      "this object works without it, expected SRDOMapping=0 and another object in the "
                                      "mapping"}));
    // Servers, clients, PDOs, and single ones; behind and between them nothing is
    for (const int index : {0x1200, 0x12FF, 0x1400, 0x1BFF, 0x1005, 0x1017, 0x1010, 0x1011, 0x1029})
    {
        EXPECT_TRUE(IsOfAService(static_cast<std::uint16_t>(index))) << index;
    }
    for (const int index : {0x1000, 0x1018, 0x11FF, 0x1300, 0x13FF, 0x1C00, 0x2000})
    {
        EXPECT_FALSE(IsOfAService(static_cast<std::uint16_t>(index))) << index;
    }
}

TEST(DeviceObjectsTest, HaveAsManySubIndicesAsTheFile)
{
    Verifies(req::SRS_NODE_038);
    const cia306::Device file =
        cia306::test::DeviceOf("[2500]\nParameterName=x\nObjectType=9\n[2501]\nParameterName=x\n"
                               "ObjectType=9\n" +
                               Variable("2501sub0", "5") + Variable("2501sub7", "5"));
    EXPECT_EQ(LastSubOf(file, 0x2500U), 0U);
    EXPECT_EQ(LastSubOf(file, 0x2501U), 7U);
    EXPECT_EQ(LastSubOf(file, 0x2502U), 0U);
}

TEST(DeviceObjectsTest, OfAMultiplexedPdoAreRefused)
{
    Verifies(req::SRS_NODE_017);
    const auto text = [](const std::string& count)
    {
        return "[1800]\nParameterName=x\nObjectType=9\n" + Variable("1800sub1", "7") +
               "[1A00]\nParameterName=x\nObjectType=9\n" + Variable("1A00sub0", "5", count) + Variable("1A00sub1", "7");
    };
    const auto fields = [&text](const std::string& count)
    {
        Objects objects(text(count));
        return objects.objects.Rooms().tpdos.count;
    };
    EXPECT_EQ(fields(""), 1U);
    EXPECT_EQ(fields("DefaultValue=253\n"), 1U);
    EXPECT_EQ(fields("DefaultValue=256\n"), 1U); // No value of its type.
    EXPECT_THROW(Objects{text("DefaultValue=254\n")}, cia306::InputError);
    EXPECT_THROW(Objects{text("DefaultValue=255\n")}, cia306::InputError);
    // And of one that is received
    const auto received = [](const std::string& count)
    {
        return "[1400]\nParameterName=x\nObjectType=9\n" + Variable("1400sub1", "7") +
               "[1600]\nParameterName=x\nObjectType=9\n" + Variable("1600sub0", "5", "DefaultValue=" + count + "\n") +
               Variable("1600sub1", "7");
    };
    EXPECT_EQ(Objects(received("253")).objects.Rooms().rpdos.count, 1U);
    EXPECT_THROW(Objects{received("254")}, cia306::InputError);
    EXPECT_THROW(Objects{received("255")}, cia306::InputError);
}

TEST(DeviceObjectsTest, OfTheStartTakeTheirOwnValueAlone)
{
    Verifies(req::SRS_NODE_001);
    const std::string times = "[5F00]\nParameterName=x\nObjectType=9\n" +
                              Variable("5F00sub0", "5", "DefaultValue=1\n") +
                              Variable("5F00sub1", "7", "DefaultValue=1000\n");
    Objects objects("[DeviceInfo]\nCANopenSafetySupported=1\n\n" + times);
    EXPECT_EQ(objects.Write({0x5F00U, 1U}, {0xE8U, 0x03U, 0U, 0U}), SdoAbort::kNone);
    EXPECT_EQ(objects.Write({0x5F00U, 1U}, {0xE9U, 0x03U, 0U, 0U}), SdoAbort::kLocalControl);
    EXPECT_EQ(objects.Read({0x5F00U, 1U}), (Octets{0xE8U, 0x03U, 0U, 0U}));
    // Of another device it is an object as others
    Verifies(req::SRS_EDS_670);
    Objects others(times);
    EXPECT_EQ(others.Write({0x5F00U, 1U}, {0xE9U, 0x03U, 0U, 0U}), SdoAbort::kNone);
    EXPECT_EQ(others.Read({0x5F00U, 1U}), (Octets{0xE9U, 0x03U, 0U, 0U}));
}

/// A service that answers a reading in one way.
class Answering final : public cia301::ReadHook
{
  public:
    explicit Answering(const cia301::Reading& answer) : answer_(answer)
    {
    }
    [[nodiscard]] cia301::Reading OnRead(const ObjectAddress& address, const cia301::Room& room) noexcept override
    {
        static_cast<void>(address);
        std::fill_n(room.data, room.size_bytes, std::uint8_t{0U});
        return answer_;
    }

  private:
    cia301::Reading answer_;
};

cia301::Entry EntryOf(const std::uint16_t index, const DataType type, const std::uint32_t size_bytes,
                      Answering& service)
{
    cia301::Entry entry{};
    entry.index = index;
    entry.type = type;
    entry.size_bytes = size_bytes;
    entry.read_hook = &service;
    return entry;
}

TEST(ServiceLength, IsThatOfTheService)
{
    Verifies(req::SRS_NODE_043);
    struct Row
    {
        SdoAbort abort;
        std::uint32_t service_bytes;
        DataType type;
        DataType expected;
        std::uint32_t expected_bytes;
    };
    for (const Row& row : {Row{SdoAbort::kNone, 1U, DataType::kInteger32, DataType::kInteger8, 1U},
                           Row{SdoAbort::kNone, 2U, DataType::kInteger32, DataType::kInteger16, 2U},
                           Row{SdoAbort::kNone, 1U, DataType::kUnsigned64, DataType::kUnsigned8, 1U},
                           Row{SdoAbort::kNone, 2U, DataType::kUnsigned32, DataType::kUnsigned16, 2U},
                           Row{SdoAbort::kNone, 4U, DataType::kInteger64, DataType::kInteger32, 4U},
                           Row{SdoAbort::kNone, 4U, DataType::kUnsigned64, DataType::kUnsigned32, 4U},
                           Row{SdoAbort::kNone, 4U, DataType::kInteger32, DataType::kInteger32, 4U},
                           // A history without errors has its length, what cannot be read has none
                           Row{SdoAbort::kNoData, 4U, DataType::kUnsigned8, DataType::kUnsigned32, 4U},
                           Row{SdoAbort::kGeneral, 2U, DataType::kUnsigned8, DataType::kUnsigned8, 1U}})
    {
        Answering service({row.abort, row.service_bytes});
        const bool is_byte = row.type == DataType::kUnsigned8;
        cia301::Entry entry = EntryOf(0x1003U, row.type, 8U, service);
        entry.size_bytes =
            is_byte ? 1U : (row.type == DataType::kInteger32 || row.type == DataType::kUnsigned32 ? 4U : 8U);
        TakeServiceLength(entry);
        EXPECT_EQ(entry.type, row.expected);
        EXPECT_EQ(entry.size_bytes, row.expected_bytes);
    }
}

TEST(ServiceLength, TakesANumberThatItCanHold)
{
    Verifies(req::SRS_NODE_043);
    const auto fitted = [](Octets value, const DataType type, const std::uint32_t size_bytes)
    {
        FitNumber(value, type, size_bytes);
        return value;
    };
    EXPECT_EQ(fitted({5U, 0U, 0U, 0U}, DataType::kUnsigned32, 2U), (Octets{5U, 0U}));
    EXPECT_EQ(fitted({5U}, DataType::kInteger8, 2U), (Octets{5U, 0U}));
    EXPECT_EQ(fitted({}, DataType::kInteger8, 2U), (Octets{0U, 0U}));
    // Too great, negative, and of no number
    EXPECT_EQ(fitted({5U, 0U, 1U, 0U}, DataType::kUnsigned32, 2U), (Octets{5U, 0U, 1U, 0U}));
    EXPECT_EQ(fitted({0xFFU}, DataType::kInteger8, 2U), Octets{0xFFU});
    EXPECT_EQ(fitted({5U, 0U, 0U, 0U}, DataType::kReal32, 2U), Octets{});
}

// What a service does not tell has no identifier that could be one of another service.
TEST(SharedIdentifiersTest, AreNotThoseOfAServiceThatCannotBeRead)
{
    Verifies(req::SRS_NODE_050);
    Answering readable({SdoAbort::kNone, 4U});
    Answering unreadable({SdoAbort::kGeneral, 4U});
    const auto count = [](const std::vector<cia301::Entry>& entries)
    { return SharedIdentifiers({entries.data(), static_cast<std::uint32_t>(entries.size())}, {0x85U, 5U}).size(); };
    // Given 1005h and 1014h with identifier 0
    EXPECT_EQ(count({EntryOf(0x1005U, DataType::kUnsigned32, 4U, readable),
                     EntryOf(0x1014U, DataType::kUnsigned32, 4U, readable)}),
              1U);
    EXPECT_EQ(count({EntryOf(0x1005U, DataType::kUnsigned32, 4U, readable),
                     EntryOf(0x1014U, DataType::kUnsigned32, 4U, unreadable)}),
              0U);
}

// Before services are there, each object has its own value.
TEST(DeviceObjectsTest, WithoutServicesHaveAllValuesOfTheFile)
{
    Verifies(req::SRS_NODE_030);
    Objects objects(Variable("1005", "7", "DefaultValue=0x240\n") + Variable("1014", "7", "DefaultValue=0x240\n"));
    EXPECT_TRUE(objects.objects.NotTaken([](const ObjectAddress&) { return false; }).empty());
    EXPECT_EQ(objects.Read({0x1005U, 0U}), (Octets{0x40U, 0x02U, 0U, 0U}));
    EXPECT_EQ(objects.Read({0x1014U, 0U}), (Octets{0x40U, 0x02U, 0U, 0U}));
}
} // namespace
} // namespace counterpoint::runtime
