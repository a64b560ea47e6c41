// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_MANAGERS_MANAGER_HPP
#define SIMULATOR_MANAGERS_MANAGER_HPP

#include "runtime/manager/station.hpp"
#include "simulator/journal/journal.hpp"
#include "simulator/world/network.hpp"

#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

namespace counterpoint::simulator
{
/// What is wrong with the clock of a manager from an instant on. [SRS_CMG_081]
struct ManagerClockFault
{
    Nanoseconds since{kNever};
    std::int64_t rate_ppm{0}; ///< Fast, or slow.
    Nanoseconds jump{0};
};

/// One manager of a simulated network, with what happens to it and what it told. It cannot be moved or copied.
/// [SRS_MGR_012]
class SimulatedManager final : public Participant, private host::BusListener
{
  public:
    /// @brief `place` is its index in the journal; managers come behind the nodes. All references outlive it. Throws
    /// cia306::InputError and YamlError.
    SimulatedManager(const ManagerSetup& setup, const std::string& profile, std::size_t place, host::VirtualBus& bus,
                     Journal& journal);

    /// @brief Adds something that will happen to it; call it in the order of time.
    void Plan(const Action& action);
    /// @brief One that was killed is there again, as new.
    void SwitchOn(Nanoseconds now);
    /// @brief Its program ends; nothing when it does not run.
    void SwitchOff();
    /// @brief From an instant that is not over its clock is wrong. An oscillator that is fast or slow is that of its
    /// cycles, too; one that stands still (-1000000 ppm) or jumps is not.
    void Disturb(const ManagerClockFault& fault) noexcept
    {
        clock_ = fault;
    }
    /// @brief What the scenario says about it.
    [[nodiscard]] const ManagerSetup& Setup() const noexcept
    {
        return setup_;
    }
    /// @brief Its node-ID.
    [[nodiscard]] std::uint8_t Node() const noexcept
    {
        return net_.Setup().own.value;
    }
    /// @brief Its controller on the bus.
    [[nodiscard]] host::NodeIndex BusNode() const noexcept
    {
        return bus_node_;
    }
    /// @brief Its network.
    [[nodiscard]] const network_plan::LoadedNetwork& Net() const noexcept
    {
        return net_;
    }
    /// @brief The same, whose memory may change.
    [[nodiscard]] network_plan::LoadedNetwork& NetRoom() noexcept
    {
        return net_;
    }
    /// @brief The manager itself; null: it was not switched on yet.
    [[nodiscard]] const runtime::ManagerStation* Station() const noexcept
    {
        return station_.get();
    }
    /// @brief The same, whose memory may change.
    [[nodiscard]] runtime::ManagerStation* Station() noexcept
    {
        return station_.get();
    }
    /// @brief Whether it is switched on and was not killed.
    [[nodiscard]] bool HasSupply() const noexcept
    {
        return station_ != nullptr && !is_killed_;
    }
    /// @brief All events that it told.
    [[nodiscard]] const std::vector<runtime::ManagerEvent>& Events() const noexcept
    {
        return events_;
    }

    [[nodiscard]] Nanoseconds NextEvent() const noexcept override;
    void Run(Nanoseconds now) override;

  private:
    /// A frame that was on the bus, and when the manager looks at it.
    struct HeardFrame
    {
        CanFrame frame;
        Nanoseconds at;
        bool is_own;
    };

    void OnReceived(const CanFrame& frame, host::BusTime at) override;
    void OnConfirmed(const CanFrame& frame, host::BusTime at) override;
    void OnBusOff(host::BusTime at) override;
    [[nodiscard]] bool Send(const CanFrame& frame);
    void TakeFrames(Nanoseconds now);
    void Start(Nanoseconds now);
    void Act(const Action& action, Nanoseconds now);
    void TellController(cia302::ControllerState state, const char* word, Nanoseconds now);
    [[nodiscard]] std::uint64_t ClockUs(Nanoseconds now) noexcept;
    [[nodiscard]] Nanoseconds CycleTime(Nanoseconds now) const noexcept;

    ManagerSetup setup_;
    std::size_t place_;
    host::VirtualBus& bus_;
    Journal& journal_;
    network_plan::LoadedNetwork net_;
    host::NodeIndex bus_node_;
    std::unique_ptr<runtime::ManagerStation> station_;
    std::vector<runtime::ManagerEvent> events_;
    std::deque<HeardFrame> heard_; ///< Not taken yet.
    std::deque<CanFrame> waiting_; ///< As in a socket: in the order of sending, the first one in the controller.
    std::vector<Action> actions_;  ///< By time.
    std::size_t next_action_{0U};
    Nanoseconds begin_;
    Nanoseconds next_cycle_{kNever};
    bool is_killed_{false};
    bool is_off_bus_{false}; ///< Its controller neither sends nor receives.
    ManagerClockFault clock_{};
    std::uint64_t fast_by_us_{0U}; ///< Modulo 2^64, of its clock when it was last looked at.
};

using SimulatedManagers = std::vector<std::unique_ptr<SimulatedManager>>;

/// @brief Refuses what a scenario asks of its managers without effect, or what holds whatever happens, by their network
/// files. Throws YamlError. [SRS_MGR_012]
void RequireOfManagers(const Scenario& scenario, const SimulatedManagers& managers);
/// @brief Refuses an order that this manager can never carry out, whatever happens, by its network file. Throws
/// YamlError. [SRS_MGR_587]
void RequirePossible(const Action& action, const runtime::ManagerOrder& order, SimulatedManager& manager);
/// @brief The manager with this node-ID; 0: the first one. Throws YamlError if there is none.
[[nodiscard]] SimulatedManager& ManagerOf(const SimulatedManagers& managers, std::uint8_t node_id,
                                          const Source& source);
} // namespace counterpoint::simulator

#endif // SIMULATOR_MANAGERS_MANAGER_HPP
