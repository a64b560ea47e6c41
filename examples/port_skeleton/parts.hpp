// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_PORT_SKELETON_PARTS_HPP
#define EXAMPLES_PORT_SKELETON_PARTS_HPP

#include <cstdint>

namespace port_skeleton
{

/// What a port has to bring.
enum class Part : std::uint8_t
{
    kInvalid = 0U,
    kStartUp = 1U,
    kExceptions = 2U,
    kClocks = 3U,
    kCanPorts = 4U,
    kReception = 5U,
    kOutput = 6U,
    kCutOff = 7U,
    kWatchdog = 8U,
    kInterruptLock = 9U,
    kMemoryProtection = 10U, ///< A device without an MPU says kAbsent.
    kParameterMemory = 11U,  ///< A device that stores nothing says kAbsent.
    kCrossLink = 12U,        ///< A device with one CPU says kAbsent.
    kNone = 0x5AU,
};
constexpr std::uint8_t kLastPart = 12U;

/// How far a part is. Zero-filled memory is a part that is missing.
enum class PartState : std::uint8_t
{
    kMissing = 0U,
    kAbsent = 1U,   ///< This device does without it; its bodies go on refusing.
    kThere = 0x69U, ///< Written, and shown by the contract test on the board.
};

/// @brief The part as people call it.
[[nodiscard]] const char* NameOf(Part part) noexcept;

} // namespace port_skeleton

#endif
