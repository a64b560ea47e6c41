// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/twins/plain/channel.hpp"

#include "verification/twins/plain/point.hpp"

#include <algorithm>

namespace counterpoint::twins::plain
{

namespace
{
const Decision kTokenFits{"SRS_CFG_031", "the token fits"};
const Decision kIsConfigured{"SRS_CFG_031", "13FEh is A5h"};
const Number kGuardView{"SRS_CFG_031", "view of the guard"};
const Number kChallenge{"SRS_CFG_031", "challenge"};
const Number kToken{"SRS_CFG_031", "token that is expected"};
const Number kOwn{"SRS_CFG_031", "own copy of 13FEh"};
const Act kRotates{"SRS_CFG_031", "the challenge is rotated"};
const Act kInEach{"SRS_CFG_031", "13FEh in each of the four bytes"};
const Decision kNmt{"SRS_CONS_002", "NMT is OPERATIONAL"};
const Decision kConfigured{"SRS_CONS_002", "the guard is configured"};
const Decision kSound{"SRS_CONS_002", "the last check found no fault"};
const Decision kResolved{"SRS_CFG_003", "a slot is active after a Validate without fault"};
const Act kEnters{"SRS_CONS_002", "a sound SRDO becomes active"};
const Decision kWasOperational{"SRS_CONS_002", "OPERATIONAL was entered before"};
const Decision kKind{"SRS_CONS_001", "a data frame"};
const Decision kCandidateActive{"SRS_CONS_001", "the SRDO is active"};
const Decision kCandidateConsumer{"SRS_CONS_001", "the SRDO is a consumer"};
const Decision kCandidateOne{"SRS_CONS_001", "the identifier is COB-ID 1"};
const Decision kCandidateTwo{"SRS_CONS_001", "the identifier is COB-ID 2 of the SRDO"};
const Decision kGfcIdentifierIs{"SRS_CONS_017", "identifier 001h"};
const Decision kGfcLength{"SRS_CONS_017", "length 0"};
const Decision kGfcParameter{"SRS_CONS_017", "1300h is 1"};
const Decision kGfcOperational{"SRS_CONS_017", "SRDOs are active"};
const Decision kGfcKind{"SRS_CONS_017", "a data frame"};
const Act kGfcKept{"SRS_CONS_017", "a GFC is kept for the next OnCycle"};
const Act kGfcOnce{"SRS_CONS_017", "a GFC is raised by one OnCycle"};
const Number kOne{"SRS_CONS_017", "value of 1300h"};
const Limit kLateLimit{"SRS_CONS_015", "time of the call"};
const Both kLateWith{"SRS_CONS_015", "above the limit, and not the first"};
const Number kLateUs{"SRS_CONS_015", "length of the time of the call"};
const Act kLateCycle{"SRS_CONS_015", "the cycle counts"};
const Act kLateTolerance{"SRS_CONS_015", "the tolerance counts"};
const Decision kFirstNever{"SRS_CONS_015", "the first OnCycle is never late"};
const Decision kLateOperational{"SRS_CONS_015", "a late call while SRDOs are active"};
const Number kPrevious{"SRS_CONS_015", "instant of the previous OnCycle"};
const Decision kIntact{"SRS_CONS_016", "the queue is intact"};
const Number kNumber{"SRS_CONS_023", "number of the cycle"};
const Decision kReleased{"SRS_CONS_023", "in released"};
const Decision kFaulted{"SRS_CONS_023", "in faulted"};
const Decision kWaiting{"SRS_CONS_023", "in waiting"};
const Decision kNewFault{"SRS_CONS_023", "in new_fault"};
const Decision kFresh{"SRS_CONS_023", "in fresh"};
const Decision kSignalled{"SRS_CONS_021", "in signalled"};
const Decision kDue{"SRS_PROD_004", "in due"};
const Decision kInRefresh{"SRS_PROD_013", "in refresh"};
const Act kFreshOnce{"SRS_CONS_023", "a pair is fresh in one OnCycle"};
const Act kSignalsGone{"SRS_CONS_021", "signals of the previous OnCycle are gone"};
const Act kSums{"SRS_CONS_023", "ordinals are summed up"};
const Number kOrdinal{"SRS_CONS_023", "ordinal in the sum"};
const Act kCountsConsumers{"SRS_CONS_023", "active consumers are counted"};
const Act kCountsProducers{"SRS_CONS_023", "active producers are counted"};
const Act kCountsOthers{"SRS_CONS_023", "the other SRDOs are counted"};
const Act kNotOperational{"SRS_CONS_023", "not_operational is told"};
const Act kLeftFault{"SRS_CONS_023", "new_fault with kNotOperational too"};
const Act kHeldData{"SRS_CONS_025", "data of the held pair"};
const Act kSentData{"SRS_CONS_025", "data of the pair in flight"};
const Number kViewOrdinal{"SRS_CONS_025", "ordinal of a consumer"};
const Number kViewSent{"SRS_CONS_025", "ordinal of a producer"};
const Decision kViewHolds{"SRS_CONS_025", "holds_pair of a consumer"};
const Decision kHeldHolds{"SRS_CONS_025", "Held of an active consumer"};
const Decision kViewRole{"SRS_CONS_025", "a consumer's view"};
const Decision kViewFlight{"SRS_CONS_025", "a pair in flight"};
const Decision kPermits{"SRS_REL_010", "SRDOs are active"};
const Decision kPermitsCommitted{"SRS_REL_010", "the slot is committed"};
const Decision kPermitsAsWritten{"SRS_REL_010", "the last Commit found the slot as it was written"};
const Decision kPermitsOnce{"SRS_REL_010", "there was a Commit since the last OnCycle"};
const Decision kPermitsOld{"SRS_REL_010", "a Commit counts behind the next OnCycle"};
const Decision kExamined{"SRS_REL_011", "the slot is examined"};
const Decision kFound{"SRS_REL_011", "the slot is not as it was written"};
const Number kPermitMask{"SRS_REL_010", "mask of the permit"};
const Act kPermitLow{"SRS_REL_010", "bits 0 to 31 of the mask"};
const Act kPermitHigh{"SRS_REL_010", "bits 32 to 63 of the mask"};
const Act kPermitRotated{"SRS_REL_010", "rotated by 16"};
const Act kPermitConstant{"SRS_REL_010", "constant of the party"};
const Act kPermitChallenge{"SRS_REL_010", "the challenge"};
const Decision kStaticFields{"SRS_CFG_032", "fields of a static mapping"};
const Act kFieldsUnresolve{"SRS_CFG_032", "registering makes the mapping unresolved"};
const Act kFieldsKept{"SRS_CFG_032", "the fields are kept"};
const Act kFieldNormal{"SRS_CFG_032", "the normal field is kept"};
const Act kFieldInverse{"SRS_CFG_032", "the inverse field is kept"};
const Place kFieldsSlot{"SRS_CFG_032", "slot of SetFields"};
const Place kDigestSlot{"SRS_CFG_034", "slot of Digest"};
const Place kValidateSlot{"SRS_CFG_020", "slot of Validate"};
const Place kRecheckSlot{"SRS_CFG_030", "slot of Recheck"};
const Place kHeldSlot{"SRS_CONS_025", "slot of Held"};
const Place kViewSlot{"SRS_CONS_025", "slot of View"};
const Place kDemoteSlot{"SRS_REL_006", "slot of Demote"};
const Place kPrepareSlot{"SRS_PROD_005", "slot of Prepare"};
const Place kInverseSlot{"SRS_PROD_006", "slot of InverseFrame"};
const Place kFaultSlot{"SRS_PROD_009", "slot of OnTransmitFault"};
const Place kConfirmSlot{"SRS_PROD_007", "slot that a confirmation names"};
const Act kRestartState{"SRS_CFG_002", "Restart begins with nothing"};
const Act kRestartConfiguration{"SRS_CFG_002", "Restart sets the power-on configuration"};
const Act kRestartValid{"SRS_CFG_002", "13FEh is 0 after Restart"};
const Act kRestartGfc{"SRS_CFG_002", "1300h is 0 after Restart"};

const Number kStale{"SRS_CFG_031", "kStale"};
const Number kConfiguredView{"SRS_CFG_031", "kConfigured"};
const Number kUnconfiguredView{"SRS_CFG_031", "kUnconfigured"};
const Both kOperationalBoth{"SRS_CONS_002", "OPERATIONAL, and configured"};
const Number kSrdos{"SRS_CFG_002", "number of SRDOs"};
const Decision kLevelFirst{"SRS_REL_005", "the level before the first OnCycle counts as 1"};
const Decision kBitFirst{"SRS_REL_005", "the bit before the first OnCycle counts as 1"};
const Decision kButtonFirst{"SRS_REL_005", "level and bit before the first OnCycle count as 1"};
const Act kEntriesFirst{"SRS_CFG_002", "map entries are 0 after Restart"};
const Act kFieldsFirst{"SRS_CFG_032", "no field is registered after Restart"};
const Decision kNewFaultActive{"SRS_CONS_023", "new_fault of an active consumer"};
const Act kToldSignals{"SRS_CONS_021", "signals are told"};
const Act kAnySignals{"SRS_CONS_021", "what happened is signalled"};
const Number kByCopy{"SRS_CFG_031", "view of a guard whose token fits"};
const Place kDemotedRecord{"SRS_REL_006", "slot that is demoted"};
const Place kFieldsKeptSlot{"SRS_CFG_032", "slot whose fields are kept"};
const Place kFieldsUnresolvedSlot{"SRS_CFG_032", "slot that registering makes unresolved"};
const Place kDemotedSlot{"SRS_REL_006", "slot of which a demotion is counted"};
const Decision kFrameKind{"SRS_CONS_001", "a frame is a data frame"};
const Number kStepNormal{"SRS_PROD_007", "step told of the normal frame"};
const Number kStepPair{"SRS_PROD_007", "step told of the pair"};
const Each kFramesEach{"SRS_CONS_001", "SRDOs that a frame is looked up in"};
const Each kConfirmEach{"SRS_PROD_007", "SRDOs that a confirmation is looked up in"};
const Difference kOthers{"SRS_CONS_023", "SRDOs that are not active"};
const Lesser kSrdoRoom{"SRS_CFG_003", "SRDOs of the device, and room for SRDOs"};
const Place kEntriesOf{"SRS_CFG_003", "slot with the map entries of an SRDO"};
const Place kReadBackOf{"SRS_REL_011", "slot whose objects are read back"};
const Number kPermitRotation{"SRS_REL_010", "bits of the rotation"};
const Number kPermitUpper{"SRS_REL_010", "first bit of the upper half of the mask"};
const Number kPermitNone{"SRS_REL_010", "mask while SRDOs are not active"};
const Sum kPermitSum{"SRS_REL_010", "challenge and mask"};
const ExclusiveOr kPermitOf{"SRS_REL_010", "challenge and mask, XOR the upper half of the mask"};
const Counter kCycleUp{"SRS_CONS_023", "number of OnCycle calls"};
const Decision kGfcNext{"SRS_CONS_017", "a GFC waits behind an OnCycle"};
const Number kDigestFirstSlot{"SRS_CFG_034", "slot with the device's part"};
const Sum kLateSum{"SRS_CONS_015", "cycle and tolerance"};
const Place kConfirmRecord{"SRS_PROD_007", "slot of a confirmation"};
const Place kNormalSlot{"SRS_PROD_007", "slot told with kNormal"};
const Place kPairSlot{"SRS_PROD_007", "slot told with kPair"};
const Act kNormalTold{"SRS_PROD_007", "a confirmed normal frame is told"};
const Act kPairTold{"SRS_PROD_007", "a confirmed pair is told"};

bool IsBit(SrdoMask mask, SlotIndex slot) noexcept
{
    return ((mask >> slot) & 1U) != 0U;
}

SrdoMask BitOf(SlotIndex slot, bool is_set) noexcept
{
    return is_set ? (SrdoMask{1U} << slot) : SrdoMask{0U};
}
} // namespace

void PlainChannel::Restart(const DeviceConfig& config) noexcept
{
    Common fresh{};
    fresh.side = common_.side;
    fresh.configuration_valid = kRestartValid() ? std::uint8_t{0U} : common_.configuration_valid;
    fresh.gfc_parameter = kRestartGfc() ? std::uint8_t{0U} : common_.gfc_parameter;
    common_ = fresh;
    common_.config = config;
    const std::uint32_t count = kSrdoRoom(config.srdo_count, kMaxSrdoCount);
    common_.config.srdo_count = static_cast<std::uint8_t>(std::min<std::uint32_t>(kSrdos(count), kMaxSrdoCount));
    for (SlotIndex slot = 0U; slot < kMaxSrdoCount; ++slot)
    {
        const Stored stored = records_[slot].stored;
        const StaticFields fields = records_[slot].fields;
        if (kRestartState())
        {
            records_[slot] = Record{};
        }
        records_[slot].stored = stored;
        const bool is_button = kButtonFirst(true);
        records_[slot].button.level = is_button && kLevelFirst(true);
        records_[slot].button.bit = is_button && kBitFirst(true);
        records_[slot].fields = kFieldsFirst() ? StaticFields{} : fields;
        records_[slot].entries = records_[kEntriesOf(slot)].stored.entries;
        if (slot < count)
        {
            records_[slot].setup = (slot < config.srdo_count) ? config.srdos[slot] : SrdoSetup{};
            if (kRestartConfiguration())
            {
                SetDefaults(config, records_[slot]);
            }
            for (std::uint32_t i = 0U; (i < kMaxMapEntries) && (!kEntriesFirst()); ++i)
            {
                records_[slot].entries[i] = stored.entries[i];
            }
        }
    }
}

void PlainChannel::Store(const ConfigItem& item) noexcept
{
    plain::Store(common_, records_, item);
}

ConfigItem PlainChannel::Load(const ConfigAddress& address) const noexcept
{
    return ConfigItem{address, plain::Load(common_, records_, address)};
}

ChannelRoom PlainChannel::Room() const noexcept
{
    return ChannelRoom{kMaxSrdoCount, kMaxMapEntries};
}

void PlainChannel::SetFields(SlotIndex slot, const StaticFields& fields) noexcept
{
    Record& record = records_[kFieldsSlot(slot)];
    if (!kStaticFields(record.setup.map.entries != nullptr))
    {
        return;
    }
    if (kFieldsKept())
    {
        StaticFields& kept = records_[kFieldsKeptSlot(kFieldsSlot(slot))].fields;
        kept.normal = kFieldNormal() ? fields.normal : kept.normal;
        kept.inverse = kFieldInverse() ? fields.inverse : kept.inverse;
    }
    Record& unresolved = records_[kFieldsUnresolvedSlot(kFieldsSlot(slot))];
    unresolved.is_resolved = unresolved.is_resolved && (!kFieldsUnresolve());
    unresolved.is_sound = unresolved.is_sound && (!kFieldsUnresolve());
}

DeviceDigest PlainChannel::Digest(SlotIndex slot, DeviceDigest before) const noexcept
{
    return DeviceDigest{
        DigestOf(common_, records_[kDigestSlot(slot)], slot == kDigestFirstSlot(SlotIndex{0U}), before.value)};
}

CheckResult PlainChannel::Validate(SlotIndex slot) noexcept
{
    return ValidateRecord(common_, records_, kValidateSlot(slot));
}

CheckResult PlainChannel::Recheck(SlotIndex slot) noexcept
{
    return RecheckRecord(common_, records_[kRecheckSlot(slot)]);
}

void PlainChannel::OnFrame(const CanFrame& frame, Instant stamp) noexcept
{
    const bool is_data = kFrameKind(frame.kind == FrameKind::kData);
    const bool is_gfc = kGfcKind(is_data) && kGfcIdentifierIs(frame.identifier == kGfcIdentifier) &&
                        kGfcLength(frame.length_bytes == 0U);
    if (is_gfc && kGfcParameter(common_.gfc_parameter == kOne(1U)) && kGfcOperational(common_.is_operational))
    {
        common_.has_gfc = kGfcKept() || common_.has_gfc;
    }
    if (!kKind(is_data))
    {
        return;
    }
    Record* ours = nullptr; // An identifier in use twice is refused, so that there is one at most.
    for (SlotIndex slot = 0U; slot < common_.config.srdo_count; ++slot)
    {
        Record& record = records_[slot];
        const bool is_ours = kCandidateOne(frame.identifier == record.stored.cob_id_1) ||
                             kCandidateTwo(frame.identifier == record.stored.cob_id_2);
        if (kCandidateActive(record.is_active) && is_ours && kFramesEach(slot))
        {
            ours = &record;
        }
    }
    if ((ours != nullptr) && kCandidateConsumer(IsConsumer(*ours)))
    {
        TakeFrame(common_, *ours, frame, stamp.us);
    }
}

GuardView PlainChannel::LookAtGuard(const CycleInput& input) const noexcept
{
    const std::uint32_t challenge = kChallenge(input.challenge);
    const std::uint32_t rotated = kRotates() ? ((challenge << 8U) | (challenge >> 24U)) : challenge;
    const std::uint8_t own = kOwn(common_.configuration_valid);
    const std::uint32_t expected = kToken(rotated ^ (kInEach() ? (own * 0x01010101U) : own));
    if (!kTokenFits(input.guard_token == expected))
    {
        return kGuardView(kStale(GuardView::kStale));
    }
    const bool is_valid = kIsConfigured(common_.configuration_valid == kConfigurationValidValue);
    const GuardView view =
        is_valid ? kConfiguredView(GuardView::kConfigured) : kUnconfiguredView(GuardView::kUnconfigured);
    return kGuardView(kByCopy(view));
}

void PlainChannel::Enter(Record& record) noexcept
{
    const bool is_on = IsConsumer(record) || IsProducer(record);
    if ((!is_on) || (!kSound(record.is_sound)) || (!kResolved(record.is_resolved)) || (!kEnters()))
    {
        return;
    }
    record.is_active = true;
    if (IsConsumer(record))
    {
        EnterConsumer(record, common_.now_us);
    }
    else
    {
        EnterProducer(common_, record);
    }
}

void PlainChannel::Leave(Record& record) noexcept
{
    if (!record.is_active)
    {
        return;
    }
    if (IsConsumer(record))
    {
        LeaveConsumer(record);
    }
    else
    {
        LeaveProducer(record);
    }
    record.is_active = false;
    record.button.is_waiting = false;
}

void PlainChannel::CycleOne(SlotIndex slot, const CycleInput& input, bool is_late, bool was_operational) noexcept
{
    Record& record = records_[slot];
    record.is_fault_reported = false;
    const bool was_active = record.is_active;
    if (!common_.is_operational)
    {
        Leave(record);
    }
    else if (!kWasOperational(was_operational))
    {
        Enter(record);
    }
    FollowButton(common_, record, IsBit(input.acknowledge, slot));
    if (record.is_active && IsConsumer(record))
    {
        CycleConsumer(common_, record, is_late, !kIntact(input.queue == QueueState::kIntact));
    }
    else if (record.is_active)
    {
        CycleProducer(common_, records_, input, slot, was_active);
    }
    else
    {
        record.is_fault_reported = record.has_fault && kLeftFault();
        record.has_fault = false;
    }
}

void PlainChannel::Tell(SlotIndex slot, CycleOutcome& outcome) noexcept
{
    Record& record = records_[slot];
    const bool is_consumer = record.is_active && IsConsumer(record);
    const bool is_producer = record.is_active && IsProducer(record);
    const std::uint32_t recorded = kAnySignals() ? (record.recorded | (kSignalsGone() ? 0U : record.told)) : 0U;
    record.told = kToldSignals() ? recorded : record.told;
    record.recorded = 0U;
    outcome.released |= BitOf(slot, kReleased(is_consumer && (record.state == SrdoState::kReleased)));
    outcome.faulted |= BitOf(slot, kFaulted(is_consumer && (record.state == SrdoState::kFaulted)));
    outcome.waiting |= BitOf(slot, kWaiting(is_consumer && (record.state == SrdoState::kWaiting)));
    const bool is_new = IsConsumer(record) && record.is_fault_reported && (!is_producer);
    outcome.new_fault |= BitOf(slot, kNewFault(is_new && (kNewFaultActive(true) || (!is_consumer))));
    outcome.fresh |= BitOf(slot, kFresh(is_consumer && record.reception.is_fresh));
    outcome.signalled |= BitOf(slot, kSignalled(recorded != 0U));
    outcome.due |= BitOf(slot, kDue(is_producer && IsDue(common_, record)));
    outcome.refresh |= BitOf(slot, kInRefresh(is_producer && IsRefreshWaiting(record)));
    record.reception.is_fresh = record.reception.is_fresh && (!kFreshOnce());
    if (common_.is_operational)
    {
        outcome.ordinal_sum += (is_consumer && kSums()) ? kOrdinal(record.reception.ordinal) : 0U;
        outcome.sct_checked =
            static_cast<std::uint8_t>(outcome.sct_checked + ((is_consumer && kCountsConsumers()) ? 1U : 0U));
        outcome.is_tx = static_cast<std::uint8_t>(outcome.is_tx + ((is_producer && kCountsProducers()) ? 1U : 0U));
        outcome.is_invalid =
            static_cast<std::uint8_t>(outcome.is_invalid + (((!record.is_active) && kCountsOthers()) ? 1U : 0U));
    }
}

CycleOutcome PlainChannel::OnCycle(const CycleInput& input) noexcept
{
    CycleOutcome outcome{};
    outcome.guard = LookAtGuard(input);
    common_.has_committed = kPermitsOld(false);
    const bool was_operational = common_.is_operational;
    common_.is_operational = kOperationalBoth(kNmt(input.nmt == NmtState::kOperational),
                                              kConfigured(outcome.guard == GuardView::kConfigured));
    common_.previous_us = common_.now_us;
    common_.now_us = input.now.us;
    common_.cycle = kNumber(kCycleUp(common_.cycle));
    outcome.cycle = common_.cycle;
    const std::uint32_t tolerance_us = kLateTolerance() ? common_.config.cycle_tolerance_us : 0U;
    const std::uint32_t cycle_us = kLateCycle() ? common_.config.cycle_us : 0U;
    const std::uint32_t limit_us = kLateSum(cycle_us, tolerance_us);
    const bool is_long = kLateLimit(common_.now_us, kPrevious(common_.previous_us), kLateUs(limit_us));
    const bool is_late = kLateWith(is_long, kFirstNever(common_.has_cycled)) && kLateOperational(true);
    common_.has_cycled = true;
    for (SlotIndex slot = 0U; slot < common_.config.srdo_count; ++slot)
    {
        CycleOne(slot, input, is_late, was_operational);
        Tell(slot, outcome);
    }
    if (common_.is_operational)
    {
        const std::uint32_t active = static_cast<std::uint32_t>(outcome.sct_checked) + outcome.is_tx;
        const std::uint32_t all = outcome.is_invalid + active;
        outcome.is_invalid = static_cast<std::uint8_t>(kOthers(all, active));
    }
    common_.has_gfc = kGfcNext(common_.has_gfc && (!kGfcOnce()));
    outcome.not_operational = ((!common_.is_operational) && kNotOperational()) ? 1U : 0U;
    return outcome;
}

HeldPair PlainChannel::Held(SlotIndex slot) const noexcept
{
    const Record& record = records_[kHeldSlot(slot)];
    HeldPair held{};
    if (kHeldHolds(record.is_active && IsConsumer(record)))
    {
        const Reception& at = record.reception;
        held.data = (kHeldData() && at.is_held) ? PayloadOf(at.held) : Payload{};
        held.ordinal = kViewOrdinal(at.ordinal);
        held.holds_pair = kViewHolds(at.is_held) ? 1U : 0U;
    }
    return held;
}

SrdoView PlainChannel::View(SlotIndex slot) const noexcept
{
    const Record& record = records_[kViewSlot(slot)];
    SrdoView view{};
    view.signals = record.told;
    view.error_count = record.errors;
    view.state = record.state;
    view.first_cause = record.cause;
    if (kViewRole(record.state == SrdoState::kProducer))
    {
        const Transmission& to = record.transmission;
        view.data = (kSentData() && kViewFlight(to.is_in_flight)) ? PayloadOf(to.sent) : Payload{};
        view.ordinal = kViewSent(to.ordinal);
    }
    else
    {
        const Reception& at = record.reception;
        view.data = (kHeldData() && at.is_held) ? PayloadOf(at.held) : Payload{};
        view.ordinal = kViewOrdinal(at.ordinal);
        view.holds_pair = kViewHolds(at.is_held) ? 1U : 0U;
    }
    return view;
}

void PlainChannel::Demote(SlotIndex slot) noexcept
{
    const SlotIndex demoted = kDemotedRecord(slot);
    DemoteConsumer(records_[kDemoteSlot(slot)], records_[kDemoteSlot(demoted)],
                   records_[kDemoteSlot(kDemotedSlot(demoted))]);
}

SrdoMask PlainChannel::Commit(const Agreement& agreement, SrdoMask examine) noexcept
{
    bool is_written[kMaxSrdoCount]{};
    for (SlotIndex slot = 0U; slot < common_.config.srdo_count; ++slot)
    {
        is_written[slot] =
            CommitConsumer(common_, records_[slot], IsBit(agreement.agreed, slot), IsBit(agreement.matched, slot));
    }
    SrdoMask found = 0U;
    for (SlotIndex slot = 0U; slot < common_.config.srdo_count; ++slot)
    {
        Record& record = records_[slot];
        record.is_otherwise =
            ReadBack(common_, record, records_[kReadBackOf(slot)], is_written[slot], kExamined(IsBit(examine, slot)));
        found |= BitOf(slot, kFound(record.is_otherwise));
    }
    common_.has_committed = true;
    return found;
}

Permit PlainChannel::Answer(std::uint32_t challenge) const noexcept
{
    Permit permit{};
    for (SlotIndex slot = 0U; slot < common_.config.srdo_count; ++slot)
    {
        const bool is_as_written = kPermitsAsWritten(!records_[slot].is_otherwise);
        const bool is_permitted = kPermitsCommitted(records_[slot].is_committed) && is_as_written;
        permit.mask |=
            BitOf(slot, is_permitted && kPermits(common_.is_operational) && kPermitsOnce(common_.has_committed));
    }
    permit.mask = kPermitMask(common_.is_operational ? permit.mask : kPermitNone(permit.mask));
    const std::uint32_t low = kPermitLow() ? static_cast<std::uint32_t>(permit.mask) : 0U;
    const std::uint32_t high = kPermitHigh() ? static_cast<std::uint32_t>(permit.mask >> kPermitUpper(32U)) : 0U;
    const std::uint32_t bits = kPermitRotation(16U) & 0x1FU;
    const std::uint32_t rotated = kPermitRotated() ? ((high << bits) | (high >> (32U - bits))) : high;
    const std::uint32_t constant = (common_.side == Side::kNormal) ? kPermitConstantA : kPermitConstantB;
    const std::uint32_t sum = kPermitSum(kPermitChallenge() ? challenge : 0U, low);
    permit.response = kPermitOf(sum, rotated) * (kPermitConstant() ? constant : 1U);
    return permit;
}

PreparedPair PlainChannel::Prepare(SlotIndex slot) noexcept
{
    return PreparePair(common_, records_[kPrepareSlot(slot)]);
}

/// Whether an active SRDO of a higher slot has the identifier too, which no configuration that is accepted has.
bool PlainChannel::IsAnotherBehind(SlotIndex slot, std::uint32_t identifier) const noexcept
{
    bool is_behind = false;
    for (std::uint32_t other = slot + 1U; other < common_.config.srdo_count; ++other)
    {
        const Stored& stored = records_[other].stored;
        is_behind = is_behind ||
                    (records_[other].is_active && ((stored.cob_id_1 == identifier) || (stored.cob_id_2 == identifier)));
    }
    return is_behind;
}

Confirmation PlainChannel::OnConfirm(const CanFrame& frame, Instant stamp) noexcept
{
    for (SlotIndex slot = 0U; slot < common_.config.srdo_count; ++slot)
    {
        if ((!kConfirmEach(slot)) || IsAnotherBehind(slot, frame.identifier))
        {
            continue;
        }
        const ConfirmStep step = Confirm(records_[kConfirmRecord(slot)], frame, stamp.us);
        if (step != ConfirmStep::kNone)
        {
            const bool is_normal = step == ConfirmStep::kNormal;
            const SlotIndex told = is_normal ? kNormalSlot(slot) : kPairSlot(slot);
            const ConfirmStep say = is_normal ? kStepNormal(step) : kStepPair(step);
            return (is_normal ? kNormalTold() : kPairTold()) ? Confirmation{kConfirmSlot(told), say} : Confirmation{};
        }
    }
    return Confirmation{kNoSlot, ConfirmStep::kNone};
}

CanFrame PlainChannel::InverseFrame(SlotIndex slot) const noexcept
{
    return InverseOf(common_, records_[kInverseSlot(slot)]);
}

void PlainChannel::OnTransmitFault(SlotIndex slot, const TransmitFault& fault) noexcept
{
    FailTransmission(records_[kFaultSlot(slot)], fault.cause);
}

} // namespace counterpoint::twins::plain
