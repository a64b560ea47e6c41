// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/third_voice/consumer.hpp"

namespace counterpoint::third_voice
{
namespace
{
std::uint64_t WordOf(const Bytes& data)
{
    std::uint64_t word = 0U;
    for (std::size_t byte = data.size(); byte > 0U; --byte)
    {
        word = (word << 8U) | data[byte - 1U];
    }
    return word;
}
} // namespace

bool AcknowledgeInput::Rises(const bool level)
{
    const bool was = settled_;
    settled_ = (level == last_) ? level : settled_;
    last_ = level;
    return settled_ && !was;
}

void Consumer::EnterOperational(const ConsumerRules& rules, const Time now)
{
    rules_ = rules;
    is_active_ = true;
    state_ = SrdoState::kWaiting;
    pending_.reset();
    held_.reset();
    ordinal_ = 0U;
    entered_ = now;
    has_told_waiting_ = false;
    has_seen_pair_ = false;
    first_cause_ = SrdoCause::kNone;
    has_new_fault_ = false;
    needs_acknowledge_ = !rules.is_automatic;
    edge_.reset();
    told_at_.clear();
    signals_.clear();
}

void Consumer::LeaveOperational()
{
    is_active_ = false;
    state_ = SrdoState::kOff;
    pending_.reset();
    held_.reset();
    edge_.reset();
    has_new_fault_ = false;
}

bool Consumer::IsActive() const
{
    return is_active_;
}

bool Consumer::HasRightLength(const Bytes& data) const
{
    return data.size() == rules_.length_bytes;
}

void Consumer::Signal(const SrdoCause cause, const Time now)
{
    const auto told = told_at_.find(cause);
    if (told == told_at_.end() || now - told->second >= rules_.sct_us)
    {
        told_at_[cause] = now;
        signals_.push_back(cause);
    }
}

void Consumer::Fail(const SrdoCause cause, const Time now)
{
    if (!is_active_)
    {
        return;
    }
    if (first_cause_ == SrdoCause::kNone)
    {
        first_cause_ = cause;
    }
    pending_.reset();
    held_.reset();
    state_ = SrdoState::kFaulted;
    has_new_fault_ = true;
    needs_acknowledge_ = !rules_.is_automatic;
    edge_.reset();
    Signal(cause, now);
}

/// What had expired before a frame came is reported first; the frame is then judged by itself.
void Consumer::LookAtExpired(const Time stamp)
{
    const bool is_srvt_over = pending_ && !rules_.is_late && stamp - pending_->stamp > rules_.srvt_us;
    const bool is_sct_over = held_ && (!pending_ || rules_.is_late) && stamp - held_->stamp > rules_.sct_us;
    if (is_srvt_over)
    {
        Fail(SrdoCause::kSrvt, stamp);
    }
    else if (is_sct_over)
    {
        Fail(SrdoCause::kSct, stamp);
    }
}

void Consumer::OnNormal(const Bytes& data, const Time stamp)
{
    if (!is_active_)
    {
        return;
    }
    LookAtExpired(stamp);
    if (!HasRightLength(data))
    {
        Fail(SrdoCause::kLength, stamp);
        return;
    }
    if (pending_)
    {
        Fail(SrdoCause::kNormalTwice, stamp);
        return;
    }
    pending_ = Half{WordOf(data), stamp};
}

void Consumer::OnInverse(const Bytes& data, const Time stamp)
{
    if (!is_active_)
    {
        return;
    }
    LookAtExpired(stamp);
    if (pending_ && stamp - pending_->stamp > rules_.srvt_us) // Late mode looks only now.
    {
        Fail(SrdoCause::kSrvt, stamp);
    }
    if (!HasRightLength(data))
    {
        Fail(SrdoCause::kLength, stamp);
        return;
    }
    if (!pending_)
    {
        Fail(SrdoCause::kInverseFirst, stamp);
        return;
    }
    const std::size_t bits = 8U * rules_.length_bytes;
    const std::uint64_t all = (bits >= 64U) ? ~std::uint64_t{0U} : ((std::uint64_t{1U} << bits) - 1U);
    const std::uint64_t inverse = WordOf(data);
    const bool is_inverse = ((pending_->data ^ inverse) & all) == all;
    const bool is_padded = (pending_->data & all & ~rules_.mask) == 0U; // Unused bits: 0 here, hence 1 there.
    if (rules_.is_inversion_checked && (!is_inverse || !is_padded))
    {
        Fail(SrdoCause::kNotInverse, stamp);
        return;
    }
    Complete(*pending_);
}

void Consumer::Complete(const Half& half)
{
    held_ = half;
    pending_.reset();
    has_seen_pair_ = true;
    ++ordinal_;
}

void Consumer::LookAtLimits(const Time now)
{
    if (!is_active_)
    {
        return;
    }
    const bool is_srvt_over = pending_ && !rules_.is_late && now - pending_->stamp > rules_.srvt_us;
    const bool counts_sct = held_ && (!pending_ || rules_.is_late);
    if (is_srvt_over)
    {
        Fail(SrdoCause::kSrvt, now);
    }
    else if (counts_sct && now - held_->stamp > rules_.sct_us)
    {
        Fail(SrdoCause::kSct, now);
    }
    else if (!has_seen_pair_ && !has_told_waiting_ && state_ == SrdoState::kWaiting && now - entered_ > rules_.sct_us)
    {
        has_told_waiting_ = true;
        Signal(SrdoCause::kWaitingPastSct, now);
    }
}

void Consumer::LookAtAcknowledge(const bool level, const Time now)
{
    const bool rises = input_.Rises(level);
    if (!is_active_)
    {
        return;
    }
    if (rises)
    {
        edge_ = now;
    }
    else if (edge_ && now - *edge_ > rules_.acknowledge_window_us)
    {
        edge_.reset();
    }
}

bool Consumer::MayRelease(const Time /*now*/) const
{
    return is_active_ && held_ && !has_new_fault_ && (state_ == SrdoState::kReleased || !needs_acknowledge_ || edge_);
}

void Consumer::Release()
{
    if (state_ != SrdoState::kReleased)
    {
        state_ = SrdoState::kReleased;
        first_cause_ = SrdoCause::kNone;
        needs_acknowledge_ = false;
        edge_.reset();
    }
}

SrdoState Consumer::State() const
{
    return state_;
}

bool Consumer::HasNewFault() const
{
    return has_new_fault_;
}

std::uint64_t Consumer::Data() const
{
    return held_ ? held_->data : 0U;
}

std::uint32_t Consumer::Ordinal() const
{
    return ordinal_;
}

SrdoCause Consumer::FirstCause() const
{
    return first_cause_;
}

std::vector<SrdoCause> Consumer::TakeSignals()
{
    std::vector<SrdoCause> taken;
    taken.swap(signals_);
    return taken;
}

/// A pair that was completed behind a fault, but before the cycle that tells of it, is not used.
void Consumer::EndCycle()
{
    if (has_new_fault_)
    {
        held_.reset();
    }
    has_new_fault_ = false;
}
} // namespace counterpoint::third_voice
