// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/kernel.hpp"

namespace counterpoint
{
namespace
{

// Every SRDO is examined or passed over for a named reason, or none is because SRDOs are not active.
FlowEvidence Coverage(const CycleOutcome& outcome, const DeviceConfig& config) noexcept
{
    const std::uint32_t seen = static_cast<std::uint32_t>(outcome.sct_checked) + outcome.is_tx + outcome.is_invalid;
    const std::uint32_t passed = static_cast<std::uint32_t>(outcome.not_operational) * config.srdo_count;
    return FlowEvidence{seen + passed, config.srdo_count};
}

constexpr FlowEvidence kDone{0U, 0U};
constexpr std::uint32_t kByteBits = 8U;

// Both members in one word.
std::uint32_t CodeOf(const Confirmation& confirmation) noexcept
{
    return static_cast<std::uint32_t>(confirmation.slot) | (static_cast<std::uint32_t>(confirmation.step) << kByteBits);
}

// What a frame counts, at least 1. [SRS_KRN_034]
std::uint32_t MarkOf(const CanFrame& frame) noexcept
{
    return frame.identifier + 1U;
}

// The gate closed what was open, not this kernel. In the device safe state it closes by what this kernel spoils, which
// is told already; and so is a call that is too late. [SRS_KRN_300, SRS_KRN_301]
void TakeInterruption(SafeStateLatch& latch, const std::uint32_t challenge) noexcept
{
    if ((challenge == 0U) && latch.IsRunning())
    {
        latch.Enter(DeviceFault::kOutput, kNoSlot);
    }
}

// The kernel's own flow monitor where no other one is named. [SRS_KRN_039]
KernelParts Completed(const KernelParts& given, FlowWatch& own) noexcept
{
    KernelParts parts{given};
    if (parts.flow == nullptr)
    {
        parts.flow = &own;
    }
    return parts;
}

// [SRS_KRN_572]
bool AreOptions(const FlowCallback flow, const StatusHandshake handshake) noexcept
{
    const bool is_flow = (flow == FlowCallback::kOff) || (flow == FlowCallback::kOn);
    return is_flow && ((handshake == StatusHandshake::kOff) || (handshake == StatusHandshake::kRequired));
}

} // namespace

Kernel::Kernel(const KernelParts& parts) noexcept : context_{Completed(parts, flow_)}
{
}

StartResult Kernel::Start(const DeviceConfig& config, const FlowCallback flow, const StatusHandshake handshake) noexcept
{
    Stop();
    const StartResult result = CheckStart(config, context_.parts);
    if (result != StartResult::kStarted)
    {
        return result;
    }
    if (!AreOptions(flow, handshake))
    {
        return StartResult::kOptions;
    }
    context_.config = &config;
    context_.parts.channel_a.Restart(config);
    context_.parts.channel_b.Restart(config);
    context_.guard.Restart(config);
    decision_.Restart(config);
    clocks_.Restart(config);
    reporting_.Restart(context_, flow, handshake);
    run_.queue = QueueState::kIntact;
    run_.started = true;
    context_.latch.Arm();
    return StartResult::kStarted;
}

void Kernel::Stop() noexcept
{
    if (run_.started)
    {
        decision_.Withdraw(context_);
    }
    run_ = KernelRun{};
    second_nmt_ = SecondNmt{};
    decision_.Stop();
    production_ = Production{};
    context_.latch.Disarm();
    context_.config = &kNoDevice;
    context_.guard.Stop();
    // The first one closes, and answers a challenge that may be outstanding; the second one arms the gate.
    // [SRS_KRN_302]
    context_.parts.output.Drive(hal::PermitSet{});
    context_.parts.output.Drive(hal::PermitSet{});
}

// Before any other part is called. [SRS_KRN_035, SRS_KRN_800, SRS_STS_040, SRS_STS_063]
PartsView Kernel::ExamineSelf() noexcept
{
    const bool is_one_device = context_.config == &context_.guard.Config();
    if ((SealOf(context_.parts) != context_.seal) || !is_one_device)
    {
        context_.latch.Enter(DeviceFault::kSelfTest, kNoSlot);
        return PartsView::kInvalid;
    }
    context_.parts.flow->Begin();
    if (context_.parts.self_test == nullptr)
    {
        context_.parts.flow->Mark(FlowStep::kSelfTest, kDone);
        return PartsView::kSound;
    }
    const SelfTestOutcome outcome = context_.parts.self_test->OnCycle();
    context_.latch.Take((outcome.parts == PartsView::kSound) ? outcome.fault : DeviceFault::kSelfTest, kNoSlot);
    context_.parts.flow->Mark(FlowStep::kSelfTest, FlowEvidence{outcome.progress, run_.cycle});
    return outcome.parts;
}

void Kernel::OnFrame(const StampedFrame& frame) noexcept
{
    // Before anything is decided: a GFC that is lost here, or taken for another frame by both channels, is in no SCT.
    run_.frames += MarkOf(frame.frame);
    if (!run_.started)
    {
        return;
    }
    clocks_.OnFrame(frame.stamp);
    context_.parts.channel_a.OnFrame(frame.frame, frame.stamp.a);
    context_.parts.channel_b.OnFrame(frame.frame, frame.stamp.b);
    run_.frames -= MarkOf(frame.frame);
    const bool is_gfc = (frame.frame.identifier == kGfcIdentifier) && (frame.frame.kind == FrameKind::kData) &&
                        (frame.frame.length_bytes == 0U);
    const bool is_active = (context_.guard.Nmt() == NmtState::kOperational) && context_.guard.IsValid();
    if (is_gfc && is_active && (context_.guard.Value(0U, ConfigField::kGfcParameter) == 1U))
    {
        reporting_.OnGfc();
    }
}

// t      prepare            normal on the bus         inverse on the bus
// A      normal frame       confirm, inverse frame    confirm: sent
// B      compared           confirm, compared         confirm: sent
// An identifier that was stored since then belongs to the next pair. [SRS_KRN_036, SRS_KRN_220, SRS_KRN_221]
void Kernel::OnConfirm(const StampedFrame& frame) noexcept
{
    if (!run_.started)
    {
        return;
    }
    clocks_.OnFrame(frame.stamp);
    const Confirmation a = context_.parts.channel_a.OnConfirm(frame.frame, frame.stamp.a);
    const Confirmation b = context_.parts.channel_b.OnConfirm(frame.frame, frame.stamp.b);
    Production::OnHalfConfirmed(context_, a, b);
    Production::OnHalfConfirmed(context_, b, a);
    const std::uint32_t said = CodeOf(a);
    const SlotIndex slot = static_cast<SlotIndex>(said);
    if ((said != CodeOf(b)) || (slot >= context_.config->srdo_count))
    {
        return;
    }
    // A pair that began before OPERATIONAL was left is over, although the channels have not been told yet.
    // [SRS_KRN_044]
    if (run_.left_operational)
    {
        return;
    }
    if (a.step == ConfirmStep::kPair)
    {
        production_.OnSent();
        reporting_.TellEvent(context_, slot);
    }
    else if ((a.step == ConfirmStep::kNormal) && second_nmt_.HasStayed())
    {
        Production::SendInverse(context_, slot);
    }
    else
    {
        // The other copy of the NMT state says that the pair is over; or both channels agree that nothing of theirs was
        // confirmed.
    }
}

void Kernel::Cycle(const CycleCall& call) noexcept
{
    if (!run_.started)
    {
        return;
    }
    ++run_.cycle;
    if (ExamineSelf() != PartsView::kSound)
    {
        return; // No permit, no answer to the watchdog: the outputs close, and nobody can be called to be told.
    }
    production_.OnCycle(call.now.a, context_.config->cycle_us);
    const std::uint32_t challenge = context_.parts.output.Challenge();

    context_.latch.Take(clocks_.OnCycle(call.now), kNoSlot);
    TakeInterruption(context_.latch, challenge);
    context_.parts.flow->Mark(FlowStep::kClocks, FlowEvidence{run_.frames, 0U});
    const std::uint32_t token = context_.guard.Cycle(challenge, call.now.a);
    context_.parts.flow->Mark(FlowStep::kGuard, kDone);

    CycleInput input = TakeInput(call, challenge, token);
    CycleOutcome outcome_a = context_.parts.channel_a.OnCycle(input);
    context_.parts.flow->Mark(FlowStep::kChannelA, FlowEvidence{outcome_a.cycle, run_.cycle});
    input.now = call.now.b;
    input.acknowledge = call.acknowledge_b;
    input.stand = production_.StandOfB() | production_.Halted(context_);
    input.nmt = second_nmt_.Take();
    CycleOutcome outcome_b = context_.parts.channel_b.OnCycle(input);
    context_.parts.flow->Mark(FlowStep::kChannelB, FlowEvidence{outcome_b.cycle, run_.cycle});
    production_.Await(context_, outcome_a, outcome_b);

    decision_.Compare(context_, Comparison{&outcome_a, &outcome_b, &context_.parts.channel_a, &context_.parts.channel_b,
                                           call.now.a, run_.cycle, challenge, HeldPair{}});
    context_.parts.flow->Mark(FlowStep::kComparison, FlowEvidence{decision_.LastVerdict().echo, challenge});
    decision_.Demote(context_);
    context_.parts.flow->Mark(FlowStep::kDemotion, kDone);
    production_.Produce(context_, decision_.LastVerdict().start);
    context_.parts.flow->Mark(FlowStep::kProduction, kDone);
    const SrdoMask received = decision_.Commit(context_);
    context_.parts.flow->Mark(FlowStep::kCommit, kDone);
    reporting_.TellErrors(context_, outcome_a.signalled | outcome_b.signalled, call.now.a);
    reporting_.TellReceived(context_, received);
    reporting_.TellFlow(context_, outcome_a, production_.Transmitted());
    reporting_.ExamineHandshake(context_);
    context_.parts.flow->Mark(FlowStep::kEvents, Coverage(outcome_b, *context_.config));
    decision_.GivePermits(context_, challenge);
    context_.parts.flow->Mark(FlowStep::kPermits, kDone);

    context_.parts.watchdog.Answer(context_.parts.flow->End(context_.parts.watchdog.Question()));
    context_.latch.Take(context_.parts.flow->Finding(), kNoSlot);
    reporting_.TellDevice(context_);
}

// What channel A is given.
CycleInput Kernel::TakeInput(const CycleCall& call, const std::uint32_t challenge, const std::uint32_t token) noexcept
{
    SrdoMask request = 0U;
    NmtState nmt = NmtState::kPreOperational;
    // OPERATIONAL that was left and entered again between two cycles was left: the channels see one cycle outside of
    // it, and what was asked for since then waits for the next one. [SRS_KRN_010, SRS_KRN_222, SRS_KRN_224]
    if (!run_.left_operational)
    {
        nmt = context_.guard.Nmt();
        request = production_.TakeRequests();
    }
    run_.left_operational = false;
    const QueueState queue = run_.queue;
    run_.queue = QueueState::kIntact;
    const SrdoMask stand = production_.StandOfA() | production_.Halted(context_);
    return CycleInput{call.now.a, challenge, token, call.acknowledge_a, request, stand, nmt, queue};
}

void Kernel::SetNmtState(const NmtState state) noexcept
{
    // B's copy first, and whatever is decided below: where a wrong decision keeps the state from A, the channels
    // differ.
    second_nmt_.Set(state);
    if (!run_.started)
    {
        return;
    }
    if (state == context_.guard.Nmt())
    {
        return;
    }
    if (context_.guard.Nmt() == NmtState::kOperational)
    {
        run_.left_operational = true;
        decision_.Withdraw(context_);
    }
    production_.Cease();
    context_.guard.SetNmt(state);
    if ((state != NmtState::kOperational) || (!context_.guard.IsValid()))
    {
        return; // No fault: SRDOs are off until the configuration is declared valid.
    }
    if (context_.guard.CheckAll(CheckDepth::kRecheck) != ConfigFault::kNone)
    {
        context_.guard.Invalidate();
        context_.parts.application.OnConfigurationInvalid(IndexOf(*context_.config, context_.guard.Faulty()));
        return;
    }
    production_.Begin(context_);
}

Result Kernel::Send(const CommunicationIndex index) noexcept
{
    SlotIndex slot = kNoSlot;
    SrdoMask asked = ~SrdoMask{0U};
    if (index.value != 0U)
    {
        slot = SlotAt(*context_.config, index);
        if (slot == kNoSlot)
        {
            return Missing();
        }
        asked = OnlySlot(slot).mask;
    }
    return production_.Request(context_, slot, asked);
}

Result Kernel::SendGfc() noexcept
{
    return (context_.config->gfc == GfcUse::kPresent) ? production_.SendGfc(context_) : Missing();
}

CheckReply Kernel::CheckConfiguration() noexcept
{
    CheckReply reply{Result::kDeviceFault, CommunicationIndex{0U}};
    if (run_.started)
    {
        // To resolve a mapping anew is not for OPERATIONAL; elsewhere the first rule that is broken is what is told.
        const bool is_in_use = context_.guard.Nmt() == NmtState::kOperational;
        const ConfigFault rule = context_.guard.CheckAll(is_in_use ? CheckDepth::kRecheck : CheckDepth::kValidate);
        reply.result = ToResult(rule);
        if (rule != ConfigFault::kNone)
        {
            reply.index = IndexOf(*context_.config, context_.guard.Faulty());
        }
        else
        {
            reply.result = context_.guard.Digest().result;
        }
    }
    return reply;
}

SignReply Kernel::Sign(const CommunicationIndex index) noexcept
{
    const SlotIndex slot = SlotAt(*context_.config, index);
    if (slot == kNoSlot)
    {
        return SignReply{Missing(), 0U};
    }
    const CheckResult result = context_.guard.Check(slot, CheckDepth::kRecheck);
    return (result.fault == ConfigFault::kInvalid) ? SignReply{Result::kDeviceFault, 0U}
                                                   : SignReply{Result::kSuccessful, result.signature};
}

StateReply Kernel::GetState(const CommunicationIndex index) const noexcept
{
    const SlotIndex slot = SlotAt(*context_.config, index);
    if (slot == kNoSlot)
    {
        return StateReply{Missing(), SrdoState::kInvalid, SrdoCause::kInvalid, 0U};
    }
    const SrdoView a = context_.parts.channel_a.View(slot);
    const SrdoView b = context_.parts.channel_b.View(slot);
    // Once OPERATIONAL was left nothing is in use; the channels are told in the next cycle. [SRS_KRN_043]
    const bool is_in_use = (context_.guard.Nmt() == NmtState::kOperational) && (!run_.left_operational);
    const SrdoState shared = is_in_use ? a.state : SrdoState::kOff;
    // In the device safe state nothing is released, whatever the channels still hold.
    const bool is_shared = (a.state == b.state) && ((shared != SrdoState::kReleased) || context_.latch.SaysRunning());
    const SrdoState state = is_shared ? shared : SrdoState::kFaulted;
    const std::uint16_t error_count = (a.error_count > b.error_count) ? a.error_count : b.error_count;
    return StateReply{Result::kSuccessful, state, FirstCauseOf(a, b), error_count};
}

StatusReply Kernel::GetStatus(const CommunicationIndex index) const noexcept
{
    const SlotIndex slot = SlotAt(*context_.config, index);
    return (slot == kNoSlot) ? StatusReply{Missing(), StatusByte{0U}}
                             : StatusReply{Result::kSuccessful, reporting_.Status().Get(slot)};
}

Result Kernel::SetStatus(const CommunicationIndex index, const StatusByte status) noexcept
{
    const SlotIndex slot = SlotAt(*context_.config, index);
    if (slot == kNoSlot)
    {
        return Missing();
    }
    reporting_.Status().Answer(slot, status);
    return Result::kSuccessful;
}

ParametersReply Kernel::GetParameters(const CommunicationIndex index) const noexcept
{
    const SlotIndex slot = SlotAt(*context_.config, index);
    if (slot == kNoSlot)
    {
        return ParametersReply{Missing(), 0U, 0U, 0U};
    }
    return ParametersReply{Result::kSuccessful,
                           static_cast<std::uint8_t>(context_.guard.Value(slot, ConfigField::kDirection)),
                           static_cast<std::uint16_t>(context_.guard.Value(slot, ConfigField::kSct)),
                           static_cast<std::uint8_t>(context_.guard.Value(slot, ConfigField::kMapCount))};
}

MappedReply Kernel::GetMapped(const CommunicationIndex index, const MappedEntry entry) const noexcept
{
    MappedReply reply{Missing(), VariablePlace{nullptr, 0U}};
    const SlotIndex slot = SlotAt(*context_.config, index);
    // 0 - 1 is the greatest value: there is no entry 0.
    if ((slot != kNoSlot) && ((entry.number - 1U) < context_.guard.Value(slot, ConfigField::kMapCount)))
    {
        const std::uint32_t mapped = context_.guard.Value(slot, ConfigField::kMapEntry, entry.number);
        const MappableObject* const object = FindMapped(*context_.config, mapped);
        reply.result = Result::kSuccessful;
        reply.variable.length_bits = static_cast<std::uint8_t>(mapped & kEntryLengthMask);
        reply.variable.place = (object == nullptr) ? nullptr : object->place;
    }
    return reply;
}

Result Kernel::DefineStaticFields(const CommunicationIndex index, const StaticFields& fields) noexcept
{
    const SlotIndex slot = SlotAt(*context_.config, index);
    return (slot == kNoSlot) ? Missing() : context_.guard.DefineFields(slot, fields);
}

} // namespace counterpoint
