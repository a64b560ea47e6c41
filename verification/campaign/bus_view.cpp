// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/bus_view.hpp"

#include <algorithm>

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
      is_late_(srdo.times.detection == SrvtDetection::kLate), sct_(srdo.times.sct_ms * kMs),
      srvt_(srdo.times.srvt_ms * kMs), greatest_age_(is_late_ ? sct_ : sct_ + srvt_)
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

/// Whether the normal frame that waits is discarded: early by SRVT, late by SCT. [SRS_CMG_813]
bool BusView::HasExpired(const Received& received, const Nanoseconds now) const
{
    return is_late_ ? (received.runs && now - received.newest.normal_at > sct_) : (now - received.normal_at > srvt_);
}

/// True: a complete valid pair is the newest one.
bool BusView::Complete(Received& received, const RecordedFrame& came) const
{
    const CanFrame& frame = came.stamped.frame;
    if (frame.kind != FrameKind::kData)
    {
        return false;
    }
    const bool is_long = frame.length_bytes == bytes_;
    if (frame.identifier == cob_id_1_)
    {
        const bool is_second = received.waits && !HasExpired(received, came.at);
        received.runs = received.runs && is_long && !received.waits; // An error ends SCT until the next pair.
        received.waits = is_long && !is_second;
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
    received.runs = is_pair;
    if (is_pair)
    {
        std::copy_backward(received.before.begin(), received.before.end() - 1, received.before.end());
        received.before.front() = received.newest;
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
    bool is_given = false;
    bool is_listed = false;
    const BusPair* follower = nullptr; // Of the pair that is looked at; the newest one has none.
    for (std::size_t index = 0U; index < std::min<std::size_t>(received.count, kKeptPairs + 1U); ++index)
    {
        const BusPair& pair = (index == 0U) ? received.newest : received.before.at(index - 1U);
        const bool is_in_place = follower == nullptr || now - follower->inverse_at <= discrepancy;
        const bool is_this = is_in_place && is_it(pair);
        is_given = is_given || (is_this && is_sent(pair));
        is_listed = is_listed || is_this;
        follower = &pair;
    }
    if (is_given)
    {
        return Leave::kGiven;
    }
    return is_listed ? Leave::kListed : Leave::kNone;
}
} // namespace counterpoint::campaign
