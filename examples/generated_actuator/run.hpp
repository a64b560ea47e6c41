// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_GENERATED_ACTUATOR_RUN_HPP
#define EXAMPLES_GENERATED_ACTUATOR_RUN_HPP

#include <string>

namespace counterpoint::examples
{

/// @brief What a client reads, then the time line of examples/actuator; the same each time.
[[nodiscard]] std::string RunGeneratedActuator();

} // namespace counterpoint::examples

#endif
