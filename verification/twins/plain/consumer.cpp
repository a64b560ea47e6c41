// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// A consumer, as the requirements SRS_TIME, SRS_CONS and SRS_REL say it.
#include "verification/twins/plain/point.hpp"
#include "verification/twins/plain/record.hpp"

#include <algorithm>

namespace counterpoint::twins::plain
{

namespace
{
// Effect of a fault.
const Act kDropsPending{"SRS_CONS_012", "a fault discards the pending normal frame"};
const Act kDropsHeld{"SRS_CONS_012", "a fault discards the held pair"};
const Act kOrdinalZero{"SRS_CONS_012", "a fault sets the ordinal to 0"};
const Act kForgetsEdge{"SRS_CONS_012", "a fault forgets an acknowledge edge that waits"};
const Act kFaultedState{"SRS_CONS_012", "a fault leads to kFaulted"};
const Act kFaultIsReported{"SRS_CONS_013", "the next OnCycle reports a fault"};
const Decision kIsFirst{"SRS_CONS_020", "a cause is recorded before"};
const Number kFirstCause{"SRS_CONS_020", "the first cause"};
const Act kCounts{"SRS_CONS_020", "every fault counts up"};
const Number kCount{"SRS_CONS_020", "error_count after a fault"};
const Decision kIsFull{"SRS_CONS_020", "error_count stays at 65535"};
const Act kSignals{"SRS_CONS_021", "every fault is signalled"};
const Number kSignalBit{"SRS_CONS_021", "bit of a signal"};

const Counter kErrors{"SRS_CONS_020", "error_count"};
const Act kRecorded{"SRS_CONS_020", "a fault is counted and is a cause"};
const Act kWaitingEnds{"SRS_CONS_022", "anything ends waiting past SCT"};
const Decision kOwnId{"SRS_CONS_004", "the identifier is the SRDO's own"};
const Decision kFrameHasFlaw{"SRS_CONS_011", "a frame has a flaw besides"};
const Decision kFlawFound{"SRS_CONS_011", "a frame has a flaw"};
const Number kFlawSays{"SRS_CONS_011", "what the checks of a frame say"};
const Number kPortSays{"SRS_CONS_004", "what the check of the controller says"};
const Number kLengthSays{"SRS_CONS_005", "what the check of the length says"};
const Number kNormalSays{"SRS_CONS_007", "what the check of a normal frame's order says"};
const Number kInverseSays{"SRS_CONS_008", "what the check of an inverse frame's order says"};
const Number kInversionSays{"SRS_CONS_009", "what the check of the inversion says"};
const Act kAllCauses{"SRS_CONS_018", "OnCycle records faults"};
const Decision kGfcPending{"SRS_CONS_017", "a GFC came"};
const Act kConsumerEdge{"SRS_REL_341", "the edge of a consumer waits"};
const Decision kEdgeIs{"SRS_REL_004", "an edge waits"};
const Either kReleaseBy{"SRS_REL_004", "automatic, or an edge"};
const Both kReleaseWith{"SRS_REL_003", "a pair, and no fault"};
const Both kClearsWith{"SRS_REL_007", "released, and an edge"};
const Both kEdgeOf{"SRS_REL_005", "the level is 1, and was 0"};
const Both kInvertedBoth{"SRS_CONS_009", "inverted, and nothing above"};
const Counter kOrdinalUp{"SRS_CONS_010", "the ordinal"};
const Number kToldNormalTwice{"SRS_CONS_007", "cause NormalTwice"};
const Number kToldInverseFirst{"SRS_CONS_008", "cause InverseFirst"};
const Number kToldNotInverse{"SRS_CONS_009", "cause NotInverse"};
const Number kToldIdentifier{"SRS_CONS_004", "cause Identifier"};
const Number kToldLength{"SRS_CONS_005", "cause Length"};
const Number kToldLateCall{"SRS_CONS_015", "cause LateCall"};
const Number kToldQueueOverflow{"SRS_CONS_016", "cause QueueOverflow"};
const Number kToldGfc{"SRS_CONS_017", "cause Gfc"};
const Number kToldNotOperational{"SRS_CONS_019", "cause NotOperational"};

// Limits.
const Milliseconds kSctOfFrame{"SRS_CONS_003", "SCT at a frame, in microseconds"};
const Milliseconds kSrvtOfFrame{"SRS_CONS_003", "SRVT at a frame, in microseconds"};
const Milliseconds kSctOfCycle{"SRS_CONS_014", "SCT in the cycle, in microseconds"};
const Milliseconds kSrvtOfCycle{"SRS_CONS_014", "SRVT in the cycle, in microseconds"};
const Milliseconds kSctOfConsumer{"SRS_TIME_005", "SCT, in microseconds"};
const Milliseconds kSrvtOfConsumer{"SRS_TIME_006", "SRVT, in microseconds"};
const Number kSct{"SRS_TIME_005", "SCT in milliseconds"};
const Number kSrvt{"SRS_TIME_006", "SRVT in milliseconds"};
const Limit kFrameSct{"SRS_CONS_003", "SCT at a frame"};
const Limit kFrameSrvt{"SRS_CONS_003", "SRVT at a frame"};
const Limit kCycleSct{"SRS_CONS_014", "SCT in the cycle"};
const Limit kCycleSrvt{"SRS_CONS_014", "SRVT in the cycle"};
const Limit kAnySct{"SRS_TIME_005", "SCT"};
const Limit kAnySrvt{"SRS_TIME_006", "SRVT"};
const Decision kPendingAtFrame{"SRS_CONS_003", "a normal frame is pending at a frame"};
const Decision kPendingInCycle{"SRS_CONS_014", "a normal frame is pending in the cycle"};
const Decision kHeldAtFrame{"SRS_CONS_003", "a pair is held at a frame"};
const Decision kHeldInCycle{"SRS_CONS_014", "a pair is held in the cycle"};
const Decision kLate{"SRS_TIME_009", "late detection"};
const Decision kLateAtFrame{"SRS_TIME_009", "late detection at a frame"};
const Decision kLateInCycle{"SRS_TIME_009", "late detection in the cycle"};
const Decision kSctFirst{"SRS_TIME_008", "SCT has the earlier deadline"};
const Decision kTie{"SRS_TIME_008", "at a tie SRVT"};
const Decision kSrvtExamined{"SRS_TIME_009", "SRVT is examined at this frame"};
const Decision kStaysTooOld{"SRS_TIME_341", "a pending frame stays too old"};
const Act kExaminesFrame{"SRS_CONS_003", "limits examined before a frame"};
const Act kExaminesCycle{"SRS_CONS_014", "limits examined in the cycle"};
const Number kCauseSct{"SRS_TIME_005", "cause of an expired SCT"};
const Number kCauseSrvt{"SRS_TIME_006", "cause of an expired SRVT"};
const Act kSctFault{"SRS_TIME_005", "an expired SCT is a fault"};
const Act kSrvtFault{"SRS_TIME_006", "an expired SRVT is a fault"};

// Frames.
const Decision kIsInverse{"SRS_CONS_001", "the identifier is COB-ID 2"};
const Decision kPort{"SRS_CONS_004", "the controller is the named one"};
const Decision kNormalPort{"SRS_CONS_004", "the controller is the one of normal frames"};
const Decision kInversePort{"SRS_CONS_004", "the controller is the one of inverse frames"};
const Decision kLength{"SRS_CONS_005", "the length is the mapped one"};
const Decision kNotShorter{"SRS_CONS_005", "the length is not below the mapped one"};
const Number kMappedLength{"SRS_CONS_005", "mapped length"};
const Decision kTwice{"SRS_CONS_007", "a normal frame is pending"};
const Act kTwiceFault{"SRS_CONS_007", "a second normal frame is a fault"};
const Act kTwiceDrops{"SRS_CONS_007", "neither of two normal frames is pending"};
const Decision kFirst{"SRS_CONS_008", "an inverse frame has a normal frame before it"};
const Act kFirstFault{"SRS_CONS_008", "an inverse frame without a normal frame is a fault"};
const Act kKeepsPending{"SRS_CONS_006", "a normal frame becomes pending"};
const Number kPendingStamp{"SRS_CONS_006", "stamp of the pending frame"};
const Act kPendingData{"SRS_CONS_006", "data of the pending frame"};
const Decision kInverted{"SRS_CONS_009", "all mapped bits are inverted"};
const Decision kAbove{"SRS_CONS_009", "bits above the mapped length are 0 and 1"};
const Decision kAboveNormal{"SRS_CONS_009", "bits above the mapped length of the normal frame are 0"};
const Decision kAboveInverse{"SRS_CONS_009", "bits above the mapped length of the inverse frame are 1"};
const Act kFirstByteCounts{"SRS_CONS_009", "the first byte is compared"};
const Act kLastByteCounts{"SRS_CONS_009", "the last byte is compared"};
const Act kKeepsPair{"SRS_CONS_010", "a valid pair is held"};
const Number kOrdinal{"SRS_CONS_010", "the ordinal after a pair"};
const Number kHeldStamp{"SRS_CONS_010", "stamp of the held pair"};
const Act kHeldFromInverse{"SRS_TIME_005", "SCT counts from the normal frame"};
const Act kNoLongerPending{"SRS_CONS_010", "after a pair no normal frame is pending"};
const Act kHeldData{"SRS_CONS_010", "data of the held pair"};
const Act kFresh{"SRS_CONS_023", "a completed pair is fresh"};
const Act kNotWritten{"SRS_REL_002", "a new pair has not been written"};

// Cycle.
const Act kLateCall{"SRS_CONS_015", "a late call is a fault"};
const Decision kUnlessExpired{"SRS_CONS_015", "a limit has expired in this call"};
const Act kOverflow{"SRS_CONS_016", "a queue overflow is a fault"};
const Act kGfc{"SRS_CONS_017", "a GFC is a fault"};
const Act kDiscardsAll{"SRS_CONS_013", "the cycle that reports a fault discards pair and ordinal"};
const Decision kBehindFault{"SRS_CONS_013", "a pair is behind a fault"};
const Act kNoSctAtFrame{"SRS_CONS_013", "at a frame a pair behind a fault has no SCT"};
const Act kNoSctInCycle{"SRS_CONS_013", "in the cycle a pair behind a fault has no SCT"};
const Act kDiscards{"SRS_CONS_013", "the cycle that reports a fault discards a pair held since"};
const Act kDiscardsOrdinal{"SRS_CONS_013", "the cycle that reports a fault sets the ordinal to 0"};
const Act kForgetsEdgeOfCall{"SRS_REL_341", "an edge in the call that reports a fault is forgotten"};
const Act kPendingStays{"SRS_CONS_013", "a pending frame stays pending in the cycle that reports a fault"};
const Decision kIsReported{"SRS_CONS_013", "a fault is to be reported"};
const Decision kNotReleasedNow{"SRS_REL_003", "no fault to report in this call"};
const Decision kAutomatic{"SRS_REL_003", "the policy is automatic"};
const Decision kHeldForRelease{"SRS_REL_003", "a pair is held for a release"};
const Decision kEdgeForRelease{"SRS_REL_004", "an edge waits for a release"};
const Act kReleases{"SRS_REL_003", "a consumer is released"};
const Act kClearsCause{"SRS_REL_007", "an acknowledge clears the cause"};
const Act kUsesEdge{"SRS_REL_007", "the edge is used up"};
const Decision kClearsReleasedOnly{"SRS_REL_007", "the consumer is released when its cause is cleared"};
const Decision kEdgeForClear{"SRS_REL_007", "an edge waits for the cause"};
const Limit kWaitingLimit{"SRS_CONS_022", "SCT since entering OPERATIONAL"};
const Milliseconds kWaitingSct{"SRS_CONS_022", "SCT since entering OPERATIONAL, in microseconds"};
const Act kWaitingOnce{"SRS_CONS_022", "waiting past SCT is signalled once"};
const Act kWaitingTold{"SRS_CONS_022", "waiting past SCT is signalled"};
const Decision kWaitingState{"SRS_CONS_022", "the consumer is waiting"};
const Decision kWaitingNothing{"SRS_CONS_022", "no pair and no fault since entering"};
const Act kWaitingFault{"SRS_CONS_022", "a fault ends waiting past SCT"};
const Act kWaitingPair{"SRS_CONS_022", "a pair ends waiting past SCT"};
const Act kWaitsForPair{"SRS_CONS_022", "a completed pair, in whatever state, ends waiting past SCT"};
const Act kWaitsForFault{"SRS_CONS_022", "a fault, in whatever state, ends waiting past SCT"};
const Decision kWaitsAtAll{"SRS_CONS_022", "waiting, no pair and no fault since entering"};
const Decision kWaitingStill{"SRS_CONS_022", "no pair and no fault since entering, and not signalled yet"};
const Number kWaitingFrom{"SRS_CONS_022", "instant of entering OPERATIONAL"};

// Entering, leaving.
const Act kEntersWaiting{"SRS_REL_001", "a consumer that becomes active is waiting"};
const Act kEntersEmpty{"SRS_CONS_019", "becoming active starts with nothing"};
const Act kLeavingFault{"SRS_CONS_019", "leaving OPERATIONAL is a cause"};
const Act kLeavingOff{"SRS_CONS_019", "the state is off after OPERATIONAL"};
const Act kLeavingEmpty{"SRS_CONS_019", "no pair and no pending frame after OPERATIONAL"};
const Act kLeavingOrdinal{"SRS_CONS_019", "the ordinal is 0 after OPERATIONAL"};

// Acknowledge.
const Decision kTwoEqual{"SRS_REL_005", "two calls gave the same"};
const Both kTwoOnes{"SRS_REL_005", "both calls gave 1"};
const Both kTwoZeros{"SRS_REL_005", "both calls gave 0"};
const Either kLevelBy{"SRS_REL_005", "both calls gave 1, or the level stays 1"};
const Either kWaitsFor{"SRS_REL_341", "an edge waits, or a new one"};
const Act kKeepsBit{"SRS_REL_005", "the bit is kept for the next call"};
const Act kKeepsLevel{"SRS_REL_005", "the level is followed"};
const Decision kWasLow{"SRS_REL_005", "the level was 0"};
const Decision kIsHigh{"SRS_REL_005", "the level is 1"};
const Decision kEdgeActive{"SRS_REL_341", "the slot of an edge is active"};
const Act kEdgeWaits{"SRS_REL_341", "an edge waits"};
const Number kEdgeFrom{"SRS_REL_341", "instant of the edge"};
const Act kNewWindow{"SRS_REL_341", "a new edge starts the window anew"};
const Limit kWindow{"SRS_REL_341", "acknowledge window"};
const Number kWindowUs{"SRS_REL_341", "length of the acknowledge window"};
const Act kForgotten{"SRS_REL_341", "an edge is forgotten behind the window"};
const Act kLeavingForgets{"SRS_REL_341", "an edge waits for an active slot only"};

std::uint32_t SctOf(const Record& record) noexcept
{
    return kSctOfConsumer(kSct(record.stored.sct_ms));
}

std::uint32_t SrvtOf(const Record& record) noexcept
{
    return kSrvtOfConsumer(kSrvt(record.stored.srvt_ms));
}

bool IsSctOver(const Record& record, std::uint32_t now_us, bool is_frame) noexcept
{
    const Reception& at = record.reception;
    const std::uint32_t ms = kSct(record.stored.sct_ms);
    const bool is_over =
        is_frame ? kFrameSct(now_us, at.held_us, kSctOfFrame(ms)) : kCycleSct(now_us, at.held_us, kSctOfCycle(ms));
    const bool is_any_over = kAnySct(now_us, at.held_us, SctOf(record));
    const bool is_held = is_frame ? kHeldAtFrame(at.is_held) : kHeldInCycle(at.is_held);
    // Both say the same unless one of them is broken.
    const bool plain = (now_us - at.held_us) > (static_cast<std::uint32_t>(record.stored.sct_ms) * 1000U);
    const bool is_behind = kBehindFault(record.has_fault) && (is_frame ? kNoSctAtFrame() : kNoSctInCycle());
    return is_held && (!is_behind) && ((is_over != plain) ? is_over : is_any_over);
}

bool IsSrvtOver(const Record& record, std::uint32_t now_us, bool is_frame) noexcept
{
    const Reception& at = record.reception;
    const std::uint32_t ms = kSrvt(record.stored.srvt_ms);
    const bool is_over = is_frame ? kFrameSrvt(now_us, at.pending_us, kSrvtOfFrame(ms))
                                  : kCycleSrvt(now_us, at.pending_us, kSrvtOfCycle(ms));
    const bool is_any_over = kAnySrvt(now_us, at.pending_us, SrvtOf(record));
    const bool plain = (now_us - at.pending_us) > (static_cast<std::uint32_t>(record.stored.srvt_ms) * 1000U);
    return (is_over != plain) ? is_over : is_any_over;
}

void SctFault(Record& record) noexcept
{
    if (kSctFault())
    {
        RecordFault(record, kCauseSct(SrdoCause::kSct));
    }
}

void SrvtFault(Record& record) noexcept
{
    if (kSrvtFault())
    {
        RecordFault(record, kCauseSrvt(SrdoCause::kSrvt));
    }
}

bool IsLate(const Record& record) noexcept
{
    return kLate(record.setup.detection == SrvtDetection::kLate);
}

/// Limits before a frame. [SRS_CONS_003, SRS_TIME_009]
void ExamineAtFrame(Record& record, std::uint32_t stamp_us, bool is_inverse) noexcept
{
    Reception& at = record.reception;
    if (!kExaminesFrame())
    {
        return;
    }
    const bool is_pending = kPendingAtFrame(at.is_pending);
    if (!kLateAtFrame(IsLate(record)))
    {
        if (is_pending)
        {
            if (IsSrvtOver(record, stamp_us, true))
            {
                SrvtFault(record);
            }
        }
        else if (IsSctOver(record, stamp_us, true))
        {
            SctFault(record);
        }
        return;
    }
    const bool is_sct = IsSctOver(record, stamp_us, true);
    const bool is_srvt =
        kSrvtExamined(is_inverse && is_pending) && (kStaysTooOld(at.is_too_old) || IsSrvtOver(record, stamp_us, true));
    const std::uint32_t srvt_after_us = (at.pending_us - at.held_us) + SrvtOf(record);
    const bool is_sct_first = kSctFirst(SctOf(record) < srvt_after_us) || kTie(false);
    if (is_sct && ((!is_srvt) || is_sct_first))
    {
        SctFault(record);
    }
    else if (is_srvt)
    {
        SrvtFault(record);
    }
}

/// In the order of SRS_CONS_011.
bool IsInverted(const Record& record, const CanFrame& frame) noexcept
{
    const std::uint32_t length = LengthOf(record);
    bool is_good = true;
    bool is_above_good = true;
    for (std::uint32_t i = 0U; i < length; ++i)
    {
        const std::uint8_t mapped = MappedOf(record, i);
        const std::uint8_t above = static_cast<std::uint8_t>(0xFFU ^ mapped);
        const std::uint8_t normal = record.reception.pending.at[i];
        const bool counts = ((i != 0U) || kFirstByteCounts()) && (((i + 1U) != length) || kLastByteCounts());
        is_good = is_good && ((!counts) || (((normal ^ frame.data[i]) & mapped) == mapped));
        is_above_good =
            is_above_good && kAboveNormal((normal & above) == 0U) && kAboveInverse((frame.data[i] & above) == above);
    }
    return kInvertedBoth(kInverted(is_good), kAbove(is_above_good));
}

/// What a check of a frame says.
struct Flaw
{
    bool is_found{false};
    SrdoCause cause{SrdoCause::kNone};
    bool is_told{true};
    bool is_refused{true};
};

Flaw Said(const Number& says, bool is_wrong, SrdoCause cause) noexcept
{
    const SrdoCause told = says(is_wrong ? cause : SrdoCause::kNone);
    return Flaw{is_wrong || (told != SrdoCause::kNone), told, true, true};
}

/// The first one in the order of SRS_CONS_011.
Flaw FlawOf(const Common& common, const Record& record, const CanFrame& frame, bool is_inverse) noexcept
{
    const std::uint32_t own = is_inverse ? record.stored.cob_id_2 : record.stored.cob_id_1;
    const bool is_right_port = is_inverse ? kInversePort(frame.port == common.config.inverse_port)
                                          : kNormalPort(frame.port == common.config.normal_port);
    const bool is_ours = kPort(is_right_port) && kOwnId(frame.identifier == own);
    Flaw flaw = Said(kPortSays, !is_ours, kToldIdentifier(SrdoCause::kIdentifier));
    if (flaw.is_found)
    {
        return flaw;
    }
    const std::uint32_t length = kMappedLength(LengthOf(record));
    const bool is_length = kLength(frame.length_bytes <= length) && kNotShorter(frame.length_bytes >= length);
    flaw = Said(kLengthSays, !is_length, kToldLength(SrdoCause::kLength));
    if (flaw.is_found)
    {
        return flaw;
    }
    const bool is_pending = record.reception.is_pending;
    if (!is_inverse)
    {
        const bool is_twice = kTwice(is_pending);
        flaw = Said(kNormalSays, is_twice, kToldNormalTwice(SrdoCause::kNormalTwice));
        flaw.is_told = (!is_twice) || kTwiceFault();
        flaw.is_refused = (!is_twice) || kTwiceDrops();
        return flaw;
    }
    const bool is_first = !kFirst(is_pending);
    flaw = Said(kInverseSays, is_first, kToldInverseFirst(SrdoCause::kInverseFirst));
    flaw.is_told = (!is_first) || kFirstFault();
    if (flaw.is_found)
    {
        return flaw;
    }
    return Said(kInversionSays, !IsInverted(record, frame), kToldNotInverse(SrdoCause::kNotInverse));
}

void TakeNormal(Record& record, const CanFrame& frame, std::uint32_t stamp_us) noexcept
{
    Reception& at = record.reception;
    at.is_pending = kKeepsPending();
    at.is_too_old = false;
    at.pending_us = kPendingStamp(stamp_us);
    std::fill(std::begin(at.pending.at), std::end(at.pending.at), std::uint8_t{0U});
    std::copy_n(frame.data, kPendingData() ? LengthOf(record) : 0U, at.pending.at);
}

void TakeInverse(Record& record, std::uint32_t stamp_us) noexcept
{
    Reception& at = record.reception;
    if (kKeepsPair())
    {
        at.is_held = true;
    }
    at.held = kHeldData() ? at.pending : at.held;
    at.held_us = kHeldFromInverse() ? kHeldStamp(at.pending_us) : stamp_us;
    at.ordinal = kOrdinal(kOrdinalUp(at.ordinal));
    at.is_pending = !kNoLongerPending();
    at.is_fresh = kFresh();
    at.is_written = kNotWritten() ? false : at.is_written;
    at.had_pair = true;
    at.had_pair_or_fault = at.had_pair_or_fault || (kWaitingPair() && kWaitingEnds());
}

/// Limits in the cycle; whether one has expired. [SRS_CONS_014]
bool ExamineInCycle(const Common& common, Record& record) noexcept
{
    Reception& at = record.reception;
    bool has_expired = false;
    if (kExaminesCycle())
    {
        const bool is_late_found = kLateInCycle(IsLate(record));
        const bool is_pending = kPendingInCycle(at.is_pending);
        if (is_pending && (!is_late_found))
        {
            has_expired = IsSrvtOver(record, common.now_us, false);
            if (has_expired)
            {
                SrvtFault(record);
            }
        }
        else if (IsSctOver(record, common.now_us, false))
        {
            has_expired = true;
            SctFault(record);
        }
        else if (at.is_pending && ((common.now_us - at.pending_us) > SrvtOf(record)))
        {
            at.is_too_old = true;
        }
    }
    return has_expired;
}

/// Limits, then what else a call may find. [SRS_CONS_018]
void RecordCycle(const Common& common, Record& record, bool is_late, bool is_lossy) noexcept
{
    if (!kAllCauses())
    {
        return;
    }
    const bool has_expired = ExamineInCycle(common, record);
    if (is_late && (!kUnlessExpired(has_expired)) && kLateCall())
    {
        RecordFault(record, kToldLateCall(SrdoCause::kLateCall));
    }
    if (is_lossy && kOverflow())
    {
        RecordFault(record, kToldQueueOverflow(SrdoCause::kQueueOverflow));
    }
    if (kGfcPending(common.has_gfc) && kGfc())
    {
        RecordFault(record, kToldGfc(SrdoCause::kGfc));
    }
}

/// The cycle that reports a fault. [SRS_CONS_013]
void Report(Record& record) noexcept
{
    Reception& at = record.reception;
    record.is_fault_reported = kIsReported(record.has_fault);
    record.has_fault = false;
    if (record.is_fault_reported)
    {
        const bool discards = kDiscardsAll();
        at.is_held = at.is_held && (!(discards && kDiscards()));
        at.is_fresh = at.is_fresh && at.is_held;
        at.ordinal = (discards && kDiscardsOrdinal()) ? 0U : at.ordinal;
        at.is_pending = at.is_pending && kPendingStays();
        record.button.is_waiting = record.button.is_waiting && (!kForgetsEdgeOfCall());
    }
}

} // namespace

void CountFault(Record& record, SrdoCause cause) noexcept
{
    record.cause = kIsFirst(record.cause != SrdoCause::kNone) ? record.cause : kFirstCause(cause);
    const bool is_full = kIsFull(record.errors == 0xFFFFU);
    record.errors = ((!is_full) && kCounts()) ? kCount(kErrors(record.errors)) : record.errors;
}

void RecordFault(Record& record, SrdoCause cause) noexcept
{
    RecordAs(record, cause, cause);
}

void RecordAs(Record& record, SrdoCause cause, SrdoCause signalled) noexcept
{
    Reception& at = record.reception;
    at.is_pending = at.is_pending && (!kDropsPending());
    at.is_too_old = false;
    at.is_held = at.is_held && (!kDropsHeld());
    at.is_fresh = at.is_fresh && at.is_held;
    at.ordinal = kOrdinalZero() ? 0U : at.ordinal;
    record.button.is_waiting = record.button.is_waiting && (!kForgetsEdge());
    if (kRecorded())
    {
        CountFault(record, cause);
    }
    record.recorded |= kSignals() ? (1U << (kSignalBit(static_cast<std::uint32_t>(signalled)) % 32U)) : 0U;
    record.has_fault = record.has_fault || kFaultIsReported();
    at.had_fault = true;
    at.had_pair_or_fault = at.had_pair_or_fault || (kWaitingFault() && kWaitingEnds());
    if ((record.state != SrdoState::kProducer) && kFaultedState())
    {
        record.state = SrdoState::kFaulted;
    }
}

void TakeFrame(Common& common, Record& record, const CanFrame& frame, std::uint32_t stamp_us) noexcept
{
    const bool is_inverse = kIsInverse(frame.identifier == record.stored.cob_id_2);
    ExamineAtFrame(record, stamp_us, is_inverse);
    const Flaw flaw = FlawOf(common, record, frame, is_inverse);
    const SrdoCause cause = kFlawSays(flaw.cause);
    if (kFlawFound(flaw.is_found || (cause != SrdoCause::kNone)))
    {
        if (flaw.is_told)
        {
            RecordFault(record, cause);
        }
        if (flaw.is_refused)
        {
            return;
        }
    }
    if (is_inverse)
    {
        TakeInverse(record, stamp_us);
    }
    else
    {
        TakeNormal(record, frame, stamp_us);
    }
    if (kFrameHasFlaw(false))
    {
        RecordFault(record, SrdoCause::kNone);
    }
}

void EnterConsumer(Record& record, std::uint32_t now_us) noexcept
{
    if (kEntersEmpty())
    {
        record.reception = Reception{};
    }
    record.reception.entered_us = kWaitingFrom(now_us);
    record.state = kEntersWaiting() ? SrdoState::kWaiting : record.state;
}

void LeaveConsumer(Record& record) noexcept
{
    if (kLeavingFault())
    {
        RecordFault(record, kToldNotOperational(SrdoCause::kNotOperational));
    }
    record.state = kLeavingOff() ? SrdoState::kOff : record.state;
    const std::uint32_t ordinal = kLeavingOrdinal() ? 0U : record.reception.ordinal;
    if (kLeavingEmpty())
    {
        record.reception = Reception{};
    }
    record.reception.ordinal = ordinal;
    record.button.is_waiting = record.button.is_waiting && (!kLeavingForgets());
}

/// [SRS_REL_005]
void FollowButton(const Common& common, Record& record, bool bit) noexcept
{
    Button& button = record.button;
    const bool is_one = kTwoOnes(bit, button.bit);
    const bool is_zero = kTwoZeros(!bit, !button.bit);
    const bool is_same = kTwoEqual(is_one || is_zero);
    const bool followed = kLevelBy(is_one, button.level && (!is_zero));
    const bool given = (is_one || is_zero) ? followed : bit;
    const bool level = is_same ? given : button.level;
    const bool is_edge = is_same && kEdgeOf(kIsHigh(level), kWasLow(!button.level));
    button.level = kKeepsLevel() ? level : button.level;
    button.bit = kKeepsBit() ? bit : button.bit;
    if (button.is_waiting && kWindow(common.now_us, button.edge_us, kWindowUs(common.config.acknowledge_window_us)))
    {
        button.is_waiting = !kForgotten();
    }
    button.is_edge = is_edge && kEdgeActive(record.is_active);
    if (button.is_edge)
    {
        button.edge_us = (button.is_waiting && (!kNewWindow())) ? button.edge_us : kEdgeFrom(common.now_us);
        button.is_waiting = kWaitsFor(kEdgeWaits(), button.is_waiting);
    }
}

/// Limits in the cycle, the other causes, release. [SRS_CONS_014, SRS_CONS_018]
void CycleConsumer(const Common& common, Record& record, bool is_late, bool is_lossy) noexcept
{
    Reception& at = record.reception;
    RecordCycle(common, record, is_late, is_lossy);
    record.button.is_waiting = record.button.is_waiting && kConsumerEdge();
    Report(record);
    const bool has_edge = kEdgeIs(record.button.is_waiting);
    const bool is_automatic = kAutomatic(record.setup.policy == ReleasePolicy::kAutomatic);
    if (kReleaseWith(kHeldForRelease(at.is_held), kNotReleasedNow(!record.is_fault_reported)) &&
        kReleaseBy(is_automatic, kEdgeForRelease(has_edge)) && kReleases())
    {
        record.state = SrdoState::kReleased;
    }
    if (kClearsWith(kClearsReleasedOnly(record.state == SrdoState::kReleased), kEdgeForClear(has_edge)))
    {
        record.cause = kClearsCause() ? SrdoCause::kNone : record.cause;
        record.button.is_waiting = record.button.is_waiting && (!kUsesEdge());
    }
    const bool is_past = kWaitingLimit(common.now_us, at.entered_us, kWaitingSct(kSct(record.stored.sct_ms)));
    const bool waits = kWaitingState(record.state == SrdoState::kWaiting) && kWaitingNothing(!at.had_pair_or_fault);
    const bool still = kWaitsForPair() ? (kWaitsForFault() ? waits : (!at.had_pair)) : (!at.had_fault);
    if (kWaitingStill(kWaitsAtAll(still) && (!at.is_late_told)) && is_past && kWaitingTold())
    {
        record.recorded |= 1U << static_cast<std::uint32_t>(SrdoCause::kWaitingPastSct);
        at.is_late_told = kWaitingOnce();
    }
}

} // namespace counterpoint::twins::plain
