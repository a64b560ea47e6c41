// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TARGET_GTEST_MEMORY_HPP
#define VERIFICATION_TARGET_GTEST_MEMORY_HPP

#include <cstddef>

namespace counterpoint::target
{

/// @brief What a test took since the mark is given back as a whole. A host has memory enough: nothing happens.
[[nodiscard]] std::size_t MarkMemory() noexcept;
/// @brief Who is told of when there is no memory left.
void NameMemoryUser(const char* suite, const char* name) noexcept;
void ReleaseMemory(std::size_t mark) noexcept;

} // namespace counterpoint::target

#endif
