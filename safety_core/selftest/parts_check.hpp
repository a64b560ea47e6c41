// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_SELFTEST_PARTS_CHECK_HPP
#define SAFETY_CORE_SELFTEST_PARTS_CHECK_HPP

#include "safety_core/selftest/slice.hpp"

#include <cstdint>

namespace counterpoint::selftest
{

constexpr std::uint8_t kMaxParts = 16U;

/// Objects that begin with a pointer to their table of virtual functions; the array outlives the check.
struct PartsSetup
{
    const hal::Address* parts;
    std::uint8_t count; ///< 1 to kMaxParts.
};

/// Compares the first words of polymorphic objects with what they were at the start. Zero-filled, it fails.
/// [SRS_STS_040]
class PartsCheck
{
  public:
    /// @brief Takes the references. O(count)
    void Restart(const PartsSetup& setup, const hal::MemoryAccess& memory) noexcept;
    /// @brief Whether the setup can be used: 1 to kMaxParts parts, all at aligned addresses.
    [[nodiscard]] bool IsUsable() const noexcept;
    /// @brief kPassed while all are as they were. O(count)
    [[nodiscard]] SliceResult Check(const hal::MemoryAccess& memory) noexcept;
    /// @brief Checks done since Restart, modular.
    [[nodiscard]] std::uint32_t Done() const noexcept
    {
        return done_;
    }

  private:
    static constexpr std::uint8_t kPointerWords = sizeof(void*) / hal::kWordBytes;

    PartsSetup setup_{nullptr, 0U};
    std::uint32_t references_[kMaxParts * kPointerWords]{}; // MISRA D-001
    std::uint32_t done_{0U};
};

} // namespace counterpoint::selftest

#endif
