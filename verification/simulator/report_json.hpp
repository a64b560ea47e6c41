// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_SIMULATOR_REPORT_JSON_HPP
#define VERIFICATION_SIMULATOR_REPORT_JSON_HPP

#include "verification/simulator/run.hpp"

#include <nlohmann/json.hpp>

namespace counterpoint::simulator
{
/// @brief The document behind --json and behind the page.
[[nodiscard]] nlohmann::ordered_json RunToJson(const Run& run);
} // namespace counterpoint::simulator

#endif // VERIFICATION_SIMULATOR_REPORT_JSON_HPP
