// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_SCENARIO_VALUES_HPP
#define SIMULATOR_SCENARIO_VALUES_HPP

#include "runtime/yaml/value.hpp"

#include <cstddef>
#include <limits>

namespace counterpoint::simulator
{
// Time and the values of files, which stand in every part of a scenario.
using runtime::kNanosecondsPerMicrosecond;
using runtime::kNanosecondsPerMillisecond;
using runtime::kNanosecondsPerSecond;
using runtime::kNever;
using runtime::Nanoseconds;
using runtime::Place;
using runtime::Range;
using runtime::Source;
using runtime::Word;
using runtime::YamlError;
using runtime::YamlValue;

/// A node by its place in Scenario::nodes.
using NodeIndex = std::size_t;
constexpr NodeIndex kNoNode = std::numeric_limits<NodeIndex>::max();
} // namespace counterpoint::simulator

#endif // SIMULATOR_SCENARIO_VALUES_HPP
