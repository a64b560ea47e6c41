// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_MONITOR_REPORT_HPP
#define CANOPEN_MONITOR_REPORT_HPP

#include "canopen/monitor/analysis.hpp"
#include "canopen/monitor/network.hpp"

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

namespace counterpoint::monitor
{
/// Violations that a report keeps, and frames in words; more are counted.
constexpr std::size_t kMostKept = 100000U;

/// A frame in words.
struct FrameText
{
    Time time;
    std::string text;
};

/// What a live bus did not give to be judged. [SRS_MON_581]
struct Missed
{
    std::uint32_t malformed{0U};   ///< Elements that were no frames.
    std::uint32_t lost_frames{0U}; ///< By this machine.
    std::uint32_t absences{0U};    ///< How often the bus was away; then nothing is judged, so that nothing is missed.
};

/// What all reports are made from.
struct Report
{
    const Network& network;
    const Analysis& analysis;
    const std::vector<Violation>& violations;
    std::string source;                            ///< Name of the file or address of the bus.
    Origin origin{};                               ///< Of a recording.
    const std::vector<FrameText>* frames{nullptr}; ///< For JsonReport; null: nobody asked for them.
    Missed missed{};                               ///< Of a live bus.
};

/// @brief SRDOs, by their numbers among Network::Watches, that had to come and of which no valid pair did: those of
/// which the files have both ends; all where no valid pair of any came. [SRS_MON_240]
[[nodiscard]] std::vector<std::size_t> Silent(const Report& report);
/// @brief Whether frames may be missing among those that were judged.
[[nodiscard]] bool HasMissed(const Report& report);
/// @brief Whether what was asked holds: no violation, no SRDO that is silent, and all was there to be judged.
[[nodiscard]] bool Holds(const Report& report);

/// Whose SRDOs a violation is about: "sensor SRDO 1 -> controller SRDO 1".
[[nodiscard]] std::string Watchers(const Network& network, const Violation& violation);
/// "12.000345 not inverse: sensor SRDO 1 -> controller SRDO 1 (101h, 102h): DETAILS"
[[nodiscard]] std::string ViolationText(const Network& network, const Violation& violation);
/// "30 frames of other interfaces were not judged, the last at 1.476000; judged: 'can0', until 1.101000"; only where
/// there are such frames. [SRS_MON_041]
[[nodiscard]] std::string OthersText(const Report& report);
/// "3 malformed elements and 2 lost frames: what was in them was not judged"; only where HasMissed.
[[nodiscard]] std::string MissedText(const Report& report);
/// Writes the summary: totals, and a block for each SRDO. [SRS_MON_010]
void WriteSummary(const Report& report, std::ostream& out);
/// The whole report as one JSON document. [SRS_MON_241]
[[nodiscard]] std::string JsonReport(const Report& report);
/// A page that needs no other file. [SRS_MON_011]
[[nodiscard]] std::string HtmlReport(const Report& report);
} // namespace counterpoint::monitor

#endif // CANOPEN_MONITOR_REPORT_HPP
