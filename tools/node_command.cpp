// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/loop.hpp"
#include "tools/command_line/options.hpp"
#include "tools/file_warnings.hpp"

#include "runtime/yaml/document.hpp"
#include "tools/command_table.hpp"

#include <ostream>
#include <unistd.h>

namespace counterpoint::tools
{
namespace
{
constexpr int kHighestNodeId = 127;
constexpr int kShortestCycleUs = 100;
constexpr int kLongestCycleUs = 1000000;

class NodeCommand final : public Command
{
  public:
    void Describe(Options& options) override
    {
        options
            .Add("--can", &address_,
                 "The bus: can0 or socketcan:can0, socketcand:HOST:PORT/can0, udp:GROUP:PORT for devices on this "
                 "machine, such as udp:239.74.163.2:43113")
            .Required()
            .Type("ADDRESS");
        options
            .Add("--can2", &second_address_,
                 "The bus of a second controller, which sends and receives the inverse frames of SRDOs; the "
                 "same bus is allowed")
            .Type("ADDRESS")
            .Check(ProblemOfAddress);
        options.Add("--dcf", &dcf_, "EDS or DCF of the device: all its objects, its safety configuration, its times")
            .Required()
            .Type("FILE")
            .Check(ProblemOfFileName);
        options.Add("--node-id", &node_id_, "Node-ID (default: the one in the file)").Range(1, kHighestNodeId);
        options.Add("--script", &script_, "What the application does, with times (YAML); docs/node.md tells the format")
            .Type("FILE")
            .Check(ProblemOfFileName);
        options
            .Add("--cycle-us", &cycle_us_,
                 "Cycle time in microseconds instead of 5F00h:01 of the file; a cycle may then be late by as much "
                 "again. For machines that are not fast enough for the file")
            .Range(kShortestCycleUs, kLongestCycleUs);
        options
            .Add("--store", &store_, "Where 1010h saves and from where each start loads; without it nothing is saved")
            .Type("FILE")
            .Check(ProblemOfFileName);
        options.Add("--lss", &has_lss_,
                    "LSS gives the node-ID, also where the file does not say LSS_Supported=1; without a node-ID of "
                    "file, command line or store there is nothing but LSS");
        options.Add("--no-self-tests", &has_no_self_tests_,
                    "Leave out the cyclic tests of program, memory, stack, parts and permits");
        options
            .Add("--domain-bytes", &domain_bytes_,
                 "Room in bytes of each DOMAIN that can be written; a value in the file that is longer has its own")
            .Range(1, static_cast<int>(runtime::kMostDomainBytes))
            .ShowDefault();
        options.Add("--json", &is_json_, "One JSON object a line");
        options.Add("--no-input", &has_no_input_, "Read no orders from the standard input");
        options.Footer("Orders, typed as lines or in a script:\n" + runtime::OrderHelp() +
                       "A line is printed for each change of state, output and value, and for each error.");
    }

    [[nodiscard]] ExitStatus Run(const Streams& streams) override
    {
        try
        {
            return RunNode(streams);
        }
        catch (const host::LiveBusError& error)
        {
            const std::string text = error.what(); // [SRS_NODE_051]
            const std::string second = "bus '" + second_address_ + "'";
            const bool is_second = second_address_ != address_ && text.compare(0U, second.size(), second) == 0;
            streams.err << "counterpoint node: " << (is_second ? "--can2: " : "--can: ") << text << "\n";
        }
        return ExitStatus::kBadInput;
    }

  private:
    [[nodiscard]] ExitStatus RunNode(const Streams& streams) const
    {
        runtime::NodeSettings settings;
        settings.dcf = dcf_;
        settings.node_id = (node_id_ == 0) ? std::nullopt : std::optional(static_cast<std::uint8_t>(node_id_));
        settings.cycle_us = (cycle_us_ == 0) ? std::nullopt : std::optional(static_cast<std::uint32_t>(cycle_us_));
        settings.store = store_;
        settings.has_lss = has_lss_;
        settings.has_self_tests = !has_no_self_tests_;
        settings.domain_bytes = static_cast<std::uint32_t>(domain_bytes_);
        const runtime::NodeScript script = script_.empty() ? runtime::NodeScript{} : runtime::ReadNodeScript(script_);
        tools::TellFileWarnings({dcf_}, streams.err);
        runtime::NodePorts ports(address_, second_address_);
        runtime::NodeReport report(streams.out, is_json_ ? runtime::ReportForm::kJson : runtime::ReportForm::kText,
                                   host::LiveNow(), STDOUT_FILENO);
        const auto make = [&settings, &ports, &report, &script](const std::optional<std::uint8_t> lss_node_id)
        {
            settings.lss_node_id = lss_node_id;
            auto device = std::make_unique<runtime::NodeDevice>(settings, ports, report);
            AddRules(script, *device);
            return device;
        };
        runtime::NodeLoop loop({make, ports, report, script, has_no_input_ ? -1 : STDIN_FILENO});
        const ExitStatus status = loop.Run();
        return report.Finish() ? status : ExitStatus::kBadInput;
    }

    static void AddRules(const runtime::NodeScript& script, runtime::NodeDevice& device)
    {
        for (const runtime::LogicRule& rule : script.rules)
        {
            const runtime::RuleFinding finding = device.App().AddRule(rule);
            if (finding == runtime::RuleFinding::kNoPair)
            {
                throw runtime::YamlError(
                    script.file, rule.source.place, "a rule with an object that is no pair of the device",
                    "'set' with a normal object that it sends, 'from' with normal objects that it receives");
            }
            if (finding == runtime::RuleFinding::kOtherLength)
            {
                throw runtime::YamlError(script.file, rule.source.place, "a rule with objects of different lengths",
                                         "each object of 'from' as long as that of 'set'");
            }
        }
    }

    std::string address_;
    std::string second_address_;
    std::string dcf_;
    std::string script_;
    std::string store_;
    int node_id_{0};
    int cycle_us_{0};
    int domain_bytes_{runtime::kDomainBytes};
    bool is_json_{false};
    bool has_no_input_{false};
    bool has_lss_{false};
    bool has_no_self_tests_{false};
};
} // namespace

std::unique_ptr<Command> MakeNodeCommand()
{
    return std::make_unique<NodeCommand>();
}
} // namespace counterpoint::tools
