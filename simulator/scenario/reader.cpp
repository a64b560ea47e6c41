// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/scenario/reader.hpp"

#include "simulator/scenario/names.hpp"
#include "simulator/scenario/parts.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace counterpoint::simulator
{
namespace
{
constexpr Range kSeedRange{0U, 0xFFFFFFFFFFFFFFFFU};
constexpr std::uint32_t kBitrates[] = {10000U, 20000U, 50000U, 100000U, 125000U, 250000U, 500000U, 800000U, 1000000U};

void ReadStimulus(Fields& fields, const Scenario& scenario, Stimulus& stimulus)
{
    fields.Into("at", stimulus.at);
    stimulus.node = NodeNamed(scenario, fields.Require("node"));
    fields.Into("object", stimulus.object);
    fields.Into("value", stimulus.value);
}

void ReadLogic(Fields& fields, const Scenario& scenario, runtime::LogicRule& rule)
{
    rule.node = NodeNamed(scenario, fields.Require("node"));
    fields.Into("set", rule.target);
    rule.operation = fields.Require("op").Choice(runtime::kOperationWords);
    const YamlValue from = fields.Require("from");
    for (const YamlValue& input : from.Items("a list of objects"))
    {
        rule.inputs.push_back(input.Object());
    }
    const bool takes_one =
        rule.operation == runtime::LogicOperation::kCopy || rule.operation == runtime::LogicOperation::kNot;
    const bool fits = takes_one ? rule.inputs.size() == 1U : !rule.inputs.empty();
    if (!fits)
    {
        from.Refuse(std::to_string(rule.inputs.size()) + " objects", takes_one ? "one object" : "one object or more");
    }
}

void ReadAcknowledge(Fields& fields, const Scenario& scenario, Acknowledge& acknowledge)
{
    fields.Into("at", acknowledge.at);
    acknowledge.node = NodeNamed(scenario, fields.Require("node"));
    fields.Into("srdo", acknowledge.srdo);
    fields.Into("pulse", acknowledge.pulse);
}

void ReadNmt(Fields& fields, const Scenario& scenario, NmtEvent& event)
{
    fields.Into("at", event.at);
    const YamlValue node = fields.Require("node");
    event.node = (node.Text("a node, or all") == "all") ? kNoNode : NodeNamed(scenario, node);
    const auto state = fields.Find("state");
    const auto command = fields.Find("command");
    if (static_cast<bool>(state) == static_cast<bool>(command))
    {
        fields.Value().Refuse("an NMT event", "either 'state' or 'command'");
    }
    event.state = state ? state->Choice(runtime::kNmtWords) : NmtState::kInvalid;
    event.command = command ? command->Choice(kCommandWords) : cia301::NmtCommand::kInvalid;
    if (event.command == cia301::NmtCommand::kResetNode || event.command == cia301::NmtCommand::kResetCommunication)
    {
        fields.Into("start_after", event.start_after);
    }
}

void ReadPower(Fields& fields, const Scenario& scenario, PowerCycle& cycle)
{
    fields.Into("at", cycle.at);
    cycle.node = NodeNamed(scenario, fields.Require("node"));
    fields.Into("off", cycle.off);
    fields.Into("start_after", cycle.start_after);
}

void ReadGfc(Fields& fields, const Scenario& scenario, GfcEvent& event)
{
    fields.Into("at", event.at);
    event.node = NodeNamed(scenario, fields.Require("node"));
}

template <typename Item> using Reader = void (*)(Fields&, const Scenario&, Item&);

/// One item of the list of a key.
template <typename Item>
Item ReadItem(const Fields& fields, const char* key, const Scenario& scenario, const YamlValue& value,
              const Reader<Item> read)
{
    Fields own(value, fields.SectionOf(key));
    Item item;
    item.source = value.Where();
    read(own, scenario, item);
    own.Close();
    return item;
}

/// Appends the items of a list, each read by `read`.
template <typename Item>
void Append(Fields& fields, const char* key, const Scenario& scenario, std::vector<Item>& items,
            const Reader<Item> read)
{
    const auto list = fields.Find(key);
    for (const YamlValue& value : list ? list->Items("a list") : std::vector<YamlValue>{})
    {
        items.push_back(ReadItem(fields, key, scenario, value, read));
    }
}

/// Takes away what is there under other profiles only.
template <typename Item> void KeepOfProfile(std::vector<Item>& items)
{
    items.erase(std::remove_if(items.begin(), items.end(), [](const Item& item) { return !item.is_of_profile; }),
                items.end());
}

/// The same of what happens to both CPUs of a device that is named without one.
template <typename Item>
void AppendToEach(Fields& fields, const char* key, const Scenario& scenario, std::vector<Item>& items,
                  const Reader<Item> read)
{
    const auto list = fields.Find(key);
    for (const YamlValue& value : list ? list->Items("a list") : std::vector<YamlValue>{})
    {
        items.push_back(ReadItem(fields, key, scenario, value, read));
        if (items.back().node != kNoNode && NamesBothCpus(scenario, value))
        {
            Item second = items.back();
            ++second.node;
            items.push_back(second);
        }
    }
}

void ReadSingles(Fields& fields, Scenario& scenario)
{
    fields.Into("title", scenario.title);
    fields.Into("description", scenario.description);
    if (fields.Into("bitrate", scenario.bitrate) &&
        std::find(std::begin(kBitrates), std::end(kBitrates), scenario.bitrate) == std::end(kBitrates))
    {
        const YamlValue bitrate = fields.Require("bitrate");
        bitrate.Refuse(runtime::Shown(bitrate.Node().scalar),
                       "one of 10000, 20000, 50000, 100000, 125000, 250000, 500000, 800000, 1000000");
    }
    fields.Into("duration", scenario.duration);
    fields.Into("seed", scenario.seed);
}

std::string Joined(const std::vector<std::string>& words)
{
    std::string text;
    for (const std::string& word : words)
    {
        text += (text.empty() ? "" : ", ") + word;
    }
    return text;
}

/// The key `profiles`, if it is there.
void ReadProfiles(Fields& fields, std::vector<std::string>& profiles)
{
    const auto value = fields.Find("profiles");
    if (!value)
    {
        return;
    }
    profiles.clear();
    for (const YamlValue& profile : OneOrMore(*value, "one profile or more"))
    {
        const std::string word = profile.Text("a profile");
        if (std::find(profiles.begin(), profiles.end(), word) != profiles.end())
        {
            profile.Refuse(runtime::Shown(word) + " a second time", "each profile once");
        }
        profiles.push_back(word);
    }
}

/// The profile under which all files are read: the wanted one, else the first one. [SRS_SIM_059]
std::string ChosenProfile(const std::vector<ScenarioDocument>& documents, const std::string& wanted)
{
    std::vector<std::string> profiles;
    for (const ScenarioDocument& document : documents)
    {
        Fields fields(YamlValue(document.file, document.root), "scenario");
        ReadProfiles(fields, profiles);
    }
    if (!wanted.empty() && std::find(profiles.begin(), profiles.end(), wanted) == profiles.end())
    {
        throw YamlError("--profile", {}, runtime::Shown(wanted),
                        profiles.empty() ? "a scenario with 'profiles'" : "one of " + Joined(profiles));
    }
    return (wanted.empty() && !profiles.empty()) ? profiles.front() : wanted;
}

/// What one file says, on top of what is known already.
void ReadInto(const ScenarioDocument& document, Scenario& scenario)
{
    Fields fields(YamlValue(document.file, document.root), "scenario");
    if (const auto base = fields.Find("extends"))
    {
        if (document.is_base)
        {
            base->Refuse("a scenario that extends another one", "none here: one step only");
        }
    }
    ReadSingles(fields, scenario);
    if (const auto nodes = fields.Find("nodes"))
    {
        ReadNodes(*nodes, scenario);
    }
    Append(fields, "managers", scenario, scenario.managers, ReadManager);
    const auto managers = fields.Find("managers");
    if (managers && scenario.managers.empty())
    {
        managers->Refuse("an empty list of managers", "at least one");
    }
    ReadProfiles(fields, scenario.profiles);
    if (scenario.managers.empty() && !scenario.profiles.empty())
    {
        fields.Require("profiles").Refuse("profiles without managers", "the key 'managers', too");
    }
    AppendToEach(fields, "inputs", scenario, scenario.stimuli, ReadStimulus);
    AppendToEach(fields, "logic", scenario, scenario.logic, ReadLogic);
    AppendToEach(fields, "acknowledge", scenario, scenario.acknowledges, ReadAcknowledge);
    AppendToEach(fields, "nmt", scenario, scenario.nmt, ReadNmt);
    AppendToEach(fields, "power", scenario, scenario.power, ReadPower);
    Append(fields, "gfc", scenario, scenario.gfc, ReadGfc);
    AppendToEach(fields, "events", scenario, scenario.actions, ReadAction);
    KeepOfProfile(scenario.actions);
    Append(fields, "faults", scenario, scenario.faults, ReadFault);
    Append(fields, "expect", scenario, scenario.expectations, ReadExpectation);
    KeepOfProfile(scenario.expectations);
    fields.Close();
}

/// What follows from having managers, or none.
void Complete(Scenario& scenario)
{
    constexpr Nanoseconds kStart = 10 * kNanosecondsPerMillisecond;
    const bool has_managers = !scenario.managers.empty();
    for (NodeSetup& node : scenario.nodes)
    {
        if (has_managers)
        {
            RequireFile(node.dcf, node.source, "a DCF");
        }
        node.node_id = has_managers ? std::optional(NodeIdOf(node)) : node.node_id;
        node.start_at = (has_managers || node.start_at != kNever) ? node.start_at : kStart;
    }
    AddReturns(scenario.actions);
}

/// The files that the maps in a list or map name under a key.
void AddFiles(const ScenarioDocument& document, const char* const maps, const char* const key,
              std::vector<std::string>& files)
{
    const runtime::YamlNode* const all = MemberOf(document.root, maps);
    for (const runtime::YamlNode& item : (all == nullptr) ? std::vector<runtime::YamlNode>{} : all->items)
    {
        if (const runtime::YamlNode* const file = MemberOf(item, key))
        {
            files.push_back(Beside(document.file, file->scalar));
        }
    }
}
} // namespace

const runtime::YamlNode* MemberOf(const runtime::YamlNode& map, const std::string& key)
{
    for (std::size_t item = 0U; map.kind == runtime::YamlKind::kMap && item + 1U < map.items.size(); item += 2U)
    {
        if (map.items[item].scalar == key)
        {
            return &map.items[item + 1U];
        }
    }
    return nullptr;
}

std::vector<YamlValue> OneOrMore(const YamlValue& value, const std::string& expected)
{
    std::vector<YamlValue> items = ItemsOf(value);
    if (items.empty())
    {
        value.Refuse("an empty list", expected);
    }
    return items;
}

bool IsOfProfile(Fields& fields, const Scenario& scenario)
{
    const auto value = fields.Find("profile");
    if (!value)
    {
        return true;
    }
    bool is_there = false;
    for (const YamlValue& profile : OneOrMore(*value, "one profile or more"))
    {
        const std::vector<std::string>& known = scenario.profiles;
        const std::string word = profile.Text("a profile");
        if (std::find(known.begin(), known.end(), word) == known.end())
        {
            profile.Refuse("profile " + runtime::Shown(word) + cia306::DidYouMean(word, known),
                           known.empty() ? "a scenario with 'profiles'" : "one of its 'profiles': " + Joined(known));
        }
        is_there = is_there || word == scenario.profile;
    }
    return is_there;
}

std::vector<ScenarioDocument> LoadScenario(const std::string& file)
{
    std::vector<ScenarioDocument> documents;
    documents.push_back({file, runtime::ParseYaml(file, runtime::ReadYamlText(file)), false});
    const runtime::YamlNode& root = documents.back().root;
    if (root.kind == runtime::YamlKind::kMap)
    {
        Fields fields(YamlValue(file, root), "scenario");
        if (const auto base = fields.Find("extends"))
        {
            const std::string name = Beside(file, base->Text("the file name of a scenario"));
            RequireFile(name, base->Where(), "a scenario");
            runtime::YamlNode extended = runtime::ParseYaml(name, runtime::ReadYamlText(name));
            documents.insert(documents.begin(), {name, std::move(extended), true});
        }
    }
    return documents;
}

std::vector<std::string> FilesOf(const std::vector<ScenarioDocument>& documents)
{
    std::vector<std::string> files;
    for (const ScenarioDocument& document : documents)
    {
        files.push_back(document.file);
        AddFiles(document, "nodes", "dcf", files);
    }
    return files;
}

std::vector<std::string> NetworkFilesOf(const std::vector<ScenarioDocument>& documents)
{
    std::vector<std::string> files;
    for (const ScenarioDocument& document : documents)
    {
        AddFiles(document, "managers", "network", files);
    }
    return files;
}

Scenario ReadScenario(const std::vector<ScenarioDocument>& documents, const std::string& profile)
{
    Scenario scenario;
    scenario.profile = ChosenProfile(documents, profile);
    const std::string& file = documents.back().file;
    scenario.file = file;
    for (const ScenarioDocument& document : documents)
    {
        ReadInto(document, scenario);
    }
    if (scenario.nodes.empty() && scenario.managers.empty())
    {
        throw YamlError(file, {1, 1}, "no nodes", "key 'nodes' with at least one node");
    }
    if (scenario.duration == 0)
    {
        throw YamlError(file, {1, 1}, "no duration", "key 'duration' with a time above 0");
    }
    Complete(scenario);
    return scenario;
}

Scenario ReadScenario(const std::string& file, const std::string& profile)
{
    return ReadScenario(LoadScenario(file), profile);
}

Nanoseconds ParseDuration(const std::string& place, const std::string& text)
{
    return YamlValue(place, {runtime::YamlKind::kScalar, false, {}, text, {}}).Lasting();
}

std::uint64_t ParseSeed(const std::string& place, const std::string& text)
{
    return YamlValue(place, {runtime::YamlKind::kScalar, false, {}, text, {}}).Number(kSeedRange);
}
} // namespace counterpoint::simulator
