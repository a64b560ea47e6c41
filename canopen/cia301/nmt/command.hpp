// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_NMT_COMMAND_HPP
#define CANOPEN_CIA301_NMT_COMMAND_HPP

#include <cstdint>

namespace counterpoint::cia301
{

/// NMT commands by their command specifier, the first byte of the frame.
enum class NmtCommand : std::uint8_t
{
    kInvalid = 0U,
    kStart = 1U,
    kStop = 2U,
    kPreOperational = 128U,
    kResetNode = 129U,
    kResetCommunication = 130U,
};

/// @brief Whether this is one of the five commands; a byte from the bus may have any value.
[[nodiscard]] constexpr bool IsNmtCommand(const NmtCommand command) noexcept
{
    return (command == NmtCommand::kStart) || (command == NmtCommand::kStop) ||
           (command == NmtCommand::kPreOperational) || (command == NmtCommand::kResetNode) ||
           (command == NmtCommand::kResetCommunication);
}

} // namespace counterpoint::cia301

#endif
