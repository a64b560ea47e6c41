// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/judge/verdicts.hpp"
#include "simulator/scenario/names.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace counterpoint::simulator
{
namespace
{
/// What was noticed at one instant.
struct Findings
{
    std::vector<const Event*> events;
    Nanoseconds at{-1};

    [[nodiscard]] bool Has(const EventKind kind) const
    {
        return std::any_of(events.begin(), events.end(), [kind](const Event* event) { return event->kind == kind; });
    }
    [[nodiscard]] bool Has(const EventKind kind, const std::uint8_t srdo) const
    {
        return std::any_of(events.begin(), events.end(),
                           [kind, srdo](const Event* event) { return event->kind == kind && event->srdo == srdo; });
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
    case DeviceFault::kOutput:
        return Party::kOutputGate;
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

void AddOnce(std::vector<Detection>& members, const Detection& found)
{
    const auto is_like = [&found](const Detection& other) { return other.IsLike(found); };
    if (std::none_of(members.begin(), members.end(), is_like))
    {
        members.push_back(found);
    }
}

/// The cause that counts, then all that are signalled with it.
void AddCauses(const Findings& findings, const Event& event, std::vector<Detection>& members)
{
    const bool is_a = findings.Has(EventKind::kCauseA, event.srdo);
    const bool is_b = findings.Has(EventKind::kCauseB, event.srdo);
    const Party one = is_a ? Party::kChannelA : Party::kChannelB;
    const Party party = (is_a && is_b) ? Party::kChannels : one;
    AddOnce(members, {party, Name(CauseOf(event)), findings.at, event.srdo});
    for (std::uint32_t cause = 1U; cause < 32U; ++cause)
    {
        const bool is_signalled = ((event.other >> cause) & 1U) != 0U;
        if (is_signalled && static_cast<SrdoCause>(cause) != SrdoCause::kNotOperational)
        {
            AddOnce(members, {party, Name(static_cast<SrdoCause>(cause)), findings.at, event.srdo});
        }
    }
}

/// Every member of what was noticed at one instant: device faults, causes of each SRDO, the watchdog, and outputs that
/// nothing of these closed.
std::vector<Detection> Conclude(const Findings& findings)
{
    std::vector<Detection> members;
    const auto each = [&findings](const EventKind kind, const auto& add)
    {
        for (const Event* const event : findings.events)
        {
            if (event->kind == kind)
            {
                add(*event);
            }
        }
    };
    each(EventKind::kDeviceFault, [&](const Event& event)
         { AddOnce(members, {PartyOf(event), Name(static_cast<DeviceFault>(event.value)), findings.at}); });
    each(EventKind::kCauseA, [&](const Event& event) { AddCauses(findings, event, members); });
    each(EventKind::kCauseB, [&](const Event& event) { AddCauses(findings, event, members); });
    each(EventKind::kWatchdog,
         [&](const Event& /*event*/) { AddOnce(members, {Party::kWatchdog, "wrong_or_no_answer", findings.at}); });
    const bool is_device = findings.Has(EventKind::kDeviceFault) || findings.Has(EventKind::kWatchdog);
    each(EventKind::kOutput,
         [&](const Event& event)
         {
             const bool has_cause =
                 findings.Has(EventKind::kCauseA, event.srdo) || findings.Has(EventKind::kCauseB, event.srdo);
             if (!is_device && !has_cause)
             {
                 AddOnce(members, {Party::kOutputGate, "no_right_permits", findings.at, event.srdo});
             }
         });
    return members;
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

namespace
{
/// The detections at a node, of the first `most` instants at which something was noticed.
std::vector<Detection> DetectionsAt(const Journal& journal, const NodeIndex node, const Nanoseconds from,
                                    const std::size_t most)
{
    std::vector<Detection> detections;
    Findings findings;
    std::size_t instants = 0U;
    const auto conclude = [&detections, &findings, &instants]()
    {
        const std::vector<Detection> members = Conclude(findings);
        detections.insert(detections.end(), members.begin(), members.end());
        instants += members.empty() ? 0U : 1U;
    };
    for (const Event& event : journal.Events())
    {
        const bool is_here = event.node == node && event.at >= from && IsFinding(event) &&
                             !(FollowsCommands(event) && IsCommanded(journal, node, event.srdo, event.at));
        if (is_here && event.at > findings.at)
        {
            conclude();
            findings = Findings{};
            if (instants == most)
            {
                return detections;
            }
        }
        if (is_here)
        {
            findings.at = event.at;
            findings.events.push_back(&event);
        }
    }
    conclude();
    return detections;
}
} // namespace

std::string DetectionText(const Detection& detection)
{
    return std::string(Name(detection.party)) + (detection.cause.empty() ? "" : " (" + detection.cause + ")");
}

Detection DetectionAt(const Journal& journal, const NodeIndex node, const Nanoseconds from)
{
    const std::vector<Detection> first = DetectionsAt(journal, node, from, 1U);
    return first.empty() ? Detection{} : first.front();
}

std::vector<Detection> DetectionsOf(const Journal& journal, const Expectation& expectation, const Nanoseconds from)
{
    constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
    std::vector<Detection> detections = DetectionsAt(journal, expectation.node, from, kAll);
    if (expectation.is_series)
    {
        const std::vector<Detection> others = DetectionsAt(journal, expectation.node + 1U, from, kAll);
        detections.insert(detections.end(), others.begin(), others.end());
    }
    std::stable_sort(detections.begin(), detections.end(),
                     [](const Detection& left, const Detection& right) { return left.at < right.at; });
    return detections;
}
} // namespace counterpoint::simulator
