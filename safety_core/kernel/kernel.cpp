// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/kernel.hpp"

#include "safety_core/comparator/slot_mask.hpp"

namespace counterpoint
{
namespace
{

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

constexpr std::uint32_t kCounts = 4U;
// What the test of the comparator alters one by one, besides the guard's view and the number of the cycle. MISRA D-001
constexpr std::uint8_t CycleOutcome::* kCount[kCounts] = {&CycleOutcome::sct_checked, &CycleOutcome::is_tx,
                                                          &CycleOutcome::is_invalid, &CycleOutcome::not_operational};

// One bit of one member; doing it again undoes it.
void Alter(CycleOutcome& outcome, const std::uint32_t number) noexcept
{
    if (number < kCounts)
    {
        outcome.*kCount[number] ^= 1U; // MISRA D-002
    }
    else if (number == kCounts)
    {
        outcome.guard = static_cast<GuardView>(static_cast<std::uint32_t>(outcome.guard) ^ 1U);
    }
    else
    {
        outcome.cycle ^= 1U;
    }
}

} // namespace

Kernel::Kernel(const KernelParts& parts) noexcept
    : parts_{parts}, config_{&kNoDevice}, guard_{parts.channel_a, parts.channel_b, latch_}
{
}

// Before any other part is called. [SRS_STS_040, SRS_STS_063]
PartsView Kernel::ExamineSelf() noexcept
{
    if (parts_.self_test == nullptr)
    {
        flow_.Mark(FlowStep::kSelfTest, kDone);
        return PartsView::kSound;
    }
    const SelfTestOutcome outcome = parts_.self_test->OnCycle();
    latch_.Enter((outcome.parts == PartsView::kSound) ? outcome.fault : DeviceFault::kSelfTest, kNoSlot);
    flow_.Mark(FlowStep::kSelfTest, FlowEvidence{outcome.progress, run_.cycle});
    return outcome.parts;
}

void Kernel::OnFrame(const StampedFrame& frame) noexcept
{
    if (!run_.started)
    {
        return;
    }
    clocks_.OnFrame(frame.stamp);
    parts_.channel_a.OnFrame(frame.frame, frame.stamp.a);
    parts_.channel_b.OnFrame(frame.frame, frame.stamp.b);
    const bool is_gfc = (frame.frame.identifier == kGfcIdentifier) && (frame.frame.kind == FrameKind::kData) &&
                        (frame.frame.length_bytes == 0U);
    const bool is_active = (guard_.Nmt() == NmtState::kOperational) && guard_.IsValid();
    if (is_gfc && is_active && (guard_.Value(0U, ConfigField::kGfcParameter) == 1U))
    {
        run_.gfc_seen = true;
    }
}

void Kernel::Cycle(const CycleCall& call) noexcept
{
    if (!run_.started)
    {
        return;
    }
    ++run_.cycle;
    run_.now = call.now.a;
    flow_.Begin();
    if (ExamineSelf() != PartsView::kSound)
    {
        return; // No permit, no answer to the watchdog: the outputs close, and nobody can be called to be told.
    }
    const std::uint32_t challenge = parts_.output.Challenge();

    latch_.Enter(clocks_.OnCycle(call.now), kNoSlot);
    flow_.Mark(FlowStep::kClocks, kDone);
    const std::uint32_t token = guard_.Cycle(challenge);
    flow_.Mark(FlowStep::kGuard, kDone);

    CycleInput input = TakeInput(call);
    input.challenge = challenge;
    input.guard_token = token;
    const CycleOutcome outcome_a = parts_.channel_a.OnCycle(input);
    flow_.Mark(FlowStep::kChannelA, FlowEvidence{outcome_a.cycle, run_.cycle});
    input.now = call.now.b;
    input.acknowledge = call.acknowledge_b;
    input.stand = run_.stand_b | Halted();
    CycleOutcome outcome_b = parts_.channel_b.OnCycle(input);
    flow_.Mark(FlowStep::kChannelB, FlowEvidence{outcome_b.cycle, run_.cycle});

    CompareOutcomes(
        Comparison{&outcome_a, &outcome_b, &parts_.channel_a, &parts_.channel_b, call.now.a, run_.cycle, challenge},
        outcome_b);
    flow_.Mark(FlowStep::kComparison, FlowEvidence{record_.verdict.echo, challenge});
    Demote();
    flow_.Mark(FlowStep::kDemotion, kDone);
    // Each channel's refresh runs by its own counter; the one that is ahead waits for the other. [SRS_KRN_017]
    run_.stand_a = outcome_a.due & ~outcome_b.due;
    run_.stand_b = outcome_b.due & ~outcome_a.due;
    Produce();
    flow_.Mark(FlowStep::kProduction, kDone);
    const SrdoMask received = Commit();
    flow_.Mark(FlowStep::kCommit, kDone);
    ReportErrors(outcome_a.signalled | outcome_b.signalled);
    ReportReceived(received);
    ReportFlow(outcome_a);
    ExamineHandshake();
    flow_.Mark(FlowStep::kEvents, Coverage(outcome_b, *config_));
    GivePermits(challenge);
    flow_.Mark(FlowStep::kPermits, kDone);

    parts_.watchdog.Answer(flow_.End(parts_.watchdog.Question()));
    latch_.Enter(flow_.Finding(), kNoSlot);
    ReportDevice();
}

// What channel A is given, but for challenge and token.
CycleInput Kernel::TakeInput(const CycleCall& call) noexcept
{
    CycleInput input{};
    input.now = call.now.a;
    input.acknowledge = call.acknowledge_a;
    input.request = Halted();
    input.stand = run_.stand_a | Halted();
    input.queue = run_.queue;
    run_.queue = QueueState::kIntact;
    // OPERATIONAL that was left and entered again between two cycles was left: the channels see one cycle outside of
    // it, and what was asked for since then waits for the next one. [SRS_KRN_010, SRS_KRN_011]
    input.nmt = NmtState::kPreOperational;
    if (!run_.left_operational)
    {
        input.nmt = guard_.Nmt();
        input.request |= run_.requests;
        run_.requests = 0U;
    }
    run_.left_operational = false;
    return input;
}

void Kernel::CompareOutcomes(const Comparison& comparison, CycleOutcome& outcome_b) noexcept
{
    --run_.cycles_to_test;
    if (run_.cycles_to_test == 0U)
    {
        run_.cycles_to_test = run_.test_cycles;
        TestComparator(comparison, outcome_b);
    }
    record_.verdict = comparator_.Compare(comparison);
    latch_.Enter(record_.verdict.fault, record_.verdict.slot);
    if (record_.verdict.echo != comparison.challenge)
    {
        latch_.Enter(DeviceFault::kComparator, kNoSlot);
    }
}

// A comparator that always says yes is found by a difference that it must see, another one each time. It is put into
// the outcome of channel B and taken out again. [SRS_CMP_009]
void Kernel::TestComparator(const Comparison& comparison, CycleOutcome& outcome_b) noexcept
{
    const std::uint32_t number = (run_.test_number > kCounts) ? 0U : (run_.test_number + 1U);
    run_.test_number = static_cast<std::uint8_t>(number);
    Alter(outcome_b, number);
    const DeviceFault fault = comparator_.Compare(comparison).fault;
    Alter(outcome_b, number);
    PreparedPair pairs[2]{};           // MISRA D-001
    pairs[1].normal.data[number] = 1U; // MISRA D-002
    const PreparedVerdict data = Comparator::ComparePrepared(pairs[0], pairs[1]);
    if ((fault == DeviceFault::kNone) || (data != PreparedVerdict::kNotInverse))
    {
        latch_.Enter(DeviceFault::kComparator, kNoSlot);
    }
}

void Kernel::Demote() noexcept
{
    SlotSet to_demote{record_.verdict.demote};
    while (to_demote.mask != 0U)
    {
        const SlotIndex slot = TakeLowest(to_demote);
        parts_.channel_a.Demote(slot);
        parts_.channel_b.Demote(slot);
        if (run_.demotions != kMostDemotions)
        {
            ++run_.demotions;
        }
    }
}

SrdoMask Kernel::Commit() noexcept
{
    const SrdoMask agreed = record_.verdict.agreement.agreed & ~record_.verdict.demote & latch_.Gate();
    const SrdoMask written = agreed & record_.verdict.agreement.matched;
    const Agreement agreement{agreed, record_.verdict.agreement.matched};
    parts_.channel_a.Commit(agreement);
    parts_.channel_b.Commit(agreement);
    const SrdoMask received = written & (record_.verdict.newly_matched | ~run_.committed);
    run_.committed = written | (run_.committed & agreed);
    return received;
}

// Computed from the comparator's echo and spoiled by a latch that is not running: there is nothing to decide.
// [SRS_KRN_005]
void Kernel::GivePermits(const std::uint32_t challenge) noexcept
{
    const std::uint32_t low = static_cast<std::uint32_t>(run_.committed);
    const std::uint32_t high = static_cast<std::uint32_t>(run_.committed >> kWordBits);
    const std::uint32_t rotated = (high << kPermitRotation) | (high >> (kWordBits - kPermitRotation));
    const std::uint32_t response = ((record_.verdict.echo + latch_.Spoiler() + low) ^ rotated) * kPermitConstantKernel;
    // In their places: channel A is asked before channel B.
    parts_.output.Drive(hal::PermitSet{parts_.channel_a.Answer(challenge), parts_.channel_b.Answer(challenge),
                                       Permit{run_.committed, response}});
}

} // namespace counterpoint
