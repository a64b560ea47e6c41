// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NODE_TRANSFERS_HPP
#define RUNTIME_NODE_TRANSFERS_HPP

#include "runtime/console/node_report.hpp"
#include "runtime/device/objects/optional_services.hpp"
#include "runtime/node/order.hpp"

#include <cstdint>
#include <list>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// What a live node sends to others by order: SDO transfers and the time. [SRS_NODE_012]
class NodeTransfers final
{
  public:
    /// All given outlive it.
    NodeTransfers(OptionalServices& services, NodeReport& report);

    /// @brief Sends the time of the system. Empty: it was sent; else why not, and what is expected.
    [[nodiscard]] std::string SendTime(cia301::NodeState state, Instant now);
    /// @brief Begins to read from another node, or to write to it. Empty: it has begun; else why not.
    [[nodiscard]] std::string StartTransfer(const NodeOrder& order, Instant now);
    /// @brief Sets the time of what is told next.
    void SetNow(std::uint64_t now_ns) noexcept
    {
        now_ns_ = now_ns;
    }
    /// @brief Tells which transfers have ended, and how.
    void Look();

  private:
    /// A client and what its transfer is about.
    struct Transfer
    {
        cia301::SdoClientPort* port;
        NodeOrder order;
        std::vector<std::uint8_t> bytes;
    };

    void Tell(const Transfer& transfer);

    OptionalServices& services_;
    NodeReport& report_;
    std::uint64_t now_ns_{0U};
    std::list<Transfer> running_;
};
} // namespace counterpoint::runtime

#endif // RUNTIME_NODE_TRANSFERS_HPP
