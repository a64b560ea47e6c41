// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NODE_ORDERS_HPP
#define RUNTIME_NODE_ORDERS_HPP

#include "runtime/node/device.hpp"
#include "runtime/node/order.hpp"

#include <cstdint>
#include <string>

namespace counterpoint::runtime
{
/// An instant of a live node: its counters, and the time of what is told.
struct NodeMoment
{
    InstantPair now{{0U}, {0U}};
    std::uint64_t now_ns{0U};
};

/// What a person or a script asks of a live node, and its answers as lines. [SRS_NODE_003, SRS_NODE_004]
class NodeOrders
{
  public:
    /// Both outlive it.
    NodeOrders(NodePorts& ports, NodeReport& report);

    /// @brief Carries one order out at the device as it is now. False: it was to quit.
    [[nodiscard]] bool Carry(const NodeOrder& order, NodeDevice& device, const NodeMoment& at);
    /// @brief Tries a value again that its object has not taken yet: a save takes many steps. Once a step.
    void GoOn(NodeDevice& device, const NodeMoment& at);

  private:
    void Set(const NodeOrder& order, NodeDevice& device);
    void TellObject(const ObjectAddress& object, NodeDevice& device);
    void SendCommand(const NodeOrder& order, NodeDevice& device);
    void TellState(NodeDevice& device);
    /// Nothing for an empty text. `shown`: what stands in the report's record; empty: the text.
    void TellProblem(const std::string& text, const std::string& shown = "");

    NodePorts& ports_;
    NodeReport& report_;
    NodeMoment at_{};
    NodeOrder pending_{};
};
} // namespace counterpoint::runtime

#endif // RUNTIME_NODE_ORDERS_HPP
