// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_STORM_HPP
#define SIMULATOR_WORLD_STORM_HPP

#include "simulator/scenario/scenario.hpp"
#include "simulator/world/participant.hpp"

#include "hal/host/virtual/bus.hpp"

namespace counterpoint::simulator
{
/// Somebody else on the bus who sends one frame, or one after the other: the events emcy_storm, babble and send.
/// [SRS_MGR_155]
class Storm final : public Participant, private host::BusListener
{
  public:
    /// @brief Both outlive it.
    Storm(const Action& action, host::VirtualBus& bus);

    /// @brief Its controller on the bus.
    [[nodiscard]] host::NodeIndex BusNode() const noexcept
    {
        return node_;
    }
    [[nodiscard]] Nanoseconds NextEvent() const noexcept override
    {
        return next_;
    }
    void Run(Nanoseconds now) override;

  private:
    void OnReceived(const CanFrame& frame, host::BusTime at) override;
    void OnConfirmed(const CanFrame& frame, host::BusTime at) override;

    const Action& action_;
    host::VirtualBus& bus_;
    host::NodeIndex node_;
    Nanoseconds next_;
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_STORM_HPP
