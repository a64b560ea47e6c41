// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/api/exception_record.hpp"
#include "verification/trace/ids/selftest.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstring>

namespace counterpoint::hal
{
namespace
{

bool IsNone(const ExceptionRecord& record)
{
    return (record.cause == ExceptionCause::kNone) && (record.address_low == 0U) && (record.address_high == 0U) &&
           (record.count == 0U);
}

TEST(ExceptionMemory, KeepsCauseAddressAndCountOverARestart)
{
    Verifies(req::SRS_STS_050);
    // Given storage that no start-up code clears, with whatever was in it
    ExceptionStorage storage{};
    std::memset(&storage, 0xA7, sizeof storage);
    // When two exceptions are recorded
    {
        ExceptionMemory memory(storage);
        EXPECT_TRUE(IsNone(memory.Read()));
        memory.Record(ExceptionCause::kBus, 0x0800'0004U);
        memory.Record(ExceptionCause::kDataAccess, 0x7FFF'1234'5678'9ABCU);
    }
    // Then after the restart the last one is known, and that it was the second
    const ExceptionRecord record = ExceptionMemory(storage).Read();
    EXPECT_EQ(record.cause, ExceptionCause::kDataAccess);
    EXPECT_EQ(record.address_low, 0x5678'9ABCU);
    EXPECT_EQ(record.address_high, 0x7FFF'1234U);
    EXPECT_EQ(record.count, 2U);
}

TEST(ExceptionMemory, SealIsTheCrc32OfTheFourWords)
{
    Verifies(req::SRS_STS_050);
    // Given a record of cause 1, address 0000000200000003h, count 1; words low byte first
    ExceptionStorage storage{};
    ExceptionMemory(storage).Record(ExceptionCause::kDataAccess, 0x0000'0002'0000'0003U);
    // Then its seal is CRC-32 of 01000000 03000000 02000000 01000000
    EXPECT_EQ(storage.seal, 0xCFD4'682CU);
}

TEST(ExceptionMemory, ZeroFilledStorageIsNoRecord)
{
    Verifies(req::SRS_STS_050);
    ExceptionStorage storage{};
    EXPECT_TRUE(IsNone(ExceptionMemory(storage).Read()));
}

TEST(ExceptionMemory, EachFlippedBitMakesItNoRecord)
{
    Verifies(req::SRS_STS_050);
    // Given a record
    ExceptionStorage storage{};
    ExceptionMemory memory(storage);
    memory.Record(ExceptionCause::kInstruction, 0x1000U);
    std::array<std::uint8_t, sizeof(ExceptionStorage)> bytes{};
    std::memcpy(bytes.data(), &storage, bytes.size());
    ASSERT_EQ(bytes.size(), 20U);
    for (std::size_t bit = 0U; bit < (bytes.size() * 8U); ++bit)
    {
        // When one bit is flipped, then there is no record
        std::array<std::uint8_t, sizeof(ExceptionStorage)> flipped = bytes;
        flipped[bit / 8U] = static_cast<std::uint8_t>(flipped[bit / 8U] ^ (1U << (bit % 8U)));
        std::memcpy(&storage, flipped.data(), flipped.size());
        EXPECT_TRUE(IsNone(memory.Read())) << "bit " << bit;
    }
}

TEST(ExceptionMemory, ClearForgetsAndCountStaysAtItsGreatest)
{
    Verifies(req::SRS_STS_050);
    // Given a record
    ExceptionStorage storage{};
    ExceptionMemory memory(storage);
    memory.Record(ExceptionCause::kProgram, 1U);
    // When it is cleared, then there is none, and the next is the first
    memory.Clear();
    EXPECT_TRUE(IsNone(memory.Read()));
    memory.Record(ExceptionCause::kArithmetic, 2U);
    EXPECT_EQ(memory.Read().count, 1U);
    EXPECT_EQ(memory.Read().cause, ExceptionCause::kArithmetic);
    // Given a record with the greatest count: FFFFFFFFh, sealed
    storage.record.count = 0xFFFF'FFFFU;
    storage.seal = 0x0A0A'B9AEU;
    ASSERT_EQ(memory.Read().count, 0xFFFF'FFFFU);
    // When one more comes, then the count does not start anew
    memory.Record(ExceptionCause::kArithmetic, 2U);
    EXPECT_EQ(memory.Read().count, 0xFFFF'FFFFU);
}

} // namespace
} // namespace counterpoint::hal
