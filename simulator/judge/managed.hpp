// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_JUDGE_MANAGED_HPP
#define SIMULATOR_JUDGE_MANAGED_HPP

#include "simulator/journal/journal.hpp"
#include "simulator/scenario/scenario.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace counterpoint::simulator
{
class Network;

/// The managers of a network as a run sees them; a program that only looks at devices needs none. They join the
/// network, and what they tell is in the journal.
class ManagedWorld
{
  public:
    ManagedWorld() = default;
    virtual ~ManagedWorld() = default;
    ManagedWorld(const ManagedWorld&) = delete;
    ManagedWorld& operator=(const ManagedWorld&) = delete;

    /// @brief What a manager knows now of what the expectation asks for, as a word of the scenario format.
    [[nodiscard]] virtual std::string Found(const Expectation& expectation) = 0;
    /// @brief The warnings of all network files, a line each.
    [[nodiscard]] virtual std::vector<std::string> Warnings() const = 0;
    /// @brief Node-IDs of the managers, in the order of the scenario.
    [[nodiscard]] virtual std::vector<std::uint8_t> Managers() const = 0;
    /// @brief For each manager the table of its nodes and its sequence diagram, as HTML.
    [[nodiscard]] virtual std::string Pictures() const = 0;
};

/// Makes the managers of a scenario.
using MakeManaged = std::function<std::unique_ptr<ManagedWorld>(const Scenario&, Journal&, Network&)>;
} // namespace counterpoint::simulator

#endif // SIMULATOR_JUDGE_MANAGED_HPP
