// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/manager/frame_backlog.hpp"

#include <algorithm>

namespace counterpoint::runtime
{
namespace
{
constexpr std::uint64_t kSilenceNs = 500000000U;
constexpr std::uint64_t kLongestHeapNs = 1000000000U;    ///< It comes in parts, but not for longer.
constexpr std::uint64_t kShortestFrameNs = 47000U;       ///< Without data, at 1 Mbit/s.
constexpr std::uint64_t kShortestHeartbeatNs = 1000000U; ///< 1017h.
constexpr std::uint64_t kMarginNs = 2000000U;
constexpr std::uint32_t kLastNode = 127U;

bool IsErrorControl(const host::LiveFrame& frame) noexcept
{
    constexpr std::uint32_t kErrorControl = 0x700U;
    const bool is_data = !frame.own && !frame.error && !frame.remote && !frame.extended;
    return is_data && frame.identifier > kErrorControl && frame.identifier <= kErrorControl + kLastNode &&
           frame.length_bytes == 1U;
}
} // namespace

FrameBacklog::FrameBacklog(const std::uint64_t start_ns) noexcept : last_turn_ns_(start_ns), last_frame_ns_(start_ns)
{
}

bool FrameBacklog::Has(const std::vector<host::LiveFrame>& frames, const std::uint64_t now_ns) noexcept
{
    std::array<std::uint64_t, kLastNode + 1U> took_ns{};
    took_ns[0] = frames.size() * kShortestFrameNs;
    for (const host::LiveFrame& frame : frames)
    {
        const bool is_heartbeat = IsErrorControl(frame) && !IsBootUp(frame);
        took_ns[is_heartbeat ? frame.identifier & kLastNode : 0U] += is_heartbeat ? kShortestHeartbeatNs : 0U;
    }
    const std::uint64_t passed_ns = now_ns - last_turn_ns_;
    last_turn_ns_ = now_ns;
    const bool ends_silence = !frames.empty() && now_ns - last_frame_ns_ > kSilenceNs;
    silence_end_ns_ = ends_silence ? now_ns : silence_end_ns_;
    last_frame_ns_ = frames.empty() ? last_frame_ns_ : now_ns;
    std::uint64_t longest_ns = 0U;
    for (std::size_t place = 0U; place < took_ns.size(); ++place)
    {
        const std::uint64_t carried_ns = ahead_ns_[place] + took_ns[place];
        const std::uint64_t rest_ns = (carried_ns > passed_ns) ? carried_ns - passed_ns : 0U;
        // What ends a silence has no time before it: it may all have come at once.
        ahead_ns_[place] = ends_silence ? took_ns[place] : rest_ns;
        longest_ns = std::max(longest_ns, ahead_ns_[place]);
    }
    const bool is_after_silence = now_ns - silence_end_ns_ < kLongestHeapNs;
    has_ = is_after_silence && longest_ns > (has_ ? 0U : kMarginNs);
    return has_;
}

bool IsBootUp(const host::LiveFrame& frame) noexcept
{
    return IsErrorControl(frame) && frame.data[0] == 0U;
}
} // namespace counterpoint::runtime
