// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NODE_ORDERS_HPP
#define RUNTIME_NODE_ORDERS_HPP

#include "runtime/node/device.hpp"
#include "runtime/node/order.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace counterpoint::runtime
{
/// Time of a live node: its counters, and CLOCK_MONOTONIC for what is told.
struct NodeMoment
{
    InstantPair now{{0U}, {0U}};
    std::uint64_t now_ns{0U};
};

/// Carries out the orders to a live node, and writes the answers as lines. [SRS_NODE_003, SRS_NODE_004]
class NodeOrders
{
  public:
    /// Both outlive it.
    NodeOrders(NodePorts& ports, NodeReport& report);

    /// @brief Carries out one order. False: it was to quit.
    [[nodiscard]] bool Carry(const NodeOrder& order, NodeDevice& device, const NodeMoment& at);
    /// @brief Tries again to write a value that its object has not taken yet, because a save takes many steps. Once a
    /// step.
    void GoOn(NodeDevice& device, const NodeMoment& at);

  private:
    void Acknowledge(const NodeOrder& order, NodeDevice& device);
    void Set(const NodeOrder& order, NodeDevice& device, cia301::Attempt attempt);
    void TellObject(const ObjectAddress& object, NodeDevice& device);
    void SendCommand(const NodeOrder& order, NodeDevice& device);
    void TellState(NodeDevice& device);
    /// Nothing for an empty text. `shown`: what stands in the report's record; empty: the text.
    void TellProblem(const std::string& text, const std::string& shown = "");

    NodePorts& ports_;
    NodeReport& report_;
    NodeMoment at_{};
    std::optional<NodeOrder> pending_; ///< A set whose object has not taken its value yet.
};
} // namespace counterpoint::runtime

#endif // RUNTIME_NODE_ORDERS_HPP
