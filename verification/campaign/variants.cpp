// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/variants.hpp"

#include "hal/api/cross_link.hpp"
#include "runtime/device/time_text.hpp"

#include "verification/campaign/drawn.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>

namespace counterpoint::campaign
{
namespace
{
constexpr std::uint32_t kIdentifierBits = 11U;
constexpr FrameKind kOtherKinds[] = {FrameKind::kRemote, FrameKind::kExtended, FrameKind::kFlexibleDataRate};
constexpr std::uint32_t kBitsOfByte = 8U;
constexpr std::int64_t kRates[] = {100,   200,   500,    1000,   2000,   5000,  10000,
                                   20000, 50000, 100000, 200000, 500000, 900000};
constexpr std::int32_t kJumps[] = {50,      100,     200,      500,       1000,       2000,      5000,
                                   10000,   20000,   50000,    100000,    200000,     500000,    1000000,
                                   2000000, 5000000, 30000000, 600000000, 1073741824, 2147483647};
constexpr std::int64_t kStandsStill = -1000000;

constexpr std::array<const char*, kChannelCalls> kChannelCallWords{"OnFrame",      "OnCycle", "Held",    "Demote",
                                                                   "Commit",       "Answer",  "Prepare", "OnConfirm",
                                                                   "InverseFrame", "Load",    "Recheck"};
constexpr std::array<const char*, kKernelCalls> kKernelCallWords{"OnFrame", "OnConfirm", "OnRefresh"};
constexpr NmtState kStates[] = {NmtState::kInitialising, NmtState::kPreOperational, NmtState::kStopped,
                                NmtState::kOperational};
constexpr const char* kStateWords[] = {"initialising", "pre_operational", "stopped", "operational"};
constexpr std::array<const char*, kCounterSubjects> kCounterWords{"counter_a", "counter_b", "both_counters"};

std::uint64_t BusVariants(const FaultKind kind, const std::uint64_t reach, const std::size_t identifiers)
{
    if (kind == FaultKind::kLost)
    {
        return kLossVariants;
    }
    if (kind == FaultKind::kWrongOrder)
    {
        return kOrderVariants;
    }
    if (kind == FaultKind::kCorrupted)
    {
        return 1U; // Each bit is a subject of its own.
    }
    if (kind == FaultKind::kWrongLength)
    {
        return kLengthVariants;
    }
    return (kind == FaultKind::kWrongIdentifier) ? kIdentifierBits + (identifiers - 1U) + std::size(kOtherKinds)
                                                 : reach;
}

std::uint64_t LinkVariants(const FaultKind kind, const std::uint64_t reach)
{
    if (kind == FaultKind::kLost)
    {
        return kLinkLossVariants;
    }
    if (kind == FaultKind::kCorrupted)
    {
        return hal::kLinkFrameBytes * std::uint64_t{kBitsOfByte};
    }
    return (kind == FaultKind::kWrongOrder) ? kOrderVariants : reach;
}

std::uint64_t CounterVariants(const FaultKind kind)
{
    if (kind == FaultKind::kStopped)
    {
        return 1U;
    }
    return (kind == FaultKind::kJump) ? 2U * std::size(kJumps) : std::size(kRates);
}

std::uint64_t CommandVariants(const FaultKind kind)
{
    if (kind == FaultKind::kInserted)
    {
        return kCommandCount;
    }
    if (kind == FaultKind::kWrongCommand)
    {
        return kWrongCommands;
    }
    return (kind == FaultKind::kSkipped) ? 1U : kCommandCycles;
}

std::string OffsetText(const Experiment& fault)
{
    std::array<char, 32U> text{};
    std::snprintf(text.data(), text.size(), "%.2f ms", (fault.variant + 1U) * 0.05);
    return text.data();
}

std::string IdentifierText(const RecordedFrame& frame)
{
    std::array<char, 16U> text{};
    std::snprintf(text.data(), text.size(), "%Xh", static_cast<unsigned>(frame.stamped.frame.identifier));
    return text.data();
}

std::string FrameText(const RecordedFrame& frame)
{
    return "frame " + IdentifierText(frame) + " at " + runtime::MillisecondsColumn(frame.at, 0U);
}

std::string BusText(const Experiment& fault, const Recording& recording)
{
    const bool is_pair = IsOfPair(fault.kind);
    const std::size_t frame = is_pair ? recording.pairs[fault.subject].normal : fault.subject;
    const std::string text = (is_pair ? "pair of " : "") + FrameText(recording.frames[frame]);
    if (BusVariants(fault.kind, 0U, 1U) == 0U)
    {
        return text + " + " + OffsetText(fault);
    }
    return text + " variant " + std::to_string(fault.variant);
}

std::string CallText(const std::string& name, const Experiment& fault)
{
    return name + " call " + std::to_string((fault.subject % kTurns) + 1U) +
           (((fault.variant & kNothingLeft) != 0U) ? " answers 0" : "") +
           (((fault.variant & kAlways) != 0U) ? " always" : "");
}

std::string CommandName(const Command& command)
{
    if (command.is_gfc)
    {
        return "gfc";
    }
    const auto* const found = std::find(std::begin(kStates), std::end(kStates), command.nmt);
    return (found == std::end(kStates)) ? "state " + std::to_string(static_cast<unsigned>(command.nmt))
                                        : kStateWords[found - std::begin(kStates)];
}

std::string CommandText(const std::string& name, const Experiment& fault, const Recording& recording)
{
    if (fault.kind == FaultKind::kInserted)
    {
        return name;
    }
    std::array<char, 32U> at{};
    std::snprintf(at.data(), at.size(), " in cycle %zu", fault.cycle);
    const std::string text = name + at.data();
    if (fault.kind == FaultKind::kWrongCommand)
    {
        return text + " as " + CommandName(WrongCommand(recording.commands[fault.subject].what, fault.variant));
    }
    const std::uint32_t cycles = fault.variant + ((fault.kind == FaultKind::kLate) ? 1U : 0U);
    return (fault.kind == FaultKind::kSkipped) ? text : text + " by " + std::to_string(cycles) + " cycles";
}

std::string LinkText(const std::string& name, const Experiment& fault)
{
    const bool moves = fault.kind == FaultKind::kRepeated || fault.kind == FaultKind::kDelayed;
    if (fault.kind == FaultKind::kCorrupted)
    {
        return name + " bit " + std::to_string(fault.variant / kBitsOfByte) + "." +
               std::to_string(fault.variant % kBitsOfByte);
    }
    return moves ? name + " + " + OffsetText(fault) : name + " variant " + std::to_string(fault.variant);
}

std::string CpuText(const std::string& name, const Experiment& fault)
{
    if (fault.kind == FaultKind::kStopped)
    {
        return name + (fault.variant == 0U ? " as a whole" : " clock alone");
    }
    return name + " " + std::to_string(CounterFaultOf(fault).rate_ppm) + " ppm";
}

std::string CounterText(const std::string& name, const Experiment& fault)
{
    const CounterFault what = CounterFaultOf(fault);
    return name + ((fault.kind == FaultKind::kJump) ? " " + std::to_string(what.jump_us) + " us"
                                                    : " " + std::to_string(what.rate_ppm) + " ppm");
}
} // namespace

std::uint64_t VariantsOf(const Part part, const FaultKind kind, const std::uint64_t reach,
                         const std::size_t identifiers)
{
    if (part == Part::kBus)
    {
        return BusVariants(kind, reach, identifiers);
    }
    if (part == Part::kLink)
    {
        return LinkVariants(kind, reach);
    }
    if (part == Part::kCpu && kind == FaultKind::kStopped)
    {
        return kStopVariants;
    }
    if (part == Part::kCounters || part == Part::kCpu)
    {
        return CounterVariants(kind);
    }
    if (part == Part::kCycle)
    {
        return (kind == FaultKind::kSkipped) ? kSkippedCycles : (kind == FaultKind::kDoubled) ? 1U : reach;
    }
    if (part == Part::kCommands)
    {
        return CommandVariants(kind);
    }
    if (part == Part::kInputs)
    {
        return 1U;
    }
    const bool has_answer = part != Part::kKernelCalls && kind == FaultKind::kSkipped;
    const bool has_mark = part == Part::kSteps && kind != FaultKind::kLate;
    return (has_answer || has_mark) ? 4U : 2U;
}

CounterFault CounterFaultOf(const Experiment& fault)
{
    CounterFault what;
    what.which = fault.subject;
    if (fault.kind == FaultKind::kStopped)
    {
        what.rate_ppm = kStandsStill;
    }
    else if (fault.kind == FaultKind::kJump)
    {
        what.jump_us = (fault.variant % 2U == 0U) ? kJumps[fault.variant / 2U] : -kJumps[fault.variant / 2U];
    }
    else
    {
        what.rate_ppm = (fault.kind == FaultKind::kFast) ? kRates[fault.variant] : -kRates[fault.variant];
    }
    return what;
}

Command CommandNumber(const std::uint32_t number)
{
    const bool is_gfc = number + 1U == kCommandCount;
    return {is_gfc, is_gfc ? NmtState::kInvalid : kStates[number]};
}

Command WrongCommand(const Command& command, const std::uint32_t variant)
{
    if (variant < kCommandCount)
    {
        return CommandNumber(variant);
    }
    const auto state = static_cast<std::uint32_t>(command.nmt);
    return {false, static_cast<NmtState>(state ^ (1U << (variant - kCommandCount)))};
}

std::uint64_t DrawnData(const std::uint64_t seed, const Experiment& fault)
{
    return Drawn(seed, (fault.subject << 32U) + fault.variant);
}

void Masquerade(const Recording& recording, const std::uint32_t variant, CanFrame& frame)
{
    if (variant < kIdentifierBits)
    {
        frame.identifier ^= 1U << variant;
        return;
    }
    const auto& known = recording.identifiers;
    const std::size_t other = variant - kIdentifierBits + 1U;
    if (other < known.size())
    {
        const auto own = static_cast<std::size_t>(
            std::distance(known.begin(), std::find(known.begin(), known.end(), frame.identifier)));
        frame.identifier = known[(own + other) % known.size()];
        return;
    }
    frame.kind = kOtherKinds[other - known.size()];
}

std::string SubjectName(const Experiment& fault, const Recording& recording)
{
    if (fault.cpu != kNoCpu)
    {
        Experiment of_one = fault;
        of_one.cpu = kNoCpu;
        return std::string((fault.cpu == 0U) ? "cpu_a " : "cpu_b ") + SubjectName(of_one, recording);
    }
    if (fault.part == Part::kBus)
    {
        const bool is_pair = IsOfPair(fault.kind);
        const std::size_t frame = is_pair ? recording.pairs[fault.subject].normal : fault.subject;
        return (is_pair ? "pair of " : "frame ") + IdentifierText(recording.frames[frame]);
    }
    if (fault.part == Part::kKernelCalls)
    {
        return std::string("kernel.") + kKernelCallWords.at(fault.subject / kTurns);
    }
    if (fault.part == Part::kCallsOfA || fault.part == Part::kCallsOfB)
    {
        return std::string((fault.part == Part::kCallsOfA) ? "channel_a." : "channel_b.") +
               kChannelCallWords.at(fault.subject / kTurns);
    }
    if (fault.part == Part::kSteps)
    {
        return std::string("step ") + WordOf(fault.phase);
    }
    if (fault.part == Part::kLink || fault.part == Part::kCpu)
    {
        return std::string((fault.part == Part::kLink) ? "link from " : "") + (fault.subject == 0U ? "cpu_a" : "cpu_b");
    }
    if (fault.part == Part::kCounters)
    {
        return kCounterWords.at(fault.subject);
    }
    if (fault.part == Part::kCommands)
    {
        return "command " + CommandName((fault.kind == FaultKind::kInserted) ? CommandNumber(fault.variant)
                                                                             : recording.commands[fault.subject].what);
    }
    return (fault.part == Part::kInputs) ? "input " + std::to_string(fault.subject) : "cycle";
}

std::string SubjectText(const Experiment& fault, const Recording& recording)
{
    const std::string tail = ((fault.variant & kAlways) != 0U) ? " always" : "";
    if (fault.part == Part::kBus)
    {
        return BusText(fault, recording);
    }
    const std::string name = SubjectName(fault, recording);
    if (fault.part == Part::kKernelCalls || fault.part == Part::kCallsOfA || fault.part == Part::kCallsOfB)
    {
        return CallText(name, fault);
    }
    if (fault.part == Part::kSteps)
    {
        return name + (((fault.variant & kNothingLeft) != 0U) ? " and its mark" : "") + tail;
    }
    if (fault.part == Part::kLink)
    {
        return LinkText(name, fault);
    }
    if (fault.part == Part::kCpu)
    {
        return CpuText(name, fault);
    }
    if (fault.part == Part::kCounters)
    {
        return CounterText(name, fault);
    }
    if (fault.part == Part::kCommands)
    {
        return CommandText(name, fault, recording);
    }
    if (fault.part == Part::kInputs)
    {
        return name;
    }
    return (fault.kind == FaultKind::kSkipped || fault.kind == FaultKind::kDoubled)
               ? name + " " + std::to_string(fault.variant + 1U) + " times"
               : name + " by " + OffsetText(fault);
}
} // namespace counterpoint::campaign
