// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/clocks.hpp"

#include <algorithm>
#include <ctime>
#include <limits>

namespace counterpoint::runtime
{
namespace
{
constexpr std::uint64_t kNsPerSecond = 1000000000U;
constexpr std::uint64_t kNsPerUs = 1000U;
/// Two readings that are closer than this were not interrupted.
constexpr std::uint64_t kCloseNs = 5000U;
constexpr int kTries = 16;

std::uint64_t Read(const clockid_t clock)
{
    timespec time{};
    static_cast<void>(::clock_gettime(clock, &time));
    return static_cast<std::uint64_t>(time.tv_sec) * kNsPerSecond + static_cast<std::uint64_t>(time.tv_nsec);
}
} // namespace

NodeClocks::NodeClocks(const std::uint32_t tolerance_us) : tolerance_us_(tolerance_us)
{
    static_cast<void>(Now());
}

InstantPair NodeClocks::Now() noexcept
{
    std::uint64_t best_ns = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t now_ns = 0U;
    for (int attempt = 0; attempt < kTries && best_ns > kCloseNs; ++attempt)
    {
        const std::uint64_t before = Read(CLOCK_MONOTONIC);
        const std::uint64_t raw = Read(CLOCK_MONOTONIC_RAW);
        const std::uint64_t after = Read(CLOCK_MONOTONIC);
        now_ns = after;
        if (after - before < best_ns)
        {
            best_ns = after - before;
            ahead_ns_ = raw - (before + (best_ns / 2U));
        }
    }
    monotonic_ns_ = now_ns;
    return PairOf(now_ns / kNsPerUs, (now_ns + ahead_ns_) / kNsPerUs);
}

InstantPair NodeClocks::Seal() noexcept
{
    newest_a_us_ = std::max(newest_a_us_, monotonic_ns_ / kNsPerUs);
    newest_b_us_ = std::max(newest_b_us_, (monotonic_ns_ + ahead_ns_) / kNsPerUs);
    return PairOf(newest_a_us_, newest_b_us_);
}

InstantPair NodeClocks::Stamp(const std::uint64_t time_ns) noexcept
{
    const std::uint64_t a_us = time_ns / kNsPerUs;
    const std::uint64_t b_us = (time_ns + ahead_ns_) / kNsPerUs;
    const std::uint64_t late_us = (newest_a_us_ > a_us) ? newest_a_us_ - a_us : 0U;
    if (late_us == 0U)
    {
        newest_a_us_ = a_us;
        newest_b_us_ = std::max(newest_b_us_, b_us);
        return PairOf(newest_a_us_, newest_b_us_);
    }
    ++late_count_;
    latest_us_ = std::max(latest_us_, late_us);
    // Later than that, the kernel shall judge it.
    return (late_us <= tolerance_us_) ? PairOf(newest_a_us_, newest_b_us_) : PairOf(a_us, b_us);
}

InstantPair NodeClocks::PairOf(const std::uint64_t a_us, const std::uint64_t b_us) noexcept
{
    return {{static_cast<std::uint32_t>(a_us)}, {static_cast<std::uint32_t>(b_us)}};
}
} // namespace counterpoint::runtime
