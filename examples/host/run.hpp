// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_HOST_RUN_HPP
#define EXAMPLES_HOST_RUN_HPP

#include <string>

namespace counterpoint::examples
{

/// @brief Each runs its device for a second of simulated time and gives the time line; the same each time.
[[nodiscard]] std::string RunSensor();
[[nodiscard]] std::string RunActuator();
[[nodiscard]] std::string RunController();

} // namespace counterpoint::examples

#endif
