// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What the check says of values that cannot be read, of SRDOs that are off, and of files that have hardly anything.
#include "tests/canopen/cia306/check_text.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace counterpoint::cia306
{
namespace
{
using Lines = std::vector<std::string>;
using test::SrdoText;

/// What is found about an object, without what is told of it because a list lacks it.
Lines About(const std::string& object, const std::string& text, const CheckOptions& options = {})
{
    Lines told;
    for (const std::string& finding : test::FindingsOf(text, options))
    {
        const bool is_meant = finding.find(object) != std::string::npos;
        if (is_meant && finding.find("in none of the lists") == std::string::npos)
        {
            told.push_back(finding);
        }
    }
    return told;
}

TEST(CheckUnread, ASrdoThatIsOffMayHaveNoIdentifierAtAllOrTwo)
{
    Verifies(req::SRS_CLI_010);
    EXPECT_EQ(About("0x1302:0", test::SrdoFileText({{2, "0", "25", "20", "0", "0", {}}})), Lines{});
    EXPECT_EQ(About("0x1302:0", test::SrdoFileText({{2, "0", "25", "20", "0", "0x104", {}}})),
              Lines{"error: 0x1302:05: COB-ID 0x000, expected a COB-ID from 0x101 to 0x180"});
}

TEST(CheckUnread, AnIdentifierOfTwoIsAnErrorWhereBothAreOn)
{
    Verifies(req::SRS_CLI_010);
    const auto about = [](const std::string& first, const std::string& second)
    {
        return About("is in use by", test::SrdoFileText({{1, first, "25", "20", "0x101", "0x102", {}},
                                                         {2, second, "25", "20", "0x101", "0x104", {}}}));
    };
    EXPECT_EQ(about("1", "1"),
              Lines{"error: 0x1302:05: COB-ID 0x101 is in use by SRDO 1, expected an identifier of its own"});
    EXPECT_EQ(
        about("0", "1"),
        Lines{"warning: 0x1302:05: COB-ID 0x101 is in use by SRDO 1, one is off, expected an identifier of its own"});
    EXPECT_EQ(
        about("1", "0"),
        Lines{"warning: 0x1302:05: COB-ID 0x101 is in use by SRDO 1, one is off, expected an identifier of its own"});
    EXPECT_EQ(
        about("0", "0"),
        Lines{"warning: 0x1302:05: COB-ID 0x101 is in use by SRDO 1, both are off, expected an identifier of its own"});
}

TEST(CheckUnread, ADefaultIdentifierThatIsNoNumberIsToldOnce)
{
    Verifies(req::SRS_CLI_010);
    CheckOptions options;
    options.node_id = std::uint8_t{5U};
    EXPECT_EQ(
        About("0x1301:05", test::SrdoFileText({{1, "1", "25", "20", "many", "0x102", {}}}), options),
        Lines{
            "error: 0x1301:05: value 'many', expected a number from 0 to 4294967295 (UNSIGNED32), or $NODEID+number"});
}

TEST(CheckUnread, AGapInAMappingIsNoPair)
{
    Verifies(req::SRS_CLI_012);
    std::string text =
        test::SrdoFileText({{1, "1", "25", "20", "0x101", "0x102", {"0x20000108", "0x20010108", "0x20000108"}}});
    const std::size_t second = text.find("[1381sub2]");
    text.erase(second, text.find("[1381sub3]") - second);
    EXPECT_EQ(
        About("0x1381", text),
        (Lines{"error: 0x1381:02: is missing, expected an object of type UNSIGNED32",
               "error: 0x1381:00: 3 mapping entries, expected an even number: one normal and one inverse entry a pair",
               "error: 0x1381:01: mapped object 0x2000:01 is unknown, expected an object that the file describes",
               "error: 0x1381:03: mapped object 0x2000:01 is unknown, expected an object that the file describes",
               "error: 0x1381:03: object 0x2000:01 is mapped twice, expected another object than in sub-index 1"}));
}

TEST(CheckUnread, AHighestSubIndexThatIsNoNumberSaysNothing)
{
    Verifies(req::SRS_CLI_039);
    const auto record = [](const std::string& count)
    {
        return "[DeviceInfo]\nVendorName=x\n[2000]\nParameterName=r\nObjectType=9\nSubNumber=2\n[2000sub0]"
               "\nParameterName=n\nDataType=5\nAccessType=ro\n"
               "DefaultValue=" +
               count + "\n[2000sub1]\nParameterName=a\nDataType=5\nAccessType=rw\n";
    };
    EXPECT_EQ(About("0x2000:00", record("many")), Lines{"warning: 0x2000:00: DefaultValue: value 'many', expected a "
                                                        "number from 0 to 255 (UNSIGNED8), or $NODEID+number"});
    EXPECT_EQ(About("0x2000:00", record("2")),
              Lines{"warning: 0x2000:00: highest sub-index 2, expected 1, the highest one that the file describes"});
}

TEST(CheckUnread, ASafetyObjectWithoutAnySrdo)
{
    Verifies(req::SRS_CLI_017);
    EXPECT_EQ(
        test::FindingsOf("[DeviceInfo]\nVendorName=x\n" + test::VariableText("13FE", "0x0005", "0"), {}),
        (Lines{"warning: no node-ID, expected NodeID in [DeviceComissioning], --node-id, or LSS_Supported=1 in "
               "[DeviceInfo]",
               "warning: 0x13FE: is in none of the lists [MandatoryObjects], [OptionalObjects], [ManufacturerObjects]",
               "error: 0x13FE: a safety object and no SRDO, expected communication parameters at 0x1301 to 0x1340"}));
}

TEST(CheckUnread, ASignatureOfNoSrdoThatIsNoNumber)
{
    Verifies(req::SRS_CLI_016);
    const std::string text = test::SrdoFileText({{1, "0", "25", "20", "0x101", "0x102", {}}});
    EXPECT_EQ(
        About("0x13FF:03", text + test::VariableText("13FFsub3", "0x0006", "many")),
        Lines{"error: 0x13FF:03: value 'many', expected a number from 0 to 65535 (UNSIGNED16), or $NODEID+number"});
    EXPECT_EQ(About("0x13FF:03", text + test::VariableText("13FFsub3", "0x0006", "0x12")),
              Lines{"warning: 0x13FF:03: signature 0x0012 of an SRDO that does not exist, expected 0x0000"});
    EXPECT_EQ(About("0x13FF:03", text + test::VariableText("13FFsub3", "0x0006", "0")), Lines{});
}

TEST(CheckUnread, AParameterValueOfAConstantEntryThatIsNoNumber)
{
    Verifies(req::SRS_CLI_023);
    // Given a mapping that nobody can write
    const auto constant = [](const std::string& own, const std::string& written)
    {
        std::string text = test::SrdoFileText({{1, "1", "25", "20", "0x101", "0x102", {own, "0x20010108"}}});
        for (const std::string section : {"[1381sub0]", "[1381sub1]", "[1381sub2]"})
        {
            const std::size_t access = text.find("AccessType=rw", text.find(section));
            text.replace(access, 13U, "AccessType=ro");
        }
        text.insert(text.find("PDOMapping", text.find("[1381sub1]")), "ParameterValue=" + written + "\n");
        Lines told;
        for (const std::string& finding : About("0x1381:01", text))
        {
            told.push_back(finding.substr(0U, finding.find(" for an entry")));
        }
        return told;
    };
    const std::string unknown = "error: 0x1381:01: mapped object 0x2000:01 is unknown, expected an object that the "
                                "file describes";
    EXPECT_EQ(constant("0x20000108", "0x20000108"),
              (Lines{unknown, "warning: 0x1381:01: ParameterValue '0x20000108'"}));
    EXPECT_EQ(
        constant("0x20000108", "many"),
        (Lines{"error: 0x1381:01: value 'many', expected a number from 0 to 4294967295 (UNSIGNED32), or $NODEID+number",
               "error: 0x1381:01: ParameterValue 'many'"}));
    EXPECT_EQ(constant("many", "0x20000108"), (Lines{unknown, "error: 0x1381:01: ParameterValue '0x20000108'"}));
}

TEST(CheckUnread, ADefaultOfTheDeviceThatDoesNotFitIsToldOfTheFile)
{
    Verifies(req::SRS_CLI_018);
    // Given a cycle of 1 s, and the interval of tests that counts without a sub-index of its own
    const std::string text = test::SrdoFileText({{1, "1", "25", "20", "0x101", "0x102", {}}}) +
                             "[5F00]\nParameterName=p\nObjectType=0x9\nSubNumber=2\n" +
                             test::VariableText("5F00sub0", "0x0005", "1") +
                             test::VariableText("5F00sub1", "0x0007", "1000000");
    const Lines told = About("0x5F00:05", text);
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(
        told[0],
        "error: 0x5F00:05: test interval of 1000 ms, expected at least 15007500 us, 15 cycles with their tolerance");
    for (const Finding& finding : CheckDevice(test::DeviceOf(text), {}))
    {
        EXPECT_TRUE((finding.object != "0x5F00:05") || (finding.place == Place{1U, 1U}));
    }
}

TEST(CheckSrdosThatAreOff, AValidConfigurationWithoutAnSrdoThatIsOn)
{
    Verifies(req::SRS_CLI_330);
    const std::string none = "warning: 0x1301:01: no SRDO is on: the device sends and receives none, and 'counterpoint "
                             "monitor' watches none, expected 1 (producer) or 2 (consumer) in the direction of one";
    // Given a controller with two SRDOs, when both are off
    const test::Set first{"1301sub1", "ParameterValue", "0"};
    const test::Set second{"1302sub1", "ParameterValue", "0"};
    const std::string text = test::ExampleText("controller");
    const std::string off = test::SignedAgain(test::WithValues(text, {first, second}), std::nullopt);
    EXPECT_EQ(test::FindingsOf(off, {}), Lines{none});
    // One that is on does
    EXPECT_EQ(test::FindingsOf(test::SignedAgain(test::WithValues(text, {first}), std::nullopt), {}), Lines{});
    // And one that is not declared valid yet has nothing to declare
    EXPECT_EQ(test::FindingsOf(test::WithValues(off, {{"13FE", "ParameterValue", "0"}}), {}),
              Lines{"warning: 0x13FE:00: 0x00: the SRDOs stay off, expected 0xA5 to set them going"});
}
} // namespace
} // namespace counterpoint::cia306
