// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TARGET_CONFORMANCE_SUITE_HPP
#define VERIFICATION_TARGET_CONFORMANCE_SUITE_HPP

#include <cstdint>

namespace counterpoint::target
{

/// @brief Runs all cases with each channel and so many differential sequences with both; 0 if nothing failed.
[[nodiscard]] std::uint32_t RunSuite(std::uint32_t sequences) noexcept;

} // namespace counterpoint::target

#endif
