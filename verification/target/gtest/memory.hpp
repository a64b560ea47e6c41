// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TARGET_GTEST_MEMORY_HPP
#define VERIFICATION_TARGET_GTEST_MEMORY_HPP

#include <cstddef>

namespace counterpoint::target
{

/// @brief What a test took since the mark is given back as a whole. A host has memory enough: nothing happens.
[[nodiscard]] std::size_t MarkMemory() noexcept;
void ReleaseMemory(std::size_t mark) noexcept;

} // namespace counterpoint::target

#endif
