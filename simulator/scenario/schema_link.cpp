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
constexpr Range kNone{0U, 0U};
constexpr Range kMessagesAgo{1U, 64U};
constexpr Range kMillionths{1U, 1000000U};
constexpr Range kTimes{1U, 1000U};
constexpr Range kCounts{1U, 0x7FFFFFFFU};
constexpr Range kBits{0U, hal::kLinkFrameBytes * 8U - 1U};

SectionSpec Kind(const char* const name, std::vector<KeySpec> keys, const char* const meaning)
{
    return {name, "a fault", {"on_messages"}, std::move(keys), meaning};
}

const std::vector<SectionSpec> kLinkFaultSections{
    {"on_messages",
     "a fault",
     {"fault"},
     {
         {"node", T::kNode, kNone, nullptr, nullptr, kNeeded, "actuator", "a node with 'structure: two_cpu'"},
         {"sender", T::kWord, kNone, &WordsOf<kCounterWords>, nullptr, "both", "a", "messages of this CPU"},
         {"at", T::kDuration, kNone, nullptr, nullptr, kNeeded, "500 ms", "not before"},
         {"until", T::kDuration, kNone, nullptr, nullptr, nullptr, "700 ms", "not from then on"},
         {"on", T::kLasting, kNone, nullptr, nullptr, nullptr, "5 ms", "intermittent: messages within so long"},
         {"off", T::kLasting, kNone, nullptr, nullptr, nullptr, "20 ms",
          "intermittent: then none for so long, again and again"},
         {"first", T::kNumber, kCounts, nullptr, nullptr, "1", "3",
          "from the n-th message of each direction that fits"},
         {"every", T::kNumber, kCounts, nullptr, nullptr, "1", "10", "from there on every n-th"},
         {"count", T::kNumber, kCounts, nullptr, nullptr, "2147483647", "2", "at most so many of each direction"},
         {"probability_ppm", T::kNumber, kMillionths, nullptr, nullptr, "1000000", "500",
          "by chance, drawn from the seed"},
     },
     "Faults that hit chosen messages between two CPUs; a message is sent in each cycle."},
    Kind("link_loss", {}, "The message does not arrive."),
    Kind("link_delay",
         {{"by", T::kLasting, kNone, nullptr, nullptr, kNeeded, "4 ms", "so much later; others may overtake it"}},
         "The message arrives later."),
    Kind("link_repetition",
         {{"times", T::kNumber, {1U, 100U}, nullptr, nullptr, "1", "3", "how many copies"},
          {"after", T::kDuration, kNone, nullptr, nullptr, "0 ms", "3 ms", "time between two of them"}},
         "The message arrives again."),
    Kind("link_reordering", {}, "The message arrives after the next one; of neighbours every other one."),
    Kind("link_corruption",
         {{"bits", T::kNumbers, kBits, nullptr, nullptr, kNeeded, "[0, 1000]",
           "these bits are flipped (0 is bit 0 of byte 0)"}},
         "The message arrives changed."),
    {"link_insertion",
     "a fault",
     {"fault"},
     {
         {"node", T::kNode, kNone, nullptr, nullptr, kNeeded, "actuator", "a node with 'structure: two_cpu'"},
         {"sender", T::kWord, kNone, &WordsOf<kCounterWords>, nullptr, "both", "a", "as if it came from this CPU"},
         {"at", T::kDuration, kNone, nullptr, nullptr, kNeeded, "500 ms", "when the first one comes"},
         {"what", T::kWord, kNone, &WordsOf<kInsertedWords>, nullptr, "noise", "earlier",
          "bytes drawn from the seed, or a message that was sent before"},
         {"back", T::kNumber, kMessagesAgo, nullptr, nullptr, nullptr, "5", "of earlier: so many messages ago"},
         {"times", T::kNumber, kTimes, nullptr, nullptr, "1", "3", "how many messages"},
         {"every", T::kLasting, kNone, nullptr, nullptr, nullptr, "2 ms", "time between two of them"},
     },
     "A message arrives that the other CPU did not send."},
    Kind("link_cut", {}, "Nothing gets through; what is under way arrives."),
};
} // namespace

std::vector<SectionSpec> LinkFaultSections()
{
    return kLinkFaultSections;
}
} // namespace counterpoint::simulator
