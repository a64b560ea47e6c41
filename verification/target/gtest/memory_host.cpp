// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/target/gtest/memory.hpp"

namespace counterpoint::target
{

std::size_t MarkMemory() noexcept
{
    return 0U;
}

void NameMemoryUser(const char* /*suite*/, const char* /*name*/) noexcept
{
}

void ReleaseMemory(const std::size_t /*mark*/) noexcept
{
}

} // namespace counterpoint::target
