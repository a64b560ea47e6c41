// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_SCENARIO_FAULT_KINDS_HPP
#define SIMULATOR_SCENARIO_FAULT_KINDS_HPP

#include "simulator/scenario/fields.hpp"
#include "simulator/scenario/frame_choice.hpp"
#include "simulator/scenario/names.hpp"

#include "hal/api/cross_link.hpp"
#include "hal/host/virtual/bus_fault.hpp"
#include "safety_core/contract/channel.hpp"
#include "safety_core/kernel/limits.hpp"
#include "safety_core/kernel/object_access.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <variant>
#include <vector>

// What kinds of faults there are. A kind is a number in the enumeration of its family and a row of kFaultSections; what
// the family's class does with it is a case of a switch over that enumeration. [SRS_SIM_020, SRS_SIM_021, SRS_SIM_022,
// SRS_SIM_023, SRS_SIM_024, SRS_SIM_025, SRS_SIM_026, SRS_SIM_027, SRS_SIM_028, SRS_SIM_029, SRS_SIM_030, SRS_SIM_031,
// SRS_SIM_032, SRS_SIM_033, SRS_SIM_034, SRS_SIM_035, SRS_SIM_036, SRS_SIM_037, SRS_SIM_038, SRS_SIM_047, SRS_SIM_057]
namespace counterpoint::simulator
{
struct Scenario;

// The families. A number is that of one kind in all families; lists of kinds are in their order.
/// Frames on their way to receivers change: FrameFaults.
enum class FrameFault : std::uint8_t
{
    kCorruption = 1U,
    kRepetition = 2U,
    kWrongSequence = 3U,
    kLoss = 4U,
    kDelay = 5U,
    kAddressing = 8U,
    kStoreAndForward = 19U,
    kDuplicate = 20U,
};
/// The sender's controller treats single frames wrongly: ControllerFaults.
enum class ControllerFault : std::uint8_t
{
    kWireError = 22U,
    kQueueFull = 25U,
    kSwallowed = 26U,
    kConfirmation = 27U,
};
/// Frames of nobody, or of a node that should not send them: NetworkFaults.
enum class ForeignFault : std::uint8_t
{
    kInsertion = 6U,
    kMasquerade = 7U,
    kBabbling = 21U,
};
/// A part, or what it is asked and answers: PartFaults, and the taps in front of the parts.
enum class PartFault : std::uint8_t
{
    kSkipped = 10U,
    kDoubled = 11U,
    kHung = 12U,
    kFrozen = 13U,
    kNotCalled = 14U,
    kAlwaysGood = 15U,
    kFrozenInput = 29U,
    kPermit = 30U,
    kWatchdog = 31U,
};
/// Memory, clocks, application and controllers of a node: NetworkFaults.
enum class NodeFault : std::uint8_t
{
    kBitFlip = 9U,
    kClock = 16U,
    kCycle = 17U,
    kNotInverse = 18U,
    kBusOff = 23U,
    kUnplugged = 24U,
    kQueueOverflow = 28U,
    kStuckBit = 32U,
    kStandstill = 33U,
};
/// Messages between two CPUs: LinkWire.
enum class LinkFault : std::uint8_t
{
    kLoss = 34U,
    kDelay = 35U,
    kRepetition = 36U,
    kReordering = 37U,
    kCorruption = 38U,
    kInsertion = 39U,
    kCut = 40U,
};
using FaultKind = std::variant<FrameFault, ControllerFault, ForeignFault, PartFault, NodeFault, LinkFault>;

/// One fault. Which members are used follows from its kind.
struct FaultSetup
{
    FaultKind kind;
    std::string name; ///< Shown to people.
    Source source;
    FrameChoice frames; ///< Bus faults.
    // Everything else: what, where, when.
    Nanoseconds at{0};
    Nanoseconds until{kNever};
    Nanoseconds on{0}; ///< Comes and goes: there for `on`, gone for `off`; 0: there all the time.
    Nanoseconds off{0};
    bool is_optional{false}; ///< It may be that it never has an effect.
    bool is_left_out{false}; ///< A run that shows what the others do without it; everybody's luck is the same.
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
    bool level{false};                   ///< Level of a stuck bit.
    std::optional<ConfigAddress> config; ///< `slot` holds the SRDO number here.
    std::uint8_t srdo{0U};               ///< Of a setup or safe value; 0: any.
    // Clock.
    bool hits_counter_a{false};
    bool hits_counter_b{false};
    std::int32_t rate_ppm{0};        ///< Instead of the drift; -10^6 stops the counter.
    std::optional<Nanoseconds> jump; ///< Instead of another rate.
    // Link between two CPUs: `frames` has window, turn and chance; `node` is CPU A.
    bool hits_from_a{true};
    bool hits_from_b{true};
    std::uint32_t back{0U}; ///< For an insertion: which message before; 0: noise.
    std::vector<std::uint32_t> message_bits;
    // Store and forward; reception queue.
    Nanoseconds gap{0};
    std::uint32_t capacity{1U};
    // Application.
    ObjectAddress object{0U, 0U};
};

/// What a kind has for itself: of faults that overlap one may have it. Faults of parts have their parts.
enum class Claim : std::uint8_t
{
    kNothing = 0U,
    kController = 1U,
    kRate = 2U,   ///< Of a counter.
    kObject = 3U, ///< Of the application.
};

/// What shows a normal frame that the fault hits: the frame itself, or, of one whose bits alone are wrong, the inverse
/// frame behind it.
enum class Shown : std::uint8_t
{
    kByItself,
    kByTheInverse,
};

/// The row of the table of limits: of a fault that hits a normal frame, a channel, or what the output stage and the
/// watchdog ask; and of all others.
struct FaultLimit
{
    constexpr FaultLimit(const FaultClass every, const Shown shown_ = Shown::kByItself)
        : first(every), other(every), shown(shown_)
    {
    }
    constexpr FaultLimit(const FaultClass first_, const FaultClass other_) : first(first_), other(other_)
    {
    }
    FaultClass first;
    FaultClass other;
    Shown shown{Shown::kByItself};
};

/// A section of the format that describes faults: of one kind, or of keys that several kinds share. A key has the
/// function that takes its value; one without is taken with another key.
struct FaultSection
{
    static constexpr std::size_t kMostKeys = 13U;

    std::optional<FaultKind> kind;
    FaultLimit limit;
    Claim claim;
    const char* name; ///< Of a kind its word.
    const char* title;
    const char* parent;
    const char* meaning;
    std::size_t count{0U};
    std::array<KeySpec, kMostKeys> keys{};
};

/// Its number, in whichever family it is.
[[nodiscard]] constexpr std::uint8_t NumberOf(const FaultKind kind)
{
    return std::visit([](const auto one) { return static_cast<std::uint8_t>(one); }, kind);
}

/// "a, b, c": the words of all kinds.
[[nodiscard]] std::string WordsOfFaults();

/// What the table of sections is written with.
namespace fault_keys
{
using T = ValueType;
using C = FaultClass;
using F = FaultSetup;

/// The value goes there as it is.
template <auto kMember> void To(Fields& fields, const char* const key, const Scenario& /*scenario*/, FaultSetup& fault)
{
    fields.Into(key, fault.*kMember);
}
/// The same of what chooses frames or messages.
template <auto kMember>
void Choosing(Fields& fields, const char* const key, const Scenario& /*scenario*/, FaultSetup& fault)
{
    fields.Into(key, fault.frames.*kMember);
}
/// The meaning of a word goes there.
template <auto kMember, const auto& kTable>
void WordTo(Fields& fields, const char* const key, const Scenario& /*scenario*/, FaultSetup& fault)
{
    fault.*kMember = fields.Require(key).Choice(kTable);
}
/// One of two sides, or both.
template <auto kFirst, auto kSecond>
void SidesTo(Fields& fields, const char* const key, const Scenario& /*scenario*/, FaultSetup& fault)
{
    const Side side = fields.Require(key).Choice(kCounterWords);
    fault.*kFirst = side != Side::kSecond;
    fault.*kSecond = side != Side::kFirst;
}
/// Bits, if there are any.
template <auto kMember>
void SomeBitsTo(Fields& fields, const char* const key, const Scenario& /*scenario*/, FaultSetup& fault)
{
    static_cast<void>(fields.IntoOnce(key, fault.*kMember));
}
/// Bits, one or more.
template <auto kMember> void BitsTo(Fields& fields, const char* const key, const Scenario& scenario, FaultSetup& fault)
{
    SomeBitsTo<kMember>(fields, key, scenario, fault);
    if ((fault.*kMember).empty())
    {
        fields.Require(key).Refuse("an empty list", "one bit or more");
    }
}
// With a rule of their own; see faults.cpp.
FaultKeyReader ToNode, ToTwoCpus, ToReceiver, ToFrames, ToEnd, ToPattern, ToLength, ToData, ToEvery, ToLateness,
    ToWrongBits, ToConfig, ToFlippedBit, ToFlippedSrdo, ToCalls, ToRate, ToShift, ToInput, ToWatchdog, ToInserted;

constexpr Range kOffsets{0U, 0xFFFFFFU};
constexpr Range kSrdos{1U, 64U};
constexpr Range kMillionths{1U, 1000000U};
constexpr Range kWordBits{0U, 31U};
constexpr Range kByteBits{0U, 7U};
constexpr Range kShortIdentifiers{0U, 0x7FFU};
constexpr Range kIdentifiers{0U, 0x1FFFFFFFU};
constexpr Range kThousand{1U, 1000U};
constexpr Range kCounts{1U, 0x7FFFFFFFU};
constexpr Range kControllers{1U, 2U};
constexpr Range kBits{0U, 63U};
constexpr Range kMessageBits{0U, hal::kLinkFrameBytes * 8U - 1U};

constexpr KeySpec kNode{"node", T::kNode, kNeeded, "actuator", "which node", ToNode};
constexpr KeySpec kAt{"at", T::kDuration, kNeeded, "500 ms", "when", To<&F::at>};
constexpr KeySpec kBegin{"at", T::kDuration, kNeeded, "500 ms", "when it begins", To<&F::at>};
constexpr KeySpec kFirst{"at", T::kDuration, kNeeded, "500 ms", "when the first one comes", To<&F::at>};
constexpr KeySpec kEnd{"until", T::kDuration, kOptional, "700 ms", "when it is over; default: it stays", ToEnd};
constexpr KeySpec kThere{"on", T::kLasting, kOptional, "5 ms", "intermittent: there for so long"};
constexpr KeySpec kGone{
    "off", T::kLasting, kOptional, "20 ms", "intermittent: then gone for so long, again and again", ToPattern};
constexpr KeySpec kCalls{"count", Number(kCounts), kOptional, "1", "how often; default: all the time", ToCalls};
constexpr KeySpec kOffset{
    "offset",      Number(kOffsets), kOptional, "12", "byte of the part; default: chosen by the seed, with its bit",
    To<&F::offset>};
constexpr KeySpec kController{
    "controller",      Number(kControllers), kOptional, "2", "of a node with two: this one alone; default: each",
    To<&F::controller>};
constexpr KeySpec kTwoCpus{"node", T::kNode, kNeeded, "actuator", "a node with 'structure: two_cpu'", ToTwoCpus};

constexpr KeySpec SenderOf(const char* const meaning)
{
    return {"sender", OneOf<kCounterWords>(), "both", "a", meaning, SidesTo<&F::hits_from_a, &F::hits_from_b>};
}

/// One word of a table, whose meaning goes there.
template <auto kMember, const auto& kTable>
constexpr KeySpec Choice(const char* const key, const char* const fallback, const char* const example,
                         const char* const meaning)
{
    return {key, OneOf<kTable>(), fallback, example, meaning, WordTo<kMember, kTable>};
}
constexpr KeySpec kCall = Choice<&F::call, kCallWords>("call", "OnCycle", "OnFrame", "which call");
template <const auto& kTable>
constexpr KeySpec kPart = Choice<&F::part, kTable>("part", kNeeded, "channel_a", "the part that is hit");

constexpr FaultSection Filled(FaultSection section, const std::initializer_list<KeySpec> keys)
{
    for (const KeySpec& key : keys)
    {
        section.keys.at(section.count++) = key;
    }
    return section;
}
/// The row of a kind.
constexpr FaultSection Kind(const FaultKind kind, const FaultLimit limit, const char* const word,
                            const char* const parent, const char* const meaning,
                            const std::initializer_list<KeySpec> keys = {}, const Claim claim = Claim::kNothing)
{
    return Filled({kind, limit, claim, word, "a fault", parent, meaning}, keys);
}
/// Keys of several kinds, or of a map in one.
constexpr FaultSection Shared(const char* const name, const char* const title, const char* const parent,
                              const char* const meaning, const std::initializer_list<KeySpec> keys)
{
    return Filled({std::nullopt, C::kInvalid, Claim::kNothing, name, title, parent, meaning}, keys);
}

inline constexpr FaultSection kSections[] = {
    Shared("fault", "a fault", nullptr, "Every fault; its other keys follow from its kind.",
           {{"fault", {T::kWord, {}, &WordsOfFaults}, kNeeded, "loss", "the kind"},
            {"name", T::kText, kOptional, "one frame lost", "shown to people, named by expectations; default: the kind",
             To<&F::name>},
            Choice<&F::is_optional, kYesWords>(
                "optional", "false", "true",
                "may never have an effect; else a fault that never happened fails the scenario")}),
    Shared("on_frames", "a fault", "fault", "Faults that hit chosen frames.",
           {{"frames", Map("frames"), kNeeded, "{identifier: 0x104, from: 500 ms}", "which frames", ToFrames}}),
    Shared("lasting", "a fault", "fault", "Faults that begin and end.", {kNode, kBegin, kEnd, kThere, kGone}),
    Shared("foreign", "a fault", "fault", "Faults that bring frames of their own.",
           {kFirst,
            {"identifier", Number(kIdentifiers), kNeeded, "0x104", "COB-ID of the frame", To<&F::identifier>},
            Choice<&F::frame_kind, kFrameKindWords>("kind", "data", "remote", "what kind of frame"),
            {"data", Numbers({0U, 255U}), kOptional, "[0xFE, 0x01]", "its bytes, at most 8", ToData},
            {"times", Number(kThousand), "1", "3", "how many frames", To<&F::times>},
            {"every", T::kLasting, kOptional, "2 ms", "time between two of them", ToEvery}}),
    Shared("frames", "a choice of frames", nullptr, "Chooses frames; everything that is said has to fit.",
           {{"identifier",
             {T::kOneOrMore, kIdentifiers},
             kOptional,
             "[0x103, 0x104]",
             "COB-ID or list of COB-IDs; default: any"},
            {"srdo", Map("frames_of"), kOptional, "{node: actuator, srdo: 1}", "instead: the frames of an SRDO"},
            {"sender", T::kNode, kOptional, "controller", "default: any"},
            {"receiver", T::kNode, kOptional, "actuator", "default: every receiver; of faults in receivers alone"},
            {"controller", Number(kControllers), kOptional, "2", "of the receiver; default: each"},
            {"from", T::kDuration, "0 ms", "500 ms", "not before"},
            {"until", T::kDuration, kOptional, "700 ms", "not from then on"},
            {"on", T::kLasting, kOptional, "5 ms", "intermittent: counted from 'from', frames within so long"},
            {"off", T::kLasting, kOptional, "20 ms", "intermittent: then none for so long, again and again"},
            {"first", Number(kCounts), "1", "3", "from the n-th frame that fits"},
            {"every", Number(kCounts), "1", "10", "from there on every n-th"},
            {"count", Number(kCounts), "1", "6", "at most so many; needed beside 'until', 'on' and 'every'"},
            {"probability_ppm", Number(kMillionths), "1000000", "500", "by chance, drawn from the seed"}}),
    Shared("frames_of", "the frames of an SRDO", nullptr, "Frames by SRDO instead of by COB-ID.",
           {{"node", T::kNode, kNeeded, "actuator", "a node that has the SRDO"},
            {"srdo", Number(kSrdos), kNeeded, "1", "its number there"},
            {"which", OneOf<kFrameSideWords>(), "both", "inverse", "COB-ID 1, COB-ID 2 or both"}}),
    Kind(FrameFault::kCorruption, {C::kWrongFrame, Shown::kByTheInverse}, "corruption", "on_frames",
         "The frame arrives changed; the CRC of the bus did not see it.",
         {{"bits", Numbers(kBits), kOptional, "[0, 15]", "these bits are flipped (0 is bit 0 of byte 0)",
           SomeBitsTo<&F::bits>},
          {"length", Number({0U, 8U}), kOptional, "1", "the length is another", ToLength}}),
    Kind(FrameFault::kRepetition, {C::kBusNextNormal, C::kWrongFrame}, "repetition", "on_frames",
         "The frame arrives again; copies that do not fit into 16 receptions are told.",
         {{"times", Number({1U, host::ReceptionList::kCapacity - 1U}), "1", "3", "how many copies", To<&F::times>},
          {"after", T::kDuration, "0 ms", "3 ms", "time between two of them", To<&F::by>}}),
    Kind(FrameFault::kWrongSequence, {C::kBus, C::kBusNextNormal}, "wrong_sequence", "on_frames",
         "The frame arrives after the next one."),
    Kind(FrameFault::kLoss, {C::kBus, C::kBusNextNormal}, "loss", "on_frames", "The frame does not arrive."),
    Kind(FrameFault::kDelay, {C::kBus, C::kBusNextNormal}, "delay", "on_frames", "The frame arrives later.",
         {{"by", T::kLasting, kNeeded, "60 ms", "so much later; others may overtake it", To<&F::by>}}),
    Kind(FrameFault::kAddressing, {C::kBus, C::kBusNextNormal}, "addressing", "on_frames",
         "The frame arrives under another COB-ID.",
         {{"as", Number(kShortIdentifiers), kNeeded, "0x104", "the other COB-ID", To<&F::identifier>}}),
    Kind(FrameFault::kStoreAndForward, {C::kBus, C::kBusNextNormal}, "store_and_forward", "on_frames",
         "A device between the segments keeps frames and lets them go in their order, one after the other.",
         {{"by", T::kLasting, kNeeded, "20 ms", "how long each frame is kept", To<&F::by>},
          {"gap", T::kDuration, "0 ms", "1 ms", "least time between two frames that it lets go", To<&F::gap>}}),
    Kind(FrameFault::kDuplicate, {C::kBusNextNormal, C::kWrongFrame}, "duplicate", "on_frames",
         "Another controller, which is no node's, sends the same frame on the bus.",
         {{"after", T::kDuration, "0 ms", "2 ms", "so much after the end of the frame", To<&F::by>}}),
    Kind(
        ControllerFault::kWireError, C::kBus, "wire_error", "on_frames",
        "A disturbance destroys the frame for all; controllers count the error and send again.",
        {{"bit", Number({0U, 156U}), "20", "30",
          "bit on the wire that is hit, 0 is SOF; one behind the end of a frame that is hit is refused", To<&F::bit>}}),
    Kind(ControllerFault::kQueueFull, {C::kBus, C::kBusNextNormal}, "queue_full", "on_frames",
         "The controller's transmit queue refuses the frame."),
    Kind(ControllerFault::kSwallowed, {C::kBus, C::kBusNextNormal}, "swallowed", "on_frames",
         "The controller takes the frame and never sends it."),
    Kind(ControllerFault::kConfirmation, C::kBus, "confirmation", "on_frames",
         "The sender's confirmation (its echo) is missing, late or wrong.",
         {Choice<&F::how, kConfirmationHowWords>("how", "missing", "late", "what is wrong with it"),
          {"by", T::kLasting, kOptional, "30 ms", "of late: so much", ToLateness},
          {"bits", Numbers(kBits), kOptional, "[0]", "of wrong: these bits are flipped", ToWrongBits}}),
    Kind(ForeignFault::kInsertion, {C::kBusNextNormal, C::kWrongFrame}, "insertion", "foreign",
         "A frame arrives that nobody sent.",
         {{"receiver", T::kNode, kOptional, "actuator", "who gets it; default: every node", ToReceiver}}),
    Kind(ForeignFault::kMasquerade, {C::kBusNextNormal, C::kWrongFrame}, "masquerade", "foreign",
         "A node sends a frame that is another node's.",
         {{"node", T::kNode, kNeeded, "sensor", "who sends it", ToNode}}),
    Kind(ForeignFault::kBabbling, C::kBus, "babbling", "fault",
         "A controller, which is no node's, sends one frame after the other without a pause.",
         {kBegin,
          kEnd,
          kThere,
          kGone,
          {"identifier", Number(kShortIdentifiers), "0", "0x001", "COB-ID of its frames; the lowest wins the bus",
           To<&F::identifier>},
          {"data", Numbers({0U, 255U}), kOptional, "[0x55]", "their bytes, at most 8", ToData}}),
    Kind(NodeFault::kBusOff, C::kBus, "bus_off", "lasting",
         "The controller goes bus-off: its queue is lost, it neither sends nor receives until it recovers at the end.",
         {kController}, Claim::kController),
    Kind(NodeFault::kUnplugged, C::kBus, "unplugged", "lasting",
         "The cable of the controller is off: it neither sends nor receives, and keeps its queue.", {kController},
         Claim::kController),
    Kind(NodeFault::kQueueOverflow, C::kWrongFrame, "queue_overflow", "lasting",
         "The node takes frames only at its cycles, from a reception queue that is too small.",
         {{"capacity", Number(kThousand), "1", "4", "frames that the queue holds", To<&F::capacity>}},
         Claim::kController),
    Kind(NodeFault::kBitFlip, C::kConfiguration, "bit_flip", "fault",
         "A bit flips: in the storage of a channel, in the kernel object or a part of it, in the table of SRDO setups, "
         "in a safe value, in the table of mappable objects, or in the mappable variables; and in what the self tests "
         "watch: the node's copy of the program of channels and kernel, the constant times of its description, the "
         "guard words of its stack, the pointers to the virtual tables of its parts (8 bytes each: channel A, channel "
         "B, output, watchdog, application).",
         {kNode,
          kPart<kMemoryWords>,
          kAt,
          kOffset,
          {"config", Map("config"), kOptional, "{srdo: 1, field: sct}",
           "of a channel, instead: where it keeps this value", ToConfig},
          {"bit", Number(kWordBits), kOptional, "4", "bit of the byte (0 to 7) or of the value; default 0",
           ToFlippedBit},
          {"srdo", Number(kSrdos), kOptional, "1", "of setup and safe_value: of which SRDO; default: of the first",
           ToFlippedSrdo}}),
    Kind(NodeFault::kStuckBit, C::kConfiguration, "stuck_bit", "fault",
         "A cell of live memory stays at one level, whatever is written: before each call into the node, and at each "
         "access of the march.",
         {kNode,
          kPart<kLiveWords>,
          {"at", T::kDuration, kNeeded, "500 ms", "when; it stays", To<&F::at>},
          kOffset,
          {"bit", Number(kByteBits), kOptional, "4", "bit of the byte; default 0", To<&F::bit>},
          Choice<&F::level, kLevelWords>("level", "0", "1", "what it reads as from then on")}),
    Kind(NodeFault::kStandstill, C::kSupervisor, "standstill", "fault",
         "The processor stands still: the node does nothing any more until a power cycle.", {kNode, kAt}),
    Shared("config", "a configuration value", nullptr, "A value of the configuration that a channel keeps.",
           {{"srdo", Number(kSrdos), kOptional, "1", "number of the SRDO; not with the device's own fields"},
            {"field", OneOf<kConfigFieldWords>(), kNeeded, "sct", "the value"},
            {"entry", Number({1U, 128U}), kOptional, "2", "of map_entry: which one"}}),
    Kind(PartFault::kSkipped, {C::kChannel, C::kSupervisor}, "skipped", "lasting", "The call of a channel is not made.",
         {kPart<kChannelWords>, kCall, kCalls}),
    Kind(PartFault::kDoubled, {C::kChannel, C::kSupervisor}, "doubled", "lasting",
         "The call of a channel is made twice.", {kPart<kChannelWords>, kCall, kCalls}),
    Kind(PartFault::kHung, {C::kChannel, C::kSupervisor}, "hung", "fault",
         "A call into that part never returns; the node does nothing any more until a power cycle.",
         {kNode, kPart<kPartWords>, kAt}),
    Kind(PartFault::kFrozen, {C::kChannel, C::kSupervisor}, "frozen", "lasting",
         "The part does not run and repeats its last answer to everything.", {kPart<kPartWords>}),
    Kind(PartFault::kNotCalled, {C::kChannel, C::kSupervisor}, "not_called", "lasting",
         "No call reaches the part; whoever asks it finds zeros.", {kPart<kPartWords>}),
    Kind(PartFault::kAlwaysGood, {C::kChannel, C::kSupervisor}, "always_good", "lasting",
         "Whatever its inputs, the part says what a healthy one says when nothing is wrong. A channel: no SRDO faulted "
         "or waiting, each one that it ever released still released with its last pair, guard's token right, nothing "
         "found in the configuration, permits to match. Comparator: what channel A releases is agreed and matched, "
         "right echo. Flow monitor: the right answer to the watchdog's question. Guard: the token of a valid "
         "configuration. Self test: nothing found, all parts sound. Output gate: takes every response for right. "
         "Watchdog: never trips.",
         {kPart<kGoodPartWords>}),
    Kind(NodeFault::kClock, C::kClock, "clock", "lasting",
         "A counter runs fast, slow or not at all, or jumps; one of ppm, stopped and jump.",
         {{"counter", OneOf<kCounterWords>(), kNeeded, "a", "which of the two",
           SidesTo<&F::hits_counter_a, &F::hits_counter_b>},
          {"ppm", T::kPpm, kOptional, "10000", "runs so much fast or slow instead of its drift"},
          {"stopped", OneOf<kYesWords>(), "false", "true", "stands still"},
          {"jump", T::kSignedTime, kOptional, "-3 ms", "jumps forward, or back, once", ToRate}},
         Claim::kRate),
    Kind(NodeFault::kCycle, C::kClock, "cycle", "fault",
         "One cycle, and those after it, come later or earlier; one of late and early.",
         {kNode,
          kAt,
          {"late", T::kLasting, kOptional, "3 ms", "so much later"},
          {"early", T::kLasting, kOptional, "700 us", "so much earlier", ToShift}}),
    Kind(NodeFault::kNotInverse, C::kBus, "not_inverse", "lasting",
         "The application's inverse of this object has wrong bits.",
         {{"object", T::kObject, kNeeded, "0x2000:02", "the normal object of a producer", To<&F::object>},
          {"bits", Numbers(kBits), kNeeded, "[3]", "bits of its inverse that are wrong", BitsTo<&F::bits>}},
         Claim::kObject),
    Kind(PartFault::kFrozenInput, {C::kSupervisor, C::kBus}, "frozen_input", "lasting",
         "The input keeps its last value, whatever happens.",
         {{"input", OneOf<kInputWords>(), kNeeded, "acknowledge",
           "acknowledge level of one channel or both, objects that the application writes, challenge of the output "
           "stage, question of the watchdog",
           ToInput}}),
    Kind(PartFault::kPermit, C::kSupervisor, "permit", "lasting",
         "A permit reaches the output stage wrong, old or not at all.",
         {Choice<&F::part, kPermitWords>("party", kNeeded, "kernel", "whose permit"),
          Choice<&F::how, kPermitHowWords>("how", "missing", "old",
                                           "one bit wrong, that of the cycle before, or none")}),
    Kind(PartFault::kWatchdog, C::kSupervisor, "watchdog", "lasting",
         "The watchdog is not served, served twice, or given a wrong or old answer.",
         {{"how", OneOf<kWatchdogHowWords>(), "not_served", "old_answer", "what is wrong", ToWatchdog}}),
    Shared("on_messages", "a fault", "fault",
           "Faults that hit chosen messages between two CPUs; a message is sent in each cycle.",
           {kTwoCpus,
            SenderOf("messages of this CPU"),
            {"at", T::kDuration, kNeeded, "500 ms", "not before", To<&F::at>},
            {"until", T::kDuration, kOptional, "700 ms", "not from then on", ToEnd},
            {"on", T::kLasting, kOptional, "5 ms", "intermittent: messages within so long"},
            {"off", T::kLasting, kOptional, "20 ms", "intermittent: then none for so long, again and again", ToPattern},
            {"first", Number(kCounts), "1", "3", "from the n-th message of each direction that fits",
             Choosing<&FrameChoice::first>},
            {"every", Number(kCounts), "1", "10", "from there on every n-th", Choosing<&FrameChoice::every>},
            {"count", Number(kCounts), "2147483647", "2", "at most so many of each direction",
             Choosing<&FrameChoice::count>},
            {"probability_ppm", Number(kMillionths), "1000000", "500", "by chance, drawn from the seed",
             Choosing<&FrameChoice::probability_ppm>}}),
    Kind(LinkFault::kLoss, C::kCrossLink, "link_loss", "on_messages", "The message does not arrive."),
    Kind(LinkFault::kDelay, C::kCrossLink, "link_delay", "on_messages", "The message arrives later.",
         {{"by", T::kLasting, kNeeded, "4 ms", "so much later; others may overtake it", To<&F::by>}}),
    Kind(LinkFault::kRepetition, C::kCrossLink, "link_repetition", "on_messages", "The message arrives again.",
         {{"times", Number({1U, 100U}), "1", "3", "how many copies", To<&F::times>},
          {"after", T::kDuration, "0 ms", "3 ms", "time between two of them", To<&F::by>}}),
    Kind(LinkFault::kReordering, C::kCrossLink, "link_reordering", "on_messages",
         "The message arrives after the next one; of neighbours every other one."),
    Kind(LinkFault::kCorruption, C::kCrossLink, "link_corruption", "on_messages", "The message arrives changed.",
         {{"bits", Numbers(kMessageBits), kNeeded, "[0, 1000]", "these bits are flipped (0 is bit 0 of byte 0)",
           BitsTo<&F::message_bits>}}),
    Kind(LinkFault::kInsertion, C::kCrossLink, "link_insertion", "fault",
         "A message arrives that the other CPU did not send.",
         {kTwoCpus,
          SenderOf("as if it came from this CPU"),
          kFirst,
          {"what", OneOf<kInsertedWords>(), "noise", "earlier",
           "bytes drawn from the seed, or a message that was sent before", ToInserted},
          {"back", Number({1U, 64U}), kOptional, "5", "of earlier: so many messages ago"},
          {"times", Number(kThousand), "1", "3", "how many messages", To<&F::times>},
          {"every", T::kLasting, kOptional, "2 ms", "time between two of them", ToEvery}}),
    Kind(LinkFault::kCut, C::kCrossLink, "link_cut", "on_messages", "Nothing gets through; what is under way arrives."),
};
} // namespace fault_keys

/// All sections that describe faults, in the order in which people read them.
inline constexpr auto& kFaultSections = fault_keys::kSections;

/// Whether each kind has one row: the numbers from 1 on are all there, each once.
[[nodiscard]] constexpr bool HaveAllKindsOneRow()
{
    std::uint64_t seen = 1U;
    for (const FaultSection& section : kFaultSections)
    {
        const std::uint64_t bit = section.kind ? std::uint64_t{1U} << NumberOf(*section.kind) : 0U;
        if ((seen & bit) != 0U)
        {
            return false;
        }
        seen |= bit;
    }
    return (seen & (seen + 1U)) == 0U;
}
static_assert(HaveAllKindsOneRow());

/// The row of a kind; each has one.
[[nodiscard]] constexpr const FaultSection& RowOf(const FaultKind kind)
{
    const FaultSection* found = kFaultSections;
    for (const FaultSection& section : kFaultSections)
    {
        found = (section.kind == kind) ? &section : found;
    }
    return *found;
}

/// The word of a kind.
[[nodiscard]] inline const char* Name(const FaultKind kind) noexcept
{
    return RowOf(kind).name;
}
} // namespace counterpoint::simulator

#endif // SIMULATOR_SCENARIO_FAULT_KINDS_HPP
