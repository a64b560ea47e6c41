// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/outcome.hpp"

#include "runtime/device/names.hpp"
#include "verification/campaign/judge.hpp"

#include <array>
#include <cstdio>

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
} // namespace

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
    const bool is_of_device = outcome.detector != Detector::kNobody && outcome.result == Class::kDetected &&
                              outcome.detector != Detector::kPermits && outcome.detector != Detector::kWatchdog &&
                              outcome.detector != Detector::kPins;
    return is_of_device ? runtime::NameOf(runtime::kDeviceFaultWords, static_cast<DeviceFault>(outcome.detail), "?")
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
