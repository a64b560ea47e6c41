// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/comparator/comparator_self_test.hpp"

namespace counterpoint
{
namespace
{

// What is turned round one by one: a bit of a member, of the masks that of a slot; another one in each round.
// number   0 to 3   4              5, 6             7, 8                9 to 12   13             14
//          counts   guard's view   cycle of B, A    words of the data   masks     pair is held   ordinal, and the sum
//          a fault follows from each of these                           the slot is not matched, or demoted
constexpr std::uint32_t kMembers = 4U;
// MISRA D-001
constexpr std::uint8_t CycleOutcome::* kCount[kMembers] = {&CycleOutcome::sct_checked, &CycleOutcome::is_tx,
                                                           &CycleOutcome::is_invalid, &CycleOutcome::not_operational};
// MISRA D-001
constexpr SrdoMask CycleOutcome::* kMask[kMembers] = {&CycleOutcome::faulted, &CycleOutcome::new_fault,
                                                      &CycleOutcome::released, &CycleOutcome::due};
constexpr std::uint32_t kGuardTest = 4U;
constexpr std::uint32_t kCycleTest = 5U;
constexpr std::uint32_t kOtherCycleTest = 6U;
constexpr std::uint32_t kLowTest = 7U;
constexpr std::uint32_t kHighTest = 8U;
constexpr std::uint32_t kFirstMaskTest = 9U;
constexpr std::uint32_t kHoldsTest = 13U;
static_assert(kComparatorTests == (kHoldsTest + 2U), "the ordinal is the last one");
constexpr std::uint32_t kBytesAWord = 4U;
constexpr std::uint32_t kBitsAByte = 8U;

// What is turned round in this round. Words: a bit of byte 0, 1, 2, 3, then the next bit of each; bytes and slots: one
// after the other.
struct TurnedBits
{
    std::uint32_t of_word;
    std::uint8_t of_byte;
    SrdoMask slot;
};

TurnedBits BitsOf(const std::uint32_t round, const SrdoMask slot) noexcept
{
    const std::uint32_t bit = (round / kBytesAWord) % kBitsAByte;
    return TurnedBits{std::uint32_t{1U} << (((round % kBytesAWord) * kBitsAByte) + bit),
                      static_cast<std::uint8_t>(std::uint32_t{1U} << (round % kBitsAByte)), slot};
}

// Both say what channel A says, but for one member: whatever the channels say, nothing else differs.
struct Voices
{
    CycleOutcome a;
    CycleOutcome b;
    HeldPair turned;
};

void TurnPair(Voices& voices, const std::uint32_t number, const TurnedBits& bits) noexcept
{
    if (number == kLowTest)
    {
        voices.turned.data.low = bits.of_word;
    }
    else if (number == kHighTest)
    {
        voices.turned.data.high = bits.of_word;
    }
    else
    {
        voices.turned.holds_pair = bits.of_word;
    }
    voices.b.fresh = bits.slot; // A new pair alone is looked at.
}

void Turn(Voices& voices, const std::uint32_t number, const TurnedBits& bits) noexcept
{
    if (number < kMembers)
    {
        voices.b.*kCount[number] ^= bits.of_byte; // MISRA D-002
    }
    else if (number == kGuardTest)
    {
        voices.b.guard = static_cast<GuardView>(static_cast<std::uint32_t>(voices.b.guard) ^ bits.of_byte);
    }
    else if (number == kCycleTest)
    {
        voices.b.cycle ^= bits.of_word;
    }
    else if (number == kOtherCycleTest)
    {
        voices.a.cycle ^= bits.of_word;
    }
    else if ((number - kFirstMaskTest) < kMembers) // 0 - 1 is the greatest value.
    {
        voices.b.*kMask[number - kFirstMaskTest] ^= bits.slot; // MISRA D-002
    }
    else if (number <= kHoldsTest)
    {
        TurnPair(voices, number, bits);
    }
    else
    {
        voices.turned.ordinal = bits.of_word;
        voices.b.ordinal_sum ^= bits.of_word;
    }
}

// A frame that differs from an empty one: in a byte of the data, status, identifier, kind, controller, length.
PreparedPair TurnedFrame(const std::uint32_t number, const TurnedBits& bits) noexcept
{
    PreparedPair pair{};
    if (number < kMaxPayloadBytes)
    {
        pair.normal.data[number] = bits.of_byte; // MISRA D-002
    }
    else if (number == kMaxPayloadBytes)
    {
        pair.status = static_cast<PrepareStatus>(bits.of_byte);
    }
    else if (number == (kMaxPayloadBytes + 1U))
    {
        pair.normal.identifier = bits.of_word;
    }
    else if (number == (kMaxPayloadBytes + 2U))
    {
        pair.normal.kind = static_cast<FrameKind>(bits.of_byte);
    }
    else if (number == (kMaxPayloadBytes + 3U))
    {
        pair.normal.port = static_cast<CanPortId>(bits.of_byte);
    }
    else
    {
        pair.normal.length_bytes = bits.of_byte;
    }
    return pair;
}

} // namespace

bool ComparatorSelfTest::TakeTurn(const Instant now) noexcept
{
    if (!is_timed_)
    {
        is_timed_ = true;
        begun_ = now;
    }
    if ((number_ >= kComparatorTests) && ((now.us - begun_.us) >= wait_us_))
    {
        begun_ = now;
        number_ = 0U;
        ++round_;
        ++slot_;
        slot_ = (slot_ < slots_) ? slot_ : SlotIndex{0U};
    }
    return number_ < kComparatorTests;
}

DeviceFault ComparatorSelfTest::Run(const Comparator& comparator, const Comparison& comparison) noexcept
{
    const std::uint32_t number = number_;
    ++number_;
    Voices voices{*comparison.outcome_a, *comparison.outcome_a, HeldPair{}};
    voices.a.fresh = 0U; // News of its own would have the comparator look for another reason.
    voices.b.fresh = 0U;
    const TurnedBits bits = BitsOf(round_, SrdoMask{1U} << slot_);
    Turn(voices, number, bits);
    const Verdict verdict =
        comparator.Try(Comparison{&voices.a, &voices.b, comparison.channel_a, comparison.channel_a, comparison.now,
                                  comparison.cycle, comparison.challenge, voices.turned});
    const SrdoMask alike = verdict.agreement.matched & ~verdict.demote & bits.slot;
    const bool are_unequal = (number < kFirstMaskTest) ? (verdict.fault != DeviceFault::kNone) : (alike == 0U);
    const PreparedVerdict expected =
        (number < kMaxPayloadBytes) ? PreparedVerdict::kNotInverse : PreparedVerdict::kDisagreement;
    const bool is_seen =
        are_unequal && (Comparator::ComparePrepared(PreparedPair{}, TurnedFrame(number, bits)) == expected);
    return is_seen ? DeviceFault::kNone : DeviceFault::kComparator;
}

} // namespace counterpoint
