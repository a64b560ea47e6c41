// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "board.hpp"

#include "exceptions.hpp"
#include "start_up.hpp"

namespace port_skeleton
{

const char* NameOf(const Part part) noexcept
{
    constexpr const char* kNames[kLastPart + 1U]{
        "no part",           "start-up",         "exceptions", "clocks",   "CAN ports",
        "reception",         "output",           "cut-off",    "watchdog", "interrupt lock",
        "memory protection", "parameter memory", "cross link"};
    const std::uint8_t number = static_cast<std::uint8_t>(part);
    return (number <= kLastPart) ? kNames[number] : kNames[0];
}

PartState Board::StateOf(const Part part) const noexcept
{
    switch (part)
    {
    case Part::kStartUp:
        return StateOfStartUp();
    case Part::kExceptions:
        return StateOfExceptions();
    case Part::kClocks:
        return clocks.State();
    case Part::kCanPorts:
        return can.State();
    case Part::kReception:
        return can.StateOfReception();
    case Part::kOutput:
        return output.State();
    case Part::kCutOff:
        return output.StateOfCutOff();
    case Part::kWatchdog:
        return watchdog.State();
    case Part::kInterruptLock:
        return lock.State();
    case Part::kMemoryProtection:
        return protection.State();
    case Part::kParameterMemory:
        return parameters.State();
    case Part::kCrossLink:
        return link.State();
    case Part::kInvalid:
    case Part::kNone:
    default:
        return PartState::kMissing;
    }
}

Part Board::FirstMissing() const noexcept
{
    for (std::uint8_t number = 1U; number <= kLastPart; ++number)
    {
        const Part part = static_cast<Part>(number);
        const PartState state = StateOf(part);
        const bool is_waived = (state == PartState::kAbsent) && IsOptional(part);
        if ((state != PartState::kThere) && !is_waived)
        {
            return part;
        }
    }
    return Part::kNone;
}

bool Board::IsOptional(const Part part) noexcept
{
    return (part == Part::kMemoryProtection) || (part == Part::kParameterMemory) || (part == Part::kCrossLink);
}

} // namespace port_skeleton
