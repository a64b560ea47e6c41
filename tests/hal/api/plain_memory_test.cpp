// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/api/plain_memory.hpp"
#include "hal/host/memory.hpp"
#include "verification/trace/ids/selftest.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>

namespace counterpoint::hal
{
namespace
{

void ExpectAccessToTheCell(MemoryAccess& memory)
{
    // Given two words of a program
    std::array<std::uint32_t, 2> words{0x1122'3344U, 0x5566'7788U};
    const Address second = memory.PlaceOf(&words[1]);
    // When one is read, written and exchanged through the access
    EXPECT_EQ(memory.Read(second), 0x5566'7788U);
    memory.Write(second, 0xCAFE'0001U);
    EXPECT_EQ(words[1], 0xCAFE'0001U);
    EXPECT_EQ(memory.Exchange(second, 0xCAFE'0002U), 0xCAFE'0001U);
    // Then it has the last value, and its neighbour is as it was
    EXPECT_EQ(words[1], 0xCAFE'0002U);
    EXPECT_EQ(words[0], 0x1122'3344U);
    EXPECT_EQ(second - memory.PlaceOf(words.data()), 4U);
}

void ExpectStackPosition(const MemoryAccess& memory)
{
    // Given a place on the stack of the caller
    const Address here = memory.PlaceOf(__builtin_frame_address(0));
    // Then the position is below it, and near
    const Address position = memory.StackPosition();
    EXPECT_LT(position, here);
    EXPECT_LT(here - position, 2048U);
}

TEST(MemoryAccess, ReadsWritesAndExchangesTheCellItself)
{
    Verifies(req::SRS_STS_014);
    PlainMemory plain;
    ExpectAccessToTheCell(plain);
    host::HostMemory of_host;
    ExpectAccessToTheCell(of_host);
}

TEST(MemoryAccess, TellsWhereTheStackIsInUse)
{
    Verifies(req::SRS_STS_014);
    ExpectStackPosition(PlainMemory{});
    ExpectStackPosition(host::HostMemory{});
}

} // namespace
} // namespace counterpoint::hal
