// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What a manager expects of a safety slave beside 1300h to 13FFh.
#include "tests/canopen/network_plan/plan_rig.hpp"

namespace counterpoint::network_plan
{
namespace
{
using cia306::test::ExampleText;
using Lines = std::vector<std::string>;

/// The text with another line in a section.
std::string Having(std::string text, const std::string& section, const std::string& from, const std::string& to)
{
    const std::size_t place = text.find(from, text.find("[" + section + "]"));
    return text.replace(place, from.size(), to);
}

std::string ActuatorWithoutDigest()
{
    return Having(ExampleText("actuator"), "5F04", "ParameterValue=0x046FFAB7", "ParameterValue=0");
}

/// "5F04:00=46FFAB7" of each expected object behind 13FFh; all are fixed.
std::vector<std::string> BehindSignatures(const std::string& text)
{
    std::vector<std::string> told;
    const std::vector<cia302::ExpectedObject> objects = MakeExpectation(cia306::test::DeviceOf(text), 33U);
    for (const cia302::ExpectedObject& object : objects)
    {
        if (object.address.index > 0x13FFU)
        {
            EXPECT_TRUE(object.is_fixed) << object.address.index;
            told.push_back(cia306::Hex(object.address.index, 4).substr(2U) + ":" +
                           cia306::Hex(object.address.sub, 2).substr(2U) + "=" +
                           cia306::Hex(object.value, 1).substr(2U));
        }
    }
    const cia302::SafetyExpectation expectation{objects.data(), static_cast<std::uint16_t>(objects.size())};
    EXPECT_TRUE(cia302::IsUsable(expectation));
    return told;
}

TEST(ExpectedParameters, TheDigestStandsForAll)
{
    Verifies(req::SRS_NET_670);
    EXPECT_EQ(BehindSignatures(ExampleText("actuator")), Lines{"5F04:00=46FFAB7"});
}

TEST(ExpectedParameters, WithoutADigestEachThatTheFileHas)
{
    Verifies(req::SRS_NET_670);
    EXPECT_EQ(BehindSignatures(ActuatorWithoutDigest()), (Lines{"5F01:01=0", "5F02:01=0", "5F05:01=0"}));
    std::string text = Having(ActuatorWithoutDigest(), "5F01sub1", "ParameterValue=0x00", "ParameterValue=0x5A");
    text = Having(text, "5F02sub1", "ParameterValue=0x0000000000000000", "ParameterValue=0x8000000000000007");
    text = Having(text, "5F05sub1", "ParameterValue=0x00", "ParameterValue=0x3C");
    EXPECT_EQ(BehindSignatures(text), (Lines{"5F01:01=5A", "5F02:01=8000000000000007", "5F05:01=3C"}));
    // By its DefaultValue, and not at all where the file gives none
    text = Having(text, "5F01sub1", "ParameterValue=0x5A\n", "");
    text = Having(text, "5F05sub1", "DefaultValue=0x00\nParameterValue=0x3C\n", "");
    EXPECT_EQ(BehindSignatures(text), (Lines{"5F01:01=0", "5F02:01=8000000000000007"}));
}

TEST(ExpectedParameters, OfADeviceOfAnotherMakerAreNone)
{
    Verifies(req::SRS_NET_670);
    std::string text = ExampleText("actuator");
    text.erase(text.find("[5F00]"));
    text = cia306::test::Changed(text, {{"SupportedObjects=8\n1=0x2200\n2=0x2300\n3=0x5F00\n4=0x5F01\n5=0x5F02\n"
                                         "6=0x5F03\n7=0x5F04\n8=0x5F05\n",
                                         "SupportedObjects=2\n1=0x2200\n2=0x2300\n"}});
    EXPECT_EQ(BehindSignatures(text), Lines{});
    EXPECT_EQ(MakeExpectation(cia306::test::DeviceOf(text), 33U).size(), 15U);
}
} // namespace
} // namespace counterpoint::network_plan
