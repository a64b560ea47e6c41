// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/safe_state_latch.hpp"

#include "verification/trace/ids/kernel.hpp"
#include "verification/trace/verifies.hpp"

#include <cstdint>
#include <cstring>

namespace counterpoint
{
namespace
{

TEST(SafeStateLatch, ZeroFilledMemoryIsTheSafeState)
{
    Verifies(req::SRS_KRN_003);
    // Given a latch that nobody armed
    SafeStateLatch latch{};
    // Then it grants nothing and spoils every permit
    EXPECT_FALSE(latch.IsRunning());
    EXPECT_EQ(latch.Gate(), 0U);
    EXPECT_NE(latch.Spoiler(), 0U);
    EXPECT_EQ(latch.Report().fault, DeviceFault::kInvalid);
    EXPECT_EQ(latch.Report().slot, kNoSlot);
    EXPECT_EQ(latch.Report().count, 0U);
}

TEST(SafeStateLatch, StartForgetsWhatWasRecorded)
{
    Verifies(req::SRS_KRN_003);
    SafeStateLatch latch{};
    latch.Arm();
    latch.Enter(DeviceFault::kClock, 5U);
    latch.Arm();
    EXPECT_EQ(latch.Report().slot, kNoSlot);
    EXPECT_EQ(latch.Report().count, 0U);
}

TEST(SafeStateLatch, ArmedLatchRuns)
{
    Verifies(req::SRS_KRN_003);
    SafeStateLatch latch{};
    latch.Arm();
    EXPECT_TRUE(latch.IsRunning());
    EXPECT_EQ(latch.Gate(), 0xFFFFFFFFFFFFFFFFU);
    EXPECT_EQ(latch.Spoiler(), 0U);
    EXPECT_EQ(latch.Report().fault, DeviceFault::kNone);
    EXPECT_EQ(latch.Report().count, 0U);
}

TEST(SafeStateLatch, FirstFaultIsKeptAndLaterOnesAreCounted)
{
    Verifies(req::SRS_KRN_003);
    SafeStateLatch latch{};
    latch.Arm();
    // When no fault, then two different ones come
    latch.Enter(DeviceFault::kNone, 3U);
    EXPECT_TRUE(latch.IsRunning());
    latch.Enter(DeviceFault::kClock, 5U);
    latch.Enter(DeviceFault::kFlow, 6U);
    // Then the first is reported with its slot, both are counted, and nothing runs
    EXPECT_FALSE(latch.IsRunning());
    EXPECT_EQ(latch.Gate(), 0U);
    EXPECT_EQ(latch.Report().fault, DeviceFault::kClock);
    EXPECT_EQ(latch.Report().slot, 5U);
    EXPECT_EQ(latch.Report().count, 2U);
}

TEST(SafeStateLatch, DemandDoesNotDependOnWhatEnterDecides)
{
    Verifies(req::SRS_KRN_031);
    SafeStateLatch latch{};
    latch.Arm();
    // Given a demand whose fault Enter takes for none
    latch.Demand(DeviceFault::kNone);
    // Then nothing runs all the same
    EXPECT_FALSE(latch.IsRunning());
    EXPECT_EQ(latch.Gate(), 0U);
    EXPECT_NE(latch.Spoiler(), 0U);
    EXPECT_EQ(latch.Report().fault, DeviceFault::kInvalid);
    // and the next fault is recorded
    latch.Demand(DeviceFault::kApplication);
    EXPECT_EQ(latch.Report().fault, DeviceFault::kApplication);
    EXPECT_EQ(latch.Report().slot, kNoSlot);
    EXPECT_EQ(latch.Report().count, 1U);
}

TEST(SafeStateLatch, CountStaysAtItsGreatestValue)
{
    Verifies(req::SRS_KRN_003);
    SafeStateLatch latch{};
    latch.Arm();
    for (std::uint32_t number = 0U; number < 65536U; ++number)
    {
        latch.Enter(DeviceFault::kGuard, 0U);
    }
    EXPECT_EQ(latch.Report().count, 65535U);
}

/// The first eight bytes of a latch are its two words.
void FlipWordBit(SafeStateLatch& latch, const std::uint32_t bit)
{
    unsigned char bytes[sizeof(SafeStateLatch)];
    std::memcpy(bytes, &latch, sizeof(bytes));
    bytes[bit / 8U] = static_cast<unsigned char>(bytes[bit / 8U] ^ (1U << (bit % 8U)));
    std::memcpy(static_cast<void*>(&latch), bytes, sizeof(bytes));
}

/// Neither word is what it is in a running latch.
bool HaveBothWordsLeft(const SafeStateLatch& latch)
{
    std::uint32_t words[2];
    std::memcpy(&words[0], &latch, sizeof(words));
    return (words[0] != 0x5A5A5A5AU) && (words[1] != 0xA5A5A5A5U);
}

// Each way into the safe state: the other word alone would stop the latch as well.
TEST(SafeStateLatch, BothWordsLeaveTheRunningPattern)
{
    Verifies(req::SRS_KRN_003);
    Verifies(req::SRS_KRN_041);
    SafeStateLatch latch{};
    latch.Arm();
    EXPECT_FALSE(HaveBothWordsLeft(latch));
    latch.Enter(DeviceFault::kClock, 5U);
    EXPECT_TRUE(HaveBothWordsLeft(latch));
    latch.Arm();
    latch.Disarm();
    EXPECT_TRUE(HaveBothWordsLeft(latch));
    for (std::uint32_t bit = 0U; bit < 64U; ++bit)
    {
        latch.Arm();
        FlipWordBit(latch, bit);
        EXPECT_FALSE(latch.IsRunning());
        EXPECT_TRUE(HaveBothWordsLeft(latch)) << "bit " << bit;
    }
}

TEST(SafeStateLatch, AnySingleFlippedBitOfItsWordsStopsIt)
{
    Verifies(req::SRS_KRN_003);
    // Given every single-bit error in the first eight bytes, the two complementary words
    for (std::uint32_t bit = 0U; bit < 64U; ++bit)
    {
        SafeStateLatch latch{};
        latch.Arm();
        FlipWordBit(latch, bit);
        // Then the latch is in the safe state
        EXPECT_FALSE(latch.IsRunning()) << "bit " << bit;
        EXPECT_NE(latch.Spoiler(), 0U) << "bit " << bit;
        EXPECT_EQ(latch.Gate(), 0U) << "bit " << bit;
        // And says that nobody entered it
        EXPECT_EQ(latch.Report().fault, DeviceFault::kInvalid) << "bit " << bit;
    }
}

// bit    changed    looked at    changed back
// latch  runs       safe         safe
TEST(SafeStateLatch, BitThatComesBackDoesNotStartItAgain)
{
    Verifies(req::SRS_KRN_041);
    for (std::uint32_t bit = 0U; bit < 64U; ++bit)
    {
        for (std::uint32_t look = 0U; look < 3U; ++look)
        {
            SafeStateLatch latch{};
            latch.Arm();
            // When a bit is otherwise, one of the three questions is asked, and the bit comes back
            FlipWordBit(latch, bit);
            const bool is_safe = (look == 0U)   ? !latch.IsRunning()
                                 : (look == 1U) ? (latch.Gate() == 0U)
                                                : (latch.Spoiler() != 0U);
            EXPECT_TRUE(is_safe) << "bit " << bit;
            FlipWordBit(latch, bit);
            // Then the device stays safe, and a start is what ends it
            EXPECT_FALSE(latch.SaysRunning()) << "bit " << bit << ", question " << look;
            EXPECT_EQ(latch.Report().fault, DeviceFault::kInvalid) << "bit " << bit;
            latch.Arm();
            EXPECT_TRUE(latch.IsRunning());
        }
    }
}

TEST(SafeStateLatch, WhoOnlyLooksChangesNothing)
{
    Verifies(req::SRS_KRN_041);
    SafeStateLatch latch{};
    latch.Arm();
    FlipWordBit(latch, 7U);
    EXPECT_FALSE(latch.SaysRunning());
    EXPECT_EQ(latch.Report().fault, DeviceFault::kInvalid);
    FlipWordBit(latch, 7U);
    EXPECT_TRUE(latch.SaysRunning());
}

TEST(SafeStateLatch, FlippedRecordOfARunningLatchTellsNoFault)
{
    Verifies(req::SRS_KRN_003);
    // Given every single-bit error in the byte behind the two words, the record of the first fault
    for (std::uint32_t bit = 0U; bit < 8U; ++bit)
    {
        SafeStateLatch latch{};
        latch.Arm();
        unsigned char bytes[sizeof(SafeStateLatch)];
        std::memcpy(bytes, &latch, sizeof(bytes));
        bytes[8U] = static_cast<unsigned char>(bytes[8U] ^ (1U << bit));
        std::memcpy(static_cast<void*>(&latch), bytes, sizeof(bytes));
        // Then the latch runs and says so
        EXPECT_TRUE(latch.IsRunning()) << "bit " << bit;
        EXPECT_EQ(latch.Report().fault, DeviceFault::kNone) << "bit " << bit;
        // And a fault that comes is the first one
        latch.Enter(DeviceFault::kClock, 5U);
        EXPECT_FALSE(latch.IsRunning()) << "bit " << bit;
        EXPECT_EQ(latch.Report().fault, DeviceFault::kClock) << "bit " << bit;
        EXPECT_EQ(latch.Report().slot, 5U) << "bit " << bit;
    }
}

TEST(SafeStateLatch, FaultThatComesToACorruptedLatchIsKept)
{
    Verifies(req::SRS_KRN_003);
    // Given a latch whose first word was hit
    SafeStateLatch latch{};
    latch.Arm();
    unsigned char bytes[sizeof(SafeStateLatch)];
    std::memcpy(bytes, &latch, sizeof(bytes));
    bytes[0] = static_cast<unsigned char>(bytes[0] ^ 1U);
    std::memcpy(static_cast<void*>(&latch), bytes, sizeof(bytes));
    // When a fault comes
    latch.Enter(DeviceFault::kClock, 5U);
    // Then it is told, with its slot
    EXPECT_FALSE(latch.IsRunning());
    EXPECT_EQ(latch.Report().fault, DeviceFault::kClock);
    EXPECT_EQ(latch.Report().slot, 5U);
}

} // namespace
} // namespace counterpoint
