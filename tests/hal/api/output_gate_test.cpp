// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/api/output_gate.hpp"
#include "verification/trace/ids/hal.hpp"
#include "verification/trace/ids/selftest.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace counterpoint::hal
{
namespace
{

constexpr GateLimit kLimit{2000U};
constexpr SrdoMask kSlots = 0x8000'0000'0000'0005U; // slots 0, 2 and 63

/// The formula of contract/channel.hpp, written down once more.
constexpr std::uint32_t Response(const std::uint32_t challenge, const SrdoMask mask, const std::uint32_t constant)
{
    const std::uint32_t low = static_cast<std::uint32_t>(mask % 0x1'0000'0000U);
    const std::uint32_t high = static_cast<std::uint32_t>(mask / 0x1'0000'0000U);
    const std::uint32_t swapped = (high * 0x10000U) + (high / 0x10000U);
    return ((challenge + low) ^ swapped) * constant;
}
// (1 + 3) XOR 0002 0000h = 0002 0004h, times 9E37 79B1h
static_assert(Response(1U, 0x0000'0002'0000'0003U, 0x9E37'79B1U) == 0x6C3F'E6C4U, "worked out by hand");

PermitSet RightPermits(const std::uint32_t challenge, const SrdoMask mask)
{
    return PermitSet{Permit{mask, Response(challenge, mask, 0x9E37'79B1U)},
                     Permit{mask, Response(challenge, mask, 0x85EB'CA77U)},
                     Permit{mask, Response(challenge, mask, 0xC2B2'AE3DU)}};
}

/// A gate as the start of a kernel leaves it.
OutputGate ArmedGate()
{
    OutputGate gate;
    gate.Drive(PermitSet{}, Instant{0U});
    return gate;
}

/// A gate with kSlots open since t = 1000 us.
OutputGate OpenGate()
{
    OutputGate gate = ArmedGate();
    gate.Drive(RightPermits(gate.Challenge(), kSlots), Instant{1000U});
    return gate;
}

TEST(OutputGate, ThreeRightPermitsOpenTheirSlots)
{
    Verifies(req::SRS_HAL_003);
    // Given a challenge
    OutputGate gate = ArmedGate();
    const std::uint32_t challenge = gate.Challenge();
    // When all three answer it
    gate.Drive(RightPermits(challenge, kSlots), Instant{1000U});
    // Then exactly these slots are open
    EXPECT_EQ(gate.Open(Instant{1000U}, kLimit), 0x8000'0000'0000'0005U);
}

TEST(OutputGate, OnlySlotsOfAllThreeMasksOpen)
{
    Verifies(req::SRS_HAL_003);
    // Given right permits for different slots: A 0 1 2 3, B 0 1 4, kernel 0 2 4
    OutputGate gate = ArmedGate();
    const std::uint32_t challenge = gate.Challenge();
    PermitSet permits{};
    permits.a = RightPermits(challenge, 0x0FU).a;
    permits.b = RightPermits(challenge, 0x13U).b;
    permits.kernel = RightPermits(challenge, 0x15U).kernel;
    // When they are driven
    gate.Drive(permits, Instant{1000U});
    // Then only slot 0 is open
    EXPECT_EQ(gate.Open(Instant{1000U}, kLimit), 0x01U);
}

enum class Party
{
    kA,
    kB,
    kKernel,
};

class OutputGateParty : public ::testing::TestWithParam<Party>
{
  protected:
    static Permit& Of(PermitSet& permits)
    {
        return (GetParam() == Party::kA) ? permits.a : ((GetParam() == Party::kB) ? permits.b : permits.kernel);
    }
};

TEST_P(OutputGateParty, MissingPermitClosesAll)
{
    Verifies(req::SRS_HAL_003);
    // Given an open gate, and two right permits for the next challenge
    OutputGate gate = OpenGate();
    PermitSet permits = RightPermits(gate.Challenge(), kSlots);
    // When the third is missing
    Of(permits) = Permit{0U, 0U};
    gate.Drive(permits, Instant{1500U});
    // Then all is closed
    EXPECT_EQ(gate.Open(Instant{1500U}, kLimit), 0U);
}

TEST_P(OutputGateParty, OldPermitClosesAll)
{
    Verifies(req::SRS_HAL_003);
    // Given an open gate
    OutputGate gate = ArmedGate();
    const PermitSet old = RightPermits(gate.Challenge(), kSlots);
    gate.Drive(old, Instant{1000U});
    ASSERT_EQ(gate.Open(Instant{1000U}, kLimit), kSlots);
    // When one party answers the next challenge as it did the one before
    PermitSet permits = RightPermits(gate.Challenge(), kSlots);
    PermitSet old_copy = old;
    Of(permits) = Of(old_copy);
    gate.Drive(permits, Instant{1500U});
    // Then all is closed
    EXPECT_EQ(gate.Open(Instant{1500U}, kLimit), 0U);
}

TEST_P(OutputGateParty, WrongPermitClosesAll)
{
    Verifies(req::SRS_HAL_003);
    // Given an open gate and right permits
    OutputGate gate = OpenGate();
    PermitSet permits = RightPermits(gate.Challenge(), kSlots);
    // When one bit of one response is wrong
    Of(permits).response ^= 0x0000'0100U;
    gate.Drive(permits, Instant{1500U});
    // Then all is closed
    EXPECT_EQ(gate.Open(Instant{1500U}, kLimit), 0U);
}

TEST_P(OutputGateParty, MaskChangedBehindTheAnswerClosesAll)
{
    Verifies(req::SRS_HAL_003);
    // Given an open gate and right permits
    OutputGate gate = OpenGate();
    PermitSet permits = RightPermits(gate.Challenge(), kSlots);
    // When a slot is added to one mask without a new response
    Of(permits).mask |= 0x0000'0001'0000'0000U;
    gate.Drive(permits, Instant{1500U});
    // Then all is closed
    EXPECT_EQ(gate.Open(Instant{1500U}, kLimit), 0U);
}

INSTANTIATE_TEST_SUITE_P(EachOfThree, OutputGateParty, ::testing::Values(Party::kA, Party::kB, Party::kKernel));

TEST(OutputGate, PermitsOfExchangedPartiesCloseAll)
{
    Verifies(req::SRS_HAL_003);
    // Given an open gate and right permits
    OutputGate gate = OpenGate();
    const PermitSet right = RightPermits(gate.Challenge(), kSlots);
    // When A and B are exchanged
    gate.Drive(PermitSet{right.b, right.a, right.kernel}, Instant{1500U});
    // Then all is closed
    EXPECT_EQ(gate.Open(Instant{1500U}, kLimit), 0U);
}

TEST(OutputGate, ChallengeIsGoodForOneDrive)
{
    Verifies(req::SRS_HAL_003);
    // Given an open gate
    OutputGate gate = ArmedGate();
    const PermitSet permits = RightPermits(gate.Challenge(), kSlots);
    gate.Drive(permits, Instant{1000U});
    ASSERT_EQ(gate.Open(Instant{1000U}, kLimit), kSlots);
    // When the same permits come again without a new challenge
    gate.Drive(permits, Instant{1001U});
    // Then all is closed
    EXPECT_EQ(gate.Open(Instant{1001U}, kLimit), 0U);
}

TEST(OutputGate, PermitsForTheEmptyChallengeOpenNothing)
{
    Verifies(req::SRS_HAL_003);
    // Given a gate that issued no challenge
    OutputGate gate = ArmedGate();
    // When somebody answers challenge 0
    gate.Drive(RightPermits(0U, kSlots), Instant{1000U});
    // Then nothing opens
    EXPECT_EQ(gate.Open(Instant{1000U}, kLimit), 0U);
}

TEST(OutputGate, NewChallengeVoidsTheOneBefore)
{
    Verifies(req::SRS_HAL_003);
    // Given two challenges, one after the other
    OutputGate gate = ArmedGate();
    const std::uint32_t first = gate.Challenge();
    static_cast<void>(gate.Challenge());
    // When the first is answered, then nothing opens
    gate.Drive(RightPermits(first, kSlots), Instant{1000U});
    EXPECT_EQ(gate.Open(Instant{1000U}, kLimit), 0U);
}

TEST(OutputGate, ResponseZeroNeverFits)
{
    Verifies(req::SRS_HAL_003);
    // Given a mask for which the formula gives 0: low word = 2^32 - challenge, high word 0
    OutputGate gate = ArmedGate();
    const std::uint32_t challenge = gate.Challenge();
    const SrdoMask mask = static_cast<SrdoMask>(0U - challenge);
    const PermitSet permits = RightPermits(challenge, mask);
    ASSERT_EQ(permits.a.response, 0U);
    // When it is driven, then nothing opens
    gate.Drive(permits, Instant{1000U});
    EXPECT_EQ(gate.Open(Instant{1000U}, kLimit), 0U);
}

TEST(OutputGate, ChallengeIsNeverZeroAndNeverTheOneBefore)
{
    Verifies(req::SRS_HAL_003);
    OutputGate gate = ArmedGate();
    std::uint32_t before = 0U;
    for (int count = 0; count < 100'000; ++count)
    {
        // When the next challenge is issued
        const std::uint32_t challenge = gate.Challenge();
        // Then it is neither 0 nor the one before
        ASSERT_NE(challenge, 0U);
        ASSERT_NE(challenge, before);
        before = challenge;
    }
}

// t [us]  1000       3000  3001      limit 2000 us
// gate    open       open  closed
TEST(OutputGate, ClosesOneMicrosecondAfterTheLimit)
{
    Verifies(req::SRS_HAL_004);
    // Given a gate driven at 1000
    // When it is looked at just inside, on and outside the limit, then it is open, open and closed
    OutputGate inside = OpenGate();
    EXPECT_EQ(inside.Open(Instant{2999U}, kLimit), kSlots);
    OutputGate on = OpenGate();
    EXPECT_EQ(on.Open(Instant{3000U}, kLimit), kSlots);
    OutputGate outside = OpenGate();
    EXPECT_EQ(outside.Open(Instant{3001U}, kLimit), 0U);
    // and stays closed though the elapsed time looks short again
    EXPECT_EQ(outside.Open(Instant{1500U}, kLimit), 0U);
    // It is interrupted: there is no challenge, and right permits open nothing; the other two go on
    EXPECT_EQ(outside.Challenge(), 0U);
    outside.Drive(RightPermits(0x1235U, kSlots), Instant{3100U});
    EXPECT_EQ(outside.Open(Instant{3101U}, kLimit), 0U);
    for (OutputGate* const gate : {&inside, &on})
    {
        gate->Drive(RightPermits(gate->Challenge(), kSlots), Instant{3100U});
        EXPECT_EQ(gate->Open(Instant{3101U}, kLimit), kSlots);
    }
}

TEST(OutputGate, LimitHoldsAcrossTheWrapOfTime)
{
    Verifies(req::SRS_HAL_004);
    // Given a gate driven 1 us before the counter wraps
    OutputGate gate = ArmedGate();
    gate.Drive(RightPermits(gate.Challenge(), kSlots), Instant{0xFFFF'FFFFU});
    // When it is looked at on and outside the limit, then it is open and closed
    EXPECT_EQ(gate.Open(Instant{1999U}, kLimit), kSlots);
    EXPECT_EQ(gate.Open(Instant{2000U}, kLimit), 0U);
}

TEST(OutputGate, StaysClosedAfterTheLimitHoweverLong)
{
    Verifies(req::SRS_HAL_007);
    // Given a gate seen closed after its limit
    OutputGate gate = OpenGate();
    ASSERT_EQ(gate.Open(Instant{3001U}, kLimit), 0U);
    // When its time comes back to the moment of the Drive
    // Then it is still closed
    EXPECT_EQ(gate.Open(Instant{1000U}, kLimit), 0U);
    // and only a gate that was armed opens again
    gate.Drive(PermitSet{}, Instant{1200U});
    gate.Drive(RightPermits(gate.Challenge(), 0x02U), Instant{1200U});
    EXPECT_EQ(gate.Open(Instant{1200U}, kLimit), 0x02U);
}

TEST(OutputGate, CloseClosesAll)
{
    Verifies(req::SRS_HAL_003);
    // Given an open gate, when it is closed, then nothing is open
    OutputGate gate = OpenGate();
    gate.Close();
    EXPECT_EQ(gate.Open(Instant{1000U}, kLimit), 0U);
}

TEST(OutputGate, ZeroFilledMemoryOpensNothing)
{
    Verifies(req::SRS_HAL_008);
    // Given a gate whose memory is all zeros, when it is looked at, then nothing is open
    OutputGate gate;
    static_assert(std::is_trivially_copyable<OutputGate>::value, "memory of a gate is its bytes");
    unsigned char zeros[sizeof(OutputGate)] = {};
    std::memcpy(&gate, zeros, sizeof(gate));
    EXPECT_EQ(gate.Open(Instant{0U}, kLimit), 0U);
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

TEST(OutputGate, NoFlippedBitOpensASlotOrMakesItStayOpenLonger)
{
    Verifies(req::SRS_HAL_008);
    const OutputGate open = OpenGate();
    OutputGate closed = OpenGate();
    closed.Close();
    for (std::size_t bit = 0U; bit < (sizeof(OutputGate) * 8U); ++bit)
    {
        // Given a closed gate with one bit flipped, then nothing is open
        OutputGate flipped_closed = WithFlippedBit(closed, bit);
        ASSERT_EQ(flipped_closed.Open(Instant{1000U}, kLimit), 0U) << "bit " << bit;
        // Given an open gate with one bit flipped, then no other slot is open
        OutputGate flipped_open = WithFlippedBit(open, bit);
        ASSERT_EQ(flipped_open.Open(Instant{1000U}, kLimit) & ~kSlots, 0U) << "bit " << bit;
        // and nothing is open after the limit
        OutputGate flipped_late = WithFlippedBit(open, bit);
        ASSERT_EQ(flipped_late.Open(Instant{3001U}, kLimit), 0U) << "bit " << bit;
    }
}

TEST(OutputGate, ProbeJudgesAsDriveDoesAndChangesNothing)
{
    Verifies(req::SRS_STS_031);
    Verifies(req::SRS_STS_030);
    // Given an open gate with an outstanding challenge
    OutputGate gate = OpenGate();
    const std::uint32_t outstanding = gate.Challenge();
    // When it is shown right permits to an even challenge, then it would accept them
    constexpr std::uint32_t kProbe = 0x1234'5678U;
    const PermitSet right = RightPermits(kProbe, kSlots);
    EXPECT_EQ(OutputGate::Probe(right, kProbe), ProbeAnswer::kAccepted);
    // and refuses a wrong, an old and a missing one of each party, and challenge 0
    for (Permit PermitSet::* const party : {&PermitSet::a, &PermitSet::b, &PermitSet::kernel})
    {
        PermitSet wrong = right;
        (wrong.*party).response ^= 1U;
        EXPECT_EQ(OutputGate::Probe(wrong, kProbe), ProbeAnswer::kRefused);
        PermitSet old = right;
        old.*party = RightPermits(kProbe - 2U, kSlots).*party;
        EXPECT_EQ(OutputGate::Probe(old, kProbe), ProbeAnswer::kRefused);
        PermitSet missing = right;
        missing.*party = Permit{0U, 0U};
        EXPECT_EQ(OutputGate::Probe(missing, kProbe), ProbeAnswer::kRefused);
    }
    EXPECT_EQ(OutputGate::Probe(RightPermits(0U, kSlots), 0U), ProbeAnswer::kRefused);
    // Then the gate is still open, and its challenge is still the one to answer
    EXPECT_EQ(gate.Open(Instant{1500U}, kLimit), kSlots);
    gate.Drive(RightPermits(outstanding, kSlots), Instant{2500U});
    EXPECT_EQ(gate.Open(Instant{4000U}, kLimit), kSlots);
}

TEST(OutputGate, NeverIssuesAnEvenChallenge)
{
    Verifies(req::SRS_STS_030);
    OutputGate gate = ArmedGate();
    for (std::uint32_t cycle = 0U; cycle < 100000U; ++cycle)
    {
        ASSERT_EQ(gate.Challenge() % 2U, 1U) << cycle;
    }
}

} // namespace
} // namespace counterpoint::hal
