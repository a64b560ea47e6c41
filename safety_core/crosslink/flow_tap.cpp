// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/crosslink/flow_tap.hpp"

namespace counterpoint
{
namespace
{

constexpr std::uint32_t kInverse = 0x359C449BU; // Times kWatchdogConstant it is 1.
static_assert((kInverse * hal::kWatchdogConstant) == 1U, "the inverse modulo 2^32");

} // namespace

FlowTap::FlowTap(hal::Watchdog& watchdog) noexcept : watchdog_{watchdog}
{
}

hal::WatchdogQuestion FlowTap::Question() noexcept
{
    asked_ = watchdog_.Question();
    return asked_;
}

void FlowTap::Answer(const hal::WatchdogAnswer& answer) noexcept
{
    signature_ = (answer.value * kInverse) - asked_.value;
    watchdog_.Answer(answer);
}

std::uint32_t FlowTap::TakeSignature() noexcept
{
    const std::uint32_t signature = signature_;
    signature_ = 0U;
    return signature;
}

} // namespace counterpoint
