// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_FLOW_WATCH_HPP
#define SAFETY_CORE_KERNEL_FLOW_WATCH_HPP

#include "hal/api/watchdog.hpp"
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

/// The flow monitor as the kernel sees it: FlowMonitor, or what stands in front of one. [SRS_KRN_039, SRS_KRN_229]
class FlowWatch
{
  public:
    /// @brief Starts a cycle.
    virtual void Begin() noexcept = 0;
    /// @brief A step was done and left this evidence.
    virtual void Mark(FlowStep step, const FlowEvidence& evidence) noexcept = 0;
    /// @brief Ends a cycle: the answer to the watchdog, from the signature alone.
    [[nodiscard]] virtual hal::WatchdogAnswer End(const hal::WatchdogQuestion& question) noexcept = 0;
    /// @brief kNone if the last ended cycle had the signature of a cycle in which all was done in order, else kFlow.
    /// [SRS_FLOW_003]
    [[nodiscard]] virtual DeviceFault Finding() const noexcept = 0;

    FlowWatch(const FlowWatch&) = delete;
    FlowWatch(FlowWatch&&) = delete;
    FlowWatch& operator=(const FlowWatch&) = delete;
    FlowWatch& operator=(FlowWatch&&) = delete;

  protected:
    FlowWatch() noexcept = default;
    ~FlowWatch() noexcept = default;
};

} // namespace counterpoint

#endif
