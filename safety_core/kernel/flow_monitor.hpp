// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_FLOW_MONITOR_HPP
#define SAFETY_CORE_KERNEL_FLOW_MONITOR_HPP

#include "safety_core/kernel/flow_watch.hpp"

#include <cstdint>

namespace counterpoint
{

/// Folds the steps of one cycle into a signature and answers the watchdog with it. No comparison decides
/// what is answered: a wrong signature gives a wrong answer. [SRS_FLOW_001, SRS_FLOW_002, SRS_FLOW_003]
class FlowMonitor final : public FlowWatch
{
  public:
    void Begin() noexcept override;
    void Mark(FlowStep step, const FlowEvidence& evidence) noexcept override;
    [[nodiscard]] hal::WatchdogAnswer End(const hal::WatchdogQuestion& question) noexcept override;
    [[nodiscard]] DeviceFault Finding() const noexcept override;

  private:
    std::uint32_t signature_{0U};
    std::uint32_t ended_{0U};
};

} // namespace counterpoint

#endif
