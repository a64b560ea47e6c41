// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/two_cpus.hpp"

#include "verification/campaign/calls.hpp"
#include "verification/campaign/variants.hpp"

#include <algorithm>
#include <stdexcept>

namespace counterpoint::campaign
{
namespace
{
constexpr std::int64_t kMillion = 1000000;

DeviceSetup FirstSetup(const RecordedScenario& scenario, const bool has_call_faults)
{
    DeviceSetup setup;
    setup.has_call_faults = has_call_faults;
    setup.cpu = CpuOfTwo{LinkConfigOf(scenario, PeerRole::kA), "cpu_a.", nullptr, nullptr};
    return setup;
}

/// What one of them is called with, and what it calls.
bool IsOfOneCpu(const Part part)
{
    return IsOfEachCpu(part) || part == Part::kCallsOfA || part == Part::kCallsOfB;
}

/// So many cycles of CPU A end before the first one of CPU B.
std::size_t LeadOf(const Recording& a, const Recording& b)
{
    return CycleOf(a, b.cycles.front().at);
}
} // namespace

LinkConfig LinkConfigOf(const RecordedScenario& scenario, const PeerRole role)
{
    const simulator::LinkSetup& link = scenario.Link();
    const auto us = [](const Nanoseconds time)
    { return static_cast<std::uint32_t>(time / runtime::kNanosecondsPerMicrosecond); };
    return {role, us(link.timeout), us(link.clock_tolerance), us(link.clock_interval), us(link.stamp_tolerance)};
}

TwoCpus::TwoCpus(Region& region, const RecordedScenario& scenario, const bool has_call_faults)
    : Device(region, scenario.Model(), scenario.Record(), OutputKind::kGate, FirstSetup(scenario, has_call_faults)),
      recordings_{&scenario.Record(), &scenario.SecondRecord()},
      second_(region, scenario.SecondModel(), scenario.SecondRecord(), OutputKind::kGate,
              [this, &scenario, has_call_faults]()
              {
                  DeviceSetup setup;
                  setup.has_call_faults = has_call_faults;
                  setup.cpu = CpuOfTwo{LinkConfigOf(scenario, PeerRole::kB), "cpu_b.", application_, ports_};
                  return setup;
              }()),
      split_(second_.places_.front().offset), lead_(LeadOf(scenario.Record(), scenario.SecondRecord())),
      counters_{scenario.Record().counters, scenario.SecondRecord().counters}, progress_(&region.Make<Progress>()),
      hooks_{CpuHook(*this, 0U), CpuHook(*this, 1U)}
{
    progress_->link.delay_ns = scenario.Link().delay;
    for (const Place& place : second_.places_)
    {
        split_ = std::min(split_, place.offset);
    }
    places_.insert(places_.end(), second_.places_.begin(), second_.places_.end());
    // CPU A's application has the normal object of each pair, CPU B's the inverse one.
    for (std::size_t pair = 0U; pair < pairs_.size(); ++pair)
    {
        pairs_[pair].inverse = second_.pairs_[pair].inverse;
    }
    b_ = second_.b_;
    flow_->hook = hooks_.data();
    second_.flow_->hook = &hooks_[1];
    RequireTurns();
    MatchCommands();
    region.Close();
}

void TwoCpus::RequireTurns() const
{
    const std::vector<RecordedCycle>& a = recordings_[0]->cycles;
    const std::vector<RecordedCycle>& b = recordings_[1]->cycles;
    for (std::size_t cycle = lead_ + 1U; cycle < a.size() && cycle - lead_ < b.size(); ++cycle)
    {
        const Nanoseconds at = b[cycle - lead_].at;
        if (at <= a[cycle - 1U].at || at > a[cycle].at)
        {
            throw std::runtime_error("the cycles of the two CPUs overtake each other in cycle " +
                                     std::to_string(cycle) + "; expected: phases farther apart, or less drift");
        }
    }
}

/// A fault of a command is told by its number in the recording of CPU A; CPU B is told the same, or some of it.
void TwoCpus::MatchCommands()
{
    const std::vector<RecordedCommand>& b = recordings_[1]->commands;
    std::size_t next = 0U;
    for (const RecordedCommand& command : recordings_[0]->commands)
    {
        const bool is_told =
            next < b.size() && b[next].what.is_gfc == command.what.is_gfc && b[next].what.nmt == command.what.nmt;
        commands_of_b_.push_back(is_told ? std::optional<std::size_t>(next) : std::nullopt);
        next += is_told ? 1U : 0U;
    }
    if (next != b.size())
    {
        throw std::runtime_error("CPU B is told a command in its cycle " + std::to_string(b[next].cycle) +
                                 " that CPU A is not; expected: commands that lie farther apart");
    }
}

std::optional<std::size_t> TwoCpus::CycleOfCommand(const std::size_t command, const std::size_t cpu) const
{
    if (cpu == 0U)
    {
        return recordings_[0]->commands[command].cycle;
    }
    const std::optional<std::size_t> own = commands_of_b_[command];
    return own ? std::optional<std::size_t>(recordings_[1]->commands[*own].cycle + lead_) : std::nullopt;
}

Device& TwoCpus::Cpu(const std::size_t cpu) noexcept
{
    return (cpu == 0U) ? static_cast<Device&>(*this) : second_;
}

const Device& TwoCpus::Cpu(const std::size_t cpu) const noexcept
{
    return (cpu == 0U) ? static_cast<const Device&>(*this) : second_;
}

void TwoCpus::Follow(PhaseHook* const hook) noexcept
{
    hook_ = hook;
}

/// Without a fault all phases, of which the runner learns what each bit ever is.
void TwoCpus::Tell(const std::size_t cpu, const Phase phase) noexcept
{
    const bool is_hit = fault_ == nullptr || (IsMemory(fault_->part) && (fault_->offset >= split_) == (cpu == 1U)) ||
                        (fault_->part == Part::kSteps && fault_->cpu == cpu);
    if (hook_ != nullptr && is_hit)
    {
        hook_->At(phase);
    }
}

void TwoCpus::Rewind(const std::size_t cycle, const Experiment* const fault, const std::size_t end,
                     const std::uint64_t seed)
{
    const std::size_t own = (cycle < lead_) ? 0U : cycle - lead_;
    fault_ = fault;
    second_fault_ = (fault == nullptr) ? Experiment{} : *fault;
    // Of its calls those of the period that begins now: of the one before, frames may have come already.
    const bool is_call = second_fault_.part == Part::kKernelCalls || second_fault_.part == Part::kCallsOfB;
    second_fault_.cycle = second_fault_.cycle - std::min(second_fault_.cycle, lead_) + (is_call ? 1U : 0U);
    if (second_fault_.part == Part::kCommands && second_fault_.kind != FaultKind::kInserted)
    {
        second_fault_.subject = commands_of_b_[second_fault_.subject].value_or(0U); // CPU B has its own numbers.
    }
    Receives().Rewind(cycle, FaultOf(0U), end, seed);
    second_.Receives().Rewind(own, FaultOf(1U), end, seed);
    feed_.OfCalls().BeginCycle(cycle);
    second_.feed_.OfCalls().BeginCycle(own);
    counters_ = {recordings_[0]->counters, recordings_[1]->counters};
    if (fault != nullptr && (fault->part == Part::kCpu || fault->part == Part::kCounters))
    {
        since_ = recordings_[0]->cycles[fault->cycle - 1U].at;
        const CounterFault what = CounterFaultOf(*fault);
        if (!IsDead(fault->subject))
        {
            counters_.at(fault->subject).Disturb(0U, since_, what.rate_ppm, what.jump_us);
        }
    }
}

/// What becomes of what this CPU receives, is called with, and calls.
const Experiment* TwoCpus::FaultOf(const std::size_t cpu) const noexcept
{
    if (fault_ == nullptr || fault_->part == Part::kCounters)
    {
        return nullptr; // Instants are stamped here.
    }
    const std::size_t of_call = (fault_->part == Part::kCallsOfB) ? 1U : 0U;
    const std::size_t hit = IsOfEachCpu(fault_->part) ? fault_->cpu : of_call;
    if (IsOfOneCpu(fault_->part) && hit != cpu)
    {
        return nullptr;
    }
    const bool counts_by_own = IsOfOneCpu(fault_->part) || fault_->part == Part::kInputs;
    return (cpu == 1U && counts_by_own) ? &second_fault_ : fault_;
}

bool TwoCpus::IsUndisturbed(const std::size_t cycle) const
{
    if (fault_ != nullptr &&
        (fault_->part == Part::kLink || fault_->part == Part::kCpu || fault_->part == Part::kCounters))
    {
        return false; // Messages are counted, a clock never goes back: it is not again as it was.
    }
    return Device::IsUndisturbed(cycle) && second_.feed_.IsUndisturbed((cycle < lead_) ? 0U : cycle - lead_);
}

/// It does nothing any more.
bool TwoCpus::IsDead(const std::size_t cpu) const noexcept
{
    return fault_ != nullptr && fault_->part == Part::kCpu && fault_->subject == cpu && now_ >= fault_->cycle &&
           fault_->kind == FaultKind::kStopped && fault_->variant == 0U;
}

/// An oscillator that is fast or slow is that of the cycles, too.
Nanoseconds TwoCpus::TimeOf(const std::size_t cpu, const std::size_t cycle) const
{
    const std::vector<RecordedCycle>& cycles = recordings_.at(cpu)->cycles;
    if (cycle >= cycles.size())
    {
        return cycles.back().at * 2;
    }
    const Nanoseconds at = cycles[cycle].at;
    const bool is_hit = fault_ != nullptr && fault_->part == Part::kCpu && fault_->subject == cpu && at > since_ &&
                        fault_->kind != FaultKind::kStopped;
    return is_hit ? since_ + ((at - since_) * kMillion / (kMillion + CounterFaultOf(*fault_).rate_ppm)) : at;
}

bool TwoCpus::IsTimeHit(const std::size_t cpu) const noexcept
{
    return fault_ != nullptr && fault_->part == Part::kCycle && fault_->cpu == cpu;
}

/// When its kernel is called next, or a cycle of it ends without a call.
Nanoseconds TwoCpus::NextCall(const std::size_t cpu) const
{
    const std::size_t own = progress_->next.at(cpu);
    if (!IsTimeHit(cpu) || own >= recordings_.at(cpu)->cycles.size())
    {
        return TimeOf(cpu, own);
    }
    const Calls calls = Cpu(cpu).feed_.CallsIn(own);
    const std::size_t called = progress_->called.at(cpu);
    return (called < calls.count) ? calls.at.at(called) : TimeOf(cpu, own);
}

/// Whether its kernel is called now. Behind the last call of a cycle comes the next cycle.
bool TwoCpus::TakeTurn(const std::size_t cpu, const Nanoseconds at)
{
    std::size_t& own = progress_->next.at(cpu);
    std::size_t& called = progress_->called.at(cpu);
    bool is_call = !IsDead(cpu);
    bool is_last = true;
    if (IsTimeHit(cpu))
    {
        const Calls calls = Cpu(cpu).feed_.CallsIn(own);
        is_call = called < calls.count;
        called += is_call ? 1U : 0U;
        is_last = called >= calls.count && at >= TimeOf(cpu, own);
    }
    if (is_last)
    {
        called = 0U;
        ++own;
    }
    return is_call;
}

/// Each CPU has one counter.
InstantPair TwoCpus::StampOf(const std::size_t cpu, const Nanoseconds at) const
{
    const Instant instant = counters_.at(cpu).At(at).a;
    return {instant, instant};
}

void TwoCpus::Cycle(const std::size_t cycle)
{
    now_ = cycle;
    ports_->MoveOn();
    ForgetErrors(*recordings_[0], cycle, *application_);
    progress_->has_come = {false, false};
    for (std::size_t cpu = 0U; cpu < 2U; ++cpu)
    {
        Cpu(cpu).feed_.BeginCycle();
        Tell(cpu, Phase::kBeforeFrames);
    }
    const Nanoseconds until = recordings_[0]->cycles[cycle].at;
    for (Next next = NextUntil(until); next.event != Event::kNothing; next = NextUntil(until))
    {
        Do(next, cycle);
    }
    SetTime(until);
    second_.SetTime(until);
}

/// Of one instant first what comes by the bus, then the link, then cycles.
TwoCpus::Next TwoCpus::NextUntil(const Nanoseconds until) const
{
    Next next;
    const auto take = [&next, until](const Event event, const std::size_t cpu, const Nanoseconds at)
    {
        if (at <= until && (next.event == Event::kNothing || at < next.at))
        {
            next = {event, cpu, at};
        }
    };
    for (std::size_t cpu = 0U; cpu < 2U; ++cpu)
    {
        if (const std::optional<RecordedFrame> frame = Cpu(cpu).feed_.FrameUntil(until))
        {
            take(Event::kFrame, cpu, frame->at);
        }
    }
    if (ports_->confirmed < std::min<std::uint32_t>(ports_->count, kMostOwnFrames))
    {
        take(Event::kOwnFrame, 0U, ports_->frames[ports_->confirmed].confirmed_at);
    }
    for (std::size_t cpu = 0U; cpu < 2U; ++cpu)
    {
        if (const Flight* const flight = progress_->link.Next(cpu, until))
        {
            take(Event::kMessage, cpu, flight->at);
        }
    }
    for (std::size_t cpu = 0U; cpu < 2U; ++cpu)
    {
        take(Event::kCycle, cpu, NextCall(cpu));
    }
    return next;
}

void TwoCpus::Do(const Next& next, const std::size_t cycle)
{
    Device& cpu = Cpu(next.cpu);
    if (next.event == Event::kFrame)
    {
        RecordedFrame frame = *cpu.feed_.FrameUntil(next.at);
        frame.stamped.stamp = StampOf(next.cpu, frame.at);
        cpu.feed_.Hand(frame, *cpu.kernel_);
        NoteFrame(next.cpu);
    }
    else if (next.event == Event::kOwnFrame)
    {
        const OwnFrame own = ports_->frames[ports_->confirmed];
        ++ports_->confirmed;
        ports_->now = own.confirmed_at;
        for (std::size_t each = 0U; each < 2U; ++each)
        {
            const StampedFrame stamped{own.frame, StampOf(each, own.confirmed_at)};
            Device& self = Cpu(each);
            self.SetTime(own.confirmed_at);
            self.peer_->IsEcho(own.frame) ? self.feed_.Confirm(stamped, *self.kernel_) : self.kernel_->OnFrame(stamped);
            NoteFrame(each);
        }
    }
    else if (next.event == Event::kMessage)
    {
        const Flight flight = *progress_->link.Next(next.cpu, next.at);
        progress_->link.Drop(next.cpu);
        cpu.peer_->OnMessage(flight.message, StampOf(next.cpu, flight.at).a);
    }
    else
    {
        RunCpu(next.cpu, next.at, cycle);
    }
}

void TwoCpus::NoteFrame(const std::size_t cpu) noexcept
{
    if (!progress_->has_come.at(cpu))
    {
        Tell(cpu, Phase::kBetweenFrames);
    }
    progress_->has_come.at(cpu) = true;
}

/// As the contract of Peer has it.
void TwoCpus::RunCpu(const std::size_t cpu, const Nanoseconds at, const std::size_t cycle)
{
    Device& self = Cpu(cpu);
    const std::size_t own = progress_->next.at(cpu);
    if (!TakeTurn(cpu, at))
    {
        return;
    }
    if (!progress_->has_come.at(cpu))
    {
        Tell(cpu, Phase::kBetweenFrames);
    }
    Tell(cpu, Phase::kAfterFrames);
    self.SetTime(at);
    ports_->now = at;
    self.feed_.TellCommands(own, *self.kernel_);
    CycleCall call = self.feed_.CallOf(own, at);
    call.now = StampOf(cpu, at);
    if (self.peer_->Examine(call.now.a) != LinkFinding::kNone)
    {
        self.kernel_->OnCrossLinkFault();
    }
    self.target_ = {&feed_, &pairs_, cycle, cpu == 0U, cpu == 1U}; // A side of each pair lies in each CPU.
    application_->provider = &self;
    self.kernel_->Cycle(call);
    feed_.WriteInputs({&feed_, &pairs_, cycle}, 0U);
    hal::LinkFrame message{};
    self.peer_->Compose({call.now.a, self.kernel_->DeviceState().fault}, message);
    const bool is_hit =
        fault_ != nullptr && fault_->part == Part::kLink && fault_->subject == cpu && cycle >= fault_->cycle;
    progress_->link.Send(cpu, message, at, is_hit ? fault_ : nullptr, is_hit ? cycle - fault_->cycle : 0U);
    BeginPeriod(cpu);
}

/// What was late comes now.
void TwoCpus::BeginPeriod(const std::size_t cpu)
{
    Device& self = Cpu(cpu);
    DisturbedChannel* const disturbed = (cpu == 0U) ? self.disturbed_a_ : self.disturbed_b_;
    if (disturbed != nullptr)
    {
        disturbed->BeginCycle();
    }
    self.feed_.BeginPeriod(progress_->next.at(cpu), *self.kernel_);
}

/// What a CPU that is hit as a whole does with its own output does not count.
SrdoMask TwoCpus::Open() noexcept
{
    const bool is_of_cpu = fault_ != nullptr && fault_->part == Part::kCpu;
    const SrdoMask first = Device::Open();
    const SrdoMask second = second_.Open();
    if (is_of_cpu)
    {
        return (fault_->subject == 0U) ? second : first;
    }
    return first & second;
}

/// The other CPU's word that the first one is safe is no cause of its own.
DeviceFault TwoCpus::Fault() const noexcept
{
    const DeviceFault first = Device::Fault();
    const DeviceFault second = second_.Fault();
    const bool is_of_cpu = fault_ != nullptr && fault_->part == Part::kCpu;
    if (is_of_cpu)
    {
        return (fault_->subject == 0U) ? second : first;
    }
    const bool asks_second =
        first == DeviceFault::kNone || (first == DeviceFault::kCrossLink && second != DeviceFault::kNone);
    return asks_second ? second : first;
}

/// Of a CPU that is hit as a whole the word does not count either.
bool TwoCpus::IsFaultTold() const noexcept
{
    const bool is_of_cpu = fault_ != nullptr && fault_->part == Part::kCpu;
    return is_of_cpu ? Fault() != DeviceFault::kNone : application_->Now().device_fault != DeviceFault::kNone;
}

bool TwoCpus::IsWatchdogAlive() const noexcept
{
    return Device::IsWatchdogAlive() && second_.IsWatchdogAlive();
}
} // namespace counterpoint::campaign
