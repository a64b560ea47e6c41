// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_WORLD_HPP
#define SIMULATOR_WORLD_WORLD_HPP

#include "simulator/journal/journal.hpp"
#include "simulator/scenario/scenario.hpp"
#include "simulator/world/link_wire.hpp"
#include "simulator/world/node/node.hpp"

#include "hal/host/virtual/bus.hpp"

#include <map>
#include <memory>
#include <vector>

namespace counterpoint::simulator
{
/// Bus, devices and journal of a network, for the classes that make something happen in it. Owned by the network.
struct World
{
    const Scenario& scenario;
    Journal& journal;
    host::VirtualBus bus;
    BusPlaces places;
    std::vector<std::unique_ptr<runtime::DeviceModel>> models;
    std::vector<std::unique_ptr<Node>> nodes;             ///< Of the scenario; then those that events duplicate.
    std::map<NodeIndex, std::unique_ptr<LinkWire>> wires; ///< By the index of CPU A.

    /// @brief The present time.
    [[nodiscard]] Nanoseconds Now() const noexcept
    {
        return bus.Now();
    }
    /// @brief The device, which comes now if this is its very instant.
    [[nodiscard]] Node& Present(const NodeIndex index)
    {
        Node& node = *nodes[index];
        if (node.NextEvent() <= Now() && node.State() == cia301::NodeState::kInvalid)
        {
            node.Run();
        }
        return node;
    }
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_WORLD_HPP
