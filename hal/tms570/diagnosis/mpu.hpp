// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_DIAGNOSIS_MPU_HPP
#define HAL_TMS570_DIAGNOSIS_MPU_HPP

#include "hal/api/memory_protection.hpp"
#include "hal/tms570/chip/registers.hpp"
#include "hal/tms570/diagnosis/mpu_registers.hpp"

#include <cstdint>

namespace counterpoint::tms570
{

/// A piece of memory: `size_bytes` is a power of two from 32 on, `start` a multiple of it.
struct ProtectedSpan
{
    std::uint32_t start;
    std::uint32_t size_bytes;
};

/// The regions that never change. Later ones have priority, and the regions of Protect over all of them.
struct MpuSetup
{
    ProtectedSpan flash;      ///< Read and executed by everybody, written by nobody.
    ProtectedSpan ram;        ///< Written by privileged code; read by everybody; never executed.
    ProtectedSpan non_safety; ///< Written by everybody: memory and stack of code in user mode. Never executed.
};

/// Memory protection of the processor: code in user mode writes `non_safety` only and reaches no peripheral; regions of
/// Protect are written by their owner, in privileged mode, while it is entered. [SRS_TMS_027, SRS_TMS_028]
class Mpu final : public hal::MemoryProtection
{
  public:
    /// @brief Sets the fixed regions, read back, and turns the unit on.
    [[nodiscard]] Outcome Start(const MpuSetup& setup) noexcept;
    [[nodiscard]] hal::ProtectStatus Protect(const hal::MemoryRegion& region) noexcept override;
    void Enter(hal::MemoryOwner owner) noexcept override;
    /// @brief Once a cycle: that the unit is on, and one region after the other as it was set up.
    [[nodiscard]] Outcome Examine() noexcept;

  private:
    struct Region
    {
        std::uint32_t start;
        std::uint32_t size;
        std::uint32_t access;
        hal::MemoryOwner owner; ///< kInvalid: fixed.
    };

    [[nodiscard]] Outcome Add(const ProtectedSpan& span, std::uint32_t access, hal::MemoryOwner owner) noexcept;
    [[nodiscard]] Outcome Compare(std::uint32_t number) const noexcept;

    Region regions_[mpu::kMostRegions]{}; // MISRA D-001
    std::uint32_t count_{0U};
    std::uint32_t room_{0U};
    std::uint32_t examined_{0U};
};

} // namespace counterpoint::tms570

#endif
