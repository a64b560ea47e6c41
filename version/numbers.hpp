// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERSION_NUMBERS_HPP
#define VERSION_NUMBERS_HPP

#include <cstdint>

namespace counterpoint
{

/// Version of the headers that a program was compiled with, that of project(Counterpoint VERSION ...): where they
/// differ the build stops. While kVersionMajor is 0, kVersionMinor counts changes that break a program, a file or an
/// output, and kVersionPatch all others. Static libraries of another kVersionMinor do not fit. [SRS_CLI_024]
constexpr std::uint32_t kVersionMajor = 0U;
constexpr std::uint32_t kVersionMinor = 1U;
constexpr std::uint32_t kVersionPatch = 0U;

} // namespace counterpoint

#endif
