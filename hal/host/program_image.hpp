// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_PROGRAM_IMAGE_HPP
#define HAL_HOST_PROGRAM_IMAGE_HPP

#include "hal/api/memory_access.hpp"

#include <vector>

namespace counterpoint::host
{

/// @brief What the program itself (no library) keeps in memory that it may not write: code and constants, from its
/// program headers, cut to whole words. Tables that the loader fills in are among them from then on, as they stand.
/// [SRS_STS_003]
[[nodiscard]] std::vector<hal::MemorySpan> ReadOnlyImage();

} // namespace counterpoint::host

#endif
