// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_NODE_PORTS_HPP
#define TOOLS_NODE_PORTS_HPP

#include "hal/api/can_ports.hpp"
#include "hal/host/live_bus.hpp"

#include <memory>
#include <string>

namespace counterpoint::tools
{
/// The controller of a live node: two connections to one bus, so that in the system too SRDO and GFC have queues that
/// no other frame takes, both ways. [SRS-DEV-007]
class NodePorts final : public hal::CanPorts
{
  public:
    /// Throws host::LiveBusError.
    explicit NodePorts(const std::string& address);
    /// @brief Two connections that were opened already: a simulated bus.
    NodePorts(std::unique_ptr<host::LiveBus> safety, std::unique_ptr<host::LiveBus> services) noexcept;

    [[nodiscard]] hal::CanGuarantees Guarantees() const noexcept override;
    /// @brief Frames with safety identifiers.
    [[nodiscard]] host::LiveBus& Safety() noexcept
    {
        return *safety_;
    }
    /// @brief All frames.
    [[nodiscard]] host::LiveBus& Services() noexcept
    {
        return *services_;
    }
    /// @brief From now on SRDOs are refused: the end of the process.
    void EndProduction() noexcept
    {
        has_ended_ = true;
    }

  private:
    [[nodiscard]] hal::TransmitStatus DoTransmit(const CanFrame& frame) noexcept override;

    std::unique_ptr<host::LiveBus> safety_;
    std::unique_ptr<host::LiveBus> services_;
    bool has_ended_{false};
};
} // namespace counterpoint::tools

#endif // TOOLS_NODE_PORTS_HPP
