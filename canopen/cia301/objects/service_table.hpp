// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_OBJECTS_SERVICE_TABLE_HPP
#define CANOPEN_CIA301_OBJECTS_SERVICE_TABLE_HPP

#include "canopen/cia301/nmt/slave.hpp"

#include <cstdint>

namespace counterpoint::cia301
{

/// The services whose use depends on the NMT state (CiA 301, table of services by state).
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

namespace service_table
{
/// A set of states has bit n for NodeState n.
constexpr std::uint32_t StateBit(const NodeState state) noexcept
{
    return std::uint32_t{1U} << static_cast<std::uint32_t>(state);
}
constexpr std::uint32_t kStarting = StateBit(NodeState::kInitialising) | StateBit(NodeState::kResetApplication) |
                                    StateBit(NodeState::kResetCommunication);
constexpr std::uint32_t kRunning = StateBit(NodeState::kOperational);
constexpr std::uint32_t kReady = StateBit(NodeState::kPreOperational) | kRunning;
constexpr std::uint32_t kAlive = kReady | StateBit(NodeState::kStopped);

/// The states of each service, by its number.
constexpr std::uint32_t kServiceStates[] = {
    0U,        // none
    kRunning,  // PDO
    kRunning,  // SRDO
    kRunning,  // GFC
    kReady,    // SDO
    kReady,    // SYNC
    kReady,    // TIME
    kReady,    // EMCY
    kStarting, // boot-up
    kAlive,    // heartbeat and guarding
    kAlive,    // NMT
    kAlive,    // LSS
};
constexpr std::uint32_t kServiceCount = sizeof(kServiceStates) / sizeof(kServiceStates[0]);
constexpr std::uint32_t kStateBits = 32U;
} // namespace service_table

/// @brief Whether a service is allowed in a state. O(1) [SRS_NMT_006]
[[nodiscard]] constexpr bool IsAllowed(const Service service, const NodeState state) noexcept
{
    const auto row = static_cast<std::uint32_t>(service);
    const auto place = static_cast<std::uint32_t>(state);
    return (row < service_table::kServiceCount) && (place < service_table::kStateBits) &&
           (((service_table::kServiceStates[row] >> place) & 1U) != 0U);
}

} // namespace counterpoint::cia301

#endif
