// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_HAL_HOST_ALLOCATIONS_HPP
#define TESTS_HAL_HOST_ALLOCATIONS_HPP

#include <cstdint>

namespace counterpoint::host
{

/// @brief Calls of operator new in this program so far.
[[nodiscard]] std::uint64_t Allocations();

} // namespace counterpoint::host

#endif
