// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_PORT_SKELETON_START_UP_HPP
#define EXAMPLES_PORT_SKELETON_START_UP_HPP

#include "parts.hpp"

namespace port_skeleton
{

/// @brief CONTRACT. From reset to here: stacks of all modes; RAM tested and with a right ECC before its first use; data
/// and zero sections, `.noinit` kept over a warm reset; clocks, and what of them is checked; pins low before anything
/// else that takes time; every wait with a bound whose end is a fault. kThere once all of that is done and shown.
[[nodiscard]] PartState StateOfStartUp() noexcept;

} // namespace port_skeleton

#endif
