// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_SELF_TEST_PART_HPP
#define SAFETY_CORE_KERNEL_SELF_TEST_PART_HPP

#include "safety_core/contract/device_fault.hpp"

#include <cstdint>

namespace counterpoint
{

/// Whether the objects that the kernel calls are those it was given.
enum class PartsView : std::uint8_t
{
    kInvalid = 0U, ///< Not looked at, or not as they were: none of them may be called.
    kSound = 0x6CU,
};

/// What the self tests say of one cycle.
struct SelfTestOutcome
{
    std::uint32_t progress; ///< Cycles since their start in which all was done that a cycle has to do. [SRS_STS_062]
    DeviceFault fault;      ///< kNone, or what goes into the latch.
    PartsView parts;
};

/// The self tests as the kernel sees them: safety_core/selftest, or whatever else covers these faults. [SRS_STS_063]
class SelfTestPart
{
  public:
    /// @brief What is to be done in one cycle; called before anything else of it. Bounded time.
    [[nodiscard]] virtual SelfTestOutcome OnCycle() noexcept = 0;

    SelfTestPart(const SelfTestPart&) = delete;
    SelfTestPart(SelfTestPart&&) = delete;
    SelfTestPart& operator=(const SelfTestPart&) = delete;
    SelfTestPart& operator=(SelfTestPart&&) = delete;

  protected:
    SelfTestPart() noexcept = default;
    ~SelfTestPart() noexcept = default;
};

} // namespace counterpoint

#endif
