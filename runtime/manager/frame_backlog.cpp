// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/manager/frame_backlog.hpp"

namespace counterpoint::runtime
{
namespace
{
constexpr std::uint64_t kSilenceNs = 500000000U;
constexpr std::uint64_t kLongestHeapNs = 1000000000U; ///< It comes in parts, but not for longer.
constexpr std::uint64_t kShortestFrameNs = 47000U;    ///< Without data, at 1 Mbit/s.
constexpr std::uint64_t kMarginNs = 2000000U;
} // namespace

FrameBacklog::FrameBacklog(const std::uint64_t start_ns) noexcept : last_turn_ns_(start_ns), last_frame_ns_(start_ns)
{
}

bool FrameBacklog::Has(const std::size_t count, const std::uint64_t now_ns) noexcept
{
    const std::uint64_t passed_ns = now_ns - last_turn_ns_;
    const std::uint64_t carried_ns = ahead_ns_ + count * kShortestFrameNs;
    ahead_ns_ = (carried_ns > passed_ns) ? carried_ns - passed_ns : 0U;
    last_turn_ns_ = now_ns;
    const bool ends_silence = count > 0U && now_ns - last_frame_ns_ > kSilenceNs;
    silence_end_ns_ = ends_silence ? now_ns : silence_end_ns_;
    last_frame_ns_ = (count > 0U) ? now_ns : last_frame_ns_;
    const bool is_after_silence = now_ns - silence_end_ns_ < kLongestHeapNs;
    // What ends a silence has no time before it: it may all have come at once.
    ahead_ns_ = ends_silence ? count * kShortestFrameNs : ahead_ns_;
    has_ = is_after_silence && ahead_ns_ > (has_ ? 0U : kMarginNs);
    return has_;
}

bool IsBootUp(const host::LiveFrame& frame) noexcept
{
    constexpr std::uint32_t kErrorControl = 0x700U;
    constexpr std::uint32_t kLastNode = 127U;
    const bool is_data = !frame.own && !frame.error && !frame.remote && !frame.extended;
    return is_data && frame.identifier > kErrorControl && frame.identifier <= kErrorControl + kLastNode &&
           frame.length_bytes == 1U && frame.data[0] == 0U;
}
} // namespace counterpoint::runtime
