// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_FAULTS_FOREIGN_CONTROLLER_HPP
#define SIMULATOR_FAULTS_FOREIGN_CONTROLLER_HPP

#include "hal/host/virtual/bus.hpp"
#include "safety_core/contract/can_frame.hpp"

namespace counterpoint::simulator
{
/// A controller on the bus that belongs to a fault: it sends again what it hears (duplicate), or one frame after the
/// other (babbling). Like every controller it acknowledges what others send. [SRS_SIM_027]
class ForeignController final : private host::BusListener
{
  public:
    /// @brief `bus` outlives the controller, which hears what FrameFaults lets it hear.
    explicit ForeignController(host::VirtualBus& bus);

    /// @brief From now on it sends this frame again and again.
    void Babble(const CanFrame& frame);
    /// @brief It sends nothing more.
    void Stop() noexcept;

  private:
    void OnReceived(const CanFrame& frame, host::BusTime at) override;
    void OnConfirmed(const CanFrame& frame, host::BusTime at) override;

    host::VirtualBus& bus_;
    host::NodeIndex node_;
    CanFrame frame_{};
    bool is_babbling_{false};
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_FAULTS_FOREIGN_CONTROLLER_HPP
