// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_FLOW_MONITOR_HPP
#define SAFETY_CORE_KERNEL_FLOW_MONITOR_HPP

#include "hal/api/watchdog.hpp"
#include "safety_core/contract/channel.hpp"
#include "safety_core/contract/device_fault.hpp"

#include <cstdint>

namespace counterpoint
{

/// Steps of a cycle in their order. [SRS_KRN_002]
enum class FlowStep : std::uint8_t
{
    kInvalid = 0U,
    kSelfTest = 1U,
    kClocks = 2U,
    kGuard = 3U,
    kChannelA = 4U,
    kChannelB = 5U,
    kComparison = 6U,
    kDemotion = 7U,
    kProduction = 8U,
    kCommit = 9U,
    kEvents = 10U,
    kPermits = 11U,
};
constexpr std::uint8_t kFlowStepCount = 11U;

/// A value that a step must have produced, with what it must be; their difference enters the signature.
struct FlowEvidence
{
    std::uint32_t observed;
    std::uint32_t expected;
};

/// Folds the steps of one cycle into a signature and answers the watchdog with it. No comparison decides
/// what is answered: a wrong signature gives a wrong answer. [SRS_FLOW_001, SRS_FLOW_002, SRS_FLOW_003]
class FlowMonitor
{
  public:
    /// @brief Starts a cycle.
    void Begin() noexcept;
    /// @brief A step was done and left this evidence.
    void Mark(FlowStep step, const FlowEvidence& evidence) noexcept;
    /// @brief Ends a cycle: the answer to the watchdog, from the signature alone.
    [[nodiscard]] hal::WatchdogAnswer End(const hal::WatchdogQuestion& question) noexcept;
    /// @brief kNone if the last ended cycle had the signature of a cycle in which all was done in order, else kFlow.
    /// [SRS_FLOW_003]
    [[nodiscard]] DeviceFault Finding() const noexcept;

  private:
    std::uint32_t signature_{0U};
    std::uint32_t ended_{0U};
};

} // namespace counterpoint

#endif
