// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/channel.hpp"
#include "channel_b/image.hpp"

#include <cstdint>

/// Looks for consumers whose marks do not fit each other or whose first cause is none: eight causes at a time where
/// there is no cause.
namespace counterpoint::channel_b
{

namespace
{

constexpr std::uint8_t kSlotsInWord = 8U;
constexpr HalfMask kAllOfWord = 0xFFU;
constexpr std::uint64_t kEightWithoutCause = 0x0101010101010101U * Code(SrdoCause::kNone);

/// Slots for which exactly one of the twins is set.
[[nodiscard]] HalfMask SoundOf(const TwinMask& mask) noexcept
{
    return mask.on ^ mask.off;
}

} // namespace

/// What does not fit ends in kFaulted. With an undefined first cause nothing is released again. The bytes of slots that
/// do not exist count for nothing. [SRS-CONS-024]
void Channel::ExamineMarks(const Half& half) noexcept
{
    Marks& marks = *half.marks;
    HalfMask caused = 0U;
    std::size_t at = half.first;
    for (HalfMask word = kAllOfWord; (word & half.present) != 0U; word <<= kSlotsInWord)
    {
        caused |= (PackBytes(&x_storage.first_cause[at]) != kEightWithoutCause) ? word : 0U;
        at += kSlotsInWord;
    }
    const HalfMask active = Granted(marks.enrolled) & half.present;
    marks.producers &= active;
    marks.consumers = active & ~marks.producers;
    Withdraw(marks.released, ~marks.consumers);
    const HalfMask sound =
        SoundOf(marks.held) & SoundOf(marks.acknowledged) & SoundOf(marks.automatic) & SoundOf(marks.released);
    const HalfMask unfit = marks.released.on & (marks.faulted | ~marks.held.on);
    HalfMask wrong = marks.consumers & (unfit | ~sound);
    for (HalfMask rest = caused & marks.released.on & marks.consumers; rest != 0U; rest = WithoutLowest(rest))
    {
        const SlotIndex slot = LowestOf(rest, half.first);
        wrong |= IsRecordable(x_storage.first_cause[slot]) ? 0U : BitOf(slot);
    }
    Withdraw(marks.automatic, wrong & ~SoundOf(marks.automatic));
    FaultEach(half.first, wrong, SrdoCause::kInvalid);
}

} // namespace counterpoint::channel_b
