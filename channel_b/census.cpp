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

constexpr std::size_t kSlotsInWord = 8U;
constexpr std::uint64_t kLowBits = 0x0101010101010101U;
constexpr std::uint64_t kBelowHighBits = 0x7F7F7F7F7F7F7F7FU;
constexpr std::uint64_t kGather = 0x0102040810204080U;
constexpr SrdoMask kAllOfWord = 0xFFU;

/// The slots of whose column the byte is `value`. In a byte that is 0 after the XOR, neither the sum nor the byte
/// itself sets the high bit; the product brings the bit of byte n to bit 56 + n.
[[nodiscard]] SrdoMask SlotsWith(const Column<std::uint8_t>& column, std::uint8_t value, std::size_t count) noexcept
{
    const std::uint64_t sought = kLowBits * value;
    SrdoMask slots = 0U;
    for (std::size_t first = 0U; first < count; first += kSlotsInWord)
    {
        const std::uint64_t word = PackBytes(&column[first]) ^ sought;
        SrdoMask found = kAllOfWord;
        if (word != 0U) // Not all eight of them.
        {
            const std::uint64_t unlike = ((word & kBelowHighBits) + kBelowHighBits) | word;
            found = (((~unlike >> 7U) & kLowBits) * kGather) >> 56U;
        }
        slots |= found << first;
    }
    return slots;
}

} // namespace

/// All masks are empty while SRDOs are not active.
Channel::Census Channel::TakeCensus() const noexcept
{
    const std::size_t count = x_count;
    const SrdoMask consumers = x_active & SlotsWith(x_storage.direction, kDirectionConsumer, count);
    Census census{0U, 0U, 0U, 0U, 0U};
    census.released = consumers & SlotsWith(x_storage.state, Code(SrdoState::kReleased), count);
    for (SrdoMask rest = census.released & ~SlotsWith(x_storage.first_cause, Code(SrdoCause::kNone), count);
         rest != 0U;)
    {
        const SlotIndex slot = TakeLowest(rest);
        if (!IsRecordable(x_storage.first_cause[slot]))
        {
            census.released &= ~BitOf(slot);
        }
    }
    if (census.released != x_active) // Else there is nothing else to be found.
    {
        const SrdoMask producers = x_active & SlotsWith(x_storage.direction, kDirectionProducer, count);
        const SrdoMask off = SlotsWith(x_storage.state, Code(SrdoState::kOff), count);
        census.waiting = consumers & SlotsWith(x_storage.state, Code(SrdoState::kWaiting), count);
        census.faulted = consumers & SlotsWith(x_storage.state, Code(SrdoState::kFaulted), count);
        census.producers = producers & SlotsWith(x_storage.state, Code(SrdoState::kProducer), count);
        census.corrupted = x_active & ~(off | census.waiting | census.faulted | census.released | census.producers);
    }
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
    x_storage.first_cause[slot] = Code(SrdoCause::kInvalid);
    x_storage.stage[slot] = Stage::kIdle;
    if (x_storage.direction[slot] == kDirectionConsumer)
    {
        census.faulted |= bit;
    }
    else
    {
        x_storage.state[slot] = Code(SrdoState::kOff);
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
    for (SrdoMask rest = census.corrupted; rest != 0U;)
    {
        Repair(TakeLowest(rest), census);
    }
    return census;
}

} // namespace counterpoint::channel_b
