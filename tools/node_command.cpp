// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/node_command.hpp"

#include "runtime/node/loop.hpp"
#include "tools/device_options.hpp"

#include "runtime/yaml/document.hpp"

#include <CLI/CLI.hpp>

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
    void Describe(CLI::App& app) override
    {
        app.add_option("--can", address_,
                       "The bus: can0 or socketcan:can0, socketcand:HOST:PORT/can0, udp:GROUP:PORT for devices on this "
                       "machine, such as udp:239.74.163.2:43113")
            ->required()
            ->type_name("ADDRESS");
        app.add_option("--can2", second_address_,
                       "The bus of a second controller, which sends and receives the inverse frames of SRDOs; the "
                       "same bus is allowed")
            ->type_name("ADDRESS")
            ->check(CLI::Validator(ProblemOfAddress, ""));
        app.add_option("--dcf", dcf_, "EDS or DCF of the device: all its objects, its safety configuration, its times")
            ->required()
            ->type_name("FILE")
            ->check(CLI::Validator(ProblemOfFileName, ""));
        app.add_option("--node-id", node_id_, "Node-ID (default: the one in the file)")
            ->check(CLI::Validator(ProblemOfNumber, ""))
            ->check(CLI::Range(1, kHighestNodeId));
        app.add_option("--script", script_,
                       "What the application does, with times (YAML); docs/node.md tells the format")
            ->type_name("FILE")
            ->check(CLI::Validator(ProblemOfFileName, ""));
        app.add_option(
               "--cycle-us", cycle_us_,
               "Cycle time in microseconds instead of 5F00h:01 of the file; a cycle may then be late by as much "
               "again. For machines that are not fast enough for the file")
            ->check(CLI::Validator(ProblemOfNumber, ""))
            ->check(CLI::Range(kShortestCycleUs, kLongestCycleUs));
        app.add_option("--store", store_,
                       "Where 1010h saves and from where each start loads; without it nothing is saved")
            ->type_name("FILE")
            ->check(CLI::Validator(ProblemOfFileName, ""));
        app.add_flag("--lss", has_lss_,
                     "LSS gives the node-ID, also where the file does not say LSS_Supported=1; without a node-ID of "
                     "file, command line or store there is nothing but LSS");
        app.add_flag("--no-self-tests", has_no_self_tests_,
                     "Leave out the cyclic tests of program, memory, stack, parts and permits");
        app.add_flag("--json", is_json_, "One JSON object a line");
        app.add_flag("--no-input", has_no_input_, "Read no orders from the standard input");
        app.footer("Orders, typed as lines or in a script:\n" + runtime::OrderHelp() +
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
            streams.err << "counterpoint node: --can: " << error.what() << "\n";
        }
        catch (const runtime::YamlError& error)
        {
            streams.err << error.what() << "\n";
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
        const runtime::NodeScript script = script_.empty() ? runtime::NodeScript{} : runtime::ReadNodeScript(script_);
        runtime::NodePorts ports(address_, second_address_);
        runtime::NodeReport report(streams.out, is_json_ ? runtime::ReportForm::kJson : runtime::ReportForm::kText,
                                   host::LiveNow());
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
            if (!device.App().AddRule(rule))
            {
                throw runtime::YamlError(
                    script.file, rule.source.place, "a rule with an object that is no pair of the device",
                    "'set' with a normal object that it sends, 'from' with normal objects of its SRDOs");
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
