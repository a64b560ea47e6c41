// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// An SRDO less in a file.
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/tools/srdo_rig.hpp"
#include "verification/trace/ids/new_device.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace counterpoint::tools
{
namespace
{
using cia306::test::Changed;
using cia306::test::ExampleText;
using test::Answer;
using test::Counted;
using test::LastText;
using test::ObjectsText;
using test::PlaceText;
using test::RunCommand;
using SrdoRemoveTest = test::SrdoRig;

TEST_F(SrdoRemoveTest, RemovingIsTheReverseOfAddingButForObjectsAndPlaces)
{
    Verifies(req::SRS_NEW_015);
    // Given the sensor with an SRDO 2 of its own objects that has values of its own
    const std::string before = Changed(ExampleText("sensor"), {{"[1381]\n", "; mappings\n[1381]\n"}});
    ASSERT_EQ(Add(before, {"--consume", "8@0x111", "--release", "automatic", "--safe-value", "3"}).err, "");
    // When it is removed
    const Answer answer = RunCommand({"srdo", "remove", Path("d.dcf"), "--number", "2"});
    EXPECT_EQ(answer.err, "");
    EXPECT_EQ(answer.out, "SRDO 1 sends 0x101 and 0x102, refresh time 25 ms, SRVT 20 ms, signature 0xB631\n"
                          "  0x2000:01 and 0x2100:01  8 bit  Button 1\n  0x2000:02 and 0x2100:02  8 bit  Button 2\n");
    // Then its parameters are gone, its objects and places stay, the digest is the one of before.
    EXPECT_EQ(
        Written(),
        Changed(before,
                {{"SupportedObjects=8\n1=0x2000", "SupportedObjects=10\n1=0x2000"},
                 {"8=0x5F05\n", "8=0x5F05\n9=0x2200\n10=0x2300\n"},
                 Counted("13FF", "Safety configuration signature"),
                 {"[2000]\n", PlaceText("13FFsub2", "Signature of SRDO 2", "0x0006", "0x0000", "0x0000") + "[2000]\n"},
                 {"[5F00]\n", ObjectsText() + "[5F00]\n"},
                 Counted("5F01", "Release policy"),
                 {"[5F02]\n", PlaceText("5F01sub2", "Release policy of SRDO 2", "0x0005", "0x00", "0x00") + "[5F02]\n"},
                 Counted("5F02", "Safe value"),
                 {"[5F03]\n",
                  PlaceText("5F02sub2", "Safe value of SRDO 2", "0x001B", "0x0000000000000000", "0x0000000000000000") +
                      "[5F03]\n"},
                 Counted("5F03", "Producer form"),
                 {"[5F04]\n", PlaceText("5F03sub2", "Producer form of SRDO 2", "0x0005", "0x00", "0x00") + "[5F04]\n"},
                 Counted("5F05", "SRVT detection")}) +
            "\n" + LastText().substr(0U, LastText().size() - 1U));
    EXPECT_EQ(RunCommand({"check", Path("d.dcf")}).out, "");
}

TEST_F(SrdoRemoveTest, RemovingFromTheMiddleMovesTheListUp)
{
    Verifies(req::SRS_NEW_015);
    const std::string before = Changed(ExampleText("controller"), {{"Gaps between SRDO numbers (0x99: searched)\n"
                                                                    "ObjectType=0x7\nDataType=0x0005\nAccessType=rw\n"
                                                                    "DefaultValue=0x00\nParameterValue=0x00",
                                                                    "Gaps between SRDO numbers (0x99: searched)\n"
                                                                    "ObjectType=0x7\nDataType=0x0005\nAccessType=rw\n"
                                                                    "DefaultValue=0x00\nParameterValue=0x99"}});
    const std::string file = File("d.dcf", before);
    ASSERT_EQ(RunCommand({"sign", file, "--write", file}).status, 0);
    EXPECT_EQ(RunCommand({"srdo", "remove", file, "--number", "1"}).err, "");
    const std::string text = Written();
    EXPECT_NE(text.find("[OptionalObjects]\nSupportedObjects=8\n1=0x1014\n2=0x1015\n3=0x1017\n4=0x1300\n5=0x1302\n"
                        "6=0x1382\n7=0x13FE\n8=0x13FF\n\n"),
              std::string::npos);
    EXPECT_EQ(Device().Find(0x1301U), nullptr);
    EXPECT_EQ(Device().Find(0x1381U), nullptr);
    EXPECT_EQ(Value(0x13FFU, 1U), "0x0000");
    EXPECT_EQ(RunCommand({"check", file}).out, "");
    // The number is free again.
    EXPECT_EQ(RunCommand({"srdo", "add", file, "--consume", "8@0x101"}).out.substr(0U, 31U),
              "SRDO 1 receives 0x101 and 0x102");
}

TEST_F(SrdoRemoveTest, RemovingWhatMustStayIsRefused)
{
    Verifies(req::SRS_NEW_012);
    Verifies(req::SRS_NEW_015);
    const std::string sensor = ExampleText("sensor");
    const std::string file = File("d.dcf", sensor);
    EXPECT_EQ(RunCommand({"srdo", "remove", file, "--number", "2"}).err,
              file + ": error: there is no SRDO 2, expected one that the file has (srdo list)\n");
    // The only one: what is left would be no safety device.
    const Answer last = RunCommand({"srdo", "remove", file, "--number", "1"});
    EXPECT_EQ(last.status, 2);
    EXPECT_EQ(last.err,
              file + ": error: SRDO 1 is the only one, expected another one that stays: a safety device needs one\n");
    EXPECT_EQ(Written(), sensor);
}

// An SRDO that stays and whose signature is wrong is not signed in passing.
TEST_F(SrdoRemoveTest, RemovingBesideAnErrorIsRefused)
{
    Verifies(req::SRS_NEW_012);
    Verifies(req::SRS_NEW_015);
    ASSERT_EQ(Add(ExampleText("sensor"), {"--consume", "8@0x111"}).err, "");
    const std::string wrong = Changed(Written(), {{"ParameterValue=0xB631", "ParameterValue=0xB632"}});
    static_cast<void>(File("d.dcf", wrong));
    const Answer answer = RunCommand({"srdo", "remove", Path("d.dcf"), "--number", "2"});
    EXPECT_EQ(answer.status, 2);
    EXPECT_NE(answer.err.find(": error: "), std::string::npos) << answer.err;
    EXPECT_EQ(Written(), wrong);
}

TEST_F(SrdoRemoveTest, RemovingTellsNoWarningOfBefore)
{
    Verifies(req::SRS_NEW_016);
    for (const bool is_json : {false, true})
    {
        ASSERT_EQ(Add(ExampleText("sensor"), {"--consume", "8@0x111"}).err, "");
        static_cast<void>(
            File("d.dcf", Changed(Written(), {{"CANopenSafetySupported=1\n", "CANopenSafetySupported=0\n"}})));
        std::vector<std::string> words{"srdo", "remove", Path("d.dcf"), "--number", "2"};
        words.insert(words.end(), is_json ? 1U : 0U, "--json");
        const Answer removed = RunCommand(words);
        EXPECT_EQ(removed.status, 0);
        EXPECT_EQ(removed.err, "");
        EXPECT_TRUE(!is_json || nlohmann::json::parse(removed.out).at("warnings").empty()) << removed.out;
        EXPECT_NE(RunCommand({"check", Path("d.dcf")}).out.find("CANopenSafetySupported"), std::string::npos);
    }
}
} // namespace
} // namespace counterpoint::tools
