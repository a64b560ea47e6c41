// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/order.hpp"

#include <initializer_list>
#include <utility>

namespace counterpoint::tools
{
void DescribeCampaign(Options& options, CampaignOrder& order)
{
    constexpr int kMostJobs = 1024;
    options.Add("PLAN", &order.files, "Plan of a campaign (YAML), or: merge PLAN RESULTS ...").Required();
    options.Add("--html", &order.html, "Write the report as a page").Check(&ProblemOfFileName);
    options
        .Add("--replay", &order.replay,
             "Number of one experiment, as report and CSV have it: its time line, with --html as a page")
        .Type("N");
    options
        .Add("--out", &order.out, "File of results: what is in it is not tried again; with merge: where all results go")
        .Check(&ProblemOfFileName)
        .Excludes("--replay");
    options.Add("--csv", &order.csv, "Write each experiment as a line").Check(&ProblemOfFileName).Excludes("--replay");
    options.Add("--json", &order.json, "Write the report for programs").Check(&ProblemOfFileName).Excludes("--replay");
    options.Add("--shard", &order.shard, "K/N: try each N-th experiment, from the K-th on")
        .ShowDefault()
        .Excludes("--replay");
    options.Add("--jobs", &order.jobs, "Processes at a time; 0: one for each processor")
        .Range(0, kMostJobs)
        .ShowDefault()
        .Excludes("--replay");
    options.Footer(
        "Start: counterpoint campaign examples/campaigns/actuator.yaml --html page.html\n"
        "One fault of it, step by step: the same plan with --replay 54\n"
        "A network with managers: counterpoint campaign examples/campaigns/managed_start.yaml\n"
        "Many machines: --shard 1/64 --out 1.results and so on, then: merge PLAN *.results --html page.html\n"
        "Killed: the same command with the same --out goes on.\n"
        "Exit status: 0 nothing silent, nothing late; 1 something is; 2 a plan that cannot be used.\n"
        "The plan and the report are explained in docs/campaign.md.");
}

std::vector<std::string> ArgumentsOf(const CampaignOrder& order)
{
    std::vector<std::string> arguments = order.files;
    for (const auto& [name, value] : {std::pair("--out", order.out),
                                      {"--html", order.html},
                                      {"--csv", order.csv},
                                      {"--json", order.json},
                                      {"--replay", order.replay},
                                      {"--shard", order.shard == CampaignOrder{}.shard ? "" : order.shard},
                                      {"--jobs", order.jobs == 0 ? "" : std::to_string(order.jobs)}})
    {
        if (!value.empty())
        {
            arguments.insert(arguments.end(), {name, value});
        }
    }
    return arguments;
}
} // namespace counterpoint::tools
