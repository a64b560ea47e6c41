// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/safety/safety_configuration.hpp"

#include "canopen/cia306/safety/device_parameters.hpp"
#include "canopen/cia306/safety/signature.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace counterpoint::cia306
{
namespace
{
using test::Changed;
using test::DeviceOf;
using test::ExampleText;

std::vector<std::string> Formatted(const std::vector<Finding>& findings)
{
    std::vector<std::string> lines;
    for (const Finding& finding : findings)
    {
        lines.push_back(FormatFinding("f", finding));
    }
    return lines;
}

SrdoConfiguration OnlySrdo(const std::string& text, const std::optional<std::uint8_t> node_id)
{
    const SafetyConfiguration configuration = ExtractSafety(DeviceOf(text), node_id);
    EXPECT_EQ(configuration.srdos.size(), 1U);
    return configuration.srdos.at(0U);
}

TEST(SafetyConfiguration, HoldsWhatTheControllersFileSays)
{
    Verifies(req::SRS_EDS_020);
    const SafetyConfiguration configuration = ExtractSafety(DeviceOf(ExampleText("controller")), std::nullopt);
    ASSERT_EQ(configuration.srdos.size(), 2U);
    const SrdoConfiguration& consumer = configuration.srdos[0];
    EXPECT_EQ(consumer.number, 1U);
    EXPECT_TRUE(consumer.IsConsumer());
    EXPECT_EQ(consumer.sct_ms.value, 50U);
    EXPECT_EQ(consumer.srvt_ms.value, 20U);
    EXPECT_EQ(consumer.transmission_type.value, 254U);
    EXPECT_EQ(consumer.cob_id_1.value, 0x101U);
    EXPECT_EQ(consumer.cob_id_2.value, 0x102U);
    ASSERT_EQ(consumer.mapping.size(), 4U);
    EXPECT_EQ(consumer.mapping[1].Index(), 0x2300U);
    EXPECT_EQ(consumer.mapping[1].Sub(), 1U);
    EXPECT_EQ(consumer.mapping[1].Bits(), 8U);
    EXPECT_FALSE(consumer.mapping[1].IsNormal());
    EXPECT_TRUE(configuration.srdos[1].IsProducer());
    EXPECT_EQ(configuration.srdos[1].signature.value, 0xCA45U);
    EXPECT_EQ(configuration.gfc.value, 1U);
    EXPECT_EQ(configuration.configuration_valid.value, 0xA5U);
    EXPECT_EQ(configuration.signature_count.value, 2U);
    EXPECT_TRUE(configuration.problems.empty());
}

TEST(SafetyConfiguration, GapsAndTheLastSrdoAreSeen)
{
    Verifies(req::SRS_EDS_020);
    const test::SrdoText first{1, "1", "25", "20", "0x101", "0x102", {}};
    const test::SrdoText third{3, "0", "25", "20", "0x103", "0x104", {}};
    const test::SrdoText last{64, "2", "50", "20", "0x105", "0x106", {}};
    const SafetyConfiguration configuration =
        ExtractSafety(DeviceOf(test::SrdoFileText({first, third, last})), std::nullopt);
    ASSERT_EQ(configuration.srdos.size(), 3U);
    EXPECT_EQ(configuration.srdos[1].number, 3U);
    EXPECT_EQ(configuration.srdos[2].number, 64U);
    EXPECT_EQ(configuration.srdos[2].CommunicationIndex(), 0x1340U);
    EXPECT_EQ(configuration.srdos[2].MappingIndex(), 0x13C0U);
}

TEST(SafetyConfiguration, UpTo128MappingEntriesAreRead)
{
    Verifies(req::SRS_EDS_020);
    test::SrdoText srdo{1, "1", "25", "20", "0x101", "0x102", {}};
    srdo.mapping.assign(128U, "0x20000101");
    const SrdoConfiguration most = OnlySrdo(test::SrdoFileText({srdo}), std::nullopt);
    EXPECT_EQ(most.mapping.size(), 128U);
    EXPECT_EQ(CanonicalBytes(most).size(), 653U); // 13 + 5 * 128
    EXPECT_EQ(CanonicalBytes(most).at(12U), 0x80U);
    EXPECT_EQ(CanonicalBytes(most).at(648U), 0x80U); // Sub-index of the last entry.
    srdo.mapping.assign(129U, "0x20000101");
    const SrdoConfiguration more = OnlySrdo(test::SrdoFileText({srdo}), std::nullopt);
    ASSERT_EQ(more.signature_problems.size(), 1U);
    EXPECT_EQ(more.signature_problems[0].text, "129 mapping entries, expected at most 128");
}

TEST(SafetyConfiguration, CanonicalBytesOfAllVectors)
{
    Verifies(req::SRS_EDS_021);
    for (const test::Vector& vector : test::Vectors())
    {
        const SrdoConfiguration srdo = OnlySrdo(test::SrdoFileText({vector.srdo}), std::nullopt);
        EXPECT_TRUE(srdo.signature_problems.empty()) << vector.name;
        EXPECT_EQ(HexBytes(CanonicalBytes(srdo)), vector.bytes) << vector.name;
    }
}

TEST(SafetyConfiguration, SignaturesOfAllVectors)
{
    Verifies(req::SRS_EDS_022);
    for (const test::Vector& vector : test::Vectors())
    {
        EXPECT_EQ(SignatureOf(OnlySrdo(test::SrdoFileText({vector.srdo}), std::nullopt)), vector.signature)
            << vector.name;
    }
}

TEST(SafetyConfiguration, SignatureIsTheCatalogueCrc)
{
    Verifies(req::SRS_EDS_022);
    EXPECT_EQ(SignatureOf(std::vector<std::uint8_t>{'1', '2', '3', '4', '5', '6', '7', '8', '9'}), 0x31C3U);
    EXPECT_EQ(SignatureOf(std::vector<std::uint8_t>{}), 0x0000U);
}

TEST(SafetyConfiguration, BytesOfBigEndianFieldsHaveAnotherSignature)
{
    Verifies(req::SRS_EDS_021);
    // GOLD with every field high byte first, as one known tool computes it wrongly.
    EXPECT_EQ(SignatureOf(std::vector<std::uint8_t>{0x02U, 0x00U, 0x32U, 0x14U, 0x00U, 0x00U, 0x01U, 0x11U, 0x00U,
                                                    0x00U, 0x01U, 0x12U, 0x04U, 0x01U, 0x60U, 0x10U, 0x01U, 0x08U,
                                                    0x02U, 0x60U, 0x11U, 0x01U, 0x08U, 0x03U, 0x60U, 0x10U, 0x02U,
                                                    0x08U, 0x04U, 0x60U, 0x11U, 0x02U, 0x08U}),
              0x98A7U);
}

TEST(SafetyConfiguration, CobIdsGoIntoTheSignatureWithTheNodeId)
{
    Verifies(req::SRS_EDS_021);
    Verifies(req::SRS_EDS_008);
    // Vector A written with formulas, for node-ID 1.
    const test::SrdoText srdo{1, "1", "25", "20", "$NODEID+0x100", "0x101+$NODEID", {"0x20000008", "0x20010008"}};
    EXPECT_EQ(SignatureOf(OnlySrdo(test::SrdoFileText({srdo}), std::uint8_t{1U})), 0x4B2DU);
    EXPECT_NE(SignatureOf(OnlySrdo(test::SrdoFileText({srdo}), std::uint8_t{3U})), 0x4B2DU);
    const SrdoConfiguration without = OnlySrdo(test::SrdoFileText({srdo}), std::nullopt);
    ASSERT_EQ(without.signature_problems.size(), 2U);
    EXPECT_EQ(without.signature_problems[0].text,
              "value '$NODEID+0x100' needs the node-ID and there is none, expected --node-id, or NodeID in "
              "[DeviceComissioning]");
}

TEST(SafetyConfiguration, WhatIsMissingOrWrongIsReportedWithItsPlace)
{
    Verifies(req::SRS_EDS_024);
    struct Row
    {
        std::vector<test::Change> changes;
        std::string problem;
    };
    const Row rows[] = {
        {{{"[1301sub2]", "[1301sub9]"}},
         "f:185:1: error: 0x1301:02: is missing, expected an object of type UNSIGNED16"},
        {{{"DataType=0x0006\nAccessType=rw\nDefaultValue=25", "DataType=0x0005\nAccessType=rw\nDefaultValue=25"}},
         "f:212:10: error: 0x1301:02: DataType is 0x0005 (UNSIGNED8), expected 0x0006 (UNSIGNED16)"},
        {{{"DefaultValue=25\nParameterValue=25\n", "DefaultValue=\n"}},
         "f:209:1: error: 0x1301:02: has no value, expected a ParameterValue or DefaultValue"},
        {{{"ParameterValue=25\n", "ParameterValue=65536\n"}},
         "f:215:16: error: 0x1301:02: value '65536', expected a number from 0 to 65535 (UNSIGNED16)"},
        {{{"[1381]", "[1391]"},
          {"[1381sub0]", "[1391sub0]"},
          {"[1381sub1]", "[1391sub1]"},
          {"[1381sub2]", "[1391sub2]"},
          {"[1381sub3]", "[1391sub3]"},
          {"[1381sub4]", "[1391sub4]"}},
         "f:185:1: error: 0x1381: SRDO 1 has no mapping parameters, expected a section [1381]"},
    };
    for (const Row& row : rows)
    {
        const SrdoConfiguration srdo = OnlySrdo(Changed(ExampleText("sensor"), row.changes), std::nullopt);
        EXPECT_EQ(Formatted(srdo.signature_problems), std::vector<std::string>{row.problem});
    }
}

TEST(SafetyConfiguration, TheFirstErrorOfProblemsIsThrown)
{
    Verifies(req::SRS_EDS_024);
    EXPECT_NO_THROW(RequireNone("f", {{Severity::kWarning, {3U, 0U}, "0x1301:01", "w"}}));
    try
    {
        RequireNone("f", {{Severity::kWarning, {3U, 0U}, "0x1301:01", "w"},
                          {Severity::kError, {4U, 7U}, "0x1301:02", "a, expected b"}});
        FAIL() << "no refusal";
    }
    catch (const InputError& error)
    {
        EXPECT_STREQ(error.what(), "f:4:7: error: 0x1301:02: a, expected b");
        EXPECT_EQ(error.File(), "f");
        EXPECT_EQ(error.Where().line, 4U);
        EXPECT_EQ(error.Message(), "0x1301:02: a, expected b");
    }
}

TEST(DeviceParameters, HaveTheirDefaultsWhereTheFileHasNone)
{
    Verifies(req::SRS_EDS_023);
    std::vector<Finding> problems;
    const DeviceParameters parameters =
        ReadDeviceParameters(DeviceOf("[1000]\nDataType=7\nAccessType=ro\n"), std::nullopt, problems);
    EXPECT_TRUE(problems.empty());
    EXPECT_EQ(parameters.cycle_us, 1000U);
    EXPECT_EQ(parameters.cycle_tolerance_us, 500U);
    EXPECT_EQ(parameters.discrepancy_us, 5000U);
    EXPECT_EQ(parameters.diagnostic_interval_ms, 1000U);
    EXPECT_EQ(parameters.test_interval_ms, 1000U);
    EXPECT_EQ(parameters.clock_tolerance_us, 500U);
    EXPECT_EQ(parameters.clock_tolerance_interval_us, 100000U);
    EXPECT_EQ(parameters.output_us, 1000U);
    EXPECT_EQ(parameters.acknowledge_window_us, 1000000U);
    EXPECT_EQ(parameters.Srdo(64U).release_policy, 0U);
    EXPECT_EQ(parameters.Srdo(1U).safe_value, 0U);
    EXPECT_EQ(parameters.Srdo(1U).producer_form, 0U);
    EXPECT_EQ(parameters.Srdo(64U).srvt_detection, 0U);
    EXPECT_EQ(parameters.granularity_bits, 8U);
    EXPECT_EQ(parameters.map_entries, 16U);
    EXPECT_EQ(parameters.dummy_mapping, 0U);
    EXPECT_EQ(parameters.number_gaps, 0x99U);
    EXPECT_EQ(parameters.gfc_use, 0U);
    EXPECT_EQ(parameters.normal_port, 1U);
    EXPECT_EQ(parameters.inverse_port, 1U);
    EXPECT_EQ(parameters.digest, 0U);
}

TEST(DeviceParameters, WhatTheRestOfTheFileSaysIsTheDefault)
{
    Verifies(req::SRS_EDS_023);
    const auto read = [](const std::string& name)
    {
        std::vector<Finding> problems;
        const Device device = DeviceOf(ReadTextFile(test::SourceFolder() + "/tests/canopen/cia306/data/" + name));
        return ReadDeviceParameters(device, device.node_id, problems);
    };
    // Given a file with 1300h, Granularity=1, no DummyUsage and a mapping of 128 entries
    EXPECT_EQ(read("bits.dcf").gfc_use, 0x5AU);
    EXPECT_EQ(read("bits.dcf").granularity_bits, 1U);
    EXPECT_EQ(read("bits.dcf").dummy_mapping, 0U);
    EXPECT_EQ(read("bits.dcf").map_entries, 128U);
    EXPECT_EQ(read("dummies.dcf").dummy_mapping, 0x66U);
    EXPECT_EQ(read("dummies.dcf").map_entries, 16U);
    // And one that tells all of it
    EXPECT_EQ(read("digest.dcf").map_entries, 128U);
    EXPECT_EQ(read("digest.dcf").number_gaps, 0x99U);
    EXPECT_EQ(read("digest.dcf").inverse_port, 2U);
    EXPECT_EQ(read("digest.dcf").digest, 0x5F9AFA3DU);
    EXPECT_EQ(read("digest.dcf").Srdo(2U).srvt_detection, 0x3CU);
}

TEST(DeviceParameters, AreReadWhereTheyAre)
{
    Verifies(req::SRS_EDS_023);
    const std::string text =
        Changed(ExampleText("controller"),
                {{"DefaultValue=1000\nParameterValue=1000\nPDOMapping=0\n\n[5F00sub2]",
                  "DefaultValue=1000\nParameterValue=2000\nPDOMapping=0\n\n[5F00sub2]"},
                 {"DefaultValue=1000000\nParameterValue=1000000", "DefaultValue=1000000\nParameterValue=0xFFFFFFFF"},
                 {"ParameterValue=0x0000000000000000\nPDOMapping=0\n\n[5F02sub2]",
                  "ParameterValue=0xFEDCBA9876543210\nPDOMapping=0\n\n[5F02sub2]"}});
    std::vector<Finding> problems;
    const DeviceParameters parameters = ReadDeviceParameters(DeviceOf(text), std::nullopt, problems);
    EXPECT_TRUE(problems.empty());
    EXPECT_EQ(parameters.cycle_us, 2000U);
    EXPECT_EQ(parameters.cycle_tolerance_us, 500U);
    EXPECT_EQ(parameters.acknowledge_window_us, 0xFFFFFFFFU);
    EXPECT_EQ(parameters.Srdo(1U).release_policy, 0x5AU);
    EXPECT_EQ(parameters.Srdo(2U).release_policy, 0U);
    EXPECT_EQ(parameters.Srdo(1U).safe_value, 0xFEDCBA9876543210U);
    EXPECT_EQ(parameters.Srdo(1U).producer_form, 0U);
    EXPECT_EQ(parameters.Srdo(2U).producer_form, 1U);
}

TEST(DeviceParameters, OneThatCannotBeUsedKeepsItsDefaultAndIsReported)
{
    Verifies(req::SRS_EDS_023);
    std::vector<Finding> problems;
    const Device device = DeviceOf("[5F00]\nObjectType=9\nSubNumber=1\n[5F00sub1]\nDataType=7\nAccessType=rw\n"
                                   "DefaultValue=fast\n[DeviceInfo]\nCANopenSafetySupported=1\n");
    EXPECT_EQ(ReadDeviceParameters(device, std::nullopt, problems).cycle_us, 1000U);
    EXPECT_EQ(Formatted(problems),
              std::vector<std::string>{"f:7:14: error: 0x5F00:01: value 'fast', expected a number from 0 to 4294967295 "
                                       "(UNSIGNED32), or $NODEID+number"});
}
} // namespace
} // namespace counterpoint::cia306
