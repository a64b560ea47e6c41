// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_API_MEMORY_ACCESS_HPP
#define HAL_API_MEMORY_ACCESS_HPP

#include <cstdint>

namespace counterpoint::hal
{

/// Place of a 32-bit word in the memory of this processor; a multiple of kWordBytes.
using Address = std::uintptr_t;
constexpr std::uint32_t kWordBytes = 4U;

/// Neighbouring words, from the lowest address on.
struct MemorySpan
{
    Address first;
    std::uint32_t words;
};

/// The memory as the self tests see it. On a target each call is one access or two to the cell itself, never to a copy
/// that a compiler keeps; on a host the same tests run over cells with simulated defects. [SRS_STS_010]
class MemoryAccess
{
  public:
    /// @brief Reads one word.
    [[nodiscard]] virtual std::uint32_t Read(Address place) const noexcept = 0;
    /// @brief Writes one word.
    virtual void Write(Address place, std::uint32_t value) noexcept = 0;
    /// @brief Reads a word, then writes it: one call for both accesses of a march element. Returns what was read.
    [[nodiscard]] virtual std::uint32_t Exchange(Address place, std::uint32_t value) noexcept = 0;
    /// @brief Where the stack is in use at this moment, to the accuracy of a few calls. [SRS_STS_013]
    [[nodiscard]] virtual Address StackPosition() const noexcept = 0;
    /// @brief Where an object begins.
    [[nodiscard]] virtual Address PlaceOf(const void* object) const noexcept = 0;

    MemoryAccess(const MemoryAccess&) = delete;
    MemoryAccess(MemoryAccess&&) = delete;
    MemoryAccess& operator=(const MemoryAccess&) = delete;
    MemoryAccess& operator=(MemoryAccess&&) = delete;

  protected:
    MemoryAccess() noexcept = default;
    ~MemoryAccess() noexcept = default;
};

} // namespace counterpoint::hal

#endif
