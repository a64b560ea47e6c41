// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/monitor/srdo_watch.hpp"

#include "canopen/monitor/texts.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace counterpoint::monitor
{
namespace
{
constexpr std::uint32_t kByteBits = 8U;

std::string Bytes(const std::size_t count)
{
    return std::to_string(count) + (count == 1U ? " byte" : " bytes");
}
} // namespace

const char* CauseName(const Cause cause) noexcept
{
    constexpr std::array<const char*, kCauseCount> names{"wrong length", "inverse first",   "normal twice",
                                                         "not inverse",  "SRVT expired",    "SCT expired",
                                                         "remote frame", "GFC not followed"};
    return names.at(static_cast<std::size_t>(cause));
}

void TimeStatistics::Add(const Time time) noexcept
{
    least = count == 0U ? time : std::min(least, time);
    greatest = count == 0U ? time : std::max(greatest, time);
    ++count;
    sum += static_cast<long double>(time);
    const Time width = std::max<Time>(limit / static_cast<Time>(kBinsToLimit), 1);
    // The limit itself is kept: a bin holds its upper end.
    const auto bin = static_cast<std::size_t>(std::max<Time>(time - 1, 0) / width);
    ++bins.at(std::min(bin, kBins - 1U));
}

Time TimeStatistics::Mean() const noexcept
{
    return count == 0U ? 0 : static_cast<Time>(sum / static_cast<long double>(count));
}

SrdoWatch::SrdoWatch(const std::size_t number, const WatchSetup& setup, BreachSink& sink)
    : number_(number), setup_(setup), sink_(sink),
      length_(static_cast<std::uint8_t>((setup.bits + kByteBits - 1U) / kByteBits))
{
    cycle_.limit = setup.sct;
    srvt_.limit = setup.srvt;
}

void SrdoWatch::Report(const Time time, const Cause cause, const std::string& details)
{
    pending_.reset();
    held_.reset();
    sink_.OnBreach(number_, {time, cause, details});
}

void SrdoWatch::Begin(const Time now) noexcept
{
    blind_until_ = now + setup_.srvt;
}

void SrdoWatch::Stop(const Time now) noexcept
{
    End(now);
    has_remainder_ = has_remainder_ || pending_.has_value() || fitting_.has_value();
    overdue_.reset();
    early_.reset();
    fitting_.reset();
    pending_.reset();
    held_.reset();
}

void SrdoWatch::End(const Time now) noexcept
{
    if (last_good_ && now - *last_good_ > setup_.sct)
    {
        cycle_.Add(now - *last_good_);
    }
    last_good_.reset();
}

// Early: with a pending normal frame SRVT, else SCT. Late: SCT alone; SRVT waits for the inverse frame.
Time SrdoWatch::Deadline() const noexcept
{
    const bool is_srvt = pending_ && !setup_.is_late;
    if (is_srvt)
    {
        return pending_->time + setup_.srvt;
    }
    return held_ ? *held_ + setup_.sct : std::numeric_limits<Time>::max();
}

void SrdoWatch::Advance(const Time now)
{
    const Time deadline = Deadline();
    if (now <= deadline)
    {
        return;
    }
    const bool is_srvt = pending_ && !setup_.is_late;
    has_remainder_ = pending_.has_value();
    overdue_ = pending_ ? std::optional<Time>(pending_->time) : std::nullopt;
    const std::string since = is_srvt ? "no inverse frame within " + MillisecondsText(setup_.srvt)
                                      : "no pair within " + MillisecondsText(setup_.sct);
    Report(deadline, is_srvt ? Cause::kSrvt : Cause::kSct,
           since + " after the normal frame at " +
               SecondsText(is_srvt ? deadline - setup_.srvt : deadline - setup_.sct));
}

void SrdoWatch::OnFrame(const LogFrame& frame)
{
    if (frame.is_remote)
    {
        sink_.OnBreach(number_, {frame.time, Cause::kRemote, "a consumer does not count it"});
        return;
    }
    const bool is_inverse = frame.identifier == setup_.inverse_id;
    const bool may_be_late = is_inverse && setup_.is_late && pending_.has_value();
    if (may_be_late && IsLateInverse(frame))
    {
        return;
    }
    Advance(frame.time);
    if (is_inverse)
    {
        TakeInverse(frame);
    }
    else
    {
        TakeNormal(frame);
    }
}

/// Late detection: an inverse frame after SRVT is the fault, unless SCT has expired before the frame. [SRS_TIME_009]
bool SrdoWatch::IsLateInverse(const LogFrame& frame)
{
    const Time limit = pending_->time + setup_.srvt;
    const bool is_sct_first = held_ && *held_ + setup_.sct < frame.time;
    if (frame.time <= limit || is_sct_first)
    {
        return false;
    }
    const Time after = frame.time - pending_->time;
    srvt_.Add(after);
    has_remainder_ = false;
    Report(frame.time, Cause::kSrvt,
           "inverse frame " + MillisecondsText(after) + " after the normal frame, limit " +
               MillisecondsText(setup_.srvt));
    return true;
}

/// Frames that changed places are one violation, told with the first one. That the other one is what is left of the
/// pair, and not the first frame of the next one with the same data, nobody knows before the frame behind it.
bool SrdoWatch::MayBeExchanged(const LogFrame& normal) noexcept
{
    const bool fits = early_ && normal.time <= early_->time + setup_.srvt && normal.length == early_->length &&
                      WrongBit(normal, *early_) < 0;
    early_.reset();
    fitting_ = fits ? std::optional<LogFrame>(normal) : std::nullopt;
    return fits;
}

void SrdoWatch::TakeNormal(const LogFrame& frame)
{
    if (MayBeExchanged(frame))
    {
        return;
    }
    const bool was_pending = pending_.has_value();
    has_remainder_ = false;
    overdue_.reset();
    blind_until_.reset();
    if (frame.length != length_)
    {
        has_remainder_ = true;
        Report(frame.time, Cause::kLength, "normal frame of " + Bytes(frame.length) + ", expected " + Bytes(length_));
        return;
    }
    if (was_pending)
    {
        has_remainder_ = true;
        const std::string first = SecondsText(pending_->time);
        Report(frame.time, Cause::kNormalTwice, "no inverse frame since the normal frame at " + first);
        return;
    }
    pending_ = frame;
}

/// Number of the first bit that is not inverted, -1 where all are. Bits above the mapped ones are 0 and 1.
int SrdoWatch::WrongBit(const LogFrame& normal, const LogFrame& inverse) const noexcept
{
    for (std::uint32_t bit = 0U; bit < length_ * kByteBits; ++bit)
    {
        const std::uint32_t plain = (normal.data[bit / kByteBits] >> (bit % kByteBits)) & 1U;
        const std::uint32_t turned = (inverse.data[bit / kByteBits] >> (bit % kByteBits)) & 1U;
        const bool is_spare_set = bit >= setup_.bits && plain != 0U;
        if (plain == turned || is_spare_set)
        {
            return static_cast<int>(bit);
        }
    }
    return -1;
}

/// An inverse frame within SRVT of the normal frame that may be the rest of an exchanged pair: it began the next one.
/// [SRS_MON_030]
bool SrdoWatch::IsOfFitting(const LogFrame& inverse)
{
    const bool is_its = fitting_ && inverse.time <= fitting_->time + setup_.srvt;
    if (is_its)
    {
        pending_ = fitting_;
    }
    fitting_.reset();
    return is_its;
}

void SrdoWatch::TakeInverse(const LogFrame& frame)
{
    const bool is_of_fitting = IsOfFitting(frame);
    const bool is_unseen = blind_until_ && frame.time <= *blind_until_;
    const bool is_remainder = has_remainder_ || is_unseen; // Neither beside a normal frame that is pending.
    has_remainder_ = false;
    early_.reset();
    blind_until_.reset();
    const std::optional<Time> since = pending_ ? std::optional<Time>(pending_->time) : std::exchange(overdue_, {});
    if (since)
    {
        srvt_.Add(frame.time - *since);
    }
    if (is_remainder)
    {
        return;
    }
    if (frame.length != length_)
    {
        Report(frame.time, Cause::kLength, "inverse frame of " + Bytes(frame.length) + ", expected " + Bytes(length_));
        return;
    }
    if (!pending_)
    {
        early_ = frame;
        Report(frame.time, Cause::kInverseFirst, "no normal frame before it");
        return;
    }
    const int wrong = WrongBit(*pending_, frame);
    if (wrong >= 0)
    {
        // If the normal frame was the rest of an exchanged pair after all, this may be the first one of another.
        early_ = is_of_fitting ? std::optional<LogFrame>(frame) : std::nullopt;
        Report(frame.time, Cause::kNotInverse,
               "bit " + std::to_string(wrong) + ": normal " + DataText(*pending_) + ", inverse " + DataText(frame));
        return;
    }
    held_ = pending_->time;
    if (last_good_)
    {
        cycle_.Add(*held_ - *last_good_);
    }
    last_good_ = held_;
    pending_.reset();
    ++pairs_;
}
} // namespace counterpoint::monitor
