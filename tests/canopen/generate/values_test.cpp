// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What the SDO server says over a generated dictionary, against what the reader says about the file it was made from.
#include "canopen/cia306/check/check.hpp"
#include "canopen/cia306/file/device_reader.hpp"
#include "canopen/cia306/safety/device_parameters.hpp"
#include "canopen/cia306/safety/signature.hpp"
#include "canopen/cia306/text/input_error.hpp"
#include "tests/canopen/generate/generated_node.hpp"
#include "verification/trace/ids/generate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace counterpoint::generate
{
namespace
{
using test::GeneratedCase;
using test::GeneratedCases;
using test::GeneratedNode;
using test::Upload;

constexpr std::uint32_t kWriteOnly = 0x06010001U;
constexpr std::uint32_t kObjectUnknown = 0x06020000U;
constexpr std::uint32_t kSubUnknown = 0x06090011U;
constexpr std::uint32_t kGeneral = 0x08000000U;

bool HasSrdos(const cia306::Device& device)
{
    return std::any_of(device.objects.begin(), device.objects.end(),
                       [](const auto& object) { return object.first >= 0x1301U && object.first <= 0x1340U; });
}

bool IsKernels(const std::uint16_t index)
{
    return index >= 0x1300U && index <= 0x13FFU;
}

/// Octet strings stand in a file as pairs of hexadecimal digits, with or without spaces, or as they are; the Unicode
/// strings here are ASCII.
std::vector<std::uint8_t> TextBytes(const cia306::Entry& entry)
{
    std::string text = entry.Configured().text;
    std::string digits = text;
    digits.erase(std::remove(digits.begin(), digits.end(), ' '), digits.end());
    const bool is_octets =
        entry.data_type == 0x000AU && digits.find_first_not_of("0123456789abcdefABCDEF") == std::string::npos;
    text = is_octets ? digits : text;
    const bool is_hex = entry.data_type == 0x000AU && text.size() % 2U == 0U &&
                        text.find_first_not_of("0123456789abcdefABCDEF") == std::string::npos;
    std::vector<std::uint8_t> bytes;
    for (std::size_t place = 0U; place < text.size(); place += is_hex ? 2U : 1U)
    {
        bytes.push_back(is_hex ? static_cast<std::uint8_t>(std::stoul(text.substr(place, 2U), nullptr, 16))
                               : static_cast<std::uint8_t>(text[place]));
        if (entry.data_type == 0x000BU)
        {
            bytes.push_back(0U);
        }
    }
    return bytes;
}

std::vector<std::uint8_t> NumberBytes(const std::uint64_t value, const std::uint32_t bits)
{
    std::vector<std::uint8_t> bytes;
    for (std::uint32_t bit = 0U; bit < bits; bit += 8U)
    {
        const std::uint64_t cut = value & (~std::uint64_t{0U} >> (64U - bits));
        bytes.push_back(static_cast<std::uint8_t>((cut >> bit) & 0xFFU));
    }
    return bytes;
}

/// Received variables have their safe values until a pair comes, whatever the file says: by index and sub-index.
std::map<std::uint32_t, std::vector<std::uint8_t>> SafeValues(const cia306::Device& device, const std::uint8_t node_id)
{
    std::vector<cia306::Finding> problems;
    const cia306::DeviceParameters parameters = cia306::ReadDeviceParameters(device, node_id, problems);
    std::map<std::uint32_t, std::vector<std::uint8_t>> values;
    for (const cia306::SrdoConfiguration& srdo : cia306::ExtractSafety(device, node_id).srdos)
    {
        std::uint64_t rest = parameters.Srdo(srdo.number).safe_value;
        for (std::size_t place = 0U; srdo.IsConsumer() && place + 1U < srdo.mapping.size(); place += 2U)
        {
            const std::uint32_t bits = srdo.mapping[place].Bits();
            values[srdo.mapping[place].raw >> 8U] = NumberBytes(rest, bits);
            values[srdo.mapping[place + 1U].raw >> 8U] = NumberBytes(~rest, bits);
            rest = bits < 64U ? rest >> bits : 0U;
        }
    }
    return values;
}

/// An element without a value begins with 0, or with the limit next to it.
std::uint64_t ValueWithoutOne(const cia306::Entry& entry)
{
    const bool is_integer =
        entry.type.kind == cia306::DataKind::kSigned || entry.type.kind == cia306::DataKind::kUnsigned;
    const std::string low = entry.low_limit.text;
    const bool is_above_zero = !low.empty() && low[0] != '-' && entry.type.kind == cia306::DataKind::kUnsigned;
    if (is_integer && is_above_zero)
    {
        return cia306::ParseValue(low, entry.type, std::nullopt).value.value().bits;
    }
    // The one of the real files with limits below 0: -1 as a pattern.
    return entry.high_limit.text == "0xFFFFFFFF" && entry.data_type == 0x0004U ? 0xFFFFFFFFU : 0U;
}

/// The answer that the file asks for.
Upload Expected(const cia306::Entry& entry, const std::uint8_t node_id, const bool is_variable)
{
    const bool is_text = entry.type.kind == cia306::DataKind::kText;
    if (entry.access == cia306::Access::kWriteOnly && !is_variable)
    {
        return {kWriteOnly, {}};
    }
    if (entry.data_type == cia306::kDomainType)
    {
        return {kGeneral, {}};
    }
    if (is_text)
    {
        return {0U, TextBytes(entry)};
    }
    std::uint64_t value = ValueWithoutOne(entry);
    if (entry.Configured().IsSet())
    {
        value = cia306::ConfiguredValue(entry, node_id).value.value().bits;
    }
    return {0U, NumberBytes(value, entry.type.bits)};
}

class GeneratedValues : public ::testing::TestWithParam<std::size_t>
{
  protected:
    [[nodiscard]] static const GeneratedCase& Case()
    {
        return GeneratedCases().at(GetParam());
    }
};

TEST_P(GeneratedValues, TheSdoServerServesWhatTheFileSays)
{
    Verifies(req::SRS_GEN_014);
    Verifies(req::SRS_GEN_005);
    Verifies(req::SRS_GEN_007);
    Verifies(req::SRS_GEN_009);
    Verifies(req::SRS_GEN_010);
    Verifies(req::SRS_GEN_011);
    Verifies(req::SRS_GEN_340);
    // Given the node of the generated code, configured as its file says
    const cia306::Device device = cia306::ReadDeviceFile(Case().file);
    const bool has_srdos = HasSrdos(device);
    GeneratedNode node(Case());
    if (has_srdos)
    {
        ASSERT_EQ(node.Start(), StartResult::kStarted);
        const generated::ConfigureReply reply = node.Configure();
        ASSERT_EQ(reply.abort, AbortCode::kNone) << cia306::ObjectName(reply.object.index, reply.object.sub);
    }
    // When a client reads every data element, then it gets the value of the file
    const auto safe_values = SafeValues(device, Case().node_id);
    std::size_t count = 0U;
    for (const auto& [index, object] : device.objects)
    {
        const bool is_looked_at = index >= 0x1000U && (has_srdos || !IsKernels(index));
        for (const auto& [sub, entry] : object.entries)
        {
            if (!is_looked_at)
            {
                continue;
            }
            const Upload upload = node.Read(index, sub);
            const bool is_known = entry.type.bits != 0U || entry.type.kind == cia306::DataKind::kText;
            const bool is_variable = entry.is_srdo_mappable.value_or(false);
            const std::uint32_t unknown = object.entries.size() > 1U ? kSubUnknown : kObjectUnknown;
            Upload expected = is_known ? Expected(entry, Case().node_id, is_variable) : Upload{unknown, {}};
            const auto safe = safe_values.find((static_cast<std::uint32_t>(index) << 8U) | sub);
            expected = safe != safe_values.end() ? Upload{0U, safe->second} : expected;
            EXPECT_EQ(upload.abort, expected.abort) << cia306::ObjectName(index, sub);
            EXPECT_EQ(upload.bytes, expected.bytes) << cia306::ObjectName(index, sub);
            ++count;
        }
    }
    EXPECT_GE(count, 4U);
}

TEST_P(GeneratedValues, FilesOfTheTestAreWithoutErrors)
{
    Verifies(req::SRS_GEN_002);
    const cia306::Device device = cia306::ReadDeviceFile(Case().file);
    for (const cia306::Finding& finding : cia306::CheckDevice(device, {Case().node_id, std::nullopt}))
    {
        EXPECT_NE(finding.severity, cia306::Severity::kError) << cia306::FormatFinding(Case().file, finding);
    }
}

TEST_P(GeneratedValues, AConfigurationToolMayWriteBackWhatItReads)
{
    Verifies(req::SRS_GEN_006);
    GeneratedNode node(Case());
    cia301::Dictionary& objects = node.Objects();
    for (std::uint32_t place = 0U; place < Case().table->count; ++place)
    {
        // Given each entry that can be written and read
        const cia301::Entry& entry = Case().table->entries[place];
        const Upload upload = node.Read(entry.index, entry.sub);
        if (entry.access != cia301::Access::kReadWrite || upload.abort != 0U)
        {
            continue;
        }
        // When what was read is written, then it is accepted, unless the file itself gives a value outside its limits
        const auto size = static_cast<std::uint32_t>(upload.bytes.size());
        EXPECT_EQ(objects.Write({entry.index, entry.sub}, {upload.bytes.data(), size}), cia301::SdoAbort::kNone)
            << cia306::ObjectName(entry.index, entry.sub);
    }
    GeneratedNode again(Case());
}

TEST_P(GeneratedValues, TheFirstRefusalEndsTheConfigurationAndIsNamed)
{
    Verifies(req::SRS_GEN_011);
    const cia306::Device device = cia306::ReadDeviceFile(Case().file);
    if (!HasSrdos(device))
    {
        return;
    }
    // Given a kernel that was not started, which takes no write
    GeneratedNode node(Case());
    const generated::ConfigureReply reply = node.Configure();
    // Then the first one is named, and the last one, 13FEh, was not tried
    EXPECT_NE(reply.abort, AbortCode::kNone);
    EXPECT_EQ(reply.object.index, cia306::ExtractSafety(device, Case().node_id).srdos.front().CommunicationIndex());
    EXPECT_EQ(reply.object.sub, 1U);
}

TEST_P(GeneratedValues, EachResetRestoresItsPartOfOneBlock)
{
    Verifies(req::SRS_GEN_007);
    // Given the bytes and lengths of all elements in memory as they are at power-on
    using Value = std::pair<std::vector<std::uint8_t>, std::uint32_t>;
    Case().reset();
    std::map<const std::uint8_t*, const cia301::Entry*> elements;
    for (std::uint32_t i = 0U; i < Case().table->count; ++i)
    {
        const cia301::Entry& entry = Case().table->entries[i];
        if (entry.place != nullptr)
        {
            elements[entry.place] = &entry;
        }
    }
    const auto value_of = [](const cia301::Entry& entry)
    {
        return Value{{entry.place, entry.place + entry.size_bytes},
                     entry.length_bytes != nullptr ? *entry.length_bytes : entry.size_bytes};
    };
    std::map<const cia301::Entry*, Value> power_on;
    std::map<const cia301::Entry*, Value> altered;
    const std::uint8_t* end = elements.empty() ? nullptr : elements.begin()->first;
    for (const auto& [place, entry] : elements)
    {
        // Then each begins where the one before it ends
        EXPECT_EQ(place, end) << cia306::ObjectName(entry->index, entry->sub);
        end = place + entry->size_bytes;
        power_on[entry] = value_of(*entry);
    }
    // When all are altered
    for (const auto& each : elements)
    {
        const cia301::Entry& entry = *each.second;
        std::for_each(entry.place, entry.place + entry.size_bytes, [](std::uint8_t& byte) { byte ^= 0xFFU; });
        if (entry.length_bytes != nullptr)
        {
            *entry.length_bytes ^= 1U;
        }
        altered[&entry] = value_of(entry);
    }
    // Then a reset of the communication restores 1000h to 1FFFh alone
    Case().reset_communication();
    for (const auto& [entry, value] : power_on)
    {
        EXPECT_EQ(value_of(*entry), entry->index <= 0x1FFFU ? value : altered[entry])
            << cia306::ObjectName(entry->index, entry->sub);
    }
    // and one of the application all
    Case().reset();
    for (const auto& [entry, value] : power_on)
    {
        EXPECT_EQ(value_of(*entry), value) << cia306::ObjectName(entry->index, entry->sub);
    }
}

TEST_P(GeneratedValues, AnotherNodeIdChangesWhatTheFileWritesWithIt)
{
    Verifies(req::SRS_GEN_016);
    Verifies(req::SRS_GEN_150);
    const cia306::Device device = cia306::ReadDeviceFile(Case().file);
    GeneratedNode node(Case());
    const auto expect_value = [&node](const std::uint16_t index, const std::uint8_t sub, const cia306::Entry& entry)
    {
        const bool has_formula = entry.Configured().text.find("NODEID") != std::string::npos;
        const bool is_looked_at =
            index >= 0x1000U && !IsKernels(index) && has_formula && entry.access != cia306::Access::kWriteOnly;
        if (is_looked_at)
        {
            EXPECT_EQ(node.Read(index, sub).bytes, Expected(entry, 77U, false).bytes) << cia306::ObjectName(index, sub);
        }
    };
    // When the node-ID is 77, at once and behind each reset
    Case().apply_node_id(77U);
    const auto at_once = []() noexcept {};
    for (void (*const reset)() noexcept : {+at_once, Case().reset_communication, Case().reset})
    {
        reset();
        // Then each element of the table has the value of the file with it
        for (const auto& [index, object] : device.objects)
        {
            for (const auto& [sub, entry] : object.entries)
            {
                expect_value(index, sub, entry);
            }
        }
    }
    Case().apply_node_id(Case().node_id);
    Case().reset();
}

/// Seen over the bus: 1301h to 1340h:05, :06 and 13FFh.
TEST_P(GeneratedValues, AnotherNodeIdReachesKernelAndSignatures)
{
    Verifies(req::SRS_GEN_016);
    const cia306::Device device = cia306::ReadDeviceFile(Case().file);
    const auto other_id = static_cast<std::uint8_t>(Case().node_id + 2U); // A COB-ID 1 stays odd.
    if (!HasSrdos(device) || Case().node_id == 0U || other_id > 127U)
    {
        return;
    }
    // When the program is told another node-ID, and its kernel is started and configured
    Case().apply_node_id(other_id);
    GeneratedNode node(Case());
    EXPECT_EQ(Case().device_now().node_id, other_id);
    EXPECT_EQ(Case().device_now().digest, 0U);
    EXPECT_EQ(node.Start(), StartResult::kStarted);
    const generated::ConfigureReply reply = node.Configure();
    EXPECT_EQ(reply.abort, AbortCode::kNone) << cia306::ObjectName(reply.object.index, reply.object.sub);
    // Then identifiers and signatures are what the file says, and is signed with, for that node-ID
    for (const cia306::SrdoConfiguration& srdo : cia306::ExtractSafety(device, other_id).srdos)
    {
        const std::uint16_t index = srdo.CommunicationIndex();
        EXPECT_EQ(node.Read(index, 5U).bytes, NumberBytes(srdo.cob_id_1.value.value_or(0U), 32U));
        EXPECT_EQ(node.Read(index, 6U).bytes, NumberBytes(srdo.cob_id_2.value.value_or(0U), 32U));
        EXPECT_EQ(node.Read(0x13FFU, srdo.number).bytes, NumberBytes(cia306::SignatureOf(srdo), 16U));
    }
    EXPECT_EQ(node.Read(0x13FEU, 0U).bytes, NumberBytes(0xA5U, 8U));
    // And with the file's node-ID again, everything is as it was
    Case().apply_node_id(Case().node_id);
    EXPECT_EQ(&Case().device_now(), Case().device);
}

const GeneratedCase& CaseNamed(const std::string& name)
{
    const std::vector<GeneratedCase>& cases = GeneratedCases();
    return *std::find_if(cases.begin(), cases.end(), [&name](const GeneratedCase& one) { return one.name == name; });
}

TEST(GeneratedConfiguration, RefusesANodeIdForWhichAValueIsTooGreat)
{
    Verifies(req::SRS_GEN_730);
    // Given the SRVT of SRDO 1 as the node-ID and 200, and its COB-ID 1 as the node-ID and FFFFFFF0h
    const generated::Setting settings[] = {
        {{0x1301U, 1U}, 1U, 0U}, {{0x1301U, 3U}, 1U, 205U}, {{0x13FFU, 1U}, 2U, 0x1234U}, {{0x13FEU, 0U}, 1U, 0xA5U}};
    const generated::NodeSetting node_settings[] = {{1U, 200U, nullptr}};
    const generated::Setting long_settings[] = {{{0x1301U, 1U}, 1U, 0U}, {{0x1301U, 5U}, 4U, 0xFFFFFFF5U}};
    const generated::NodeSetting long_node_settings[] = {{1U, 0xFFFFFFF0U, nullptr}};
    const generated::Configuration configuration{settings, nullptr, node_settings, 4U, 1U, 0U, 5U};
    const generated::Configuration long_one{long_settings, nullptr, long_node_settings, 2U, 1U, 0U, 5U};
    GeneratedNode node(CaseNamed("chain_sensor"));
    ASSERT_EQ(node.Start(), StartResult::kStarted);
    // Then 255 is written, and the kernel has the last word about the signature
    const generated::ConfigureReply fits = node.ConfigureWith(configuration, 55U);
    EXPECT_EQ(fits.object.index, 0x13FEU);
    EXPECT_EQ(node.Read(0x1301U, 3U).bytes, NumberBytes(255U, 8U));
    // but not 256 as 0, nor anything behind it
    const generated::ConfigureReply reply = node.ConfigureWith(configuration, 56U);
    EXPECT_EQ(reply.abort, AbortCode::kValueRange);
    EXPECT_EQ(reply.object.index, 0x1301U);
    EXPECT_EQ(reply.object.sub, 3U);
    EXPECT_EQ(node.Read(0x1301U, 3U).bytes, NumberBytes(255U, 8U));
    // Of 32 bits, too: node 15 gives FFFFFFFFh, which is no identifier to the kernel when the SRDO is on
    EXPECT_EQ(node.ConfigureWith(long_one, 16U).abort, AbortCode::kValueRange);
    EXPECT_EQ(node.ConfigureWith(long_one, 16U).object.sub, 5U);
}

std::vector<std::size_t> Places()
{
    std::vector<std::size_t> places;
    for (std::size_t place = 0U; place < COUNTERPOINT_GENERATED_CASES; ++place)
    {
        places.push_back(place);
    }
    return places;
}

// The list fills itself before main; its length is known to the build.
INSTANTIATE_TEST_SUITE_P(Files, GeneratedValues, ::testing::ValuesIn(Places()));

TEST(GeneratedCasesTest, AllAreHere)
{
    Verifies(req::SRS_GEN_014);
    EXPECT_EQ(GeneratedCases().size(), static_cast<std::size_t>(COUNTERPOINT_GENERATED_CASES));
    EXPECT_GE(GeneratedCases().size(), 20U);
}
} // namespace
} // namespace counterpoint::generate
