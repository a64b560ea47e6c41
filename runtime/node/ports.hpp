// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NODE_PORTS_HPP
#define RUNTIME_NODE_PORTS_HPP

#include "hal/api/can_ports.hpp"
#include "hal/host/live/bus.hpp"
#include "runtime/yaml/value.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <string>

namespace counterpoint::runtime
{
/// The words for the states of a bus, the worst state first.
inline constexpr Word<host::BusState> kBusWords[] = {{"down", host::BusState::kDown},
                                                     {"bus_off", host::BusState::kBusOff},
                                                     {"passive", host::BusState::kPassive},
                                                     {"warning", host::BusState::kWarning},
                                                     {"active", host::BusState::kActive}};

/// SRDOs that a connection may have held for longer are left aside. [SRS_NODE_031]
constexpr std::uint32_t kOldestSrdoMs = 100U;

/// The controllers of a live node. It has two connections to one bus, so that SRDO and GFC also have queues of their
/// own in the system, both ways. A second controller is a third connection, for the inverse frames of SRDOs (even
/// identifiers). [SRS_DEV_007, SRS_NODE_014]
class NodePorts final : public hal::CanPorts
{
  public:
    /// @brief Opens the buses with these addresses; `second` empty: one controller. Throws host::LiveBusError.
    NodePorts(const std::string& first, const std::string& second);
    /// @brief One controller, with two connections that are open already; two with a third connection.
    NodePorts(std::unique_ptr<host::LiveBus> safety, std::unique_ptr<host::LiveBus> services,
              std::unique_ptr<host::LiveBus> inverse = nullptr) noexcept;

    [[nodiscard]] hal::CanGuarantees Guarantees() const noexcept override;
    /// @brief The connection for frames with safety identifiers, but for those of the second controller.
    [[nodiscard]] host::LiveBus& Safety() noexcept
    {
        return *safety_;
    }
    /// @brief The connection for all frames of the first controller.
    [[nodiscard]] host::LiveBus& Services() noexcept
    {
        return *services_;
    }
    /// @brief The connection of the second controller; null: there is none.
    [[nodiscard]] host::LiveBus* Inverse() noexcept
    {
        return inverse_.get();
    }
    /// @brief Number of frames that the system lost, on all connections.
    [[nodiscard]] std::uint32_t LostFrames() const;
    /// @brief Number of SRDOs that were left aside because nobody knows how old they are.
    [[nodiscard]] std::uint32_t StaleFrames() const;
    /// @brief Number of elements of all connections that were none.
    [[nodiscard]] std::uint32_t Malformed() const;
    /// @brief What was wrong with the last of those, of one connection.
    [[nodiscard]] std::string Problem() const;
    /// @brief What the last absence of a connection was, if there was one since the last call; else kInvalid.
    /// [SRS_NODE_580]
    [[nodiscard]] host::BusState TakeAbsence();
    /// @brief The worst state of all connections.
    [[nodiscard]] host::BusState State() const;
    /// @brief From now on SRDOs are refused, because the process ends.
    void EndProduction() noexcept
    {
        has_ended_ = true;
    }

  private:
    [[nodiscard]] std::array<host::LiveBus*, 3U> Buses() const noexcept;
    [[nodiscard]] hal::TransmitStatus DoTransmit(const CanFrame& frame) noexcept override;

    std::unique_ptr<host::LiveBus> safety_;
    std::unique_ptr<host::LiveBus> services_;
    std::unique_ptr<host::LiveBus> inverse_;
    bool has_ended_{false};
    std::array<std::uint32_t, 3U> absences_{}; ///< By connection, as they were taken last.
};
} // namespace counterpoint::runtime

#endif // RUNTIME_NODE_PORTS_HPP
