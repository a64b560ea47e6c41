// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/managed/plan.hpp"

#include "runtime/manager/report/texts.hpp"
#include "runtime/yaml/map.hpp"
#include "simulator/scenario/parts.hpp"
#include "verification/campaign/word_list.hpp"

#include <filesystem>

namespace counterpoint::campaign::managed
{
namespace
{
using runtime::Word;
using runtime::YamlMap;
using runtime::YamlValue;

constexpr Word<Target> kTargetWords[] = {
    {"nmt", Target::kNmt},           {"sdo", Target::kSdo},       {"life", Target::kLife},
    {"election", Target::kElection}, {"srdo", Target::kSrdo},     {"other", Target::kOther},
    {"writes", Target::kWrites},     {"slaves", Target::kSlaves}, {"managers", Target::kManagers},
    {"memory", Target::kMemory},     {"clocks", Target::kClocks},
};
constexpr Word<Fault> kFaultWords[] = {
    {"lost", Fault::kLost},
    {"repeated", Fault::kRepeated},
    {"inserted", Fault::kInserted},
    {"wrong_order", Fault::kWrongOrder},
    {"delayed", Fault::kDelayed},
    {"corrupted", Fault::kCorrupted},
    {"wrong_byte", Fault::kWrongByte},
    {"wrong_length", Fault::kWrongLength},
    {"wrong_identifier", Fault::kWrongIdentifier},
    {"foreign", Fault::kForeign},
    {"stored", Fault::kStored},
    {"restarted", Fault::kRestarted},
    {"pulled", Fault::kPulled},
    {"exchanged", Fault::kExchanged},
    {"killed", Fault::kKilled},
    {"back", Fault::kBack},
    {"off_bus", Fault::kOffBus},
    {"flip", Fault::kFlip},
    {"stopped", Fault::kStopped},
    {"fast", Fault::kFast},
    {"slow", Fault::kSlow},
    {"jump", Fault::kJump},
};
constexpr Word<Teller> kTellerWords[] = {
    {"nobody", Teller::kNobody},     {"safety_gate", Teller::kSafetyGate},
    {"status", Teller::kStatus},     {"error_control", Teller::kErrorControl},
    {"boot_up", Teller::kBootUp},    {"duplicate", Teller::kDuplicate},
    {"election", Teller::kElection}, {"emergency", Teller::kEmergency},
    {"device", Teller::kDevice},     {"controller", Teller::kController},
    {"command", Teller::kCommand},   {"exception", Teller::kException},
};
static_assert(sizeof(kTargetWords) / sizeof(kTargetWords[0]) == kTargetCount, "a word each");
static_assert(sizeof(kFaultWords) / sizeof(kFaultWords[0]) == kFaultCount, "a word each");
static_assert(sizeof(kTellerWords) / sizeof(kTellerWords[0]) == kTellerCount, "a word each");

constexpr const char* kNetwork = "network";

std::uint64_t HashOf(const std::string& text)
{
    std::uint64_t hash = 0xCBF29CE484222325U;
    for (const char character : text)
    {
        hash = (hash ^ static_cast<std::uint8_t>(character)) * 0x100000001B3U;
    }
    return hash;
}

Nanoseconds TimeOf(const YamlMap& map, const char* const key, const Nanoseconds usual)
{
    const std::optional<YamlValue> value = map.Find(key);
    const Nanoseconds time = value ? value->Duration() : usual;
    if (value && time % kStep != 0)
    {
        value->Refuse("a time that is no multiple of the grid of 50 us", "a time as 60 ms");
    }
    return time;
}

void ReadTimes(const YamlMap& map, Plan& plan)
{
    constexpr Nanoseconds kMs = runtime::kNanosecondsPerMillisecond;
    plan.from = TimeOf(map, "from", 0);
    plan.until = TimeOf(map, "until", 0);
    plan.reach = TimeOf(map, "reach", 60 * kMs);
    plan.settle = TimeOf(map, "settle", 600 * kMs);
    plan.stop_within = TimeOf(map, "stop_within", 3000 * kMs);
    plan.masters_within = TimeOf(map, "masters_within", 8000 * kMs);
    if (const auto until = map.Find("until"); until && plan.until <= plan.from)
    {
        until->Refuse("an end that is not behind the begin", "a time behind 'from'");
    }
    for (const auto& [key, time] : {std::pair("reach", plan.reach), {"settle", plan.settle}})
    {
        if (time < kStep)
        {
            map.Require(key).Refuse("no time", "at least 50 us");
        }
    }
}

void ReadKnown(const YamlMap& map, Plan& plan)
{
    const std::optional<YamlValue> list = map.Find("known");
    if (!list)
    {
        return;
    }
    for (const YamlValue& item : list->Items("a list of places with a reason"))
    {
        const YamlMap known(plan.file, item.Node(), {"place", "reason"});
        const YamlValue reason = known.Require("reason");
        plan.known.push_back({known.Require("place").Text("a place as reports tell it, or its first words"),
                              reason.Text("who answers for it")});
        if (plan.known.back().reason.empty() || plan.known.back().place.empty())
        {
            reason.Refuse("an empty text", "a place, and who answers for it");
        }
    }
    if (plan.known.empty())
    {
        list->Refuse("an empty list", "at least one place with a reason");
    }
}

void ReadNumbers(const YamlMap& map, Plan& plan)
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
    if (const auto profile = map.Find("profile"))
    {
        plan.profile = runtime::WordOf(profile->Choice(runtime::kProfileWords));
    }
}

void ReadMembers(const YamlMap& map, Plan& plan)
{
    const std::optional<YamlValue> list = map.Find("members");
    if (!list)
    {
        return;
    }
    for (const YamlValue& item : list->Items("a list of members of a manager's memory"))
    {
        const std::string name = item.Text("a member as reports name it, or its first word, as gate");
        if (std::find(plan.members.begin(), plan.members.end(), name) != plan.members.end())
        {
            item.Refuse("a member that is there already", "each one once");
        }
        plan.members.push_back(name);
        plan.member_sources.push_back(item.Where());
    }
    if (plan.members.empty())
    {
        list->Refuse("an empty list", "at least one member");
    }
}

/// A kind that none of the parts has would be left aside.
void RequireEffect(const Plan& plan)
{
    for (std::size_t index = 0U; index < plan.kind_sources.size(); ++index)
    {
        const Fault kind = plan.kinds[index];
        if (std::none_of(plan.parts.begin(), plan.parts.end(), [kind](const Target part) { return IsOf(part, kind); }))
        {
            throw runtime::YamlError(plan.file, plan.kind_sources[index].place, "a kind that none of the parts has",
                                     "one of its kinds");
        }
    }
}
} // namespace

bool IsManagedPlan(const std::string& file)
{
    const runtime::YamlNode root = runtime::ParseYaml(file, runtime::ReadYamlText(file));
    bool has_network = false;
    for (std::size_t key = 0U; root.kind == runtime::YamlKind::kMap && key < root.items.size(); key += 2U)
    {
        has_network = has_network || root.items[key].scalar == kNetwork;
    }
    return has_network;
}

Plan ReadManagedPlan(const std::string& file)
{
    const std::string text = runtime::ReadYamlText(file);
    const runtime::YamlNode root = runtime::ParseYaml(file, text);
    const YamlMap map(file, root,
                      {"title", kNetwork, "profile", "from", "until", "parts", "members", "kinds", "detectors", "known",
                       "reach", "settle", "stop_within", "masters_within", "seed", "sample", "confidence"});
    Plan plan;
    plan.file = file;
    plan.digest = HashOf(text);
    plan.title = TitleOf(map);
    const YamlValue network = map.Require(kNetwork);
    const std::filesystem::path scenario = network.Text("the file name of a scenario with managers");
    plan.scenario_source = network.Where();
    plan.scenario =
        scenario.is_absolute() ? scenario.string() : (std::filesystem::path(file).parent_path() / scenario).string();
    simulator::RequireFile(plan.scenario, network.Where(), "a scenario with managers");
    plan.parts = Chosen(map, "parts", kTargetWords, &plan.part_sources);
    plan.kinds = Chosen(map, "kinds", kFaultWords, &plan.kind_sources);
    RequireEffect(plan);
    ReadMembers(map, plan);
    plan.detectors = map.Find("detectors") ? Chosen(map, "detectors", kTellerWords) : std::vector<Teller>{};
    ReadTimes(map, plan);
    ReadKnown(map, plan);
    ReadNumbers(map, plan);
    return plan;
}

bool IsOf(const Target target, const Fault fault) noexcept
{
    const auto is_from_to = [fault](const Fault first, const Fault last) { return fault >= first && fault <= last; };
    switch (target)
    {
    case Target::kWrites:
        return is_from_to(Fault::kForeign, Fault::kStored);
    case Target::kSlaves:
        return is_from_to(Fault::kRestarted, Fault::kExchanged);
    case Target::kManagers:
        return is_from_to(Fault::kKilled, Fault::kOffBus);
    case Target::kMemory:
        return fault == Fault::kFlip;
    case Target::kClocks:
        return is_from_to(Fault::kStopped, Fault::kJump);
    default:
        return is_from_to(Fault::kLost, Fault::kWrongIdentifier);
    }
}

const char* WordOf(const Target target)
{
    return TextOf(kTargetWords, target);
}

const char* WordOf(const Fault fault)
{
    return TextOf(kFaultWords, fault);
}

const char* WordOf(const Teller teller)
{
    return TextOf(kTellerWords, teller);
}
} // namespace counterpoint::campaign::managed
