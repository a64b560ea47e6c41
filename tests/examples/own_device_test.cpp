// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The file of the firmware's template. That its program writes what stands there, the scenarios of `./dev firmware`
// show: a kernel with another configuration does not start.
#include "tests/canopen/cia306/check_text.hpp"
#include "verification/trace/ids/verification.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace counterpoint
{
namespace
{

const char* const kFile = COUNTERPOINT_SOURCE_FOLDER "/examples/firmware/own_device/own_device.dcf";

TEST(OwnDeviceFile, CheckFindsNothing)
{
    Verifies(req::SRS_VER_019);
    // Given the file as it is in the tree, when it is checked, then nothing is found
    EXPECT_EQ(cia306::test::FindingsOf(cia306::ReadTextFile(kFile), {}), std::vector<std::string>{});
}

TEST(OwnDeviceFile, HasTheSignaturesAndTheDigestOfTheProgram)
{
    Verifies(req::SRS_VER_019);
    // Given the values that own_application.cpp writes
    const std::string text = cia306::ReadTextFile(kFile);
    // Then each stands in the file
    for (const char* value : {"ParameterValue=0xE570", "ParameterValue=0x0E21", "ParameterValue=0xE070",
                              "ParameterValue=0x0B21", "ParameterValue=0x95777803"})
    {
        EXPECT_NE(text.find(value), std::string::npos) << value;
    }
}

} // namespace
} // namespace counterpoint
