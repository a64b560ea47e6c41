// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/third_voice/producer_srdo.hpp"

namespace counterpoint::third_voice
{
namespace
{
constexpr Time kDelayUs = 500; ///< Of the first transmission, for each node-ID.
} // namespace

ProducerSrdo::ProducerSrdo(const DeviceConfig& config, const std::size_t slot, const SrdoObjects& objects,
                           const Flaw flaw, const Drift& drift)
    : config_(config), setup_(config.srdos[slot]), objects_(objects), flaw_(flaw), drift_(drift)
{
}

ProducerRules ProducerSrdo::Rules(const bool is_level_2) const
{
    const std::uint32_t bits = BitsOf(objects_);
    ProducerRules rules;
    rules.delay_us = kDelayUs * config_.node_id;
    rules.refresh_us = kUsPerMs * objects_.sct_ms + ((flaw_ == Flaw::kRefreshDrifts) ? 1 : 0);
    rules.srvt_us = kUsPerMs * objects_.srvt_ms;
    rules.cob_id_1 = objects_.cob_id_1;
    rules.cob_id_2 = objects_.cob_id_2;
    rules.length_bytes = (bits + 7U) / 8U;
    rules.mask = MaskOf(bits);
    rules.is_called = IsCalled();
    rules.is_refresh_skipped = flaw_ == Flaw::kRefreshSkipped;
    rules.misses_standing = flaw_ == Flaw::kMissesStanding;
    rules.any_request_will_do = flaw_ == Flaw::kLateIsInTime;
    rules.late_cycle_us = Time{config_.cycle_us} + ((flaw_ == Flaw::kSilenceShorter) ? 0 : config_.cycle_tolerance_us);
    rules.late_cycle_us += (flaw_ == Flaw::kSilenceLonger) ? 1 : 0;
    rules.misses_halted =
        flaw_ == Flaw::kMissedInLevel2 || (flaw_ == Flaw::kEntersInLevel2 && is_level_2); // As OPERATIONAL is entered.
    return rules;
}

void ProducerSrdo::EnterOperational(const Time now, const bool is_level_2)
{
    a_.EnterOperational(Rules(is_level_2), now);
    b_.EnterOperational(Rules(is_level_2), drift_.ByB(now));
}

void ProducerSrdo::LeaveOperational()
{
    a_.LeaveOperational();
    b_.LeaveOperational();
    stands_a_ = false;
    stands_b_ = false;
}

bool ProducerSrdo::IsActive() const
{
    return a_.IsActive();
}

void ProducerSrdo::Request()
{
    a_.Request();
    b_.Request();
}

/// A pair starts when both channels call it due. Each channel's refresh runs by its own counter; where more of them
/// fell due by one counter, that one stands, and the pair waits for the other one. [semantics 6]
bool ProducerSrdo::Look(const Time now, const bool is_level_2)
{
    if (is_level_2)
    {
        a_.LookHalted(now);
        b_.LookHalted(drift_.ByB(now));
        return false;
    }
    a_.Look(now, stands_a_);
    b_.Look(drift_.ByB(now), stands_b_);
    const bool is_ahead_a = a_.Refreshes() > b_.Refreshes();
    const bool is_ahead_b = b_.Refreshes() > a_.Refreshes();
    const bool anything_stands = flaw_ != Flaw::kNothingStands;
    stands_a_ = is_ahead_a && anything_stands;
    stands_b_ = is_ahead_b && anything_stands;
    const bool waits = (is_ahead_a || is_ahead_b) && flaw_ != Flaw::kRequestAlone;
    return a_.IsDue() && b_.IsDue() && !waits;
}

std::optional<Sent> ProducerSrdo::Prepare(const Variables& variables, const Time now)
{
    const std::uint64_t normal = variables.ReadNormal(objects_);
    const std::uint64_t inverse = variables.ReadInverse(objects_);
    const bool is_sound_a = a_.Prepare(normal, inverse, now);
    const bool is_sound_b = b_.Prepare(normal, inverse, drift_.ByB(now));
    if (is_sound_a && is_sound_b)
    {
        return a_.Normal();
    }
    return std::nullopt;
}

Confirmed ProducerSrdo::Confirm(const Sent& frame, const Time stamp)
{
    const Confirmed by_a = a_.Confirm(frame, stamp);
    const Confirmed by_b = b_.Confirm(frame, drift_.ByB(stamp));
    if ((by_a == Confirmed::kNormal) != (by_b == Confirmed::kNormal))
    {
        // Too late for one channel alone: none for either.
        if (flaw_ != Flaw::kHalfConfirmed)
        {
            Fail(SrdoCause::kNoConfirmation);
        }
    }
    else if (by_a == by_b)
    {
        return by_a;
    }
    return Confirmed::kNothing;
}

Sent ProducerSrdo::Inverse() const
{
    return b_.Inverse();
}

void ProducerSrdo::Fail(const SrdoCause cause)
{
    a_.Fail(cause);
    b_.Fail(cause);
}

bool ProducerSrdo::IsCalled() const
{
    return setup_.form == ProducerForm::kProviderCalled;
}

Time ProducerSrdo::NextRefresh() const
{
    return a_.NextRefresh();
}

std::optional<Time> ProducerSrdo::SilentUntil() const
{
    if (setup_.form == ProducerForm::kApplicationSends && IsActive())
    {
        return a_.SilentUntil();
    }
    return std::nullopt;
}

std::set<SrdoCause> ProducerSrdo::TakeCauses()
{
    std::set<SrdoCause> causes = a_.TakeCauses();
    causes.merge(b_.TakeCauses());
    return causes;
}
} // namespace counterpoint::third_voice
