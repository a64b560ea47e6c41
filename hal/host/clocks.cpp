// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/clocks.hpp"

#include <algorithm>

namespace counterpoint::host
{

namespace
{

constexpr std::uint64_t kMillion = 1'000'000U;
constexpr std::uint64_t kNanosecondsPerMicrosecond = 1'000U;
/// After so many nanoseconds the reading comes back to the same value.
constexpr std::uint64_t kPeriodNs = 0x1'0000'0000U * kNanosecondsPerMicrosecond;

} // namespace

HostClock::HostClock(const std::uint32_t start_us) : base_ns_(start_us * kNanosecondsPerMicrosecond)
{
}

Instant HostClock::At(const BusTime at) const
{
    const std::uint64_t reading_ns = base_ns_ + SinceOrigin(at).ns;
    return Instant{static_cast<std::uint32_t>(reading_ns / kNanosecondsPerMicrosecond)};
}

void HostClock::SetRate(const BusTime at, const std::uint32_t rate_ppm)
{
    Rebase(at);
    rate_ppm_ = std::min(rate_ppm, kGreatestRate);
}

void HostClock::Jump(const BusTime at, const std::int32_t delta_us)
{
    Rebase(at);
    const std::int64_t delta_ns =
        static_cast<std::int64_t>(delta_us) * static_cast<std::int64_t>(kNanosecondsPerMicrosecond);
    base_ns_ = (base_ns_ + kPeriodNs + static_cast<std::uint64_t>(delta_ns)) % kPeriodNs;
}

/// Whole millionths of the elapsed time are multiplied before the rest, so that nothing overflows, and the fraction of
/// a nanosecond is kept, so that nothing is rounded away.
HostClock::Progress HostClock::SinceOrigin(const BusTime at) const
{
    const std::uint64_t elapsed = static_cast<std::uint64_t>(std::max<BusTime>(at - origin_, 0));
    const std::uint64_t fraction = ((elapsed % kMillion) * rate_ppm_) + base_fraction_;
    return Progress{((elapsed / kMillion) * rate_ppm_) + (fraction / kMillion), fraction % kMillion};
}

void HostClock::Rebase(const BusTime at)
{
    const Progress progress = SinceOrigin(at);
    base_ns_ = (base_ns_ + (progress.ns % kPeriodNs)) % kPeriodNs;
    base_fraction_ = progress.fraction;
    origin_ = std::max(at, origin_);
}

HostClocks::HostClocks(const VirtualBus& bus, const InstantPair& start) : bus_(bus), a_(start.a.us), b_(start.b.us)
{
}

InstantPair HostClocks::Now() noexcept
{
    return At(bus_.Now());
}

InstantPair HostClocks::At(const BusTime at) const
{
    return InstantPair{a_.At(at), b_.At(at)};
}

} // namespace counterpoint::host
