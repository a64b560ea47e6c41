// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/outcome.hpp"

#include "runtime/device/names.hpp"
#include "verification/campaign/judge.hpp"

#include <array>

namespace counterpoint::campaign
{
namespace
{
constexpr std::array<const char*, kClassCount> kClassWords{"open",       "masked", "benign", "detected",
                                                           "safe_other", "silent", "listed", "exposed"};
constexpr std::array<const char*, kDetectorCount> kDetectorWords{
    "nobody",   "comparator", "flow_monitor", "guard",     "seal",      "clocks", "channels", "permits",
    "watchdog", "latch",      "pair_check",   "receivers", "exception", "time",   "self_test"};
constexpr std::array<const char*, 6U> kWrongWords{"",
                                                  "open with data that the bus did not bring",
                                                  "open without leave",
                                                  "open again without an acknowledge, or behind a device fault",
                                                  "frame under a foreign identifier",
                                                  "valid pair sent with data that nobody wrote"};
} // namespace

const char* WordOf(const Class result)
{
    return kClassWords.at(static_cast<std::size_t>(result));
}

const char* WordOf(const Detector detector)
{
    return kDetectorWords.at(static_cast<std::size_t>(detector));
}

const char* ReasonOf(const Outcome& outcome)
{
    if (outcome.result == Class::kSilent)
    {
        return kWrongWords.at(outcome.detail);
    }
    if (outcome.result == Class::kListed)
    {
        return "open by a complete valid pair that nobody sent, or that is too old";
    }
    if (outcome.detector == Detector::kChannels)
    {
        return runtime::NameOf(runtime::kCauseWords, static_cast<SrdoCause>(outcome.detail), "?");
    }
    const bool is_of_device = outcome.detector != Detector::kNobody && outcome.result == Class::kDetected &&
                              outcome.detector != Detector::kPermits && outcome.detector != Detector::kWatchdog;
    return is_of_device ? runtime::NameOf(runtime::kDeviceFaultWords, static_cast<DeviceFault>(outcome.detail), "?")
                        : "";
}
} // namespace counterpoint::campaign
