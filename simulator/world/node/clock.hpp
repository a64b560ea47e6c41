// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_NODE_CLOCK_HPP
#define SIMULATOR_WORLD_NODE_CLOCK_HPP

#include "simulator/scenario/scenario.hpp"

#include "hal/host/clocks.hpp"
#include "hal/host/virtual/bus.hpp"
#include "safety_core/contract/can_frame.hpp"

#include <cstdint>

namespace counterpoint::simulator
{
/// The two counters of a node, and when its cycles come by its oscillator. [SRS_SIM_004]
class NodeClock
{
  public:
    /// @brief The bus and the setup outlive it. The first cycle comes at the phase of the setup.
    NodeClock(const host::VirtualBus& bus, const NodeSetup& setup, std::uint32_t cycle_us);

    /// @brief kNever: there is no supply.
    [[nodiscard]] Nanoseconds NextCycle() const noexcept
    {
        return next_cycle_;
    }
    /// @brief Whole nanoseconds of a cycle.
    [[nodiscard]] Nanoseconds CycleTime() const noexcept
    {
        return cycle_ns_;
    }
    /// @brief Cycles begin now: the first one is a cycle time away.
    void Begin() noexcept;
    void Advance() noexcept;
    void Stop() noexcept
    {
        next_cycle_ = kNever;
    }
    /// @brief The next cycle, and all after it, come so much later (negative: earlier).
    void Shift(Nanoseconds by) noexcept;

    void SetRate(bool is_counter_a, std::int32_t drift_ppm);
    void Jump(bool is_counter_a, Nanoseconds by);
    /// @brief Both counters begin again.
    void RestartCounters();
    [[nodiscard]] host::HostClocks& Counters() noexcept
    {
        return counters_;
    }
    [[nodiscard]] InstantPair Instants() noexcept;
    [[nodiscard]] StampedFrame Stamped(const StampedFrame& frame) const noexcept;

  private:
    const host::VirtualBus& bus_;
    const NodeSetup& setup_;
    host::HostClocks counters_;
    bool is_one_of_two_; ///< CPUs: it has one counter, the second one is the other CPU's.
    std::int64_t oscillator_;
    Nanoseconds cycle_ns_;
    std::int64_t cycle_fraction_; ///< The rest of a cycle, in parts of `oscillator_`.
    std::int64_t fraction_sum_{0};
    Nanoseconds next_cycle_;
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_NODE_CLOCK_HPP
