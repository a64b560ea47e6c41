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
    /// @brief Tells at `now_ns` which transfers have ended, and how.
    void Look(std::uint64_t now_ns);

  private:
    /// A client and what its transfer is about.
    struct Transfer
    {
        cia301::SdoClientPort* port;
        NodeOrder order;
        std::vector<std::uint8_t> bytes;
    };

    void Tell(const Transfer& transfer, std::uint64_t now_ns);

    OptionalServices& services_;
    NodeReport& report_;
    std::list<Transfer> running_;
};

/// @brief The abort code of a transfer, or of an object of this node, as text.
[[nodiscard]] std::string SdoAbortText(cia301::SdoAbort abort);
} // namespace counterpoint::runtime

#endif // RUNTIME_NODE_TRANSFERS_HPP
