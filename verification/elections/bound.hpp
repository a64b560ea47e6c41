// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_ELECTIONS_BOUND_HPP
#define VERIFICATION_ELECTIONS_BOUND_HPP

#include "verification/elections/world.hpp"

#include <vector>

namespace counterpoint::elections
{

/// How long elections may last, from 1F90h alone; the runs are held against these.
struct Bound
{
    Time detection;      ///< 1F90h:02 + 1F90h:01.
    Time greatest_slot;  ///< Longest waiting of all masters.
    Time least_slot;     ///< Shortest one.
    Time greatest_cycle; ///< Largest 1F90h:06.
    Time slack;          ///< Cycles and frames of the steps of one negotiation.

    /// @brief From the last power-on, at worst: its detection ends in the instant in which another one becomes master,
    /// which ignores the reset; the next detection finds it and forces; detection and race of all.
    [[nodiscard]] Time FromPowerOn() const
    {
        return (3 * detection) + least_slot + slack;
    }
    /// @brief One detection and one race. A lost frame costs one more of these.
    [[nodiscard]] Time Negotiation() const
    {
        return detection + greatest_slot + slack;
    }
    /// @brief From the joining of two parts of a bus: the cyclic message, then as with a device that joins.
    [[nodiscard]] Time FromJoin() const
    {
        return greatest_cycle + FromPowerOn();
    }
    /// @brief Two active masters on one bus.
    [[nodiscard]] Time TwoMasters() const
    {
        return greatest_cycle + Negotiation();
    }
    /// @brief From the last heartbeat that standbys heard of a master.
    [[nodiscard]] Time Failover(const Time watch) const
    {
        return watch + detection + least_slot;
    }
};

[[nodiscard]] Bound BoundOf(const std::vector<MasterPlan>& masters, Time bit_us);

} // namespace counterpoint::elections

#endif
