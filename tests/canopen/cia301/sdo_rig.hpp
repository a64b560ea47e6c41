// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_CANOPEN_CIA301_SDO_RIG_HPP
#define TESTS_CANOPEN_CIA301_SDO_RIG_HPP

#include "canopen/cia301/sdo/server.hpp"
#include "tests/canopen/cia301/fake_objects.hpp"
#include "verification/trace/verifies.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace counterpoint::cia301
{

using Octets = std::vector<std::uint8_t>;

/// A server with a buffer of 1000 bytes, time-out 1000 us, blocks of 4 segments, over a small dictionary.
class SdoRig : public ::testing::Test
{
  public:
    SdoRig()
    {
        dictionary.SetNmtState(NmtState::kPreOperational);
        for (std::uint32_t i = 0U; i < 2000U; ++i)
        {
            domain[i] = static_cast<std::uint8_t>(i & 0xFFU);
        }
    }

    /// The answer's bytes; empty for none.
    static Octets Plain(const SdoAnswer& answer)
    {
        Octets bytes{};
        if (answer.presence == SdoPresence::kFrame)
        {
            bytes.assign(answer.frame.bytes, answer.frame.bytes + 8);
        }
        return bytes;
    }
    /// Missing bytes of a request are 0.
    Octets Send(const Octets& request)
    {
        SdoFrame frame{};
        for (std::size_t i = 0U; i < request.size(); ++i)
        {
            frame.bytes[i] = request[i];
        }
        return Plain(server.OnFrame(frame, 8U, Instant{now_us}));
    }
    Octets Poll()
    {
        return Plain(server.Poll(Instant{now_us}));
    }
    /// The abort frame for an object, by its code.
    static Octets AbortOf(std::uint16_t index, std::uint8_t sub, std::uint32_t code)
    {
        return {0x80U,
                static_cast<std::uint8_t>(index & 0xFFU),
                static_cast<std::uint8_t>(index >> 8U),
                sub,
                static_cast<std::uint8_t>(code & 0xFFU),
                static_cast<std::uint8_t>((code >> 8U) & 0xFFU),
                static_cast<std::uint8_t>((code >> 16U) & 0xFFU),
                static_cast<std::uint8_t>(code >> 24U)};
    }

    std::uint32_t now_us{0xFFFFFF00U}; // The counter wraps in every test that lets time pass.
    std::array<std::uint8_t, 4> u32{0x44U, 0x33U, 0x22U, 0x11U};
    std::array<std::uint8_t, 1> u8{0x7FU};
    std::array<std::uint8_t, 8> u64{1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U};
    std::array<std::uint8_t, 2000> domain{};
    std::uint32_t domain_length{0U};
    std::array<std::uint8_t, 3> u24{0xAAU, 0xBBU, 0xCCU};
    std::array<std::uint8_t, 2> u16{0x34U, 0x12U};
    std::array<Entry, 7> entries{{
        {0x1000U, 0U, DataType::kUnsigned32, Access::kConstant, kInBoth, kInBoth, 4U, u32.data(), nullptr, nullptr,
         nullptr, nullptr},
        {0x2100U, 0U, DataType::kUnsigned8, Access::kReadWrite, kInBoth, kInBoth, 1U, u8.data(), nullptr, nullptr,
         nullptr, nullptr},
        {0x2101U, 2U, DataType::kUnsigned32, Access::kReadWrite, kInBoth, kInBoth, 4U, u32.data(), nullptr, nullptr,
         nullptr, nullptr},
        {0x2102U, 0U, DataType::kUnsigned64, Access::kReadWrite, kInBoth, kInBoth, 8U, u64.data(), nullptr, nullptr,
         nullptr, nullptr},
        {0x2103U, 0U, DataType::kDomain, Access::kReadWrite, kInBoth, kInBoth, 2000U, domain.data(), &domain_length,
         nullptr, nullptr, nullptr},
        {0x2104U, 0U, DataType::kOctetString, Access::kReadWrite, kInBoth, kInBoth, 3U, u24.data(), nullptr, nullptr,
         nullptr, nullptr},
        {0x2105U, 0U, DataType::kUnsigned16, Access::kReadWrite, kInBoth, kInBoth, 2U, u16.data(), nullptr, nullptr,
         nullptr, nullptr},
    }};
    FakeObjects foreign{};
    Dictionary dictionary{EntryTable{entries.data(), 7U}, foreign};
    std::array<std::uint8_t, 1000> buffer{};
    SdoServer server{SdoServerParts{dictionary, Room{buffer.data(), 1000U}, 1000U, 4U}};
};

} // namespace counterpoint::cia301

#endif
