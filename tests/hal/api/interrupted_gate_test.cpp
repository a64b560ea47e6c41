// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What the gate remembers of having closed.
#include "hal/api/output_gate.hpp"
#include "verification/trace/ids/hal.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace counterpoint::hal
{
namespace
{

constexpr GateLimit kLimit{2000U};

/// Three right permits for slots 0 and 2; the high word of the mask is 0, so that the formula is one sum and one
/// product.
PermitSet RightPermits(const std::uint32_t challenge, const SrdoMask mask = 5U)
{
    const std::uint32_t sum = challenge + static_cast<std::uint32_t>(mask);
    return PermitSet{{mask, sum * 0x9E37'79B1U}, {mask, sum * 0x85EB'CA77U}, {mask, sum * 0xC2B2'AE3DU}};
}

class InterruptedGate : public ::testing::Test
{
  public:
    InterruptedGate()
    {
        gate.Drive(PermitSet{}, Instant{0U});
    }
    /// One cycle with right permits 1 ms later: what is open then.
    SrdoMask Cycle(const SrdoMask mask = 5U)
    {
        now_us += 1000U;
        gate.Drive(RightPermits(gate.Challenge(), mask), Instant{now_us});
        return Open();
    }
    SrdoMask Open()
    {
        return gate.Open(Instant{now_us}, kLimit);
    }
    /// Right permits open nothing, and the challenge is 0; until no permits at all come.
    void StaysClosedUntilArmed()
    {
        for (std::uint32_t cycle = 0U; cycle < 10U; ++cycle)
        {
            now_us += 1000U;
            const std::uint32_t challenge = gate.Challenge();
            EXPECT_EQ(challenge, 0U);
            gate.Drive(RightPermits(challenge), Instant{now_us});
            EXPECT_EQ(Open(), 0U);
        }
        gate.Drive(PermitSet{}, Instant{now_us});
        EXPECT_EQ(Open(), 0U);
        EXPECT_EQ(Cycle(), 5U);
    }

    OutputGate gate{};
    std::uint32_t now_us{0U};
};

TEST_F(InterruptedGate, IsOneWhoseOpenSlotsARefusalClosed)
{
    Verifies(req::SRS_HAL_300);
    Verifies(req::SRS_HAL_301);
    for (Permit PermitSet::* const party : {&PermitSet::a, &PermitSet::b, &PermitSet::kernel})
    {
        // Given open slots
        ASSERT_EQ(Cycle(), 5U);
        // When one party is wrong once
        PermitSet permits = RightPermits(gate.Challenge());
        (permits.*party).response ^= 0x100U;
        gate.Drive(permits, Instant{now_us});
        EXPECT_EQ(Open(), 0U);
        // Then it stays closed
        StaysClosedUntilArmed();
    }
}

TEST_F(InterruptedGate, IsOneThatWasDrivenTwice)
{
    Verifies(req::SRS_HAL_300);
    ASSERT_EQ(Cycle(), 5U);
    const PermitSet permits = RightPermits(gate.Challenge());
    gate.Drive(permits, Instant{now_us});
    EXPECT_EQ(Open(), 5U);
    gate.Drive(permits, Instant{now_us});
    EXPECT_EQ(Open(), 0U);
    StaysClosedUntilArmed();
}

// t ms   1      2            3
//        open   challenge    challenge
//               no Drive     0
TEST_F(InterruptedGate, IsOneWhoseDriveWasLost)
{
    Verifies(req::SRS_HAL_300);
    ASSERT_EQ(Cycle(), 5U);
    EXPECT_NE(gate.Challenge(), 0U);
    EXPECT_EQ(Open(), 5U);
    EXPECT_EQ(gate.Challenge(), 0U);
    EXPECT_EQ(Open(), 0U);
    StaysClosedUntilArmed();
}

// limit 2000 us: open on it, interrupted 1 us later
TEST_F(InterruptedGate, IsOneWhoseTimeIsOver)
{
    Verifies(req::SRS_HAL_300);
    ASSERT_EQ(Cycle(), 5U);
    now_us += 2000U;
    EXPECT_EQ(Open(), 5U);
    EXPECT_NE(gate.Challenge(), 0U);
    now_us += 1U;
    EXPECT_EQ(Open(), 0U);
    StaysClosedUntilArmed();
}

// t ms   1        2                4           5
//        slot 0   right, no slot   time over   right, slot 0
TEST_F(InterruptedGate, IsNoneThatHadClosedByRightPermits)
{
    Verifies(req::SRS_HAL_300);
    ASSERT_EQ(Cycle(), 5U);
    ASSERT_EQ(Cycle(0U), 0U);
    now_us += 2001U;
    EXPECT_EQ(Open(), 0U);
    EXPECT_NE(gate.Challenge(), 0U);
    EXPECT_NE(gate.Challenge(), 0U);
    gate.Drive(RightPermits(0U), Instant{now_us});
    EXPECT_EQ(Cycle(), 5U);
}

TEST_F(InterruptedGate, IsNoneThatRefusesBeforeItOpens)
{
    Verifies(req::SRS_HAL_300);
    // A peer that does not run yet gives nothing
    for (std::uint32_t cycle = 0U; cycle < 10U; ++cycle)
    {
        PermitSet permits = RightPermits(gate.Challenge());
        permits.b = Permit{0U, 0U};
        gate.Drive(permits, Instant{now_us});
        EXPECT_EQ(Open(), 0U);
    }
    EXPECT_EQ(Cycle(), 5U);
}

TEST_F(InterruptedGate, IsNoneThatItsPortClosed)
{
    Verifies(req::SRS_HAL_300);
    ASSERT_EQ(Cycle(), 5U);
    gate.Close();
    EXPECT_EQ(Open(), 0U);
    EXPECT_EQ(Cycle(), 5U);
    // nor does that arm one
    EXPECT_NE(gate.Challenge(), 0U);
    EXPECT_EQ(gate.Challenge(), 0U);
    gate.Close();
    StaysClosedUntilArmed();
}

TEST_F(InterruptedGate, IsNoneThatNoPermitsClosedOutsideOfACycle)
{
    Verifies(req::SRS_HAL_302);
    ASSERT_EQ(Cycle(), 5U);
    gate.Drive(PermitSet{}, Instant{now_us});
    EXPECT_EQ(Open(), 0U);
    EXPECT_EQ(Cycle(), 5U);
}

TEST_F(InterruptedGate, IsOneThatNoPermitsAnswered)
{
    Verifies(req::SRS_HAL_302);
    ASSERT_EQ(Cycle(), 5U);
    EXPECT_NE(gate.Challenge(), 0U);
    gate.Drive(PermitSet{}, Instant{now_us});
    EXPECT_EQ(gate.Challenge(), 0U);
    // An answer to the 0 that was told, of nobody, arms nothing either
    gate.Drive(PermitSet{}, Instant{now_us});
    StaysClosedUntilArmed();
}

TEST_F(InterruptedGate, IsNotArmedByAnythingThatOnePartyGave)
{
    Verifies(req::SRS_HAL_302);
    PermitSet one_of_each[6]{};
    one_of_each[0].a.mask = 0x8000'0000'0000'0000U;
    one_of_each[1].b.mask = 1U;
    one_of_each[2].kernel.mask = 0x1'0000'0000U;
    one_of_each[3].a.response = 1U;
    one_of_each[4].b.response = 0x8000'0000U;
    one_of_each[5].kernel.response = 0x100U;
    ASSERT_EQ(Cycle(), 5U);
    gate.Drive(RightPermits(0U), Instant{now_us});
    for (const PermitSet& permits : one_of_each)
    {
        gate.Drive(permits, Instant{now_us});
        EXPECT_EQ(gate.Challenge(), 0U);
        gate.Drive(permits, Instant{now_us}); // Uses the challenge up.
        EXPECT_EQ(Open(), 0U);
    }
    StaysClosedUntilArmed();
}

TEST_F(InterruptedGate, IsNotOpenedByWhoKnowsTheChallengeThatItDidNotTell)
{
    Verifies(req::SRS_HAL_301);
    ASSERT_EQ(Cycle(), 5U);
    gate.Drive(RightPermits(0U), Instant{now_us});
    EXPECT_EQ(gate.Challenge(), 0U);
    // The second step of 9E37 79B1h is 3C6E F362h; a challenge is odd
    gate.Drive(RightPermits(0x3C6E'F363U), Instant{now_us});
    EXPECT_EQ(Open(), 0U);
    StaysClosedUntilArmed();
}

TEST_F(InterruptedGate, IsANewOneAndOneOfZeros)
{
    Verifies(req::SRS_HAL_303);
    gate = OutputGate{};
    StaysClosedUntilArmed();
    std::memset(static_cast<void*>(&gate), 0, sizeof(gate));
    StaysClosedUntilArmed();
}

OutputGate WithFlippedBit(const OutputGate& gate, const std::size_t bit)
{
    unsigned char bytes[sizeof(OutputGate)];
    std::memcpy(bytes, &gate, sizeof(gate));
    bytes[bit / 8U] = static_cast<unsigned char>(bytes[bit / 8U] ^ (1U << (bit % 8U)));
    OutputGate flipped;
    std::memcpy(&flipped, bytes, sizeof(flipped));
    return flipped;
}

// Each bit, flipped while slots are open, and while the gate is interrupted.
TEST_F(InterruptedGate, NoBitThatClosesIsForgottenAndNoneArms)
{
    Verifies(req::SRS_HAL_300);
    Verifies(req::SRS_HAL_303);
    ASSERT_EQ(Cycle(), 5U);
    const OutputGate open = gate;
    ASSERT_EQ(open.Probe(PermitSet{}, 0U), ProbeAnswer::kRefused);
    gate.Drive(RightPermits(0U), Instant{now_us});
    const OutputGate interrupted = gate;
    std::uint32_t closed = 0U;
    for (std::size_t bit = 0U; bit < (sizeof(OutputGate) * 8U); ++bit)
    {
        now_us = 1000U;
        gate = WithFlippedBit(open, bit);
        now_us += 900U;
        const bool was_closed = Open() != 5U;
        now_us += 100U;
        const std::uint32_t challenge = gate.Challenge();
        gate.Drive(RightPermits(challenge), Instant{now_us});
        // What it closed stays closed, and what it did not stays open
        EXPECT_EQ(Open(), (was_closed || (challenge == 0U)) ? 0U : 5U) << "bit " << bit;
        EXPECT_EQ(challenge == 0U, Open() == 0U) << "bit " << bit;
        closed += was_closed ? 1U : 0U;
        gate = WithFlippedBit(interrupted, bit);
        StaysClosedUntilArmed();
    }
    // 64 bits of each copy of the slots; bits of each copy of the moment by which the elapsed time is above 2 ms
    EXPECT_GT(closed, 128U);
}

TEST_F(InterruptedGate, WordThatComesBackDoesNotArm)
{
    Verifies(req::SRS_HAL_303);
    ASSERT_EQ(Cycle(), 5U);
    const OutputGate open = gate;
    std::uint32_t interrupting = 0U;
    for (std::size_t bit = 0U; bit < (sizeof(OutputGate) * 8U); ++bit)
    {
        gate = WithFlippedBit(open, bit);
        now_us = 2000U;
        if (gate.Challenge() == 0U)
        {
            // The bit is as it was once the gate has looked
            gate = WithFlippedBit(gate, bit);
            EXPECT_EQ(gate.Challenge(), 0U) << "bit " << bit;
            ++interrupting;
        }
    }
    // The 32 bits of each copy of what it is armed by, at the least
    EXPECT_GE(interrupting, 64U);
}

// A pattern whose two copies are complements of each other as well, but is not the one.
TEST_F(InterruptedGate, IsOneWhoseBothCopiesHaveTheSameBitWrong)
{
    Verifies(req::SRS_HAL_303);
    // Given an armed gate that is closed, and the bits by which alone it is interrupted: those of its two copies
    ASSERT_EQ(Cycle(0U), 0U);
    const OutputGate armed = gate;
    std::vector<std::size_t> bits;
    for (std::size_t bit = 0U; bit < (sizeof(OutputGate) * 8U); ++bit)
    {
        gate = WithFlippedBit(armed, bit);
        if (gate.Challenge() == 0U)
        {
            bits.push_back(bit);
        }
    }
    ASSERT_EQ(bits.size(), 64U);
    // When any two of them are wrong, then it is interrupted
    std::uint32_t interrupted = 0U;
    for (std::size_t first = 0U; first < bits.size(); ++first)
    {
        for (std::size_t second = first + 1U; second < bits.size(); ++second)
        {
            gate = WithFlippedBit(WithFlippedBit(armed, bits[first]), bits[second]);
            interrupted += (gate.Challenge() == 0U) ? 1U : 0U;
        }
    }
    EXPECT_EQ(interrupted, 2016U); // 64 * 63 / 2
}

} // namespace
} // namespace counterpoint::hal
