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
    : cob_id_1_(srdo.cob_id_1), cob_id_2_(srdo.cob_id_2), bytes_((mapped_bits + kByteBits - 1U) / kByteBits),
      srvt_(srdo.times.srvt_ms * kMs),
      greatest_age_((srdo.times.detection == SrvtDetection::kLate) ? srdo.times.sct_ms * kMs
                                                                   : (srdo.times.sct_ms + srdo.times.srvt_ms) * kMs)
{
    Received received;
    for (const RecordedFrame& frame : recording.frames)
    {
        if (Complete(received, frame))
        {
            pairs_.push_back(received.newest);
        }
    }
}

/// True: a complete valid pair is the newest one.
bool BusView::Complete(Received& received, const RecordedFrame& came) const
{
    const CanFrame& frame = came.stamped.frame;
    const bool is_long = frame.length_bytes == bytes_ && frame.kind == FrameKind::kData;
    if (frame.identifier == cob_id_1_)
    {
        received.waits = is_long && !received.waits;
        received.normal_at = came.at;
        received.normal = NumberIn(frame);
        return false;
    }
    if (frame.identifier != cob_id_2_)
    {
        return false;
    }
    const bool is_pair = received.waits && is_long && came.at - received.normal_at <= srvt_ &&
                         (received.normal ^ NumberIn(frame)) == LowBits(bytes_ * kByteBits);
    received.waits = false;
    if (is_pair)
    {
        received.before = received.newest;
        received.newest = {received.normal_at, came.at, received.normal, BusPair::kNever};
        ++received.count;
    }
    return is_pair;
}

/// Who sent it is not asked: it is one that was sent if its data are those of a pair that was sent no earlier than the
/// last one that was, and not after it came.
void BusView::Take(Received& received, const RecordedFrame& came) const
{
    if (!Complete(received, came))
    {
        return;
    }
    for (std::size_t index = received.sent; index < pairs_.size() && pairs_[index].normal_at <= came.at; ++index)
    {
        if (pairs_[index].data == received.newest.data)
        {
            received.newest.sent_at = pairs_[index].normal_at;
            received.sent = index;
        }
    }
}

Leave BusView::Allows(const Received& received, const Nanoseconds now, const std::uint64_t data,
                      const std::uint64_t mask, const Nanoseconds discrepancy) const
{
    const auto is_it = [this, now, data, mask](const BusPair& pair)
    { return ((pair.data ^ data) & mask) == 0U && now - pair.normal_at <= greatest_age_; };
    const auto is_sent = [this, now](const BusPair& pair)
    { return pair.sent_at != BusPair::kNever && now - pair.sent_at <= greatest_age_; };
    const bool is_newest = received.count > 0U && is_it(received.newest);
    const bool is_before =
        received.count > 1U && now - received.newest.inverse_at <= discrepancy && is_it(received.before);
    if ((is_newest && is_sent(received.newest)) || (is_before && is_sent(received.before)))
    {
        return Leave::kGiven;
    }
    return (is_newest || is_before) ? Leave::kListed : Leave::kNone;
}
} // namespace counterpoint::campaign
