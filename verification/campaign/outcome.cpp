// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/outcome.hpp"

#include "runtime/device/names.hpp"
#include "verification/campaign/judge.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>

namespace counterpoint::campaign
{
namespace
{
constexpr std::array<const char*, kClassCount> kClassWords{"open",       "masked", "benign", "detected",
                                                           "safe_other", "silent", "listed", "exposed"};
constexpr std::array<const char*, kDetectorCount> kDetectorWords{
    "nobody", "comparator", "flow_monitor", "guard",     "seal", "clocks", "channels",  "permits",   "watchdog",
    "latch",  "pair_check", "receivers",    "exception", "time", "pins",   "self_test", "cross_link"};
constexpr std::array<const char*, 7U> kWrongWords{"",
                                                  "open with data that the bus did not bring",
                                                  "open without leave",
                                                  "open again without an acknowledge, or behind a device fault",
                                                  "frame under a foreign identifier",
                                                  "valid pair sent with data that nobody wrote",
                                                  "valid pair sent with old data"};
constexpr std::uint8_t kMarks = kMarkLate | kMarkSaidByA | kMarkSaidByB | kMarkLatent;
constexpr std::uint8_t kMarksOfExposed = kMarks | kMarkOldPair; // [SRS_CMG_820]

/// Detectors whose detail is a device fault.
bool IsOfDevice(const Outcome& outcome)
{
    return outcome.detector != Detector::kNobody && outcome.result == Class::kDetected &&
           outcome.detector != Detector::kPermits && outcome.detector != Detector::kWatchdog &&
           outcome.detector != Detector::kPins;
}

/// Whether a table of words has the value of a detail.
template <typename Words> bool IsAmong(const Words& words, const std::uint8_t detail)
{
    return std::any_of(std::begin(words), std::end(words),
                       [detail](const auto& each) { return static_cast<std::uint8_t>(each.meaning) == detail; });
}

Strange StrangeReason(const Outcome& outcome)
{
    const std::string reason = "reason " + std::to_string(outcome.detail);
    if (outcome.result == Class::kSilent)
    {
        return StrangeNumber("reason", outcome.detail, kWrongWords.size());
    }
    if (outcome.result == Class::kListed || outcome.result == Class::kExposed)
    {
        return {};
    }
    if (outcome.detector == Detector::kChannels)
    {
        return IsAmong(runtime::kCauseWords, outcome.detail) ? Strange{} : Strange{reason, "a cause of an SRDO"};
    }
    const bool is_known = !IsOfDevice(outcome) || IsAmong(runtime::kDeviceFaultWords, outcome.detail);
    return is_known ? Strange{} : Strange{reason, "a device fault"};
}
} // namespace

Strange StrangeNumber(const char* const what, const std::size_t number, const std::size_t count)
{
    return (number < count)
               ? Strange{}
               : Strange{std::string(what) + " " + std::to_string(number), "0 to " + std::to_string(count - 1U)};
}

Strange StrangeIn(const Outcome& outcome)
{
    const auto detector = static_cast<std::size_t>(outcome.detector);
    const bool has_any = detector != 0U || outcome.detail != 0U || outcome.marks != 0U || outcome.us != 0U;
    if (outcome.result == Class::kOpen && has_any)
    {
        return {"a fault that was not tried and has an outcome", "none"};
    }
    if (detector >= kDetectorCount)
    {
        return StrangeNumber("detector", detector, kDetectorCount);
    }
    const bool is_exposed = outcome.result == Class::kExposed;
    const std::uint8_t marks = is_exposed ? kMarksOfExposed : kMarks;
    return ((outcome.marks & ~marks) != 0) ? Strange{"marks " + std::to_string(outcome.marks),
                                                     is_exposed ? "bits 0 to 4 alone" : "bits 0 to 3 alone"}
                                           : StrangeReason(outcome);
}

Detector DetectorOf(const DeviceFault fault)
{
    switch (fault)
    {
    case DeviceFault::kDisagreement:
    case DeviceFault::kUnmatched:
    case DeviceFault::kComparator:
        return Detector::kComparator;
    case DeviceFault::kGuard:
    case DeviceFault::kConfiguration:
        return Detector::kGuard;
    case DeviceFault::kFlow:
        return Detector::kFlowMonitor;
    case DeviceFault::kClock:
    case DeviceFault::kLateCall:
    case DeviceFault::kFrameOrder:
        return Detector::kClocks;
    case DeviceFault::kSelfTest:
        return Detector::kSeal;
    case DeviceFault::kCrossLink:
        return Detector::kCrossLink;
    case DeviceFault::kOutput:
        return Detector::kPermits;
    case DeviceFault::kInvalid:
    case DeviceFault::kApplication:
    case DeviceFault::kHandshake:
    case DeviceFault::kNone:
        break;
    }
    return Detector::kLatch;
}

bool IsOfTest(const Outcome& found, const std::string& member)
{
    const bool is_itself = member.find("comparator.self_test") != std::string::npos;
    return found.detector == Detector::kGuard || found.detector == Detector::kSelfTest ||
           (found.detector == Detector::kComparator && !is_itself &&
            found.detail == static_cast<std::uint8_t>(DeviceFault::kComparator));
}

const char* WordOf(const Class result)
{
    return kClassWords.at(static_cast<std::size_t>(result));
}

const char* WordOf(const Detector detector)
{
    return kDetectorWords.at(static_cast<std::size_t>(detector));
}

std::string ReasonOf(const Outcome& outcome)
{
    if (outcome.result == Class::kSilent)
    {
        return kWrongWords.at(outcome.detail);
    }
    if (outcome.result == Class::kListed)
    {
        return "open by a complete valid pair that nobody sent, or that is too old";
    }
    if (outcome.result == Class::kExposed)
    {
        const bool is_old = (outcome.marks & kMarkOldPair) != 0U;
        return (is_old ? "valid pairs sent with old data until the " : "open with wrong data until the ") +
               runtime::Words(WordOf(outcome.detector)) + " found it";
    }
    if (outcome.detector == Detector::kChannels)
    {
        return runtime::NameOf(runtime::kCauseWords, static_cast<SrdoCause>(outcome.detail), "?");
    }
    return IsOfDevice(outcome)
               ? runtime::NameOf(runtime::kDeviceFaultWords, static_cast<DeviceFault>(outcome.detail), "?")
               : "";
}

std::string MsText(const std::uint32_t us)
{
    constexpr double kThousand = 1000.0;
    char text[32] = {};
    std::snprintf(text, sizeof(text), "%.3f", us / kThousand);
    return text;
}

std::string OutcomeText(const Outcome& outcome)
{
    const std::string reason = ReasonOf(outcome);
    std::string text = std::string("outcome: ") + WordOf(outcome.result);
    text += (outcome.detector == Detector::kNobody) ? "" : std::string(", by ") + WordOf(outcome.detector);
    text += reason.empty() ? "" : ", " + reason;
    const bool has_time = IsEffective(outcome.result);
    return text + (has_time ? ", after " + MsText(outcome.us) + " ms" : "") + (IsLate(outcome) ? ", late" : "");
}
} // namespace counterpoint::campaign
