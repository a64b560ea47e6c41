// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NODE_LOOP_HPP
#define RUNTIME_NODE_LOOP_HPP

#include "runtime/console/streams.hpp"
#include "runtime/console/told_count.hpp"
#include "runtime/node/clocks.hpp"
#include "runtime/node/orders.hpp"
#include "runtime/node/script.hpp"

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace counterpoint::runtime
{
/// What a loop works with; all outlive it.
struct NodeLoopParts
{
    /// A device with the node-ID that LSS gave, if it gave one. May throw as NodeDevice does. [SRS_NODE_151]
    std::function<std::unique_ptr<NodeDevice>(std::optional<std::uint8_t> lss_node_id)> make;
    NodePorts& ports;
    NodeReport& report;
    const NodeScript& script;
    int input; ///< Descriptor of typed orders; -1: none.
};

/// Runs a live node: cycles at their times, frames and orders between them, until it is told to stop. [SRS_NODE_003,
/// SRS_NODE_005, SRS_NODE_006, SRS_NODE_031, SRS_NODE_580, SRS_NODE_581]
class NodeLoop
{
  public:
    /// @brief Makes the device; may throw as `make` does.
    explicit NodeLoop(const NodeLoopParts& parts);

    /// @brief Runs until `quit`, typed or in the script, SIGTERM or SIGINT. kDoesNotHold: the device ended in its safe
    /// state.
    [[nodiscard]] ExitStatus Run();

  private:
    using HeldFrames = std::deque<host::LiveFrame>;

    [[nodiscard]] std::string BusNames() const;
    void Wait();
    void Receive();
    void Hold(host::LiveBus& bus, HeldFrames& held);
    [[nodiscard]] bool TakeOldest();
    void ReceiveServices();
    void Replace(std::uint8_t node_id);
    void Step();
    void RunCycle();
    void TellConnection();
    void WatchBus();
    void WatchState();
    void EnterBus(host::BusState state);
    void WatchMalformed();
    void WatchAge();
    void FollowScript();
    void ReadOrders();
    void TakeOrder(const std::string& line);
    void TellProblem(const std::string& text);
    void Carry(const NodeOrder& order);
    void Tell(const std::string& text, const std::string& event, const nlohmann::ordered_json& details);
    [[nodiscard]] ExitStatus End();

    NodeLoopParts parts_;
    std::unique_ptr<NodeDevice> device_;
    NodeClocks clocks_;
    NodeOrders orders_;
    NodeScript script_;     ///< Steps that are left.
    HeldFrames first_held_; ///< Safety frames by controller; those after the instant that is worked on wait.
    HeldFrames second_held_;
    std::uint64_t start_ns_{0U};
    std::uint64_t next_cycle_ns_{0U};
    std::uint64_t cycle_ns_;
    std::uint64_t watched_ns_{0U};
    std::uint64_t latest_cycle_ns_{0U}; ///< Greatest distance of a cycle from its time.
    std::uint32_t lost_{0U};
    bool has_connection_{false}; ///< A bus is that of a server.
    ToldCount stale_{};
    ToldCount malformed_{};
    host::BusState bus_{host::BusState::kActive};
    InstantPair now_{{0U}, {0U}};
    std::uint64_t now_ns_{0U};
    std::string typed_;       ///< Begin of a line.
    bool is_too_long_{false}; ///< What is typed until the next line end is the rest of a line that was left out.
    std::string reason_;      ///< Why it ends; empty: it does not.
    bool is_input_open_;
};
} // namespace counterpoint::runtime

#endif // RUNTIME_NODE_LOOP_HPP
