// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// A producer, as the requirements SRS_PROD say it.
#include "verification/twins/plain/point.hpp"
#include "verification/twins/plain/record.hpp"

#include <algorithm>
#include <iterator>

namespace counterpoint::twins::plain
{

namespace
{
const Number kStep{"SRS_PROD_001", "0.5 ms"};
const Number kNodeId{"SRS_PROD_001", "node-ID"};
const Decision kDelayOver{"SRS_PROD_001", "the initial delay is over"};
const Act kDelayReached{"SRS_PROD_001", "the instant itself counts"};
const Number kDelay{"SRS_PROD_001", "initial delay"};
const Number kEntered{"SRS_PROD_001", "instant of entering OPERATIONAL"};
const Decision kProvider{"SRS_PROD_002", "the provider is called"};
const Decision kRefreshReached{"SRS_PROD_002", "the instant of the refresh is reached"};
const Act kRefreshEqual{"SRS_PROD_002", "the instant of the refresh itself counts"};
const Act kRefreshDue{"SRS_PROD_002", "a refresh makes due"};
const Milliseconds kPeriod{"SRS_PROD_002", "refresh time, in microseconds"};
const Number kPeriodMs{"SRS_PROD_002", "refresh time"};
const Act kPhase{"SRS_PROD_002", "the refresh goes on"};
const Act kExactPhase{"SRS_PROD_002", "exact addition, whatever the jitter"};
const Act kFirstRefresh{"SRS_PROD_002", "the first refresh is at the initial delay"};
const Act kRequests{"SRS_PROD_003", "a request counts"};
const Either kRequestsTogether{"SRS_PROD_003", "a request of this call, or one that waits"};
const Decision kDueRequest{"SRS_PROD_003", "a request makes due"};
const Decision kDueInFlight{"SRS_PROD_004", "no pair is in flight"};
const Decision kDueRefresh{"SRS_PROD_004", "a refresh makes due until Prepare"};
const Decision kPrepares{"SRS_PROD_005", "an active producer"};
const Decision kPreparesIdle{"SRS_PROD_005", "without a pair in flight"};
const Act kUsesRefresh{"SRS_PROD_005", "Prepare uses up the refresh"};
const Act kUsesRequest{"SRS_PROD_005", "Prepare uses up the request"};
const Number kIdentifier1{"SRS_PROD_005", "identifier of the normal frame"};
const Number kIdentifier2{"SRS_PROD_006", "identifier of the inverse frame"};
const Number kPort1{"SRS_PROD_005", "controller of the normal frame"};
const Number kPort2{"SRS_PROD_006", "controller of the inverse frame"};
const Number kLength1{"SRS_PROD_005", "length of the normal frame"};
const Number kLength2{"SRS_PROD_006", "length of the inverse frame"};
const Act kKind1{"SRS_PROD_005", "kind of the normal frame"};
const Act kKind2{"SRS_PROD_006", "kind of the inverse frame"};
const Act kData1{"SRS_PROD_005", "data of the normal frame"};
const Act kData2{"SRS_PROD_006", "data of the inverse frame"};
const Act kComplement{"SRS_PROD_006", "the complement"};
const Decision kAboveIsOne{"SRS_PROD_006", "bits above the mapped length are 1"};
const Act kGoesInFlight{"SRS_PROD_006", "a ready Prepare puts a pair in flight"};
const Number kSince{"SRS_PROD_006", "instant of the pair in flight"};
const Decision kInverseAwaited{"SRS_PROD_006", "the inverse frame is awaited"};
const Decision kInverseInFlight{"SRS_PROD_006", "the pair is in flight"};
const Decision kConfirmInFlight{"SRS_PROD_007", "a pair is in flight"};
const Decision kConfirmKind{"SRS_PROD_007", "a data frame"};
const Decision kConfirmAwaited{"SRS_PROD_007", "the identifier is the awaited one"};
const Decision kConfirmInverse{"SRS_PROD_007", "the inverse frame is the awaited one"};
const Decision kEchoLength{"SRS_PROD_007", "the length is the expected one"};
const Decision kEchoData{"SRS_PROD_007", "the data are the expected ones"};
const Act kEchoFirst{"SRS_PROD_007", "the first byte is compared"};
const Act kEchoLast{"SRS_PROD_007", "the last byte is compared"};
const Act kEchoFault{"SRS_PROD_007", "a wrong echo is a fault"};
const Act kAwaitsInverse{"SRS_PROD_007", "the inverse frame becomes the awaited one"};
const Number kSent{"SRS_PROD_007", "the number of pairs sent"};
const Act kPairOver{"SRS_PROD_007", "after a pair nothing is in flight"};
const Number kReplyNormal{"SRS_PROD_007", "reply to the normal frame"};
const Number kReplyPair{"SRS_PROD_007", "reply to the inverse frame"};
const Milliseconds kSrvtOfCycle{"SRS_PROD_008", "SRVT in the cycle, in microseconds"};
const Milliseconds kSrvtOfConfirm{"SRS_PROD_008", "SRVT of a confirmation, in microseconds"};
const Milliseconds kSrvtOfBoth{"SRS_PROD_008", "SRVT, in microseconds"};
const Limit kNoConfirmInCycle{"SRS_PROD_008", "SRVT in the cycle"};
const Limit kNoConfirmAtFrame{"SRS_PROD_008", "SRVT of a confirmation"};
const Limit kNoConfirmAny{"SRS_PROD_008", "SRVT"};
const Act kConfirmStamp{"SRS_PROD_008", "SRVT counts from the confirmation of the normal frame"};
const Act kNoConfirmFault{"SRS_PROD_008", "no confirmation in the cycle is a fault"};
const Act kNoConfirmFaultFrame{"SRS_PROD_008", "a confirmation too late is a fault"};
const Decision kNoConfirmInFlight{"SRS_PROD_008", "a frame is awaited"};
const Act kBeforeRefresh{"SRS_PROD_008", "examined before the refresh"};
const Decision kFailInFlight{"SRS_PROD_009", "a pair is in flight"};
const Decision kFailCause{"SRS_PROD_009", "a cause of a failed transmission"};
const Decision kFailQueue{"SRS_PROD_009", "kTransmitQueue"};
const Decision kFailBusOff{"SRS_PROD_009", "kBusOff"};
const Decision kFailInverse{"SRS_PROD_009", "kNotInverse"};
const Decision kFailLate{"SRS_PROD_009", "kNoConfirmation"};
const Act kGivesUp{"SRS_PROD_009", "a fault gives up the pair"};
const Act kGivesUpAwaited{"SRS_PROD_009", "a given up pair awaits nothing"};
const Act kProducerFault{"SRS_PROD_009", "a fault is recorded"};
const Act kAcknowledge{"SRS_PROD_009", "an edge sets the first cause to none"};
const Decision kAcknowledgeFault{"SRS_PROD_009", "no fault in the call of the edge"};
const Decision kMissedMark{"SRS_PROD_010", "the refresh before still waits"};
const Act kMissedFault{"SRS_PROD_010", "a missed refresh is a fault"};
const Act kSkips{"SRS_PROD_010", "a missed refresh is skipped"};
const Limit kTooRare{"SRS_PROD_010", "time of an application that sends"};
const Number kTooRareUs{"SRS_PROD_010", "length of the time of an application that sends"};
const Milliseconds kTooRareMs{"SRS_PROD_010", "refresh time of an application, in microseconds"};
const Number kTooRareSct{"SRS_PROD_010", "refresh time of an application"};
const Number kTooRareCycle{"SRS_PROD_010", "cycle time"};
const Number kTooRareTolerance{"SRS_PROD_010", "tolerance of the cycle"};
const Act kTooRareTakesCycle{"SRS_PROD_010", "the time holds the cycle"};
const Act kTooRareTakesTolerance{"SRS_PROD_010", "the time holds the tolerance"};
const Sum kTooRareSum{"SRS_PROD_010", "refresh time, and cycle and tolerance"};
const Sum kTooRareCallSum{"SRS_PROD_010", "cycle and tolerance"};
const Decision kTooRareRequest{"SRS_PROD_010", "a request waits from before"};
const Act kTooRareLate{"SRS_PROD_010", "a request of this very call does not wait from before"};
const Decision kTooRareForm{"SRS_PROD_010", "the application sends"};
const Act kTooRareFault{"SRS_PROD_010", "an application that sends too rarely is a fault"};
const Act kTooRareAnew{"SRS_PROD_010", "the time counts anew after the fault"};
const Act kTooRarePrepare{"SRS_PROD_010", "the time counts from the last Prepare"};
const Decision kTooRareAtFirst{"SRS_PROD_010", "Prepare came at or after the first possible transmission"};
const Act kTooRareFirst{"SRS_PROD_010", "the time counts from the first possible transmission"};
const Act kLeaves{"SRS_PROD_011", "everything is given up"};
const Act kLeavesFlight{"SRS_PROD_011", "the pair in flight is given up"};
const Act kLeavesMarks{"SRS_PROD_011", "due marks and requests are given up"};
const Act kLeavesOrdinal{"SRS_PROD_011", "the number of pairs sent is 0"};
const Act kLeavesState{"SRS_PROD_011", "the state is off"};
const Act kEntersState{"SRS_CONS_025", "the state is kProducer"};
const Act kStands{"SRS_PROD_012", "the refresh is moved on"};
const Place kStandingSlot{"SRS_PROD_012", "slot that is asked whether it stands"};
const Act kStandsApplication{"SRS_PROD_012", "the time of an application that sends is moved on"};
const Act kStandsUnexamined{"SRS_PROD_012", "a refresh that stands is not examined"};
const Act kStandsUnexaminedApplication{"SRS_PROD_012", "an application whose time stands is not examined"};
const Decision kStandDelay{"SRS_PROD_012", "the delay was over at the previous OnCycle"};
const Act kStandDelayEqual{"SRS_PROD_012", "the delay over in the previous OnCycle itself counts"};
const Decision kStandEntered{"SRS_PROD_012", "the slot was active before"};
const Number kStandTime{"SRS_PROD_012", "time from the previous OnCycle"};
const Act kStandDifference{"SRS_PROD_012", "the previous OnCycle counts"};
const Act kWaitsInFlight{"SRS_PROD_013", "a refresh that falls due while a pair is in flight waits"};
const Act kWaitsBehindPair{"SRS_PROD_013", "a refresh waits until the pair is sent"};
const Act kWaitsBehindGivenUp{"SRS_PROD_013", "a refresh waits until the pair is given up"};
const Act kWaitsOn{"SRS_PROD_013", "a refresh waits until Prepare"};
const Act kShownInFlight{"SRS_PROD_013", "a refresh that waits is shown while a pair is in flight"};
const Act kShownIdle{"SRS_PROD_013", "a refresh that waits is shown without a pair in flight"};
const Act kShownForm{"SRS_PROD_013", "a request of the other form is no refresh"};
const Act kShownRequest{"SRS_PROD_013", "a request of this form is no refresh"};

const Product kSteps{"SRS_PROD_001", "0.5 ms x node-ID"};
const Sum kFirstSum{"SRS_PROD_001", "entering OPERATIONAL and the initial delay"};
const Sum kRefreshSum{"SRS_PROD_002", "instant of a refresh and the refresh time"};
const Number kCauseAny{"SRS_PROD_009", "which fault of a producer it is"};
const Number kCauseRecorded{"SRS_PROD_009", "first cause of a producer"};
const Number kCauseSignalled{"SRS_PROD_009", "signal of a producer"};
const Number kMissedTold{"SRS_PROD_010", "what is recorded of a missed refresh, in either form"};
const Number kMissedTold2{"SRS_PROD_010", "what is recorded of an application that sends too rarely"};
const Number kMissedTold1{"SRS_PROD_010", "what is recorded of a missed refresh"};
const Place kExaminedSlot{"SRS_PROD_008", "slot that is examined in the cycle"};
const Place kAcknowledgedSlot{"SRS_PROD_009", "slot whose first cause an edge clears"};
const Number kGivingUpTold{"SRS_PROD_009", "cause of a fault that gives up the pair"};
const Act kEdgeOfCall{"SRS_PROD_009", "an edge of a producer counts in its own call"};
const Act kEdgeGone{"SRS_PROD_009", "an edge of a producer does not wait"};
const Number kMissedCause{"SRS_PROD_010", "cause of a refresh that is missed"};
const Number kTimeSays{"SRS_PROD_008", "what the check of the time says"};
const Number kTimeSaysInCycle{"SRS_PROD_008", "what the check of the time in the cycle says"};
const Number kTimeSaysOfFrame{"SRS_PROD_008", "what the check of the time of a confirmation says"};
const Decision kAcknowledges{"SRS_PROD_009", "an edge clears the first cause"};
const Number kToldAny{"SRS_PROD_009", "cause of a producer"};
const Number kToldNoConfirmCycle{"SRS_PROD_008", "cause of no confirmation in the cycle"};
const Number kToldNoConfirmFrame{"SRS_PROD_008", "cause of a confirmation too late"};
const Number kToldMissed{"SRS_PROD_010", "cause of a missed refresh"};
const Number kToldRare{"SRS_PROD_010", "cause of an application that sends too rarely"};
const Number kToldEcho{"SRS_PROD_007", "cause of a wrong echo"};
const Number kToldFail{"SRS_PROD_009", "cause of a failed transmission"};
const Number kReady{"SRS_PROD_005", "status of a ready pair"};
const Number kNotReady{"SRS_PROD_005", "status without a pair"};
const Act kReadyTold{"SRS_PROD_005", "a ready pair is told"};
const Act kPrepareDone{"SRS_PROD_005", "Prepare is done"};
const Decision kEchoInverse{"SRS_PROD_007", "the inverse frame's data are expected"};
const Decision kEchoWrong{"SRS_PROD_007", "the echo is wrong"};
const Either kEchoEither{"SRS_PROD_007", "length or data differ"};
const Decision kConfirmFlaw{"SRS_PROD_007", "a confirmation has a flaw"};
const Counter kSentUp{"SRS_PROD_007", "number of pairs sent"};
const Both kAcknowledgeWith{"SRS_PROD_009", "an edge, and no fault in the call"};
const Both kDueWith{"SRS_PROD_004", "something makes due, and no pair is in flight"};
const Either kDueBy{"SRS_PROD_004", "a refresh, or a request"};
const Both kPreparesBoth{"SRS_PROD_005", "an active producer, and no pair in flight"};

std::uint32_t DelayOf(const Common& common) noexcept
{
    return kDelay(kSteps(kStep(500U), kNodeId(static_cast<std::uint32_t>(common.config.node_id))));
}

bool IsReached(std::uint32_t now_us, std::uint32_t from_us, std::uint32_t delay_us) noexcept
{
    const std::uint32_t elapsed = now_us - from_us;
    return kDelayOver(kDelayReached() ? (elapsed >= delay_us) : (elapsed > delay_us));
}

void GiveUpPair(Record& record) noexcept
{
    record.transmission.is_in_flight = false;
    record.transmission.is_refresh_due = record.transmission.is_refresh_due && kWaitsBehindGivenUp();
    record.transmission.is_inverse_awaited = record.transmission.is_inverse_awaited && (!kGivesUpAwaited());
}

/// A fault `given` that is told as `told`.
void FaultAs(Record& record, SrdoCause given, SrdoCause told) noexcept
{
    const SrdoCause cause = kCauseAny(given);
    if (kProducerFault())
    {
        const bool is_missed = cause == SrdoCause::kRefreshMissed;
        const SrdoCause recorded = kToldAny(is_missed ? told : kGivingUpTold(told));
        RecordAs(record, kCauseRecorded(recorded), kCauseSignalled(recorded));
    }
    if ((cause != SrdoCause::kRefreshMissed) && kGivesUp())
    {
        GiveUpPair(record);
    }
}

void Fault(Record& record, SrdoCause cause) noexcept
{
    FaultAs(record, cause, kCauseAny(cause));
}

bool IsSrvtOver(const Record& record, const Limit& limit, const Milliseconds& unit, std::uint32_t now_us) noexcept
{
    const std::uint32_t since_us = record.transmission.since_us;
    const bool is_over = limit(now_us, since_us, unit(record.stored.srvt_ms));
    const bool is_any = kNoConfirmAny(now_us, since_us, kSrvtOfBoth(record.stored.srvt_ms));
    const bool plain = (now_us - since_us) > (record.stored.srvt_ms * 1000U);
    return (is_over != plain) ? is_over : is_any;
}

void ExamineConfirmation(const Common& common, Record& record) noexcept
{
    const bool is_over = kNoConfirmInFlight(record.transmission.is_in_flight) &&
                         IsSrvtOver(record, kNoConfirmInCycle, kSrvtOfCycle, common.now_us);
    const SrdoCause told = is_over ? kToldNoConfirmCycle(SrdoCause::kNoConfirmation) : SrdoCause::kNone;
    const SrdoCause said = record.transmission.is_in_flight ? kTimeSays(kTimeSaysInCycle(told)) : told;
    if ((is_over || (said != SrdoCause::kNone)) && kNoConfirmFault())
    {
        Fault(record, said);
    }
}

/// Form kProviderCalled. [SRS_PROD_002, SRS_PROD_010]
void ExamineRefresh(const Common& common, Record& record) noexcept
{
    Transmission& to = record.transmission;
    const std::uint32_t beyond = common.now_us - to.next_us;
    const bool is_reached = kRefreshEqual() ? (beyond < 0x80000000U) : ((beyond - 1U) < 0x7FFFFFFFU);
    if (!kRefreshReached(is_reached))
    {
        return;
    }
    const bool is_missed = kMissedMark(to.is_refresh_due);
    if (is_missed)
    {
        if (kMissedFault())
        {
            const SrdoCause cause = kMissedCause(kToldMissed(SrdoCause::kRefreshMissed));
            FaultAs(record, cause, kMissedTold(kMissedTold1(cause)));
        }
    }
    else
    {
        to.is_refresh_due = kRefreshDue() && ((!to.is_in_flight) || kWaitsInFlight());
    }
    const std::uint32_t from_us = kExactPhase() ? to.next_us : common.now_us;
    const bool goes_on = kPhase() && ((!is_missed) || kSkips());
    to.next_us = goes_on ? kRefreshSum(from_us, kPeriod(kPeriodMs(record.stored.sct_ms))) : to.next_us;
}

/// Form kApplicationSends. [SRS_PROD_010]
void ExamineApplication(const Common& common, Record& record, bool was_requested) noexcept
{
    Transmission& to = record.transmission;
    const std::uint32_t cycle_us = kTooRareTakesCycle() ? kTooRareCycle(common.config.cycle_us) : 0U;
    const std::uint32_t tolerance_us =
        kTooRareTakesTolerance() ? kTooRareTolerance(common.config.cycle_tolerance_us) : 0U;
    const std::uint32_t refresh_us = kTooRareMs(kTooRareSct(record.stored.sct_ms));
    const std::uint32_t limit_us = kTooRareSum(refresh_us, kTooRareCallSum(cycle_us, tolerance_us));
    const bool waits = was_requested || (to.is_requested && (!kTooRareLate()));
    if (kTooRare(common.now_us, to.base_us, kTooRareUs(limit_us)) && (!kTooRareRequest(waits)) && kTooRareFault())
    {
        const SrdoCause cause = kMissedCause(kToldRare(SrdoCause::kRefreshMissed));
        FaultAs(record, cause, kMissedTold(kMissedTold2(cause)));
        to.base_us = kTooRareAnew() ? common.now_us : to.base_us;
    }
}

CanFrame NormalFrame(const Common& common, const Record& record) noexcept
{
    CanFrame frame{};
    frame.identifier = kIdentifier1(record.stored.cob_id_1);
    frame.kind = kKind1() ? FrameKind::kData : FrameKind::kInvalid;
    frame.port = kPort1(common.config.normal_port);
    frame.length_bytes = static_cast<std::uint8_t>(kLength1(LengthOf(record)));
    if (kData1())
    {
        std::copy(std::begin(record.transmission.sent.at), std::end(record.transmission.sent.at), frame.data);
    }
    return frame;
}

std::uint8_t Expected(const Record& record, std::uint32_t byte, bool is_inverse) noexcept
{
    const std::uint8_t normal = record.transmission.sent.at[byte];
    return is_inverse ? static_cast<std::uint8_t>(0xFFU ^ normal) : normal;
}

} // namespace

void EnterProducer(const Common& common, Record& record) noexcept
{
    Transmission& to = record.transmission;
    to.entered_us = kEntered(common.now_us);
    to.next_us = kFirstSum(to.entered_us, kFirstRefresh() ? DelayOf(common) : 0U);
    to.base_us = kFirstSum(to.entered_us, kTooRareFirst() ? DelayOf(common) : 0U);
    record.state = kEntersState() ? SrdoState::kProducer : record.state;
}

void LeaveProducer(Record& record) noexcept
{
    const Transmission was = record.transmission;
    Transmission& to = record.transmission;
    to = kLeaves() ? Transmission{} : was;
    to.is_in_flight = kLeavesFlight() ? to.is_in_flight : was.is_in_flight;
    to.is_inverse_awaited = kLeavesFlight() ? to.is_inverse_awaited : was.is_inverse_awaited;
    to.is_requested = kLeavesMarks() ? to.is_requested : was.is_requested;
    to.is_refresh_due = kLeavesMarks() ? to.is_refresh_due : was.is_refresh_due;
    to.ordinal = kLeavesOrdinal() ? to.ordinal : was.ordinal;
    record.state = kLeavesState() ? SrdoState::kOff : record.state;
}

void CycleProducer(const Common& common, Record* records, const CycleInput& input, SlotIndex slot,
                   bool was_active) noexcept
{
    Record& record = records[slot];
    Transmission& to = record.transmission;
    const bool is_provider = kProvider(record.setup.form == ProducerForm::kProviderCalled);
    const SlotIndex asked = kStandingSlot(slot);
    const bool is_asked = records[asked].is_active && IsProducer(records[asked]);
    const bool is_standing = is_asked && (((input.stand >> asked) & 1U) != 0U);
    const std::uint32_t elapsed_before = common.previous_us - to.entered_us;
    const std::uint32_t delay_us = DelayOf(common);
    const bool was_over = kStandDelayEqual() ? (elapsed_before >= delay_us) : (elapsed_before > delay_us);
    const bool stands = is_standing && kStandEntered(was_active) && kStandDelay(was_over);
    if (stands)
    {
        const std::uint32_t then_us = kStandDifference() ? common.previous_us : 0U;
        to.next_us += kStands() ? kStandTime(common.now_us - then_us) : 0U;
        to.base_us += kStandsApplication() ? kStandTime(common.now_us - then_us) : 0U;
    }
    const bool was_requested = to.is_requested;
    const bool is_requested = ((input.request >> slot) & 1U) != 0U;
    to.is_requested = kRequestsTogether(to.is_requested, is_requested && kRequests());
    const bool is_first = kBeforeRefresh();
    if (is_first)
    {
        ExamineConfirmation(common, records[kExaminedSlot(slot)]);
    }
    if (IsReached(common.now_us, to.entered_us, delay_us))
    {
        if (is_provider && (!(stands && kStandsUnexamined())))
        {
            ExamineRefresh(common, record);
        }
        if (kTooRareForm(!is_provider) && (!(stands && kStandsUnexaminedApplication())))
        {
            ExamineApplication(common, record, was_requested);
        }
    }
    if (!is_first)
    {
        ExamineConfirmation(common, records[kExaminedSlot(slot)]);
    }
    record.is_fault_reported = record.has_fault;
    record.has_fault = false;
    const bool waits = (!kEdgeOfCall()) || (!kEdgeGone());
    const bool has_edge = record.button.is_edge || (waits && record.button.is_waiting);
    const bool is_read = kAcknowledgeWith(has_edge, kAcknowledgeFault(!record.is_fault_reported));
    if (kAcknowledges(is_read) && kAcknowledge())
    {
        records[kAcknowledgedSlot(slot)].cause = SrdoCause::kNone;
    }
    record.button.is_waiting = record.button.is_waiting && waits && !(is_read && kEdgeGone());
}

bool IsDue(const Common& common, const Record& record) noexcept
{
    const Transmission& to = record.transmission;
    const bool is_marked = kDueBy(kDueRefresh(to.is_refresh_due), kDueRequest(to.is_requested));
    return kDueWith(kDueInFlight(!to.is_in_flight), is_marked) &&
           IsReached(common.now_us, to.entered_us, DelayOf(common));
}

bool IsRefreshWaiting(Record& record) noexcept
{
    Transmission& to = record.transmission;
    const bool is_shown = to.is_in_flight ? kShownInFlight() : kShownIdle();
    const bool is_waiting = to.is_refresh_due && is_shown;
    to.is_refresh_due = to.is_refresh_due && kWaitsOn();
    const bool is_provider = record.setup.form == ProducerForm::kProviderCalled;
    return is_waiting || (to.is_requested && !(is_provider ? kShownRequest() : kShownForm()));
}

PreparedPair PreparePair(const Common& common, Record& record) noexcept
{
    Transmission& to = record.transmission;
    if (!kPrepareDone())
    {
        return PreparedPair{};
    }
    if (!kPreparesBoth(kPrepares(record.is_active && IsProducer(record)), kPreparesIdle(!to.is_in_flight)))
    {
        return PreparedPair{CanFrame{}, kNotReady(PrepareStatus::kNotProducer)};
    }
    to.is_refresh_due = to.is_refresh_due && (!kUsesRefresh());
    to.is_requested = to.is_requested && (!kUsesRequest());
    const bool is_after = IsReached(common.now_us, to.entered_us, DelayOf(common));
    to.base_us = (kTooRareAtFirst(is_after) && kTooRarePrepare()) ? common.now_us : to.base_us;
    to.sent = ReadObjects(record, common.side);
    to.is_in_flight = kGoesInFlight();
    to.is_inverse_awaited = false;
    to.since_us = kSince(common.now_us);
    return kReadyTold() ? PreparedPair{NormalFrame(common, record), kReady(PrepareStatus::kReady)} : PreparedPair{};
}

ConfirmStep Confirm(Record& record, const CanFrame& frame, std::uint32_t stamp_us) noexcept
{
    Transmission& to = record.transmission;
    const bool is_inverse = kConfirmInverse(to.is_inverse_awaited);
    const std::uint32_t awaited = is_inverse ? record.stored.cob_id_2 : record.stored.cob_id_1;
    if ((!kConfirmInFlight(to.is_in_flight)) || (!kConfirmKind(frame.kind == FrameKind::kData)) ||
        (!kConfirmAwaited(frame.identifier == awaited)))
    {
        return ConfirmStep::kNone;
    }
    const std::uint32_t length = LengthOf(record);
    bool is_equal = true;
    for (std::uint32_t i = 0U; i < length; ++i)
    {
        const bool counts = ((i != 0U) || kEchoFirst()) && (((i + 1U) != length) || kEchoLast());
        is_equal = is_equal && ((!counts) || (frame.data[i] == Expected(record, i, kEchoInverse(is_inverse))));
    }
    if (kEchoWrong(kEchoEither(!kEchoLength(frame.length_bytes == length), !kEchoData(is_equal))))
    {
        if (kEchoFault())
        {
            Fault(record, kToldEcho(SrdoCause::kWrongEcho));
        }
        return ConfirmStep::kNone;
    }
    const bool is_over = IsSrvtOver(record, kNoConfirmAtFrame, kSrvtOfConfirm, stamp_us);
    const SrdoCause told = is_over ? kToldNoConfirmFrame(SrdoCause::kNoConfirmation) : SrdoCause::kNone;
    const SrdoCause said = kTimeSays(kTimeSaysOfFrame(told));
    if (is_over || (said != SrdoCause::kNone))
    {
        if (kNoConfirmFaultFrame())
        {
            Fault(record, said);
        }
        return ConfirmStep::kNone;
    }
    if (kConfirmFlaw(false))
    {
        Fault(record, SrdoCause::kNone);
        return ConfirmStep::kNone;
    }
    if (!is_inverse)
    {
        to.is_inverse_awaited = kAwaitsInverse();
        to.since_us = kConfirmStamp() ? stamp_us : to.since_us;
        return kReplyNormal(ConfirmStep::kNormal);
    }
    to.ordinal = kSent(kSentUp(to.ordinal));
    to.is_in_flight = !kPairOver();
    to.is_refresh_due = to.is_refresh_due && kWaitsBehindPair();
    to.is_inverse_awaited = false;
    return kReplyPair(ConfirmStep::kPair);
}

CanFrame InverseOf(const Common& common, const Record& record) noexcept
{
    CanFrame frame{};
    const Transmission& to = record.transmission;
    if ((!kInverseInFlight(to.is_in_flight)) || (!kInverseAwaited(to.is_inverse_awaited)))
    {
        return frame;
    }
    frame.identifier = kIdentifier2(record.stored.cob_id_2);
    frame.kind = kKind2() ? FrameKind::kData : FrameKind::kInvalid;
    frame.port = kPort2(common.config.inverse_port);
    frame.length_bytes = static_cast<std::uint8_t>(kLength2(LengthOf(record)));
    for (std::uint32_t i = 0U; (i < LengthOf(record)) && kData2(); ++i)
    {
        const std::uint8_t above = static_cast<std::uint8_t>(0xFFU ^ MappedOf(record, i));
        const std::uint8_t data = Expected(record, i, kComplement());
        frame.data[i] = static_cast<std::uint8_t>(kAboveIsOne(true) ? (data | above) : (data & (0xFFU ^ above)));
    }
    return frame;
}

void FailTransmission(Record& record, SrdoCause cause) noexcept
{
    const bool is_cause = kFailQueue(cause == SrdoCause::kTransmitQueue) || kFailBusOff(cause == SrdoCause::kBusOff) ||
                          kFailInverse(cause == SrdoCause::kNotInverse) ||
                          kFailLate(cause == SrdoCause::kNoConfirmation);
    if (kFailInFlight(record.transmission.is_in_flight) && kFailCause(is_cause))
    {
        Fault(record, kToldFail(cause));
        if (cause == SrdoCause::kRefreshMissed) // Of a pair in flight it is no missed refresh: the pair is given up.
        {
            GiveUpPair(record);
        }
    }
}

} // namespace counterpoint::twins::plain
