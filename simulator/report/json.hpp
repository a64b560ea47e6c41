// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_REPORT_JSON_HPP
#define SIMULATOR_REPORT_JSON_HPP

#include "simulator/judge/run.hpp"

#include <nlohmann/json.hpp>

namespace counterpoint::simulator
{
/// @brief A run as the document behind --json and the page.
[[nodiscard]] nlohmann::ordered_json RunToJson(const Run& run);
} // namespace counterpoint::simulator

#endif // SIMULATOR_REPORT_JSON_HPP
