// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/third_voice/producer.hpp"

namespace counterpoint::third_voice
{
void Producer::EnterOperational(const ProducerRules& rules, const Time now)
{
    rules_ = rules;
    is_active_ = true;
    first_ = now + rules.delay_us;
    next_ = first_;
    silent_since_ = first_;
    looked_.reset();
    is_asked_ = false;
    is_requested_ = false;
    is_refresh_waiting_ = false;
    refreshes_ = 0U;
    flight_.reset();
}

void Producer::LeaveOperational()
{
    is_active_ = false;
    is_asked_ = false;
    is_requested_ = false;
    is_refresh_waiting_ = false;
    flight_.reset();
}

bool Producer::IsActive() const
{
    return is_active_;
}

void Producer::Request()
{
    is_asked_ = is_active_;
}

void Producer::Look(const Time now, const bool is_standing)
{
    const bool is_examined = !is_standing || rules_.misses_standing;
    if (is_standing && looked_ && *looked_ >= first_)
    {
        next_ += now - *looked_;
    }
    looked_ = now;
    LookAtFlight(now);
    if (rules_.is_called && is_examined && now >= next_)
    {
        next_ += rules_.refresh_us;
        ++refreshes_;
        const bool is_skipped = rules_.is_refresh_skipped && flight_;
        if (is_refresh_waiting_ || is_skipped)
        {
            causes_.insert(SrdoCause::kRefreshMissed);
        }
        is_refresh_waiting_ = is_refresh_waiting_ || !is_skipped;
    }
    if (!rules_.is_called)
    {
        LookAtSilence(now);
    }
    is_requested_ = is_requested_ || is_asked_;
    is_asked_ = false;
}

void Producer::LookHalted(const Time now)
{
    if (rules_.misses_halted)
    {
        Look(now, false);
        return;
    }
    LookAtFlight(now);
}

void Producer::LookAtFlight(const Time now)
{
    if (flight_ && now - since_ > rules_.srvt_us)
    {
        Fail(SrdoCause::kNoConfirmation);
    }
}

/// A pair that comes later than the refresh time and a late cycle is an error, also where it comes with the very call
/// that finds it; not where it was asked for before, and waits. [semantics 6]
void Producer::LookAtSilence(const Time now)
{
    const bool is_awaited = is_requested_ || (is_asked_ && rules_.any_request_will_do);
    if (!is_awaited && now > SilentUntil())
    {
        silent_since_ = now;
        causes_.insert(SrdoCause::kRefreshMissed);
    }
}

bool Producer::IsDue() const
{
    return (is_requested_ || is_refresh_waiting_) && looked_ && *looked_ >= first_ && !flight_;
}

bool Producer::IsRefreshWaiting() const
{
    return is_refresh_waiting_;
}

std::uint64_t Producer::Refreshes() const
{
    return refreshes_;
}

Time Producer::NextRefresh() const
{
    return next_;
}

Time Producer::SilentUntil() const
{
    return silent_since_ + rules_.refresh_us + rules_.late_cycle_us;
}

/// Every bit of the inversion is checked before anything leaves.
bool Producer::Prepare(const std::uint64_t normal, const std::uint64_t inverse, const Time now)
{
    is_requested_ = false;
    is_refresh_waiting_ = false;
    silent_since_ = now;
    flight_ = normal & rules_.mask;
    is_inverse_awaited_ = false;
    since_ = now;
    if (((normal ^ inverse) & rules_.mask) != rules_.mask)
    {
        Fail(SrdoCause::kNotInverse);
        return false;
    }
    return true;
}

void Producer::Fail(const SrdoCause cause)
{
    flight_.reset();
    causes_.insert(cause);
}

Confirmed Producer::Confirm(const Sent& frame, const Time stamp)
{
    if (!flight_ || frame.identifier != (is_inverse_awaited_ ? rules_.cob_id_2 : rules_.cob_id_1))
    {
        return Confirmed::kNothing;
    }
    if (frame.data != (is_inverse_awaited_ ? Inverse() : Normal()).data)
    {
        Fail(SrdoCause::kWrongEcho);
        return Confirmed::kNothing;
    }
    if (stamp - since_ > rules_.srvt_us) // Later than SRVT is no confirmation.
    {
        Fail(SrdoCause::kNoConfirmation);
        return Confirmed::kNothing;
    }
    if (is_inverse_awaited_)
    {
        flight_.reset();
        return Confirmed::kPair;
    }
    is_inverse_awaited_ = true;
    since_ = stamp;
    return Confirmed::kNormal;
}

Sent Producer::FrameOf(const std::uint32_t identifier, const std::uint64_t data) const
{
    Sent frame{identifier, {}};
    for (std::size_t byte = 0U; byte < rules_.length_bytes; ++byte)
    {
        frame.data.push_back(static_cast<std::uint8_t>(data >> (8U * byte)));
    }
    return frame;
}

Sent Producer::Normal() const
{
    return FrameOf(rules_.cob_id_1, flight_.value());
}

Sent Producer::Inverse() const
{
    return FrameOf(rules_.cob_id_2, ~flight_.value());
}

std::set<SrdoCause> Producer::TakeCauses()
{
    std::set<SrdoCause> taken;
    taken.swap(causes_);
    return taken;
}
} // namespace counterpoint::third_voice
