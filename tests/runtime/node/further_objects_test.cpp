// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/cia306/folder_of_files.hpp"
#include "tests/runtime/node/bench.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

// Objects of the services that not every device has: who may write them, and which sub-indices there are.
namespace counterpoint::tools::test
{
namespace
{
constexpr std::uint32_t kReadOnly = 0x06010002U;
constexpr std::uint32_t kSubUnknown = 0x06090011U;

/// A section of a data element: its type by number, its access, its value (empty: none).
std::string Element(const std::string& section, const char* const type, const std::string& access,
                    const std::string& value)
{
    return "[" + section + "]\nDataType=" + type + "\nAccessType=" + access + "\n" +
           (value.empty() ? "" : "DefaultValue=" + value + "\n");
}

std::string Record(const std::string& section)
{
    return "[" + section + "]\nObjectType=9\n";
}

const std::string kHead = "[DeviceInfo]\nVendorName=test\n[DeviceComissioning]\nNodeID=5\n" +
                          Element("1000", "7", "ro", "0") + Element("1001", "5", "ro", "");

/// As a client reads, at most 4 bytes; the abort code where there is one.
std::uint32_t Read(Bench& bench, const ObjectAddress& object)
{
    std::uint8_t bytes[4U]{};
    const cia301::SdoAbort abort = bench.Device().Assembly().Dictionary().Read(object, {bytes, 4U}).abort;
    const std::uint32_t value = bytes[0] | (std::uint32_t{bytes[1]} << 8U) | (std::uint32_t{bytes[2]} << 16U) |
                                (std::uint32_t{bytes[3]} << 24U);
    return abort == cia301::SdoAbort::kNone ? value : static_cast<std::uint32_t>(abort);
}

struct Number
{
    const char* section;
    const char* type;
    ObjectAddress object;
    std::uint32_t value;
    std::uint8_t size_bytes;
};

using FurtherObjectsTest = cia306::test::FolderTest;

TEST_F(FurtherObjectsTest, AConstantHasTheValueOfTheFileAndTakesNone)
{
    Verifies(req::SRS_NODE_037);
    const std::vector<Number> numbers{
        {"1006", "7", {0x1006U, 0U}, 10000U, 4U},      {"1007", "7", {0x1007U, 0U}, 5000U, 4U},
        {"100C", "6", {0x100CU, 0U}, 100U, 2U},        {"100D", "5", {0x100DU, 0U}, 3U, 1U},
        {"1012", "7", {0x1012U, 0U}, 0x80000100U, 4U}, {"1019", "5", {0x1019U, 0U}, 8U, 1U},
        {"1028sub0", "5", {0x1028U, 0U}, 1U, 1U},      {"1028sub1", "7", {0x1028U, 1U}, 0x81U, 4U},
        {"1201sub0", "5", {0x1201U, 0U}, 3U, 1U},      {"1201sub1", "7", {0x1201U, 1U}, 0x690U, 4U},
        {"1201sub2", "7", {0x1201U, 2U}, 0x691U, 4U},  {"1201sub3", "5", {0x1201U, 3U}, 9U, 1U},
        {"1280sub0", "5", {0x1280U, 0U}, 3U, 1U},      {"1280sub1", "7", {0x1280U, 1U}, 0x606U, 4U},
        {"1280sub2", "7", {0x1280U, 2U}, 0x586U, 4U},  {"1280sub3", "5", {0x1280U, 3U}, 6U, 1U}};
    for (const char* const access : {"const", "ro"})
    {
        std::string text = kHead + Record("1028") + Record("1201") + Record("1280");
        for (const Number& number : numbers)
        {
            text += Element(number.section, number.type, access, std::to_string(number.value));
        }
        Bench bench(File("node.dcf", text));
        for (const Number& number : numbers)
        {
            EXPECT_EQ(Read(bench, number.object), number.value) << access << " " << number.section;
            EXPECT_EQ(bench.Download(number.object.index, number.object.sub, number.value, number.size_bytes),
                      kReadOnly)
                << access << " " << number.section;
        }
        // And the services work with them: the client is that of node 6, the second server answers
        EXPECT_NE(bench.Device().Assembly().Optional().ClientOf(6U), nullptr);
        bench.Receive(0x100U, {0xDCU, 0x05U, 0U, 0U, 2U, 0U});
        bench.Receive(0x081U, {0x30U, 0x81U, 0x11U, 0U, 0U, 0U, 0U, 0U});
        bench.Cycle();
        const std::string told = bench.Told();
        EXPECT_NE(told.find("time 1500 ms of day 2"), std::string::npos) << told;
        EXPECT_NE(told.find("emergency of node 1: 0x8130"), std::string::npos) << told;
        EXPECT_EQ(told.find("warning"), std::string::npos) << told;
    }
}

TEST_F(FurtherObjectsTest, WhatServicesCountThemselvesIsNotThatOfTheFile)
{
    Verifies(req::SRS_NODE_037);
    for (const char* const access : {"const", "ro"})
    {
        // Given other values in the file for error register, errors, what a store can, and the default SDO
        Bench bench(File(
            "node.dcf",
            "[DeviceInfo]\nVendorName=test\n[DeviceComissioning]\nNodeID=5\n" + Element("1000", "7", "ro", "0") +
                Element("1001", "5", access, "0x55") + Record("1003") + Element("1003sub0", "5", access, "1") +
                Element("1003sub1", "7", access, "0x1234") + Record("1010") + Element("1010sub0", "5", access, "1") +
                Element("1010sub1", "7", access, "3") + Record("1011") + Element("1011sub0", "5", access, "1") +
                Element("1011sub1", "7", access, "3") + Record("1200") + Element("1200sub0", "5", access, "2") +
                Element("1200sub1", "7", access, "0x606") + Element("1200sub2", "7", access, "0x586")));
        // Then no error is there, nothing can be stored without a store, and the default SDO is that of the node-ID
        EXPECT_EQ(Read(bench, {0x1001U, 0U}), 0U) << access;
        EXPECT_EQ(Read(bench, {0x1003U, 0U}), 0U) << access;
        EXPECT_EQ(Read(bench, {0x1003U, 1U}), 0x08000024U) << access;
        EXPECT_EQ(Read(bench, {0x1010U, 1U}), 0U) << access;
        EXPECT_EQ(Read(bench, {0x1011U, 1U}), 0U) << access;
        EXPECT_EQ(Read(bench, {0x1200U, 1U}), 0x605U) << access;
        EXPECT_EQ(Read(bench, {0x1200U, 2U}), 0x585U) << access;
    }
}

TEST_F(FurtherObjectsTest, SubIndicesAreThoseOfTheFile)
{
    Verifies(req::SRS_NODE_038);
    Bench bench(File("node.dcf", kHead + Record("1010") + Element("1010sub1", "7", "rw", "1") + Record("1011") +
                                     Element("1011sub1", "7", "rw", "1") + Element("1011sub5", "7", "rw", "1") +
                                     Record("1028") + Element("1028sub0", "5", "rw", "2") +
                                     Element("1028sub1", "7", "rw", "0x81") + Element("1028sub2", "7", "rw", "0x82") +
                                     Record("1200") + Element("1200sub1", "7", "ro", "") + Record("1201") +
                                     Element("1201sub0", "5", "ro", "") + Element("1201sub1", "7", "rw", "0x690") +
                                     Element("1201sub2", "7", "rw", "0x691") + Record("1280") +
                                     Element("1280sub0", "5", "const", "3") + Element("1280sub1", "7", "rw", "0x606") +
                                     Element("1280sub2", "7", "rw", "0x586") + Element("1280sub3", "5", "rw", "6")),
                Path("node.store"));
    EXPECT_EQ(Read(bench, {0x1028U, 0U}), 2U);
    EXPECT_EQ(Read(bench, {0x1201U, 0U}), 2U);
    EXPECT_EQ(Read(bench, {0x1280U, 0U}), 3U);
    EXPECT_EQ(bench.Download(0x1028U, 0U, 2U, 1U), 0U);
    EXPECT_EQ(bench.Download(0x1028U, 0U, 1U, 1U), kReadOnly);
    EXPECT_EQ(Read(bench, {0x1028U, 3U}), kSubUnknown);
    EXPECT_EQ(Read(bench, {0x1200U, 1U}), 0x605U);
    EXPECT_EQ(Read(bench, {0x1200U, 2U}), kSubUnknown);
    EXPECT_EQ(Read(bench, {0x1201U, 3U}), kSubUnknown);
    EXPECT_EQ(bench.Download(0x1201U, 3U, 9U, 1U), kSubUnknown);
    EXPECT_EQ(Read(bench, {0x1280U, 4U}), kSubUnknown);
    // Of 1011h there are groups 1 to 4 to restore
    EXPECT_EQ(Read(bench, {0x1011U, 1U}), 1U);
    EXPECT_EQ(Read(bench, {0x1011U, 5U}), 0U);
    EXPECT_EQ(bench.Download(0x1011U, 5U, 0x64616F6CU, 4U), 0x08000020U);
}
TEST_F(FurtherObjectsTest, SubIndicesOfTheLastObjectsAreThoseOfTheFile)
{
    Verifies(req::SRS_NODE_038);
    // Given the last object of servers, clients, RPDOs and TPDOs, one of them with a sub-index that nobody writes
    Bench bench(File(
        "node.dcf",
        kHead + Record("127F") + Element("127Fsub0", "5", "ro", "") + Element("127Fsub1", "7", "rw", "0x80000000") +
            Element("127Fsub2", "7", "rw", "0x80000000") + Record("12FF") + Element("12FFsub0", "5", "rw", "2") +
            Element("12FFsub1", "7", "rw", "0x80000000") + Element("12FFsub2", "7", "rw", "0x80000000") +
            Record("15FF") + Element("15FFsub0", "5", "const", "2") + Element("15FFsub1", "7", "rw", "0x80000206") +
            Element("15FFsub2", "5", "rw", "254") + Record("19FF") + Element("19FFsub0", "5", "rw", "5") +
            Element("19FFsub1", "7", "rw", "0xC0000186") + Element("19FFsub2", "5", "rw", "254") +
            Element("19FFsub4", "5", "ro", "4") + Element("19FFsub5", "6", "rw", "0")));
    const std::vector<std::pair<ObjectAddress, std::uint32_t>> present{
        {{0x127FU, 0U}, 2U}, {{0x12FFU, 0U}, 2U}, {{0x15FFU, 0U}, 2U},  {{0x15FFU, 2U}, 254U},
        {{0x19FFU, 0U}, 5U}, {{0x19FFU, 4U}, 4U}, {{0x19FFU, 2U}, 254U}};
    for (const auto& [object, value] : present)
    {
        EXPECT_EQ(Read(bench, object), value) << std::hex << object.index;
    }
    for (const ObjectAddress& object : {ObjectAddress{0x127FU, 3U}, ObjectAddress{0x12FFU, 3U},
                                        ObjectAddress{0x15FFU, 3U}, ObjectAddress{0x19FFU, 3U}})
    {
        EXPECT_EQ(Read(bench, object), 0x06090011U) << std::hex << object.index;
        EXPECT_EQ(bench.Download(object.index, object.sub, 0U, 1U), 0x06090011U) << std::hex << object.index;
    }
    // Then its access is kept as well, and sub-index 0 takes its own value alone
    EXPECT_EQ(bench.Download(0x19FFU, 4U, 4U, 1U), 0x06010002U);
    for (const std::uint16_t index : {std::uint16_t{0x12FFU}, std::uint16_t{0x19FFU}})
    {
        const std::uint32_t own = (index == 0x12FFU) ? 2U : 5U;
        EXPECT_EQ(bench.Download(index, 0U, own, 1U), 0U) << std::hex << index;
        EXPECT_EQ(bench.Download(index, 0U, own + 1U, 1U), 0x06010002U) << std::hex << index;
        EXPECT_EQ(bench.Download(index, 0U, own - 1U, 1U), 0x06010002U) << std::hex << index;
    }
}

} // namespace
} // namespace counterpoint::tools::test
