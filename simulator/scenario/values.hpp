// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_SCENARIO_VALUES_HPP
#define SIMULATOR_SCENARIO_VALUES_HPP

#include "runtime/yaml/value.hpp"

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
} // namespace counterpoint::simulator

#endif // SIMULATOR_SCENARIO_VALUES_HPP
