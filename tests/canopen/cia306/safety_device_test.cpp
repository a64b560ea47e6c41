// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// 5F00h to 5F05h of a device without CANopen Safety are objects of its maker.
#include "canopen/cia306/file/saved.hpp"
#include "canopen/cia306/safety/device_parameters.hpp"
#include "tests/canopen/cia306/check_text.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::cia306
{
namespace
{
std::string VariableOf(const std::string& section, const std::string& type, const std::string& value)
{
    return "[" + section + "]\nParameterName=x\nObjectType=7\nDataType=" + type +
           "\nAccessType=rw\nParameterValue=" + value + "\nPDOMapping=0\n\n";
}

/// Each of them otherwise than a safety device has it: no array, another type, a value out of its range.
const std::string kOfSomebody = VariableOf("5F00", "6", "70") + VariableOf("5F01", "9", "pump") +
                                VariableOf("5F02", "5", "7") + VariableOf("5F03", "8", "1.5") +
                                VariableOf("5F04", "7", "9") + VariableOf("5F05", "5", "300");

/// What check, or the reader, tells of them.
std::vector<std::string> ToldOfParameters(const std::string& text)
{
    std::vector<std::string> told;
    for (const std::string& line : test::FindingsOf(text, CheckOptions{}))
    {
        if (line.find("0x5F0") != std::string::npos)
        {
            told.push_back(line);
        }
    }
    return told;
}

TEST(SafetyDevice, IsOneByItsObjectsItsListsOrItsWord)
{
    Verifies(req::SRS_EDS_670);
    const std::string plain = "[DeviceInfo]\nVendorName=x\n\n";
    const std::string list = "[OptionalObjects]\nSupportedObjects=1\n1=";
    EXPECT_FALSE(test::DeviceOf(plain + kOfSomebody).IsSafetyObject(0x5F00U));
    EXPECT_FALSE(test::DeviceOf("[DeviceInfo]\nCANopenSafetySupported=0\n\n" + kOfSomebody).IsSafetyObject(0x5F02U));
    EXPECT_FALSE(
        test::DeviceOf(plain + VariableOf("12FF", "5", "1") + VariableOf("1400", "5", "1")).IsSafetyObject(0x5F02U));
    EXPECT_FALSE(test::DeviceOf(plain + list + "0x1400\n\n" + kOfSomebody).IsSafetyObject(0x5F02U));
    const std::string of_safety[] = {
        "[DeviceInfo]\nCANopenSafetySupported=1\n\n" + kOfSomebody,
        plain + kOfSomebody + VariableOf("1300", "5", "1"),
        plain + kOfSomebody + VariableOf("13FF", "5", "1"),
        plain + list + "0x1301\n\n" + kOfSomebody,
    };
    for (const std::string& text : of_safety)
    {
        const Device device = test::DeviceOf(text);
        EXPECT_TRUE(device.IsSafetyObject(0x5F00U)) << text;
        EXPECT_TRUE(device.IsSafetyObject(0x5F05U)) << text;
        EXPECT_TRUE(device.IsSafetyObject(0x1300U)) << text;
        EXPECT_TRUE(device.IsSafetyObject(0x13FFU)) << text;
        EXPECT_FALSE(device.IsSafetyObject(0x5EFFU)) << text;
        EXPECT_FALSE(device.IsSafetyObject(0x5F06U)) << text;
        EXPECT_FALSE(device.IsSafetyObject(0x12FFU)) << text;
        EXPECT_FALSE(device.IsSafetyObject(0x1400U)) << text;
        EXPECT_TRUE(device.Find(0x5F02U, 0U)->is_safety) << text;
        EXPECT_FALSE(IsSaved(*device.Find(0x5F02U, 0U))) << text;
    }
}

TEST(SafetyDevice, ObjectsOfAMakerAreCheckedAsAnyOthers)
{
    Verifies(req::SRS_EDS_670);
    const std::string plain = "[DeviceInfo]\nVendorName=x\n\n[ManufacturerObjects]\nSupportedObjects=7\n1=0x5F00\n"
                              "2=0x5F01\n3=0x5F02\n4=0x5F03\n5=0x5F04\n6=0x5F05\n7=0x5F06\n\n";
    const std::string six = plain + kOfSomebody + VariableOf("5F06", "5", "1");
    EXPECT_EQ(
        ToldOfParameters(six),
        (std::vector<std::string>{"warning: 0x5F05:00: ParameterValue: value '300', expected a number from 0 to 255 "
                                  "(UNSIGNED8)"}));
    // One that is only listed is a warning, as of any object
    EXPECT_EQ(
        ToldOfParameters(plain + kOfSomebody.substr(0U, kOfSomebody.find("[5F05]")) + VariableOf("5F06", "5", "1")),
        (std::vector<std::string>{"warning: 0x5F05: is listed, expected a section that describes it"}));
    const Device device = test::DeviceOf(six);
    EXPECT_FALSE(device.Find(0x5F02U, 0U)->is_safety);
    EXPECT_TRUE(IsSaved(*device.Find(0x5F02U, 0U)));
    // In a safety device the same objects are errors
    const std::string safety = test::Changed(six, {{"VendorName=x\n", "VendorName=x\nCANopenSafetySupported=1\n"}});
    EXPECT_FALSE(ToldOfParameters(safety).empty());
    EXPECT_EQ(ToldOfParameters(safety).front().rfind("error: 0x5F0", 0U), 0U) << ToldOfParameters(safety).front();
}

TEST(SafetyDevice, NoParameterIsReadFromAnotherDevice)
{
    Verifies(req::SRS_EDS_670);
    const std::string times = "[5F00]\nParameterName=x\nObjectType=9\nSubNumber=2\n\n" +
                              VariableOf("5F00sub0", "5", "1") + VariableOf("5F00sub1", "7", "2000");
    std::vector<Finding> problems;
    EXPECT_EQ(ReadDeviceParameters(test::DeviceOf("[DeviceInfo]\nVendorName=x\n\n" + times), 5U, problems).cycle_us,
              1000U);
    EXPECT_EQ(ReadDeviceParameters(test::DeviceOf("[DeviceInfo]\nCANopenSafetySupported=1\n\n" + times), 5U, problems)
                  .cycle_us,
              2000U);
    EXPECT_TRUE(problems.empty());
    static_cast<void>(
        ReadDeviceParameters(test::DeviceOf("[DeviceInfo]\nVendorName=x\n\n" + kOfSomebody), 5U, problems));
    EXPECT_TRUE(problems.empty());
}
} // namespace
} // namespace counterpoint::cia306
