// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/text/input_error.hpp"
#include "canopen/cia306/text/text_file.hpp"
#include "runtime/console/output_files.hpp"
#include "runtime/console/progress_bar.hpp"
#include "runtime/network_files/file.hpp"
#include "simulator/judge/run.hpp"
#include "simulator/judge/sweep.hpp"
#include "simulator/managers/managed.hpp"
#include "simulator/report/reports.hpp"
#include "simulator/scenario/network_names.hpp"
#include "simulator/scenario/reader.hpp"
#include "simulator/scenario/schema.hpp"
#include "tools/command_line/options.hpp"
#include "tools/command_table.hpp"
#include "tools/file_warnings.hpp"

#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace counterpoint::tools
{
namespace
{
/// What --explain alone stands for: an empty KEY is a slip, as of a variable that a shell does not know.
constexpr const char* kEverything = "all";

std::vector<std::string> Profiles()
{
    std::vector<std::string> words;
    for (const simulator::FoundWord& profile : simulator::kProfileWords)
    {
        words.emplace_back(profile.text);
    }
    return words;
}

class SimulateCommand final : public Command
{
  public:
    void Describe(Options& options) override
    {
        options.Add("SCENARIO", &scenario_, "Scenario file (YAML); --explain tells the format");
        options.Add("--html", &html_, "Write a page with the timing diagram").Check(ProblemOfFileName);
        options.Add("--json", &json_, "Write recording, measurements and verdicts as JSON").Check(ProblemOfFileName);
        options.Add("--candump", &candump_, "Write the frames of the bus as candump -l does").Check(ProblemOfFileName);
        options.Add("--seed", &seed_, "Instead of the scenario's seed: 0 to 2^64 - 1").Type("N");
        options.Add("--profile", &profile_, "Start-up profile of the managers: one of the scenario's 'profiles'")
            .Words(Profiles())
            .Check(ProblemOfAnyText); // The scenario says which.
        options.Add("--until", &until_, "Instead of the scenario's duration, with its unit: 500ms, 20s");
        options.Add("--frames", &frames_, "Show every frame on the time line");
        options.Add("--quiet", &quiet_, "No time line; only what was expected and did not come").Excludes("--frames");
        options.Add("--sweep", &sweeps_, "NAME=FROM:TO:STEP: run once for each value of the key with this path")
            .OneValueEach()
            .Excludes("--frames");
        options
            .Add("--explain", &explained_, "Describe the scenario format (all), or one KEY or section of it, and end")
            .Values(0, 1)
            .IfAlone(kEverything)
            .Type("[KEY]");
        options.Add("--markdown", &markdown_, "With --explain: the reference as it stands in docs/scenario.md");
        options_ = &options;
    }

    [[nodiscard]] ExitStatus Run(const Streams& streams) override
    {
        if (options_->IsGiven("--explain") || markdown_)
        {
            return Explain(streams);
        }
        if (scenario_.empty())
        {
            streams.err << "counterpoint simulate: no scenario, expected SCENARIO or --explain\n";
            return ExitStatus::kBadInput;
        }
        return sweeps_.empty() ? Simulate(streams) : Sweep(streams);
    }

  private:
    /// `simulate --explain`, alone or with a name. [SRS_SIM_047]
    [[nodiscard]] ExitStatus Explain(const Streams& streams) const
    {
        if (!options_->IsGiven("--explain") || options_->GivenCount() > (markdown_ ? 2U : 1U))
        {
            streams.err << "counterpoint simulate: --explain with something else, expected it alone\n";
            return ExitStatus::kBadInput;
        }
        const std::string name = (explained_ == kEverything) ? std::string() : explained_;
        const std::string text = markdown_ ? simulator::ExplainMarkdown() : simulator::ExplainText(name);
        if (explained_.empty() || text.empty())
        {
            streams.err << "counterpoint simulate: --explain " << runtime::Shown(explained_)
                        << cia306::DidYouMean(explained_, simulator::ExplainedNames())
                        << ", expected a key or section of the format; without a name all of them are told\n";
            return ExitStatus::kBadInput;
        }
        streams.out << text;
        return ExitStatus::kHolds;
    }

    [[nodiscard]] std::optional<runtime::Nanoseconds> Until() const
    {
        return options_->IsGiven("--until") ? std::optional(simulator::ParseDuration("--until", until_)) : std::nullopt;
    }

    [[nodiscard]] std::optional<std::uint64_t> Seed() const
    {
        return options_->IsGiven("--seed") ? std::optional(simulator::ParseSeed("--seed", seed_)) : std::nullopt;
    }

    [[nodiscard]] ExitStatus Sweep(const Streams& streams) const
    {
        std::vector<simulator::SweepAxis> axes;
        for (const std::string& sweep : sweeps_)
        {
            axes.push_back(simulator::ParseSweepAxis(sweep));
        }
        RequireFiles();
        if (options_->IsGiven("--candump"))
        {
            throw runtime::YamlError("--candump", {}, "frames of one bus for a sweep", "--html or --json");
        }
        tools::TellFileWarnings(simulator::FilesOf(simulator::LoadScenario(scenario_)), streams.err);
        const simulator::SweepOptions options{Seed(), Until(), &simulator::MakeManagedWorld, profile_};
        simulator::SweepResult result;
        {
            runtime::ProgressBar bar(streams.err, "sweeping");
            result = simulator::RunSweep(scenario_, axes, options, [&bar](const double part) { bar.Show(part); });
        }
        if (!html_.empty())
        {
            cia306::WriteTextFile(html_, simulator::SweepHtml(result));
        }
        if (!json_.empty())
        {
            cia306::WriteTextFile(json_, simulator::SweepJson(result));
        }
        if (!quiet_ || !result.Holds())
        {
            simulator::WriteSweepTable(result, streams.out);
        }
        return result.Holds() ? ExitStatus::kHolds : ExitStatus::kDoesNotHold;
    }

    [[nodiscard]] ExitStatus Simulate(const Streams& streams) const
    {
        const std::optional<runtime::Nanoseconds> until = Until();
        RequireFiles();
        tools::TellFileWarnings(simulator::FilesOf(simulator::LoadScenario(scenario_)), streams.err);
        const std::optional<std::uint64_t> seed = Seed();
        const bool keeps_all = !quiet_ || !html_.empty() || !json_.empty() || !candump_.empty();
        simulator::Run run(scenario_, seed, until, keeps_all, &simulator::MakeManagedWorld, profile_);
        {
            runtime::ProgressBar bar(streams.err, "simulating");
            const auto duration = static_cast<double>(run.Setting().duration);
            run.Simulate([&bar, duration](const runtime::Nanoseconds now)
                         { bar.Show(static_cast<double>(now) / duration); });
        }
        if (!quiet_)
        {
            simulator::WriteTimeLine(run, frames_ ? simulator::FrameLines::kAll : simulator::FrameLines::kCounted,
                                     streams.out);
        }
        WriteFiles(run);
        runtime::PrintLines(run.Findings(), streams.err);
        runtime::PrintLines(run.FaultsWithoutEffect(), streams.err);
        if (!quiet_ || !run.Holds())
        {
            simulator::WriteVerdicts(run, streams.out);
        }
        return run.Holds() ? ExitStatus::kHolds : ExitStatus::kDoesNotHold;
    }

    /// All before the run.
    void RequireFiles() const
    {
        runtime::OutputFiles files;
        files.Read(scenario_);
        const std::vector<simulator::ScenarioDocument> documents = simulator::LoadScenario(scenario_);
        for (const std::string& file : simulator::FilesOf(documents))
        {
            files.Read(file);
        }
        for (const std::string& file : simulator::NetworkFilesOf(documents))
        {
            files.Read(file);
            ReadNetwork(file, files);
        }
        for (const auto& [option, file] : {std::pair("--html", html_), {"--json", json_}, {"--candump", candump_}})
        {
            files.Write(option, file);
        }
    }

    /// What a network file names in turn. Whether it is one, and right, is said when the run reads it.
    static void ReadNetwork(const std::string& file, runtime::OutputFiles& files)
    {
        try
        {
            const network_plan::NetworkPlan plan = runtime::ReadNetworkFile(file, 0U);
            files.Read(plan.manager.dcf);
            for (const network_plan::SlavePlan& slave : plan.slaves)
            {
                files.Read(slave.dcf);
                files.Read(slave.software ? slave.software->program : "");
            }
        }
        catch (const runtime::YamlError&)
        {
        }
        catch (const cia306::InputError&)
        {
        }
    }

    void WriteFiles(const simulator::Run& run) const
    {
        if (!html_.empty())
        {
            const std::string& title = run.Setting().title;
            cia306::WriteTextFile(html_,
                                  simulator::HtmlReport(title.empty() ? "Counterpoint simulation" : title, {&run}));
        }
        if (!json_.empty())
        {
            cia306::WriteTextFile(json_, simulator::JsonReport(run));
        }
        if (!candump_.empty())
        {
            cia306::WriteTextFile(candump_, simulator::CandumpReport(run));
        }
    }

    std::string scenario_;
    std::string html_;
    std::string json_;
    std::string candump_;
    std::string until_;
    std::string seed_;
    std::string profile_;
    const Options* options_{nullptr};
    bool frames_{false};
    bool quiet_{false};
    std::string explained_;
    std::vector<std::string> sweeps_;
    bool markdown_{false};
};
} // namespace

std::unique_ptr<Command> MakeSimulateCommand()
{
    return std::make_unique<SimulateCommand>();
}
} // namespace counterpoint::tools
