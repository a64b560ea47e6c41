// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/third_voice/consumer_srdo.hpp"

namespace counterpoint::third_voice
{
ConsumerSrdo::ConsumerSrdo(const DeviceConfig& config, const std::size_t slot, const SrdoObjects& objects,
                           const Flaw flaw, Variables& variables)
    : config_(config), setup_(config.srdos[slot]), objects_(objects), flaw_(flaw), variables_(variables)
{
}

ConsumerRules ConsumerSrdo::Rules() const
{
    const std::uint32_t bits = BitsOf(objects_);
    ConsumerRules rules;
    rules.sct_us = kUsPerMs * objects_.sct_ms;
    rules.srvt_us = kUsPerMs * objects_.srvt_ms;
    rules.sct_us += (flaw_ == Flaw::kSctLonger) ? 1 : 0;
    rules.srvt_us += (flaw_ == Flaw::kSrvtLonger) ? 1 : 0;
    rules.length_bytes = (bits + 7U) / 8U;
    rules.is_inversion_checked = flaw_ != Flaw::kNoInversion;
    rules.mask = MaskOf(bits);
    rules.is_late = setup_.detection == SrvtDetection::kLate;
    rules.is_automatic = setup_.policy == ReleasePolicy::kAutomatic;
    rules.acknowledge_window_us = config_.acknowledge_window_us;
    rules.is_one_reading_enough = flaw_ == Flaw::kEdgeAtOnce;
    rules.counts_behind_fault = flaw_ == Flaw::kBehindFault;
    return rules;
}

void ConsumerSrdo::EnterOperational(const Time now)
{
    a_.EnterOperational(Rules(), now);
    b_.EnterOperational(Rules(), now);
}

void ConsumerSrdo::LeaveOperational(const bool was_on)
{
    if (was_on)
    {
        has_left_ = true;
        if (flaw_ != Flaw::kKeepsReleased)
        {
            WriteSafe();
        }
    }
    is_released_ = false;
    a_.LeaveOperational();
    b_.LeaveOperational();
}

bool ConsumerSrdo::IsActive() const
{
    return a_.IsActive();
}

void ConsumerSrdo::OnFrame(const std::uint32_t identifier, const Bytes& data, const Time stamp)
{
    if (identifier == objects_.cob_id_1)
    {
        a_.OnNormal(data, stamp);
        b_.OnNormal(data, stamp);
    }
    else if (identifier == objects_.cob_id_2)
    {
        a_.OnInverse(data, stamp);
        b_.OnInverse(data, stamp);
    }
}

void ConsumerSrdo::LookAtAcknowledge(const bool level_a, const bool level_b, const Time now)
{
    a_.LookAtAcknowledge(level_a, now);
    b_.LookAtAcknowledge(level_b, now);
}

void ConsumerSrdo::LookAtLimits(const Time now)
{
    a_.LookAtLimits(now);
    b_.LookAtLimits(now);
}

void ConsumerSrdo::Fail(const SrdoCause cause)
{
    a_.Fail(cause);
    b_.Fail(cause);
}

void ConsumerSrdo::LookAtWaiting(const Time now)
{
    a_.LookAtWaiting(now);
    b_.LookAtWaiting(now);
}

/// Whoever reports a fault makes both safe in this cycle; so does a release of one alone when the window is over.
void ConsumerSrdo::Converge()
{
    if (a_.HasNewFault() != b_.HasNewFault() || a_.IsAloneTooLong() || b_.IsAloneTooLong())
    {
        a_.Demote();
        b_.Demote();
    }
}

bool ConsumerSrdo::IsGiven() const
{
    const bool is_given_by_a = a_.State() == SrdoState::kReleased;
    const bool is_given_by_b = b_.State() == SrdoState::kReleased;
    const bool is_one_enough = flaw_ == Flaw::kOneEdgeIsEnough;
    const bool is_given = is_one_enough ? (is_given_by_a || is_given_by_b) : (is_given_by_a && is_given_by_b);
    return is_given && a_.Ordinal() == b_.Ordinal() && a_.Data() == b_.Data();
}

bool ConsumerSrdo::Decide(const Time now, const bool is_level_2)
{
    is_open_ = is_open_ || a_.IsOpen(now) || b_.IsOpen(now);
    Converge();
    a_.Judge(now);
    b_.Judge(now);
    bool is_new = false;
    if (IsGiven())
    {
        a_.Settle();
        b_.Settle();
        is_new = Release(is_level_2);
    }
    else
    {
        is_released_ = false;
        WriteSafe();
    }
    a_.EndCycle();
    b_.EndCycle();
    return is_new;
}

/// Both observers have the pair; in level 2 that opens nothing, and the objects are safe. [semantics 4]
bool ConsumerSrdo::Release(const bool is_level_2)
{
    if (is_level_2)
    {
        is_released_ = false;
        if (flaw_ != Flaw::kKeepsInLevel2)
        {
            WriteSafe();
        }
        return false;
    }
    const bool is_new = !is_released_ || written_ordinal_ != a_.Ordinal();
    is_released_ = true;
    written_ordinal_ = a_.Ordinal();
    variables_.Write(objects_, a_.Data());
    return is_new;
}

void ConsumerSrdo::WriteSafe()
{
    const Payload& safe = setup_.safe_value;
    variables_.Write(objects_, (std::uint64_t{safe.high} << 32U) | safe.low);
}

SrdoState ConsumerSrdo::State() const
{
    return (a_.State() == b_.State()) ? a_.State() : SrdoState::kFaulted; // While one waits for the other.
}

bool ConsumerSrdo::IsReleased() const
{
    return is_released_;
}

bool ConsumerSrdo::IsOpen() const
{
    return is_open_;
}

std::set<SrdoCause> ConsumerSrdo::TakeCauses()
{
    std::set<SrdoCause> causes = a_.TakeCauses();
    causes.merge(b_.TakeCauses());
    if (has_left_)
    {
        causes.insert(SrdoCause::kNotOperational);
        has_left_ = false;
    }
    return causes;
}
} // namespace counterpoint::third_voice
