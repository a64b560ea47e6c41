// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_NETWORKS_DEVICE_HPP
#define SIMULATOR_NETWORKS_DEVICE_HPP

#include "runtime/node/device.hpp"
#include "simulator/networks/bus.hpp"
#include "simulator/scenario/scenario.hpp"

#include <cstdint>
#include <deque>
#include <ostream>
#include <streambuf>

namespace counterpoint::simulator
{
/// Where nobody reads.
class NowhereBuffer final : public std::streambuf
{
  private:
    int_type overflow(const int_type character) override
    {
        return character;
    }
};

/// A device of a DCF on a simulated bus: the same that `counterpoint node` runs. It exists while it has supply.
class SimulatedDevice
{
  public:
    /// @brief Supply on at `now_ns`. Throws cia306::InputError.
    SimulatedDevice(NodeIndex node, const NodeSetup& setup, SimulatedBus& bus, std::uint64_t now_ns);

    /// @brief The next instant at which it does something by itself.
    [[nodiscard]] std::uint64_t NextNs() const noexcept
    {
        return next_cycle_ns_;
    }
    [[nodiscard]] bool HasFrames() const noexcept;
    /// @brief Takes what the bus has, and runs the cycle that is due.
    void Run(std::uint64_t now_ns);
    [[nodiscard]] runtime::NodeDevice& Device() noexcept
    {
        return device_;
    }
    [[nodiscard]] NodeIndex Node() const noexcept
    {
        return node_;
    }
    void Acknowledge(std::uint8_t srdo, std::uint64_t now_ns);
    /// @brief Somebody writes into it, by no message of the bus.
    void Store(const ObjectAddress& object, std::uint32_t value);

  private:
    [[nodiscard]] InstantPair Now(std::uint64_t now_ns) const noexcept;
    void Take(std::uint64_t now_ns);
    void SetSerial();

    NodeIndex node_;
    NodeSetup setup_;
    SimulatedPort* safety_;
    SimulatedPort* services_;
    runtime::NodePorts ports_;
    NowhereBuffer nowhere_;
    std::ostream out_;
    runtime::NodeReport report_;
    runtime::NodeDevice device_;
    std::uint64_t start_ns_;
    std::uint64_t cycle_ns_;
    std::uint64_t next_cycle_ns_;
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_NETWORKS_DEVICE_HPP
