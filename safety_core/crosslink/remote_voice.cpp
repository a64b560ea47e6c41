// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/crosslink/remote_voice.hpp"

#include "hal/api/watchdog.hpp"
#include "safety_core/comparator/slot_mask.hpp"

namespace counterpoint
{
namespace
{

constexpr std::uint32_t kPermitRotation = 16U;
constexpr std::uint32_t kWordBits = 32U;

std::uint32_t Unequal(const std::uint8_t left, const std::uint8_t right) noexcept
{
    return static_cast<std::uint32_t>(left) ^ static_cast<std::uint32_t>(right);
}

std::uint32_t Unequal(const Statement& left, const Statement& right) noexcept
{
    return Unequal(static_cast<std::uint8_t>(left.guard), static_cast<std::uint8_t>(right.guard)) |
           Unequal(left.sct_checked, right.sct_checked) | Unequal(left.is_tx, right.is_tx) |
           Unequal(left.is_invalid, right.is_invalid) | Unequal(left.not_operational, right.not_operational);
}

} // namespace

RemoteVoice::RemoteVoice(OwnVoice& own, const LinkConfig& config) noexcept : own_{own}, config_{config}
{
}

void RemoteVoice::Restart(const DeviceConfig& /*config*/) noexcept
{
    link_.Restart(config_);
    statement_ = Statement{};
    digest_ = DeviceDigest{0U};
    released_ = 0U;
    holding_ = 0U;
    told_faults_ = 0U;
    new_faults_ = 0U;
    fresh_ = 0U;
    shown_ = 0U;
    committed_ = 0U;
    checked_ = 0U;
    statements_.is_open = 0U;
    digests_.is_open = 0U;
    previous_ = Instant{0U}; // No difference begins at it: there is no contact in the first OnCycle. [SRS_LNK_011]
    cycle_ = 0U;
    offered_.Restart();
    normal_ = CanFrame{};
    for (Told& told : told_)
    {
        told.report = SlotReport{};
    }
}

void RemoteVoice::Store(const ConfigItem& /*item*/) noexcept
{
    // The other CPU has a configuration of its own.
}

ConfigItem RemoteVoice::Load(const ConfigAddress& address) const noexcept
{
    return own_.Load(address);
}

ChannelRoom RemoteVoice::Room() const noexcept
{
    return own_.Room();
}

void RemoteVoice::SetFields(const SlotIndex /*slot*/, const StaticFields& /*fields*/) noexcept
{
    // Nor are these objects those of the other CPU.
}

DeviceDigest RemoteVoice::Digest(const SlotIndex slot, const DeviceDigest before) const noexcept
{
    return own_.Digest(slot, before);
}

CheckResult RemoteVoice::Validate(const SlotIndex slot) noexcept
{
    return own_.Validate(slot);
}

bool RemoteVoice::IsOperational() const noexcept
{
    const std::uint32_t passed = static_cast<std::uint32_t>(statement_.not_operational) | own_.Said().not_operational;
    return link_.IsAlive() && (passed == 0U);
}

CheckResult RemoteVoice::Recheck(const SlotIndex slot) noexcept
{
    const bool is_told = (checked_ & OnlySlot(slot).mask) != 0U;
    if (is_told && IsOperational())
    {
        return checks_[slot]; // MISRA D-002
    }
    return own_.Recheck(slot);
}

void RemoteVoice::OnFrame(const CanFrame& /*frame*/, const Instant /*stamp*/) noexcept
{
    // The other CPU hears the bus by a controller of its own.
}

// t (own clock)   composed.first   composed.last      The pair was on the bus `age` before the composing, give or take
//                       |...........|                 the drift of both clocks and the tolerance of the stamps.
Window RemoteVoice::WindowOf(const std::uint32_t age_us) const noexcept
{
    constexpr std::uint32_t kDriftShift = 11U; // 488 ppm
    const std::uint32_t slack_us = config_.stamp_tolerance_us + (age_us >> kDriftShift);
    const Window& composed = link_.Composed();
    return Window{Instant{(composed.first.us - age_us) - slack_us}, Instant{(composed.last.us - age_us) + slack_us}};
}

void RemoteVoice::OnMessage(const LinkMessage& message, const Instant received) noexcept
{
    if (link_.Take(message, received) != TakeResult::kTaken)
    {
        return;
    }
    if (message.flow != hal::kFlowReference)
    {
        link_.Lose(LinkFinding::kFlow);
    }
    if (message.fault != DeviceFault::kNone)
    {
        link_.Lose(LinkFinding::kPeerSafe);
    }
    statement_ = message.statement;
    digest_ = message.digest;
    released_ = message.released;
    new_faults_ |= message.new_faults & ~told_faults_;
    told_faults_ = message.new_faults;
    if (statement_.not_operational != 0U)
    {
        checked_ = 0U;
    }
    if (message.check.slot < kMaxSrdoCount)
    {
        checked_ |= OnlySlot(message.check.slot).mask;
        checks_[message.check.slot] = message.check.result; // MISRA D-002
    }
    for (const SlotReport& report : message.reports)
    {
        Keep(report);
    }
    offered_.Take(message);
    // First the refusal: it is older than this message, which may tell the same slot due anew.
    own_.Sending().TakeRefusal(message.refusal, link_.Composed().first);
    own_.Sending().TakeDue(message.due, link_.Composed());
}

// A pair is told again and again, each time with a window of its own; the narrowest one is kept until it tells which
// pair of the own channel this is.
void RemoteVoice::Keep(const SlotReport& report) noexcept
{
    if ((report.slot >= kMaxSrdoCount) || (report.holding == Holding::kUnknown))
    {
        return;
    }
    const SrdoMask bit = OnlySlot(report.slot).mask;
    const Window moment = WindowOf(report.age_us);
    Told& told = told_[report.slot]; // MISRA D-002
    const SlotReport& before = told.report;
    const std::uint32_t data = (before.data.low ^ report.data.low) | (before.data.high ^ report.data.high);
    const std::uint32_t forms =
        Unequal(static_cast<std::uint8_t>(before.holding), static_cast<std::uint8_t>(report.holding)) |
        (before.ordinal ^ report.ordinal);
    const bool overlaps = Holds(moment, told.moment.first) || Holds(told.moment, moment.first);
    const bool is_same = ((data | forms) == 0U) && overlaps;
    const bool is_wider = (moment.last.us - moment.first.us) >= (told.moment.last.us - told.moment.first.us);
    const bool is_known = is_wider || own_.Moments().IsPair(report.slot, told.moment);
    told.report = report;
    holding_ = (report.holding == Holding::kPair) ? (holding_ | bit) : (holding_ & ~bit);
    if (is_same && is_known)
    {
        return;
    }
    told.moment = moment;
    fresh_ |= bit;
}

void RemoteVoice::Follow(Difference& difference, const std::uint32_t differs) const noexcept
{
    if (differs == 0U)
    {
        difference.is_open = 0U;
    }
    else if (difference.is_open == 0U)
    {
        difference = Difference{previous_, 1U};
    }
    else
    {
        // It goes on.
    }
}

void RemoteVoice::CompareStatements(const Instant now) noexcept
{
    const std::uint32_t statements = link_.IsAlive() ? Unequal(statement_, own_.Said()) : 0U;
    const std::uint32_t digests = IsOperational() ? (digest_.value ^ own_.LastDigest().value) : 0U;
    Follow(statements_, statements);
    Follow(digests_, digests);
    previous_ = now;
}

CycleOutcome RemoteVoice::OnCycle(const CycleInput& input) noexcept
{
    ++cycle_;
    link_.Examine(input.now);
    CompareStatements(input.now);
    const Statement said = own_.Said();
    const DeviceConfig& device = own_.Config();
    CycleOutcome outcome{};
    outcome.cycle = cycle_;
    outcome.guard = said.guard;
    outcome.sct_checked = said.sct_checked;
    outcome.is_tx = said.is_tx;
    outcome.is_invalid = said.is_invalid;
    outcome.not_operational = said.not_operational;
    const bool is_statement =
        (statements_.is_open == 0U) || ((input.now.us - statements_.since.us) <= device.discrepancy_us);
    const bool is_digest =
        (digests_.is_open == 0U) || ((input.now.us - digests_.since.us) <= device.diagnostic_interval_us);
    if (!(is_statement && is_digest && (link_.State() != LinkState::kLost)))
    {
        outcome.guard = GuardView::kInvalid;
    }
    shown_ = link_.IsAlive() ? (released_ & holding_) : SrdoMask{0U};
    outcome.released = shown_;
    outcome.new_fault = new_faults_;
    outcome.fresh = fresh_;
    outcome.due = (config_.role == PeerRole::kB) ? own_.Sending().Wanted() : offered_.Due();
    new_faults_ = 0U;
    fresh_ = 0U;
    return outcome;
}

// One holds a pair, the other none: right if the pair was complete before the other's last discard.
bool RemoteVoice::IsExcused(const Told& told, const HeldPair& own, const SlotIndex slot) const noexcept
{
    return (own.holds_pair != 0U) ? IsNotAfter(own_.Moments().PairAt(slot), told.moment.last)
                                  : IsNotAfter(told.moment.first, own_.Moments().DiscardedAt(slot));
}

HeldPair RemoteVoice::Held(const SlotIndex slot) const noexcept
{
    const HeldPair own = own_.Held(slot);
    const Told& told = told_[slot]; // MISRA D-002
    const bool is_compared = link_.IsAlive() && ((own_.Consumers() & OnlySlot(slot).mask) != 0U);
    if (!is_compared)
    {
        return own;
    }
    const std::uint32_t peer_holds = (told.report.holding == Holding::kPair) ? 1U : 0U;
    if ((told.report.holding != Holding::kUnknown) && (peer_holds != own.holds_pair) && IsExcused(told, own, slot))
    {
        return own;
    }
    const bool is_name = (peer_holds == 0U) || own_.Moments().IsPair(slot, told.moment);
    const bool is_match = (peer_holds == own.holds_pair) && is_name;
    return HeldPair{told.report.data, is_match ? own.ordinal : ~own.ordinal, peer_holds};
}

SrdoView RemoteVoice::View(const SlotIndex slot) const noexcept
{
    SrdoView view = own_.View(slot);
    view.signals = 0U;
    const bool is_told = link_.IsAlive() && ((own_.Consumers() & OnlySlot(slot).mask) != 0U);
    if (is_told)
    {
        const HeldPair held = Held(slot);
        const SlotReport& report = told_[slot].report; // MISRA D-002
        view.data = held.data;
        view.ordinal = held.ordinal;
        view.holds_pair = static_cast<std::uint8_t>(held.holds_pair);
        view.state = report.state;
        view.first_cause = report.cause;
    }
    return view;
}

void RemoteVoice::Demote(const SlotIndex slot) noexcept
{
    // The other CPU is told by the next message; until it answers the slot is not released here.
    released_ &= ~OnlySlot(slot).mask;
}

// Its objects are in the memory of the other CPU, which reads them back itself.
SrdoMask RemoteVoice::Commit(const Agreement& agreement, const SrdoMask /*examine*/) noexcept
{
    const SrdoMask released = agreement.agreed & shown_;
    committed_ = released & (agreement.matched | committed_);
    return 0U;
}

Permit RemoteVoice::Answer(const std::uint32_t challenge) const noexcept
{
    const std::uint32_t constant = (config_.role == PeerRole::kA) ? kPermitConstantB : kPermitConstantA;
    const SrdoMask mask = link_.IsAlive() ? committed_ : SrdoMask{0U};
    const std::uint32_t low = static_cast<std::uint32_t>(mask & 0xFFFFFFFFU);
    const std::uint32_t high = static_cast<std::uint32_t>(mask >> kWordBits);
    const std::uint32_t rotated = (high << kPermitRotation) | (high >> (kWordBits - kPermitRotation));
    return Permit{mask, ((challenge + link_.Spoiler() + low) ^ rotated) * constant};
}

PreparedPair RemoteVoice::Prepare(const SlotIndex slot) noexcept
{
    if (config_.role == PeerRole::kB)
    {
        return own_.Sending().PrepareAhead(slot);
    }
    const PrepareStatus status = own_.Sending().Status();
    return PreparedPair{(status == PrepareStatus::kReady) ? offered_.Use(slot) : CanFrame{}, status};
}

Confirmation RemoteVoice::OnConfirm(const CanFrame& frame, const Instant /*stamp*/) noexcept
{
    const SlotIndex slot = own_.Moments().SlotOfFrame(frame);
    const bool is_normal = (frame.identifier & 1U) != 0U;
    normal_ = is_normal ? frame : normal_;
    const ConfirmStep step = is_normal ? ConfirmStep::kNormal : ConfirmStep::kPair;
    return Confirmation{slot, (slot == kNoSlot) ? ConfirmStep::kNone : step};
}

// What the leader says of it is its normal frame, as CPU B had it on its own controller.
CanFrame RemoteVoice::InverseFrame(const SlotIndex slot) const noexcept
{
    if ((config_.role == PeerRole::kA) || (own_.Moments().SlotOfFrame(normal_) != slot))
    {
        return CanFrame{};
    }
    CanFrame inverse{normal_.identifier + 1U, FrameKind::kData, own_.Config().inverse_port, normal_.length_bytes, {}};
    for (std::uint8_t byte = 0U; byte < kMaxPayloadBytes; ++byte)
    {
        const std::uint8_t complement = static_cast<std::uint8_t>(0xFFU - normal_.data[byte]); // MISRA D-002
        inverse.data[byte] = (byte < normal_.length_bytes) ? complement : std::uint8_t{0U};    // MISRA D-002
    }
    return inverse;
}

void RemoteVoice::OnTransmitFault(const SlotIndex slot, const TransmitFault& fault) noexcept
{
    offered_.GiveUp(slot, fault.cause);
}

} // namespace counterpoint
