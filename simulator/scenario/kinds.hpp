// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_SCENARIO_KINDS_HPP
#define SIMULATOR_SCENARIO_KINDS_HPP

#include <cstddef>
#include <cstdint>

// The enumerations of scenarios; their words are in names.hpp. Kinds of faults are in fault_kinds.hpp.
namespace counterpoint::simulator
{
/// The part of a node that a fault hits.
enum class Part : std::uint8_t
{
    kNone = 0U,
    kChannelA = 1U,
    kChannelB = 2U,
    kComparator = 3U,
    kFlowMonitor = 4U,
    kGuard = 5U,
    // Inputs, the last link, and what only bits flip in.
    kAcknowledgeA = 6U,
    kAcknowledgeB = 7U,
    kApplication = 8U,
    kChallenge = 9U,
    kQuestion = 10U,
    kPermitA = 11U,
    kPermitB = 12U,
    kPermitKernel = 13U,
    kWatchdog = 14U,
    kKernel = 15U,
    kLatch = 16U,
    kClocks = 17U,
    kSetup = 18U,
    kSafeValue = 19U,
    kObjects = 20U,
    kVariables = 21U,
    // What the self tests watch, they themselves, and the last links as chips.
    kSelfTest = 22U,
    kOutputGate = 23U,
    kWatchdogChip = 24U,
    kProgram = 25U,
    kConstants = 26U,
    kStackGuard = 27U,
    kTablePointer = 28U,
};
constexpr std::size_t kPartCount = 29U;

/// How a permit, an answer to the watchdog or a confirmation is wrong.
enum class Wrongness : std::uint8_t
{
    kNone = 0U,
    kWrong = 1U,
    kOld = 2U,
    kMissing = 3U,
    kTwice = 4U,
    kLate = 5U,
};

/// Calls of a channel that can be skipped or doubled.
enum class ChannelCall : std::uint8_t
{
    kOnCycle = 1U,
    kOnFrame = 2U,
};

/// What an expectation is about.
enum class ExpectationKind : std::uint8_t
{
    kReleased = 1U,
    kSafe = 2U,
    kValue = 3U,
    kCause = 4U,
    kDeviceFault = 5U,
    kDetectedBy = 6U,
    kSafeWithin = 7U,
    kNoFault = 8U,
    // Of networks with managers.
    kState = 9U,   ///< As the manager knows it.
    kDevice = 10U, ///< As it is.
    kLetter = 11U,
    kCode = 12U,
    kGate = 13U,
    kFinding = 14U,
    kOutput = 15U,
    kEvent = 16U,
    kNoEvent = 17U,
    kActive = 18U,
    kFlying = 19U,
};

/// What happens to the devices and managers of a network, and what somebody else sends.
enum class ActionKind : std::uint8_t
{
    kPull = 1U,
    kInsert = 2U,
    kReset = 3U, ///< Its supply blinks: nobody commanded it.
    kReplace = 4U,
    kDuplicate = 5U,
    kEmcyStorm = 6U,
    kBabble = 7U,
    kOrder = 8U,
    kKillManager = 9U,
    kStore = 10U,
    kAcknowledge = 11U,
    kSend = 12U,         ///< A frame of somebody else.
    kBusOff = 13U,       ///< The manager's controller.
    kNoController = 14U, ///< Of the manager.
    kBusBack = 15U,      ///< Its end, made from both.
};

/// Who can find a fault.
enum class Party : std::uint8_t
{
    kNobody = 0U,
    kChannels = 1U, ///< Both channels in the same cycle.
    kChannelA = 2U,
    kChannelB = 3U,
    kComparator = 4U,
    kKernel = 5U, ///< By the comparator's echo and its negative test.
    kFlowMonitor = 6U,
    kWatchdog = 7U,
    kOutputGate = 8U,
    kClockSupervisor = 9U,
    kGuard = 10U,
    kSelfTest = 11U,
    kCrossLink = 12U,
};

/// Whether the action happens to a manager, which is named by its node-ID; 0: the first one.
[[nodiscard]] constexpr bool IsOfManager(const ActionKind kind)
{
    return kind == ActionKind::kOrder || kind == ActionKind::kKillManager || kind == ActionKind::kBusOff ||
           kind == ActionKind::kNoController || kind == ActionKind::kBusBack;
}

/// Whether the action sends frames of somebody else.
[[nodiscard]] constexpr bool IsStorm(const ActionKind kind)
{
    return kind == ActionKind::kEmcyStorm || kind == ActionKind::kBabble || kind == ActionKind::kSend;
}

/// Whether the action happens to a device.
[[nodiscard]] constexpr bool IsOfDevice(const ActionKind kind)
{
    return !IsOfManager(kind) && !IsStorm(kind);
}

/// Whether the expectation asks a manager, not a device.
[[nodiscard]] constexpr bool IsOfManager(const ExpectationKind kind)
{
    return kind >= ExpectationKind::kState && kind != ExpectationKind::kDevice && kind != ExpectationKind::kOutput;
}

/// Whether the expectation needs a network with managers.
[[nodiscard]] constexpr bool IsOfNetwork(const ExpectationKind kind)
{
    return kind >= ExpectationKind::kState;
}

/// Whether the expectation looks at what a manager told within a window of time.
[[nodiscard]] constexpr bool IsOfEvents(const ExpectationKind kind)
{
    return kind == ExpectationKind::kEvent || kind == ExpectationKind::kNoEvent;
}
} // namespace counterpoint::simulator

#endif // SIMULATOR_SCENARIO_KINDS_HPP
