// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_NODE_OUTPUTS_HPP
#define SIMULATOR_WORLD_NODE_OUTPUTS_HPP

#include "runtime/device/model.hpp"
#include "simulator/faults/output_tap.hpp"
#include "simulator/world/node/pairs.hpp"
#include "simulator/world/node/place.hpp"

#include "hal/host/output.hpp"
#include "hal/host/watchdog.hpp"

namespace counterpoint::simulator
{
/// The output stage and the watchdog of a node, and what the world sees of them. [SRS_SIM_032, SRS_SIM_034]
class NodeOutputs
{
  public:
    /// @brief All outlive it.
    NodeOutputs(const NodePlace& place, const runtime::DeviceModel& model, const NodePairs& pairs, PartFaults& faults);

    /// @brief What the kernel is given.
    [[nodiscard]] hal::SafetyOutput& Output() noexcept;
    [[nodiscard]] hal::Watchdog& Supervision() noexcept;
    /// @brief The watchdog starts, with the kernel.
    void Start();
    /// @brief What is open now, and whether the watchdog has tripped.
    void Look(Nanoseconds cycle_time);
    /// @brief Without supply.
    void Close();
    [[nodiscard]] SrdoMask Open() const noexcept
    {
        return open_;
    }
    /// @brief When output or watchdog change by themselves; kNever in a node that is not tapped.
    [[nodiscard]] Nanoseconds LookAt() const noexcept
    {
        return look_at_;
    }
    /// @brief As the kernel of a tapped node gave them last.
    [[nodiscard]] const hal::PermitSet& Permits() const noexcept
    {
        return output_tap_.Permits();
    }

  private:
    void NoteOpen(SrdoMask open);

    const NodePlace& place_;
    const runtime::DeviceModel& model_;
    const NodePairs& pairs_;
    host::HostWatchdog watchdog_;
    host::HostOutput output_;
    OutputTap output_tap_;
    WatchdogTap watchdog_tap_;
    SrdoMask open_{0U};
    Nanoseconds look_at_{kNever};
    bool was_alive_{true};
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_NODE_OUTPUTS_HPP
