// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_NODE_INSIDE_HPP
#define SIMULATOR_WORLD_NODE_INSIDE_HPP

#include "simulator/world/node/application.hpp"
#include "simulator/world/node/channels.hpp"
#include "simulator/world/node/clock.hpp"
#include "simulator/world/node/outputs.hpp"
#include "simulator/world/node/pairs.hpp"
#include "simulator/world/node/place.hpp"
#include "simulator/world/node/processor.hpp"
#include "simulator/world/node/self_test.hpp"

namespace counterpoint::simulator
{
/// What a node consists of, for those of its parts that join others. All of it outlives them.
struct NodeInside
{
    const NodePlace& place;
    const NodeSetup& setup;
    runtime::DeviceModel& model;
    NodeProcessor& processor;
    NodeClock& clock;
    NodePairs& pairs;
    NodeOutputs& outputs;
    NodeChannels& channels;
    NodeApplication& application;
    NodeSelfTest* self_test; ///< Null: the device has none.
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_NODE_INSIDE_HPP
