// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_MANAGER_CHECK_PLACES_HPP
#define RUNTIME_MANAGER_CHECK_PLACES_HPP

#include "canopen/cia302/flying_master/compare.hpp"
#include "canopen/network_plan/loaded_network.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// What decides a value that was compared: a key of a slave, or of the manager (node 0), `flying` included.
struct CheckedKey
{
    std::uint8_t node{0U};
    std::string key; ///< Empty: the slave or manager as such.
};

/// @brief The key that stands for the object of a finding.
[[nodiscard]] CheckedKey KeyOf(const cia302::FlyingFinding& finding);
/// @brief FILE:LINE of a key; where the file does not have it, of `dcf`, from which it came then, or of the slave or
/// manager.
[[nodiscard]] std::string PlaceOf(const network_plan::LoadedNetwork& net, const CheckedKey& key);
/// @brief What does not work between these masters though their configurations are equal, a line each: supervision of
/// a master that is not longer than its heartbeat, standbys that race and masters that ignore 071h beside one that
/// sends 072h each cycle. O(masters^2) [SRS_MGR_009]
[[nodiscard]] std::vector<std::string> ProblemsTogether(const std::vector<const network_plan::LoadedNetwork*>& masters);
} // namespace counterpoint::runtime

#endif // RUNTIME_MANAGER_CHECK_PLACES_HPP
