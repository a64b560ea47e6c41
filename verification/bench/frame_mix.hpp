// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_BENCH_FRAME_MIX_HPP
#define VERIFICATION_BENCH_FRAME_MIX_HPP

#include <cstdint>

/// What a ServiceNode lives through on the simulated bus, written down by bench_mix and replayed on the target. Words
/// of 32 bits, in the file with the high byte first.
namespace counterpoint::bench
{

constexpr std::uint32_t kMixMagic = 0x4D495831U;
/// Where the emulator loads the file: behind the program, in memory that it does not use.
constexpr std::uint32_t kMixAddress = 0x00600000U;

enum class MixKind : std::uint8_t
{
    kInvalid = 0U,
    kFrame = 1U,   ///< Received at `time_us`.
    kConfirm = 2U, ///< A frame of the node was on the bus.
    kCycle = 3U,
    kMeasure = 4U, ///< What follows is measured; once.
};

struct MixEvent
{
    std::uint32_t time_us;
    std::uint32_t head; ///< Kind, length, and identifier in the low half.
    std::uint32_t low;  ///< First four bytes of data, the first one lowest.
    std::uint32_t high;
};

struct MixHeader
{
    std::uint32_t magic;
    std::uint32_t event_count;
    std::uint32_t released; ///< Pairs in the whole time.
    std::uint32_t digest;   ///< FrameDigest of what the node sent in the whole time.
};

struct Mix
{
    MixHeader header;
    MixEvent events[1]; ///< `event_count` of them.
};

} // namespace counterpoint::bench

#endif
