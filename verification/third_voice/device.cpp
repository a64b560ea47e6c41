// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/third_voice/device.hpp"

#include <algorithm>

namespace counterpoint::third_voice
{
namespace
{
SrdoMask BitOf(const std::ptrdiff_t slot)
{
    return SrdoMask{1U} << static_cast<unsigned>(slot);
}

constexpr Time kUsPerMs = 1000;
constexpr Time kDelayUs = 500; ///< Of the first transmission, for each node-ID.
constexpr std::uint32_t kGfcIdentifier = 1U;

std::uint64_t MaskOf(const std::uint32_t bits)
{
    return (bits >= 64U) ? ~std::uint64_t{0U} : ((std::uint64_t{1U} << bits) - 1U);
}
} // namespace

Device::Device(const DeviceConfig& config, const Flaw flaw, const Drift& drift)
    : config_(config), flaw_(flaw), drift_(drift), configuration_(config, flaw)
{
    for (std::size_t slot = 0U; slot < config.srdo_count; ++slot)
    {
        Srdo srdo;
        srdo.setup = &config.srdos[slot];
        srdo.objects = &configuration_.Objects(slot);
        srdos_.push_back(std::move(srdo));
    }
    for (std::size_t object = 0U; object < config.object_count; ++object)
    {
        variables_[{config.objects[object].index, config.objects[object].sub}] = 0U;
    }
}

void Device::Start(const std::vector<SrdoObjects>& objects, const std::uint32_t gfc_parameter)
{
    for (std::size_t slot = 0U; slot < objects.size(); ++slot)
    {
        configuration_.SetInitial(slot, objects[slot]);
    }
    configuration_.SetGfcParameter(gfc_parameter);
    configuration_.Start();
    called_.reset();
    has_sent_gfc_ = false;
    nmt_ = NmtState::kInitialising;
    is_running_ = false;
}

AbortCode Device::Write(const Address address, const std::uint64_t value, const std::size_t size)
{
    if (variables_.count(address) != 0U)
    {
        return AbortCode::kReadOnly;
    }
    const Written written = configuration_.Write(address, static_cast<std::uint32_t>(value), size, nmt_);
    for (const std::size_t slot : written.safe)
    {
        WriteSafe(srdos_[slot]);
    }
    return written.abort;
}

ConsumerRules Device::RulesOf(const Srdo& srdo) const
{
    const std::uint32_t bits = BitsOf(*srdo.objects);
    ConsumerRules rules;
    rules.sct_us = kUsPerMs * srdo.objects->sct_ms;
    rules.srvt_us = kUsPerMs * srdo.objects->srvt_ms;
    rules.sct_us += (flaw_ == Flaw::kSctLonger) ? 1 : 0;
    rules.srvt_us += (flaw_ == Flaw::kSrvtLonger) ? 1 : 0;
    rules.length_bytes = (bits + 7U) / 8U;
    rules.is_inversion_checked = flaw_ != Flaw::kNoInversion;
    rules.mask = MaskOf(bits);
    rules.is_late = srdo.setup->detection == SrvtDetection::kLate;
    rules.is_automatic = srdo.setup->policy == ReleasePolicy::kAutomatic;
    rules.acknowledge_window_us = config_.acknowledge_window_us;
    rules.is_one_reading_enough = flaw_ == Flaw::kEdgeAtOnce;
    rules.counts_behind_fault = flaw_ == Flaw::kBehindFault;
    return rules;
}

ProducerRules Device::SendingOf(const Srdo& srdo) const
{
    const std::uint32_t bits = BitsOf(*srdo.objects);
    ProducerRules rules;
    rules.delay_us = kDelayUs * config_.node_id;
    rules.refresh_us = kUsPerMs * srdo.objects->sct_ms + ((flaw_ == Flaw::kRefreshDrifts) ? 1 : 0);
    rules.srvt_us = kUsPerMs * srdo.objects->srvt_ms;
    rules.cob_id_1 = srdo.objects->cob_id_1;
    rules.cob_id_2 = srdo.objects->cob_id_2;
    rules.length_bytes = (bits + 7U) / 8U;
    rules.mask = MaskOf(bits);
    rules.is_called = srdo.setup->form == ProducerForm::kProviderCalled;
    rules.is_refresh_skipped = flaw_ == Flaw::kRefreshSkipped;
    rules.misses_standing = flaw_ == Flaw::kMissesStanding;
    rules.any_request_will_do = flaw_ == Flaw::kLateIsInTime;
    rules.late_cycle_us = Time{config_.cycle_us} + ((flaw_ == Flaw::kSilenceShorter) ? 0 : config_.cycle_tolerance_us);
    rules.late_cycle_us += (flaw_ == Flaw::kSilenceLonger) ? 1 : 0;
    rules.misses_halted =
        flaw_ == Flaw::kMissedInLevel2 || (flaw_ == Flaw::kEntersInLevel2 && is_level_2_); // As OPERATIONAL is entered.
    return rules;
}

void Device::SetNmt(const NmtState state)
{
    const bool leaves = nmt_ == NmtState::kOperational && state != NmtState::kOperational;
    nmt_ = state;
    if (leaves)
    {
        has_left_ = true;
        Leave();
    }
}

void Device::Leave()
{
    for (Srdo& srdo : srdos_)
    {
        if (is_running_ && srdo.objects->direction == kDirectionConsumer)
        {
            // In this very call, whatever follows. [semantics 4]
            srdo.has_left = true;
            if (flaw_ != Flaw::kKeepsReleased)
            {
                WriteSafe(srdo);
            }
        }
        srdo.is_released = false;
        srdo.observers[0].LeaveOperational();
        srdo.observers[1].LeaveOperational();
        srdo.producers[0].LeaveOperational();
        srdo.producers[1].LeaveOperational();
        srdo.stands = {};
    }
    is_running_ = false;
    has_entered_ = false;
}

/// With the first cycle behind the command.
void Device::Enter(const Time now)
{
    has_entered_ = true;
    const bool is_sound = configuration_.IsValid() && configuration_.IsAllSound();
    seen_.is_configuration_invalid = configuration_.IsValid() && !is_sound;
    is_running_ = is_sound;
    for (Srdo& srdo : srdos_)
    {
        if (is_sound && srdo.objects->direction == kDirectionConsumer)
        {
            srdo.observers[0].EnterOperational(RulesOf(srdo), now);
            srdo.observers[1].EnterOperational(RulesOf(srdo), now);
        }
        if (is_sound && srdo.objects->direction == kDirectionProducer)
        {
            srdo.producers[0].EnterOperational(SendingOf(srdo), now);
            srdo.producers[1].EnterOperational(SendingOf(srdo), drift_.ByB(now));
        }
    }
}

void Device::OnFrame(const CanFrame& frame, const Time stamp)
{
    if (nmt_ != NmtState::kOperational || frame.kind != FrameKind::kData)
    {
        return;
    }
    if (frame.identifier == kGfcIdentifier && frame.length_bytes == 0U && configuration_.IsGfcOn())
    {
        has_gfc_ = true; // Takes effect with the cycle.
        has_gfc_fault_ = is_running_;
        return;
    }
    const Bytes data(frame.data, frame.data + std::min<std::size_t>(frame.length_bytes, 8U));
    for (Srdo& srdo : srdos_)
    {
        for (Consumer& observer : srdo.observers)
        {
            if (frame.identifier == srdo.objects->cob_id_1)
            {
                observer.OnNormal(data, stamp);
            }
            else if (frame.identifier == srdo.objects->cob_id_2)
            {
                observer.OnInverse(data, stamp);
            }
        }
    }
}

void Device::WriteData(const Srdo& srdo, const std::uint64_t normal)
{
    std::uint32_t shift = 0U;
    for (std::size_t entry = 0U; entry + 1U < srdo.objects->count; entry += 2U)
    {
        const std::uint32_t bits = LengthOf(srdo.objects->entries[entry]);
        const std::uint64_t value = (normal >> shift) & MaskOf(bits);
        variables_[AddressOf(srdo.objects->entries[entry])] = value;
        variables_[AddressOf(srdo.objects->entries[entry + 1U])] = ~value & MaskOf(bits);
        shift += bits;
    }
}

void Device::WriteSafe(const Srdo& srdo)
{
    const Payload& safe = srdo.setup->safe_value;
    WriteData(srdo, (std::uint64_t{safe.high} << 32U) | safe.low);
}

/// Both observers have the pair; in level 2 that opens nothing, and the objects are safe. [semantics 4]
void Device::Release(Srdo& srdo)
{
    const Consumer& a = srdo.observers[0];
    if (is_level_2_)
    {
        srdo.is_released = false;
        if (flaw_ != Flaw::kKeepsInLevel2)
        {
            WriteSafe(srdo);
        }
        return;
    }
    if (!srdo.is_released || srdo.written_ordinal != a.Ordinal())
    {
        seen_.events.push_back(srdo.setup->number);
    }
    srdo.is_released = true;
    srdo.written_ordinal = a.Ordinal();
    WriteData(srdo, a.Data());
}

void Device::Decide(Srdo& srdo, const Time now)
{
    Consumer& a = srdo.observers[0];
    Consumer& b = srdo.observers[1];
    is_open_ = is_open_ || a.IsOpen(now) || b.IsOpen(now);
    // Whoever reports a fault makes both safe in this cycle; so does a release of one alone when the window is over.
    if (a.HasNewFault() != b.HasNewFault() || a.IsAloneTooLong() || b.IsAloneTooLong())
    {
        a.Demote();
        b.Demote();
    }
    a.Judge(now);
    b.Judge(now);
    const bool is_first = flaw_ == Flaw::kOneEdgeIsEnough;
    const bool is_given = (a.State() == SrdoState::kReleased && b.State() == SrdoState::kReleased) ||
                          (is_first && (a.State() == SrdoState::kReleased || b.State() == SrdoState::kReleased));
    if (is_given && a.Ordinal() == b.Ordinal() && a.Data() == b.Data())
    {
        a.Settle();
        b.Settle();
        Release(srdo);
    }
    else
    {
        srdo.is_released = false;
        WriteSafe(srdo);
    }
    a.EndCycle();
    b.EndCycle();
}

void Device::Cycle(const Time now, const SrdoMask acknowledge_a, const SrdoMask acknowledge_b)
{
    const bool is_shown_as_left = has_left_;
    has_left_ = false;
    if (nmt_ == NmtState::kOperational && !has_entered_ && !is_shown_as_left)
    {
        Enter(now);
    }
    const bool is_gfc = has_gfc_fault_ && is_running_;
    seen_.gfcs += has_gfc_ ? 1 : 0;
    has_gfc_ = false;
    has_gfc_fault_ = false;
    for (Srdo& srdo : srdos_)
    {
        const SrdoMask bit = BitOf(&srdo - srdos_.data());
        srdo.observers[0].LookAtAcknowledge((acknowledge_a & bit) != 0U, now);
        srdo.observers[1].LookAtAcknowledge((acknowledge_b & bit) != 0U, now);
        if (srdo.observers[0].IsActive())
        {
            srdo.observers[0].LookAtLimits(now);
            srdo.observers[1].LookAtLimits(now);
            if (is_gfc)
            {
                srdo.observers[0].Fail(SrdoCause::kGfc);
                srdo.observers[1].Fail(SrdoCause::kGfc);
            }
            srdo.observers[0].LookAtWaiting(now);
            srdo.observers[1].LookAtWaiting(now);
            Decide(srdo, now);
        }
        const bool is_due = srdo.producers[0].IsActive() && LookAtProducer(srdo, now);
        TellCauses(srdo, now);
        if (is_due)
        {
            Produce(srdo, now);
        }
    }
    seen_.faults += (is_level_2_ && !has_told_level_2_) ? 1 : 0;
    has_told_level_2_ = is_level_2_;
    LookAtGfc(now);
    called_ = now;
}

/// At most once per SCT (or refresh time) and cause. [semantics 2]
void Device::TellCauses(Srdo& srdo, const Time now)
{
    std::set<SrdoCause> causes = srdo.producers[0].TakeCauses();
    causes.merge(srdo.producers[1].TakeCauses());
    causes.merge(srdo.observers[0].TakeCauses());
    causes.merge(srdo.observers[1].TakeCauses());
    if (srdo.has_left)
    {
        causes.insert(SrdoCause::kNotOperational);
        srdo.has_left = false;
    }
    for (const SrdoCause cause : causes)
    {
        const auto told = srdo.told_at.find(cause);
        const Time window = (flaw_ == Flaw::kToldAlways) ? -1 : kUsPerMs * srdo.objects->sct_ms;
        if (told == srdo.told_at.end() || now - told->second > window)
        {
            srdo.told_at[cause] = now;
            seen_.signals.emplace_back(srdo.setup->number, cause);
        }
    }
}

// ---- producers

std::uint64_t Device::ReadSide(const Srdo& srdo, const std::size_t side) const
{
    std::uint64_t data = 0U;
    std::uint32_t shift = 0U;
    for (std::size_t entry = side; entry < srdo.objects->count; entry += 2U)
    {
        data |= variables_.at(AddressOf(srdo.objects->entries[entry])) << shift;
        shift += LengthOf(srdo.objects->entries[entry]);
    }
    return data;
}

/// A pair starts when both channels call it due. Each channel's refresh runs by its own counter; where more of them
/// fell due by one counter, that one stands, and the pair waits for the other one. [semantics 6]
bool Device::LookAtProducer(Srdo& srdo, const Time now)
{
    Producer& a = srdo.producers[0];
    Producer& b = srdo.producers[1];
    if (is_level_2_)
    {
        a.LookHalted(now);
        b.LookHalted(drift_.ByB(now));
        return false;
    }
    a.Look(now, srdo.stands[0]);
    b.Look(drift_.ByB(now), srdo.stands[1]);
    const bool is_ahead_a = a.Refreshes() > b.Refreshes();
    const bool is_ahead_b = b.Refreshes() > a.Refreshes();
    const bool anything_stands = flaw_ != Flaw::kNothingStands;
    srdo.stands = {is_ahead_a && anything_stands, is_ahead_b && anything_stands};
    const bool waits = (is_ahead_a || is_ahead_b) && flaw_ != Flaw::kRequestAlone;
    return a.IsDue() && b.IsDue() && !waits;
}

void Device::Produce(Srdo& srdo, const Time now)
{
    if (srdo.setup->form == ProducerForm::kProviderCalled)
    {
        seen_.refreshes.push_back(srdo.setup->number);
    }
    const std::uint64_t normal = ReadSide(srdo, 0U);
    const std::uint64_t inverse = ReadSide(srdo, 1U);
    const bool is_sound_a = srdo.producers[0].Prepare(normal, inverse, now);
    const bool is_sound_b = srdo.producers[1].Prepare(normal, inverse, drift_.ByB(now));
    if (is_sound_a && is_sound_b)
    {
        const bool is_taken = !refused_;
        HandOver(srdo, srdo.producers[0].Normal());
        has_sent_gfc_ = has_sent_gfc_ && !is_taken && flaw_ != Flaw::kGfcFollowed;
    }
}

/// Of the producers, 0 without one.
Time Device::ShortestRefresh() const
{
    Time shortest = 0;
    for (const Srdo& srdo : srdos_)
    {
        const Time refresh = kUsPerMs * srdo.objects->sct_ms;
        const bool is_shorter = shortest == 0 || refresh < shortest;
        if (srdo.objects->direction == kDirectionProducer && is_shorter)
        {
            shortest = refresh;
        }
    }
    return shortest;
}

bool Device::SendGfc()
{
    if (nmt_ != NmtState::kOperational || !configuration_.IsGfcOn() || is_level_2_)
    {
        return false;
    }
    seen_.frames.push_back({kGfcIdentifier, {}});
    if (!has_sent_gfc_ || flaw_ == Flaw::kGfcPutOff) // One that is sent again does not put the first one off.
    {
        follow_us_ = ShortestRefresh();
        gfc_at_ = called_;
    }
    has_sent_gfc_ = true;
    return true;
}

void Device::DemandSafeState()
{
    is_level_2_ = true;
}

bool Device::IsInLevel2() const
{
    return is_level_2_;
}

/// Behind the normal frames of this cycle.
void Device::LookAtGfc(const Time now)
{
    if (has_sent_gfc_ && !gfc_at_)
    {
        gfc_at_ = now - ((flaw_ == Flaw::kGfcFromCycle) ? 0 : Time{config_.cycle_us});
        follow_us_ = (flaw_ == Flaw::kGfcAtOnce) ? 0 : follow_us_;
    }
    if (has_sent_gfc_ && now - *gfc_at_ > follow_us_)
    {
        has_sent_gfc_ = false;
        ++seen_.unfollowed;
    }
}

/// To the controller, which may not take it.
void Device::HandOver(Srdo& srdo, const Sent& frame)
{
    seen_.frames.push_back(frame);
    if (refused_)
    {
        srdo.Fail(*refused_);
        refused_.reset();
    }
}

void Device::RefuseNext(const std::optional<SrdoCause> cause)
{
    refused_ = cause;
}

void Device::Put(const Address address, const std::uint64_t value)
{
    variables_.at(address) = value;
}

void Device::Send(const std::uint8_t number)
{
    if (is_level_2_)
    {
        return;
    }
    Srdo& srdo = srdos_[configuration_.SlotOf(number).value()];
    srdo.producers[0].Request();
    srdo.producers[1].Request();
}

void Device::OnConfirm(const Sent& frame, const Time stamp)
{
    for (Srdo& srdo : srdos_)
    {
        const Confirmed by_a = srdo.producers[0].Confirm(frame, stamp);
        const Confirmed by_b = srdo.producers[1].Confirm(frame, drift_.ByB(stamp));
        if ((by_a == Confirmed::kNormal) != (by_b == Confirmed::kNormal))
        {
            // Too late for one channel alone: none for either.
            if (flaw_ != Flaw::kHalfConfirmed)
            {
                srdo.Fail(SrdoCause::kNoConfirmation);
            }
        }
        else if (by_a == Confirmed::kNormal && (!is_level_2_ || flaw_ == Flaw::kSentInLevel2))
        {
            HandOver(srdo, srdo.producers[1].Inverse());
        }
        else if (by_a == Confirmed::kPair && by_b == Confirmed::kPair)
        {
            seen_.events.push_back(srdo.setup->number);
        }
    }
}

std::uint64_t Device::Variable(const Address address) const
{
    return variables_.at(address);
}

const Configuration& Device::Configured() const
{
    return configuration_;
}

SrdoState Device::StateOf(const std::uint8_t number) const
{
    const Srdo& srdo = srdos_[configuration_.SlotOf(number).value()];
    if (!is_running_ || srdo.objects->direction == 0U)
    {
        return SrdoState::kOff;
    }
    if (srdo.objects->direction == kDirectionProducer)
    {
        return SrdoState::kProducer;
    }
    const SrdoState a = srdo.observers[0].State();
    return (a == srdo.observers[1].State()) ? a : SrdoState::kFaulted; // While one waits for the other.
}

Time Device::NextRefresh(const std::uint8_t number) const
{
    return srdos_[configuration_.SlotOf(number).value()].producers[0].NextRefresh();
}

std::optional<Time> Device::SilenceEndsBetween(const Time first, const Time last) const
{
    for (const Srdo& srdo : srdos_)
    {
        const Time until = srdo.producers[0].SilentUntil();
        const bool is_sent = srdo.setup->form == ProducerForm::kApplicationSends && srdo.producers[0].IsActive();
        if (is_sent && until >= first && until <= last)
        {
            return until;
        }
    }
    return std::nullopt;
}

SrdoMask Device::Open() const
{
    SrdoMask open = 0U;
    for (const Srdo& srdo : srdos_)
    {
        open |= srdo.is_released ? BitOf(&srdo - srdos_.data()) : 0U;
    }
    return open;
}

bool Device::IsOpen() const
{
    return is_open_;
}

Seen Device::TakeSeen()
{
    Seen taken;
    std::swap(taken, seen_);
    return taken;
}
} // namespace counterpoint::third_voice
