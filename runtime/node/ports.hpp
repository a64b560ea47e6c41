// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NODE_PORTS_HPP
#define RUNTIME_NODE_PORTS_HPP

#include "hal/api/can_ports.hpp"
#include "hal/host/live/bus.hpp"

#include <memory>
#include <string>

namespace counterpoint::runtime
{
/// The controllers of a live node: two connections to one bus, so that in the system too SRDO and GFC have queues that
/// no other frame takes, both ways; with a second controller a third one, which has the inverse frames of SRDOs (even
/// identifiers) for itself. [SRS_DEV_007, SRS_NODE_014]
class NodePorts final : public hal::CanPorts
{
  public:
    /// `second` empty: one controller. Throws host::LiveBusError.
    NodePorts(const std::string& first, const std::string& second);
    /// @brief One controller, two connections that were opened already.
    NodePorts(std::unique_ptr<host::LiveBus> safety, std::unique_ptr<host::LiveBus> services) noexcept;

    [[nodiscard]] hal::CanGuarantees Guarantees() const noexcept override;
    /// @brief Frames with safety identifiers; without those of the second controller.
    [[nodiscard]] host::LiveBus& Safety() noexcept
    {
        return *safety_;
    }
    /// @brief All frames of the first controller.
    [[nodiscard]] host::LiveBus& Services() noexcept
    {
        return *services_;
    }
    /// @brief The second controller; null: there is none.
    [[nodiscard]] host::LiveBus* Inverse() noexcept
    {
        return inverse_.get();
    }
    /// @brief Frames that the system lost, of all.
    [[nodiscard]] std::uint32_t LostFrames() const;
    /// @brief The worst one of all connections and controllers.
    [[nodiscard]] host::BusState State() const;
    /// @brief From now on SRDOs are refused: the end of the process.
    void EndProduction() noexcept
    {
        has_ended_ = true;
    }

  private:
    [[nodiscard]] hal::TransmitStatus DoTransmit(const CanFrame& frame) noexcept override;

    std::unique_ptr<host::LiveBus> safety_;
    std::unique_ptr<host::LiveBus> services_;
    std::unique_ptr<host::LiveBus> inverse_;
    bool has_ended_{false};
};
} // namespace counterpoint::runtime

#endif // RUNTIME_NODE_PORTS_HPP
