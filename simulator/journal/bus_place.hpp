// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_JOURNAL_BUS_PLACE_HPP
#define SIMULATOR_JOURNAL_BUS_PLACE_HPP

#include "simulator/scenario/scenario.hpp"

#include "hal/host/virtual/bus_fault.hpp"

#include <cstddef>
#include <vector>

namespace counterpoint::simulator
{
constexpr std::size_t kNoFaultIndex = static_cast<std::size_t>(-1);

/// Whose controller a node of the bus is: the first or second one of a device, or the one of a fault.
struct BusPlace
{
    NodeIndex node{kNoNode};
    std::uint32_t controller{1U};
    std::size_t fault{kNoFaultIndex}; ///< A controller that is no node's.
};
/// By the numbers of the nodes on the bus.
using BusPlaces = std::vector<BusPlace>;
} // namespace counterpoint::simulator

#endif // SIMULATOR_JOURNAL_BUS_PLACE_HPP
