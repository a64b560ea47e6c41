// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_LOCKSTEP_HPP
#define HAL_TMS570_LOCKSTEP_HPP

#include "hal/tms570/registers.hpp"

#include <cstdint>

/// Comparator of the two processors (CCM). Source: CPU facts 4.4; reference manual, chapter "CPU Compare Module".
namespace counterpoint::tms570
{

namespace ccm
{

inline constexpr RegisterBase kBase{0xFFFFF600U};
inline constexpr std::uint32_t kStatus = 0x00U;
inline constexpr std::uint32_t kKey = 0x04U;
inline constexpr std::uint32_t kKeyLockstep = 0x0U;
inline constexpr std::uint32_t kKeySelfTest = 0x6U;
inline constexpr std::uint32_t kKeyForceError = 0x9U;
inline constexpr std::uint32_t kKeyForceSelfTestError = 0xFU;
inline constexpr std::uint32_t kSelfTestError = 1U << 0U;
inline constexpr std::uint32_t kSelfTestDone = 1U << 8U;
inline constexpr std::uint32_t kCompareError = 1U << 16U;

} // namespace ccm

/// Lockstep of the two processors; nothing turns it off but the test, and only while it runs. [SRS-TMS-040]
class Lockstep
{
  public:
    /// @brief Self test, error forcing, self-test error forcing; lockstep afterwards. Interrupts are locked and the ESM
    /// is not started, or they would react to the forced errors.
    [[nodiscard]] static Outcome Test() noexcept;
    /// @brief Once a cycle: lockstep mode, no compare error.
    [[nodiscard]] static Outcome Examine() noexcept;
};

} // namespace counterpoint::tms570

#endif
