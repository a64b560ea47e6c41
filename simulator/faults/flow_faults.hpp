// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_FAULTS_FLOW_FAULTS_HPP
#define SIMULATOR_FAULTS_FLOW_FAULTS_HPP

#include "simulator/faults/part_faults.hpp"

#include "safety_core/kernel/flow_monitor.hpp"

namespace counterpoint::simulator
{
/// A shipped flow monitor, and its faults in front of it. The kernel of a node that is looked into is given it instead
/// of its own one. [SRS_SIM_022]
class FlowFaults final : public FlowWatch
{
  public:
    /// @brief `faults` outlives it.
    explicit FlowFaults(PartFaults& faults) noexcept;

    void Begin() noexcept override;
    void Mark(FlowStep step, const FlowEvidence& evidence) noexcept override;
    [[nodiscard]] hal::WatchdogAnswer End(const hal::WatchdogQuestion& question) noexcept override;
    [[nodiscard]] DeviceFault Finding() const noexcept override;

    /// @brief The flow monitor that is in use.
    [[nodiscard]] FlowMonitor& Monitor() noexcept
    {
        return monitor_;
    }

  private:
    [[nodiscard]] bool Runs() noexcept;

    PartFaults& faults_;
    FlowMonitor monitor_{};
    hal::WatchdogAnswer answer_{};
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_FAULTS_FLOW_FAULTS_HPP
