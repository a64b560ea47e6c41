// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_SAFETY_CONTRADICTIONS_HPP
#define CANOPEN_CIA306_SAFETY_CONTRADICTIONS_HPP

#include "canopen/cia306/safety/safety_configuration.hpp"
#include "canopen/cia306/text/finding.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace counterpoint::cia306
{
/// An SRDO that is on, in a device of a network.
struct SrdoEnd
{
    std::size_t device{0U}; ///< Any number: one for each device.
    std::string name;       ///< Of the device.
    std::string file;
    const SrdoConfiguration* srdo{nullptr};
};

/// A place of a file that says another thing than another file of the same bus, or than the rest of its own.
struct Contradiction
{
    std::string file;
    Finding finding; ///< A warning.
};

/// @brief What the SRDOs of two devices that share an identifier say differently: the pair of identifiers, two
/// producers, the mapped length, an SCT that is not above the refresh time. In the order of the ends.
/// [SRS_MON_020, SRS_NET_060]
[[nodiscard]] std::vector<Contradiction> ContradictionsOf(const std::vector<SrdoEnd>& ends);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_SAFETY_CONTRADICTIONS_HPP
