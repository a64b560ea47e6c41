// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_SERVICE_TABLE_HPP
#define CANOPEN_CIA301_SERVICE_TABLE_HPP

#include "canopen/cia301/nmt_slave.hpp"

#include <cstdint>

namespace counterpoint::cia301
{

enum class Service : std::uint8_t
{
    kInvalid = 0U,
    kPdo = 1U,
    kSrdo = 2U,
    kGfc = 3U,
    kSdo = 4U,
    kSync = 5U,
    kTime = 6U,
    kEmergency = 7U,
    kBootUp = 8U,
    kErrorControl = 9U,
    kNmt = 10U,
    kLss = 11U,
};

/// @brief Whether a service is allowed in a state. O(1) [SRS-NMT-006]
[[nodiscard]] bool IsAllowed(Service service, NodeState state) noexcept;

} // namespace counterpoint::cia301

#endif
