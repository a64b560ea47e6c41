// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_SAFETY_CORE_KERNEL_COMPARATOR_TEST_HOOKS_HPP
#define TESTS_SAFETY_CORE_KERNEL_COMPARATOR_TEST_HOOKS_HPP

#include <cstddef>
#include <cstdint>

namespace counterpoint
{

/// What happens to the kernel's calls of the comparator: the linker leads them here (--wrap), the objects stay as they
/// ship.
enum class ComparatorCalls : std::uint8_t
{
    kReal = 0U,
    kNotCalled = 1U,         ///< Nothing comes back but zeros.
    kFrozen = 2U,            ///< The last verdict comes back.
    kAlwaysGood = 3U,        ///< No fault ever; everything else is real.
    kDataUnseen = 4U,        ///< Prepared pairs are always called equal.
    kNeverMatched = 5U,      ///< Slot 0 is never called matched; everything else is real.
    kFrameChanged = 6U,      ///< The first of two frames has another bit, see `changed_bit`.
    kNeverAgreed = 7U,       ///< Slot 0 is never called agreed; everything else is real.
    kDemotesToo = 8U,        ///< Slot 0 is demoted besides; everything else is real.
    kAgreedToo = 9U,         ///< Slot 0 is called agreed besides; everything else is real.
    kDemotesUnmatched = 10U, ///< Slot 0 is demoted, and called unmatched, besides; everything else is real.
    kEchoChanged = 11U,      ///< A bit of the echo is otherwise; everything else is real.
};

extern ComparatorCalls comparator_calls;
/// Of a prepared pair, counted over its bytes.
extern std::size_t changed_bit;

} // namespace counterpoint

#endif
