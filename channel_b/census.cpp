// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/channel.hpp"
#include "channel_b/image.hpp"

#include <cstddef>
#include <cstdint>

/// One look at the states of all slots, eight bytes at a time. A value counts only if it is exactly the one defined, so
/// that a corrupted state is in no mask.
namespace counterpoint::channel_b
{

namespace
{

constexpr std::uint64_t kLowBits = 0x0101010101010101U;
constexpr std::uint64_t kHighBits = 0x8080808080808080U;
constexpr std::uint64_t kBelowHighBits = 0x7F7F7F7F7F7F7F7FU;
constexpr std::uint64_t kLastCause = static_cast<std::uint64_t>(SrdoCause::kWrongEcho);

constexpr std::uint64_t kAllReleased = kLowBits * static_cast<std::uint64_t>(SrdoState::kReleased);
constexpr std::uint64_t kAllConsumers = kLowBits * kDirectionConsumer;
constexpr std::uint64_t kNoCauses = kLowBits * static_cast<std::uint64_t>(SrdoCause::kNone);
constexpr SrdoMask kEight = 0xFFU;

/// High bit of each byte that is not 0.
[[nodiscard]] inline std::uint64_t NonZero(std::uint64_t word) noexcept
{
    return (((word & kBelowHighBits) + kBelowHighBits) | word) & kHighBits;
}

/// High bit of each byte that is not `value`.
[[nodiscard]] inline std::uint64_t Unlike(std::uint64_t word, std::uint8_t value) noexcept
{
    return NonZero(word ^ (kLowBits * value));
}

/// High bit of each byte that is above `limit`, which is below 80h.
[[nodiscard]] inline std::uint64_t Above(std::uint64_t word, std::uint64_t limit) noexcept
{
    return (((word & kBelowHighBits) + (kLowBits * (0x7FU - limit))) | word) & kHighBits;
}

/// High bit of each byte that is no cause which can be recorded: those are 1 to kWrongEcho and kNone.
[[nodiscard]] inline std::uint64_t Undefined(std::uint64_t causes) noexcept
{
    return (~NonZero(causes) | Above(causes, kLastCause)) & Unlike(causes, static_cast<std::uint8_t>(SrdoCause::kNone));
}

/// The high bits, of which no other may be set, side by side: the product brings the one of byte n to bit 56 + n.
[[nodiscard]] inline SrdoMask Gather(std::uint64_t high_bits, std::size_t first_slot) noexcept
{
    return (((high_bits >> 7U) * 0x0102040810204080U) >> 56U) << first_slot;
}

[[nodiscard]] inline std::uint8_t Code(SrdoState state) noexcept
{
    return static_cast<std::uint8_t>(state);
}

/// Eight bytes of a column of single bytes, whatever enumeration they hold.
template <typename T> [[nodiscard]] inline std::uint64_t EightOf(const Column<T>& column, std::size_t first) noexcept
{
    static_assert(sizeof(T) == 1U, "single bytes");
    std::uint64_t word = 0U;
    for (std::size_t index = 0U; index < kSlotsInWord; ++index)
    {
        word |= static_cast<std::uint64_t>(column[first + index]) << (8U * index);
    }
    return word;
}

} // namespace

Channel::Census Channel::TakeCensus() const noexcept
{
    Census census{0U, 0U, 0U, 0U, 0U};
    const std::size_t count = x_count;
    for (std::size_t first = 0U; first < count; first += kSlotsInWord)
    {
        const std::uint64_t state = EightOf(x_storage.state, first);
        const std::uint64_t direction = EightOf(x_storage.direction, first);
        const std::uint64_t cause = EightOf(x_storage.first_cause, first);
        if ((state == kAllReleased) && (direction == kAllConsumers) && (cause == kNoCauses))
        {
            census.released |= kEight << first; // The common case at little cost.
            continue;
        }
        const std::uint64_t no_consumer = Unlike(direction, kDirectionConsumer);
        const std::uint64_t no_producer = Unlike(direction, kDirectionProducer);
        const std::uint64_t off = Unlike(state, Code(SrdoState::kOff));
        const std::uint64_t waiting = Unlike(state, Code(SrdoState::kWaiting)) | no_consumer;
        const std::uint64_t faulted = Unlike(state, Code(SrdoState::kFaulted)) | no_consumer;
        const std::uint64_t released = Unlike(state, Code(SrdoState::kReleased)) | no_consumer | Undefined(cause);
        const std::uint64_t producer = Unlike(state, Code(SrdoState::kProducer)) | no_producer;
        census.waiting |= Gather(waiting ^ kHighBits, first);
        census.faulted |= Gather(faulted ^ kHighBits, first);
        census.released |= Gather(released ^ kHighBits, first);
        census.producers |= Gather(producer ^ kHighBits, first);
        census.corrupted |= Gather(off & waiting & faulted & released & producer, first);
    }
    census.waiting &= x_active;
    census.faulted &= x_active;
    census.released &= x_active;
    census.producers &= x_active;
    census.corrupted &= x_active;
    return census;
}

/// A slot whose state fits none of its other marks ends in kFaulted, or in kOff if it is no consumer. It stays there
/// until Restart: with kInvalid as its first cause nothing is released. [SRS-CONS-024]
void Channel::Repair(SlotIndex slot, Census& census) noexcept
{
    const SrdoMask bit = BitOf(slot);
    census.waiting &= ~bit;
    census.released &= ~bit;
    census.producers &= ~bit;
    census.faulted &= ~bit;
    Fault(slot, SrdoCause::kInvalid);
    Withdraw(x_storage.marks->automatic, bit);
    x_storage.first_cause[slot] = SrdoCause::kInvalid;
    x_storage.stage[slot] = Stage::kIdle;
    if (x_storage.direction[slot] == kDirectionConsumer)
    {
        census.faulted |= bit;
    }
    else
    {
        x_storage.state[slot] = SrdoState::kOff;
    }
}

Channel::Census Channel::SoundCensus() noexcept
{
    Census census = TakeCensus();
    const Marks& marks = *x_storage.marks;
    const SrdoMask consumers = census.waiting | census.faulted | census.released;
    const SrdoMask twins = (marks.held.on ^ marks.held.off) & (marks.acknowledged.on ^ marks.acknowledged.off) &
                           (marks.automatic.on ^ marks.automatic.off);
    census.corrupted |= (consumers & ~twins) | (census.released & ~marks.held.on);
    for (SrdoMask rest = census.corrupted; rest != 0U; rest &= rest - 1U)
    {
        Repair(LowestSlot(rest), census);
    }
    return census;
}

} // namespace counterpoint::channel_b
