// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/calls.hpp"

namespace counterpoint::campaign
{
Turn CallFaults::Next(const Part part, const std::uint32_t call) noexcept
{
    if (fault_ == nullptr || fault_->part != part || call != fault_->subject / kTurns)
    {
        return Turn::kAsItIs;
    }
    const std::uint32_t turn = turns_[call]++;
    const bool is_always = (fault_->variant & kAlways) != 0U;
    const bool is_now = cycle_ == fault_->cycle || (is_always && cycle_ > fault_->cycle);
    if (!is_now || turn != fault_->subject % kTurns)
    {
        return Turn::kAsItIs;
    }
    if (fault_->kind == FaultKind::kSkipped)
    {
        return ((fault_->variant & kNothingLeft) != 0U) ? Turn::kSkipToZero : Turn::kSkip;
    }
    return (fault_->kind == FaultKind::kDoubled) ? Turn::kTwice : Turn::kDefer;
}
} // namespace counterpoint::campaign
