// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_SIMULATOR_SCENARIO_HPP
#define VERIFICATION_SIMULATOR_SCENARIO_HPP

#include "verification/simulator/yaml_document.hpp"

#include "safety_core/contract/channel.hpp"
#include "safety_core/contract/device_fault.hpp"
#include "safety_core/kernel/limits.hpp"
#include "safety_core/kernel/object_access.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::simulator
{
/// Simulated time since the start of the run. The bus and the world run on it; nodes have counters of their own.
using Nanoseconds = std::int64_t;
constexpr Nanoseconds kNanosecondsPerMicrosecond = 1000;
constexpr Nanoseconds kNanosecondsPerMillisecond = 1000000;
constexpr Nanoseconds kNanosecondsPerSecond = 1000000000;
constexpr Nanoseconds kNever = std::numeric_limits<Nanoseconds>::max();

using NodeIndex = std::size_t;
constexpr NodeIndex kNoNode = std::numeric_limits<NodeIndex>::max();

/// What came from one file: places in messages need the file.
struct Source
{
    std::string file;
    Place place;
};

struct CounterSetup
{
    std::int32_t drift_ppm{0}; ///< Positive is fast.
    std::uint32_t start_us{0U};
};

struct NodeSetup
{
    std::string name;
    std::string dcf; ///< Path, usable from here.
    Source source;
    std::optional<std::uint8_t> node_id;
    Nanoseconds phase{0};    ///< First cycle.
    Nanoseconds start_at{0}; ///< Enters OPERATIONAL.
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

enum class LogicOperation : std::uint8_t
{
    kCopy = 1U,
    kAnd = 2U,
    kOr = 3U,
    kNot = 4U,
};

struct LogicRule
{
    NodeIndex node{0U};
    ObjectAddress target{0U, 0U};
    LogicOperation operation{LogicOperation::kCopy};
    std::vector<ObjectAddress> inputs;
    Source source;
};

struct Acknowledge
{
    Nanoseconds at{0};
    Nanoseconds pulse{0};
    NodeIndex node{0U};
    std::uint8_t srdo{0U};
    Source source;
};

/// What an NMT master says.
enum class NmtCommand : std::uint8_t
{
    kNone = 0U,
    kStart = 1U,
    kStop = 2U,
    kEnterPreOperational = 3U,
    kResetNode = 4U,
    kResetCommunication = 5U,
};

struct NmtEvent
{
    Nanoseconds at{0};
    NodeIndex node{kNoNode}; ///< kNoNode: all.
    NmtState state{NmtState::kInvalid};
    NmtCommand command{NmtCommand::kNone}; ///< Instead of `state`.
    Nanoseconds start_after{kNever};       ///< Enters OPERATIONAL so long after a reset.
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

struct GfcEvent
{
    Nanoseconds at{0};
    NodeIndex node{0U};
    Source source;
};

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
    // A new kind: a number, a word (names.hpp), a section (schema_faults.cpp), a reader (scenario_faults.cpp) and
    // whoever brings it about (network_faults.cpp).
};

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

/// Chooses frames. Bus faults act on the frames that fit, from the `first`-th one on, at most `count` of them.
struct FrameChoice
{
    std::vector<std::uint32_t> identifiers; ///< None: any.
    std::optional<NodeIndex> srdo_of;       ///< The frames of SRDO `srdo` of this node, both or one of them.
    std::uint8_t srdo{0U};
    bool has_normal{true};
    bool has_inverse{true};
    std::optional<NodeIndex> sender;
    std::optional<NodeIndex> receiver; ///< None: for all receivers.
    std::uint32_t controller{0U};      ///< Of the receiver; 0: each.
    Nanoseconds from{0};
    Nanoseconds until{kNever};
    Nanoseconds on{0}; ///< 0: all the time.
    Nanoseconds off{0};
    std::uint32_t first{1U};
    std::uint32_t every{1U};
    std::uint32_t count{1U};
    std::uint32_t probability_ppm{1000000U};
};

struct FaultSetup
{
    FaultKind kind{FaultKind::kLoss};
    std::string name; ///< Shown to people.
    Source source;
    FrameChoice frames; ///< Bus faults.
    // Everything else: what, where, when.
    Nanoseconds at{0};
    Nanoseconds until{kNever};
    Nanoseconds on{0}; ///< Comes and goes: there for `on`, gone for `off`; 0: there all the time.
    Nanoseconds off{0};
    bool is_optional{false}; ///< It may be that it never has an effect.
    NodeIndex node{kNoNode};
    std::uint32_t controller{0U}; ///< 0: each.
    Part part{Part::kNone};
    Part second_part{Part::kNone}; ///< Where one cause hits two.
    Wrongness how{Wrongness::kNone};
    ChannelCall call{ChannelCall::kOnCycle};
    // Corruption.
    std::vector<std::uint8_t> bits;     ///< Numbered from bit 0 of byte 0.
    std::optional<std::uint8_t> length; ///< Frame length instead of the true one.
    // Repetition, delay, early and late cycle.
    std::uint32_t times{1U};
    Nanoseconds by{0};
    // Insertion and masquerade; `identifier` also of addressing.
    std::uint32_t identifier{0U};
    FrameKind frame_kind{FrameKind::kData};
    std::vector<std::uint8_t> data;
    // Bit flip.
    std::optional<std::uint32_t> offset;
    std::uint8_t bit{0U};
    bool level{false};                   ///< Of a stuck bit.
    std::optional<ConfigAddress> config; ///< `slot` holds the SRDO number here.
    std::uint8_t srdo{0U};               ///< Of a setup or safe value; 0: any.
    // Clock.
    bool hits_counter_a{false};
    bool hits_counter_b{false};
    std::int32_t rate_ppm{0};        ///< Instead of the drift; -10^6 stops the counter.
    std::optional<Nanoseconds> jump; ///< Instead of another rate.
    // Store and forward; reception queue.
    Nanoseconds gap{0};
    std::uint32_t capacity{1U};
    // Application.
    ObjectAddress object{0U, 0U};
};

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
};

struct Expectation
{
    ExpectationKind kind{ExpectationKind::kNoFault};
    Source source;
    Nanoseconds at{0};
    NodeIndex node{kNoNode};
    std::uint8_t srdo{0U};
    ObjectAddress object{0U, 0U};
    std::uint64_t value{0U};
    SrdoCause cause{SrdoCause::kInvalid};
    DeviceFault device_fault{DeviceFault::kInvalid};
    std::vector<Party> parties;                   ///< Any of them.
    std::size_t fault{0U};                        ///< Index in Scenario::faults.
    FaultClass fault_class{FaultClass::kInvalid}; ///< kInvalid: follows from the fault.
};

struct Scenario
{
    std::string file;
    std::string title;
    std::string description;
    std::uint32_t bitrate{500000U};
    Nanoseconds duration{0};
    std::uint64_t seed{1U};
    std::vector<NodeSetup> nodes;
    std::vector<Stimulus> stimuli;
    std::vector<LogicRule> logic;
    std::vector<Acknowledge> acknowledges;
    std::vector<NmtEvent> nmt;
    std::vector<PowerCycle> power;
    std::vector<GfcEvent> gfc;
    std::vector<FaultSetup> faults;
    std::vector<Expectation> expectations;
};

/// Whether a state of a part, counter, object or controller begins and ends; else single frames or moments are hit.
[[nodiscard]] constexpr bool IsState(const FaultKind kind)
{
    const bool is_old = kind >= FaultKind::kSkipped && kind != FaultKind::kCycle && kind <= FaultKind::kNotInverse;
    const bool is_controller = kind == FaultKind::kBusOff || kind == FaultKind::kUnplugged;
    return is_old || is_controller || kind == FaultKind::kBabbling || kind >= FaultKind::kQueueOverflow;
}

/// Whether normal frames, which have odd identifiers, are among the chosen ones.
[[nodiscard]] inline bool ChoosesNormal(const FrameChoice& choice)
{
    bool is_odd = choice.identifiers.empty() && choice.has_normal;
    for (const std::uint32_t identifier : choice.identifiers)
    {
        is_odd = is_odd || (identifier & 1U) != 0U;
    }
    return is_odd;
}
} // namespace counterpoint::simulator

#endif // VERIFICATION_SIMULATOR_SCENARIO_HPP
