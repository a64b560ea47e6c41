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
constexpr Range kNone{0U, 0U};
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

SectionSpec Kind(const char* const name, std::vector<const char*> parents, std::vector<KeySpec> keys,
                 const char* const meaning)
{
    return {name, "a fault", std::move(parents), std::move(keys), meaning};
}

KeySpec Identifier()
{
    return {"identifier", T::kNumber, kIdentifiers, nullptr, nullptr, kNeeded, "0x104", "COB-ID of the frame"};
}

KeySpec PartOf(std::string (*words)())
{
    return {"part", T::kWord, kNone, words, nullptr, kNeeded, "channel_a", "the part that is hit"};
}
} // namespace

namespace
{
const std::vector<SectionSpec> kFrameFaultSections{
    {"fault",
     "a fault",
     {},
     {
         {"fault", T::kWord, kNone, &WordsOf<kFaultKinds>, nullptr, kNeeded, "loss", "the kind"},
         {"name", T::kText, kNone, nullptr, nullptr, nullptr, "one frame lost",
          "shown to people, named by expectations; default: the kind"},
         {"optional", T::kWord, kNone, &WordsOf<kYesWords>, nullptr, "false", "true",
          "may never have an effect; else a fault that never happened fails the scenario"},
     },
     "Every fault; its other keys follow from its kind."},
    {"on_frames",
     "a fault",
     {"fault"},
     {
         {"frames", T::kMap, kNone, nullptr, "frames", kNeeded, "{identifier: 0x104, from: 500 ms}", "which frames"},
     },
     "Faults that hit chosen frames."},
    {"lasting",
     "a fault",
     {"fault"},
     {
         {"node", T::kNode, kNone, nullptr, nullptr, kNeeded, "actuator", "which node"},
         {"at", T::kDuration, kNone, nullptr, nullptr, kNeeded, "500 ms", "when it begins"},
         {"until", T::kDuration, kNone, nullptr, nullptr, nullptr, "700 ms", "when it is over; default: it stays"},
         {"on", T::kLasting, kNone, nullptr, nullptr, nullptr, "5 ms", "intermittent: there for so long"},
         {"off", T::kLasting, kNone, nullptr, nullptr, nullptr, "20 ms",
          "intermittent: then gone for so long, again and again"},
     },
     "Faults that begin and end."},
    {"foreign",
     "a fault",
     {"fault"},
     {
         {"at", T::kDuration, kNone, nullptr, nullptr, kNeeded, "500 ms", "when the first one comes"},
         Identifier(),
         {"kind", T::kWord, kNone, &WordsOf<kFrameKindWords>, nullptr, "data", "remote", "what kind of frame"},
         {"data", T::kNumbers, {0U, 255U}, nullptr, nullptr, nullptr, "[0xFE, 0x01]", "its bytes, at most 8"},
         {"times", T::kNumber, kFrames, nullptr, nullptr, "1", "3", "how many frames"},
         {"every", T::kLasting, kNone, nullptr, nullptr, nullptr, "2 ms", "time between two of them"},
     },
     "Faults that bring frames of their own."},
    {"frames",
     "a choice of frames",
     {},
     {
         {"identifier", T::kOneOrMore, kIdentifiers, nullptr, nullptr, nullptr, "[0x103, 0x104]",
          "COB-ID or list of COB-IDs; default: any"},
         {"srdo", T::kMap, kNone, nullptr, "frames_of", nullptr, "{node: actuator, srdo: 1}",
          "instead: the frames of an SRDO"},
         {"sender", T::kNode, kNone, nullptr, nullptr, nullptr, "controller", "default: any"},
         {"receiver", T::kNode, kNone, nullptr, nullptr, nullptr, "actuator", "default: every receiver"},
         {"controller", T::kNumber, kControllers, nullptr, nullptr, nullptr, "2", "of the receiver; default: each"},
         {"from", T::kDuration, kNone, nullptr, nullptr, "0 ms", "500 ms", "not before"},
         {"until", T::kDuration, kNone, nullptr, nullptr, nullptr, "700 ms", "not from then on"},
         {"on", T::kLasting, kNone, nullptr, nullptr, nullptr, "5 ms",
          "intermittent: counted from 'from', frames within so long"},
         {"off", T::kLasting, kNone, nullptr, nullptr, nullptr, "20 ms",
          "intermittent: then none for so long, again and again"},
         {"first", T::kNumber, kCounts, nullptr, nullptr, "1", "3", "from the n-th frame that fits"},
         {"every", T::kNumber, kCounts, nullptr, nullptr, "1", "10", "from there on every n-th"},
         {"count", T::kNumber, kCounts, nullptr, nullptr, "1", "6", "at most so many"},
         {"probability_ppm", T::kNumber, kMillionths, nullptr, nullptr, "1000000", "500",
          "by chance, drawn from the seed"},
     },
     "Chooses frames; everything that is said has to fit."},
    {"frames_of",
     "the frames of an SRDO",
     {},
     {
         {"node", T::kNode, kNone, nullptr, nullptr, kNeeded, "actuator", "a node that has the SRDO"},
         {"srdo", T::kNumber, kSrdos, nullptr, nullptr, kNeeded, "1", "its number there"},
         {"which", T::kWord, kNone, &WordsOf<kFrameSideWords>, nullptr, "both", "inverse",
          "COB-ID 1, COB-ID 2 or both"},
     },
     "Frames by SRDO instead of by COB-ID."},
    Kind("corruption", {"on_frames"},
         {
             {"bits", T::kNumbers, kBits, nullptr, nullptr, nullptr, "[0, 15]",
              "these bits are flipped (0 is bit 0 of byte 0)"},
             {"length", T::kNumber, {0U, 8U}, nullptr, nullptr, nullptr, "1", "the length is another"},
         },
         "The frame arrives changed; the CRC of the bus did not see it."),
    Kind("repetition", {"on_frames"},
         {
             {"times",
              T::kNumber,
              {1U, host::ReceptionList::kCapacity - 1U},
              nullptr,
              nullptr,
              "1",
              "3",
              "how many copies"},
             {"after", T::kDuration, kNone, nullptr, nullptr, "0 ms", "3 ms", "time between two of them"},
         },
         "The frame arrives again; copies that do not fit into 16 receptions are told."),
    Kind("wrong_sequence", {"on_frames"}, {}, "The frame arrives after the next one."),
    Kind("loss", {"on_frames"}, {}, "The frame does not arrive."),
    Kind("delay", {"on_frames"},
         {
             {"by", T::kLasting, kNone, nullptr, nullptr, kNeeded, "60 ms", "so much later; others may overtake it"},
         },
         "The frame arrives later."),
    Kind("addressing", {"on_frames"},
         {
             {"as", T::kNumber, kShortIdentifiers, nullptr, nullptr, kNeeded, "0x104", "the other COB-ID"},
         },
         "The frame arrives under another COB-ID."),
    Kind("store_and_forward", {"on_frames"},
         {
             {"by", T::kLasting, kNone, nullptr, nullptr, kNeeded, "20 ms", "how long each frame is kept"},
             {"gap", T::kDuration, kNone, nullptr, nullptr, "0 ms", "1 ms",
              "least time between two frames that it lets go"},
         },
         "A device between the segments keeps frames and lets them go in their order, one after the other."),
    Kind("duplicate", {"on_frames"},
         {
             {"after", T::kDuration, kNone, nullptr, nullptr, "0 ms", "2 ms", "so much after the end of the frame"},
         },
         "Another controller, which is no node's, sends the same frame on the bus."),
    Kind("wire_error", {"on_frames"},
         {
             {"bit", T::kNumber, {0U, 156U}, nullptr, nullptr, "20", "30", "bit on the wire that is hit, 0 is SOF"},
         },
         "A disturbance destroys the frame for all; controllers count the error and send again."),
    Kind("queue_full", {"on_frames"}, {}, "The controller's transmit queue refuses the frame."),
    Kind("swallowed", {"on_frames"}, {}, "The controller takes the frame and never sends it."),
    Kind("confirmation", {"on_frames"},
         {
             {"how", T::kWord, kNone, &WordsOf<kConfirmationHowWords>, nullptr, "missing", "late",
              "what is wrong with it"},
             {"by", T::kLasting, kNone, nullptr, nullptr, nullptr, "30 ms", "of late: so much"},
             {"bits", T::kNumbers, kBits, nullptr, nullptr, nullptr, "[0]", "of wrong: these bits are flipped"},
         },
         "The sender's confirmation (its echo) is missing, late or wrong."),
    Kind("insertion", {"foreign"},
         {
             {"receiver", T::kNode, kNone, nullptr, nullptr, nullptr, "actuator", "who gets it; default: every node"},
         },
         "A frame arrives that nobody sent."),
    Kind("masquerade", {"foreign"},
         {
             {"node", T::kNode, kNone, nullptr, nullptr, kNeeded, "sensor", "who sends it"},
         },
         "A node sends a frame that is another node's."),
    Kind("babbling", {"fault"},
         {
             {"at", T::kDuration, kNone, nullptr, nullptr, kNeeded, "500 ms", "when it begins"},
             {"until", T::kDuration, kNone, nullptr, nullptr, nullptr, "700 ms", "when it is over; default: it stays"},
             {"on", T::kLasting, kNone, nullptr, nullptr, nullptr, "5 ms", "intermittent: there for so long"},
             {"off", T::kLasting, kNone, nullptr, nullptr, nullptr, "20 ms",
              "intermittent: then gone for so long, again and again"},
             {"identifier", T::kNumber, kShortIdentifiers, nullptr, nullptr, "0", "0x001",
              "COB-ID of its frames; the lowest wins the bus"},
             {"data", T::kNumbers, {0U, 255U}, nullptr, nullptr, nullptr, "[0x55]", "their bytes, at most 8"},
         },
         "A controller, which is no node's, sends one frame after the other without a pause."),
};
} // namespace

std::vector<SectionSpec> FrameFaultSections()
{
    return kFrameFaultSections;
}

namespace
{
const KeySpec controller{"controller", T::kNumber, kControllers, nullptr,
                         nullptr,      nullptr,    "2",          "of a node with two: this one alone; default: each"};
const std::vector<SectionSpec> kNodeFaultSections{
    Kind("bus_off", {"lasting"}, {controller},
         "The controller goes bus-off: its queue is lost, it neither sends nor receives until it recovers at the "
         "end."),
    Kind("unplugged", {"lasting"}, {controller},
         "The cable of the controller is off: it neither sends nor receives, and keeps its queue."),
    Kind("queue_overflow", {"lasting"},
         {
             {"capacity", T::kNumber, kFrames, nullptr, nullptr, "1", "4", "frames that the queue holds"},
         },
         "The node takes frames only at its cycles, from a reception queue that is too small."),
    Kind("bit_flip", {"fault"},
         {
             {"node", T::kNode, kNone, nullptr, nullptr, kNeeded, "actuator", "which node"},
             PartOf(&WordsOf<kMemoryWords>),
             {"at", T::kDuration, kNone, nullptr, nullptr, kNeeded, "500 ms", "when"},
             {"offset", T::kNumber, kOffsets, nullptr, nullptr, nullptr, "12",
              "byte of the part; default: chosen by the seed, with its bit"},
             {"config", T::kMap, kNone, nullptr, "config", nullptr, "{srdo: 1, field: sct}",
              "of a channel, instead: where it keeps this value"},
             {"bit", T::kNumber, kWordBits, nullptr, nullptr, nullptr, "4",
              "bit of the byte (0 to 7) or of the value; default 0"},
             {"srdo", T::kNumber, kSrdos, nullptr, nullptr, nullptr, "1",
              "of setup and safe_value: of which SRDO; default: of the first"},
         },
         "A bit flips: in the storage of a channel, in the kernel object or a part of it, in the table of SRDO "
         "setups, in a safe value, in the table of mappable objects, or in the mappable variables; and in what the "
         "self tests watch: the node's copy of the program of channels and kernel, the constant times of its "
         "description, the guard words of its stack, the pointers to the virtual tables of its parts (8 bytes each: "
         "channel A, channel B, output, watchdog, application)."),
    Kind("stuck_bit", {"fault"},
         {
             {"node", T::kNode, kNone, nullptr, nullptr, kNeeded, "actuator", "which node"},
             PartOf(&WordsOf<kLiveWords>),
             {"at", T::kDuration, kNone, nullptr, nullptr, kNeeded, "500 ms", "when; it stays"},
             {"offset", T::kNumber, kOffsets, nullptr, nullptr, nullptr, "12",
              "byte of the part; default: chosen by the seed, with its bit"},
             {"bit", T::kNumber, kByteBits, nullptr, nullptr, nullptr, "4", "bit of the byte; default 0"},
             {"level", T::kWord, kNone, &WordsOf<kLevelWords>, nullptr, "0", "1", "what it reads as from then on"},
         },
         "A cell of live memory stays at one level, whatever is written: before each call into the node, and at each "
         "access of the march."),
    Kind("standstill", {"fault"},
         {
             {"node", T::kNode, kNone, nullptr, nullptr, kNeeded, "actuator", "which node"},
             {"at", T::kDuration, kNone, nullptr, nullptr, kNeeded, "500 ms", "when"},
         },
         "The processor stands still: the node does nothing any more until a power cycle."),
    {"config",
     "a configuration value",
     {},
     {
         {"srdo", T::kNumber, kSrdos, nullptr, nullptr, nullptr, "1",
          "number of the SRDO; not with the device's own fields"},
         {"field", T::kWord, kNone, &WordsOf<kConfigFieldWords>, nullptr, kNeeded, "sct", "the value"},
         {"entry", T::kNumber, {1U, 128U}, nullptr, nullptr, nullptr, "2", "of map_entry: which one"},
     },
     "A value of the configuration that a channel keeps."},
    Kind("skipped", {"lasting"},
         {
             PartOf(&WordsOf<kChannelWords>),
             {"call", T::kWord, kNone, &WordsOf<kCallWords>, nullptr, "OnCycle", "OnFrame", "which call"},
             {"count", T::kNumber, kCounts, nullptr, nullptr, nullptr, "1", "how often; default: all the time"},
         },
         "The call of a channel is not made."),
    Kind("doubled", {"lasting"},
         {
             PartOf(&WordsOf<kChannelWords>),
             {"call", T::kWord, kNone, &WordsOf<kCallWords>, nullptr, "OnCycle", "OnFrame", "which call"},
             {"count", T::kNumber, kCounts, nullptr, nullptr, nullptr, "1", "how often; default: all the time"},
         },
         "The call of a channel is made twice."),
    Kind("hung", {"fault"},
         {
             {"node", T::kNode, kNone, nullptr, nullptr, kNeeded, "actuator", "which node"},
             PartOf(&WordsOf<kPartWords>),
             {"at", T::kDuration, kNone, nullptr, nullptr, kNeeded, "500 ms", "when"},
         },
         "A call into that part never returns; the node does nothing any more until a power cycle."),
    Kind("frozen", {"lasting"}, {PartOf(&WordsOf<kPartWords>)},
         "The part does not run and repeats its last answer to everything."),
    Kind("not_called", {"lasting"}, {PartOf(&WordsOf<kPartWords>)},
         "No call reaches the part; whoever asks it finds zeros."),
    Kind("always_good", {"lasting"}, {PartOf(&WordsOf<kGoodPartWords>)},
         "Whatever its inputs, the part says what a healthy one says when nothing is wrong. A channel: no SRDO "
         "faulted or waiting, each one that it ever "
         "released still released with its last pair, guard's token right, nothing found in the configuration, "
         "permits to match. Comparator: what channel A "
         "releases is agreed and matched, right echo. Flow monitor: the right answer to the watchdog's question. "
         "Guard: the token of a valid configuration. Self test: nothing found, all parts sound. Output gate: takes "
         "every response for right. Watchdog: never trips."),
    Kind("clock", {"lasting"},
         {
             {"counter", T::kWord, kNone, &WordsOf<kCounterWords>, nullptr, kNeeded, "a", "which of the two"},
             {"ppm", T::kPpm, kNone, nullptr, nullptr, nullptr, "10000",
              "runs so much fast or slow instead of its drift"},
             {"stopped", T::kWord, kNone, &WordsOf<kYesWords>, nullptr, "false", "true", "stands still"},
             {"jump", T::kSignedTime, kNone, nullptr, nullptr, nullptr, "-3 ms", "jumps forward, or back, once"},
         },
         "A counter runs fast, slow or not at all, or jumps; one of ppm, stopped and jump."),
    Kind("cycle", {"fault"},
         {
             {"node", T::kNode, kNone, nullptr, nullptr, kNeeded, "actuator", "which node"},
             {"at", T::kDuration, kNone, nullptr, nullptr, kNeeded, "500 ms", "when"},
             {"late", T::kLasting, kNone, nullptr, nullptr, nullptr, "3 ms", "so much later"},
             {"early", T::kLasting, kNone, nullptr, nullptr, nullptr, "700 us", "so much earlier"},
         },
         "One cycle, and those after it, come later or earlier; one of late and early."),
    Kind("not_inverse", {"lasting"},
         {
             {"object", T::kObject, kNone, nullptr, nullptr, kNeeded, "0x2000:02", "the normal object of a producer"},
             {"bits", T::kNumbers, kBits, nullptr, nullptr, kNeeded, "[3]", "bits of its inverse that are wrong"},
         },
         "The application's inverse of this object has wrong bits."),
    Kind("frozen_input", {"lasting"},
         {
             {"input", T::kWord, kNone, &WordsOf<kInputWords>, nullptr, kNeeded, "acknowledge",
              "acknowledge level of one channel or both, objects that the application writes, challenge of the "
              "output stage, question of the watchdog"},
         },
         "The input keeps its last value, whatever happens."),
    Kind("permit", {"lasting"},
         {
             {"party", T::kWord, kNone, &WordsOf<kPermitWords>, nullptr, kNeeded, "kernel", "whose permit"},
             {"how", T::kWord, kNone, &WordsOf<kPermitHowWords>, nullptr, "missing", "old",
              "one bit wrong, that of the cycle before, or none"},
         },
         "A permit reaches the output stage wrong, old or not at all."),
    Kind(
        "watchdog", {"lasting"},
        {
            {"how", T::kWord, kNone, &WordsOf<kWatchdogHowWords>, nullptr, "not_served", "old_answer", "what is wrong"},
        },
        "The watchdog is not served, served twice, or given a wrong or old answer."),
};
} // namespace

std::vector<SectionSpec> NodeFaultSections()
{
    return kNodeFaultSections;
}
} // namespace counterpoint::simulator
