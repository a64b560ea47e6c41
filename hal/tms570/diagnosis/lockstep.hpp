// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_DIAGNOSIS_LOCKSTEP_HPP
#define HAL_TMS570_DIAGNOSIS_LOCKSTEP_HPP

#include "hal/tms570/chip/registers.hpp"
#include "hal/tms570/diagnosis/esm_channels.hpp"

#include <cstdint>

/// Comparator of the two processors (CCM). Source: facts/tms570 4; reference manual, chapter "CPU Compare Module"; the
/// CCM of an LC43x compares more than processors (SPNU563A, 13.2), by registers and keys of the same form.
namespace counterpoint::tms570
{

namespace ccm
{

inline constexpr RegisterBase kBase{0xFFFFF600U};
inline constexpr std::uint32_t kMostComparators = 4U;
inline constexpr std::uint32_t kKeyLockstep = 0x0U;
inline constexpr std::uint32_t kKeySelfTest = 0x6U;
inline constexpr std::uint32_t kKeyForceError = 0x9U;
inline constexpr std::uint32_t kKeyForceSelfTestError = 0xFU;
inline constexpr std::uint32_t kSelfTestError = 1U << 0U;
inline constexpr std::uint32_t kSelfTestDone = 1U << 8U;
inline constexpr std::uint32_t kCompareError = 1U << 16U;

/// One comparator: where its registers are, and what says that it found a difference.
struct Comparator
{
    std::uint32_t status;
    std::uint32_t key;
    std::uint32_t esm_2; ///< Channel of group 2.
};

inline constexpr Comparator kComparators[kMostComparators] = {{0x00U, 0x04U, kEsm2Lockstep}, // MISRA D-001
                                                              {0x08U, 0x0CU, kEsm2VimLockstep},
                                                              {0x10U, 0x14U, kEsm2IdleBus},
                                                              {0x1CU, 0x20U, kEsm2PowerDomain}};

} // namespace ccm

/// Lockstep of the two processors and what else the CCM compares; nothing turns it off but the test, and only while it
/// runs. [SRS_TMS_040]
class Lockstep
{
  public:
    /// @brief Self test, error forcing, self-test error forcing; lockstep afterwards. Interrupts are locked and the ESM
    /// is not started, or they would react to the forced errors.
    /// kFailed for no comparator, or more than there can be.
    [[nodiscard]] static Outcome Test(std::uint8_t comparators) noexcept;
    /// @brief Once a cycle: lockstep mode, no compare error.
    [[nodiscard]] static Outcome Examine(std::uint8_t comparators) noexcept;
};

} // namespace counterpoint::tms570

#endif
