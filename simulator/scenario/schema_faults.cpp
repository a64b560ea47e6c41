// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/scenario/names.hpp"
#include "simulator/scenario/schema.hpp"

#include "hal/host/virtual/bus_fault.hpp"

// The kinds of faults. A new kind is a section here, named like its word in fault_kinds.hpp. [SRS_SIM_020, SRS_SIM_021,
// SRS_SIM_022, SRS_SIM_023, SRS_SIM_024, SRS_SIM_025, SRS_SIM_026, SRS_SIM_027, SRS_SIM_028, SRS_SIM_029, SRS_SIM_030,
// SRS_SIM_031, SRS_SIM_032, SRS_SIM_033, SRS_SIM_034, SRS_SIM_035, SRS_SIM_036, SRS_SIM_037, SRS_SIM_038, SRS_SIM_047]
namespace counterpoint::simulator
{
namespace
{
using T = ValueType;
constexpr Range kOffsets{0U, 0xFFFFFFU};
constexpr Range kSrdos{1U, 64U};
constexpr Range kMillionths{1U, 1000000U};
constexpr Range kWordBits{0U, 31U};
constexpr Range kByteBits{0U, 7U};
constexpr Range kShortIdentifiers{0U, 0x7FFU};
constexpr Range kFrames{1U, 1000U};
constexpr Range kIdentifiers{0U, 0x1FFFFFFFU};
constexpr Range kCounts{1U, 0x7FFFFFFFU};
constexpr Range kControllers{1U, 2U};
constexpr Range kBits{0U, 63U};

const KeySpec kBegin{"at", T::kDuration, kNeeded, "500 ms", "when it begins"};
const KeySpec kEnd{"until", T::kDuration, kOptional, "700 ms", "when it is over; default: it stays"};
const KeySpec kThere{"on", T::kLasting, kOptional, "5 ms", "intermittent: there for so long"};
const KeySpec kGone{"off", T::kLasting, kOptional, "20 ms", "intermittent: then gone for so long, again and again"};
const KeySpec kCall{"call", OneOf<kCallWords>(), "OnCycle", "OnFrame", "which call"};
const KeySpec kCalls{"count", Number(kCounts), kOptional, "1", "how often; default: all the time"};
const KeySpec kOffset{"offset", Number(kOffsets), kOptional, "12",
                      "byte of the part; default: chosen by the seed, with its bit"};
const KeySpec kController{"controller", Number(kControllers), kOptional, "2",
                          "of a node with two: this one alone; default: each"};

KeySpec PartOf(const Shape& shape)
{
    return {"part", shape, kNeeded, "channel_a", "the part that is hit"};
}
} // namespace

const std::vector<SectionSpec> kFrameFaultSections{
    Section(
        "fault", "a fault", "Every fault; its other keys follow from its kind.",
        {{"fault", OneOf<kFaultKinds>(), kNeeded, "loss", "the kind"},
         {"name", T::kText, kOptional, "one frame lost", "shown to people, named by expectations; default: the kind"},
         {"optional", OneOf<kYesWords>(), "false", "true",
          "may never have an effect; else a fault that never happened fails the scenario"}}),
    Kind("on_frames", "fault", "Faults that hit chosen frames.",
         {{"frames", Map("frames"), kNeeded, "{identifier: 0x104, from: 500 ms}", "which frames"}}),
    Kind("lasting", "fault", "Faults that begin and end.", {kNodeKey, kBegin, kEnd, kThere, kGone}),
    Kind("foreign", "fault", "Faults that bring frames of their own.",
         {{"at", T::kDuration, kNeeded, "500 ms", "when the first one comes"},
          {"identifier", Number(kIdentifiers), kNeeded, "0x104", "COB-ID of the frame"},
          {"kind", OneOf<kFrameKindWords>(), "data", "remote", "what kind of frame"},
          {"data", Numbers({0U, 255U}), kOptional, "[0xFE, 0x01]", "its bytes, at most 8"},
          {"times", Number(kFrames), "1", "3", "how many frames"},
          {"every", T::kLasting, kOptional, "2 ms", "time between two of them"}}),
    Section("frames", "a choice of frames", "Chooses frames; everything that is said has to fit.",
            {{"identifier",
              {T::kOneOrMore, kIdentifiers},
              kOptional,
              "[0x103, 0x104]",
              "COB-ID or list of COB-IDs; default: any"},
             {"srdo", Map("frames_of"), kOptional, "{node: actuator, srdo: 1}", "instead: the frames of an SRDO"},
             {"sender", T::kNode, kOptional, "controller", "default: any"},
             {"receiver", T::kNode, kOptional, "actuator", "default: every receiver"},
             {"controller", Number(kControllers), kOptional, "2", "of the receiver; default: each"},
             {"from", T::kDuration, "0 ms", "500 ms", "not before"},
             {"until", T::kDuration, kOptional, "700 ms", "not from then on"},
             {"on", T::kLasting, kOptional, "5 ms", "intermittent: counted from 'from', frames within so long"},
             {"off", T::kLasting, kOptional, "20 ms", "intermittent: then none for so long, again and again"},
             {"first", Number(kCounts), "1", "3", "from the n-th frame that fits"},
             {"every", Number(kCounts), "1", "10", "from there on every n-th"},
             {"count", Number(kCounts), "1", "6", "at most so many"},
             {"probability_ppm", Number(kMillionths), "1000000", "500", "by chance, drawn from the seed"}}),
    Section("frames_of", "the frames of an SRDO", "Frames by SRDO instead of by COB-ID.",
            {{"node", T::kNode, kNeeded, "actuator", "a node that has the SRDO"},
             {"srdo", Number(kSrdos), kNeeded, "1", "its number there"},
             {"which", OneOf<kFrameSideWords>(), "both", "inverse", "COB-ID 1, COB-ID 2 or both"}}),
    Kind("corruption", "on_frames", "The frame arrives changed; the CRC of the bus did not see it.",
         {{"bits", Numbers(kBits), kOptional, "[0, 15]", "these bits are flipped (0 is bit 0 of byte 0)"},
          {"length", Number({0U, 8U}), kOptional, "1", "the length is another"}}),
    Kind("repetition", "on_frames", "The frame arrives again; copies that do not fit into 16 receptions are told.",
         {{"times", Number({1U, host::ReceptionList::kCapacity - 1U}), "1", "3", "how many copies"},
          {"after", T::kDuration, "0 ms", "3 ms", "time between two of them"}}),
    Kind("wrong_sequence", "on_frames", "The frame arrives after the next one."),
    Kind("loss", "on_frames", "The frame does not arrive."),
    Kind("delay", "on_frames", "The frame arrives later.",
         {{"by", T::kLasting, kNeeded, "60 ms", "so much later; others may overtake it"}}),
    Kind("addressing", "on_frames", "The frame arrives under another COB-ID.",
         {{"as", Number(kShortIdentifiers), kNeeded, "0x104", "the other COB-ID"}}),
    Kind("store_and_forward", "on_frames",
         "A device between the segments keeps frames and lets them go in their order, one after the other.",
         {{"by", T::kLasting, kNeeded, "20 ms", "how long each frame is kept"},
          {"gap", T::kDuration, "0 ms", "1 ms", "least time between two frames that it lets go"}}),
    Kind("duplicate", "on_frames", "Another controller, which is no node's, sends the same frame on the bus.",
         {{"after", T::kDuration, "0 ms", "2 ms", "so much after the end of the frame"}}),
    Kind("wire_error", "on_frames",
         "A disturbance destroys the frame for all; controllers count the error and send again.",
         {{"bit", Number({0U, 156U}), "20", "30", "bit on the wire that is hit, 0 is SOF"}}),
    Kind("queue_full", "on_frames", "The controller's transmit queue refuses the frame."),
    Kind("swallowed", "on_frames", "The controller takes the frame and never sends it."),
    Kind("confirmation", "on_frames", "The sender's confirmation (its echo) is missing, late or wrong.",
         {{"how", OneOf<kConfirmationHowWords>(), "missing", "late", "what is wrong with it"},
          {"by", T::kLasting, kOptional, "30 ms", "of late: so much"},
          {"bits", Numbers(kBits), kOptional, "[0]", "of wrong: these bits are flipped"}}),
    Kind("insertion", "foreign", "A frame arrives that nobody sent.",
         {{"receiver", T::kNode, kOptional, "actuator", "who gets it; default: every node"}}),
    Kind("masquerade", "foreign", "A node sends a frame that is another node's.",
         {{"node", T::kNode, kNeeded, "sensor", "who sends it"}}),
    Kind("babbling", "fault", "A controller, which is no node's, sends one frame after the other without a pause.",
         {kBegin,
          kEnd,
          kThere,
          kGone,
          {"identifier", Number(kShortIdentifiers), "0", "0x001", "COB-ID of its frames; the lowest wins the bus"},
          {"data", Numbers({0U, 255U}), kOptional, "[0x55]", "their bytes, at most 8"}}),
};
const std::vector<SectionSpec> kNodeFaultSections{
    Kind("bus_off", "lasting",
         "The controller goes bus-off: its queue is lost, it neither sends nor receives until it recovers at the end.",
         {kController}),
    Kind("unplugged", "lasting",
         "The cable of the controller is off: it neither sends nor receives, and keeps its queue.", {kController}),
    Kind("queue_overflow", "lasting",
         "The node takes frames only at its cycles, from a reception queue that is too small.",
         {{"capacity", Number(kFrames), "1", "4", "frames that the queue holds"}}),
    Kind("bit_flip", "fault",
         "A bit flips: in the storage of a channel, in the kernel object or a part of it, in the table of SRDO setups, "
         "in a safe value, in the table of mappable objects, or in the mappable variables; and in what the self tests "
         "watch: the node's copy of the program of channels and kernel, the constant times of its description, the "
         "guard words of its stack, the pointers to the virtual tables of its parts (8 bytes each: channel A, channel "
         "B, output, watchdog, application).",
         {kNodeKey,
          PartOf(OneOf<kMemoryWords>()),
          kAtKey,
          kOffset,
          {"config", Map("config"), kOptional, "{srdo: 1, field: sct}",
           "of a channel, instead: where it keeps this value"},
          {"bit", Number(kWordBits), kOptional, "4", "bit of the byte (0 to 7) or of the value; default 0"},
          {"srdo", Number(kSrdos), kOptional, "1", "of setup and safe_value: of which SRDO; default: of the first"}}),
    Kind("stuck_bit", "fault",
         "A cell of live memory stays at one level, whatever is written: before each call into the node, and at each "
         "access of the march.",
         {kNodeKey,
          PartOf(OneOf<kLiveWords>()),
          {"at", T::kDuration, kNeeded, "500 ms", "when; it stays"},
          kOffset,
          {"bit", Number(kByteBits), kOptional, "4", "bit of the byte; default 0"},
          {"level", OneOf<kLevelWords>(), "0", "1", "what it reads as from then on"}}),
    Kind("standstill", "fault", "The processor stands still: the node does nothing any more until a power cycle.",
         {kNodeKey, kAtKey}),
    Section("config", "a configuration value", "A value of the configuration that a channel keeps.",
            {{"srdo", Number(kSrdos), kOptional, "1", "number of the SRDO; not with the device's own fields"},
             {"field", OneOf<kConfigFieldWords>(), kNeeded, "sct", "the value"},
             {"entry", Number({1U, 128U}), kOptional, "2", "of map_entry: which one"}}),
    Kind("skipped", "lasting", "The call of a channel is not made.", {PartOf(OneOf<kChannelWords>()), kCall, kCalls}),
    Kind("doubled", "lasting", "The call of a channel is made twice.", {PartOf(OneOf<kChannelWords>()), kCall, kCalls}),
    Kind("hung", "fault", "A call into that part never returns; the node does nothing any more until a power cycle.",
         {kNodeKey, PartOf(OneOf<kPartWords>()), kAtKey}),
    Kind("frozen", "lasting", "The part does not run and repeats its last answer to everything.",
         {PartOf(OneOf<kPartWords>())}),
    Kind("not_called", "lasting", "No call reaches the part; whoever asks it finds zeros.",
         {PartOf(OneOf<kPartWords>())}),
    Kind("always_good", "lasting",
         "Whatever its inputs, the part says what a healthy one says when nothing is wrong. A channel: no SRDO faulted "
         "or waiting, each one that it ever released still released with its last pair, guard's token right, nothing "
         "found in the configuration, permits to match. Comparator: what channel A releases is agreed and matched, "
         "right echo. Flow monitor: the right answer to the watchdog's question. Guard: the token of a valid "
         "configuration. Self test: nothing found, all parts sound. Output gate: takes every response for right. "
         "Watchdog: never trips.",
         {PartOf(OneOf<kGoodPartWords>())}),
    Kind("clock", "lasting", "A counter runs fast, slow or not at all, or jumps; one of ppm, stopped and jump.",
         {{"counter", OneOf<kCounterWords>(), kNeeded, "a", "which of the two"},
          {"ppm", T::kPpm, kOptional, "10000", "runs so much fast or slow instead of its drift"},
          {"stopped", OneOf<kYesWords>(), "false", "true", "stands still"},
          {"jump", T::kSignedTime, kOptional, "-3 ms", "jumps forward, or back, once"}}),
    Kind("cycle", "fault", "One cycle, and those after it, come later or earlier; one of late and early.",
         {kNodeKey,
          kAtKey,
          {"late", T::kLasting, kOptional, "3 ms", "so much later"},
          {"early", T::kLasting, kOptional, "700 us", "so much earlier"}}),
    Kind("not_inverse", "lasting", "The application's inverse of this object has wrong bits.",
         {{"object", T::kObject, kNeeded, "0x2000:02", "the normal object of a producer"},
          {"bits", Numbers(kBits), kNeeded, "[3]", "bits of its inverse that are wrong"}}),
    Kind("frozen_input", "lasting", "The input keeps its last value, whatever happens.",
         {{"input", OneOf<kInputWords>(), kNeeded, "acknowledge",
           "acknowledge level of one channel or both, objects that the application writes, challenge of the output "
           "stage, question of the watchdog"}}),
    Kind("permit", "lasting", "A permit reaches the output stage wrong, old or not at all.",
         {{"party", OneOf<kPermitWords>(), kNeeded, "kernel", "whose permit"},
          {"how", OneOf<kPermitHowWords>(), "missing", "old", "one bit wrong, that of the cycle before, or none"}}),
    Kind("watchdog", "lasting", "The watchdog is not served, served twice, or given a wrong or old answer.",
         {{"how", OneOf<kWatchdogHowWords>(), "not_served", "old_answer", "what is wrong"}}),
};
} // namespace counterpoint::simulator
