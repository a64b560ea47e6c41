// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_NETWORKS_SCENARIO_HPP
#define SIMULATOR_NETWORKS_SCENARIO_HPP

#include "runtime/yaml/document.hpp"
#include "safety_core/kernel/object_access.hpp"
#include "simulator/scenario/network_names.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::simulator
{
/// A manager of the scenario: a network file, and who manages.
struct ScenarioManager
{
    std::string network;
    std::uint8_t node{0U}; ///< 0: as the file says.
    std::uint64_t at_ns{0U};
    Place place{};
};

/// A device of the scenario: everything of a DCF in simulated time.
struct ScenarioDevice
{
    std::uint8_t node{0U};
    std::string dcf;
    std::optional<std::uint32_t> serial; ///< 1018h:04 instead of the DCF's.
    std::uint64_t at_ns{0U};
    Place place{};
};

using simulator::NetworkActionKind;
using simulator::NetworkExpectationKind;

/// Something that happens to the network.
struct NetworkAction
{
    NetworkActionKind kind{NetworkActionKind::kPull};
    Place place{};
    std::uint64_t at_ns{0U};
    std::uint64_t until_ns{0U};
    std::uint64_t every_ns{0U};
    std::uint8_t node{0U};
    std::uint32_t serial{0U};
    std::uint32_t identifier{0U};
    std::uint16_t code{0U};
    std::string order;
    ObjectAddress object{0U, 0U};
    std::uint32_t value{0U};
    std::uint8_t srdo{0U};
    std::vector<std::uint8_t> data; ///< Of a frame that is sent.
};

/// @brief Whether the action is one of a manager, by its node-ID or 0 for the first one.
[[nodiscard]] bool IsOfManager(NetworkActionKind kind) noexcept;
/// @brief Whether the action puts frames on the bus by itself.
[[nodiscard]] bool IsStorm(NetworkActionKind kind) noexcept;

struct NetworkExpectation
{
    NetworkExpectationKind kind{NetworkExpectationKind::kState};
    Place place;
    std::uint64_t at_ns{0U};   ///< When it is looked at; of events the end of the window.
    std::uint64_t from_ns{0U}; ///< Of events.
    std::uint8_t node{0U};
    std::uint8_t manager{0U}; ///< 0: the first one.
    std::uint8_t srdo{0U};
    std::string is; ///< The word that is expected.
};

/// A network in simulated time. [SRS_MGR_012]
struct NetworkScenario
{
    std::string file;
    std::string title;
    std::string description;
    std::uint32_t bitrate{500000U};
    std::uint64_t duration_ns{0U};
    std::vector<ScenarioManager> managers;
    std::vector<ScenarioDevice> devices;
    std::vector<NetworkAction> actions;
    std::vector<NetworkExpectation> expectations;
};

/// @brief Whether a scenario is one of a network: its top level has the key managers. Throws YamlError.
[[nodiscard]] bool IsNetworkScenario(const std::string& path);
/// @brief Refuses also what would do nothing, or hold whatever happens. Throws YamlError.
[[nodiscard]] NetworkScenario ReadNetworkScenario(const std::string& path);
/// @brief The second half of it: what does not fit together. Throws YamlError.
void RequireSense(const NetworkScenario& scenario);
/// @brief A part of that: what is asked of a device and its DCF does not have. Throws also cia306::InputError.
void RequireObjects(const NetworkScenario& scenario, const ScenarioDevice& device);
} // namespace counterpoint::simulator

#endif // SIMULATOR_NETWORKS_SCENARIO_HPP
