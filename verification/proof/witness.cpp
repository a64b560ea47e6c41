// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/proof/witness.hpp"

#include <algorithm>

namespace counterpoint::proof
{

/// "The pair is discarded": with what waits for its other half, and with an acknowledge that waits. [semantics 2]
void Witness::Fail(const SrdoCause cause)
{
    pending_.reset();
    pair_.reset();
    edge_us_.reset();
    error_ = error_ ? error_ : cause;
}

/// "A limit that had expired before a frame came is reported first, and discards what was there." Equal to the limit is
/// accepted. Late mode looks at SRVT when the inverse frame comes, and at SCT beside a waiting normal frame, too.
/// [semantics 1, 2]
void Witness::LookAtLimits(const std::int64_t stamp_us, const bool is_inverse, const ConsumerSetup& setup)
{
    const bool is_late_mode = setup.detection == SrvtDetection::kLate;
    const bool is_srvt_over =
        pending_ && (is_inverse || !is_late_mode) && ((stamp_us - pending_->stamp_us) > std::int64_t{kSrvtUs});
    const bool is_sct_over =
        pair_ && (!pending_ || is_late_mode) && ((stamp_us - pair_->stamp_us) > std::int64_t{kSctUs});
    if (is_srvt_over || is_sct_over)
    {
        Fail(is_srvt_over ? SrdoCause::kSrvt : SrdoCause::kSct);
    }
}

void Witness::OnNormal(const std::uint8_t value, const bool is_length_right, const std::int64_t stamp_us,
                       const ConsumerSetup& setup)
{
    if (!is_active_)
    {
        return;
    }
    LookAtLimits(stamp_us, false, setup);
    if (!is_length_right)
    {
        Fail(SrdoCause::kLength);
    }
    else if (pending_)
    {
        Fail(SrdoCause::kNormalTwice);
    }
    else
    {
        pending_ = Half{value, stamp_us};
    }
}

void Witness::OnInverse(const std::uint8_t value, const bool is_length_right, const std::int64_t stamp_us,
                        const ConsumerSetup& setup)
{
    if (!is_active_)
    {
        return;
    }
    LookAtLimits(stamp_us, true, setup);
    if (!is_length_right)
    {
        Fail(SrdoCause::kLength);
    }
    else if (!pending_)
    {
        Fail(SrdoCause::kInverseFirst);
    }
    else if (pending_->value != value)
    {
        Fail(SrdoCause::kNotInverse);
    }
    else
    {
        pair_ = pending_;
        pending_.reset();
    }
}

/// "A constant 1 never acknowledges", "a level that lasted one cycle only is no edge". [semantics 3]
void Witness::LookAtAcknowledge(const CallSeen& call)
{
    const bool was = is_high_;
    is_high_ = (call.is_acknowledged == was_high_) ? call.is_acknowledged : is_high_;
    was_high_ = call.is_acknowledged;
    if (is_high_ && !was)
    {
        edge_us_ = call.now_us;
    }
    if (edge_us_ && (((call.now_us - *edge_us_) > std::int64_t{kWindowUs}) || !is_active_))
    {
        edge_us_.reset();
    }
}

void Witness::OnCall(const CallSeen& call, const ConsumerSetup& setup)
{
    now_us_ = call.now_us;
    if (call.is_operational != is_active_)
    {
        pending_.reset();
        pair_.reset();
        edge_us_.reset();
        error_.reset();
        is_active_ = call.is_operational;
    }
    LookAtAcknowledge(call);
    if (!is_active_)
    {
        return;
    }
    LookAtLimits(call.now_us, false, setup);
    if (call.is_late)
    {
        Fail(SrdoCause::kLateCall);
    }
    if (!call.is_intact)
    {
        Fail(SrdoCause::kQueueOverflow);
    }
    if (call.is_gfc)
    {
        Fail(SrdoCause::kGfc);
    }
    if (error_)
    {
        // "A pair completed behind a fault, but before the cycle that tells of the fault, is not released." [semantics
        // 2]
        pair_.reset();
        edge_us_.reset();
    }
    if (call.is_demoted) // A frame that waits is not concerned.
    {
        pair_.reset();
        error_ = error_ ? error_ : SrdoCause::kDemoted;
    }
}

void Witness::EndCall(const bool is_released)
{
    if (is_released || error_) // Used up, or forgotten.
    {
        edge_us_.reset();
    }
    error_.reset();
}

std::string Witness::JudgeRelease(const Shows& before, const Shows& now, const ConsumerSetup& setup) const
{
    if (!is_active_)
    {
        return "released outside OPERATIONAL";
    }
    if (error_)
    {
        return "released beside a fault, cause " + std::to_string(static_cast<unsigned>(*error_));
    }
    if (!pair_)
    {
        return "released without a valid pair";
    }
    if (now.data != pair_->value)
    {
        return "released with other data than the pair's";
    }
    // "At the longest SCT + SRVT after its normal frame", in late mode SCT. [semantics 3, 5]
    const std::int64_t most = (setup.detection == SrvtDetection::kLate) ? kSctUs : (kSctUs + kSrvtUs);
    if ((now_us_ - pair_->stamp_us) > most)
    {
        return "released too late";
    }
    const bool is_new = before.state != SrdoState::kReleased;
    if (is_new && (setup.policy == ReleasePolicy::kInterlock) && !edge_us_)
    {
        return "released without acknowledge";
    }
    return {};
}

/// The latch of a fault: one way in, one way out.
std::string Witness::JudgeFault(const Shows& before, const Shows& now) const
{
    const bool stands = now.state == SrdoState::kFaulted;
    if (is_active_ && error_ && !stands)
    {
        return "fault not latched, cause " + std::to_string(static_cast<unsigned>(*error_));
    }
    if (stands && (before.state != SrdoState::kFaulted) && !error_)
    {
        return "faulted without a fault";
    }
    if ((before.state == SrdoState::kFaulted) && (now.state == SrdoState::kWaiting))
    {
        return "fault forgotten";
    }
    const bool is_cleared = (before.first_cause != SrdoCause::kNone) && (before.first_cause != now.first_cause);
    if (is_cleared && !edge_us_)
    {
        return "first cause changed without acknowledge";
    }
    const bool is_new = (now.first_cause != SrdoCause::kNone) && (before.first_cause != now.first_cause);
    if (is_new && is_active_ && !error_)
    {
        return "first cause without a fault";
    }
    return {};
}

std::string Witness::Judge(const Shows& before, const Shows& now, const bool is_call, const ConsumerSetup& setup) const
{
    const bool is_released = now.state == SrdoState::kReleased;
    if (!is_call && is_released && (before.state != SrdoState::kReleased))
    {
        return "released by a frame";
    }
    const std::string found = (is_call && is_released) ? JudgeRelease(before, now, setup) : std::string{};
    return found.empty() ? JudgeFault(before, now) : found;
}

void Witness::AddTo(std::vector<std::uint32_t>& key, const std::int64_t now_us, const std::uint32_t oldest_us) const
{
    const auto age = [now_us, oldest_us](const std::int64_t since)
    { return static_cast<std::uint32_t>(std::min<std::int64_t>(now_us - since, oldest_us)); };
    key.push_back(pending_ ? ((pending_->value + 1U) << 16U) + age(pending_->stamp_us) : 0U);
    key.push_back(pair_ ? ((pair_->value + 1U) << 16U) + age(pair_->stamp_us) : 0U);
    key.push_back(edge_us_ ? age(*edge_us_) + 1U : 0U);
    key.push_back((error_ ? static_cast<std::uint32_t>(*error_) : 0U) | (is_active_ ? 0x100U : 0U) |
                  (was_high_ ? 0x200U : 0U) | (is_high_ ? 0x400U : 0U));
}

} // namespace counterpoint::proof
