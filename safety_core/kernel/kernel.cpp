// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/kernel.hpp"

#include "safety_core/comparator/slot_mask.hpp"

namespace counterpoint
{
namespace
{

constexpr DeviceConfig kNoDevice{};
constexpr std::uint16_t kMostDemotions = 65535U;
constexpr std::uint32_t kPermitRotation = 16U;
constexpr std::uint32_t kWordBits = 32U;

// Every SRDO is examined or passed over for a named reason, or none is because SRDOs are not active.
FlowEvidence Coverage(const CycleOutcome& outcome, const DeviceConfig& config) noexcept
{
    const std::uint32_t seen = static_cast<std::uint32_t>(outcome.sct_checked) + outcome.is_tx + outcome.is_invalid;
    const std::uint32_t passed = static_cast<std::uint32_t>(outcome.not_operational) * config.srdo_count;
    return FlowEvidence{seen + passed, config.srdo_count};
}

constexpr FlowEvidence kDone{0U, 0U};

} // namespace

Kernel::Kernel(const KernelParts& parts) noexcept
    : parts_{parts}, config_{&kNoDevice}, guard_{parts.channel_a, parts.channel_b}
{
}

void Kernel::Adopt(const DeviceFaultReport& report) noexcept
{
    latch_.Enter(report.fault, report.slot);
}

// Before any other part is called. [SRS-STS-040, SRS-STS-063]
PartsView Kernel::ExamineSelf() noexcept
{
    if (parts_.self_test == nullptr)
    {
        flow_.Mark(FlowStep::kSelfTest, kDone);
        return PartsView::kSound;
    }
    const SelfTestOutcome outcome = parts_.self_test->OnCycle();
    latch_.Enter((outcome.parts == PartsView::kSound) ? outcome.fault : DeviceFault::kSelfTest, kNoSlot);
    flow_.Mark(FlowStep::kSelfTest, FlowEvidence{outcome.progress, cycle_});
    return outcome.parts;
}

void Kernel::OnFrame(const StampedFrame& frame) noexcept
{
    if (!started_)
    {
        return;
    }
    clocks_.OnFrame(frame.stamp);
    parts_.channel_a.OnFrame(frame.frame, frame.stamp.a);
    parts_.channel_b.OnFrame(frame.frame, frame.stamp.b);
    const bool is_gfc = (frame.frame.identifier == kGfcIdentifier) && (frame.frame.kind == FrameKind::kData) &&
                        (frame.frame.length_bytes == 0U);
    if (is_gfc)
    {
        gfc_seen_ = true;
    }
}

void Kernel::OnOverflow() noexcept
{
    queue_ = QueueState::kOverflowed;
}

void Kernel::Cycle(const CycleCall& call) noexcept
{
    if (!started_)
    {
        return;
    }
    ++cycle_;
    now_ = call.now;
    flow_.Begin();
    if (ExamineSelf() != PartsView::kSound)
    {
        return; // No permit, no answer to the watchdog: the outputs close, and nobody can be called to be told.
    }
    const std::uint32_t challenge = parts_.output.Challenge();

    latch_.Enter(clocks_.OnCycle(call.now), kNoSlot);
    flow_.Mark(FlowStep::kClocks, kDone);
    const std::uint32_t token = guard_.Cycle(challenge);
    Adopt(guard_.TakeFinding());
    flow_.Mark(FlowStep::kGuard, kDone);

    // OPERATIONAL that was left and entered again between two cycles was left: the channels see one cycle outside of
    // it.
    const NmtState nmt = left_operational_ ? NmtState::kPreOperational : nmt_;
    left_operational_ = false;
    const CycleInput input_a{call.now.a, challenge, token, call.acknowledge_a, requests_, stand_a_, nmt, queue_};
    const CycleInput input_b{call.now.b, challenge, token, call.acknowledge_b, requests_, stand_b_, nmt, queue_};
    queue_ = QueueState::kIntact;
    requests_ = 0U;
    const CycleOutcome outcome_a = parts_.channel_a.OnCycle(input_a);
    flow_.Mark(FlowStep::kChannelA, FlowEvidence{outcome_a.cycle, cycle_});
    const CycleOutcome outcome_b = parts_.channel_b.OnCycle(input_b);
    flow_.Mark(FlowStep::kChannelB, FlowEvidence{outcome_b.cycle, cycle_});

    CompareOutcomes(call, challenge, outcome_a, outcome_b);
    flow_.Mark(FlowStep::kComparison, FlowEvidence{verdict_.echo, challenge});
    Demote();
    flow_.Mark(FlowStep::kDemotion, kDone);
    // Each channel's refresh runs by its own counter; the one that is ahead waits for the other. [SRS-KRN-017]
    stand_a_ = outcome_a.due & ~outcome_b.due;
    stand_b_ = outcome_b.due & ~outcome_a.due;
    Produce();
    flow_.Mark(FlowStep::kProduction, kDone);
    Commit();
    flow_.Mark(FlowStep::kCommit, kDone);
    ReportErrors(outcome_a.signalled | outcome_b.signalled);
    ReportReceived(received_mask_);
    ReportFlow(outcome_a);
    flow_.Mark(FlowStep::kEvents, Coverage(outcome_b, *config_));
    GivePermits(challenge);
    flow_.Mark(FlowStep::kPermits, kDone);

    parts_.watchdog.Answer(flow_.End(parts_.watchdog.Question()));
    latch_.Enter(flow_.Finding(), kNoSlot);
    ReportDevice();
}

void Kernel::CompareOutcomes(const CycleCall& call, const std::uint32_t challenge, const CycleOutcome& a,
                             const CycleOutcome& b) noexcept
{
    const Comparison comparison{&a, &b, &parts_.channel_a, &parts_.channel_b, call.now.a, cycle_, challenge};
    --cycles_to_test_;
    if (cycles_to_test_ == 0U)
    {
        cycles_to_test_ = test_cycles_;
        TestComparator(comparison);
    }
    verdict_ = comparator_.Compare(comparison);
    latch_.Enter(verdict_.fault, verdict_.slot);
    if (verdict_.echo != challenge)
    {
        latch_.Enter(DeviceFault::kComparator, kNoSlot);
    }
}

// A comparator that always says yes is found by a difference that it must see, another one each time. [SRS-CMP-009]
void Kernel::TestComparator(const Comparison& comparison) noexcept
{
    constexpr std::uint8_t kVariants = 6U;
    CycleOutcome altered = *comparison.outcome_b;
    const std::uint8_t one = 1U;
    // The one field whose number it is gets its lowest bit flipped.
    altered.cycle ^= (test_number_ == 0U) ? 1U : 0U;
    altered.sct_checked ^= (test_number_ == 1U) ? one : std::uint8_t{0U};
    altered.is_tx ^= (test_number_ == 2U) ? one : std::uint8_t{0U};
    altered.is_invalid ^= (test_number_ == 3U) ? one : std::uint8_t{0U};
    altered.not_operational ^= (test_number_ == 4U) ? one : std::uint8_t{0U};
    altered.guard = (test_number_ == 5U) ? GuardView::kInvalid : altered.guard;
    test_number_ = static_cast<std::uint8_t>((test_number_ + 1U) % kVariants);

    Comparison deliberate = comparison;
    deliberate.outcome_b = &altered;
    const Verdict verdict = comparator_.Compare(deliberate);
    PreparedPair right{};
    right.normal.identifier = comparison.challenge;
    PreparedPair wrong = right;
    wrong.normal.data[test_number_] ^= one; // MISRA D-002
    const PreparedVerdict data = Comparator::ComparePrepared(right, wrong);
    if ((verdict.fault == DeviceFault::kNone) || (data != PreparedVerdict::kNotInverse))
    {
        latch_.Enter(DeviceFault::kComparator, kNoSlot);
    }
}

void Kernel::Demote() noexcept
{
    SlotSet to_demote{verdict_.demote};
    while (to_demote.mask != 0U)
    {
        const SlotIndex slot = TakeLowest(to_demote);
        parts_.channel_a.Demote(slot);
        parts_.channel_b.Demote(slot);
        if (demotions_ != kMostDemotions)
        {
            ++demotions_;
        }
    }
}

void Kernel::Commit() noexcept
{
    const SrdoMask agreed = verdict_.agreement.agreed & ~verdict_.demote & latch_.Gate();
    const SrdoMask written = agreed & verdict_.agreement.matched;
    const Agreement agreement{agreed, verdict_.agreement.matched};
    parts_.channel_a.Commit(agreement);
    parts_.channel_b.Commit(agreement);
    received_mask_ = written & (verdict_.newly_matched | ~committed_);
    committed_ = written | (committed_ & agreed);
}

// Computed from the comparator's echo and spoiled by a latch that is not running: there is nothing to decide.
// [SRS-KRN-005]
void Kernel::GivePermits(const std::uint32_t challenge) noexcept
{
    const Permit permit_a = parts_.channel_a.Answer(challenge);
    const Permit permit_b = parts_.channel_b.Answer(challenge);
    const std::uint32_t low = static_cast<std::uint32_t>(committed_);
    const std::uint32_t high = static_cast<std::uint32_t>(committed_ >> kWordBits);
    const std::uint32_t rotated = (high << kPermitRotation) | (high >> (kWordBits - kPermitRotation));
    const std::uint32_t response = ((verdict_.echo + latch_.Spoiler() + low) ^ rotated) * kPermitConstantKernel;
    parts_.output.Drive(hal::PermitSet{permit_a, permit_b, Permit{committed_, response}});
}

} // namespace counterpoint
