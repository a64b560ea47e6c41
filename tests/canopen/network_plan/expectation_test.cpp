// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What a manager expects of the safety configuration of a slave.
#include "tests/canopen/network_plan/plan_rig.hpp"
#include "verification/trace/ids/node.hpp"

namespace counterpoint::network_plan
{
namespace
{
using cia306::test::ExampleText;
using test::Entry;

/// The text with the first `from` behind the head of a section replaced.
std::string With(std::string text, const std::string& section, const std::string& from, const std::string& to)
{
    const std::size_t place = text.find(from, text.find("[" + section + "]"));
    return text.replace(place, from.size(), to);
}

std::vector<cia302::ExpectedObject> ExpectationOf(const std::string& text)
{
    return MakeExpectation(cia306::test::DeviceOf(text), 33U);
}

std::string RefusalOf(const std::string& text)
{
    try
    {
        static_cast<void>(ExpectationOf(text));
    }
    catch (const cia306::InputError& error)
    {
        return error.what();
    }
    return "";
}

// A list that names an object that is no SRDO, and has no section, makes no safety slave.
TEST(Expectation, OfADeviceWithoutSrdosIsEmpty)
{
    Verifies(req::SRS_NET_340);
    const std::string plain = cia306::ReadTextFile(cia306::test::SourceFolder() + "/tests/runtime/data/plain.dcf");
    for (const std::string index : {"0x1028", "0x1300", "0x1341", "0x1406"})
    {
        const std::string text =
            cia306::test::Changed(plain, {{"SupportedObjects=11\n", "SupportedObjects=12\n12=" + index + "\n"}});
        EXPECT_TRUE(ExpectationOf(text).empty()) << index;
    }
}

// A signature that is const is expected once; one of another type, or without a value, is not read.
TEST(Expectation, HasEachConstantOnce)
{
    Verifies(req::SRS_NET_340);
    const std::string text = ExampleText("actuator");
    ASSERT_EQ(ExpectationOf(text).size(), 16U);
    EXPECT_EQ(ExpectationOf(With(text, "13FFsub1", "AccessType=rw", "AccessType=const")).size(), 16U);
    EXPECT_EQ(ExpectationOf(text + "\n" + Entry("13FFsub40", 6, "const", "DefaultValue=1")).size(), 17U);
    EXPECT_EQ(ExpectationOf(text + "\n" + Entry("13FFsub7", 5, "const", "DefaultValue=1")).size(), 16U);
    EXPECT_EQ(ExpectationOf(text + "\n" + Entry("13FFsub7", 6, "const", "")).size(), 16U);
    EXPECT_EQ(ExpectationOf(text + "\n" + Entry("1381sub11", 7, "const", "DefaultValue=0x20000108")).size(), 17U);
}

// A slave with the sides of a pair exchanged is none that anybody may expect.
TEST(Expectation, HasNormalDataOnTheNormalSide)
{
    Verifies(req::SRS_NODE_550);
    const std::string text = With(ExampleText("actuator"), "1381sub1", "=0x22000108", "=0x23000108");
    const std::string refusal = RefusalOf(With(text, "1381sub2", "=0x23000108", "=0x22000108"));
    EXPECT_NE(refusal.find("error: 0x1381:01: normal entry 0x2300:01 is the InvertedSRAD of 0x2200:01"),
              std::string::npos)
        << refusal;
}

// What is not there, has no value or has no such sub-index is no expectation: the file is refused.
TEST(Expectation, IsOfAFileThatHasAllOfIt)
{
    Verifies(req::SRS_NET_004);
    const std::string text = With(ExampleText("actuator"), "13FE", "ParameterValue=0xA5", "ParameterValue=0x00");
    ASSERT_EQ(RefusalOf(text), "");
    const std::string none = " has no value, expected a ParameterValue or DefaultValue";
    EXPECT_EQ(RefusalOf(With(text, "1301sub0", "DefaultValue=6\n", "")), "test.dcf:190:1: error: 0x1301:00:" + none);
    EXPECT_EQ(RefusalOf(With(text, "1301sub4", "DefaultValue=254\n", "")), "test.dcf:227:1: error: 0x1301:04:" + none);
    EXPECT_EQ(RefusalOf(With(text, "13FFsub0", "DefaultValue=1\n", "")), "test.dcf:317:1: error: 0x13FF:00:" + none);
    EXPECT_EQ(RefusalOf(With(With(text, "1300", "DefaultValue=0\n", ""), "1300", "ParameterValue=1\n", "")),
              "test.dcf:174:1: error: 0x1300:00:" + none);
    EXPECT_EQ(RefusalOf(text + "\n" + Entry("13FFsub41", 6, "const", "DefaultValue=1")),
              "test.dcf:652:1: error: 0x13FF:41: sub-index 65 is not defined, expected at most sub-index 64");
    EXPECT_EQ(RefusalOf(text + "\n" + Entry("1381sub81", 7, "const", "DefaultValue=0x20000108")),
              "test.dcf:652:1: error: 0x1381:81: sub-index 129 is not defined, expected at most sub-index 128");
}
} // namespace
} // namespace counterpoint::network_plan
