// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/service_table.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint32_t kServices = 12U;
constexpr std::uint32_t kStates = 4U;

/// Row: service by number. Columns: INITIALISATION, PRE-OPERATIONAL, OPERATIONAL, STOPPED.
constexpr bool kTable[kServices][kStates] = {
    {false, false, false, false}, // none
    {false, false, true, false},  // PDO
    {false, false, true, false},  // SRDO
    {false, false, true, false},  // GFC
    {false, true, true, false},   // SDO
    {false, true, true, false},   // SYNC
    {false, true, true, false},   // TIME
    {false, true, true, false},   // EMCY
    {true, false, false, false},  // boot-up
    {false, true, true, true},    // heartbeat and guarding
    {false, true, true, true},    // NMT
    {false, true, true, true},    // LSS
};

std::uint32_t ColumnOf(const NodeState state) noexcept
{
    std::uint32_t column = kStates;
    switch (state)
    {
    case NodeState::kInitialising:
    case NodeState::kResetApplication:
    case NodeState::kResetCommunication:
        column = 0U;
        break;
    case NodeState::kPreOperational:
        column = 1U;
        break;
    case NodeState::kOperational:
        column = 2U;
        break;
    case NodeState::kStopped:
        column = 3U;
        break;
    case NodeState::kInvalid:
    default:
        break;
    }
    return column;
}

} // namespace

bool IsAllowed(const Service service, const NodeState state) noexcept
{
    const std::uint32_t row = static_cast<std::uint32_t>(service);
    const std::uint32_t column = ColumnOf(state);
    return (row < kServices) && (column < kStates) && kTable[row][column];
}

} // namespace counterpoint::cia301
