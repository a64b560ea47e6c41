// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_SLOTS_HPP
#define CHANNEL_A_SLOTS_HPP

#include "safety_core/contract/limits.hpp"
#include "safety_core/contract/srdo.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_a
{

/// Each window of five bits of this de Bruijn sequence occurs once: it names the bit that the sequence was multiplied
/// with.
constexpr std::uint32_t kDeBruijn = 0x077CB531U;
constexpr std::uint32_t kDeBruijnShift = 27U;
constexpr std::uint32_t kSlotsOfWord = 32U;
inline constexpr SlotIndex kSlotOfWindow[kSlotsOfWord] = {
    // MISRA D-001
    // clang-format off
    0U, 1U, 28U, 2U, 29U, 14U, 24U, 3U, 30U, 22U, 20U, 15U, 25U, 17U, 4U, 8U,
    31U, 27U, 13U, 23U, 21U, 19U, 16U, 7U, 26U, 12U, 18U, 6U, 11U, 5U, 10U, 9U,
    // clang-format on
};

template <std::size_t kBits>
inline constexpr std::size_t kFound =
    kFound<kBits - 1U> +
    ((kSlotOfWindow[((kDeBruijn << (kBits - 1U)) >> kDeBruijnShift) % kSlotsOfWord] == (kBits - 1U)) ? 1U : 0U);
template <> inline constexpr std::size_t kFound<0U> = 0U;
static_assert(kFound<kSlotsOfWord> == kSlotsOfWord, "every bit is found by its window");

[[nodiscard]] inline SrdoMask BitOf(const std::size_t slot) noexcept
{
    return SrdoMask{1U} << slot;
}

/// @brief Takes the lowest slot out of a mask that is not empty.
[[nodiscard]] inline std::size_t TakeLowest(SrdoMask& mask) noexcept
{
    std::uint32_t word = static_cast<std::uint32_t>(mask);
    std::size_t first = 0U;
    if (word == 0U)
    {
        word = static_cast<std::uint32_t>(mask >> kSlotsOfWord);
        first = kSlotsOfWord;
    }
    const std::uint32_t lowest = word & (~word + 1U);
    mask &= mask - 1U;
    return first + kSlotOfWindow[((lowest * kDeBruijn) >> kDeBruijnShift) % kSlotsOfWord];
}

} // namespace counterpoint::channel_a

#endif
