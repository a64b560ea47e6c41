// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/judge/verdicts.hpp"
#include "simulator/scenario/names.hpp"

#include <algorithm>
#include <map>

namespace counterpoint::simulator
{
namespace
{
/// What was noticed at one instant: of each kind the first event.
struct Findings
{
    std::map<EventKind, const Event*> first;
    Nanoseconds at{-1};

    [[nodiscard]] const Event* Of(const EventKind kind) const
    {
        const auto found = first.find(kind);
        return (found == first.end()) ? nullptr : found->second;
    }
};

bool IsFinding(const Event& event)
{
    return event.kind == EventKind::kDeviceFault || event.kind == EventKind::kWatchdog ||
           event.kind == EventKind::kCauseA || event.kind == EventKind::kCauseB ||
           (event.kind == EventKind::kOutput && event.value == 0U);
}

Party PartyOf(const Event& device_fault)
{
    const auto fault = static_cast<DeviceFault>(device_fault.value);
    const bool is_verdict = device_fault.value == device_fault.other;
    switch (fault)
    {
    case DeviceFault::kDisagreement:
    case DeviceFault::kUnmatched:
        return is_verdict ? Party::kComparator : Party::kGuard;
    case DeviceFault::kGuard:
    case DeviceFault::kConfiguration:
        return Party::kChannels;
    case DeviceFault::kComparator:
        return Party::kKernel;
    case DeviceFault::kFlow:
        return Party::kFlowMonitor;
    case DeviceFault::kClock:
    case DeviceFault::kLateCall:
    case DeviceFault::kFrameOrder:
        return Party::kClockSupervisor;
    case DeviceFault::kSelfTest:
        return Party::kSelfTest;
    case DeviceFault::kCrossLink:
        return Party::kCrossLink;
    case DeviceFault::kInvalid:
    case DeviceFault::kApplication:
    case DeviceFault::kHandshake:
    case DeviceFault::kNone:
        break;
    }
    return Party::kKernel;
}

/// The cause of this cycle: the first cause if it is among the signalled ones, or was signalled before; else the
/// lowest.
SrdoCause CauseOf(const Event& event)
{
    const bool is_first = event.other == 0U || event.value >= 32U || ((event.other >> event.value) & 1U) != 0U;
    for (std::uint32_t cause = 1U; !is_first && cause < 32U; ++cause)
    {
        if (((event.other >> cause) & 1U) != 0U)
        {
            return static_cast<SrdoCause>(cause);
        }
    }
    return static_cast<SrdoCause>(event.value);
}

/// Whether a command may be the reason.
bool FollowsCommands(const Event& event)
{
    const bool is_cause = event.kind == EventKind::kCauseA || event.kind == EventKind::kCauseB;
    return event.kind == EventKind::kOutput || (is_cause && CauseOf(event) == SrdoCause::kNotOperational);
}

Detection Conclude(const Findings& findings)
{
    if (const Event* const fault = findings.Of(EventKind::kDeviceFault))
    {
        return {PartyOf(*fault), Name(static_cast<DeviceFault>(fault->value)), findings.at};
    }
    const Event* const cause_a = findings.Of(EventKind::kCauseA);
    const Event* const cause_b = findings.Of(EventKind::kCauseB);
    if (cause_a != nullptr || cause_b != nullptr)
    {
        const Party one = (cause_a != nullptr) ? Party::kChannelA : Party::kChannelB;
        const bool is_both = cause_a != nullptr && cause_b != nullptr;
        return {is_both ? Party::kChannels : one, Name(CauseOf((cause_a != nullptr) ? *cause_a : *cause_b)),
                findings.at};
    }
    if (findings.Of(EventKind::kWatchdog) != nullptr)
    {
        return {Party::kWatchdog, "wrong_or_no_answer", findings.at};
    }
    return {Party::kOutputGate, "no_right_permits", findings.at};
}
} // namespace

bool IsCommanded(const Journal& journal, const NodeIndex node, const std::uint8_t srdo, const Nanoseconds at)
{
    CommandEntry last{-1, node, false};
    for (const CommandEntry& command : journal.Commands())
    {
        last = (command.node == node && command.at <= at) ? command : last;
    }
    const auto is_later_opening = [&last, node, srdo, at](const Event& event)
    {
        return event.kind == EventKind::kOutput && event.node == node && event.srdo == srdo && event.value != 0U &&
               event.at >= last.at && event.at <= at;
    };
    return last.closes && std::none_of(journal.Events().begin(), journal.Events().end(), is_later_opening);
}

Detection DetectionAt(const Journal& journal, const NodeIndex node, const Nanoseconds from)
{
    Findings findings;
    for (const Event& event : journal.Events())
    {
        const bool is_here = event.node == node && event.at >= from && IsFinding(event) &&
                             !(FollowsCommands(event) && IsCommanded(journal, node, event.srdo, event.at));
        if (is_here && findings.at >= 0 && event.at > findings.at)
        {
            break;
        }
        if (is_here)
        {
            findings.at = event.at;
            findings.first.try_emplace(event.kind, &event);
        }
    }
    return (findings.at < 0) ? Detection{} : Conclude(findings);
}
} // namespace counterpoint::simulator
