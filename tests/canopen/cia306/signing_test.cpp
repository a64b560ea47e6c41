// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/safety/signing.hpp"

#include "canopen/cia306/safety/signature.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <string>

namespace counterpoint::cia306
{
namespace
{
using test::Changed;
using test::ExampleText;

std::string Signed(const std::string& text)
{
    const IniDocument document = IniDocument::Parse("test.dcf", text);
    const Device device = ReadDevice(document);
    return WithSignatures(document, device, device.node_id).Text();
}

std::string RefusalOfSigning(const std::string& text)
{
    try
    {
        (void)Signed(text);
    }
    catch (const InputError& error)
    {
        return error.what();
    }
    return "";
}

TEST(Signing, AnExampleIsSignedAlready)
{
    Verifies(req::SRS_CLI_005);
    for (const char* name : {"sensor", "controller", "actuator"})
    {
        EXPECT_EQ(Signed(ExampleText(name)), ExampleText(name));
    }
}

TEST(Signing, WhatIsRightIsKeptAsItIsSpelled)
{
    Verifies(req::SRS_EDS_005);
    const std::string spelled = Changed(ExampleText("sensor"), {{"0xB631", "46641"}, {"0x66596575", "0x66596575 "}});
    EXPECT_EQ(Signed(spelled), spelled);
}

TEST(Signing, ChangesNothingButTheSignatures)
{
    Verifies(req::SRS_CLI_005);
    const std::string before = Changed(
        ExampleText("controller"), {{"ParameterValue=0xE3BF\n", ""}, {"ParameterValue=0xCA45", "ParameterValue=1"}});
    const std::string after = Changed(
        before, {{"DefaultValue=0x0000\nPDOMapping=0\n\n[13FFsub2]",
                  "DefaultValue=0x0000\nParameterValue=0xE3BF\nPDOMapping=0\n\n[13FFsub2]"},
                 {"ParameterValue=1\nPDOMapping=0\n\n[2000]", "ParameterValue=0xCA45\nPDOMapping=0\n\n[2000]"}});
    EXPECT_EQ(Signed(before), after);
    EXPECT_EQ(after, ExampleText("controller"));
}

TEST(Signing, ACompactSignatureObjectGetsASectionOfValues)
{
    Verifies(req::SRS_CLI_005);
    const std::string before = ReadTextFile(test::SourceFolder() + "/tests/canopen/cia306/data/compact.dcf");
    const std::string once = Signed(before);
    EXPECT_EQ(once, before + "\n\n[13FFValue]\nNrOfEntries=2\n1=0x4B2D\n3=0x9880\n");
    EXPECT_EQ(Signed(once), once);
    const std::string partly = before + "\n[13FFValue]\nNrOfEntries=2\n2=7\n0x1=9\n";
    EXPECT_EQ(Signed(partly), before + "\n[13FFValue]\nNrOfEntries=3\n2=7\n0x1=0x4B2D\n3=0x9880\n");
}

TEST(Signing, WhatDoesNotReadBackAsItWasSignedIsRefused)
{
    Verifies(req::SRS_CLI_006);
    const std::string example = ExampleText("sensor");
    const auto refusal = [](const std::string& signed_text, const std::string& written_text) -> std::string
    {
        const IniDocument read = IniDocument::Parse("test.dcf", signed_text);
        const IniDocument written = IniDocument::Parse("test.dcf", written_text);
        const Device device = ReadDevice(read);
        try
        {
            static_cast<void>(WithSignatures(written, device, device.node_id));
        }
        catch (const InputError& error)
        {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(refusal(example, example), "");
    // Given that what is written has another refresh time in it than what was signed
    EXPECT_EQ(refusal(example, Changed(example, {{"ParameterValue=25\n", "ParameterValue=26\n"}})),
              "test.dcf:331:16: error: 0x13FF:01: the signature is not there when read back, expected 0x5DFB");
    // Or another discrepancy time, which the digest covers
    EXPECT_EQ(refusal(example, Changed(example, {{"ParameterValue=5000\n", "ParameterValue=5001\n"}})),
              "test.dcf:627:16: error: 0x5F04:00: the digest is not there when read back, expected 0xC760E19B");
}

TEST(Signing, WithoutAPlaceForASignatureItIsRefused)
{
    Verifies(req::SRS_CLI_005);
    EXPECT_EQ(RefusalOfSigning(Changed(ExampleText("controller"), {{"[13FFsub2]", "[13FFsub3]"}})),
              "test.dcf:434:1: error: 0x13FF:02 is missing, expected an object that takes the signature of SRDO 2");
    EXPECT_EQ(RefusalOfSigning(Changed(ExampleText("sensor"), {{"[13FF]", "[13F0]"},
                                                               {"[13FFsub0]", "[13F0sub0]"},
                                                               {"[13FFsub1]", "[13F0sub1]"},
                                                               {"=0x13FF", "=0x13F0"}})),
              "test.dcf:185:1: error: 0x13FF:01 is missing, expected an object that takes the signature of SRDO 1");
}

TEST(Signing, WhatCannotBeSignedIsRefused)
{
    Verifies(req::SRS_EDS_024);
    EXPECT_EQ(RefusalOfSigning(Changed(ExampleText("sensor"), {{"ParameterValue=25\n", "ParameterValue=25 ms\n"}})),
              "test.dcf:215:16: error: 0x1301:02: value '25 ms', expected a number from 0 to 65535 (UNSIGNED16), or "
              "$NODEID+number");
}

TEST(Signing, APlaceThatCannotHoldASignatureIsRefused)
{
    Verifies(req::SRS_CLI_005);
    EXPECT_EQ(
        RefusalOfSigning(Changed(ExampleText("sensor"), {{"DataType=0x0006\nAccessType=rw\nDefaultValue=0x0000",
                                                          "DataType=0x0005\nAccessType=rw\nDefaultValue=0x0000"}})),
        "test.dcf:325:1: error: 0x13FF:01 is of UNSIGNED8, expected UNSIGNED16");
}
} // namespace
} // namespace counterpoint::cia306
