// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TARGET_COVERAGE_PROFILE_HPP
#define VERIFICATION_TARGET_COVERAGE_PROFILE_HPP

namespace counterpoint::target
{

/// @brief Writes the counters of an instrumented program in the raw format of LLVM 19 to a file of the host. On a host
/// the compiler's own library does it at the end of the program, and this does nothing.
[[nodiscard]] bool WriteProfile(const char* path) noexcept;

} // namespace counterpoint::target

#endif
