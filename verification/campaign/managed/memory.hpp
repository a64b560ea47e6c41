// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_MANAGED_MEMORY_HPP
#define VERIFICATION_CAMPAIGN_MANAGED_MEMORY_HPP

#include "simulator/managers/manager.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::campaign::managed
{
/// A member of a manager's memory, where it lies now.
struct ManagerPlace
{
    std::string name;
    std::uint8_t* bytes{nullptr};
    std::size_t size{0U};
};

/// @brief All that a manager decides by: expectations and setup of its network, and its own state; of arrays by node-ID
/// the elements of the network's slaves, of queues and connections as many as such a network uses. Nothing while it was
/// never switched on. [SRS_CMG_080]
[[nodiscard]] std::vector<ManagerPlace> PlacesOf(simulator::SimulatedManager& manager);

/// A member of a manager's memory in the run without fault.
struct ManagerMember
{
    std::size_t manager{0U};
    std::string name;
    std::uint32_t size_bytes{0U};
};

/// Learns in the run without fault which members there are. [SRS_CMG_080]
class MemoryWatch
{
  public:
    /// @brief Once a ms.
    void Look(std::size_t index, simulator::SimulatedManager& manager);
    [[nodiscard]] std::vector<ManagerMember> Members() const;

  private:
    std::vector<std::vector<ManagerMember>> seen_{}; ///< By manager.
};

/// @brief Flips a bit; nothing where the member is not there, or an address lies there now.
void FlipIn(simulator::SimulatedManager& manager, const std::string& member, std::uint32_t byte, std::uint32_t bit);
} // namespace counterpoint::campaign::managed

#endif // VERIFICATION_CAMPAIGN_MANAGED_MEMORY_HPP
