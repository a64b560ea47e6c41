// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_REPORT_REPORTS_HPP
#define SIMULATOR_REPORT_REPORTS_HPP

#include "simulator/judge/run.hpp"

#include <iosfwd>
#include <string>
#include <vector>

namespace counterpoint::simulator
{
/// Which frames a time line shows.
enum class FrameLines
{
    kCounted, ///< Undisturbed frames are counted, not shown.
    kAll,
};

/// @brief Writes what happened, line by line, then the verdicts. [SRS_SIM_040]
void WriteTimeLine(const Run& run, FrameLines frames, std::ostream& out);
/// @brief Writes a line for each expectation, and one for all of them.
void WriteVerdicts(const Run& run, std::ostream& out);
/// @brief Recording, measurements and verdicts as one JSON document. [SRS_SIM_041]
[[nodiscard]] std::string JsonReport(const Run& run);
/// @brief One frame as candump -l writes it, with its line end. [SRS_SIM_042]
[[nodiscard]] std::string CandumpLine(const CanFrame& frame, Nanoseconds end);
/// @brief The frames of the bus as candump -l writes them. [SRS_SIM_042]
[[nodiscard]] std::string CandumpReport(const Run& run);
/// @brief A page with the timing diagrams of all runs; needs no network. [SRS_SIM_043, SRS_DEMO_003]
[[nodiscard]] std::string HtmlReport(const std::string& title, const std::vector<const Run*>& runs);

/// @brief An event in words, without its time and place.
[[nodiscard]] std::string EventText(const Run& run, const Event& event);
/// @brief Identifier and data of a frame: "0x103  01 01".
[[nodiscard]] std::string FrameText(const CanFrame& frame);
/// @brief The data of a frame, two digits each, with `separator` between them.
[[nodiscard]] std::string DataText(const CanFrame& frame, const char* separator);
/// @brief The numbers of the SRDOs whose slots are in `mask`: "1, 2"; "none" for an empty mask.
[[nodiscard]] std::string SlotsText(const Run& run, NodeIndex node, SrdoMask mask);
} // namespace counterpoint::simulator

#endif // SIMULATOR_REPORT_REPORTS_HPP
