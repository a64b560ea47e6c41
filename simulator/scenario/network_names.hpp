// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_SCENARIO_NETWORK_NAMES_HPP
#define SIMULATOR_SCENARIO_NETWORK_NAMES_HPP

#include "simulator/scenario/schema.hpp"

#include <cstdint>
#include <string>

// The words of scenarios with managers. [SRS_MGR_012]
namespace counterpoint::simulator
{
enum class NetworkActionKind : std::uint8_t
{
    kPull = 1U,
    kInsert,
    kReset, ///< Its supply blinks: nobody commanded it.
    kReplace,
    kDuplicate,
    kEmcyStorm,
    kBabble,
    kOrder,
    kKillManager,
    kStore,
    kAcknowledge,
    kSend,         ///< A frame of somebody else.
    kBusOff,       ///< The manager's controller.
    kNoController, ///< Of the manager.
    kBusBack,      ///< Its end, made from both.
};

enum class NetworkExpectationKind : std::uint8_t
{
    kState = 1U, ///< As the manager knows it.
    kDevice,     ///< As it is.
    kLetter,
    kCode,
    kGate,
    kFinding,
    kOutput,
    kEvent,
    kNoEvent,
    kActive,
    kFlying,
};

inline constexpr Word<NetworkActionKind> kNetworkActionWords[] = {
    {"pull", NetworkActionKind::kPull},
    {"insert", NetworkActionKind::kInsert},
    {"reset", NetworkActionKind::kReset},
    {"replace", NetworkActionKind::kReplace},
    {"duplicate", NetworkActionKind::kDuplicate},
    {"emcy_storm", NetworkActionKind::kEmcyStorm},
    {"babble", NetworkActionKind::kBabble},
    {"order", NetworkActionKind::kOrder},
    {"kill_manager", NetworkActionKind::kKillManager},
    {"store", NetworkActionKind::kStore},
    {"acknowledge", NetworkActionKind::kAcknowledge},
    {"send", NetworkActionKind::kSend},
    {"bus_off", NetworkActionKind::kBusOff},
    {"no_controller", NetworkActionKind::kNoController},
};

inline constexpr Word<NetworkExpectationKind> kNetworkExpectationWords[] = {
    {"state", NetworkExpectationKind::kState},      {"device", NetworkExpectationKind::kDevice},
    {"letter", NetworkExpectationKind::kLetter},    {"code", NetworkExpectationKind::kCode},
    {"gate", NetworkExpectationKind::kGate},        {"finding", NetworkExpectationKind::kFinding},
    {"output", NetworkExpectationKind::kOutput},    {"event", NetworkExpectationKind::kEvent},
    {"no_event", NetworkExpectationKind::kNoEvent}, {"active", NetworkExpectationKind::kActive},
    {"flying", NetworkExpectationKind::kFlying},
};

/// What may be found; a word stands for itself.
struct FoundWord
{
    const char* text;
};

inline constexpr FoundWord kFoundStates[] = {
    {"unknown"}, {"missing"}, {"stopped"}, {"operational"}, {"pre-operational"}};
inline constexpr FoundWord kFoundDevices[] = {
    {"absent"}, {"initialising"}, {"pre-operational"}, {"operational"}, {"stopped"}};
inline constexpr FoundWord kFoundLetters[] = {{"none"}, {"A"}, {"B"}, {"C"}, {"D"}, {"E"}, {"F"}, {"G"},
                                              {"H"},    {"I"}, {"J"}, {"K"}, {"L"}, {"M"}, {"N"}, {"O"}};
inline constexpr FoundWord kFoundGates[] = {{"closed"}, {"busy"}, {"differs"}, {"failed"}, {"open"}};
inline constexpr FoundWord kFoundOutputs[] = {{"open"}, {"closed"}};
/// What a manager tells, as in its log.
inline constexpr FoundWord kFoundEvents[] = {{"boot_up"},      {"supervision_started"},
                                             {"state"},        {"heartbeat_lost"},
                                             {"guard_lost"},   {"guard_missed"},
                                             {"toggle_error"}, {"never_seen"},
                                             {"unexpected"},   {"status"},
                                             {"master"},       {"nmt"},
                                             {"gate"},         {"emergency"},
                                             {"duplicate"},    {"flying_master"},
                                             {"order"},        {"write_safety"},
                                             {"pdo"},          {"bus"}};

/// What begins the names of the sections of these scenarios.
inline constexpr char kNetworkPrefix[] = "network.";
} // namespace counterpoint::simulator

#endif // SIMULATOR_SCENARIO_NETWORK_NAMES_HPP
