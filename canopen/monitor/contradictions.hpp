// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_MONITOR_CONTRADICTIONS_HPP
#define CANOPEN_MONITOR_CONTRADICTIONS_HPP

#include "canopen/monitor/network.hpp"

#include "canopen/cia306/text/finding.hpp"

#include <string>
#include <vector>

namespace counterpoint::monitor
{
/// A place of a file that says another thing than another file of the same bus, or than the rest of its own.
struct Contradiction
{
    std::string file;
    cia306::Finding finding; ///< A warning.
};

/// @brief What the SRDOs of two devices that share an identifier say differently: the pair of identifiers, two
/// producers, the mapped length, an SCT that is not above the refresh time; and SRDOs that are set up where 13FEh is
/// not A5h. In the order of the files. [SRS_MON_020, SRS_MON_021]
[[nodiscard]] std::vector<Contradiction> ContradictionsOf(const Network& network);
} // namespace counterpoint::monitor

#endif // CANOPEN_MONITOR_CONTRADICTIONS_HPP
