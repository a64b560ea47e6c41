// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_NETWORK_CHECK_HPP
#define SIMULATOR_WORLD_NETWORK_CHECK_HPP

#include "simulator/world/world.hpp"

namespace counterpoint::simulator
{
/// Compares a scenario with the DCFs of its devices. Throws YamlError for the first thing that does not exist.
class NetworkCheck
{
  public:
    /// @brief `world` outlives the check.
    explicit NetworkCheck(const World& world);

    /// @brief Whether every object, SRDO and node that the scenario names exists.
    void RequireThatEverythingExists() const;

  private:
    [[nodiscard]] const runtime::DeviceModel& ModelOf(NodeIndex node) const;
    void RequirePair(NodeIndex node, const ObjectAddress& object, bool is_consumer, const Source& source) const;
    void RequireSrdo(NodeIndex node, std::uint8_t number, bool needs_consumer, const Source& source) const;
    void RequireValue(NodeIndex node, const ObjectAddress& object, std::uint64_t value, const Source& source) const;
    void RequireNodeIds() const;
    void RequireLinks() const;
    void RequireOfCpu(const FaultSetup& fault) const;
    void RequireOfFault(const FaultSetup& fault) const;
    void RequireOfExpectation(const Expectation& expectation) const;

    const World& world_;
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_NETWORK_CHECK_HPP
