// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/channel.hpp"
#include "channel_b/image.hpp"

#include <cstdint>

/// One look at the states of all slots, eight bytes at a time where all eight are alike. A value counts only if it is
/// exactly the one defined, so that a corrupted state is in no mask but that of the corrupted ones.
namespace counterpoint::channel_b
{

namespace
{

constexpr std::uint8_t kSlotsInWord = 8U;
constexpr HalfMask kAllOfWord = 0xFFU;
constexpr std::uint64_t kEight = 0x0101010101010101U;
constexpr std::uint64_t kEightReleased = kEight * Code(SrdoState::kReleased);
constexpr std::uint64_t kEightSending = kEight * Code(SrdoState::kProducer);
constexpr std::uint64_t kEightConsumers = kEight * kDirectionConsumer;
constexpr std::uint64_t kEightProducers = kEight * kDirectionProducer;
constexpr std::uint64_t kEightWithoutCause = kEight * Code(SrdoCause::kNone);

/// Direction and state in one number.
[[nodiscard]] constexpr std::uint32_t KindOf(std::uint8_t direction, std::uint8_t state) noexcept
{
    return (static_cast<std::uint32_t>(direction) << 8U) | static_cast<std::uint32_t>(state);
}

} // namespace

/// Puts one slot where it belongs; slots that are off belong nowhere. What is corrupted is taken from the others by
/// Repair.
void Channel::Enlist(SlotIndex slot, Census& census) const noexcept
{
    const HalfMask bit = BitOf(slot);
    const std::uint8_t state = x_storage.state[slot];
    switch (KindOf(x_storage.direction[slot], state))
    {
    case KindOf(kDirectionConsumer, Code(SrdoState::kReleased)):
        census.released |= bit;
        census.corrupted |= IsRecordable(x_storage.first_cause[slot]) ? 0U : bit;
        break;
    case KindOf(kDirectionProducer, Code(SrdoState::kProducer)):
        census.producers |= bit;
        break;
    case KindOf(kDirectionConsumer, Code(SrdoState::kWaiting)):
        census.waiting |= bit;
        break;
    case KindOf(kDirectionConsumer, Code(SrdoState::kFaulted)):
        census.faulted |= bit;
        break;
    default:
        census.corrupted |= (state == Code(SrdoState::kOff)) ? 0U : bit;
        break;
    }
}

/// A slot whose state fits none of its other marks ends in kFaulted, or in kOff if it is no consumer. It stays there
/// until Restart: with kInvalid as its first cause nothing is released. [SRS-CONS-024]
void Channel::Repair(SlotIndex slot, Census& census) noexcept
{
    const HalfMask bit = BitOf(slot);
    census.waiting &= ~bit;
    census.released &= ~bit;
    census.producers &= ~bit;
    census.faulted &= ~bit;
    Fault(slot, SrdoCause::kInvalid);
    Withdraw(MarksOf(x_storage, slot).automatic, bit);
    x_storage.first_cause[slot] = Code(SrdoCause::kInvalid);
    x_storage.rows[slot].stage = Stage::kOff;
    if (x_storage.direction[slot] == kDirectionConsumer)
    {
        census.faulted |= bit;
    }
    else
    {
        x_storage.state[slot] = Code(SrdoState::kOff);
    }
}

/// All masks stay empty while SRDOs are not active. The bytes of slots that do not exist count for nothing.
void Channel::TakeCensus(Census& census) noexcept
{
    const Marks& marks = *census.marks;
    const HalfMask active = census.active;
    const Column<const std::uint8_t> state{&x_storage.state[census.first]};
    const Column<const std::uint8_t> direction{&x_storage.direction[census.first]};
    const Column<const std::uint8_t> cause{&x_storage.first_cause[census.first]};
    HalfMask released = 0U;
    HalfMask producers = 0U;
    HalfMask others = 0U;
    std::size_t at = 0U;
    for (HalfMask word = kAllOfWord; (word & active) != 0U; word <<= kSlotsInWord)
    {
        const std::uint64_t states = PackBytes(&state[at]);
        const std::uint64_t directions = PackBytes(&direction[at]);
        const std::uint64_t not_released = (states ^ kEightReleased) | (directions ^ kEightConsumers);
        const std::uint64_t not_sending = (states ^ kEightSending) | (directions ^ kEightProducers);
        if ((not_released | (PackBytes(&cause[at]) ^ kEightWithoutCause)) == 0U)
        {
            released |= word;
        }
        else if (not_sending == 0U)
        {
            producers |= word;
        }
        else
        {
            others |= word;
        }
        at += kSlotsInWord;
    }
    census.released = released & active;
    census.producers = producers & active;
    for (HalfMask rest = others & active; rest != 0U; rest = WithoutLowest(rest))
    {
        Enlist(LowestOf(rest, census.first), census);
    }
    const HalfMask consumers = census.waiting | census.faulted | census.released;
    const HalfMask twins = (marks.held.on ^ marks.held.off) & (marks.acknowledged.on ^ marks.acknowledged.off) &
                           (marks.automatic.on ^ marks.automatic.off);
    const HalfMask wrong = census.corrupted | (consumers & ~twins) | (census.released & ~marks.held.on);
    for (HalfMask rest = wrong; rest != 0U; rest = WithoutLowest(rest))
    {
        Repair(LowestOf(rest, census.first), census);
    }
}

} // namespace counterpoint::channel_b
