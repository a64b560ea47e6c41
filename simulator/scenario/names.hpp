// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_SCENARIO_NAMES_HPP
#define SIMULATOR_SCENARIO_NAMES_HPP

#include "canopen/cia301/nmt/command.hpp"
#include "runtime/device/names.hpp"
#include "simulator/scenario/kinds.hpp"
#include "simulator/scenario/values.hpp"

#include "safety_core/contract/can_frame.hpp"
#include "safety_core/contract/channel.hpp"
#include "safety_core/crosslink/link_supervisor.hpp"
#include "safety_core/kernel/limits.hpp"

#include <cstddef>
#include <string>

namespace counterpoint::simulator
{
using runtime::IdentifierText;
using runtime::MillisecondsText;
using runtime::Name;
using runtime::NameOf;
using runtime::ObjectText;
using runtime::Words;

// The words of scenarios and outputs for the enumerations of contract, kernel and simulator: one table for both ways.
inline constexpr Word<Part> kPartWords[] = {
    {"channel_a", Part::kChannelA},       {"channel_b", Part::kChannelB}, {"comparator", Part::kComparator},
    {"flow_monitor", Part::kFlowMonitor}, {"guard", Part::kGuard},        {"self_test", Part::kSelfTest},
};

/// What can always be good: chips, too.
inline constexpr Word<Part> kGoodPartWords[] = {
    {"channel_a", Part::kChannelA},       {"channel_b", Part::kChannelB},    {"comparator", Part::kComparator},
    {"flow_monitor", Part::kFlowMonitor}, {"guard", Part::kGuard},           {"self_test", Part::kSelfTest},
    {"output_gate", Part::kOutputGate},   {"watchdog", Part::kWatchdogChip},
};

inline constexpr Word<Part> kChannelWords[] = {{"channel_a", Part::kChannelA}, {"channel_b", Part::kChannelB}};

/// Where bits can flip.
inline constexpr Word<Part> kMemoryWords[] = {
    {"channel_a", Part::kChannelA},
    {"channel_b", Part::kChannelB},
    {"kernel", Part::kKernel},
    {"latch", Part::kLatch},
    {"comparator", Part::kComparator},
    {"flow_monitor", Part::kFlowMonitor},
    {"guard", Part::kGuard},
    {"clocks", Part::kClocks},
    {"setup", Part::kSetup},
    {"safe_value", Part::kSafeValue},
    {"objects", Part::kObjects},
    {"variables", Part::kVariables},
    {"program", Part::kProgram},
    {"constants", Part::kConstants},
    {"stack_guard", Part::kStackGuard},
    {"table_pointer", Part::kTablePointer},
};

/// Live memory, which a march tests.
inline constexpr Word<Part> kLiveWords[] = {
    {"channel_a", Part::kChannelA}, {"channel_b", Part::kChannelB}, {"kernel", Part::kKernel}};

inline constexpr Word<Part> kInputWords[] = {
    {"acknowledge_a", Part::kAcknowledgeA}, {"acknowledge_b", Part::kAcknowledgeB}, {"acknowledge", Part::kNone},
    {"application", Part::kApplication},    {"challenge", Part::kChallenge},        {"question", Part::kQuestion},
};

inline constexpr Word<Part> kPermitWords[] = {
    {"a", Part::kPermitA}, {"b", Part::kPermitB}, {"kernel", Part::kPermitKernel}};

inline constexpr Word<Wrongness> kPermitHowWords[] = {
    {"wrong", Wrongness::kWrong}, {"old", Wrongness::kOld}, {"missing", Wrongness::kMissing}};
inline constexpr Word<Wrongness> kWatchdogHowWords[] = {{"not_served", Wrongness::kMissing},
                                                        {"served_twice", Wrongness::kTwice},
                                                        {"wrong_answer", Wrongness::kWrong},
                                                        {"old_answer", Wrongness::kOld}};
inline constexpr Word<Wrongness> kConfirmationHowWords[] = {
    {"missing", Wrongness::kMissing}, {"late", Wrongness::kLate}, {"wrong", Wrongness::kWrong}};

inline constexpr Word<cia301::NmtCommand> kCommandWords[] = {
    {"start", cia301::NmtCommand::kStart},
    {"stop", cia301::NmtCommand::kStop},
    {"enter_pre_operational", cia301::NmtCommand::kPreOperational},
    {"reset_node", cia301::NmtCommand::kResetNode},
    {"reset_communication", cia301::NmtCommand::kResetCommunication},
};

inline constexpr Word<ChannelCall> kCallWords[] = {{"OnCycle", ChannelCall::kOnCycle},
                                                   {"OnFrame", ChannelCall::kOnFrame}};
inline constexpr Word<bool> kYesWords[] = {{"true", true}, {"false", false}};

inline constexpr Word<bool> kLevelWords[] = {{"0", false}, {"1", true}};

/// The self tests by the number of selftest::TestId.
inline constexpr Word<std::uint64_t> kTestWords[] = {
    {"no test started", 0U}, {"pointers to tables", 1U}, {"stack guard", 2U}, {"program", 3U},
    {"constants", 4U},       {"live memory", 5U},        {"permits", 6U},     {"schedule", 7U}};

/// One or both of two: normal and inverse frames, or counters A and B.
enum class Side : std::uint8_t
{
    kFirst = 1U,
    kSecond = 2U,
    kBoth = 3U,
};
inline constexpr Word<bool> kStructureWords[] = {{"one_cpu", false}, {"two_cpu", true}};
inline constexpr Word<bool> kInsertedWords[] = {{"earlier", true}, {"noise", false}};
/// The state of the link as a CPU sees it, by the number of its LinkState.
inline constexpr Word<LinkState> kLinkStateWords[] = {
    {"lost", LinkState::kLost}, {"waiting", LinkState::kWaiting}, {"alive", LinkState::kAlive}};
inline constexpr Word<LinkFinding> kLinkFindingWords[] = {{"nothing", LinkFinding::kNone},
                                                          {"timeout", LinkFinding::kTimeout},
                                                          {"clock", LinkFinding::kClock},
                                                          {"flow", LinkFinding::kFlow},
                                                          {"peer_safe", LinkFinding::kPeerSafe}};
inline constexpr Word<Side> kFrameSideWords[] = {
    {"normal", Side::kFirst}, {"inverse", Side::kSecond}, {"both", Side::kBoth}};
inline constexpr Word<Side> kCounterWords[] = {{"a", Side::kFirst}, {"b", Side::kSecond}, {"both", Side::kBoth}};

inline constexpr Word<ExpectationKind> kExpectationWords[] = {
    {"released", ExpectationKind::kReleased},
    {"safe", ExpectationKind::kSafe},
    {"value", ExpectationKind::kValue},
    {"cause", ExpectationKind::kCause},
    {"device_fault", ExpectationKind::kDeviceFault},
    {"detected_by", ExpectationKind::kDetectedBy},
    {"safe_within", ExpectationKind::kSafeWithin},
    {"no_fault", ExpectationKind::kNoFault},
    {"state", ExpectationKind::kState},
    {"device", ExpectationKind::kDevice},
    {"letter", ExpectationKind::kLetter},
    {"code", ExpectationKind::kCode},
    {"gate", ExpectationKind::kGate},
    {"finding", ExpectationKind::kFinding},
    {"output", ExpectationKind::kOutput},
    {"event", ExpectationKind::kEvent},
    {"no_event", ExpectationKind::kNoEvent},
    {"active", ExpectationKind::kActive},
    {"flying", ExpectationKind::kFlying},
};

inline constexpr Word<Party> kPartyWords[] = {
    {"nobody", Party::kNobody},
    {"channels", Party::kChannels},
    {"channel_a", Party::kChannelA},
    {"channel_b", Party::kChannelB},
    {"comparator", Party::kComparator},
    {"kernel", Party::kKernel},
    {"flow_monitor", Party::kFlowMonitor},
    {"watchdog", Party::kWatchdog},
    {"output_gate", Party::kOutputGate},
    {"clock_supervisor", Party::kClockSupervisor},
    {"guard", Party::kGuard},
    {"self_test", Party::kSelfTest},
    {"cross_link", Party::kCrossLink},
};

inline constexpr Word<FaultClass> kFaultClassWords[] = {
    {"bus", FaultClass::kBus},
    {"bus_next_normal", FaultClass::kBusNextNormal},
    {"wrong_frame", FaultClass::kWrongFrame},
    {"channel", FaultClass::kChannel},
    {"configuration", FaultClass::kConfiguration},
    {"shared_source", FaultClass::kSharedSource},
    {"supervisor", FaultClass::kSupervisor},
    {"clock", FaultClass::kClock},
    {"cross_link", FaultClass::kCrossLink},
};

inline constexpr Word<FrameKind> kFrameKindWords[] = {
    {"data", FrameKind::kData},
    {"remote", FrameKind::kRemote},
    {"extended", FrameKind::kExtended},
    {"extended_remote", FrameKind::kExtendedRemote},
    {"flexible_data_rate", FrameKind::kFlexibleDataRate},
};

inline constexpr Word<ConfigField> kConfigFieldWords[] = {
    {"direction", ConfigField::kDirection},
    {"sct", ConfigField::kSct},
    {"srvt", ConfigField::kSrvt},
    {"transmission_type", ConfigField::kTransmissionType},
    {"cob_id_1", ConfigField::kCobId1},
    {"cob_id_2", ConfigField::kCobId2},
    {"map_count", ConfigField::kMapCount},
    {"map_entry", ConfigField::kMapEntry},
    {"signature", ConfigField::kSignature},
    {"gfc_parameter", ConfigField::kGfcParameter},
    {"configuration_valid", ConfigField::kConfigurationValid},
};

[[nodiscard]] inline const char* Name(const Party party) noexcept
{
    return NameOf(kPartyWords, party);
}
[[nodiscard]] inline const char* Name(const FaultClass fault_class) noexcept
{
    return NameOf(kFaultClassWords, fault_class);
}

} // namespace counterpoint::simulator

#endif // SIMULATOR_SCENARIO_NAMES_HPP
