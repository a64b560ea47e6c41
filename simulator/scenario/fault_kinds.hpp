// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_SCENARIO_FAULT_KINDS_HPP
#define SIMULATOR_SCENARIO_FAULT_KINDS_HPP

#include "safety_core/kernel/limits.hpp"

#include <cstdint>

// What kinds of faults there are: each is a number and a row here. Its keys are a section of schema_faults.cpp.
namespace counterpoint::simulator
{
/// The kinds of faults; their meanings are in the sections of schema_faults.cpp.
enum class FaultKind : std::uint8_t
{
    kCorruption = 1U,
    kRepetition = 2U,
    kWrongSequence = 3U,
    kLoss = 4U,
    kDelay = 5U,
    kInsertion = 6U,
    kMasquerade = 7U,
    kAddressing = 8U,
    kBitFlip = 9U,
    kSkipped = 10U,
    kDoubled = 11U,
    kHung = 12U,
    kFrozen = 13U,
    kNotCalled = 14U,
    kAlwaysGood = 15U,
    kClock = 16U,
    kCycle = 17U,
    kNotInverse = 18U,
    kStoreAndForward = 19U,
    kDuplicate = 20U,
    kBabbling = 21U,
    kWireError = 22U,
    kBusOff = 23U,
    kUnplugged = 24U,
    kQueueFull = 25U,
    kSwallowed = 26U,
    kConfirmation = 27U,
    kQueueOverflow = 28U,
    kFrozenInput = 29U,
    kPermit = 30U,
    kWatchdog = 31U,
    kStuckBit = 32U,
    kStandstill = 33U,
    kLinkLoss = 34U,
    kLinkDelay = 35U,
    kLinkRepetition = 36U,
    kLinkReordering = 37U,
    kLinkCorruption = 38U,
    kLinkInsertion = 39U,
    kLinkCut = 40U,
};

/// Where a kind of fault takes hold.
enum class FaultSite : std::uint8_t
{
    kReceptions = 1U, ///< Frames on their way to receivers: FrameFaults.
    kController = 2U, ///< Frames in the sender's controller: ControllerFaults.
    kForeign = 3U,    ///< Frames of nobody: NetworkFaults.
    kNode = 4U,       ///< A part, the memory, a clock or a controller of a node: NetworkFaults.
    kLink = 5U,       ///< Messages between two CPUs: LinkWire.
};

/// One kind of fault.
struct FaultKindRow
{
    const char* text;
    FaultKind meaning;
    FaultSite site;
    /// The row of the table of limits: of a fault that hits a normal frame, a channel, or what the output stage and the
    /// watchdog ask; and of all others.
    FaultClass limit;
    FaultClass other_limit;
};

inline constexpr FaultKindRow kFaultKinds[] = {
    {"corruption", FaultKind::kCorruption, FaultSite::kReceptions, FaultClass::kWrongFrame, FaultClass::kWrongFrame},
    {"repetition", FaultKind::kRepetition, FaultSite::kReceptions, FaultClass::kWrongFrame, FaultClass::kWrongFrame},
    {"wrong_sequence", FaultKind::kWrongSequence, FaultSite::kReceptions, FaultClass::kWrongFrame,
     FaultClass::kWrongFrame},
    {"loss", FaultKind::kLoss, FaultSite::kReceptions, FaultClass::kBus, FaultClass::kBusNextNormal},
    {"delay", FaultKind::kDelay, FaultSite::kReceptions, FaultClass::kBus, FaultClass::kBusNextNormal},
    {"insertion", FaultKind::kInsertion, FaultSite::kForeign, FaultClass::kBusNextNormal, FaultClass::kWrongFrame},
    {"masquerade", FaultKind::kMasquerade, FaultSite::kForeign, FaultClass::kBusNextNormal, FaultClass::kWrongFrame},
    {"addressing", FaultKind::kAddressing, FaultSite::kReceptions, FaultClass::kBus, FaultClass::kBusNextNormal},
    {"bit_flip", FaultKind::kBitFlip, FaultSite::kNode, FaultClass::kConfiguration, FaultClass::kConfiguration},
    {"skipped", FaultKind::kSkipped, FaultSite::kNode, FaultClass::kChannel, FaultClass::kSupervisor},
    {"doubled", FaultKind::kDoubled, FaultSite::kNode, FaultClass::kChannel, FaultClass::kSupervisor},
    {"hung", FaultKind::kHung, FaultSite::kNode, FaultClass::kChannel, FaultClass::kSupervisor},
    {"frozen", FaultKind::kFrozen, FaultSite::kNode, FaultClass::kChannel, FaultClass::kSupervisor},
    {"not_called", FaultKind::kNotCalled, FaultSite::kNode, FaultClass::kChannel, FaultClass::kSupervisor},
    {"always_good", FaultKind::kAlwaysGood, FaultSite::kNode, FaultClass::kChannel, FaultClass::kSupervisor},
    {"clock", FaultKind::kClock, FaultSite::kNode, FaultClass::kClock, FaultClass::kClock},
    {"cycle", FaultKind::kCycle, FaultSite::kNode, FaultClass::kClock, FaultClass::kClock},
    {"not_inverse", FaultKind::kNotInverse, FaultSite::kNode, FaultClass::kBus, FaultClass::kBus},
    {"store_and_forward", FaultKind::kStoreAndForward, FaultSite::kReceptions, FaultClass::kBus,
     FaultClass::kBusNextNormal},
    {"duplicate", FaultKind::kDuplicate, FaultSite::kReceptions, FaultClass::kBusNextNormal, FaultClass::kWrongFrame},
    {"babbling", FaultKind::kBabbling, FaultSite::kForeign, FaultClass::kBus, FaultClass::kBus},
    {"wire_error", FaultKind::kWireError, FaultSite::kController, FaultClass::kBus, FaultClass::kBus},
    {"bus_off", FaultKind::kBusOff, FaultSite::kNode, FaultClass::kBus, FaultClass::kBus},
    {"unplugged", FaultKind::kUnplugged, FaultSite::kNode, FaultClass::kBus, FaultClass::kBus},
    {"queue_full", FaultKind::kQueueFull, FaultSite::kController, FaultClass::kBus, FaultClass::kBusNextNormal},
    {"swallowed", FaultKind::kSwallowed, FaultSite::kController, FaultClass::kBus, FaultClass::kBusNextNormal},
    {"confirmation", FaultKind::kConfirmation, FaultSite::kController, FaultClass::kBus, FaultClass::kBus},
    {"queue_overflow", FaultKind::kQueueOverflow, FaultSite::kNode, FaultClass::kWrongFrame, FaultClass::kWrongFrame},
    {"frozen_input", FaultKind::kFrozenInput, FaultSite::kNode, FaultClass::kSupervisor, FaultClass::kBus},
    {"permit", FaultKind::kPermit, FaultSite::kNode, FaultClass::kSupervisor, FaultClass::kSupervisor},
    {"watchdog", FaultKind::kWatchdog, FaultSite::kNode, FaultClass::kSupervisor, FaultClass::kSupervisor},
    {"stuck_bit", FaultKind::kStuckBit, FaultSite::kNode, FaultClass::kConfiguration, FaultClass::kConfiguration},
    {"standstill", FaultKind::kStandstill, FaultSite::kNode, FaultClass::kSupervisor, FaultClass::kSupervisor},
    {"link_loss", FaultKind::kLinkLoss, FaultSite::kLink, FaultClass::kCrossLink, FaultClass::kCrossLink},
    {"link_delay", FaultKind::kLinkDelay, FaultSite::kLink, FaultClass::kCrossLink, FaultClass::kCrossLink},
    {"link_repetition", FaultKind::kLinkRepetition, FaultSite::kLink, FaultClass::kCrossLink, FaultClass::kCrossLink},
    {"link_reordering", FaultKind::kLinkReordering, FaultSite::kLink, FaultClass::kCrossLink, FaultClass::kCrossLink},
    {"link_corruption", FaultKind::kLinkCorruption, FaultSite::kLink, FaultClass::kCrossLink, FaultClass::kCrossLink},
    {"link_insertion", FaultKind::kLinkInsertion, FaultSite::kLink, FaultClass::kCrossLink, FaultClass::kCrossLink},
    {"link_cut", FaultKind::kLinkCut, FaultSite::kLink, FaultClass::kCrossLink, FaultClass::kCrossLink},
};

/// The row of a kind; each has one.
[[nodiscard]] constexpr const FaultKindRow& RowOf(const FaultKind kind)
{
    const FaultKindRow* found = kFaultKinds;
    for (const FaultKindRow& row : kFaultKinds)
    {
        found = (row.meaning == kind) ? &row : found;
    }
    return *found;
}
} // namespace counterpoint::simulator

#endif // SIMULATOR_SCENARIO_FAULT_KINDS_HPP
