// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_NETWORKS_SIMULATION_HPP
#define SIMULATOR_NETWORKS_SIMULATION_HPP

#include "runtime/manager/station.hpp"
#include "simulator/networks/device.hpp"
#include "simulator/networks/scenario.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace counterpoint::simulator
{
/// One manager of a simulated network, with what it told.
struct SimulatedManager
{
    ScenarioManager setup;
    std::uint8_t node{0U};
    std::unique_ptr<network::LoadedNetwork> net;
    std::unique_ptr<SimulatedPort> port; ///< Null: it has no supply.
    std::unique_ptr<runtime::ManagerStation> station;
    std::vector<runtime::ManagerEvent> events;
    std::uint64_t next_cycle_ns{0U};
    bool is_off_bus{false}; ///< Its controller neither sends nor receives.
};

struct NetworkVerdict
{
    bool holds{false};
    std::string text; ///< "line 31: letter of node 33 is O" or what it was instead.
};

/// A network scenario brought to life, and judged. The same scenario gives the same events. [SRS_MGR_012]
class NetworkSimulation
{
  public:
    using TellEvent = std::function<void(const SimulatedManager&, const runtime::ManagerEvent&)>;
    using TellFrame = std::function<void(const host::LiveFrame&)>;

    /// @brief `scenario` outlives it. Throws cia306::InputError and YamlError.
    NetworkSimulation(const NetworkScenario& scenario, TellEvent tell);

    void Run();
    /// @brief `tell` gets each frame of the bus at its end.
    void Listen(TellFrame tell);
    [[nodiscard]] const std::vector<NetworkVerdict>& Verdicts() const noexcept
    {
        return verdicts_;
    }
    [[nodiscard]] const std::vector<std::unique_ptr<SimulatedManager>>& Managers() const noexcept
    {
        return managers_;
    }
    [[nodiscard]] std::uint64_t FrameCount() const noexcept
    {
        return bus_.FrameCount();
    }

  private:
    /// Frames that a defective device sends, one after the other.
    struct Storm
    {
        NetworkAction action;
        std::unique_ptr<SimulatedPort> port;
        std::uint64_t next_ns{0U};
    };

    [[nodiscard]] std::uint64_t NextNs() const;
    void Step(std::uint64_t now_ns);
    void TellFrames();
    void StartDue(std::uint64_t now_ns);
    void Act(const NetworkAction& action, std::uint64_t now_ns);
    void ActOnController(const NetworkAction& action, std::uint64_t now_ns);
    void ActOnDevice(const NetworkAction& action, std::uint64_t now_ns);
    void Insert(std::uint8_t node, std::uint64_t now_ns);
    void Pull(std::uint8_t node);
    void RunStorms(std::uint64_t now_ns);
    void RunManager(SimulatedManager& manager, std::uint64_t now_ns);
    void Judge(std::uint64_t now_ns);
    void RequireKnown(const NetworkExpectation& expectation);
    void RequireOfProfile(const NetworkExpectation& expectation, const SimulatedManager& manager) const;
    void RequireOfSafety(const NetworkExpectation& expectation, const SimulatedManager& manager) const;
    void RequireOfGuarding(const NetworkExpectation& expectation, const SimulatedManager& manager) const;
    [[nodiscard]] bool MayChange(const SimulatedManager& manager) const;
    void RequireManagers();
    [[nodiscard]] NetworkVerdict VerdictOf(const NetworkExpectation& expectation);
    [[nodiscard]] std::string Found(const NetworkExpectation& expectation, const SimulatedManager& manager);
    [[nodiscard]] std::string FoundAtDevice(const NetworkExpectation& expectation);
    [[nodiscard]] SimulatedDevice* DeviceOf(std::uint8_t node);
    [[nodiscard]] SimulatedManager& ManagerOf(std::uint8_t node, const Place& place);

    const NetworkScenario& scenario_;
    TellEvent tell_;
    TellFrame tell_frame_;
    SimulatedBus bus_;
    std::unique_ptr<SimulatedPort> listener_; ///< Null: nobody listens.
    std::vector<std::unique_ptr<SimulatedManager>> managers_;
    std::vector<ScenarioDevice> setups_; ///< As they are now: a replaced one has another serial number.
    std::vector<bool> has_come_;         ///< By setup: its supply came once.
    std::vector<std::unique_ptr<SimulatedDevice>> devices_;
    std::vector<Storm> storms_;
    std::vector<NetworkAction> actions_;           ///< By time.
    std::vector<NetworkExpectation> expectations_; ///< By time.
    std::vector<NetworkVerdict> verdicts_;
    std::size_t next_action_{0U};
    std::size_t next_expectation_{0U};
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_NETWORKS_SIMULATION_HPP
