// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_NETWORK_PLAN_ROW_TIMES_HPP
#define CANOPEN_NETWORK_PLAN_ROW_TIMES_HPP

#include "canopen/network_plan/network_plan.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::network_plan
{
/// What the rows of the EL6751 profile make of guard time and life time factor.
struct RowTimes
{
    std::uint32_t life_ms;    ///< As they say.
    std::uint32_t watched_ms; ///< As 1016h can hold.
};

/// @brief Whether those rows say how the slave is supervised.
[[nodiscard]] bool HasRows(const cia302::SlaveSetup& setup);

/// @brief The times of a slave that HasRows.
[[nodiscard]] RowTimes RowTimesOf(const cia302::SlaveSetup& setup);

/// @brief What is to be told of a slave that is lost before or after the time that is asked for; empty: nothing.
/// [SRS_NET_230, SRS_NET_751]
[[nodiscard]] std::string OtherTimeText(const SlavePlan& slave, const cia302::SlaveSetup& setup);

/// @brief What is to be told of heartbeat and consumer of a slave where the rows say something else. [SRS_NET_752]
[[nodiscard]] std::vector<std::string> UnusedBesideRows(const SlavePlan& slave, const cia302::SlaveSetup& setup);
} // namespace counterpoint::network_plan

#endif // CANOPEN_NETWORK_PLAN_ROW_TIMES_HPP
