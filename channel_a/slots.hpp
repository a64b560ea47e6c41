// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_SLOTS_HPP
#define CHANNEL_A_SLOTS_HPP

#include "safety_core/contract/limits.hpp"
#include "safety_core/contract/srdo.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_a
{

/// Each window of six bits of this de Bruijn sequence occurs once: it names the bit that the sequence was multiplied
/// with.
constexpr SrdoMask kDeBruijn = 0x03F79D71B4CB0A89U;
constexpr std::uint32_t kDeBruijnShift = 58U;
inline constexpr SlotIndex kSlotOfWindow[kMaxSrdoCount] = {
    // MISRA D-001
    // clang-format off
    0U, 1U, 48U, 2U, 57U, 49U, 28U, 3U, 61U, 58U, 50U, 42U, 38U, 29U, 17U, 4U,
    62U, 55U, 59U, 36U, 53U, 51U, 43U, 22U, 45U, 39U, 33U, 30U, 24U, 18U, 12U, 5U,
    63U, 47U, 56U, 27U, 60U, 41U, 37U, 16U, 54U, 35U, 52U, 21U, 44U, 32U, 23U, 11U,
    46U, 26U, 40U, 15U, 34U, 20U, 31U, 10U, 25U, 14U, 19U, 9U, 13U, 8U, 7U, 6U,
    // clang-format on
};

template <std::size_t kBits>
inline constexpr std::size_t kFound =
    kFound<kBits - 1U> + ((kSlotOfWindow[(kDeBruijn << (kBits - 1U)) >> kDeBruijnShift] == (kBits - 1U)) ? 1U : 0U);
template <> inline constexpr std::size_t kFound<0U> = 0U;
static_assert(kFound<kMaxSrdoCount> == kMaxSrdoCount, "every bit is found by its window");

[[nodiscard]] inline SrdoMask BitOf(const std::uint32_t slot) noexcept
{
    return SrdoMask{1U} << slot;
}

/// @brief Takes the lowest slot out of a mask that is not empty.
[[nodiscard]] inline std::uint32_t TakeLowest(SrdoMask& mask) noexcept
{
    const SrdoMask lowest = mask & (~mask + 1U);
    mask ^= lowest;
    return kSlotOfWindow[(lowest * kDeBruijn) >> kDeBruijnShift];
}

} // namespace counterpoint::channel_a

#endif
