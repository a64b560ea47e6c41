// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_NODE_CONTROLLERS_HPP
#define SIMULATOR_WORLD_NODE_CONTROLLERS_HPP

#include "simulator/world/node/processor.hpp"

#include "canopen/device/device.hpp"
#include "hal/host/can_ports.hpp"
#include "hal/host/frame_queue.hpp"
#include "hal/host/virtual/bus.hpp"
#include "runtime/device/model.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace counterpoint::simulator
{
/// The CAN controllers of a node. They give frames to whoever runs the device at once, as an interrupt does; or keep
/// them until it asks for them, while the node polls. [SRS_SIM_027]
class NodeControllers final : private host::FrameSink
{
  public:
    /// @brief One controller, or two that hear each other on the one bus, with mailboxes for all SRDOs of the model.
    /// All others given outlive it.
    NodeControllers(const NodePlace& place, const NodeProcessor& processor, host::HostClocks& counters,
                    const runtime::DeviceModel& model, host::FrameSink& device);

    [[nodiscard]] hal::CanPorts& Ports() noexcept
    {
        return can_;
    }
    /// @brief Its nodes of the bus, the first controller first.
    [[nodiscard]] const std::vector<host::NodeIndex>& BusNodes() const noexcept
    {
        return bus_nodes_;
    }
    void PowerOn();
    /// @brief The frames that wait are lost.
    void PowerOff();
    /// @brief The device begins anew and does not poll yet.
    void Restart();
    /// @brief From now on frames wait in a queue of this capacity for the next cycle; 0: as before.
    void Poll(std::size_t capacity, std::size_t fault);
    /// @brief Gives what waits.
    void Drain();
    [[nodiscard]] device::BusCondition Condition() const;

  private:
    void OnFrame(const StampedFrame& frame) override;
    void OnConfirm(const StampedFrame& frame) override;
    void OnOverflow() override;

    const NodePlace& place_;
    const NodeProcessor& processor_;
    host::FrameSink& device_;
    host::HostCanPorts can_;
    std::vector<host::NodeIndex> bus_nodes_;
    std::unique_ptr<host::FrameQueue> queue_; ///< Null: nothing waits.
    std::size_t capacity_{0U};
    std::size_t fault_{kNoFaultIndex}; ///< Whose effect a full queue is.
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_NODE_CONTROLLERS_HPP
