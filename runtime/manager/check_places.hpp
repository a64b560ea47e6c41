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
/// The key of a network file that decides a compared value: of a slave, or of the manager (node 0), the keys of
/// `flying` included.
struct CheckedKey
{
    std::uint8_t node{0U};
    std::string key; ///< Empty: the slave or manager as such.
};

/// @brief The key for the object of a finding.
[[nodiscard]] CheckedKey KeyOf(const cia302::FlyingFinding& finding);
/// @brief FILE:LINE of a key. Where the file does not have the key: of `dcf`, from which the value came then, or of the
/// slave or manager.
[[nodiscard]] std::string PlaceOf(const network_plan::LoadedNetwork& net, const CheckedKey& key);
/// @brief What does not work between these masters although their configurations agree, a line each: a consumer time
/// that is not longer than the heartbeat of the watched master; standbys that race, or masters that ignore 071h, beside
/// one that sends 072h each cycle. O(masters^2) [SRS_MGR_009]
[[nodiscard]] std::vector<std::string> ProblemsTogether(const std::vector<const network_plan::LoadedNetwork*>& masters);
} // namespace counterpoint::runtime

#endif // RUNTIME_MANAGER_CHECK_PLACES_HPP
