// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_MANAGED_STAGE_HPP
#define VERIFICATION_CAMPAIGN_MANAGED_STAGE_HPP

#include "simulator/managers/manager.hpp"
#include "verification/campaign/managed/frame_fault.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::campaign::managed
{
/// Somebody on the bus who says nothing by itself.
class Stranger final : public simulator::Participant, private host::BusListener
{
  public:
    explicit Stranger(host::VirtualBus& bus);

    void Send(const CanFrame& frame);
    [[nodiscard]] host::NodeIndex BusNode() const noexcept
    {
        return node_;
    }
    [[nodiscard]] Nanoseconds NextEvent() const noexcept override
    {
        return simulator::kNever;
    }
    void Run(Nanoseconds now) override;

  private:
    void OnReceived(const CanFrame& frame, host::BusTime at) override;
    void OnConfirmed(const CanFrame& frame, host::BusTime at) override;

    host::VirtualBus& bus_;
    host::NodeIndex node_;
};

/// A manager whose program may end by a fault of its memory: what a system does with a program that fails. From Guard
/// on such an end is that of the manager alone. [SRS_CMG_080]
class GuardedManager final : public simulator::Participant
{
  public:
    explicit GuardedManager(simulator::SimulatedManager& manager) noexcept : manager_(manager)
    {
    }
    /// @brief While a Trap is there.
    void Guard() noexcept
    {
        is_guarded_ = true;
    }
    /// @brief When its program ended by an exception; below 0: it did not.
    [[nodiscard]] Nanoseconds EndedAt() const noexcept
    {
        return ended_at_;
    }
    [[nodiscard]] Nanoseconds NextEvent() const noexcept override
    {
        return manager_.NextEvent();
    }
    void Run(Nanoseconds now) override;
    /// @brief Looks at the manager, which may end by that, too.
    void Look(Nanoseconds now, const std::function<void()>& look);

  private:
    simulator::SimulatedManager& manager_;
    bool is_guarded_{false};
    Nanoseconds ended_at_{-1};
};

/// An object of a safety configuration as it has to be.
struct ExpectedValue
{
    ObjectAddress object{0U, 0U};
    std::uint32_t value{0U};
    std::uint8_t size{0U};
};

/// A device of the scenario.
struct Slave
{
    simulator::NodeIndex index{0U};
    std::uint8_t node_id{0U};
    host::NodeIndex bus_node{0U};
    std::vector<ExpectedValue> expected; ///< None: no safety slave.
    std::uint32_t serial{0U};            ///< That the network files tell; 0: not compared.
};

/// The scenario of a plan as it runs: the shipped managers and devices on the simulated bus, somebody who can write,
/// and a fault that can be armed. Its parts refer to each other. [SRS_CMG_070]
class Stage
{
  public:
    /// @brief Nothing has happened yet. Throws YamlError and cia306::InputError.
    explicit Stage(const Plan& plan);
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    [[nodiscard]] const simulator::Scenario& Setting() const noexcept
    {
        return scenario_;
    }
    [[nodiscard]] const simulator::Journal& Record() const noexcept
    {
        return journal_;
    }
    [[nodiscard]] simulator::Network& World() noexcept
    {
        return *network_;
    }
    [[nodiscard]] simulator::SimulatedManagers& Managers() noexcept
    {
        return managers_;
    }
    /// @brief In the order of the managers.
    [[nodiscard]] const std::vector<std::unique_ptr<GuardedManager>>& Guards() const noexcept
    {
        return guards_;
    }
    [[nodiscard]] const std::vector<Slave>& Slaves() const noexcept
    {
        return slaves_;
    }
    [[nodiscard]] FrameFault& Hit() noexcept
    {
        return fault_;
    }
    [[nodiscard]] Stranger& Somebody() noexcept
    {
        return *stranger_;
    }
    /// @brief The manager with this controller; null: it is none.
    [[nodiscard]] simulator::SimulatedManager* ManagerAt(host::NodeIndex bus_node) noexcept;
    /// @brief The device with this controller; null: it is none.
    [[nodiscard]] const Slave* SlaveAt(host::NodeIndex bus_node) const noexcept;
    /// @brief Node-ID of who has this controller, as "node 33".
    [[nodiscard]] std::string NameOf(host::NodeIndex bus_node) noexcept;
    /// @brief What the device has there now; nothing: it has no supply, or no such object.
    [[nodiscard]] std::optional<std::uint32_t> ValueIn(const Slave& slave, const ObjectAddress& object);
    [[nodiscard]] Nanoseconds End() const noexcept
    {
        return scenario_.duration;
    }

  private:
    void BuildManagers();
    void BuildSlaves();

    simulator::Scenario scenario_;
    simulator::Journal journal_{false};
    std::unique_ptr<simulator::Network> network_;
    simulator::SimulatedManagers managers_;
    std::vector<std::unique_ptr<GuardedManager>> guards_;
    std::unique_ptr<Stranger> stranger_;
    FrameFault fault_;
    std::vector<Slave> slaves_;
};
} // namespace counterpoint::campaign::managed

#endif // VERIFICATION_CAMPAIGN_MANAGED_STAGE_HPP
