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

bool AcknowledgeInput::Rises(const bool level, const bool is_one_enough)
{
    const bool was = settled_;
    settled_ = (level == last_ || is_one_enough) ? level : settled_;
    last_ = level;
    return settled_ && !was;
}

Time AcknowledgeInput::Standing() const
{
    return (last_ ? 1 : 0) + (settled_ ? 2 : 0);
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
    has_new_fault_ = false;
    is_settled_ = false;
    edge_.reset();
}

void Consumer::LeaveOperational()
{
    is_active_ = false;
    state_ = SrdoState::kOff;
    pending_.reset();
    held_.reset();
    edge_.reset();
    has_new_fault_ = false;
    is_settled_ = false;
}

bool Consumer::IsActive() const
{
    return is_active_;
}

bool Consumer::HasRightLength(const Bytes& data) const
{
    return data.size() == rules_.length_bytes;
}

void Consumer::Fail(const SrdoCause cause)
{
    if (!is_active_)
    {
        return;
    }
    Demote();
    pending_.reset();
    has_new_fault_ = true;
    causes_.insert(cause);
}

void Consumer::Demote()
{
    held_.reset();
    state_ = SrdoState::kFaulted;
    is_settled_ = false;
    edge_.reset();
}

/// What had expired before a frame came is reported first, the earlier deadline of both; the frame is then judged by
/// itself. Late mode looks at SRVT only when an inverse frame comes.
void Consumer::LookAtExpired(const Time stamp, const bool is_inverse)
{
    const bool counts_srvt = pending_ && (!rules_.is_late || is_inverse);
    const bool counts_sct = held_ && (!pending_ || rules_.is_late);
    const bool is_srvt_over = counts_srvt && stamp - pending_->stamp > rules_.srvt_us;
    const bool is_sct_over = counts_sct && stamp - held_->stamp > rules_.sct_us;
    const bool is_srvt_first =
        is_srvt_over && (!is_sct_over || pending_->stamp + rules_.srvt_us <= held_->stamp + rules_.sct_us);
    if (is_srvt_first)
    {
        Fail(SrdoCause::kSrvt);
    }
    else if (is_sct_over)
    {
        Fail(SrdoCause::kSct);
    }
}

void Consumer::OnNormal(const Bytes& data, const Time stamp)
{
    if (!is_active_)
    {
        return;
    }
    LookAtExpired(stamp, false);
    if (!HasRightLength(data))
    {
        Fail(SrdoCause::kLength);
        return;
    }
    if (pending_)
    {
        Fail(SrdoCause::kNormalTwice);
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
    LookAtExpired(stamp, true);
    if (!HasRightLength(data))
    {
        Fail(SrdoCause::kLength);
        return;
    }
    if (!pending_)
    {
        Fail(SrdoCause::kInverseFirst);
        return;
    }
    const std::size_t bits = 8U * rules_.length_bytes;
    const std::uint64_t all = (bits >= 64U) ? ~std::uint64_t{0U} : ((std::uint64_t{1U} << bits) - 1U);
    const std::uint64_t inverse = WordOf(data);
    const bool is_inverse = ((pending_->data ^ inverse) & all) == all;
    const bool is_padded = (pending_->data & all & ~rules_.mask) == 0U; // Unused bits: 0 here, hence 1 there.
    if (rules_.is_inversion_checked && (!is_inverse || !is_padded))
    {
        Fail(SrdoCause::kNotInverse);
        return;
    }
    Complete();
}

/// Behind a fault that no cycle has told yet a pair neither counts nor starts SCT. [semantics 2]
void Consumer::Complete()
{
    const Half half = *pending_;
    pending_.reset();
    if (has_new_fault_ && !rules_.counts_behind_fault)
    {
        return;
    }
    held_ = half;
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
        Fail(SrdoCause::kSrvt);
    }
    else if (counts_sct && now - held_->stamp > rules_.sct_us)
    {
        Fail(SrdoCause::kSct);
    }
}

void Consumer::LookAtWaiting(const Time now)
{
    const bool waits = is_active_ && !has_seen_pair_ && state_ == SrdoState::kWaiting;
    if (waits && !has_told_waiting_ && now - entered_ > rules_.sct_us)
    {
        has_told_waiting_ = true;
        causes_.insert(SrdoCause::kWaitingPastSct);
    }
}

void Consumer::LookAtAcknowledge(const bool level, const Time now)
{
    const bool rises = input_.Rises(level, rules_.is_one_reading_enough);
    if (!is_active_ || is_settled_ || has_new_fault_) // No edge that comes with a fault acknowledges it.
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

void Consumer::Judge(const Time now)
{
    if (is_active_ && held_ && !has_new_fault_ && (rules_.is_automatic || edge_))
    {
        given_at_ = (state_ == SrdoState::kReleased) ? given_at_ : now;
        state_ = SrdoState::kReleased;
    }
}

bool Consumer::IsAloneTooLong() const
{
    return IsAlone() && !edge_;
}

bool Consumer::IsAlone() const
{
    return state_ == SrdoState::kReleased && !is_settled_ && !rules_.is_automatic;
}

bool Consumer::IsOpen(const Time now) const
{
    return IsAlone() && !edge_ != (now - given_at_ > rules_.acknowledge_window_us);
}

void Consumer::Settle()
{
    is_settled_ = true;
    edge_.reset();
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

std::set<SrdoCause> Consumer::TakeCauses()
{
    std::set<SrdoCause> taken;
    taken.swap(causes_);
    return taken;
}

void Consumer::EndCycle()
{
    if (has_new_fault_) // Not released, whatever was counted.
    {
        held_.reset();
    }
    has_new_fault_ = false;
}

std::vector<Time> Consumer::StandingAt(const Time now) const
{
    constexpr Time kNone = -1;
    const bool counts_waiting = is_active_ && !has_told_waiting_ && !has_seen_pair_;
    const bool counts_given = (state_ == SrdoState::kReleased) && !is_settled_;
    return {is_active_ ? 1 : 0,
            static_cast<Time>(state_),
            pending_ ? static_cast<Time>(pending_->data) : kNone,
            pending_ ? now - pending_->stamp : kNone,
            held_ ? static_cast<Time>(held_->data) : kNone,
            held_ ? now - held_->stamp : kNone,
            counts_waiting ? now - entered_ : kNone,
            has_new_fault_ ? 1 : 0,
            is_settled_ ? 1 : 0,
            counts_given ? now - given_at_ : kNone,
            input_.Standing(),
            edge_ ? now - *edge_ : kNone};
}
} // namespace counterpoint::third_voice
