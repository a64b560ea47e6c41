// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NODE_OUTPUT_WATCH_HPP
#define RUNTIME_NODE_OUTPUT_WATCH_HPP

#include "runtime/console/node_report.hpp"
#include "runtime/node/latency.hpp"

#include "hal/host/live/bus.hpp"
#include "hal/host/output.hpp"
#include "runtime/device/model.hpp"
#include "safety_core/kernel/kernel.hpp"

#include <array>
#include <cstdint>

namespace counterpoint::runtime
{
/// Writes a line when an output of a live node opens or closes, and measures the time from the reception of a pair to
/// its open output. [SRS_NODE_004, SRS_NODE_008]
class OutputWatch
{
  public:
    /// All outlive it.
    OutputWatch(const DeviceModel& model, host::HostOutput& output, NodeReport& report);

    /// @brief Takes which frame completes the pair of which consumer, as the SRDOs are configured now. Call it on
    /// entering OPERATIONAL.
    void Follow(Kernel& kernel);
    /// @brief A frame of the bus, with its stamp.
    void OnFrame(const host::LiveFrame& frame);
    /// @brief A pair of this SRDO was released or confirmed.
    void OnPair(std::uint8_t srdo);
    /// @brief A cycle begins: pairs from now on are new.
    void BeginCycle() noexcept
    {
        paired_ = 0U;
    }
    /// @brief Looks at the outputs at `now_ns`. Outputs that closed by themselves did so at `closed_ns`, if that is
    /// earlier.
    void Look(std::uint64_t closed_ns, std::uint64_t now_ns);

    /// @brief The slots that were open at the last Look.
    [[nodiscard]] SrdoMask Open() const noexcept
    {
        return open_;
    }
    /// @brief The measured times.
    [[nodiscard]] const NodeLatency& Latency() const noexcept
    {
        return latency_;
    }

  private:
    const DeviceModel& model_;
    host::HostOutput& output_;
    NodeReport& report_;
    NodeLatency latency_;
    std::array<std::uint64_t, kMaxSrdoCount> received_ns_{}; ///< Last inverse frame, by slot.
    std::array<SlotIndex, kSrdoIdentifierCount> slot_of_{};  ///< By identifier of the inverse frame.
    SrdoMask paired_{0U};                                    ///< Slots with a new pair in this cycle.
    SrdoMask open_{0U};
};
} // namespace counterpoint::runtime

#endif // RUNTIME_NODE_OUTPUT_WATCH_HPP
