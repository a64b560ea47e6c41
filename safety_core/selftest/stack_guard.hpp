// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_SELFTEST_STACK_GUARD_HPP
#define SAFETY_CORE_SELFTEST_STACK_GUARD_HPP

#include "safety_core/selftest/slice.hpp"

#include <cstdint>

namespace counterpoint::selftest
{

/// A stack that grows towards lower addresses. `guard_words` at its low end are never used; `area` begins with them.
struct StackSetup
{
    hal::MemorySpan area;
    std::uint8_t guard_words;
};

/// Guard words at the far end of a stack, and the mark of how far it was ever used. Zero-filled, it fails.
/// [SRS_STS_020]
class StackGuard
{
  public:
    /// @brief Writes guard and fill pattern into every word of the area that is further than the reach from the running
    /// stack position. O(words)
    void Restart(const StackSetup& setup, hal::MemoryAccess& memory) noexcept;
    /// @brief Whether the setup can be used: an aligned area with at least one guard word and more.
    [[nodiscard]] bool IsUsable() const noexcept;
    /// @brief kPassed while every guard word is as written. O(guard_words)
    [[nodiscard]] SliceResult Check(const hal::MemoryAccess& memory) noexcept;
    /// @brief Most bytes of the area ever in use since Restart. O(words)
    [[nodiscard]] std::uint32_t HighWaterBytes(const hal::MemoryAccess& memory) const noexcept;
    /// @brief Checks done since Restart, modular.
    [[nodiscard]] std::uint32_t Done() const noexcept
    {
        return done_;
    }

  private:
    StackSetup setup_{{0U, 0U}, 0U};
    std::uint32_t done_{0U};
};

} // namespace counterpoint::selftest

#endif
