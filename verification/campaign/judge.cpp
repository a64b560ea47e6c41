// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/judge.hpp"

#include "verification/campaign/two_cpus.hpp"

#include "safety_core/kernel/limits.hpp"

#include <algorithm>

namespace counterpoint::campaign
{
namespace
{
constexpr Nanoseconds kUs = runtime::kNanosecondsPerMicrosecond;
/// From when the application wrote a value to when it is sent.
constexpr std::size_t kInputCycles = 4U;

bool IsGfc(const CanFrame& frame)
{
    return frame.identifier == kGfcIdentifier && frame.kind == FrameKind::kData && frame.length_bytes == 0U;
}

/// 1300h as the DCF has it.
bool KnowsGfc(const runtime::DeviceModel& model)
{
    constexpr std::uint16_t kGfcParameter = 0x1300U;
    return std::any_of(model.Writes().begin(), model.Writes().end(), [](const runtime::ConfigurationWrite& write)
                       { return write.object.index == kGfcParameter && write.value == 1U; });
}

std::uint64_t MaskOf(const VariablePlace& place)
{
    return ~std::uint64_t{0U} >> (kMaxPayloadBits - place.length_bits);
}

/// Of two CPUs the word of one that is hit as a whole does not count. [SRS_CMG_132]
bool IsFaultTold(const Device& device)
{
    const TwoCpus* const two = device.AsTwoCpus();
    return (two == nullptr) ? device.Application().Now().device_fault != DeviceFault::kNone : two->IsFaultTold();
}
} // namespace

Judge::Judge(const Recording& recording, const runtime::DeviceModel& model, Device& device)
    : recording_(recording), device_(device), knows_gfc_(KnowsGfc(model)),
      slack_((LateCycleUs(device.Config()) * kUs) + (2 * recording.frame_ns)),
      discrepancy_((device.Config().discrepancy_us + 2U * LateCycleUs(device.Config())) * kUs)
{
    for (const runtime::SrdoModel& each : model.Srdos())
    {
        Srdo srdo;
        srdo.slot = model.SlotOf(each.number).value_or(kNoSlot);
        srdo.number = each.number;
        srdo.is_consumer = each.direction == kDirectionConsumer;
        srdo.is_automatic = device.Config().srdos[srdo.slot].policy == ReleasePolicy::kAutomatic;
        const Payload& safe = device.Config().srdos[srdo.slot].safe_value;
        srdo.safe = (std::uint64_t{safe.high} << 32U) | safe.low;
        srdo.model = each;
        for (const FlatPair& pair : device.Pairs())
        {
            if (pair.slot == srdo.slot)
            {
                srdo.pairs.push_back(pair);
                srdo.bits = std::max<std::uint32_t>(srdo.bits, pair.first_bit + pair.normal.length_bits);
            }
        }
        srdo.input_cycles = InputCyclesOf(srdo);
        if (srdo.is_consumer)
        {
            srdo.bus.emplace_back(recording, each, srdo.bits);
        }
        srdos_.push_back(std::move(srdo));
    }
}

Sight Judge::Look(const std::size_t cycle, JudgeMemory& memory)
{
    Sight sight;
    sight.open = device_.Open();
    TakeFrames(cycle, memory);
    Arm(cycle, sight.open, memory);
    for (const Srdo& srdo : srdos_)
    {
        const bool is_open = ((sight.open >> srdo.slot) & 1U) != 0U;
        if (srdo.is_consumer && is_open)
        {
            LookAtOutput(srdo, cycle, memory, sight);
        }
    }
    LookAtFrames(cycle, memory, sight);
    return sight;
}

/// What the device got is what was on the bus, or what a fault made of it.
void Judge::TakeFrames(const std::size_t cycle, JudgeMemory& memory) const
{
    memory.has_gfc = false;
    if (cycle < memory.looked)
    {
        return;
    }
    memory.looked = cycle + 1U;
    for (const RecordedFrame& frame : device_.Receives().Handed())
    {
        memory.has_gfc = memory.has_gfc || (knows_gfc_ && IsGfc(frame.stamped.frame));
        for (const Srdo& srdo : srdos_)
        {
            if (srdo.is_consumer)
            {
                srdo.bus.front().Take(memory.received.at(srdo.slot), frame);
            }
        }
    }
}

void Judge::Arm(const std::size_t cycle, const SrdoMask open, JudgeMemory& memory) const
{
    const RecordedCycle& recorded = recording_.cycles[cycle];
    const SrdoMask level = recorded.call.acknowledge_a & recorded.call.acknowledge_b;
    const SrdoMask edge = level & ~memory.pressed;
    const SrdoMask faulted = device_.Application().Now().faulted;
    const SrdoMask told = faulted & ~memory.told;
    memory.pressed = level;
    memory.told = faulted;
    memory.fault_cycles += IsFaultTold(device_) ? 1U : 0U;
    memory.safe_cycles += (device_.Fault() != DeviceFault::kNone) ? 1U : 0U;
    memory.left = memory.armed;
    if (recorded.nmt != NmtState::kOperational)
    {
        memory.armed = 0U;
        memory.erred = 0U;
        memory.stopped = 0U;
        memory.opened = 0U;
        memory.closed = 0U;
        return;
    }
    for (const Srdo& srdo : srdos_)
    {
        const SrdoMask bit = SrdoMask{1U} << srdo.slot;
        const SrdoMask number = SrdoMask{1U} << ((srdo.number - 1U) % kMaxSrdoCount);
        memory.erred |= ((told & number) != 0U) ? bit : SrdoMask{0U};
        if (memory.has_gfc)
        {
            memory.armed &= ~bit;
            memory.stopped |= bit;
        }
        // An error that takes nothing back is a word too many; one that does asks for an acknowledge.
        if ((memory.erred & bit & ~open) != 0U && IsTakenBack(srdo))
        {
            memory.armed &= ~bit;
            memory.stopped |= bit;
            memory.erred &= ~bit;
        }
        if ((edge & bit) != 0U || srdo.is_automatic)
        {
            memory.armed |= bit;
            memory.stopped &= ~bit;
        }
        NoteClosed(srdo, open, edge, memory);
    }
}

/// Also where nobody told why: who sees the output stop has to know that it does not start by itself. [SRS_CMG_250]
void Judge::NoteClosed(const Srdo& srdo, const SrdoMask open, const SrdoMask edge, JudgeMemory& memory) const
{
    const SrdoMask bit = SrdoMask{1U} << srdo.slot;
    if (srdo.is_automatic)
    {
        return;
    }
    memory.closed |= memory.opened & ~open & bit;
    memory.closed &= ~(edge & bit);
    memory.opened = (memory.opened & ~bit) | (open & bit);
}

/// Its objects hold the safe value.
bool Judge::IsTakenBack(const Srdo& srdo)
{
    return std::all_of(srdo.pairs.begin(), srdo.pairs.end(),
                       [&srdo](const FlatPair& pair)
                       {
                           const std::uint64_t safe = (srdo.safe >> pair.first_bit) & MaskOf(pair.normal);
                           return ReadVariable(pair.normal).bits == safe &&
                                  IsInversePair(pair.normal, pair.inverse) == PairView::kInverse;
                       });
}

/// The cycle that obeys a stop or a GFC found a fault, and gave no permits: the output closes by its own time, and its
/// objects hold the safe value, or until the next cycle what the bus brought. Parts of the kernel that are wrong tell
/// the application nothing. [SRS_CMG_814]
bool Judge::MayStillClose(const Srdo& srdo, const JudgeMemory& memory)
{
    const bool has_lost_leave = ((memory.left >> srdo.slot) & 1U) != 0U;
    return has_lost_leave && memory.safe_cycles == 1U;
}

void Judge::LookAtOutput(const Srdo& srdo, const std::size_t cycle, const JudgeMemory& memory, Sight& sight) const
{
    const SrdoMask bit = SrdoMask{1U} << srdo.slot;
    std::uint64_t data = 0U;
    std::uint64_t inverse = 0U;
    std::uint64_t mask = 0U;
    for (const FlatPair& pair : srdo.pairs)
    {
        if (device_.AsTwoCpus() == nullptr && IsInversePair(pair.normal, pair.inverse) != PairView::kInverse)
        {
            sight.not_inverse |= bit;
            return; // The application does not use it.
        }
        data |= ReadVariable(pair.normal).bits << pair.first_bit;
        inverse |= (~ReadVariable(pair.inverse).bits & MaskOf(pair.inverse)) << pair.first_bit;
        mask |= MaskOf(pair.normal) << pair.first_bit;
    }
    // The permits of the cycle that tells of a device fault may have been given before.
    if (memory.fault_cycles > 1U || (memory.closed & bit) != 0U)
    {
        sight.wrong = Wrong::kRestart;
    }
    else if ((memory.armed & bit) == 0U && !MayStillClose(srdo, memory))
    {
        sight.wrong = ((memory.stopped & bit) != 0U) ? Wrong::kRestart : Wrong::kNoLeave;
    }
    else if ((memory.armed & bit) != 0U || !IsTakenBack(srdo))
    {
        const auto allows = [this, &srdo, &memory, cycle, mask](const std::uint64_t each)
        {
            return srdo.bus.front().Allows(memory.received.at(srdo.slot), recording_.cycles[cycle].at, each, mask,
                                           discrepancy_);
        };
        const Leave leave = allows(data);
        const Leave other = (device_.AsTwoCpus() != nullptr) ? allows(inverse) : leave;
        const bool is_none = leave == Leave::kNone && other == Leave::kNone;
        // What one CPU has wrong stands in series with what the other one has right. [SRS_CMG_064]
        sight.not_inverse |= (!is_none && (leave == Leave::kNone || other == Leave::kNone)) ? bit : SrdoMask{0U};
        sight.wrong = is_none ? Wrong::kData : sight.wrong;
        sight.listed |= (leave == Leave::kListed || other == Leave::kListed) ? bit : SrdoMask{0U};
    }
    else
    {
        // It closes by its time, and is safe already.
    }
}

void Judge::LookAtFrames(const std::size_t cycle, JudgeMemory& memory, Sight& sight) const
{
    const FlatPorts& ports = device_.Ports();
    const std::uint32_t kept = std::min<std::uint32_t>(ports.count, kMostOwnFrames);
    const std::uint32_t fresh = std::min(ports.sent - memory.sent, kept);
    memory.sent = ports.sent;
    for (std::uint32_t index = kept - fresh; index < kept; ++index)
    {
        const Wrong wrong = LookAtFrame(ports.frames[index], cycle, memory, sight);
        sight.wrong = (sight.wrong == Wrong::kNothing) ? wrong : sight.wrong;
    }
    LookAtPairs(cycle, memory, sight);
}

/// Whether they come when they have to.
void Judge::LookAtPairs(const std::size_t cycle, JudgeMemory& memory, Sight& sight) const
{
    for (std::size_t index = 0U; index < srdos_.size(); ++index)
    {
        const Srdo& srdo = srdos_[index];
        const Nanoseconds last = memory.pair_at[srdo.slot];
        const Nanoseconds patience = recording_.peer_scts[index] * kUs;
        if (recording_.cycles[cycle].nmt != NmtState::kOperational)
        {
            memory.pair_at[srdo.slot] = 0; // Whoever waits was told that it stops.
            continue;
        }
        const bool is_waited_for = srdo.model.direction == kDirectionProducer && last != 0;
        const Nanoseconds waited = recording_.cycles[cycle].at - last;
        const Nanoseconds refresh = srdo.model.times.sct_ms * kMicrosecondsPerMillisecond * kUs;
        sight.is_missed = sight.is_missed || (is_waited_for && waited > patience);
        sight.is_overdue = sight.is_overdue || (is_waited_for && waited > refresh + slack_);
    }
}

Wrong Judge::LookAtFrame(const OwnFrame& own, const std::size_t cycle, JudgeMemory& memory, Sight& sight) const
{
    for (const Srdo& srdo : srdos_)
    {
        OwnFrame& normal = memory.normal[srdo.slot];
        if (srdo.model.direction != kDirectionProducer)
        {
            continue;
        }
        if (own.frame.identifier == srdo.model.cob_id_1)
        {
            normal = own;
            sight.is_bad_frame = sight.is_bad_frame || !WereInputs(srdo, NumberIn(own.frame), cycle, kInputCycles);
            return (memory.fault_cycles > 1U) ? Wrong::kRestart : Wrong::kNothing;
        }
        if (own.frame.identifier != srdo.model.cob_id_2)
        {
            continue;
        }
        const std::uint64_t all = ~std::uint64_t{0U} >> (kMaxPayloadBits - srdo.bits);
        const std::uint64_t data = NumberIn(normal.frame);
        // A pair says what was so when its normal frame was sent; how late the inverse one may be is the receivers'
        // SRVT.
        const std::size_t sent_in = std::min(cycle, CycleOf(recording_, normal.confirmed_at));
        const bool is_pair = normal.confirmed_at != 0 && normal.frame.length_bytes * 8U == srdo.bits &&
                             own.frame.length_bytes == normal.frame.length_bytes && (data ^ NumberIn(own.frame)) == all;
        normal = OwnFrame{};
        if (!is_pair)
        {
            sight.is_bad_frame = true;
            return Wrong::kNothing; // Whoever consumes it finds it wrong.
        }
        memory.pair_at[srdo.slot] = own.confirmed_at;
        return JudgePair(srdo, data, sent_in);
    }
    if (knows_gfc_ && IsGfc(own.frame)) // A false one makes safe.
    {
        return (memory.fault_cycles > 1U) ? Wrong::kRestart : Wrong::kNothing;
    }
    return Wrong::kIdentifier;
}

/// Whoever is asked before each refresh may have been passed over once: to a consumer that is a pair that was lost. Who
/// writes in each cycle has nothing older. [SRS_CMG_812]
std::size_t Judge::InputCyclesOf(const Srdo& srdo) const
{
    const bool is_asked = device_.Config().srdos[srdo.slot].form == ProducerForm::kProviderCalled;
    const Nanoseconds refresh = srdo.model.times.sct_ms * kMicrosecondsPerMillisecond * kUs;
    const Nanoseconds cycle = device_.Config().cycle_us * kUs;
    return kInputCycles + (is_asked ? static_cast<std::size_t>((refresh + slack_) / cycle) : std::size_t{0U});
}

Wrong Judge::JudgePair(const Srdo& srdo, const std::uint64_t data, const std::size_t cycle) const
{
    if (WereInputs(srdo, data, cycle, srdo.input_cycles))
    {
        return Wrong::kNothing;
    }
    return WereInputs(srdo, data, cycle, cycle) ? Wrong::kOldPair : Wrong::kSentPair;
}

bool Judge::WereInputs(const Srdo& srdo, const std::uint64_t data, const std::size_t cycle,
                       const std::size_t cycles) const
{
    return std::all_of(srdo.pairs.begin(), srdo.pairs.end(), [this, data, cycle, cycles](const FlatPair& pair)
                       { return WasInput(pair, (data >> pair.first_bit) & MaskOf(pair.normal), cycle, cycles); });
}

/// In this cycle or so many before.
bool Judge::WasInput(const FlatPair& pair, const std::uint64_t value, const std::size_t cycle,
                     const std::size_t cycles) const
{
    std::uint64_t present = 0U;
    bool was_it = false;
    const std::size_t since = cycle - std::min(cycle, cycles);
    for (const RecordedInput& input : recording_.inputs)
    {
        if (input.cycle > cycle || input.object.index != pair.address.index || input.object.sub != pair.address.sub)
        {
            continue;
        }
        was_it = was_it || (input.cycle > since && present == value);
        present = input.value;
    }
    return was_it || present == value;
}
} // namespace counterpoint::campaign
