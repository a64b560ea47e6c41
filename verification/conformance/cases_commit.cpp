// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Writing the objects. Gold: 6010h:01, 02 by A, 6011h:01, 02 by B; pair 12h 34h, safe value A5h C3h. Untouched objects
// read 66h. Times in microseconds.
#include "verification/conformance/gold.hpp"
#include "verification/trace/ids/channel.hpp"

namespace counterpoint::conformance
{

namespace
{
// clang-format off: a line is a moment, a step stands beside what it must lead to.
constexpr Step kSafeAtValidate[] = {
    NormalObject(0x6010U, 1U, 0x66U), InverseObject(0x6011U, 1U, 0x66U), StoreAll(), NormalObject(0x6010U, 1U, 0x66U),
    InverseObject(0x6011U, 1U, 0x66U), Validate(0U, ConfigFault::kNone, 0x4370U),
    NormalObject(0x6010U, 1U, 0xA5U), NormalObject(0x6010U, 2U, 0xC3U), InverseObject(0x6011U, 1U, 0x5AU),
    InverseObject(0x6011U, 2U, 0x3CU),
};

constexpr Step kUntouchedByFault[] = {
    StoreAll(), Store(0U, ConfigField::kSignature, 0x4369U), Validate(0U, ConfigFault::kSignature, 0x4370U),
    NormalObject(0x6010U, 1U, 0x66U), NormalObject(0x6010U, 2U, 0x66U), InverseObject(0x6011U, 1U, 0x66U),
    InverseObject(0x6011U, 2U, 0x66U),
};

constexpr Step kWritten[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(1500U), Cycle(2000U), NormalObject(0x6010U, 1U, 0xA5U),
    InverseObject(0x6011U, 1U, 0x5AU),
    Commit(1U, 1U), NormalObject(0x6010U, 1U, 0x12U), NormalObject(0x6010U, 2U, 0x34U),
    InverseObject(0x6011U, 1U, 0xEDU), InverseObject(0x6011U, 2U, 0xCBU),
    Cycle(3000U), Commit(1U, 1U), NormalObject(0x6010U, 1U, 0x12U), InverseObject(0x6011U, 1U, 0xEDU),
    OtherNormal(3500U), OtherInverse(3600U),
    NormalObject(0x6010U, 1U, 0x12U), Cycle(4000U), Commit(1U, 1U), NormalObject(0x6010U, 1U, 0x56U),
    NormalObject(0x6010U, 2U, 0x78U),
    InverseObject(0x6011U, 1U, 0xA9U), InverseObject(0x6011U, 2U, 0x87U),
};

constexpr Step kNotAgreed[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(1500U), Cycle(2000U), Commit(0U, 1U),
    NormalObject(0x6010U, 1U, 0xA5U), InverseObject(0x6011U, 1U, 0x5AU),
    Commit(0U, 0U), NormalObject(0x6010U, 1U, 0xA5U), Commit(2U, 3U), NormalObject(0x6010U, 1U, 0xA5U),
};

constexpr Step kNotMatched[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(1500U), Cycle(2000U), Commit(1U, 0U),
    NormalObject(0x6010U, 1U, 0xA5U), InverseObject(0x6011U, 1U, 0x5AU),
    Cycle(3000U), Commit(1U, 1U), NormalObject(0x6010U, 1U, 0x12U), InverseObject(0x6011U, 1U, 0xEDU),
};

// A newer pair that the other channel does not have yet: what was written before stays.
constexpr Step kNewerNotMatched[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(1500U), Cycle(2000U), Commit(1U, 1U), OtherNormal(2500U),
    OtherInverse(2600U), Cycle(3000U), Commit(1U, 0U),
    NormalObject(0x6010U, 1U, 0x12U), InverseObject(0x6011U, 1U, 0xEDU),
    Answer(0x12345678U, 1U, 0x950DFAA9U, 0x00A2AC3FU), Cycle(4000U), Commit(1U, 1U),
    NormalObject(0x6010U, 1U, 0x56U), InverseObject(0x6011U, 1U, 0xA9U),
};

constexpr Step kNoLongerAgreed[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(1500U), Cycle(2000U), Commit(1U, 1U), Cycle(3000U), Commit(0U, 1U),
    NormalObject(0x6010U, 1U, 0xA5U),
    NormalObject(0x6010U, 2U, 0xC3U), InverseObject(0x6011U, 1U, 0x5AU), InverseObject(0x6011U, 2U, 0x3CU),
    Answer(0x12345678U, 0U, 0xF6D680F8U, 0x7AB6E1C8U),
    // Agreed without matched does not bring it back; a new pair does.
    Cycle(4000U), Commit(1U, 0U), NormalObject(0x6010U, 1U, 0xA5U), InverseObject(0x6011U, 1U, 0x5AU),
    OtherNormal(4100U), OtherInverse(4200U), Cycle(5000U),
    Commit(1U, 1U), NormalObject(0x6010U, 1U, 0x56U), InverseObject(0x6011U, 1U, 0xA9U),
};

// The channel's own state counts, whatever the comparator says.
constexpr Step kOwnFault[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(1500U), Cycle(2000U), Commit(1U, 1U), Inverse(2500U), Cycle(3000U),
    Commit(1U, 1U),
    NormalObject(0x6010U, 1U, 0xA5U), NormalObject(0x6010U, 2U, 0xC3U), InverseObject(0x6011U, 1U, 0x5AU),
    InverseObject(0x6011U, 2U, 0x3CU),
    Answer(0x12345678U, 0U, 0xF6D680F8U, 0x7AB6E1C8U),
};

constexpr Step kOwnWaiting[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(1500U), Cycle(2000U), Masks(0U, 0U, 1U, 0U, 1U), Commit(1U, 1U),
    NormalObject(0x6010U, 1U, 0xA5U),
    InverseObject(0x6011U, 1U, 0x5AU), Answer(0x12345678U, 0U, 0xF6D680F8U, 0x7AB6E1C8U),
};

constexpr Step kDemoted[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(1500U), Cycle(2000U), Commit(1U, 1U), Cycle(3000U), Demote(0U),
    Commit(1U, 1U),
    NormalObject(0x6010U, 1U, 0xA5U), InverseObject(0x6011U, 1U, 0x5AU),
    Answer(0x12345678U, 0U, 0xF6D680F8U, 0x7AB6E1C8U),
};

constexpr Step kLeft[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(1500U), Cycle(2000U), Commit(1U, 1U),
    Answer(0x12345678U, 1U, 0x950DFAA9U, 0x00A2AC3FU),
    Nmt(NmtState::kStopped), Cycle(3000U), Answer(0x12345678U, 0U, 0xF6D680F8U, 0x7AB6E1C8U), Commit(1U, 1U),
    NormalObject(0x6010U, 1U, 0xA5U),
    InverseObject(0x6011U, 1U, 0x5AU), Answer(0x12345678U, 0U, 0xF6D680F8U, 0x7AB6E1C8U), Nmt(NmtState::kOperational),
    Cycle(4000U), Commit(1U, 1U),
    NormalObject(0x6010U, 1U, 0xA5U), InverseObject(0x6011U, 1U, 0x5AU),
    Answer(0x12345678U, 0U, 0xF6D680F8U, 0x7AB6E1C8U),
};

// Two pairs between two commits: only the newest is written.
constexpr Step kTwoPairs[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(1100U), OtherNormal(1200U), OtherInverse(1300U), Cycle(2000U),
    Commit(1U, 1U),
    NormalObject(0x6010U, 1U, 0x56U), NormalObject(0x6010U, 2U, 0x78U), InverseObject(0x6011U, 1U, 0xA9U),
    InverseObject(0x6011U, 2U, 0x87U),
};

constexpr Step kOneOfTwo[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(1001U), Frame(0x103U, 4U, 0xDDCCBBAAU, 0U, 1002U),
    Frame(0x104U, 4U, 0x22334455U, 0U, 1003U), Cycle(2000U),
    Commit(2U, 2U), NormalObject(0x6010U, 1U, 0xA5U), InverseObject(0x6011U, 1U, 0x5AU),
    NormalObject(0x6200U, 1U, 0xDDCCBBAAU),
    InverseObject(0x6201U, 1U, 0x22334455U), Answer(0xDEADBEEFU, 2U, 0xD927EDA1U, 0x17A8EC07U), Commit(3U, 3U),
    NormalObject(0x6010U, 1U, 0x12U),
    Answer(0xDEADBEEFU, 3U, 0x775F6752U, 0x9D94B67EU), Commit(1U, 1U), NormalObject(0x6200U, 1U, 0x44332211U),
    InverseObject(0x6201U, 1U, 0xBBCCDDEEU),
};

constexpr Step kSixteen[] = {
    Configure(), NormalObject(0x6631U, 1U, 0x01U), NormalObject(0x6631U, 8U, 0x08U), InverseObject(0x6633U, 1U, 0xFEU),
    InverseObject(0x6633U, 8U, 0xF7U),
    Cycle(0U), Frame(0x17FU, 8U, 0x44332211U, 0x88776655U, 100U), Frame(0x180U, 8U, 0xBBCCDDEEU, 0x778899AAU, 200U),
    Cycle(1000U), Commit(1U, 1U),
    NormalObject(0x6631U, 1U, 0x11U), NormalObject(0x6631U, 2U, 0x22U), NormalObject(0x6631U, 3U, 0x33U),
    NormalObject(0x6631U, 4U, 0x44U),
    NormalObject(0x6631U, 5U, 0x55U), NormalObject(0x6631U, 6U, 0x66U), NormalObject(0x6631U, 7U, 0x77U),
    NormalObject(0x6631U, 8U, 0x88U),
    InverseObject(0x6633U, 1U, 0xEEU), InverseObject(0x6633U, 2U, 0xDDU), InverseObject(0x6633U, 3U, 0xCCU),
    InverseObject(0x6633U, 4U, 0xBBU),
    InverseObject(0x6633U, 5U, 0xAAU), InverseObject(0x6633U, 6U, 0x99U), InverseObject(0x6633U, 7U, 0x88U),
    InverseObject(0x6633U, 8U, 0x77U),
};

constexpr Step kSixtyFourBits[] = {
    Configure(), NormalObject(0x6300U, 8U, 0x04030201U, 0x08070605U),
    InverseObject(0x6301U, 8U, 0xFBFCFDFEU, 0xF7F8F9FAU), Cycle(0U),
    Frame(0x105U, 8U, 0x44332211U, 0x88776655U, 100U), Frame(0x106U, 8U, 0xBBCCDDEEU, 0x778899AAU, 200U), Cycle(1000U),
    Commit(1U, 1U),
    NormalObject(0x6300U, 8U, 0x44332211U, 0x88776655U), InverseObject(0x6301U, 8U, 0xBBCCDDEEU, 0x778899AAU),
};

constexpr Step kSizes[] = {
    Configure(), NormalObject(0x6300U, 3U, 0x030201U), NormalObject(0x6300U, 2U, 0x0504U),
    NormalObject(0x6300U, 1U, 0x06U), InverseObject(0x6301U, 3U, 0xFCFDFEU),
    InverseObject(0x6301U, 2U, 0xFAFBU), InverseObject(0x6301U, 1U, 0xF9U), Cycle(0U),
    Frame(0x107U, 6U, 0x44332211U, 0x6655U, 100U),
    Frame(0x108U, 6U, 0xBBCCDDEEU, 0x99AAU, 200U), Data(0U, 0x44332211U, 0x6655U), Cycle(1000U), Commit(1U, 1U),
    NormalObject(0x6300U, 3U, 0x332211U),
    NormalObject(0x6300U, 2U, 0x5544U), NormalObject(0x6300U, 1U, 0x66U), InverseObject(0x6301U, 3U, 0xCCDDEEU),
    InverseObject(0x6301U, 2U, 0xAABBU),
    InverseObject(0x6301U, 1U, 0x99U), NormalObject(0x6300U, 4U, 0x66666666U), InverseObject(0x6301U, 4U, 0x66666666U),
};

// Producers and SRDOs that are off have nothing to write, whatever the masks say.
constexpr Step kNoConsumer[] = {
    Configure(), Cycle(0U), Commit(0xFFFFFFFFFFFFFFFFU, 0xFFFFFFFFFFFFFFFFU), NormalObject(0x6210U, 1U, 0x66U),
    InverseObject(0x6211U, 1U, 0x66U),
    Answer(0x12345678U, 0U, 0xF6D680F8U, 0x7AB6E1C8U),
};

// Validated again before the cycle that sees OPERATIONAL left: the safe value stands, and there is no permit for it.
constexpr Step kValidatedAgain[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(1500U), Cycle(2000U), Commit(1U, 1U),
    Answer(0x12345678U, 1U, 0x950DFAA9U, 0x00A2AC3FU),
    Validate(0U, ConfigFault::kNone, 0x4370U), NormalObject(0x6010U, 1U, 0xA5U), InverseObject(0x6011U, 1U, 0x5AU),
    Answer(0x12345678U, 0U, 0xF6D680F8U, 0x7AB6E1C8U),
};

// ---- reading back: both objects in one place, so that the second one overwrites the first

constexpr Step kOverwritten[] = {
    Share(0x6010U, 1U, 0x6010U, 2U), Share(0x6011U, 1U, 0x6011U, 2U), Configure(), Cycle(0U), Normal(1000U),
    Inverse(1500U), Cycle(2000U), Examine(0U, 1U), Commit(1U, 1U), Answer(0x12345678U, 0U, 0xF6D680F8U, 0x7AB6E1C8U),
    // Nothing new, nothing to examine: nothing is read.
    Cycle(3000U), Commit(1U, 1U), Answer(0x12345678U, 1U, 0x950DFAA9U, 0x00A2AC3FU),
    Cycle(4000U), Examine(1U, 1U), Commit(1U, 1U), Answer(0x12345678U, 0U, 0xF6D680F8U, 0x7AB6E1C8U),
    // The safe value is A5h C3h.
    Cycle(5000U), Examine(0U, 1U), Commit(0U, 0U), Answer(0x12345678U, 0U, 0xF6D680F8U, 0x7AB6E1C8U),
    Cycle(6000U), Examine(1U, 0U), Commit(0U, 0U),
};

// Changed behind the writing: found when its turn comes, in the upper byte too.
constexpr Step kChangedLater[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(1500U), Cycle(2000U), Examine(1U, 0U), Commit(1U, 1U),
    Cycle(3000U), Examine(1U, 0U), Commit(1U, 1U), Answer(0x12345678U, 1U, 0x950DFAA9U, 0x00A2AC3FU),
    Put(0x6010U, 2U, 0x35U), Put(0x6011U, 2U, 0xCAU), Cycle(4000U), Commit(1U, 1U),
    Answer(0x12345678U, 1U, 0x950DFAA9U, 0x00A2AC3FU), Cycle(5000U), Examine(1U, 1U), Commit(1U, 1U),
    Answer(0x12345678U, 0U, 0xF6D680F8U, 0x7AB6E1C8U),
    Put(0x6010U, 2U, 0x34U), Put(0x6011U, 2U, 0xCBU), Put(0x6010U, 1U, 0x92U), Put(0x6011U, 1U, 0x6DU),
    Cycle(6000U), Examine(1U, 1U), Commit(1U, 1U),
    Put(0x6010U, 1U, 0x12U), Put(0x6011U, 1U, 0xEDU), Cycle(7000U), Examine(1U, 0U), Commit(1U, 1U),
    Answer(0x12345678U, 1U, 0x950DFAA9U, 0x00A2AC3FU),
};

// A newer pair that is held, but not matched: the objects still have the older one, and are not looked at.
constexpr Step kNewerIsNotExamined[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(1500U), Cycle(2000U), Commit(1U, 1U), OtherNormal(2500U),
    OtherInverse(2600U), Cycle(3000U), Examine(1U, 0U), Commit(1U, 0U),
    Answer(0x12345678U, 1U, 0x950DFAA9U, 0x00A2AC3FU), Cycle(4000U), Examine(1U, 0U), Commit(1U, 1U),
    NormalObject(0x6010U, 1U, 0x56U), InverseObject(0x6011U, 1U, 0xA9U),
};

// Neither what is not released nor what the mask does not name.
constexpr Step kNotExamined[] = {
    Configure(), Put(0x6010U, 1U, 0U), Put(0x6011U, 1U, 0U), Cycle(0U), Examine(~SrdoMask{0U}, 0U), Commit(0U, 0U),
    Normal(1000U), Inverse(1500U), Cycle(2000U), Commit(1U, 1U), Put(0x6010U, 1U, 0U), Put(0x6011U, 1U, 0U),
    Cycle(3000U), Examine(~SrdoMask{1U}, 0U), Commit(1U, 1U), Answer(0x12345678U, 1U, 0x950DFAA9U, 0x00A2AC3FU),
};

// No permit of a cycle before: without Commit there is none.
constexpr Step kLeftOut[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(1500U), Cycle(2000U), Commit(1U, 1U),
    Answer(0x12345678U, 1U, 0x950DFAA9U, 0x00A2AC3FU), Cycle(3000U), Answer(0x12345678U, 0U, 0xF6D680F8U, 0x7AB6E1C8U),
    Commit(1U, 1U), Answer(0x12345678U, 1U, 0x950DFAA9U, 0x00A2AC3FU),
};

constexpr Step kSixteenExamined[] = {
    Configure(), Cycle(0U), Frame(0x17FU, 8U, 0x44332211U, 0x88776655U, 100U),
    Frame(0x180U, 8U, 0xBBCCDDEEU, 0x778899AAU, 200U), Cycle(1000U), Commit(1U, 1U),
    Cycle(1100U), Examine(1U, 0U), Commit(1U, 1U), Put(0x6631U, 8U, 0x08U), Put(0x6633U, 8U, 0x07U),
    Cycle(1200U), Examine(1U, 1U), Commit(1U, 1U), Put(0x6631U, 8U, 0x88U), Put(0x6633U, 8U, 0x77U),
    Put(0x6631U, 5U, 0x54U), Put(0x6633U, 5U, 0xABU), Cycle(1300U), Examine(1U, 1U), Commit(1U, 1U),
};

constexpr Step kSixtyFourBitsExamined[] = {
    Configure(), Cycle(0U), Frame(0x105U, 8U, 0x44332211U, 0x88776655U, 100U),
    Frame(0x106U, 8U, 0xBBCCDDEEU, 0x778899AAU, 200U), Cycle(1000U), Commit(1U, 1U),
    Put(0x6300U, 8U, 0x44332210U, 0x88776655U), Put(0x6301U, 8U, 0xBBCCDDEFU, 0x778899AAU),
    Cycle(1100U), Examine(1U, 1U), Commit(1U, 1U),
    Put(0x6300U, 8U, 0x44332211U, 0x08776655U), Put(0x6301U, 8U, 0xBBCCDDEEU, 0xF78899AAU),
    Cycle(1200U), Examine(1U, 1U), Commit(1U, 1U),
    Put(0x6300U, 8U, 0x44332211U, 0x88776655U), Put(0x6301U, 8U, 0xBBCCDDEEU, 0x778899AAU),
    Cycle(1300U), Examine(1U, 0U), Commit(1U, 1U),
};

// What was written once is not written again: agreed anew, the same pair stays away.
constexpr Step kAgreedAgain[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(1500U), Cycle(2000U), Commit(1U, 1U), Cycle(3000U), Commit(0U, 1U),
    Cycle(4000U), Commit(1U, 1U), NormalObject(0x6010U, 1U, 0xA5U), InverseObject(0x6011U, 1U, 0x5AU),
    Answer(0x12345678U, 0U, 0xF6D680F8U, 0x7AB6E1C8U),
};

// Written and examined in one call.
constexpr Step kOverwrittenAndExamined[] = {
    Share(0x6010U, 1U, 0x6010U, 2U), Share(0x6011U, 1U, 0x6011U, 2U), Configure(), Cycle(0U), Normal(1000U),
    Inverse(1500U), Cycle(2000U), Examine(1U, 1U), Commit(1U, 1U), Answer(0x12345678U, 0U, 0xF6D680F8U, 0x7AB6E1C8U),
};

// The object of the second slot changes: found where that slot is examined, and told of it alone.
constexpr Step kOneOfTwoExamined[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(1001U), Frame(0x103U, 4U, 0xDDCCBBAAU, 0U, 1002U),
    Frame(0x104U, 4U, 0x22334455U, 0U, 1003U), Cycle(2000U), Commit(3U, 3U), Put(0x6200U, 1U, 0xDDCCBBABU),
    Put(0x6201U, 1U, 0x22334454U), Cycle(3000U), Examine(1U, 0U), Commit(3U, 3U),
    Answer(0xDEADBEEFU, 3U, 0x775F6752U, 0x9D94B67EU), Cycle(4000U), Examine(3U, 2U), Commit(3U, 3U),
    Answer(0xDEADBEEFU, 1U, 0x3AF073F0U, 0x91BD2190U),
};

// The held pair is what counts, even if it came behind the cycle.
constexpr Step kBehindTheCycle[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(1500U), Cycle(2000U), OtherNormal(2100U), OtherInverse(2200U),
    Commit(1U, 1U), NormalObject(0x6010U, 1U, 0x56U), NormalObject(0x6010U, 2U, 0x78U),
    InverseObject(0x6011U, 1U, 0xA9U), InverseObject(0x6011U, 2U, 0x87U),
    Answer(0x12345678U, 1U, 0x950DFAA9U, 0x00A2AC3FU),
};

constexpr Case kCases[] = {
    MakeCase("ValidateWritesTheSafeValue", {req::SRS_REL_002, req::SRS_REL_340}, kGold, kSafeAtValidate),
    MakeCase("ValidateWithFaultWritesNothing", {req::SRS_REL_002, req::SRS_REL_340, req::SRS_CFG_029}, kGold, kUntouchedByFault),
    MakeCase("AgreedAndMatchedIsWritten", {req::SRS_REL_002}, kGold, kWritten),
    MakeCase("NotAgreedIsNotWritten", {req::SRS_REL_002, req::SRS_REL_340}, kGold, kNotAgreed),
    MakeCase("NotMatchedIsNotWritten", {req::SRS_REL_002, req::SRS_REL_340}, kGold, kNotMatched),
    MakeCase("NewerPairNotMatchedLeavesTheOlder", {req::SRS_REL_002, req::SRS_REL_010}, kGold, kNewerNotMatched),
    MakeCase("NoLongerAgreedIsSafe", {req::SRS_REL_002, req::SRS_REL_010}, kGold, kNoLongerAgreed),
    MakeCase("OwnFaultIsSafeThoughAgreed", {req::SRS_REL_002, req::SRS_REL_010, req::SRS_CONS_012}, kGold, kOwnFault),
    MakeCase("OwnWaitingIsSafeThoughAgreed", {req::SRS_REL_002, req::SRS_REL_001}, kGoldLocked, kOwnWaiting),
    MakeCase("DemotedIsSafeThoughAgreed", {req::SRS_REL_002, req::SRS_REL_006}, kGold, kDemoted),
    MakeCase("LeavingOperationalIsSafe", {req::SRS_REL_002, req::SRS_REL_010, req::SRS_CONS_019}, kGold, kLeft),
    MakeCase("NewestOfTwoPairsIsWritten", {req::SRS_REL_002}, kGold, kTwoPairs),
    MakeCase("EachSlotIsWrittenForItself", {req::SRS_REL_002, req::SRS_REL_010}, kTwo, kOneOfTwo),
    MakeCase("SixteenEntriesAreWritten", {req::SRS_REL_002}, kWide, kSixteen),
    MakeCase("SixtyFourBitsAreWritten", {req::SRS_REL_002}, kLong, kSixtyFourBits),
    MakeCase("MixedSizesAreWritten", {req::SRS_REL_002}, kMixedSizes, kSizes),
    MakeCase("ValidatedAgainIsNotCommitted", {req::SRS_REL_002, req::SRS_REL_340, req::SRS_REL_010}, kGold, kValidatedAgain),
    MakeCase("OverwrittenIsFoundAtOnce", {req::SRS_REL_011, req::SRS_REL_010}, kGold, kOverwritten),
    MakeCase("ChangedLaterIsFoundInItsTurn", {req::SRS_REL_011, req::SRS_REL_010, req::SRS_REL_002}, kGold, kChangedLater),
    MakeCase("NewerPairNotMatchedIsNotExamined", {req::SRS_REL_011}, kGold, kNewerIsNotExamined),
    MakeCase("OthersAreNotExamined", {req::SRS_REL_011}, kGold, kNotExamined),
    MakeCase("NoCommitNoPermit", {req::SRS_REL_010}, kGold, kLeftOut),
    MakeCase("SixteenEntriesAreExamined", {req::SRS_REL_011}, kWide, kSixteenExamined),
    MakeCase("SixtyFourBitsAreExamined", {req::SRS_REL_011}, kLong, kSixtyFourBitsExamined),
    MakeCase("NothingIsWrittenForOthers", {req::SRS_REL_002, req::SRS_REL_010}, kMixed, kNoConsumer),
    MakeCase("AgreedAgainIsNotWrittenAgain", {req::SRS_REL_002, req::SRS_REL_340, req::SRS_REL_010}, kGold,
             kAgreedAgain),
    MakeCase("OverwrittenIsFoundWhileExamined", {req::SRS_REL_011, req::SRS_REL_010}, kGold, kOverwrittenAndExamined),
    MakeCase("EachSlotIsExaminedForItself", {req::SRS_REL_011, req::SRS_REL_010}, kTwo, kOneOfTwoExamined),
    MakeCase("PairBehindTheCycleIsWritten", {req::SRS_REL_002}, kGold, kBehindTheCycle),
};
// clang-format on
} // namespace

const CaseTable kCommitCases = MakeTable("commit", kCases);

} // namespace counterpoint::conformance
