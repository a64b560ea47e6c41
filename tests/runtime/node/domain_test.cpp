// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/dictionary/no_objects.hpp"
#include "canopen/cia306/file/device_reader.hpp"
#include "runtime/device/objects/objects.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstdint>

// How much a client may write into a DOMAIN.
namespace counterpoint::runtime
{
namespace
{
/// Room of 3000h, an object of this type and access, with a value.
std::uint32_t RoomOf(const std::string& keys, const std::uint32_t domain_bytes)
{
    const std::string text = "[3000]\n" + keys;
    const cia306::Device device = cia306::ReadDevice(cia306::IniDocument::Parse("room.dcf", text));
    const auto is_kernels = [](std::uint16_t, std::uint8_t) { return false; };
    const DeviceObjects objects(device, 5U, is_kernels, domain_bytes);
    return objects.Table().entries[0].size_bytes;
}

TEST(DomainRoom, IsThatOfTheSetting)
{
    Verifies(req::SRS_NODE_040);
    const std::string domain = "ObjectType=2\nAccessType=rw\n";
    EXPECT_EQ(RoomOf(domain, kDomainBytes), 8192U);
    EXPECT_EQ(RoomOf(domain, 1U), 1U);
    EXPECT_EQ(RoomOf(domain, 100000U), 100000U);
    // A longer value of the file has its own
    EXPECT_EQ(RoomOf(domain + "DefaultValue=abcdefghijklmnop\n", 4U), 16U);
    // Nobody writes it
    EXPECT_EQ(RoomOf("ObjectType=2\nAccessType=ro\nDefaultValue=abc\n", 8192U), 3U);
    // Strings are not concerned
    EXPECT_EQ(RoomOf("DataType=9\nAccessType=rw\n", 1U), 256U);
}

TEST(DomainRoom, ALongerWriteIsRefused)
{
    Verifies(req::SRS_NODE_040);
    const cia306::Device file =
        cia306::ReadDevice(cia306::IniDocument::Parse("room.dcf", "[3000]\nObjectType=2\nAccessType=rw\n"));
    const DeviceObjects objects(file, 5U, [](std::uint16_t, std::uint8_t) { return false; }, 4U);
    cia301::NoObjects none{};
    cia301::Dictionary dictionary{objects.Table(), none};
    dictionary.SetNmtState(NmtState::kPreOperational);
    const std::uint8_t bytes[5] = {1U, 2U, 3U, 4U, 5U};
    EXPECT_EQ(dictionary.Write({0x3000U, 0U}, {bytes, 4U}), cia301::SdoAbort::kNone);
    EXPECT_EQ(dictionary.Write({0x3000U, 0U}, {bytes, 5U}), cia301::SdoAbort::kTooLong);
}
} // namespace
} // namespace counterpoint::runtime
