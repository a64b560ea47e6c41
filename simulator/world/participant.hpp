// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_PARTICIPANT_HPP
#define SIMULATOR_WORLD_PARTICIPANT_HPP

#include "simulator/scenario/values.hpp"

#include "hal/host/virtual/bus.hpp"

namespace counterpoint::simulator
{
/// How long services take to answer a frame. It is longer than the intermission, so that a frame that waits in another
/// controller comes first.
[[nodiscard]] inline Nanoseconds ReactionTime(const host::VirtualBus& bus)
{
    constexpr Nanoseconds kBits = 3;
    constexpr Nanoseconds kMore = 100;
    return kBits * bus.BitDuration() + kMore;
}

/// Takes part in a network without being a device of the scenario: a manager, a defective device. It acts by itself;
/// what it hears of the bus comes to its listener there.
class Participant
{
  public:
    virtual ~Participant() = default;

    /// @brief The next instant at which it does something; kNever: nothing any more.
    [[nodiscard]] virtual Nanoseconds NextEvent() const noexcept = 0;
    /// @brief Does what is due at `now`; called after bus, world and devices have done what is due then.
    virtual void Run(Nanoseconds now) = 0;
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_PARTICIPANT_HPP
