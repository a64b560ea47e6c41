// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What comparator and other channel make of a consumer. [SRS_REL_002, SRS_REL_006]
#include "verification/twins/plain/point.hpp"
#include "verification/twins/plain/record.hpp"

namespace counterpoint::twins::plain
{

namespace
{
// Demote.
const Decision kDemotable{"SRS_REL_006", "the slot is an active consumer"};
const Act kDemoteDrops{"SRS_REL_006", "a demoted slot holds no pair"};
const Act kDemoteOrdinal{"SRS_REL_006", "a demoted slot has ordinal 0"};
const Act kDemoteState{"SRS_REL_006", "a demoted slot is faulted"};
const Act kDemoteCounts{"SRS_REL_006", "a demotion counts"};
const Decision kDemoteFirst{"SRS_REL_006", "a demoted slot has a cause"};
const Act kDemoteEdge{"SRS_REL_006", "a demotion forgets an edge"};
const Decision kDemotePending{"SRS_REL_006", "a pending frame stays pending"};
const Number kDemoteCause{"SRS_REL_006", "cause of a demotion"};
const Act kDemoteWaiting{"SRS_REL_006", "a demotion ends waiting past SCT"};
const Decision kDemoteQuiet{"SRS_REL_006", "a demotion is not reported"};
const Decision kDemoteSilent{"SRS_REL_006", "a demotion is not signalled"};

// Commit.
const Decision kAgreed{"SRS_REL_002", "the slot is agreed"};
const Decision kMatched{"SRS_REL_002", "the slot is matched"};
const Decision kOwnState{"SRS_REL_002", "the channel's own state is released"};
const Decision kWritten{"SRS_REL_002", "the pair has been written"};
const Act kWritesPair{"SRS_REL_002", "the held pair is written"};
const Act kNotesWritten{"SRS_REL_002", "a written pair is not written again"};
const Act kNotesCommitted{"SRS_REL_002", "a slot whose pair is written is committed"};
const Act kReadsPair{"SRS_REL_011", "a written pair is read back"};
const Act kReadsSafe{"SRS_REL_011", "a written safe value is read back"};
const Decision kExaminesCommitted{"SRS_REL_011", "a slot that is examined is committed"};
const Decision kExaminesWritten{"SRS_REL_011", "the held pair of a slot that is examined has been written"};
const Number kValueOf{"SRS_REL_011", "first bit of what was written into an object"};
const Act kDummyLeft{"SRS_REL_011", "a dummy has no object to look at"};
const Decision kDiffers{"SRS_REL_011", "an object holds something else"};
const Act kWritesSafe{"SRS_REL_002", "the safe value is written"};
const Act kNoLongerCommitted{"SRS_REL_002", "a slot with the safe value is not committed"};
const Decision kWasCommitted{"SRS_REL_002", "the slot is committed"};
const Act kSafeMasked{"SRS_CFG_036", "bits of the safe value above the mapped length are 0"};
const Decision kEnds{"SRS_REL_002", "a committed slot is committed no longer"};
const Either kCommittedBy{"SRS_REL_002", "committed before, or by this pair"};
const Both kCommitOf{"SRS_REL_002", "agreed, and released here"};
const Both kCommitMatched{"SRS_REL_002", "agreed, and matched"};
const Act kDemoteEffect{"SRS_REL_006", "Demote has the effect of a fault"};
const Act kDemoteEffectEnds{"SRS_REL_006", "Demote has the effect of a fault and ends waiting past SCT"};
const Act kDemoteDiscards{"SRS_REL_006", "a demotion discards"};
const Act kDemoteRecorded{"SRS_REL_006", "a demotion is counted and is a cause"};

std::uint32_t BitAt(const Bytes& bytes, std::uint32_t bit) noexcept
{
    return (bit < kMaxPayloadBits) ? ((static_cast<std::uint32_t>(bytes.at[bit / 8U]) >> (bit % 8U)) & 1U) : 0U;
}

Bytes SafeOf(const Record& record) noexcept
{
    Bytes bytes = BytesOf(record.setup.safe_value);
    for (std::uint32_t i = 0U; i < kMaxPayloadBytes; ++i)
    {
        bytes.at[i] = static_cast<std::uint8_t>(bytes.at[i] & (kSafeMasked() ? MappedOf(record, i) : 0xFFU));
    }
    return bytes;
}

} // namespace

void DemoteConsumer(const Record& judged, Record& record, Record& counted) noexcept
{
    const bool is_state = (judged.state == SrdoState::kWaiting) || (judged.state == SrdoState::kFaulted) ||
                          (judged.state == SrdoState::kReleased);
    if (!kDemotable(judged.is_active && is_state))
    {
        return;
    }
    Reception& at = record.reception;
    const bool ends = kDemoteEffectEnds();
    const bool has_effect = kDemoteEffect() && ends;
    const bool discards = kDemoteDiscards() && has_effect;
    at.is_held = at.is_held && (!(discards && kDemoteDrops()));
    at.is_fresh = at.is_fresh && at.is_held;
    at.ordinal = (discards && kDemoteOrdinal()) ? 0U : at.ordinal;
    at.is_pending = at.is_pending && kDemotePending(true);
    record.state = (has_effect && kDemoteState()) ? SrdoState::kFaulted : record.state;
    const Record was = counted;
    if (kDemoteRecorded())
    {
        CountFault(counted, kDemoteCause(SrdoCause::kDemoted));
    }
    counted.errors = kDemoteCounts() ? counted.errors : was.errors;
    counted.cause = kDemoteFirst(false) ? was.cause : counted.cause;
    record.button.is_waiting = record.button.is_waiting && (!(discards && kDemoteEdge()));
    at.had_fault = at.had_fault || ends;
    at.had_pair_or_fault = at.had_pair_or_fault || (ends && kDemoteWaiting());
    record.has_fault = record.has_fault || (!kDemoteQuiet(true));
    record.recorded |= kDemoteSilent(true) ? 0U : (1U << static_cast<std::uint32_t>(SrdoCause::kDemoted));
}

/// [SRS_REL_002]
bool CommitConsumer(const Common& common, Record& record, bool is_agreed, bool is_matched) noexcept
{
    Reception& at = record.reception;
    const bool was_committed = record.is_committed;
    const bool is_released = kCommitOf(kAgreed(is_agreed), kOwnState(record.state == SrdoState::kReleased));
    if (kCommitMatched(is_released, kMatched(is_matched)))
    {
        if (!kWritten(at.is_written))
        {
            if (kWritesPair())
            {
                WriteObjects(record, common.side, at.held);
            }
            at.is_written = kNotesWritten();
            record.is_safe = false;
            const bool stays = was_committed && (!kEnds(false));
            record.is_committed = kCommittedBy(stays, kNotesCommitted());
            return kReadsPair();
        }
    }
    else if ((!is_released) && kWasCommitted(record.is_committed))
    {
        if (kWritesSafe())
        {
            WriteObjects(record, common.side, SafeOf(record));
        }
        record.is_safe = true;
        record.is_committed = !kEnds(kNoLongerCommitted());
        return kReadsSafe();
    }
    record.is_committed = was_committed && (!kEnds(false));
    return false;
}

/// [SRS_REL_011]
bool ReadBack(const Common& common, const Record& record, const Record& read, bool is_written,
              bool is_examined) noexcept
{
    const Reception& at = record.reception;
    const bool is_in_turn = is_examined && kExaminesCommitted(record.is_committed) && kExaminesWritten(at.is_written);
    if ((!is_written) && (!is_in_turn))
    {
        return false;
    }
    const Bytes expected = record.is_safe ? SafeOf(record) : at.held;
    const Bytes found = ReadObjects(read, common.side);
    bool is_other = false;
    std::uint32_t from = 0U;
    for (const Part& part : read.parts)
    {
        for (std::uint32_t bit = 0U; (bit < part.bits) && (part.place != nullptr); ++bit)
        {
            is_other = is_other || (BitAt(expected, kValueOf(from) + bit) != BitAt(found, from + bit));
        }
        is_other = is_other || ((part.place == nullptr) && (!kDummyLeft()));
        from += part.bits;
    }
    return kDiffers(is_other);
}

} // namespace counterpoint::twins::plain
