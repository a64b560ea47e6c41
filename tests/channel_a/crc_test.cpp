// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The tables of both checksums, that their check while compiling finds a wrong one, and what the digest is made of.
#include "channel_a/crc.hpp"
#include "tests/channel_a/device.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/ids/kernel.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>

namespace counterpoint::channel_a
{
namespace
{

constexpr char kText[] = "123456789";

TEST(ChannelACrc, OfSixteenBitsIsThatOfTheStandard)
{
    Verifies(req::SRS_CFG_010);
    Crc16 crc{};
    for (std::size_t place = 0U; place < 9U; ++place)
    {
        crc.AddByte(static_cast<std::uint8_t>(kText[place]));
    }
    EXPECT_EQ(crc.Value(), 0x31C3U);
    // Low byte first, and only as many as told
    Crc16 two{};
    two.AddBytes(0x00993231U, 2U);
    Crc16 other{};
    other.AddByte(0x31U);
    other.AddByte(0x32U);
    EXPECT_EQ(two.Value(), other.Value());
}

TEST(ChannelACrc, OfThirtyTwoBitsIsThatOfTheStandard)
{
    Verifies(req::SRS_CFG_034);
    Crc32 crc{0U};
    crc.AddWord(0x34333231U);
    crc.AddWord(0x38373635U);
    crc.AddByte(0x39U);
    EXPECT_EQ(crc.Value(), 0xCBF43926U);
    // It continues
    Crc32 first{0U};
    first.AddWord(0x34333231U);
    Crc32 second{first.Value()};
    second.AddWord(0x38373635U);
    second.AddByte(0x39U);
    EXPECT_EQ(second.Value(), 0xCBF43926U);
}

TEST(ChannelACrc, TablesAreThoseWorkedOutNow)
{
    Verifies(req::SRS_CFG_010);
    Verifies(req::SRS_CFG_034);
    const Table16 table16 = MakeTable16();
    const Table32 table32 = MakeTable32();
    EXPECT_EQ(std::memcmp(&table16, &kTable16, sizeof(table16)), 0);
    EXPECT_EQ(std::memcmp(&table32, &kTable32, sizeof(table32)), 0);
    EXPECT_EQ(kTable16.rest[0x80], 0x9188U);
    EXPECT_EQ(kTable16.rest[0xFF], 0x1EF0U);
    EXPECT_EQ(kTable32.rest[0x01], 0x77073096U);
    EXPECT_EQ(kTable32.rest[0xFF], 0x2D02EF8DU);
}

TEST(ChannelACrc, CheckOfTheTablesFindsEverySingleBit)
{
    Verifies(req::SRS_CFG_010);
    Verifies(req::SRS_CFG_034);
    EXPECT_EQ(WrongEntries(MakeTable16()), 0U);
    EXPECT_EQ(WrongEntries(MakeTable32()), 0U);
    for (std::size_t entry = 0U; entry < kByteValues; ++entry)
    {
        for (std::uint32_t bit = 0U; bit < 32U; ++bit)
        {
            Table16 table16 = MakeTable16();
            Table32 table32 = MakeTable32();
            table16.rest[entry] = static_cast<std::uint16_t>(table16.rest[entry] ^ (1U << (bit % 16U)));
            table32.rest[entry] ^= std::uint32_t{1U} << bit;
            EXPECT_NE(WrongEntries(table16), 0U) << entry << ", bit " << bit;
            EXPECT_NE(WrongEntries(table32), 0U) << entry << ", bit " << bit;
        }
    }
}

/// What the property makes of the entries of one bit each: every other one is the sum of those of its bits.
template <typename Table, typename Rest> Table FromBits(const Rest (&of_bit)[8])
{
    Table table{};
    for (std::size_t byte = 0U; byte < kByteValues; ++byte)
    {
        for (std::size_t bit = 0U; bit < 8U; ++bit)
        {
            const bool is_set = ((byte >> bit) & 1U) != 0U;
            table.rest[byte] = static_cast<Rest>(table.rest[byte] ^ (is_set ? of_bit[bit] : Rest{0U}));
        }
    }
    return table;
}

TEST(ChannelACrc, CheckOfTheTableOfSixteenBitsFindsWhatLooksRightElsewhere)
{
    Verifies(req::SRS_CFG_010);
    const std::uint16_t right[8] = {0x1021U, 0x2042U, 0x4084U, 0x8108U, 0x1231U, 0x2462U, 0x48C4U, 0x9188U};
    EXPECT_EQ(WrongEntries(FromBits<Table16>(right)), 0U);

    // Another polynomial, 1020h, throughout, and the same bit in the entry of 0
    std::uint16_t of_bit[8] = {0x1020U};
    for (std::size_t bit = 1U; bit < 8U; ++bit)
    {
        of_bit[bit] = static_cast<std::uint16_t>(Shifted16(of_bit[bit - 1U]));
    }
    Table16 table = FromBits<Table16>(of_bit);
    table.rest[0] = 0x0001U;
    EXPECT_NE(WrongEntries(table), 0U);

    // Right but for 02h, and everything that follows from it
    table = MakeTable16();
    table.rest[0x02] ^= 0x0001U;
    for (std::size_t byte = 2U; byte < 128U; ++byte)
    {
        table.rest[2U * byte] = static_cast<std::uint16_t>(Shifted16(table.rest[byte]));
        table.rest[(2U * byte) + 1U] = static_cast<std::uint16_t>(table.rest[2U * byte] ^ 0x1021U);
    }
    EXPECT_NE(WrongEntries(table), 0U);

    // The same bit in two neighbours that no other entry rests on
    table = MakeTable16();
    table.rest[0x80] ^= 0x0001U;
    table.rest[0x81] ^= 0x0001U;
    EXPECT_NE(WrongEntries(table), 0U);
    table = MakeTable16();
    table.rest[0x81] ^= 0x0001U;
    table.rest[0x82] ^= 0x0001U;
    EXPECT_NE(WrongEntries(table), 0U);
}

TEST(ChannelACrc, CheckOfTheTableOfThirtyTwoBitsFindsWhatLooksRightElsewhere)
{
    Verifies(req::SRS_CFG_034);
    const std::uint32_t right[8] = {0x77073096U, 0xEE0E612CU, 0x076DC419U, 0x0EDB8832U,
                                    0x1DB71064U, 0x3B6E20C8U, 0x76DC4190U, 0xEDB88320U};
    EXPECT_EQ(WrongEntries(FromBits<Table32>(right)), 0U);

    // Another polynomial, EDB88321h, throughout, and the same bit in the entry of 0
    std::uint32_t of_bit[8] = {0U, 0U, 0U, 0U, 0U, 0U, 0U, 0xEDB88321U};
    for (std::size_t bit = 7U; bit > 0U; --bit)
    {
        of_bit[bit - 1U] = Shifted32(of_bit[bit]);
    }
    Table32 table = FromBits<Table32>(of_bit);
    table.rest[0] = 0x00000001U;
    EXPECT_NE(WrongEntries(table), 0U);

    // A bit of 01h, and of 81h, which is the sum of 01h and 80h
    table = MakeTable32();
    table.rest[0x01] ^= 0x00000001U;
    table.rest[0x81] ^= 0x00000001U;
    EXPECT_NE(WrongEntries(table), 0U);

    // The same of 03h
    table.rest[0x03] ^= 0x00000001U;
    table.rest[0x83] ^= 0x00000001U;
    EXPECT_NE(WrongEntries(table), 0U);
}

// What was changed in the description behind the channel's back is no change of what the channel works by; what the
// kernel reads there as well is another matter, below.
TEST(ChannelADigest, IsThatOfTheOwnCopies)
{
    Verifies(req::SRS_CFG_348);
    using channel_a_test::Device;
    const auto fenced = std::make_unique<channel_a_test::FencedDevice>();
    Device& device = fenced->device;
    device.Start();
    const DeviceDigest first = device.channel.Digest(0U, DeviceDigest{0U});
    const DeviceDigest second = device.channel.Digest(1U, DeviceDigest{0U});
    const auto expect_same = [&device, &first, &second](const char* const what)
    {
        EXPECT_EQ(device.channel.Digest(0U, DeviceDigest{0U}).value, first.value) << what;
        EXPECT_EQ(device.channel.Digest(1U, DeviceDigest{0U}).value, second.value) << what;
    };
    // When policy, detection and safe value of both slots and the controller of the inverse frames are others
    for (SrdoSetup& setup : device.setups)
    {
        setup.policy = ReleasePolicy::kInterlock;
        expect_same("policy");
        setup.detection = SrvtDetection::kLate;
        expect_same("detection");
        setup.safe_value = Payload{0x12345678U, 0x9ABCDEF0U};
        expect_same("safe value");
    }
    device.config.inverse_port = CanPortId::kSecond;
    expect_same("controller");
    // Then the digest is another one only when the channel starts with them
    device.Start();
    EXPECT_NE(device.channel.Digest(0U, DeviceDigest{0U}).value, first.value);
    EXPECT_NE(device.channel.Digest(1U, DeviceDigest{0U}).value, second.value);
}

// The expected values were computed outside this program.
TEST(ChannelADigest, IsAnotherForEachBitOfTheFormThatTheKernelReads)
{
    Verifies(req::SRS_CFG_800);
    constexpr DeviceDigest kFirst{0xFB6C74B0U};
    for (const bool is_provider : {false, true})
    {
        // Given a producer of either form in slot 1
        const auto fenced = std::make_unique<channel_a_test::FencedDevice>();
        channel_a_test::Device& device = fenced->device;
        const ProducerForm form = is_provider ? ProducerForm::kProviderCalled : ProducerForm::kApplicationSends;
        device.setups[1].form = form;
        device.Start();
        const std::uint32_t expected = is_provider ? 0x14E3874EU : 0xD56D588EU;
        EXPECT_EQ(device.channel.Digest(0U, DeviceDigest{0U}).value, kFirst.value);
        EXPECT_EQ(device.channel.Digest(1U, kFirst).value, expected);
        for (std::uint32_t bit = 0U; bit < 8U; ++bit)
        {
            // When a bit of it flips in the description, then FFh is in its place, in this slot alone
            device.setups[1].form = static_cast<ProducerForm>(static_cast<std::uint32_t>(form) ^ (1U << bit));
            EXPECT_EQ(device.channel.Digest(0U, DeviceDigest{0U}).value, kFirst.value) << bit;
            EXPECT_EQ(device.channel.Digest(1U, kFirst).value, 0xCF56CB24U) << bit;
        }
        // and as before when it is what it was
        device.setups[1].form = form;
        EXPECT_EQ(device.channel.Digest(1U, kFirst).value, expected);
    }
}

TEST(ChannelADigest, IsAnotherForEachBitOfTheCopyOfTheForm)
{
    Verifies(req::SRS_CFG_800);
    constexpr DeviceDigest kFirst{0xFB6C74B0U};
    const auto fenced = std::make_unique<channel_a_test::FencedDevice>();
    channel_a_test::Device& device = fenced->device;
    device.Start();
    ProducerForm& copy = fenced->fence.storage.records[1].form;
    for (std::uint32_t bit = 0U; bit < 8U; ++bit)
    {
        copy = static_cast<ProducerForm>(1U << bit);
        EXPECT_EQ(device.channel.Digest(1U, kFirst).value, 0xCF56CB24U) << bit;
    }
}

TEST(ChannelADigest, IsAnotherForEachBitOfTheControllerThatTheKernelReads)
{
    Verifies(req::SRS_CFG_800);
    const auto fenced = std::make_unique<channel_a_test::FencedDevice>();
    channel_a_test::Device& device = fenced->device;
    device.Start();
    EXPECT_EQ(device.channel.Digest(0U, DeviceDigest{0U}).value, 0xFB6C74B0U);
    for (std::uint32_t bit = 0U; bit < 8U; ++bit)
    {
        device.config.normal_port = static_cast<CanPortId>(static_cast<std::uint32_t>(CanPortId::kFirst) ^ (1U << bit));
        EXPECT_EQ(device.channel.Digest(0U, DeviceDigest{0U}).value, 0xF3F17237U) << bit;
    }
    device.config.normal_port = CanPortId::kFirst;
    EXPECT_EQ(device.channel.Digest(0U, DeviceDigest{0U}).value, 0xFB6C74B0U);
}

} // namespace
} // namespace counterpoint::channel_a
