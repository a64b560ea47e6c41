// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_API_MEMORY_PROTECTION_HPP
#define HAL_API_MEMORY_PROTECTION_HPP

#include <cstdint>

namespace counterpoint::hal
{

/// Who may write a region while others run.
enum class MemoryOwner : std::uint8_t
{
    kInvalid = 0U,
    kChannelA = 1U,
    kChannelB = 2U,
    kKernel = 3U,
};

/// A region of memory and the party that may write it.
struct MemoryRegion
{
    const void* start;
    std::uint32_t size_bytes; ///< A power of two, `start` aligned to it, where the MPU wants that.
    MemoryOwner owner;
};

/// Whether a region is protected.
enum class ProtectStatus : std::uint8_t
{
    kInvalid = 0U,
    kProtected = 0x69U,
    kRefused = 1U, ///< Not a region this MPU can protect.
    kAbsent = 2U,  ///< No MPU here.
};

/// Keeps one party from writing another party's memory. [SRS_HAL_006]
class MemoryProtection
{
  public:
    /// @brief From now on only `region.owner` may write the region.
    [[nodiscard]] virtual ProtectStatus Protect(const MemoryRegion& region) noexcept = 0;
    /// @brief From now on this party runs.
    virtual void Enter(MemoryOwner owner) noexcept = 0;

    MemoryProtection(const MemoryProtection&) = delete;
    MemoryProtection(MemoryProtection&&) = delete;
    MemoryProtection& operator=(const MemoryProtection&) = delete;
    MemoryProtection& operator=(MemoryProtection&&) = delete;

  protected:
    MemoryProtection() noexcept = default;
    ~MemoryProtection() noexcept = default;
};

} // namespace counterpoint::hal

#endif
