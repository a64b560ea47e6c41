// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/live/hardware_clock.hpp"

#include <algorithm>

namespace counterpoint::host
{
namespace
{

constexpr std::int64_t kGreatestStepNs = 100'000'000;
/// 200 ppm.
constexpr std::uint64_t kDriftPart = 5000U;

} // namespace

std::uint64_t HardwareClock::Map(const std::uint64_t hardware_ns, const std::uint64_t software_ns) noexcept
{
    const auto distance = static_cast<std::int64_t>(software_ns - hardware_ns);
    const std::uint64_t passed_ns = (hardware_ns > newest_ns_) ? hardware_ns - newest_ns_ : 0U;
    const std::int64_t grown = distance_ns_ + static_cast<std::int64_t>(passed_ns / kDriftPart);
    const std::int64_t step = distance - grown;
    // A controller that was reset, or a clock that was set.
    const bool is_new = !is_known_ || (step > kGreatestStepNs) || (step < -kGreatestStepNs);
    distance_ns_ = is_new ? distance : std::min(grown, distance);
    newest_ns_ = is_new ? hardware_ns : std::max(newest_ns_, hardware_ns);
    is_known_ = true;
    return hardware_ns + static_cast<std::uint64_t>(distance_ns_);
}

} // namespace counterpoint::host
