// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_REPORT_PAGE_PARTS_HPP
#define SIMULATOR_REPORT_PAGE_PARTS_HPP

#include "simulator/judge/run.hpp"

#include <nlohmann/json.hpp>

namespace counterpoint::simulator
{
/// @brief A run as the document behind --json and the page.
[[nodiscard]] nlohmann::ordered_json RunToJson(const Run& run);
// The files of page/, built in by CMake.
extern const char* const kPageHtml;
extern const char* const kPageCss;
extern const char* const kPageJs;
} // namespace counterpoint::simulator

#endif // SIMULATOR_REPORT_PAGE_PARTS_HPP
