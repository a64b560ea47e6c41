// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/bus_view.hpp"

namespace counterpoint::campaign
{
namespace
{
constexpr Nanoseconds kMs = runtime::kNanosecondsPerMillisecond;
constexpr std::uint32_t kByteBits = 8U;

std::uint64_t LowBits(const std::uint32_t bits)
{
    return (bits == 0U) ? 0U : (~std::uint64_t{0U} >> (kMaxPayloadBits - bits));
}
} // namespace

std::uint64_t NumberIn(const CanFrame& frame)
{
    std::uint64_t number = 0U;
    for (std::uint32_t byte = 0U; byte < frame.length_bytes && byte < kMaxPayloadBytes; ++byte)
    {
        number |= std::uint64_t{frame.data[byte]} << (byte * kByteBits);
    }
    return number;
}

BusView::BusView(const Recording& recording, const runtime::SrdoModel& srdo, const std::uint32_t mapped_bits)
    : recording_(recording), greatest_age_((srdo.times.sct_ms + srdo.times.srvt_ms) * kMs)
{
    const std::uint32_t bytes = (mapped_bits + kByteBits - 1U) / kByteBits;
    const std::uint64_t all = LowBits(bytes * kByteBits);
    const RecordedFrame* normal = nullptr;
    std::size_t frame = 0U;
    for (const RecordedCycle& cycle : recording.cycles)
    {
        for (; frame < cycle.frames_end; ++frame)
        {
            const RecordedFrame& came = recording.frames[frame];
            const bool is_long = came.stamped.frame.length_bytes == bytes;
            if (came.stamped.frame.identifier == srdo.cob_id_1)
            {
                normal = (is_long && normal == nullptr) ? &came : nullptr;
            }
            else if (came.stamped.frame.identifier == srdo.cob_id_2)
            {
                const bool is_pair = normal != nullptr && is_long && came.at - normal->at <= srdo.times.srvt_ms * kMs &&
                                     (NumberIn(normal->stamped.frame) ^ NumberIn(came.stamped.frame)) == all;
                if (is_pair)
                {
                    pairs_.push_back({normal->at, came.at, NumberIn(normal->stamped.frame)});
                }
                normal = nullptr;
            }
        }
        ends_.push_back(pairs_.size());
    }
}

bool BusView::Allows(const std::size_t cycle, const std::uint64_t data, const std::uint64_t mask,
                     const Nanoseconds discrepancy) const
{
    const Nanoseconds now = recording_.cycles[cycle].at;
    const std::size_t end = ends_[cycle];
    const auto is_it = [this, now, data, mask](const std::size_t index)
    { return ((pairs_[index].data ^ data) & mask) == 0U && now - pairs_[index].normal_at <= greatest_age_; };
    if (end == 0U)
    {
        return false;
    }
    const bool may_be_older = end > 1U && now - pairs_[end - 1U].inverse_at <= discrepancy;
    return is_it(end - 1U) || (may_be_older && is_it(end - 2U));
}
} // namespace counterpoint::campaign
