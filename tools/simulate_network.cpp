// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/simulate_network.hpp"

#include "canopen/cia306/text/text_file.hpp"
#include "runtime/console/output_files.hpp"
#include "runtime/manager/report/status.hpp"
#include "runtime/network_files/file.hpp"
#include "simulator/networks/simulation.hpp"
#include "simulator/report/reports.hpp"

#include <ostream>

namespace counterpoint::tools
{
namespace
{
/// With several managers each line tells whose it is.
std::string LineOf(const simulator::NetworkScenario& scenario, const simulator::SimulatedManager& manager,
                   const runtime::ManagerEvent& event)
{
    const std::string whose = (scenario.managers.size() > 1U) ? "[" + std::to_string(manager.node) + "] " : "";
    return whose + runtime::TextLine(event);
}

nlohmann::ordered_json JsonOf(const simulator::NetworkScenario& scenario,
                              const simulator::NetworkSimulation& simulation)
{
    nlohmann::ordered_json verdicts = nlohmann::ordered_json::array();
    for (const simulator::NetworkVerdict& verdict : simulation.Verdicts())
    {
        verdicts.push_back({{"holds", verdict.holds}, {"text", verdict.text}});
    }
    nlohmann::ordered_json managers = nlohmann::ordered_json::array();
    for (const auto& manager : simulation.Managers())
    {
        nlohmann::ordered_json events = nlohmann::ordered_json::array();
        for (const runtime::ManagerEvent& event : manager->events)
        {
            events.push_back(nlohmann::ordered_json::parse(runtime::JsonLine(event)));
        }
        managers.push_back({{"node", manager->node}, {"events", events}});
    }
    return {{"title", scenario.title}, {"managers", managers}, {"verdicts", verdicts}};
}

std::string PageOf(const simulator::NetworkScenario& scenario, const simulator::NetworkSimulation& simulation)
{
    constexpr std::uint64_t kNsPerUs = 1000U;
    const simulator::SimulatedManager& first = *simulation.Managers().front();
    return (first.station == nullptr) ? std::string{}
                                      : runtime::DiagramPage(first.station->Host(), first.station->Diagram(),
                                                             runtime::InstantAt(scenario.duration_ns / kNsPerUs));
}

/// Before the run: nothing that it reads is written, the network files and their DCFs included.
void RequireFiles(const simulator::NetworkScenario& scenario, const NetworkOptions& options)
{
    runtime::OutputFiles files;
    files.Read(scenario.file);
    for (const simulator::ScenarioManager& manager : scenario.managers)
    {
        const network::NetworkPlan plan = runtime::ReadNetworkFile(manager.network, manager.node);
        files.Read(manager.network);
        files.Read(plan.manager.dcf);
        for (const network::SlavePlan& slave : plan.slaves)
        {
            files.Read(slave.dcf);
            files.Read(slave.software ? slave.software->program : "");
        }
    }
    for (const simulator::ScenarioDevice& device : scenario.devices)
    {
        files.Read(device.dcf);
    }
    files.Write("--html", options.html);
    files.Write("--json", options.json);
    files.Write("--candump", options.candump);
}

void WriteFiles(const NetworkOptions& options, const simulator::NetworkScenario& scenario,
                const simulator::NetworkSimulation& simulation, const std::string& frames)
{
    if (!options.json.empty())
    {
        cia306::WriteTextFile(options.json, JsonOf(scenario, simulation).dump(1) + "\n");
    }
    if (!options.candump.empty())
    {
        cia306::WriteTextFile(options.candump, frames);
    }
    if (!options.html.empty())
    {
        cia306::WriteTextFile(options.html, PageOf(scenario, simulation));
    }
}
} // namespace

ExitStatus SimulateNetwork(const std::string& path, const NetworkOptions& options, const Streams& streams)
{
    const simulator::NetworkScenario scenario = simulator::ReadNetworkScenario(path);
    RequireFiles(scenario, options);
    if (!options.is_quiet)
    {
        streams.out << scenario.title << "\n\n";
    }
    simulator::NetworkSimulation simulation(
        scenario,
        [&](const simulator::SimulatedManager& manager, const runtime::ManagerEvent& event)
        {
            if (!options.is_quiet && !event.text.empty())
            {
                streams.out << LineOf(scenario, manager, event) << "\n";
            }
        });
    for (const auto& manager : simulation.Managers())
    {
        for (const std::string& warning : manager->net->Warnings())
        {
            streams.err << warning << "\n";
        }
    }
    std::string frames;
    if (!options.candump.empty())
    {
        simulation.Listen(
            [&frames](const host::LiveFrame& frame)
            {
                frames += simulator::CandumpLine(host::ToCanFrame(frame, CanPortId::kFirst),
                                                 static_cast<runtime::Nanoseconds>(frame.time_ns));
            });
    }
    simulation.Run();
    std::size_t held = 0U;
    for (const simulator::NetworkVerdict& verdict : simulation.Verdicts())
    {
        held += verdict.holds ? 1U : 0U;
        if (!verdict.holds || !options.is_quiet)
        {
            streams.out << (held == 1U && !options.is_quiet && verdict.holds ? "\n" : "")
                        << (verdict.holds ? "holds     " : "VIOLATED  ") << verdict.text << "\n";
        }
    }
    if (!options.is_quiet)
    {
        streams.out << held << " of " << simulation.Verdicts().size() << " expectations hold, "
                    << simulation.FrameCount() << " frames\n";
    }
    WriteFiles(options, scenario, simulation, frames);
    return (held == simulation.Verdicts().size()) ? ExitStatus::kHolds : ExitStatus::kDoesNotHold;
}
} // namespace counterpoint::tools
