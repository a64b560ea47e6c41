// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/plan.hpp"

#include "runtime/device/names.hpp"
#include "runtime/yaml/map.hpp"
#include "runtime/yaml/optional_values.hpp"
#include "simulator/scenario/parts.hpp"
#include "verification/campaign/variants.hpp"
#include "verification/campaign/word_list.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <system_error>

namespace counterpoint::campaign
{
namespace
{
using runtime::Word;
using runtime::YamlMap;
using runtime::YamlValue;

constexpr Word<Phase> kPhaseWords[] = {
    {"before_frames", Phase::kBeforeFrames}, {"between_frames", Phase::kBetweenFrames},
    {"after_frames", Phase::kAfterFrames},   {"self_test", static_cast<Phase>(3U)},
    {"clocks", static_cast<Phase>(4U)},      {"guard", static_cast<Phase>(5U)},
    {"channel_a", static_cast<Phase>(6U)},   {"channel_b", static_cast<Phase>(7U)},
    {"comparison", static_cast<Phase>(8U)},  {"demotion", static_cast<Phase>(9U)},
    {"production", static_cast<Phase>(10U)}, {"commit", static_cast<Phase>(11U)},
    {"events", static_cast<Phase>(12U)},     {"permits", static_cast<Phase>(13U)},
};
constexpr Word<Part> kPartWords[] = {
    {"channel_a", Part::kChannelA},
    {"channel_b", Part::kChannelB},
    {"comparator", Part::kComparator},
    {"flow_monitor", Part::kFlowMonitor},
    {"guard", Part::kGuard},
    {"latch", Part::kLatch},
    {"clocks", Part::kClocks},
    {"kernel", Part::kKernel},
    {"tables", Part::kTables},
    {"variables", Part::kVariables},
    {"pins", Part::kPins},
    {"cross_link", Part::kCrossLink},
    {"bus", Part::kBus},
    {"kernel_calls", Part::kKernelCalls},
    {"a_calls", Part::kCallsOfA},
    {"b_calls", Part::kCallsOfB},
    {"steps", Part::kSteps},
    {"counters", Part::kCounters},
    {"cycle", Part::kCycle},
    {"both_channels", Part::kBothChannels},
    {"inputs", Part::kInputs},
    {"commands", Part::kCommands},
    {"link", Part::kLink},
    {"cpu", Part::kCpu},
};
constexpr Word<FaultKind> kKindWords[] = {
    {"flip", FaultKind::kFlip},
    {"stuck_at_0", FaultKind::kStuckAt0},
    {"stuck_at_1", FaultKind::kStuckAt1},
    {"intermittent", FaultKind::kIntermittent},
    {"lost", FaultKind::kLost},
    {"repeated", FaultKind::kRepeated},
    {"inserted", FaultKind::kInserted},
    {"wrong_order", FaultKind::kWrongOrder},
    {"delayed", FaultKind::kDelayed},
    {"corrupted", FaultKind::kCorrupted},
    {"wrong_length", FaultKind::kWrongLength},
    {"wrong_identifier", FaultKind::kWrongIdentifier},
    {"pair_repeated", FaultKind::kPairRepeated},
    {"pair_delayed", FaultKind::kPairDelayed},
    {"pair_forged", FaultKind::kPairForged},
    {"skipped", FaultKind::kSkipped},
    {"doubled", FaultKind::kDoubled},
    {"reordered", FaultKind::kReordered},
    {"late", FaultKind::kLate},
    {"early", FaultKind::kEarly},
    {"stopped", FaultKind::kStopped},
    {"fast", FaultKind::kFast},
    {"slow", FaultKind::kSlow},
    {"jump", FaultKind::kJump},
    {"wrong_command", FaultKind::kWrongCommand},
};
constexpr Word<OutputKind> kOutputWords[] = {
    {"gate", OutputKind::kGate},
    {"pins", OutputKind::kPins},
};
constexpr Word<Detector> kDetectorWords[] = {
    {"comparator", Detector::kComparator},
    {"flow_monitor", Detector::kFlowMonitor},
    {"guard", Detector::kGuard},
    {"seal", Detector::kSeal},
    {"clocks", Detector::kClocks},
    {"channels", Detector::kChannels},
    {"permits", Detector::kPermits},
    {"watchdog", Detector::kWatchdog},
    {"pins", Detector::kPins},
    {"self_test", Detector::kSelfTest},
    {"cross_link", Detector::kCrossLink},
};
/// Of `known`.
constexpr Word<Class> kFindingWords[] = {
    {"silent", Class::kSilent},
    {"exposed", Class::kExposed},
    {"late", Class::kDetected},
};

static_assert(sizeof(kPhaseWords) / sizeof(kPhaseWords[0]) == kPhaseCount, "a word each");
static_assert(sizeof(kPartWords) / sizeof(kPartWords[0]) == kPartCount, "a word each");
static_assert(sizeof(kKindWords) / sizeof(kKindWords[0]) == kFaultKindCount, "a word each");

/// Where each word of a list is; none where the key is missing.
std::vector<runtime::Source> SourcesOf(const YamlMap& map, const char* const key)
{
    std::vector<runtime::Source> sources;
    if (const std::optional<YamlValue> list = map.Find(key))
    {
        for (const YamlValue& item : list->Items("a list of words"))
        {
            sources.push_back(item.Where());
        }
    }
    return sources;
}

/// The items of a list that has one at least; none where the key is missing.
std::vector<YamlValue> SomeItems(const YamlMap& map, const char* const key, const std::string& expected)
{
    const std::optional<YamlValue> list = map.Find(key);
    std::vector<YamlValue> items = list ? list->Items("a list of " + expected) : std::vector<YamlValue>{};
    if (list && items.empty())
    {
        list->Refuse("an empty list", "at least one of " + expected);
    }
    return items;
}

std::uint64_t HashOf(const std::string& text)
{
    std::uint64_t hash = 0xCBF29CE484222325U;
    for (const char character : text)
    {
        hash = (hash ^ static_cast<std::uint8_t>(character)) * 0x100000001B3U;
    }
    return hash;
}

void ReadInstants(const YamlMap& map, Plan& plan)
{
    const YamlValue at = map.Require("at");
    plan.at_source = at.Where();
    for (const YamlValue& item : at.Items("a list of times"))
    {
        plan.at.push_back(item.Lasting());
        if (plan.at.size() > 1U && plan.at.back() <= plan.at[plan.at.size() - 2U])
        {
            item.Refuse("a time that is not later than the one before", "ascending times");
        }
    }
    if (plan.at.empty())
    {
        at.Refuse("an empty list", "at least one time");
    }
}

void ReadMembers(const YamlMap& map, Plan& plan)
{
    for (const YamlValue& item : SomeItems(map, "members", "members"))
    {
        const std::string text = item.Text("a member, or a byte of it as channel_b.data+0");
        const std::size_t plus = text.find('+');
        Member member{text.substr(0U, plus), std::nullopt, item.Where()};
        if (plus != std::string::npos)
        {
            std::size_t byte = 0U;
            const char* const end = text.data() + text.size();
            const auto [stop, error] = std::from_chars(text.data() + plus + 1U, end, byte);
            if (error != std::errc() || stop != end)
            {
                item.Refuse(runtime::Shown(text), "a member, or a byte of it as channel_b.data+0");
            }
            member.byte = byte;
        }
        if (std::any_of(plan.members.begin(), plan.members.end(),
                        [&member](const Member& each) { return each.name == member.name && each.byte == member.byte; }))
        {
            item.Refuse("the same member twice", "each once");
        }
        plan.members.push_back(member);
    }
}

/// As channel_b.srvt.
void ReadVoices(const YamlMap& map, Plan& plan)
{
    for (const YamlValue& item : SomeItems(map, "voices", "causes"))
    {
        const std::string text = item.Text("a cause of one channel, as channel_b.srvt");
        const bool is_a = text.rfind("channel_a.", 0U) == 0U;
        const bool is_b = text.rfind("channel_b.", 0U) == 0U;
        const std::string word = text.substr(text.find('.') + 1U);
        const auto* const found = std::find_if(std::begin(runtime::kCauseWords), std::end(runtime::kCauseWords),
                                               [&word](const auto& each) { return word == each.text; });
        const bool is_cause = found != std::end(runtime::kCauseWords) && found->meaning != SrdoCause::kNone;
        if ((!is_a && !is_b) || !is_cause)
        {
            item.Refuse(runtime::Shown(text), "a cause of one channel, as channel_b.srvt");
        }
        if (std::any_of(plan.voices.begin(), plan.voices.end(),
                        [&text](const Voice& each) { return each.name == text; }))
        {
            item.Refuse("the same voice twice", "each once");
        }
        plan.voices.push_back({text, is_a ? kMarkSaidByA : kMarkSaidByB, found->meaning});
    }
}

void ReadKnown(const YamlMap& map, Plan& plan)
{
    for (const YamlValue& item : SomeItems(map, "known", "places with a reason"))
    {
        const YamlMap known(plan.file, item.Node(), {"place", "class", "reason"});
        const YamlValue reason = known.Require("reason");
        const YamlValue place = known.Require("place");
        plan.known.push_back({place.Text("a member, byte or bit, as comparator.verdict+8.0"),
                              reason.Text("who answers for it"), std::nullopt, place.Where()});
        if (plan.known.back().reason.empty())
        {
            reason.Refuse("an empty text", "who answers for it");
        }
        if (const auto result = known.Find("class"))
        {
            plan.known.back().result = result->Choice(kFindingWords);
        }
    }
}

void ReadSample(const YamlMap& map, Plan& plan)
{
    constexpr std::uint64_t kMost = 10'000'000U;
    if (const auto sample = map.Find("sample"); sample && sample->Node().scalar != "all")
    {
        plan.sample = sample->Number({1U, kMost});
    }
    if (const auto seed = map.Find("seed"))
    {
        plan.seed = seed->Number({0U, ~std::uint64_t{0U}});
    }
    if (const auto confidence = map.Find("confidence"))
    {
        plan.confidence_percent = static_cast<std::uint32_t>(confidence->Number({50U, 99U}));
    }
    if (const auto reach = map.Find("reach"))
    {
        constexpr runtime::Nanoseconds kMostReach = 1000 * runtime::kNanosecondsPerMillisecond;
        plan.reach = reach->Lasting();
        if (plan.reach < kGrid || plan.reach > kMostReach || plan.reach % kGrid != 0)
        {
            reach->Refuse("a reach that is no multiple of the grid of 50 us within a second", "a time as 60 ms");
        }
    }
    if (const auto cycles = map.Find("cycles"))
    {
        plan.cycles = static_cast<std::uint32_t>(cycles->Number({1U, 1000U}));
    }
}

void RequireReach(const YamlMap& map, const Plan& plan)
{
    const std::optional<YamlValue> reach = map.Find("reach");
    const auto moves = [&plan](const Part part)
    {
        return std::any_of(plan.kinds.begin(), plan.kinds.end(),
                           [part](const FaultKind kind) { return HasReach(part, kind); });
    };
    if (reach && std::none_of(plan.parts.begin(), plan.parts.end(), moves))
    {
        reach->Refuse("a reach where nothing moves in time", "a part and kind that does, or no reach");
    }
}

/// A kind of none of the parts, and phases where no memory is hit, would be left aside.
void RequireEffect(const YamlMap& map, const Plan& plan)
{
    const auto is_memory = [](const Part part) { return IsMemory(part); };
    const std::optional<YamlValue> phases = map.Find("phases");
    if (phases && std::none_of(plan.parts.begin(), plan.parts.end(), is_memory))
    {
        phases->Refuse("phases where nothing of the memory is hit", "a part of the memory, or no phases");
    }
    const std::optional<YamlValue> kinds = map.Find("kinds");
    if (!kinds)
    {
        return;
    }
    const std::vector<YamlValue> items = kinds->Items("a list of words");
    for (std::size_t index = 0U; index < items.size(); ++index)
    {
        const FaultKind kind = plan.kinds[index];
        if (std::none_of(plan.parts.begin(), plan.parts.end(), [kind](const Part part) { return IsOf(part, kind); }))
        {
            items[index].Refuse("a kind that none of the parts has", "one of its kinds");
        }
    }
}
} // namespace

Plan ReadPlan(const std::string& file)
{
    std::error_code error;
    if (!std::filesystem::exists(file, error) && !error)
    {
        throw runtime::YamlError(file, {}, "no such file", "the plan of a campaign");
    }
    const std::string text = runtime::ReadYamlText(file);
    const runtime::YamlNode root = runtime::ParseYaml(file, text);
    const YamlMap map(file, root,
                      {"title", "scenario", "device", "at", "cycles", "phases", "parts", "members", "kinds",
                       "detectors", "known", "voices", "reach", "self_test", "seed", "sample", "confidence", "output"});
    Plan plan;
    plan.file = file;
    plan.digest = HashOf(text);
    plan.title = TitleOf(map);
    const YamlValue scenario = map.Require("scenario");
    plan.scenario = simulator::Beside(file, scenario.Text("the file name of a scenario"));
    simulator::RequireFile(plan.scenario, scenario.Where(), "a scenario");
    plan.device_node = map.Require("device").Node();
    ReadInstants(map, plan);
    plan.phases = Chosen(map, "phases", kPhaseWords);
    plan.parts = Chosen(map, "parts", kPartWords);
    if (!map.Find("parts"))
    {
        plan.parts.resize(kMemoryPartCount); // The others are tried by name.
    }
    plan.part_sources = SourcesOf(map, "parts");
    plan.kinds = Chosen(map, "kinds", kKindWords);
    plan.kind_sources = SourcesOf(map, "kinds");
    RequireEffect(map, plan);
    plan.detectors = map.Find("detectors") ? Chosen(map, "detectors", kDetectorWords) : std::vector<Detector>{};
    ReadMembers(map, plan);
    ReadSample(map, plan);
    RequireReach(map, plan);
    ReadVoices(map, plan);
    ReadKnown(map, plan);
    if (const auto self_test = map.Find("self_test"))
    {
        plan.has_self_test = self_test->Choice(runtime::kTruthWords);
    }
    if (const auto output = map.Find("output"))
    {
        plan.output = output->Choice(kOutputWords);
    }
    return plan;
}

bool IsOf(const Part part, const FaultKind kind)
{
    const auto is_from_to = [kind](const FaultKind first, const FaultKind last)
    { return kind >= first && kind <= last; };
    if (part == Part::kBus)
    {
        return is_from_to(FaultKind::kLost, FaultKind::kPairForged);
    }
    if (part == Part::kKernelCalls || part == Part::kCallsOfA || part == Part::kCallsOfB || part == Part::kSteps)
    {
        return is_from_to(FaultKind::kSkipped, FaultKind::kLate);
    }
    if (part == Part::kCycle)
    {
        return is_from_to(FaultKind::kSkipped, FaultKind::kEarly) && kind != FaultKind::kReordered;
    }
    if (part == Part::kCounters)
    {
        return is_from_to(FaultKind::kStopped, FaultKind::kJump);
    }
    if (part == Part::kCommands)
    {
        return kind == FaultKind::kSkipped || kind == FaultKind::kDoubled || kind == FaultKind::kLate ||
               kind == FaultKind::kInserted || kind == FaultKind::kWrongCommand;
    }
    if (part == Part::kLink)
    {
        return kind == FaultKind::kLost || kind == FaultKind::kRepeated || kind == FaultKind::kWrongOrder ||
               kind == FaultKind::kDelayed || kind == FaultKind::kCorrupted;
    }
    if (part == Part::kCpu)
    {
        return is_from_to(FaultKind::kStopped, FaultKind::kSlow);
    }
    if (part == Part::kInputs)
    {
        return kind == FaultKind::kStuckAt0 || kind == FaultKind::kStuckAt1;
    }
    return is_from_to(FaultKind::kFlip, (part == Part::kBothChannels) ? FaultKind::kFlip : FaultKind::kIntermittent);
}

bool HasReach(const Part part, const FaultKind kind)
{
    if (part == Part::kCycle)
    {
        return kind == FaultKind::kLate; // An early one moves within its cycle.
    }
    const bool is_later =
        kind == FaultKind::kRepeated || kind == FaultKind::kInserted || kind == FaultKind::kDelayed || IsOfPair(kind);
    return (part == Part::kBus || part == Part::kLink) && is_later;
}

const char* WordOf(const Phase phase)
{
    return TextOf(kPhaseWords, phase);
}

const char* WordOf(const Part part)
{
    return TextOf(kPartWords, part);
}

const char* WordOf(const FaultKind kind)
{
    return TextOf(kKindWords, kind);
}
} // namespace counterpoint::campaign
