// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/network_plan/cpj_reader.hpp"

#include "canopen/cia306/text/ini_document.hpp"
#include "canopen/cia306/text/input_error.hpp"
#include "canopen/cia306/text/number.hpp"
#include "canopen/cia306/text/text_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <unistd.h>

namespace counterpoint::network_plan
{
namespace
{
using cia306::IniDocument;
using cia306::IniKey;
using cia306::IniSection;
using cia306::InputError;
using cia306::Lower;
using cia306::Quoted;

/// The keys of one node.
struct CpjNode
{
    const IniKey* present{nullptr};
    const IniKey* name{nullptr};
    const IniKey* dcf{nullptr};
    Place place;
};

[[noreturn]] void Refuse(const IniDocument& document, const Place place, const std::string& wrong,
                         const std::string& expected)
{
    throw InputError(document.File(), place, {wrong, expected});
}

std::uint64_t NumberOf(const IniDocument& document, const IniKey& key, const std::uint64_t max)
{
    const auto number = cia306::ParseUnsigned(key.Bare(), max);
    if (!number)
    {
        Refuse(document, key.place, key.name + "=" + Quoted(key.value), "a number from 0 to " + std::to_string(max));
    }
    return *number;
}

const IniSection& TopologyOf(const IniDocument& document)
{
    const IniSection* const topology = document.Find("Topology");
    if (topology == nullptr)
    {
        // Behind its last line: there it is still missing.
        Refuse(document, {std::max<std::size_t>(document.LineCount(), 1U), 1U}, "no section [Topology]",
               "a CPJ file of CiA 306-3");
    }
    for (const IniSection& section : document.Sections())
    {
        const std::string name = Lower(section.name);
        if (name != "topology" && name.rfind("topology", 0U) == 0U)
        {
            Refuse(document, section.place, "a second network [" + section.name + "]", "one network a file");
        }
    }
    return *topology;
}

/// What was left aside: a slip of the pen would otherwise leave out a node.
void Warn(const IniDocument& document, const Place place, const std::string& text, NetworkPlan& plan)
{
    plan.warnings.push_back(cia306::PlaceText(document.File(), place) + ": warning: " + text);
}

bool IsOneOf(const std::string& word, const std::initializer_list<const char*> words)
{
    return std::any_of(words.begin(), words.end(), [&word](const char* const other) { return word == other; });
}

/// Puts a key NodeNPresent, NodeNName or NodeNDCFName where it belongs. Whether the format knows the key.
bool TakeNodeKey(const IniDocument& document, const IniKey& key, std::map<std::uint64_t, CpjNode>& nodes)
{
    constexpr std::size_t kPrefix = 4U;
    const std::string name = Lower(key.name);
    std::size_t end = kPrefix;
    while (end < name.size() && std::isdigit(static_cast<unsigned char>(name[end])) != 0)
    {
        ++end;
    }
    if (name.rfind("node", 0U) != 0U || end == kPrefix)
    {
        return IsOneOf(name, {"netname", "netrefd", "nodes"});
    }
    const std::string digits = name.substr(kPrefix, end - kPrefix);
    const bool is_id =
        digits.size() <= 3U && std::stoul(digits) >= 1U && std::stoul(digits) <= cia302::kLastNode && digits[0] != '0';
    if (!is_id)
    {
        Refuse(document, key.name_place, "key " + Quoted(key.name), "a node-ID from 1 to 127 after Node");
    }
    CpjNode& node = nodes[std::stoul(digits)];
    const std::string what = name.substr(end);
    node.place = node.place.IsWhole() ? key.name_place : node.place;
    node.present = (what == "present") ? &key : node.present;
    node.name = (what == "name") ? &key : node.name;
    node.dcf = (what == "dcfname") ? &key : node.dcf;
    return IsOneOf(what, {"present", "name", "dcfname", "refd"});
}

void WarnOfUnknown(const IniDocument& document, NetworkPlan& plan)
{
    for (const cia306::Finding& finding : document.Warnings())
    {
        Warn(document, finding.place, finding.text, plan);
    }
    for (const IniSection& section : document.Sections())
    {
        if (Lower(section.name) != "topology")
        {
            Warn(document, section.place, "section [" + section.name + "] is ignored, expected [Topology] alone", plan);
        }
        for (const IniKey& key : section.keys)
        {
            const std::string name = Lower(key.name);
            const bool is_text = name.size() >= 4U && name.compare(name.size() - 4U, 4U, "name") == 0;
            const auto comment = is_text ? std::nullopt : cia306::CommentBehind(key.value, key.place);
            if (comment)
            {
                Warn(document, comment->place, comment->text, plan);
            }
        }
    }
}

void WarnOfAbsent(const IniDocument& document, const std::map<std::uint64_t, CpjNode>& nodes, NetworkPlan& plan)
{
    for (const auto& [id, node] : nodes)
    {
        if (node.present == nullptr)
        {
            const std::string key = "Node" + std::to_string(id) + "Present";
            Warn(document, node.place,
                 "node " + std::to_string(id) + " without " + key + " is taken as absent, expected " + key + "=1 or 0",
                 plan);
        }
    }
}

bool IsPresent(const IniDocument& document, const CpjNode& node)
{
    return node.present != nullptr && NumberOf(document, *node.present, 1U) == 1U;
}

/// Whether the DCF says that its device is the manager.
bool IsManager(const std::string& dcf)
{
    const IniDocument document = IniDocument::Parse(dcf, cia306::ReadTextFile(dcf));
    for (const char* const name : {"DeviceComissioning", "DeviceCommissioning"})
    {
        const IniSection* const section = document.Find(name);
        const IniKey* const key = (section == nullptr) ? nullptr : section->Find("CANopenManager");
        if (key != nullptr && !key->Bare().empty())
        {
            return NumberOf(document, *key, 1U) == 1U;
        }
    }
    return false;
}

SlavePlan PlanOf(const IniDocument& document, const std::uint64_t id, const CpjNode& node)
{
    SlavePlan plan;
    plan.node = static_cast<std::uint8_t>(id);
    plan.name = (node.name == nullptr || node.name->value.empty()) ? "node " + std::to_string(id) : node.name->value;
    if (node.dcf == nullptr || node.dcf->value.empty())
    {
        Refuse(document, node.present->place, "node " + std::to_string(id) + " is present and has no DCF",
               "Node" + std::to_string(id) + "DCFName=FILE");
    }
    plan.place = node.dcf->place;
    plan.dcf = BesideFile(document.File(), node.dcf->value);
    const std::string problem = ProblemOfFile(plan.dcf);
    if (!problem.empty())
    {
        Refuse(document, node.dcf->place, problem, "the DCF of node " + std::to_string(id));
    }
    return plan;
}

void RequireCount(const IniDocument& document, const IniSection& topology, const std::size_t present)
{
    const IniKey* const count = topology.Find("Nodes");
    if (count == nullptr)
    {
        Refuse(document, topology.place, "no key Nodes in [Topology]", "Nodes=" + std::to_string(present));
    }
    if (NumberOf(document, *count, cia302::kLastNode) != present)
    {
        Refuse(document, count->place,
               "Nodes=" + count->value + ", and " + std::to_string(present) + " nodes are present", "equal numbers");
    }
}

void TakeManager(NetworkPlan& plan, const SlavePlan& node)
{
    if (!plan.manager.dcf.empty())
    {
        throw InputError(plan.file, node.place,
                         {"a second manager, node " + std::to_string(node.node) + " besides node " +
                              std::to_string(*plan.manager.node),
                          "CANopenManager=1 in one DCF"});
    }
    plan.manager.node = node.node;
    plan.manager.place = node.place;
    plan.manager.dcf = node.dcf;
}

/// Both are asked: another one on the command line would make the file's manager a slave, and a slave that it names the
/// manager, which nobody verifies any more. A slave with its node-ID is found with the rest. [SRS_NET_750]
void RequireManager(NetworkPlan& plan, const std::uint8_t manager)
{
    if (!plan.manager.node && manager == 0U)
    {
        throw InputError(
            plan.file, plan.manager.place,
            {"no node is the manager", "CANopenManager=1 in [DeviceComissioning] of one DCF, or the option --node-id"});
    }
    if (plan.manager.node && manager != 0U && manager != *plan.manager.node)
    {
        const std::string node = std::to_string(*plan.manager.node);
        throw InputError(plan.file, plan.manager.place,
                         {"node " + node + " is the manager by CANopenManager=1, and another node-ID is asked for, " +
                              std::to_string(manager),
                          "node-ID " + node + ", or CANopenManager=0"});
    }
    plan.manager.node = plan.manager.node.value_or(manager);
}
} // namespace

std::string BesideFile(const std::string& network_file, const std::string& name)
{
    std::string path = name;
    std::replace(path.begin(), path.end(), '\\', '/');
    const std::filesystem::path file(path);
    return file.is_absolute() ? path : (std::filesystem::path(network_file).parent_path() / file).string();
}

std::string ProblemOfFile(const std::string& path)
{
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status))
    {
        return "there is no file " + Quoted(path);
    }
    if (std::filesystem::is_directory(status))
    {
        return Quoted(path) + " is a folder";
    }
    if (!std::filesystem::is_regular_file(status))
    {
        return Quoted(path) + " is no regular file";
    }
    const std::uintmax_t bytes = std::filesystem::file_size(path, error);
    if (bytes > cia306::kMaxFileBytes)
    {
        return Quoted(path) + " has " + std::to_string(bytes) + " bytes, and " + std::to_string(cia306::kMaxFileBytes) +
               " are the most";
    }
    return (::access(path.c_str(), R_OK) == 0) ? "" : Quoted(path) + " cannot be read";
}

NetworkPlan ReadCpj(const std::string& path, const std::uint8_t manager)
{
    const IniDocument document = IniDocument::Parse(path, cia306::ReadTextFile(path));
    const IniSection& topology = TopologyOf(document);
    std::map<std::uint64_t, CpjNode> nodes;
    NetworkPlan plan;
    plan.file = path;
    WarnOfUnknown(document, plan);
    for (const IniKey& key : topology.keys)
    {
        if (!TakeNodeKey(document, key, nodes))
        {
            Warn(document, key.name_place,
                 "key " + Quoted(key.name) +
                     " is ignored, expected NetName, Nodes, NodeNPresent, NodeNName or NodeNDCFName",
                 plan);
        }
    }
    WarnOfAbsent(document, nodes, plan);
    const IniKey* const name = topology.Find("NetName");
    plan.name = (name == nullptr) ? "" : name->value;
    std::size_t present = 0U;
    for (const auto& [id, node] : nodes)
    {
        if (IsPresent(document, node))
        {
            ++present;
            const SlavePlan slave = PlanOf(document, id, node);
            IsManager(slave.dcf) ? TakeManager(plan, slave) : plan.slaves.push_back(slave);
        }
    }
    RequireCount(document, topology, present);
    plan.manager.place = plan.manager.place.IsWhole() ? topology.place : plan.manager.place;
    RequireManager(plan, manager);
    return plan;
}
} // namespace counterpoint::network_plan
