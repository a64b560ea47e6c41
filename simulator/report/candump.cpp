// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/report/reports.hpp"

#include <array>
#include <cstdio>

namespace counterpoint::simulator
{
// (seconds.microseconds) interface identifier#data; remote frames have R instead of data, 29-bit identifiers 8 digits.
std::string CandumpLine(const CanFrame& frame, const Nanoseconds end)
{
    const bool is_extended = frame.kind == FrameKind::kExtended || frame.kind == FrameKind::kExtendedRemote;
    const bool is_remote = frame.kind == FrameKind::kRemote || frame.kind == FrameKind::kExtendedRemote;
    std::array<char, 64U> head{};
    static_cast<void>(std::snprintf(head.data(), head.size(), "(%010lld.%06lld) can0 %0*X#",
                                    static_cast<long long>(end / kNanosecondsPerSecond),
                                    static_cast<long long>(end % kNanosecondsPerSecond / kNanosecondsPerMicrosecond),
                                    is_extended ? 8 : 3, static_cast<unsigned>(frame.identifier)));
    return head.data() + (is_remote ? "R" + std::to_string(frame.length_bytes) : DataText(frame, "")) + "\n";
}

std::string CandumpReport(const Run& run)
{
    std::string text;
    for (const FrameEntry& entry : run.Record().Frames())
    {
        const bool is_seen = entry.fate == host::FrameFate::kComplete && entry.IsOfBus();
        text += is_seen ? CandumpLine(entry.frame, entry.end) : ""; // By anybody on the bus.
    }
    return text;
}
} // namespace counterpoint::simulator
