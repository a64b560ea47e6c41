// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/judge/verdicts.hpp"
#include "simulator/scenario/names.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
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

namespace
{
/// The first `most` detections at a node, one for each instant at which something was noticed.
std::vector<Detection> DetectionsAt(const Journal& journal, const NodeIndex node, const Nanoseconds from,
                                    const std::size_t most)
{
    std::vector<Detection> detections;
    Findings findings;
    const auto conclude = [&detections, &findings]()
    {
        if (findings.at >= 0)
        {
            detections.push_back(Conclude(findings));
        }
    };
    for (const Event& event : journal.Events())
    {
        const bool is_here = event.node == node && event.at >= from && IsFinding(event) &&
                             !(FollowsCommands(event) && IsCommanded(journal, node, event.srdo, event.at));
        if (is_here && event.at > findings.at)
        {
            conclude();
            findings = Findings{};
            if (detections.size() == most)
            {
                return detections;
            }
        }
        if (is_here)
        {
            findings.at = event.at;
            findings.first.try_emplace(event.kind, &event);
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
