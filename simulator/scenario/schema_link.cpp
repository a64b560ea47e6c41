// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/scenario/names.hpp"
#include "simulator/scenario/schema.hpp"

#include "hal/api/cross_link.hpp"

// The faults of the link between two CPUs. [SRS_SIM_047, SRS_SIM_057]
namespace counterpoint::simulator
{
namespace
{
using T = ValueType;
constexpr Range kMessagesAgo{1U, 64U};
constexpr Range kMillionths{1U, 1000000U};
constexpr Range kTimes{1U, 1000U};
constexpr Range kCounts{1U, 0x7FFFFFFFU};
constexpr Range kBits{0U, hal::kLinkFrameBytes * 8U - 1U};
} // namespace

const std::vector<SectionSpec> kLinkFaultSections{
    Kind("on_messages", "fault", "Faults that hit chosen messages between two CPUs; a message is sent in each cycle.",
         {{"node", T::kNode, kNeeded, "actuator", "a node with 'structure: two_cpu'"},
          {"sender", OneOf<kCounterWords>(), "both", "a", "messages of this CPU"},
          {"at", T::kDuration, kNeeded, "500 ms", "not before"},
          {"until", T::kDuration, kOptional, "700 ms", "not from then on"},
          {"on", T::kLasting, kOptional, "5 ms", "intermittent: messages within so long"},
          {"off", T::kLasting, kOptional, "20 ms", "intermittent: then none for so long, again and again"},
          {"first", Number(kCounts), "1", "3", "from the n-th message of each direction that fits"},
          {"every", Number(kCounts), "1", "10", "from there on every n-th"},
          {"count", Number(kCounts), "2147483647", "2", "at most so many of each direction"},
          {"probability_ppm", Number(kMillionths), "1000000", "500", "by chance, drawn from the seed"}}),
    Kind("link_loss", "on_messages", "The message does not arrive."),
    Kind("link_delay", "on_messages", "The message arrives later.",
         {{"by", T::kLasting, kNeeded, "4 ms", "so much later; others may overtake it"}}),
    Kind("link_repetition", "on_messages", "The message arrives again.",
         {{"times", Number({1U, 100U}), "1", "3", "how many copies"},
          {"after", T::kDuration, "0 ms", "3 ms", "time between two of them"}}),
    Kind("link_reordering", "on_messages", "The message arrives after the next one; of neighbours every other one."),
    Kind("link_corruption", "on_messages", "The message arrives changed.",
         {{"bits", Numbers(kBits), kNeeded, "[0, 1000]", "these bits are flipped (0 is bit 0 of byte 0)"}}),
    Kind("link_insertion", "fault", "A message arrives that the other CPU did not send.",
         {{"node", T::kNode, kNeeded, "actuator", "a node with 'structure: two_cpu'"},
          {"sender", OneOf<kCounterWords>(), "both", "a", "as if it came from this CPU"},
          {"at", T::kDuration, kNeeded, "500 ms", "when the first one comes"},
          {"what", OneOf<kInsertedWords>(), "noise", "earlier",
           "bytes drawn from the seed, or a message that was sent before"},
          {"back", Number(kMessagesAgo), kOptional, "5", "of earlier: so many messages ago"},
          {"times", Number(kTimes), "1", "3", "how many messages"},
          {"every", T::kLasting, kOptional, "2 ms", "time between two of them"}}),
    Kind("link_cut", "on_messages", "Nothing gets through; what is under way arrives."),
};
} // namespace counterpoint::simulator
