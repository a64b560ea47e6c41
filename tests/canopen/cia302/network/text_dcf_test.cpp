// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia302/network/text_dcf.hpp"
#include "tests/canopen/start_up/boot_rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/nmt_master.hpp"

#include <string>

namespace counterpoint::cia302
{
namespace
{

Bytes BytesOf(const std::string& text)
{
    return Bytes{reinterpret_cast<const std::uint8_t*>(text.data()), static_cast<std::uint32_t>(text.size())};
}

/// One object 2000h of this type with this value, for node 5.
TextReading Read(const std::string& type, const std::string& value)
{
    static std::string text{};
    text = "[2000]\nAccessType=rw\nDataType=" + type + "\nParameterValue=" + value + "\n";
    return ReadTextDcf(BytesOf(text), 0U, NodeId{5U});
}

struct Case
{
    const char* type;
    const char* value;
    std::uint64_t number;
    std::uint32_t size;
};

TEST(TextDcfTest, NumbersOfAllKinds)
{
    Verifies(req::SRS_BOOT_010);
    const Case cases[] = {{"0x0005", "0x1F", 0x1FU, 1U},
                          {"0x0007", "$NODEID+0x180", 0x185U, 4U},
                          {"7", "0x80000200 + $nodeid", 0x80000205U, 4U},
                          {"0x6", "$NODEID", 5U, 2U},
                          {"0x0002", "-1", 0xFFU, 1U},
                          {"0x0002", "-128", 0x80U, 1U},
                          {"0x0003", "-2", 0xFFFEU, 2U},
                          {"0x0005", "255", 255U, 1U},
                          {"0x0005", "010", 8U, 1U},
                          {"0x0001", "1", 1U, 1U},
                          {"0x0016", "0xABCDEF", 0xABCDEFU, 3U},
                          {"0x001B", "0xFFFFFFFFFFFFFFFF", 0xFFFFFFFFFFFFFFFFU, 8U},
                          {"0x001B", "18446744073709551615", 0xFFFFFFFFFFFFFFFFU, 8U},
                          {"0x001B", "01777777777777777777777", 0xFFFFFFFFFFFFFFFFU, 8U},
                          {"0x0015", "-9223372036854775808", 0x8000000000000000U, 8U},
                          {"0x0008", "0x3F800000", 0x3F800000U, 4U}};
    for (const Case& one : cases)
    {
        const TextReading reading = Read(one.type, one.value);
        EXPECT_EQ(reading.state, TextState::kEntry) << one.value;
        EXPECT_EQ(reading.number, one.number) << one.value;
        EXPECT_EQ(reading.size_bytes, one.size) << one.value;
        EXPECT_EQ(reading.text, nullptr);
        EXPECT_EQ(reading.object.index, 0x2000U);
    }
}

TEST(TextDcfTest, ValuesThatCannotBeUnderstood)
{
    Verifies(req::SRS_BOOT_010);
    const Case cases[] = {{"0x0005", "256", 0U, 0U},
                          {"0x0005", "0x", 0U, 0U},
                          {"0x0005", "12x", 0U, 0U},
                          {"0x0005", "08", 0U, 0U},
                          {"0x0002", "-129", 0U, 0U},
                          {"0x0005", "1+2", 0U, 0U},
                          {"0x0005", "$NODEID+", 0U, 0U},
                          {"0x0005", "$NODEID+$NODEID", 0U, 0U},
                          {"0x0008", "1.5", 0U, 0U},
                          {"0x000A", "00", 0U, 0U},
                          {"0x001C", "0", 0U, 0U},
                          {"", "0", 0U, 0U},
                          {"0x001B", "0x10000000000000000", 0U, 0U},
                          {"0x001B", "18446744073709551616", 0U, 0U},
                          {"0x001B", "18446744073709551620", 0U, 0U},
                          {"0x001B", "02000000000000000000000", 0U, 0U},
                          {"0x0005", "-", 0U, 0U}};
    for (const Case& one : cases)
    {
        EXPECT_EQ(Read(one.type, one.value).state, TextState::kMalformed) << one.value;
    }
}

TEST(TextDcfTest, ObjectsInTheOrderOfTheFileAndOnlyThoseThatAreWritten)
{
    Verifies(req::SRS_BOOT_010);
    const std::string text =
        "; a comment\r\n[DeviceInfo]\r\nParameterValue=1\r\nAccessType=rw\r\n"
        "[1018Sub1]\r\nParameterName=Vendor\r\nDataType=0x0007\r\nAccessType=ro\r\nParameterValue=1\r\n"
        "[1400sub2]\r\nparametervalue = 254 \r\n;ParameterValue=1\r\nDATATYPE=0x0005\r\naccesstype=RW\r\n"
        "[2001]\r\nDataType=0x0009\r\nAccessType=wo\r\nParameterValue=two words\r\n"
        "[2002]\r\nDataType=0x0005\r\nAccessType=rwr\r\nParameterValue=\r\n"
        "[2002Value]\r\nDataType=0x0005\r\nAccessType=rw\r\nParameterValue=1\r\n"
        "[2003subFF]\r\nDataType=0x0005\r\nAccessType=rww\r\nParameterValue=3";
    const TextReading first = ReadTextDcf(BytesOf(text), 0U, NodeId{5U});
    EXPECT_EQ(first.state, TextState::kEntry);
    EXPECT_EQ(first.object.index, 0x1400U);
    EXPECT_EQ(first.object.sub, 2U);
    EXPECT_EQ(first.number, 254U);
    const TextReading second = ReadTextDcf(BytesOf(text), first.next, NodeId{5U});
    EXPECT_EQ(second.object.index, 0x2001U);
    ASSERT_NE(second.text, nullptr);
    EXPECT_EQ(std::string(reinterpret_cast<const char*>(second.text), second.size_bytes), "two words");
    const TextReading third = ReadTextDcf(BytesOf(text), second.next, NodeId{5U});
    EXPECT_EQ(third.object.index, 0x2003U);
    EXPECT_EQ(third.object.sub, 0xFFU);
    EXPECT_EQ(third.number, 3U);
    EXPECT_EQ(ReadTextDcf(BytesOf(text), third.next, NodeId{5U}).state, TextState::kEnd);
    EXPECT_EQ(ReadTextDcf(Bytes{nullptr, 0U}, 0U, NodeId{5U}).state, TextState::kEnd);
}

TEST(TextDcfTest, WhatADownloadIsNotToWriteIsLeftOut)
{
    Verifies(req::SRS_MGR_322);
    const auto state = [](const char* const flags) { return Read("5", std::string("1\nObjFlags=") + flags).state; };
    EXPECT_EQ(state("1"), TextState::kEnd);
    EXPECT_EQ(state("0x3"), TextState::kEnd);
    EXPECT_EQ(state("2"), TextState::kEntry);
    EXPECT_EQ(state("0"), TextState::kEntry);
    EXPECT_EQ(state("no"), TextState::kEntry);
}

TEST(TextDcfTest, EveryBeginOfATextEnds)
{
    Verifies(req::SRS_BOOT_010);
    const std::string text =
        "[2000sub1]\nDataType=0x0005\nAccessType=rw\nParameterValue=$NODEID+1\n[\n[]\n[sub]\n=\n[20001]\n";
    for (std::size_t length = 0U; length <= text.size(); ++length)
    {
        const std::string begin = text.substr(0U, length);
        std::uint32_t at = 0U;
        int entries = 0;
        TextReading reading = ReadTextDcf(BytesOf(begin), at, NodeId{5U});
        while ((reading.state == TextState::kEntry) && (entries < 10))
        {
            ++entries;
            at = reading.next;
            reading = ReadTextDcf(BytesOf(begin), at, NodeId{5U});
        }
        EXPECT_LE(entries, 1);
    }
}

using TextBootTest = BootRig;

TEST_F(TextBootTest, TextFirstThenConciseAndAnErrorInTheTextIsJ)
{
    Verifies(req::SRS_BOOT_010);
    const std::string text = "[2000]\nDataType=0x0007\nAccessType=rw\nParameterValue=$NODEID+0x180\n"
                             "[2001]\nDataType=0x0009\nAccessType=rw\nParameterValue=twelve bytes\n";
    const std::string wrong = "[2000]\nDataType=0x0005\nAccessType=rw\nParameterValue=0x100\n";
    Octets dcf{};
    AddEntry(dcf, 0x2000U, 0U, {1U, 0U, 0U, 0U});
    for (const std::uint8_t node : {std::uint8_t{5U}, std::uint8_t{6U}, std::uint8_t{7U}})
    {
        FakeSlave& slave = Add(node, kBoot);
        slave.Put32(0x2000U, 0U, 0U);
        slave.Put(0x2001U, 0U, Octets{});
        setups[node].dcf = BytesOf((node == 6U) ? wrong : text);
        setups[node].concise_dcf = Bytes{dcf.data(), static_cast<std::uint32_t>(dcf.size())};
    }
    slaves[7]->refused[0x200100U] = SdoAbort::kHardware;
    setups[5].concise_dcf = Bytes{nullptr, 0U};
    Begin();
    Run(20U);
    EXPECT_EQ(Letter(5U), "-");
    EXPECT_EQ(slaves[5]->Get(0x2000U, 0U), (Octets{0x85U, 1U, 0U, 0U}));
    EXPECT_EQ(slaves[5]->Get(0x2001U, 0U).size(), 12U);
    EXPECT_EQ(Letter(6U), "J");
    EXPECT_EQ(Of(6U).object.index, 0x1F20U);
    EXPECT_EQ(Of(6U).object.sub, 6U);
    EXPECT_EQ(Letter(7U), "J");
    EXPECT_EQ(Of(7U).object.index, 0x2001U);
    setups[7].dcf = Bytes{nullptr, 0U};
    EXPECT_TRUE(start_up.Boot(NodeId{7U}, Now()));
    Run(20U);
    EXPECT_EQ(slaves[7]->Get(0x2000U, 0U), (Octets{1U, 0U, 0U, 0U}));
}

TEST(TextDcfTest, SectionsOfNoObjectEmptyLinesAndTabs)
{
    Verifies(req::SRS_BOOT_010);
    const std::string body = "\nDataType=0x0005\nAccessType=rw\nParameterValue=3\n\n";
    // Neither an index nor a sub-index above those that there are, nor one with something behind
    const std::string text = "[10000]" + body + "[2000sub100]" + body + "[2000sub1x]" + body + "[2000subx]" + body +
                             "\t[2000sub1]\t\n\n\tDataType\t=\t0x0005\n\t\nAccessType=rw\nParameterValue=4\t\n";
    const TextReading reading = ReadTextDcf(BytesOf(text), 0U, NodeId{5U});
    EXPECT_EQ(reading.state, TextState::kEntry);
    EXPECT_EQ(reading.object.index, 0x2000U);
    EXPECT_EQ(reading.object.sub, 1U);
    EXPECT_EQ(reading.number, 4U);
    EXPECT_EQ(ReadTextDcf(BytesOf(text), reading.next, NodeId{5U}).state, TextState::kEnd);
}

} // namespace
} // namespace counterpoint::cia302
