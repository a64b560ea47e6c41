// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_SCENARIO_NETWORK_NAMES_HPP
#define SIMULATOR_SCENARIO_NETWORK_NAMES_HPP

#include "simulator/scenario/kinds.hpp"
#include "simulator/scenario/schema.hpp"

#include <cstdint>
#include <string>

// The words of networks with managers. [SRS_MGR_155]
namespace counterpoint::simulator
{
inline constexpr Word<ActionKind> kActionWords[] = {
    {"pull", ActionKind::kPull},
    {"insert", ActionKind::kInsert},
    {"reset", ActionKind::kReset},
    {"replace", ActionKind::kReplace},
    {"duplicate", ActionKind::kDuplicate},
    {"emcy_storm", ActionKind::kEmcyStorm},
    {"babble", ActionKind::kBabble},
    {"order", ActionKind::kOrder},
    {"kill_manager", ActionKind::kKillManager},
    {"store", ActionKind::kStore},
    {"acknowledge", ActionKind::kAcknowledge},
    {"send", ActionKind::kSend},
    {"bus_off", ActionKind::kBusOff},
    {"no_controller", ActionKind::kNoController},
};

/// A word that an expectation compares as it is.
struct FoundWord
{
    const char* text;
};

inline constexpr FoundWord kProfileWords[] = {{"cia302"}, {"el6751"}, {"plc_designer"}};
/// The key of what is there under some profiles only.
inline constexpr KeySpec kProfileKey{"profile", SomeOf<kProfileWords>(), kOptional, "el6751",
                                     "only under these of the scenario's 'profiles'"};
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

/// What begins the names of the sections of actions: some are called like faults.
inline constexpr char kActionPrefix[] = "events.";
} // namespace counterpoint::simulator

#endif // SIMULATOR_SCENARIO_NETWORK_NAMES_HPP
