// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_SCENARIO_SCENARIO_HPP
#define SIMULATOR_SCENARIO_SCENARIO_HPP

#include "canopen/cia301/nmt/command.hpp"
#include "runtime/device/logic_rule.hpp"
#include "runtime/device/owned_channel.hpp"
#include "simulator/scenario/fault_kinds.hpp"
#include "simulator/scenario/kinds.hpp"
#include "simulator/scenario/values.hpp"

#include "safety_core/contract/channel.hpp"
#include "safety_core/contract/device_fault.hpp"
#include "safety_core/kernel/limits.hpp"
#include "safety_core/kernel/object_access.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::simulator
{
/// One counter of a node.
struct CounterSetup
{
    std::int32_t drift_ppm{0}; ///< Positive is fast.
    std::uint32_t start_us{0U};
};

/// The link between the two CPUs of a device. [SRS_SIM_056]
struct LinkSetup
{
    Nanoseconds timeout{10 * kNanosecondsPerMillisecond};
    Nanoseconds delay{100 * kNanosecondsPerMicrosecond};
    Nanoseconds jitter{0}; ///< Each message takes up to so much longer.
    Nanoseconds clock_tolerance{2 * kNanosecondsPerMillisecond};
    Nanoseconds clock_interval{500 * kNanosecondsPerMillisecond};
    Nanoseconds stamp_tolerance{50 * kNanosecondsPerMicrosecond};
};

/// One CPU: a device with one CPU, or one CPU of a device with two. The two CPUs of a device follow each other, A
/// first.
struct NodeSetup
{
    std::string name;
    std::string device; ///< The same, or without .a and .b.
    runtime::CpuRole role{runtime::CpuRole::kWhole};
    LinkSetup link;
    std::string dcf; ///< Path, usable from here.
    Source source;
    std::optional<std::uint8_t> node_id; ///< Always known in a network with managers.
    std::optional<std::uint32_t> serial; ///< 1018h:04 instead of the DCF's.
    Nanoseconds phase{0};                ///< Power-on; its cycles follow.
    Nanoseconds start_at{0};             ///< Enters OPERATIONAL; kNever: when a manager says so.
    bool names_start{false};             ///< `start_at` stands in the file.
    CounterSetup counter_a;
    CounterSetup counter_b;
    bool self_tests{true};
    std::uint32_t controllers{1U}; ///< 2: normal frames by the first, inverse frames by the second.
};

/// The input of a producer changes.
struct Stimulus
{
    Nanoseconds at{0};
    NodeIndex node{0U};
    ObjectAddress object{0U, 0U};
    std::uint64_t value{0U};
    Source source;
};

/// An acknowledge input is 1 for a while.
struct Acknowledge
{
    Nanoseconds at{0};
    Nanoseconds pulse{0};
    NodeIndex node{0U};
    std::uint8_t srdo{0U};
    Source source;
};

/// A node changes its NMT state or follows an NMT command.
struct NmtEvent
{
    Nanoseconds at{0};
    NodeIndex node{kNoNode}; ///< kNoNode: all.
    NmtState state{NmtState::kInvalid};
    cia301::NmtCommand command{cia301::NmtCommand::kInvalid}; ///< Instead of `state`.
    Nanoseconds start_after{kNever};                          ///< Enters OPERATIONAL so long after a reset.
    Source source;
};

/// A node loses its supply for a while.
struct PowerCycle
{
    Nanoseconds at{0};
    NodeIndex node{0U};
    Nanoseconds off{0};
    Nanoseconds start_after{kNever}; ///< Enters OPERATIONAL so long after power-on.
    Source source;
};

/// A node sends the global fail-safe command.
struct GfcEvent
{
    Nanoseconds at{0};
    NodeIndex node{0U};
    Source source;
};

/// A manager of the network.
struct ManagerSetup
{
    std::string network;      ///< Path, usable from here.
    std::uint8_t node_id{0U}; ///< 0: as the file says.
    Nanoseconds at{0};        ///< It is switched on.
    Source source;
};

/// Something that happens to devices, managers or bus. Which members are used follows from its kind.
struct Action
{
    ActionKind kind{ActionKind::kPull};
    Source source;
    bool is_of_profile{true}; ///< Else it is left out.
    Nanoseconds at{0};
    Nanoseconds until{0};
    Nanoseconds every{0};
    NodeIndex node{kNoNode};  ///< Of a device.
    std::uint8_t node_id{0U}; ///< Of a manager (0: the first one), or of the node whose emergencies are sent.
    std::uint32_t serial{0U};
    std::uint32_t identifier{0U};
    std::uint16_t code{0U};
    std::string order;
    Source order_source; ///< Where it stands.
    ObjectAddress object{0U, 0U};
    std::uint32_t value{0U};
    std::uint8_t srdo{0U};
    std::vector<std::uint8_t> data; ///< Of a frame that is sent.
};

/// One expectation. Which members are used follows from its kind.
struct Expectation
{
    ExpectationKind kind{ExpectationKind::kNoFault};
    Source source;
    bool is_of_profile{true}; ///< Else it is left out.
    Nanoseconds at{0};        ///< Of events the end of the window; kNever: the end of the run.
    Nanoseconds from{0};      ///< Of events.
    std::uint8_t node_id{0U}; ///< Whom a manager is asked about; 0: nobody in particular.
    std::uint8_t manager{0U}; ///< Who is asked; 0: the first one.
    std::string is;           ///< The word that is expected of manager, device or output.
    NodeIndex node{kNoNode};
    bool is_series{false}; ///< It is about both CPUs of a device: `node` and the next one, whose outputs are in series.
    std::uint8_t srdo{0U};
    ObjectAddress object{0U, 0U};
    std::uint64_t value{0U};
    SrdoCause cause{SrdoCause::kInvalid};
    DeviceFault device_fault{DeviceFault::kInvalid};
    std::vector<Party> parties;                   ///< Any of them.
    std::size_t fault{0U};                        ///< Index in Scenario::faults.
    FaultClass fault_class{FaultClass::kInvalid}; ///< kInvalid: follows from the fault.
};

/// A whole scenario.
struct Scenario
{
    std::string file;
    std::string title;
    std::string description;
    std::uint32_t bitrate{500000U};
    Nanoseconds duration{0};
    std::uint64_t seed{1U};
    std::vector<std::string> profiles; ///< Those that it is written for; none: as the network files say.
    std::string profile;               ///< The one of them that runs.
    std::vector<NodeSetup> nodes;
    std::vector<ManagerSetup> managers;
    std::vector<Stimulus> stimuli;
    std::vector<runtime::LogicRule> logic;
    std::vector<Acknowledge> acknowledges;
    std::vector<NmtEvent> nmt;
    std::vector<PowerCycle> power;
    std::vector<GfcEvent> gfc;
    std::vector<Action> actions;
    std::vector<FaultSetup> faults;
    std::vector<Expectation> expectations;
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_SCENARIO_SCENARIO_HPP
