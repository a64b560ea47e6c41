// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/runner.hpp"

#include "runtime/device/names.hpp"
#include "safety_core/kernel/limits.hpp"
#include "verification/campaign/variants.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>

namespace counterpoint::campaign
{
namespace
{
/// So many cycles behind a device fault nothing may open again.
constexpr std::size_t kSettleCycles = 80U;
/// Of an intermittent fault.
constexpr std::size_t kStrikes = 5U;
constexpr std::size_t kStrikeDistance = 7U;
constexpr std::uint8_t kNoPart = 0xFFU;
constexpr std::size_t kNever = ~std::size_t{0U};

bool Strikes(const Experiment& fault, const std::size_t cycle)
{
    const std::size_t since = cycle - fault.cycle;
    return since == 0U || (fault.kind == FaultKind::kIntermittent && since % kStrikeDistance == 0U &&
                           since < kStrikes * kStrikeDistance);
}

/// Whether the fault can still change anything behind this cycle.
bool IsOver(const Experiment& fault, const std::size_t cycle)
{
    return !IsMemory(fault.part) || fault.kind == FaultKind::kFlip ||
           (fault.kind == FaultKind::kIntermittent && cycle >= fault.cycle + (kStrikes - 1U) * kStrikeDistance);
}

/// The device is safe for good.
bool HasGivenUp(const Device& device)
{
    return device.Fault() != DeviceFault::kNone || !device.IsOutputLive();
}
} // namespace

Runner::Runner(Device& device, Judge& judge, const Recording& recording, const Space& space, const Limits& limits)
    : device_(device), judge_(judge), recording_(recording), limits_(limits), seed_(space.Seed()),
      horizon_(HorizonOf(limits, device.Config())), first_(space.Cycles().front()), size_(device.Memory().Size()),
      read_(WhatIsRead(device)), all_set_(size_, 0xFFU), ever_set_(size_, 0U), owner_(size_, kNoPart), steps_(device)
{
    for (const Place& place : device.Places())
    {
        std::fill_n(owner_.begin() + static_cast<std::ptrdiff_t>(place.offset), place.size,
                    static_cast<std::uint8_t>(place.part));
    }
    const std::size_t end = space.LastCycle() + horizon_ + 1U;
    device_.Follow(this);
    JudgeMemory memory;
    for (std::size_t cycle = 0U; cycle < end && cycle < recording_.cycles.size(); ++cycle)
    {
        if (cycle >= first_)
        {
            kept_.insert(kept_.end(), device_.Memory().Bytes(), device_.Memory().Bytes() + size_);
        }
        memories_.push_back(memory);
        now_ = cycle;
        device_.Cycle(cycle);
        const Sight sight = judge_.Look(cycle, memory);
        sights_.push_back(sight);
        const std::string problem = WhatIsNotWell(sight);
        if (!problem.empty())
        {
            throw NotWell("without a fault, in cycle " + std::to_string(cycle) + ": " + problem);
        }
    }
    kept_.insert(kept_.end(), device_.Memory().Bytes(), device_.Memory().Bytes() + size_);
    is_kept_ = true;
}

/// In words; empty: it is as it must be.
std::string Runner::WhatIsNotWell(const Sight& sight) const
{
    const DeviceFault fault = device_.Fault();
    if (fault != DeviceFault::kNone)
    {
        return std::string("device fault ") + runtime::NameOf(runtime::kDeviceFaultWords, fault, "?") + ", found by " +
               WordOf(DetectorOf(fault));
    }
    if (sight.wrong != Wrong::kNothing)
    {
        return ReasonOf(Outcome{Class::kSilent, Detector::kNobody, static_cast<std::uint8_t>(sight.wrong), 0U, 0U});
    }
    if (!device_.IsOutputLive())
    {
        return "the pins cut themselves off";
    }
    if (sight.not_inverse != 0U)
    {
        return "a pair of variables is not inverse";
    }
    return sight.is_missed ? "receivers wait for its frames" : "";
}

/// At each phase of each cycle, of all memory: by words, whose number is whole because the memory is whole pages.
void Runner::KeepBits() noexcept
{
    const std::uint8_t* const bytes = device_.Memory().Bytes();
    for (std::size_t index = 0U; index + sizeof(std::uint64_t) <= size_; index += sizeof(std::uint64_t))
    {
        std::uint64_t now = 0U;
        std::uint64_t all = 0U;
        std::uint64_t ever = 0U;
        std::memcpy(&now, bytes + index, sizeof(now));
        std::memcpy(&all, all_set_.data() + index, sizeof(all));
        std::memcpy(&ever, ever_set_.data() + index, sizeof(ever));
        all &= now;
        ever |= now;
        std::memcpy(all_set_.data() + index, &all, sizeof(all));
        std::memcpy(ever_set_.data() + index, &ever, sizeof(ever));
    }
}

void Runner::At(const Phase phase) noexcept
{
    if (fault_ == nullptr)
    {
        if (now_ >= first_ && !is_kept_)
        {
            KeepBits();
        }
        return;
    }
    if (fault_->part == Part::kSteps)
    {
        steps_.At(*fault_, now_, phase, frame_);
    }
    else if (IsMemory(fault_->part))
    {
        ForceBit(phase);
    }
    else
    {
        // It is in what the device receives, or in its calls.
    }
}

/// A function of its own, so that a step that runs again stands below its frame.
[[gnu::noinline]] void Runner::RunCycle()
{
    frame_ = __builtin_frame_address(0);
    device_.Cycle(now_);
    frame_ = nullptr;
}

void Runner::ForceBit(const Phase phase) noexcept
{
    const auto mask = static_cast<std::uint8_t>(1U << fault_->bit);
    std::uint8_t* const bytes = device_.Memory().Bytes();
    std::uint8_t& byte = bytes[fault_->offset];
    if (IsStuck(fault_->kind))
    {
        if (device_.SelfTest() != nullptr && now_ == fault_->cycle && phase == fault_->phase)
        {
            device_.SelfTest()->Stick(&byte, fault_->bit, fault_->kind == FaultKind::kStuckAt1);
        }
        if (now_ > fault_->cycle || phase >= fault_->phase)
        {
            byte = static_cast<std::uint8_t>((fault_->kind == FaultKind::kStuckAt1) ? (byte | mask) : (byte & ~mask));
        }
    }
    else if (phase == fault_->phase && Strikes(*fault_, now_))
    {
        byte = static_cast<std::uint8_t>(byte ^ mask);
        if (fault_->part == Part::kBothChannels)
        {
            const Bit& second = fault_->second;
            bytes[second.offset] = static_cast<std::uint8_t>(bytes[second.offset] ^ (1U << second.bit));
        }
    }
    else
    {
        // Not now.
    }
}

/// A bit that is stuck at what it is anyway changes nothing.
bool Runner::IsNeverOtherwise(const Experiment& experiment) const
{
    if (!IsMemory(experiment.part) || device_.SelfTest() != nullptr)
    {
        return false; // A march writes what it is not.
    }
    const auto mask = static_cast<std::uint8_t>(1U << experiment.bit);
    return (experiment.kind == FaultKind::kStuckAt1 && (all_set_[experiment.offset] & mask) != 0U) ||
           (experiment.kind == FaultKind::kStuckAt0 && (ever_set_[experiment.offset] & mask) == 0U);
}

Outcome Runner::Run(const Experiment& experiment)
{
    if (IsNeverOtherwise(experiment))
    {
        return Outcome{Class::kMasked, Detector::kNobody, 0U, 0U, 0U};
    }
    Begin(experiment);
    found_ = Outcome{Class::kOpen, Detector::kNobody, 0U, 0U, 0U};
    const Return back = Trap::Run([this, &experiment]() { Watch(experiment); });
    fault_ = nullptr;
    if (back != Return::kEnded && found_.result == Class::kOpen)
    {
        // The processor's handler, or the output's own time, closes it.
        found_.result = Class::kSafeOther;
        found_.detector = (back == Return::kException) ? Detector::kException : Detector::kTime;
        found_.us = Since(experiment, now_) + ExceptionUs();
    }
    if (found_.result == Class::kDetected && found_.us > limits_.Of(experiment, recording_))
    {
        found_.marks |= MarksOf(experiment);
    }
    return found_;
}

bool Runner::IsSound()
{
    is_sound_ = true;
    Rewind(first_);
    device_.Rewind(first_, nullptr, first_, seed_);
    const Return back = Trap::Run(
        [this]()
        {
            JudgeMemory memory = memories_[first_];
            for (; is_sound_ && now_ < sights_.size(); ++now_)
            {
                RunCycle();
                const Sight sight = judge_.Look(now_, memory);
                is_sound_ = IsAsWithoutFault(now_ + 1U) && sight == sights_[now_];
                if (watcher_ != nullptr)
                {
                    watcher_->OnCycle(now_, sight);
                }
            }
        });
    return back == Return::kEnded && is_sound_;
}

void Runner::Begin(const Experiment& experiment)
{
    Rewind(experiment.cycle);
    fault_ = &experiment;
    steps_.Begin();
    is_obeyed_ = false;
    is_otherwise_ = false;
    is_exposed_ = false;
    device_.Rewind(experiment.cycle, &experiment, EndOf(experiment), seed_);
}

void Runner::Rewind(const std::size_t cycle)
{
    std::memcpy(device_.Memory().Bytes(), kept_.data() + ((cycle - first_) * size_), size_);
    if (device_.SelfTest() != nullptr)
    {
        device_.SelfTest()->Release();
    }
    now_ = cycle;
}

/// What is no memory is seen by the time of its limit, or never.
std::size_t Runner::EndOf(const Experiment& experiment) const
{
    // What is found later than its own limit, within that of its part, is late and not benign.
    const std::uint32_t longest =
        std::max(limits_.Of(experiment, recording_), limits_.us.at(static_cast<std::size_t>(experiment.part)));
    const std::size_t limit = longest / device_.Config().cycle_us;
    const bool moves_in_time = experiment.part == Part::kBus || experiment.part == Part::kCycle ||
                               (experiment.part == Part::kLink && HasReach(experiment.part, experiment.kind));
    const std::size_t more =
        moves_in_time ? static_cast<std::size_t>(experiment.variant * kGrid /
                                                 (device_.Config().cycle_us * runtime::kNanosecondsPerMicrosecond))
                      : 0U;
    const bool lasts = IsMemory(experiment.part) || experiment.part == Part::kCommands; // The next command may tell.
    const bool is_long =
        lasts && device_.AsTwoCpus() == nullptr; // Two run for no longer than the limit of their part asks.
    return experiment.cycle + (is_long ? horizon_ : std::min(horizon_, limit + more + kMoreCycles));
}

/// A fault may lie still for long: a bit that is stuck at what it is anyway, a word that is not read. The same run
/// again, to see when the device did something else. So may a call whose answer would have been the same. What is else
/// no memory has happened as soon as a byte differs. What a
/// test finds that comes again and again has its interval from when the memory is wrong, whatever the device does.
/// [SRS_CMG_007, SRS_CMG_060, SRS_CMG_153, SRS_CMG_154]
std::uint8_t Runner::MarksOf(const Experiment& experiment)
{
    const Outcome found = found_;
    Begin(experiment);
    JudgeMemory memory = memories_[experiment.cycle];
    Signs signs{kNever, kNever, kNever};
    const Return back = Trap::Run(
        [this, &experiment, &memory, &signs, &found]()
        {
            for (; Since(experiment, now_) < found.us && signs.effect == kNever; ++now_)
            {
                RunCycle();
                NoticeSigns(experiment, judge_.Look(now_, memory), signs);
            }
        });
    static_cast<void>(back); // Where it ends by an exception, the effect is the exception.
    fault_ = nullptr;
    found_ = found;
    const auto is_above = [this, &experiment, &found](const std::size_t sign)
    {
        const std::size_t seen = std::min(sign, now_);
        const std::uint32_t silent_us = (seen > experiment.cycle) ? Since(experiment, seen - 1U) : 0U;
        return found.us - std::min(found.us, silent_us) > limits_.Of(experiment, recording_);
    };
    const bool is_call = experiment.part == Part::kCallsOfA || experiment.part == Part::kCallsOfB;
    const bool may_lie_still =
        is_call || (IsMemory(experiment.part) && !IsOfTest(found, device_.Places()[experiment.place].name));
    if (is_above(may_lie_still ? signs.effect : signs.memory))
    {
        return kMarkLate;
    }
    return is_above(signs.spread) ? kMarkLatent : std::uint8_t{0U};
}

void Runner::NoticeSigns(const Experiment& experiment, const Sight& sight, Signs& signs) const
{
    const auto notice = [this](std::size_t& sign, const bool is_there)
    { sign = (sign == kNever && is_there) ? now_ : sign; };
    notice(signs.memory, !IsAsWithoutFault(now_ + 1U));
    notice(signs.spread, HasSpread(experiment));
    notice(signs.effect, DoesOtherwise(sight));
}

/// What a person outside or the safety function can see: output, frames, what the application is told and given.
bool Runner::DoesOtherwise(const Sight& sight) const
{
    const Sight& was = sights_[now_];
    const bool is_output = sight.open != was.open || sight.not_inverse != was.not_inverse || sight.listed != was.listed;
    const bool is_frame = sight.is_bad_frame != was.is_bad_frame || sight.is_overdue != was.is_overdue ||
                          sight.is_missed != was.is_missed;
    const std::uint8_t* const is = device_.Memory().Bytes();
    const std::uint8_t* const without = kept_.data() + ((now_ + 1U - first_) * size_);
    ToldCopies was_told{};
    std::memcpy(was_told.data(), without + device_.Memory().OffsetOf(&device_.Application().copies), sizeof(was_told));
    const bool is_told = !(device_.Application().Now() == MajorityOf(was_told));
    return is_output || is_frame || is_told ||
           std::any_of(read_.begin(), read_.end(), [is, without](const ReadBytes& each)
                       { return std::memcmp(is + each.offset, without + each.offset, each.size) != 0; });
}

/// Other frames, or at another time.
bool Runner::SendsOtherwise() const
{
    const FlatPorts& ports = device_.Ports();
    const std::uint8_t* const without = kept_.data() + ((now_ + 1U - first_) * size_);
    return std::memcmp(&ports.frames, without + device_.Memory().OffsetOf(&ports.frames), sizeof(ports.frames)) != 0;
}

bool Runner::HasSpread(const Experiment& experiment) const
{
    const std::uint8_t* const is = device_.Memory().Bytes();
    const std::uint8_t* const was = kept_.data() + ((now_ + 1U - first_) * size_);
    const auto part = static_cast<std::uint8_t>(experiment.part);
    const auto is_hit = [&experiment, part](const std::uint8_t owner)
    {
        return owner == part ||
               (experiment.part == Part::kBothChannels && owner <= static_cast<std::uint8_t>(Part::kChannelB));
    };
    for (std::size_t offset = 0U; offset < size_; ++offset)
    {
        if (is[offset] != was[offset] && !is_hit(owner_[offset]))
        {
            return true;
        }
    }
    return false;
}

std::uint32_t Runner::ExceptionUs() const noexcept
{
    return LateCycleUs(device_.Config());
}

void Runner::Watch(const Experiment& experiment)
{
    JudgeMemory memory = memories_[experiment.cycle];
    std::size_t end = EndOf(experiment);
    bool is_settling = false;
    for (; now_ < end; ++now_)
    {
        RunCycle();
        const Sight sight = judge_.Look(now_, memory);
        if (watcher_ != nullptr)
        {
            watcher_->OnCycle(now_, sight);
        }
        is_otherwise_ = is_otherwise_ || DoesOtherwise(sight) || SendsOtherwise();
        if (Notice(sight, experiment))
        {
            return;
        }
        const bool is_safe = HasGivenUp(device_) && sight.open == 0U;
        if (is_safe && !is_settling)
        {
            is_settling = true;
            end = std::min(end, now_ + kSettleCycles);
        }
        if (IsOver(experiment, now_) && device_.IsUndisturbed(now_) && IsAsWithoutFault(now_ + 1U))
        {
            const Class undone = (is_obeyed_ || is_otherwise_) ? Class::kBenign : Class::kMasked;
            found_.result = (found_.result == Class::kOpen) ? undone : found_.result;
            return;
        }
    }
    found_.result = (found_.result == Class::kOpen) ? Class::kBenign : found_.result;
}

/// True: nothing that comes later counts.
bool Runner::Notice(const Sight& sight, const Experiment& experiment)
{
    if (sight.wrong != Wrong::kNothing)
    {
        return NoticeWrong(sight, experiment);
    }
    if (is_exposed_ && HasClosed(sight))
    {
        is_exposed_ = false;
        const std::uint32_t us = Since(experiment, now_);
        if (us <= limits_.Of(experiment, recording_))
        {
            const std::uint8_t old = (found_.detail == static_cast<std::uint8_t>(Wrong::kOldPair)) ? kMarkOldPair : 0U;
            found_ = Blame();
            found_.result = Class::kExposed;
            found_.marks |= old;
            found_.us = us;
        }
    }
    if (found_.result != Class::kOpen)
    {
        return false;
    }
    if (sight.listed != 0U)
    {
        found_.result = Class::kListed;
        found_.us = Since(experiment, now_);
        return false;
    }
    if (HasClosed(sight))
    {
        NoticeClosed(experiment);
    }
    else if (sight.not_inverse != 0U || sight.is_missed)
    {
        found_.result = Class::kSafeOther;
        found_.detector = (sight.not_inverse != 0U) ? Detector::kPairCheck : Detector::kReceivers;
        found_.us = Since(experiment, now_);
    }
    else
    {
        // Nothing to be seen yet.
    }
    return false;
}

/// A device that does what a false command says found nothing. [SRS_CMG_029]
void Runner::NoticeClosed(const Experiment& experiment)
{
    const Outcome blamed = Blame();
    const bool is_of_command = blamed.detector == Detector::kPermits ||
                               (blamed.detector == Detector::kChannels &&
                                (blamed.detail == static_cast<std::uint8_t>(SrdoCause::kNotOperational) ||
                                 blamed.detail == static_cast<std::uint8_t>(SrdoCause::kGfc)));
    if (experiment.part == Part::kCommands && is_of_command)
    {
        is_obeyed_ = true;
        return;
    }
    found_ = blamed;
    found_.us = Since(experiment, now_);
}

/// Memory that is wrong may be so until the march meets it, and old data may be sent until somebody finds why: within
/// the limit, where there is one. [SRS_CMG_151, SRS_CMG_812]
bool Runner::NoticeWrong(const Sight& sight, const Experiment& experiment)
{
    const bool has_march = device_.SelfTest() != nullptr && IsMemory(experiment.part);
    const bool is_of_time = (has_march && sight.wrong == Wrong::kData) || sight.wrong == Wrong::kOldPair;
    const bool may_be_found = is_of_time && (is_exposed_ || found_.result == Class::kOpen) &&
                              Since(experiment, now_) <= limits_.Of(experiment, recording_);
    if (!is_exposed_ || !may_be_found)
    {
        found_ = Outcome{Class::kSilent, Detector::kNobody, static_cast<std::uint8_t>(sight.wrong), 0U,
                         Since(experiment, now_)};
    }
    is_exposed_ = may_be_found;
    return !may_be_found;
}

bool Runner::HasClosed(const Sight& sight) const
{
    return (sights_[now_].open & ~sight.open) != 0U || (HasGivenUp(device_) && sight.open == 0U);
}

Outcome Runner::Blame() const
{
    Outcome outcome{Class::kDetected, Detector::kPermits, 0U, 0U, 0U};
    const DeviceFault fault = device_.Fault();
    if (fault != DeviceFault::kNone)
    {
        const bool is_of_test = fault == DeviceFault::kSelfTest && device_.SelfTest() != nullptr;
        outcome.detector = is_of_test ? Detector::kSelfTest : DetectorOf(fault);
        outcome.detail = static_cast<std::uint8_t>(fault);
    }
    else if (!device_.IsOutputLive())
    {
        outcome.detector = Detector::kPins;
    }
    else if (!device_.IsWatchdogAlive())
    {
        outcome.detector = Detector::kWatchdog;
    }
    else if (device_.Application().Now().faulted != 0U)
    {
        outcome.detector = Detector::kChannels;
        const SrdoCause cause = FirstCauseOf(device_);
        outcome.detail = static_cast<std::uint8_t>(cause);
        outcome.marks = WhoSaid(device_, cause);
    }
    else
    {
        // The gate alone.
    }
    return outcome;
}

std::vector<std::size_t> Runner::DifferentPlaces() const
{
    const std::uint8_t* const was = kept_.data() + ((now_ + 1U - first_) * size_);
    std::vector<std::size_t> different;
    for (std::size_t index = 0U; index < device_.Places().size(); ++index)
    {
        const Place& place = device_.Places()[index];
        if (std::memcmp(device_.Memory().Bytes() + place.offset, was + place.offset, place.size) != 0)
        {
            different.push_back(index);
        }
    }
    return different;
}

/// What differs mostly goes on to: that byte is looked at first.
bool Runner::IsAsWithoutFault(const std::size_t cycle) const
{
    const std::uint8_t* const is = device_.Memory().Bytes();
    const std::uint8_t* const was = kept_.data() + ((cycle - first_) * size_);
    if (is[differs_at_] != was[differs_at_])
    {
        return false;
    }
    if (std::memcmp(is, was, size_) == 0)
    {
        return true;
    }
    differs_at_ = static_cast<std::size_t>(std::mismatch(is, is + size_, was).first - is);
    return false;
}

/// A fault before the cycle may have come as early as behind the cycle before.
std::uint32_t Runner::Since(const Experiment& experiment, const std::size_t cycle) const
{
    const bool is_before = experiment.phase < Phase::kFirstStep;
    const Nanoseconds began = recording_.cycles[experiment.cycle - (is_before ? 1U : 0U)].at;
    return static_cast<std::uint32_t>((recording_.cycles[cycle].at - began) / runtime::kNanosecondsPerMicrosecond);
}
} // namespace counterpoint::campaign
