// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_PROGRAM_IMAGE_HPP
#define HAL_HOST_PROGRAM_IMAGE_HPP

#include "hal/api/memory_access.hpp"

#include <vector>

namespace counterpoint::host
{

/// @brief Code and constants of the program itself, without libraries: what it keeps in memory that it may not write,
/// from its program headers, cut to whole words. Tables that the loader fills in are part of it, as they are after
/// loading. [SRS_STS_003]
[[nodiscard]] std::vector<hal::MemorySpan> ReadOnlyImage();

} // namespace counterpoint::host

#endif
