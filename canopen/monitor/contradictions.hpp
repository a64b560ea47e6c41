// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_MONITOR_CONTRADICTIONS_HPP
#define CANOPEN_MONITOR_CONTRADICTIONS_HPP

#include "canopen/monitor/network.hpp"

#include "canopen/cia306/safety/contradictions.hpp"

#include <vector>

namespace counterpoint::monitor
{
using cia306::Contradiction;

/// @brief What the SRDOs of two devices that share an identifier say differently: the pair of identifiers, two
/// producers, the mapped length, an SCT that is not above the refresh time; SRDOs that are set up where 13FEh is not
/// A5h; and active ones whose signature is another than that of their parameters. In the order of the files.
/// [SRS_MON_020, SRS_MON_021, SRS_MON_400]
[[nodiscard]] std::vector<Contradiction> ContradictionsOf(const Network& network);
} // namespace counterpoint::monitor

#endif // CANOPEN_MONITOR_CONTRADICTIONS_HPP
