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
    static_cast<void>(std::snprintf(head.data(), head.size(), "(%010lld.%06lld) can0 ",
                                    static_cast<long long>(end / kNanosecondsPerSecond),
                                    static_cast<long long>(end % kNanosecondsPerSecond / kNanosecondsPerMicrosecond)));
    std::array<char, 16U> identifier{};
    const auto number = static_cast<unsigned>(frame.identifier);
    static_cast<void>(is_extended ? std::snprintf(identifier.data(), identifier.size(), "%08X#", number)
                                  : std::snprintf(identifier.data(), identifier.size(), "%03X#", number));
    std::string line = head.data();
    line += identifier.data();
    line += is_remote ? "R" + std::to_string(frame.length_bytes) : DataText(frame, "");
    line += "\n";
    return line;
}

std::string CandumpReport(const Run& run)
{
    std::string text;
    for (const FrameEntry& entry : run.Record().Frames())
    {
        if (entry.fate != host::FrameFate::kComplete || entry.sender == kNoNode)
        {
            continue; // Nobody on the bus has seen it.
        }
        text += CandumpLine(entry.frame, entry.end);
    }
    return text;
}
} // namespace counterpoint::simulator
