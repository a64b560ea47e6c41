// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Concise DCFs: what is written to a device, and in which order.
#include "canopen/cia306/text/input_error.hpp"
#include "tests/canopen/network_plan/plan_rig.hpp"
#include "verification/trace/ids/eds.hpp"

namespace counterpoint::network_plan
{
namespace
{
using test::Entry;
using test::Number;
using test::Record;
using test::TextsOf;
using Texts = std::vector<std::string>;

Texts ConciseOf(const std::string& text)
{
    return TextsOf(MakeConcise(cia306::test::DeviceOf("[DeviceInfo]\nVendorName=test\n\n" + text), 5U));
}

TEST(Concise, HasWhatCanBeWrittenAndIsConfigured)
{
    Verifies(req::SRS_NET_003);
    EXPECT_EQ(ConciseOf(Entry("2000", 6, "rw", "ParameterValue=0x1234") + Entry("2001", 6, "rw", "DefaultValue=1") +
                        Entry("2002", 6, "const", "ParameterValue=2") + Entry("2003", 6, "ro", "ParameterValue=3") +
                        Entry("2004", 6, "wo", "ParameterValue=4") + Entry("2005", 9, "rw", "ParameterValue=AB")),
              (Texts{"2000:00=34 12", "2004:00=04 00", "2005:00=41 42"}));
}

// Store, restore, programs, network management; and what is no object but a type.
TEST(Concise, LeavesOutCommandsAndTypes)
{
    Verifies(req::SRS_NET_003);
    EXPECT_EQ(ConciseOf(Number("0005", "1") + Number("100F", "1") + Number("1010", "2") + Number("1011", "3") +
                        Number("1012", "4") + Number("1F4F", "5") + Number("1F50", "6") + Number("1F5F", "7") +
                        Number("1F60", "8") + Number("1F7F", "9") + Number("1F80", "10") + Number("1F91", "11") +
                        Number("1F92", "12")),
              (Texts{"100F:00=01 00 00 00", "1012:00=04 00 00 00", "1F4F:00=05 00 00 00", "1F60:00=08 00 00 00",
                     "1F7F:00=09 00 00 00", "1F92:00=0C 00 00 00"}));
}

// Bit 0 of ObjFlags, of an entry or of its object.
TEST(Concise, LeavesOutWhatADownloadIsNotToWrite)
{
    Verifies(req::SRS_MGR_322);
    EXPECT_EQ(ConciseOf(Entry("2000", 6, "rw", "ParameterValue=1\nObjFlags=1") +
                        Entry("2001", 6, "rw", "ParameterValue=2\nObjFlags=0x3") +
                        Entry("2002", 6, "rw", "ParameterValue=3\nObjFlags=2") +
                        Entry("2003", 6, "rw", "ParameterValue=4\nObjFlags=0") +
                        Entry("2004", 6, "rw", "ParameterValue=5\nObjFlags=no")),
              (Texts{"2002:00=03 00", "2003:00=04 00", "2004:00=05 00"}));
    const std::string entries = Number("2000sub1", "1") + Entry("2000sub2", 7, "rw", "ParameterValue=2\nObjFlags=1");
    EXPECT_EQ(ConciseOf(Record("2000", 3) + entries), Texts{"2000:01=01 00 00 00"});
    EXPECT_EQ(ConciseOf("[2000]\nParameterName=x\nObjectType=9\nSubNumber=3\nObjFlags=1\n\n" + entries), Texts{});
    // A PDO whose identifier is not to be written stays as it is
    EXPECT_EQ(ConciseOf(Record("1800", 3) + Entry("1800sub1", 7, "rw", "ParameterValue=0x185\nObjFlags=1") +
                        Entry("1800sub2", 5, "rw", "ParameterValue=254")),
              Texts{"1800:02=FE"});
}

TEST(Concise, HasTheConfigurationDateAtItsEnd)
{
    Verifies(req::SRS_NET_003);
    EXPECT_EQ(ConciseOf(Record("1020", 2) + Number("1020sub1", "7") + Number("1005", "0x80") + Number("2000", "1")),
              (Texts{"1005:00=80 00 00 00", "2000:00=01 00 00 00", "1020:01=07 00 00 00"}));
}

// 5F00h to 5F05h are the project's own in a safety device alone.
TEST(Concise, LeavesOutTheSafetyParametersOfASafetyDevice)
{
    Verifies(req::SRS_NET_672);
    const std::string objects = Number("5F00", "1") + Number("5F04", "2") + Number("5F06", "3");
    const Texts all{"5F00:00=01 00 00 00", "5F04:00=02 00 00 00", "5F06:00=03 00 00 00"};
    EXPECT_EQ(ConciseOf(objects), all);
    EXPECT_EQ(TextsOf(MakeConcise(cia306::test::DeviceOf("[DeviceInfo]\nCANopenSafetySupported=0\n\n" + objects), 5U)),
              all);
    EXPECT_EQ(TextsOf(MakeConcise(cia306::test::DeviceOf("[DeviceInfo]\nCANopenSafetySupported=1\n\n" + objects), 5U)),
              Texts{"5F06:00=03 00 00 00"});
    // Of another maker with one of them alone
    EXPECT_EQ(ConciseOf(Number("5F04", "2") + Number("5F06", "3")),
              (Texts{"5F04:00=02 00 00 00", "5F06:00=03 00 00 00"}));
    // A safety device that does not say so, whose objects are there or only listed
    EXPECT_EQ(ConciseOf(Number("1300", "1") + objects), Texts{"5F06:00=03 00 00 00"});
    EXPECT_EQ(ConciseOf("[OptionalObjects]\nSupportedObjects=1\n1=0x1301\n\n" + objects), Texts{"5F06:00=03 00 00 00"});
}

// As `node` and `generate` take them from the same file.
TEST(Concise, HasStringsAsTheyAreOnTheBus)
{
    Verifies(req::SRS_NET_671);
    EXPECT_EQ(ConciseOf(Entry("2000", 10, "rw", "ParameterValue=DEADBEEF01") +
                        Entry("2001", 10, "rw", "ParameterValue=de AD\tbe ef") +
                        Entry("2002", 10, "rw", "ParameterValue=ABC") + Entry("2003", 10, "rw", "ParameterValue=XY") +
                        Entry("2004", 11, "rw", "ParameterValue=G\xC3\xB6") +
                        Entry("2005", 9, "rw", "ParameterValue=G\xC3\xB6")),
              (Texts{"2000:00=DE AD BE EF 01", "2001:00=DE AD BE EF", "2002:00=41 42 43", "2003:00=58 59",
                     "2004:00=47 00 F6 00", "2005:00=47 C3 B6"}));
}

// What the reader warns of, and check, node and generate leave out, too.
TEST(Concise, LeavesOutAValueThatItsTypeCannotHave)
{
    Verifies(req::SRS_EDS_032);
    EXPECT_EQ(ConciseOf(Entry("2000", 6, "rw", "ParameterValue=70000") + Entry("2001", 6, "rw", "ParameterValue=7") +
                        Entry("2002", 3, "rw", "DefaultValue=1\nParameterValue=-32769") +
                        Entry("2003", 6, "rw", "ParameterValue=0xFFFF")),
              (Texts{"2001:00=07 00", "2003:00=FF FF"}));
    // Of a PDO: its parameter, its identifier, its count
    const std::string identifier = Record("1800", 3) + Number("1800sub1", "0x185");
    EXPECT_EQ(ConciseOf(identifier + Entry("1800sub2", 5, "rw", "ParameterValue=256")),
              (Texts{"1800:01=85 01 00 80", "1800:01=85 01 00 00"}));
    EXPECT_EQ(ConciseOf(Record("1800", 3) + Number("1800sub1", "0x100000000") +
                        Entry("1800sub2", 5, "rw", "ParameterValue=254")),
              Texts{"1800:02=FE"});
    EXPECT_EQ(ConciseOf(identifier + Record("1A00", 2) + Entry("1A00sub0", 5, "rw", "ParameterValue=300") +
                        Number("1A00sub1", "0x60000108")),
              (Texts{"1800:01=85 01 00 80", "1800:01=85 01 00 00"}));
}

// Off, parameters, mapping off, mapping, on, whichever of them the file configures.
TEST(ConcisePdo, IsOffWhileItIsChanged)
{
    Verifies(req::SRS_NET_003);
    const std::string mapping =
        Record("1A00", 2) + Entry("1A00sub0", 5, "rw", "ParameterValue=1") + Number("1A00sub1", "0x60000108");
    EXPECT_EQ(ConciseOf(Record("1800", 3) + Number("1800sub1", "0x185") +
                        Entry("1800sub2", 5, "rw", "ParameterValue=254") + mapping),
              (Texts{"1800:01=85 01 00 80", "1800:02=FE", "1A00:00=00", "1A00:01=08 01 00 60", "1A00:00=01",
                     "1800:01=85 01 00 00"}));
    // The mapping alone is configured: the identifier is the default one
    EXPECT_EQ(ConciseOf(Record("1800", 2) + Entry("1800sub1", 7, "rw", "DefaultValue=$NODEID+0x180") + mapping),
              (Texts{"1800:01=85 01 00 80", "1A00:00=00", "1A00:01=08 01 00 60", "1A00:00=01", "1800:01=85 01 00 00"}));
    // A parameter alone, without a mapping in the file
    EXPECT_EQ(ConciseOf(Record("1800", 3) + Number("1800sub1", "0x185") + Entry("1800sub2", 5, "rw", "DefaultValue=1")),
              (Texts{"1800:01=85 01 00 80", "1800:01=85 01 00 00"}));
    // Nothing is configured
    EXPECT_EQ(ConciseOf(Record("1800", 2) + Entry("1800sub1", 7, "rw", "DefaultValue=0x185")), Texts{});
}

TEST(ConcisePdo, WhoseIdentifierCannotChangeStaysOn)
{
    Verifies(req::SRS_NET_003);
    const std::string type = Entry("1800sub2", 5, "rw", "ParameterValue=254");
    EXPECT_EQ(ConciseOf(Record("1800", 2) + type), Texts{"1800:02=FE"});
    EXPECT_EQ(ConciseOf(Record("1800", 3) + Entry("1800sub1", 7, "ro", "DefaultValue=0x185") + type),
              Texts{"1800:02=FE"});
    EXPECT_EQ(ConciseOf(Record("1800", 3) + Entry("1800sub1", 7, "rw", "") + type), Texts{"1800:02=FE"});
}

// Given a mapping whose count has no value, then nobody knows what is to be written, and the file is refused there.
TEST(ConcisePdo, WhoseCountHasNoValueIsRefused)
{
    Verifies(req::SRS_NET_003);
    const std::string text = Record("1800", 2) + Number("1800sub1", "0x185") + Record("1A00", 2) +
                             Entry("1A00sub0", 5, "rw", "") + Number("1A00sub1", "0x60000108");
    try
    {
        static_cast<void>(ConciseOf(text));
        ADD_FAILURE() << "taken";
    }
    catch (const cia306::InputError& problem)
    {
        EXPECT_NE(std::string(problem.what()).find("0x1A00:00: no value, expected a ParameterValue or DefaultValue"),
                  std::string::npos)
            << problem.what();
    }
}

// A mapping whose count cannot be written cannot change; one without a PDO is an object like others.
TEST(ConcisePdo, WhoseCountCannotBeWrittenKeepsItsMapping)
{
    Verifies(req::SRS_NET_003);
    const std::string field = Number("1A00sub1", "0x60000108");
    const std::string identifier = Record("1800", 2) + Number("1800sub1", "0x185");
    const Texts nothing{"1800:01=85 01 00 80", "1800:01=85 01 00 00"};
    EXPECT_EQ(ConciseOf(identifier + Record("1A00", 2) + Entry("1A00sub0", 5, "const", "DefaultValue=1") + field),
              nothing);
    EXPECT_EQ(ConciseOf(identifier + Record("1A00", 1) + field), nothing);
    EXPECT_EQ(ConciseOf(Record("1A00", 2) + Entry("1A00sub0", 5, "rw", "ParameterValue=1") + field),
              (Texts{"1A00:00=01", "1A00:01=08 01 00 60"}));
}

TEST(NumberOfAnEntry, IsTheUsualOneWhereThereIsNone)
{
    Verifies(req::SRS_NET_003);
    const cia306::Device device = cia306::test::DeviceOf(Number("2000", "7") + Entry("2001", 7, "rw", "") +
                                                         Entry("2002", 7, "rw", "DefaultValue=$NODEID+1"));
    EXPECT_EQ(NumberOf(device, 5U, 0x2000U, 0U, 9U), 7U);
    EXPECT_EQ(NumberOf(device, 5U, 0x2001U, 0U, 9U), 9U);
    EXPECT_EQ(NumberOf(device, 5U, 0x2002U, 0U, 9U), 6U);
    EXPECT_EQ(NumberOf(device, 5U, 0x2003U, 0U, 9U), 9U);
    EXPECT_EQ(NumberOf(cia306::test::DeviceOf(Number("2000", "0x100000000")), 5U, 0x2000U, 0U, 9U), 9U);
}
} // namespace
} // namespace counterpoint::network_plan
