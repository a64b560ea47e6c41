// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/device/model.hpp"
#include "simulator/scenario/names.hpp"
#include "simulator/scenario/parts.hpp"

#include <charconv>
#include <filesystem>
#include <optional>
#include <system_error>
#include <unistd.h>
#include <utility>

// The section `nodes`, and who is meant by the name of a node. [SRS_SIM_056]
namespace counterpoint::simulator
{
namespace
{
constexpr std::size_t kMostNodes = 127U;
constexpr std::int32_t kStandsStill = -1000000;

void ReadCounter(Fields& fields, const char* const key, CounterSetup& counter)
{
    if (auto own = fields.Map(key))
    {
        own->Into("ppm", counter.drift_ppm);
        if (counter.drift_ppm == kStandsStill)
        {
            own->Require("ppm").Refuse("a counter that stands still from the start", "more than -1000000 ppm");
        }
        own->Into("start_us", counter.start_us);
        own->Close();
    }
}

/// What is a CPU's own where the device has two.
void ReadCpu(Fields& fields, const char* key, NodeSetup& node)
{
    if (auto cpu = fields.Map(key))
    {
        cpu->Into("phase", node.phase);
        ReadCounter(*cpu, "counter", node.counter_a);
        cpu->Close();
    }
}

LinkSetup ReadLink(Fields& fields)
{
    LinkSetup setup;
    if (auto link = fields.Map("link"))
    {
        link->Into("timeout", setup.timeout);
        link->Into("delay", setup.delay);
        link->Into("jitter", setup.jitter);
        link->Into("clock_tolerance", setup.clock_tolerance);
        link->Into("clock_interval", setup.clock_interval);
        link->Into("stamp_tolerance", setup.stamp_tolerance);
        link->Close();
    }
    return setup;
}

/// What is a device's own where it has one CPU.
void ReadWhole(Fields& fields, NodeSetup& node)
{
    fields.Into("controllers", node.controllers);
    fields.Into("phase", node.phase);
    ReadCounter(fields, "counter_a", node.counter_a);
    ReadCounter(fields, "counter_b", node.counter_b);
}

/// A name that is a number is the node-ID.
std::optional<std::uint8_t> NodeIdIn(const std::string& text)
{
    std::uint8_t number = 0U;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool is_one = error == std::errc() && end == text.data() + text.size() && number > 0U && number <= kMostNodes;
    return is_one ? std::optional<std::uint8_t>(number) : std::nullopt;
}

std::vector<NodeSetup> ReadNode(const YamlValue& name, const YamlValue& value)
{
    Fields fields(value, "node");
    NodeSetup node;
    node.name = name.Text("the name of a node");
    if (node.name.empty() || node.name == "all" || node.name == "bus")
    {
        name.Refuse("node name " + runtime::Shown(node.name), "a name other than 'all' and 'bus'");
    }
    const YamlValue dcf = fields.Require("dcf");
    node.dcf = Beside(value.FileName(), dcf.Text("the file name of a DCF"));
    node.source = dcf.Where();
    node.node_id = NodeIdIn(node.name);
    const bool is_numbered = node.node_id.has_value();
    if (fields.Into("node_id", node.node_id) && is_numbered)
    {
        fields.Require("node_id").Refuse("a node-ID of node " + runtime::Shown(node.name), "none, its name is one");
    }
    fields.Into("serial", node.serial);
    node.self_tests = fields.Require("self_tests").Choice(kYesWords);
    node.start_at = kNever;
    node.names_start = fields.Into("start_at", node.start_at);
    node.device = node.name;
    std::vector<NodeSetup> cpus{node};
    if (fields.Require("structure").Choice(kStructureWords))
    {
        cpus[0U].link = ReadLink(fields);
        cpus.push_back(cpus[0U]);
        cpus[0U].role = runtime::CpuRole::kA;
        cpus[1U].role = runtime::CpuRole::kB;
        cpus[0U].name += ".a";
        cpus[1U].name += ".b";
        ReadCpu(fields, "cpu_a", cpus[0U]);
        ReadCpu(fields, "cpu_b", cpus[1U]);
    }
    else
    {
        ReadWhole(fields, cpus[0U]);
    }
    fields.Close();
    return cpus;
}
} // namespace

void ReadNodes(const YamlValue& value, Scenario& scenario)
{
    Fields fields(value, "nodes");
    for (const auto& [name, node] : fields.All())
    {
        if (scenario.nodes.size() >= kMostNodes)
        {
            name.Refuse("node " + runtime::Shown(name.Node().scalar), "at most 127 nodes");
        }
        for (NodeSetup& setup : ReadNode(name, node))
        {
            for (const NodeSetup& other : scenario.nodes)
            {
                if (other.name == setup.name || other.device == setup.name)
                {
                    name.Refuse("node " + runtime::Shown(setup.name) + " twice", "each node once");
                }
            }
            scenario.nodes.push_back(std::move(setup));
        }
    }
}

std::string Beside(const std::string& file, const std::string& name)
{
    const std::filesystem::path path(name);
    return path.is_absolute() ? name : (std::filesystem::path(file).parent_path() / path).string();
}

// [SRS_SIM_081]
void RequireFile(const std::string& path, const Source& source, const std::string& expected)
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
    {
        const bool is_there = std::filesystem::exists(path, error);
        throw YamlError(source.file, source.place,
                        is_there ? runtime::Shown(path) + " is no regular file"
                                 : "there is no file " + runtime::Shown(path),
                        expected);
    }
    if (::access(path.c_str(), R_OK) != 0)
    {
        throw YamlError(source.file, source.place, runtime::Shown(path) + " cannot be read", expected);
    }
}

std::uint8_t NodeIdOf(const NodeSetup& node)
{
    return node.node_id ? *node.node_id
                        : runtime::DeviceModel(node.dcf, std::nullopt, runtime::SafetyNeed::kOptional).Config().node_id;
}

std::uint8_t NodeIdNamed(const Scenario& scenario, const YamlValue& name)
{
    const std::string text = name.Text("a node");
    for (const NodeSetup& setup : scenario.nodes)
    {
        if (setup.name == text || setup.device == text)
        {
            return NodeIdOf(setup);
        }
    }
    const std::optional<std::uint8_t> number = NodeIdIn(text);
    if (!number)
    {
        name.Refuse("node " + runtime::Shown(text), "the name of a node, or a node-ID from 1 to 127");
    }
    return *number;
}

NodeIndex NodeNamed(const Scenario& scenario, const YamlValue& name)
{
    const std::string text = name.Text("the name of a node");
    std::string expected;
    for (NodeIndex node = 0U; node < scenario.nodes.size(); ++node)
    {
        const NodeSetup& setup = scenario.nodes[node];
        if (setup.name == text || setup.device == text)
        {
            return node;
        }
        expected += (expected.empty() ? "" : ", ") + setup.name;
    }
    name.Refuse("node " + runtime::Shown(text) + cia306::DidYouMean(text, WordsIn(expected)),
                expected.empty() ? "a node of 'nodes', which has none" : "one of " + expected);
}

bool IsTwoCpus(const Scenario& scenario, const YamlValue& name)
{
    const NodeSetup& setup = scenario.nodes[NodeNamed(scenario, name)];
    return setup.role != runtime::CpuRole::kWhole && setup.device == name.Node().scalar;
}

NodeIndex CpuNamed(const Scenario& scenario, const YamlValue& name)
{
    if (IsTwoCpus(scenario, name))
    {
        const std::string& device = name.Node().scalar;
        name.Refuse("node " + runtime::Shown(device) + ", which is two CPUs", device + ".a or " + device + ".b");
    }
    return NodeNamed(scenario, name);
}

bool NamesBothCpus(const Scenario& scenario, const YamlValue& item)
{
    const runtime::YamlNode* const node = MemberOf(item.Node(), "node");
    return node != nullptr && node->scalar != "all" && IsTwoCpus(scenario, YamlValue(item.FileName(), *node));
}
} // namespace counterpoint::simulator
