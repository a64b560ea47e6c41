// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/generate/generate.hpp"
#include "canopen/generate/text.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/canopen/generate/random_device.hpp"
#include "verification/trace/ids/generate.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <unistd.h>

namespace counterpoint::generate
{
namespace
{
using cia306::test::Changed;

GeneratedCode Code(const std::string& text, const std::optional<std::uint8_t> node_id = std::nullopt)
{
    const cia306::Device device = cia306::test::DeviceOf(text);
    return Generate(device, text, {"a_device", node_id ? node_id : device.node_id});
}

std::string RefusalOf(const std::string& text)
{
    try
    {
        static_cast<void>(Code(text));
    }
    catch (const cia306::InputError& error)
    {
        return error.what();
    }
    return "";
}

std::string StaticText()
{
    return cia306::ReadTextFile(cia306::test::SourceFolder() + "/tests/canopen/cia306/data/static.dcf");
}

bool Has(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

TEST(GenerateTest, TheSameFileGivesTheSameBytes)
{
    Verifies(req::SRS_GEN_001);
    for (const std::uint64_t seed : {5U, 6U, 7U, 8U})
    {
        const std::string text = test::RandomDevice(seed);
        EXPECT_EQ(text, test::RandomDevice(seed));
        EXPECT_EQ(Code(text).header, Code(text).header);
        EXPECT_EQ(Code(text).source, Code(text).source);
        EXPECT_EQ(Code(text).header.rfind("// Made by `counterpoint generate` from test.dcf (CRC-32 0x", 0U), 0U);
    }
}

TEST(GenerateTest, TheNodeIdGoesIntoValuesAndDevice)
{
    Verifies(req::SRS_GEN_009);
    const std::string text = cia306::test::ExampleText("sensor");
    // Given the node-ID of the file, the digest of the file is expected
    EXPECT_TRUE(Has(Code(text).header, "kNodeId = 1U;"));
    EXPECT_TRUE(Has(Code(text).source, "0x66596575U, // digest"));
    // With another one it is another device
    EXPECT_TRUE(Has(Code(text, std::uint8_t{9U}).header, "kNodeId = 9U;"));
    EXPECT_TRUE(Has(Code(text, std::uint8_t{9U}).source, "0x00000000U, // digest"));
    EXPECT_TRUE(Has(Code(text, std::uint8_t{9U}).source, "0x89U, 0x00U, 0x00U, 0x00U, // 1014h:00"));
}

TEST(GenerateTest, APdoMappableObjectIsAVariableOfTheKernelOnlyWhereAnSrdoMapsIt)
{
    Verifies(req::SRS_GEN_009);
    // Given button 1 without the key SRDOMapping, and another object for PDOs, which no SRDO maps
    const std::string text =
        Changed(cia306::test::ExampleText("sensor"),
                {{"PDOMapping=0\nSRDOMapping=1\nInvertedSRAD=0x210001", "PDOMapping=1\nInvertedSRAD=0x210001"}}) +
        "\n[2800]\nParameterName=For PDOs\nObjectType=0x7\nDataType=5\nAccessType=ro\nDefaultValue=0\nPDOMapping=1\n";
    const std::string source = Code(text).source;
    EXPECT_TRUE(Has(source, "{0x2000U, 0x01U, 8U, counterpoint::MapAccess::kProducer,"));
    EXPECT_FALSE(Has(source, "{0x2800U, 0x00U, 8U, counterpoint::MapAccess::"));
    EXPECT_TRUE(Has(source, "{0x2800U, 0x00U, DataType::kUnsigned8"));
}

TEST(GenerateTest, WhatCannotBeGeneratedIsNamedWithItsLine)
{
    Verifies(req::SRS_GEN_003);
    const std::string head = "[FileInfo]\n\n";
    // A value that its type cannot have is as if it were not there; the reader warns of it.
    EXPECT_EQ(RefusalOf(head + test::Section("2000", "A", 6U, "rw", "70000")), "");
    std::string safety = cia306::test::ExampleText("sensor");
    const std::string sct = "ParameterValue=25";
    safety.replace(safety.find(sct, safety.find("[1301sub2]")), sct.size(), "ParameterValue=70000");
    EXPECT_NE(RefusalOf(safety).find("expected a number from 0 to 65535 (UNSIGNED16)"), std::string::npos)
        << RefusalOf(safety);
    EXPECT_EQ(
        RefusalOf(head + test::Section("2000", "A", 7U, "rw", "$NODEID+1")),
        "test.dcf:8:14: error: 0x2000:00: value '$NODEID+1' needs the node-ID and there is none, expected --node-id, "
        "or NodeID in [DeviceComissioning]");
    EXPECT_EQ(RefusalOf(head + test::Section("0040", "A", 5U, "rw", "1")),
              "test.dcf: error: no object for a dictionary, expected objects from 0x1000 on");
    const std::string twice = Changed(StaticText(), {{"DefaultValue=0x24000110", "DefaultValue=0x22000110"}});
    EXPECT_NE(RefusalOf(twice).find("which a static mapping has already, expected each object in one static mapping"),
              std::string::npos)
        << RefusalOf(twice);
}

TEST(GenerateTest, AStaticMappingIsAConstantTableAndTwoFields)
{
    Verifies(req::SRS_GEN_010);
    const GeneratedCode code = Code(StaticText());
    EXPECT_TRUE(Has(code.source, "constexpr std::uint32_t kMap1[]{0x"));
    EXPECT_TRUE(Has(code.source, "{{0x1301U}, {storage.bytes + "));
    EXPECT_FALSE(Has(code.source, "{{0x1381U, 0x01U}, 4U"));
    EXPECT_TRUE(Has(code.header, ", static mapping\n"));
}

TEST(GenerateTest, ConstantsAndTypesAreThoseOfTheFile)
{
    Verifies(req::SRS_GEN_013);
    std::string text = "[FileInfo]\n\n" + test::Section("2000", "Least", 4U, "const", "-2147483648");
    text += test::Section("2001", "Least 64", 0x15U, "const", "-9223372036854775808");
    text += test::Section("2002", "Greatest", 0x1BU, "const", "0xFFFFFFFFFFFFFFFF");
    text += test::Section("2003", "Flag", 1U, "const", "1") + test::Section("2004", "Three", 0x16U, "rw", "1");
    text += test::Section("2005", "Signed three", 0x10U, "ro", "-1") + test::Section("2006", "Real", 8U, "rw", "1.5");
    text += test::Section("2007", "Word", 9U, "rw", "abc") + test::Section("2008", "Name", 9U, "const", "abc");
    const GeneratedCode code = Code(text);
    EXPECT_TRUE(Has(code.header, "constexpr std::int32_t kLeast = -2147483647 - 1;"));
    EXPECT_TRUE(Has(code.header, "constexpr std::int64_t kLeast64 = -9223372036854775807LL - 1;"));
    EXPECT_TRUE(Has(code.header, "constexpr std::uint64_t kGreatest = 18446744073709551615ULL;"));
    EXPECT_TRUE(Has(code.header, "constexpr bool kFlag = true;"));
    EXPECT_TRUE(Has(code.header, "std::uint32_t GetThree() noexcept;"));
    EXPECT_TRUE(Has(code.header, "std::int32_t GetSignedThree() noexcept;"));
    EXPECT_TRUE(Has(code.header, "void SetReal(float value) noexcept;"));
    EXPECT_TRUE(Has(code.header, "bool SetWord(const counterpoint::cia301::Bytes& value) noexcept;"));
    EXPECT_FALSE(Has(code.header, "SetName"));
    EXPECT_EQ(code.entry_count, 9U);
    EXPECT_EQ(code.stored_bytes, 3U + 3U + 4U + 32U);
    EXPECT_EQ(code.constant_bytes, 4U + 8U + 8U + 1U + 3U);
}

TEST(GenerateTest, EachVariableOfAConsumerHasItsPartOfTheSafeValue)
{
    Verifies(req::SRS_GEN_020);
    std::string text = cia306::ReadTextFile(cia306::test::SourceFolder() + "/examples/actuator/actuator.dcf");
    const std::string zero = "ParameterValue=0x0000000000000000";
    text.replace(text.find(zero, text.find("[5F02sub1]")), zero.size(), "ParameterValue=0x0000000000000A05");
    const GeneratedCode code = Code(text);
    // The first mapped bit is the lowest of the safe value.
    EXPECT_TRUE(Has(code.source, "? GetReceivedCommandCommandUnchecked() : static_cast<std::uint8_t>(5U);"));
    EXPECT_TRUE(Has(code.source, "? GetReceivedCommandModeUnchecked() : static_cast<std::uint8_t>(10U);"));
    EXPECT_TRUE(Has(code.source, "const bool is_released = ((released >> kSrdo1Slot) & 1U) != 0U;"));
    EXPECT_TRUE(Has(code.header, "std::uint8_t GetReceivedCommandMode(counterpoint::SrdoMask released) noexcept;"));
    EXPECT_FALSE(Has(code.header, "GetReceivedCommandMode()"));
}

TEST(GenerateTest, VariablesOfAProducerAreTheApplicationsOwn)
{
    Verifies(req::SRS_GEN_020);
    const GeneratedCode code = Code(cia306::ReadTextFile(cia306::test::SourceFolder() + "/examples/sensor/sensor.dcf"));
    EXPECT_FALSE(Has(code.header, "Unchecked"));
    EXPECT_FALSE(Has(code.header, "released)"));
}

TEST(GenerateTest, ARealWhoseSafeValueIsNoNumberHasNoCheckedFunction)
{
    Verifies(req::SRS_GEN_020);
    // Given a consumer of REAL32 with the safe value 1.5, and one whose safe value is no number
    const auto code = [](const std::string& safe_value)
    {
        std::string text = cia306::ReadTextFile(cia306::test::SourceFolder() + "/tests/canopen/cia306/data/digest.dcf");
        for (const char* const section : {"[2200sub1]", "[2300sub1]"})
        {
            const std::string type = "DataType=0x0007";
            text.replace(text.find(type, text.find(section)), type.size(), "DataType=0x0008");
        }
        const std::string before = "0xA1B2C3D4";
        text.replace(text.find(before, text.find("[5F02sub2]")), before.size(), safe_value);
        return Code(text);
    };
    const GeneratedCode number = code("0x3FC00000");
    EXPECT_TRUE(Has(number.header, "float GetIn1(counterpoint::SrdoMask released) noexcept;"));
    EXPECT_TRUE(Has(number.source, "? GetIn1Unchecked() : static_cast<float>(0x1.8p+0F);"));
    const GeneratedCode none = code("0x7FC00000");
    EXPECT_FALSE(Has(none.header, "GetIn1(counterpoint::SrdoMask released)"));
    EXPECT_TRUE(Has(none.header, "float GetIn1Unchecked() noexcept;"));
}

TEST(GenerateTest, SafeValuesAreLiteralsOfTheirTypes)
{
    Verifies(req::SRS_GEN_020);
    using cia306::DataKind;
    EXPECT_EQ(BitsLiteral({"BOOLEAN", DataKind::kBoolean, 1U}, 1U), "true");
    EXPECT_EQ(BitsLiteral({"INTEGER8", DataKind::kSigned, 8U}, 0x80U), "-127 - 1");
    EXPECT_EQ(BitsLiteral({"INTEGER16", DataKind::kSigned, 16U}, 0x7FFFU), "32767");
    EXPECT_EQ(BitsLiteral({"UNSIGNED64", DataKind::kUnsigned, 64U}, 0xFFFFFFFFFFFFFFFFU), "18446744073709551615ULL");
    EXPECT_EQ(BitsLiteral({"REAL32", DataKind::kReal, 32U}, 0x3FC00000U), "0x1.8p+0F");
    EXPECT_EQ(BitsLiteral({"REAL64", DataKind::kReal, 64U}, 0xC000000000000000U), "-0x1p+1");
    EXPECT_EQ(BitsLiteral({"REAL32", DataKind::kReal, 32U}, 0x7FC00000U), ""); // No number.
}

TEST(GenerateTest, OnlyNumbersHaveATypeOfTheLanguage)
{
    Verifies(req::SRS_GEN_013);
    using cia306::DataKind;
    EXPECT_EQ(CppTypeOf({"INTEGER24", DataKind::kSigned, 24U}), "std::int32_t");
    EXPECT_EQ(CppTypeOf({"VISIBLE_STRING", DataKind::kText, 0U}), "");
    EXPECT_EQ(CppTypeOf({"a structure (DEFSTRUCT)", DataKind::kStructure, 0U}), "");
    EXPECT_EQ(CppTypeOf({"unknown", DataKind::kUnknown, 0U}), "");
}

TEST(GenerateTest, WhatHasNoLengthIsLeftOutWithAWarning)
{
    Verifies(req::SRS_GEN_341);
    const GeneratedCode code = Code("[FileInfo]\n\n" + test::Section("2000", "Odd", 0x999U, "rw", "1") +
                                    test::Section("0040", "Below 1000h", 5U, "rw", "1") +
                                    test::Section("2001", "Kept", 5U, "rw", "9", "LowLimit=10\n"));
    EXPECT_EQ(code.entry_count, 1U);
    ASSERT_EQ(code.warnings.size(), 2U);
    EXPECT_EQ(cia306::FormatFinding("a.eds", code.warnings[0]),
              "a.eds:6:10: warning: 0x2000:00: is left out, expected a data type whose length is known");
    EXPECT_EQ(code.warnings[1].text,
              "value '9', expected one between LowLimit and HighLimit; it is generated all the same");
}

TEST(GenerateTest, AnEntryTellsIntoWhichPdosItMayBeMapped)
{
    Verifies(req::SRS_GEN_005);
    std::string text = "[FileInfo]\n\n";
    const char* const access[]{"rw", "ro", "rww", "rwr", "const", "wo"};
    for (std::size_t number = 0U; number < 6U; ++number)
    {
        text += "[200" + std::to_string(number) + "]\nParameterName=A\nDataType=5\nAccessType=" + access[number] +
                "\nDefaultValue=1\nPDOMapping=1\n";
    }
    text += test::Section("2006", "A", 5U, "rw", "1");
    const std::string source = Code(text).source;
    // What can be written and is kept by 1010h has kStored besides
    const std::vector<std::string> ends{"&objects, kInTpdo | kInRpdo | kStored},",
                                        "&objects, kInTpdo},",
                                        "&objects, kInRpdo | kStored},",
                                        "&objects, kInTpdo | kStored},",
                                        "&constants, kInTpdo},",
                                        "&objects, kInRpdo},",
                                        "&objects, kStored},"};
    for (std::size_t number = 0U; number < ends.size(); ++number)
    {
        const std::size_t row = source.find("{0x200" + std::to_string(number) + "U, 0x00U, DataType");
        ASSERT_NE(row, std::string::npos) << number;
        EXPECT_NE(source.substr(row, source.find('\n', row) - row).find(ends[number]), std::string::npos)
            << source.substr(row, source.find('\n', row) - row);
    }
    EXPECT_TRUE(Has(source, "\nstatic_assert(counterpoint::cia301::IsUsable(kEntryTable)"));
}

TEST(GenerateTest, TheOutputCompilesWithoutAWarning)
{
    Verifies(req::SRS_GEN_004);
    // Given dictionaries of random devices of each kind
    const auto folder =
        std::filesystem::temp_directory_path() / ("generate_test_" + std::to_string(::getpid())); // Its own.
    for (const std::uint64_t seed : {100U, 101U, 102U, 103U})
    {
        const GeneratedCode code = Code(test::RandomDevice(seed));
        std::filesystem::create_directories(folder / std::to_string(seed));
        cia306::WriteTextFile((folder / std::to_string(seed) / kHeaderName).string(), code.header);
        cia306::WriteTextFile((folder / std::to_string(seed) / kSourceName).string(), code.source);
    }
    // When all compilers of the requirement that are installed compile them, then none has a word to say
    const std::string source = cia306::test::SourceFolder();
    const std::string command =
        source + "/tests/canopen/generate/compile_test.sh " + source + " " + folder.string() + " 4";
    EXPECT_EQ(std::system(command.c_str()), 0);
    std::filesystem::remove_all(folder);
}

TEST(GenerateTest, OnlyWhatTheChannelsDoNotWriteCanBeWritten)
{
    Verifies(req::SRS_GEN_013);
    Verifies(req::SRS_GEN_342);
    const GeneratedCode code = Code(cia306::test::ExampleText("controller"));
    EXPECT_EQ(code.variable_count, 8U);
    EXPECT_EQ(code.srdo_count, 2U);
    EXPECT_TRUE(Has(code.source, "counterpoint::MapAccess::kConsumer"));
    EXPECT_TRUE(Has(code.source, "counterpoint::MapAccess::kProducer"));
    EXPECT_TRUE(Has(code.header, "rww; the channels write it\n[[nodiscard]]"));
    // Pairs of variables can be compared bit by bit
    const auto count_of = [](const std::string& text, const std::string& part)
    {
        std::size_t count = 0U;
        for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1U))
        {
            ++count;
        }
        return count;
    };
    EXPECT_EQ(count_of(code.header, "counterpoint::PairView Compare"), 4U);
    EXPECT_EQ(count_of(code.source, "return counterpoint::IsInversePair("), 4U);
}
} // namespace
} // namespace counterpoint::generate
