// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_ELECTIONS_NODE_CLOCK_HPP
#define VERIFICATION_ELECTIONS_NODE_CLOCK_HPP

#include "verification/elections/world_plan.hpp"

namespace counterpoint::elections
{

/// The clock of a node, which goes faster or slower than that of the world, and the beats of its cycle.
class NodeClock
{
  public:
    NodeClock() = default;
    NodeClock(const MasterPlan& plan, Time cycle);
    /// @brief By the node's own clock.
    [[nodiscard]] Time LocalOf(Time at) const;
    /// @brief First instant of the world at which the node's clock shows `local`.
    [[nodiscard]] Time WorldOf(Time local) const;
    [[nodiscard]] Instant Stamp(Time at) const;
    /// @brief Its first cycle at `at` or later.
    [[nodiscard]] Time TickFrom(Time at) const;

  private:
    Time ppm_{0};
    Time phase_{0};
    Time cycle_{kMs};
    std::uint32_t begin_{0U};
};

} // namespace counterpoint::elections

#endif
