// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/text/input_error.hpp"
#include "canopen/cia306/text/text_file.hpp"
#include "hal/host/live/bus.hpp"
#include "runtime/console/json_text.hpp"
#include "runtime/console/output_files.hpp"
#include "runtime/manager/check.hpp"
#include "runtime/manager/loop.hpp"
#include "runtime/manager/report/status.hpp"
#include "runtime/network_files/file.hpp"
#include "tools/command_line/options.hpp"

#include "runtime/yaml/document.hpp"
#include "tools/command_table.hpp"

#include <ostream>
#include <unistd.h>
#include <utility>

namespace counterpoint::tools
{
namespace
{
constexpr int kHighestNodeId = 127;
constexpr int kLongestSeconds = 1000000;
constexpr std::uint64_t kNsPerSecond = 1000000000U;

class ManagerCommand final : public Command
{
  public:
    void Describe(Options& options) override
    {
        options
            .Add("--can", &address_,
                 "The bus: can0 or socketcan:can0, socketcand:HOST:PORT/can0, udp:GROUP:PORT for devices on this "
                 "machine, such as udp:239.74.163.2:43113")
            .Type("ADDRESS");
        options
            .Add("--network", &network_,
                 "The network: a CPJ file (CiA 306-3) or YAML; docs/manager.md tells the format")
            .Type("FILE")
            .Check(ProblemOfFileName);
        options
            .Add("--check", &check_,
                 "Instead: compare the network files of all flying masters of one network with the first one")
            .Type("FILE...")
            .Values(2, kHighestNodeId);
        options.Add("--node-id", &node_id_, "Node-ID of the manager (default: the one in the file)")
            .Range(1, kHighestNodeId);
        options.Add("--for", &seconds_, "End after so many seconds (default: quit, SIGINT, SIGTERM or SIGHUP)")
            .Type("SECONDS")
            .Range(1, kLongestSeconds);
        options.Add("--log", &log_, "Event log, one JSON object a line").Type("FILE").Check(ProblemOfFileName);
        options.Add("--html", &html_, "Page with the boot-up sequence diagram, written at the end")
            .Type("FILE")
            .Check(ProblemOfFileName);
        options.Add("--socket", &socket_, "Unix socket on which programs send orders, a line each")
            .Type("PATH")
            .Check(ProblemOfFileName);
        options.Add("--socket-group", &is_for_group_,
                    "The socket is for the group of its owner, too (default: for its owner alone)");
        options.Add("--json", &is_json_, "Events and answers as one JSON object a line");
        options.Add("--no-input", &has_no_input_, "Read no orders from the standard input");
        options_ = &options;
        options.Footer(
            "Orders, typed as lines or by the socket:\n" + runtime::ManagerOrderHelp() +
            "On a terminal the table of all slaves is shown and redrawn; elsewhere a line is printed for each\n"
            "event, and the table at the end. Exit status 0: at the end every mandatory slave\n"
            "was started, runs, and has nothing wrong with it.");
    }

    [[nodiscard]] ExitStatus Run(const Streams& streams) override
    {
        try
        {
            return check_.empty() ? RunManager(streams) : Check(streams);
        }
        catch (const host::LiveBusError& error)
        {
            streams.err << "counterpoint manager: --can: " << error.what() << "\n";
        }
        return ExitStatus::kBadInput;
    }

  private:
    [[nodiscard]] std::uint8_t NodeId() const
    {
        return static_cast<std::uint8_t>(node_id_);
    }

    [[nodiscard]] ExitStatus Check(const Streams& streams) const
    {
        for (const char* const option :
             {"--can", "--network", "--for", "--log", "--html", "--socket", "--socket-group", "--no-input"})
        {
            if (options_->IsGiven(option))
            {
                throw runtime::YamlError(option, {}, "with --check, which runs nothing",
                                         "--check FILE FILE... alone, or with --node-id and --json");
            }
        }
        std::vector<std::unique_ptr<network_plan::LoadedNetwork>> networks;
        std::vector<const network_plan::LoadedNetwork*> masters;
        for (const std::string& file : check_)
        {
            const std::uint8_t node = networks.empty() ? NodeId() : std::uint8_t{0U};
            networks.push_back(std::make_unique<network_plan::LoadedNetwork>(runtime::ReadNetworkFile(file, node)));
            masters.push_back(networks.back().get());
        }
        const std::vector<std::string> warnings = runtime::WarningsOf(masters);
        const std::vector<std::string> lines = runtime::DifferencesOf(masters);
        runtime::PrintLines(warnings, streams.err);
        if (is_json_)
        {
            streams.out << runtime::JsonText({{"format", "counterpoint-manager-check-1"},
                                              {"files", check_},
                                              {"holds", lines.empty()},
                                              {"differences", lines},
                                              {"warnings", warnings}});
        }
        else
        {
            runtime::PrintLines(lines, streams.out);
        }
        return lines.empty() ? ExitStatus::kHolds : ExitStatus::kDoesNotHold;
    }

    /// Before the bus is touched.
    void RequireFiles(const network_plan::LoadedNetwork& net) const
    {
        runtime::OutputFiles files;
        files.Read(network_);
        files.Read(net.Plan().manager.dcf);
        for (const auto& slave : net.Slaves())
        {
            files.Read(slave->plan.dcf);
            files.Read(slave->plan.software ? slave->plan.software->program : "");
        }
        files.Write("--log", log_);
        files.Write("--html", html_);
    }

    [[nodiscard]] ExitStatus RunManager(const Streams& streams) const
    {
        if (address_.empty() || network_.empty())
        {
            streams.err << "counterpoint manager: --" << (address_.empty() ? "can" : "network")
                        << " is missing, expected --can ADDRESS --network FILE, or --check FILE...\n";
            return ExitStatus::kBadInput;
        }
        if (is_for_group_ && socket_.empty())
        {
            throw runtime::YamlError("--socket-group", {}, "without --socket, whose rights it tells",
                                     "--socket PATH with it, or neither");
        }
        network_plan::LoadedNetwork net(runtime::ReadNetworkFile(network_, NodeId()));
        runtime::PrintLines(net.Warnings(), streams.err);
        RequireFiles(net);
        std::unique_ptr<host::LiveBus> bus = host::OpenLiveBus(address_);
        const std::unique_ptr<runtime::ManagerSocket> socket =
            socket_.empty() ? nullptr
                            : std::make_unique<runtime::ManagerSocket>(socket_, is_for_group_ ? runtime::kOwnerAndGroup
                                                                                              : runtime::kOwnerOnly);
        runtime::NodeReport report(streams.out, is_json_ ? runtime::ReportForm::kObjects : runtime::ReportForm::kText,
                                   host::LiveNow(), STDOUT_FILENO, runtime::kManagerFormat);
        runtime::ManagerLoopSettings settings;
        settings.log = log_;
        settings.for_ns = static_cast<std::uint64_t>(seconds_) * kNsPerSecond;
        settings.input = has_no_input_ ? -1 : STDIN_FILENO;
        settings.is_json = is_json_;
        settings.is_screen = !is_json_ && ::isatty(STDOUT_FILENO) != 0;
        runtime::ManagerLoop loop(net, std::move(bus), report, socket.get(), settings);
        const bool has_started = loop.Run();
        const std::uint64_t now_us = loop.NowUs();
        const runtime::ManagerStation& station = loop.Station();
        report.PrintLast(is_json_ ? runtime::OneLine(runtime::StatusJson(station, now_us))
                                  : runtime::StatusTable(station, now_us));
        if (!html_.empty())
        {
            cia306::WriteTextFile(html_, runtime::DiagramPage(station));
        }
        const bool is_written = report.Finish();
        if (!loop.IsLogWhole())
        {
            throw cia306::InputError(log_, {},
                                     {"the event log could not be written to its end", "a file system with room"});
        }
        const ExitStatus status = has_started ? ExitStatus::kHolds : ExitStatus::kDoesNotHold;
        return is_written ? status : ExitStatus::kBadInput;
    }

    const Options* options_{nullptr};
    std::string address_;
    std::string network_;
    std::vector<std::string> check_;
    std::string log_;
    std::string html_;
    std::string socket_;
    int node_id_{0};
    int seconds_{0};
    bool is_json_{false};
    bool is_for_group_{false};
    bool has_no_input_{false};
};
} // namespace

std::unique_ptr<Command> MakeManagerCommand()
{
    return std::make_unique<ManagerCommand>();
}
} // namespace counterpoint::tools
