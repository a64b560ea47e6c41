// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_MANAGER_CONSUMERS_HPP
#define RUNTIME_MANAGER_CONSUMERS_HPP

#include "runtime/manager/assembly.hpp"

#include <array>
#include <cstdint>

namespace counterpoint::runtime
{
/// @brief Whether the start-up of the slave runs and has looked at the slave. It has not while it waits for its boot-up
/// message or, under cia302, for its first answer. [SRS_MGR_215]
[[nodiscard]] bool IsStartingUp(const ManagerAssembly& assembly, cia302::NodeId node) noexcept;

/// 1016h of the manager: which nodes it supervises by heartbeat, and with which time. At first these are the nodes of
/// the network file, by node-ID. [SRS_MGR_221, SRS_MGR_222]
class ManagerConsumers
{
  public:
    /// @brief Both outlive it.
    ManagerConsumers(ManagerAssembly& assembly, network_plan::LoadedNetwork& net);

    /// @brief `sub` is 1 to 127, checked by the caller: node-ID in bits 16 to 23, time in ms; 0: nobody.
    [[nodiscard]] std::uint32_t Value(std::uint8_t sub) const noexcept;
    /// @brief Writes an entry. It counts at once if the node is watched, started or no slave, else from its next
    /// start-up on.
    /// Refused are a node in two entries, reserved bits, the own node, a safety slave, and a slave that is starting up.
    [[nodiscard]] cia301::SdoAbort Write(std::uint8_t sub, std::uint32_t value, Instant now) noexcept;

  private:
    [[nodiscard]] cia301::SdoAbort MayWrite(std::uint8_t sub, std::uint32_t value) const noexcept;
    [[nodiscard]] cia301::SdoAbort MayChange(std::uint32_t value) const noexcept;
    void Watch(cia302::NodeId node, std::uint16_t consumer_ms, Instant now) noexcept;

    ManagerAssembly& assembly_;
    network_plan::LoadedNetwork& net_;
    std::array<std::uint32_t, cia302::kNodeRoom> values_{};
};
} // namespace counterpoint::runtime

#endif // RUNTIME_MANAGER_CONSUMERS_HPP
