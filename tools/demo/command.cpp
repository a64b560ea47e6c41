// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/demo/command.hpp"

#include "canopen/cia306/text/input_error.hpp"
#include "canopen/cia306/text/text_file.hpp"
#include "runtime/console/json_text.hpp"
#include "simulator/judge/run.hpp"
#include "simulator/report/reports.hpp"
#include "simulator/scenario/names.hpp"
#include "simulator/scenario/reader.hpp"
#include "tools/command_line/options.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <iomanip>
#include <ostream>
#include <string>
#include <system_error>
#include <vector>

namespace counterpoint::tools
{
namespace
{
namespace fs = std::filesystem;

/// Some of its scenarios are examples, the others test data; the examples alone are installed.
constexpr const char* kExamples = "examples/emergency_stop";
constexpr const char* kInstalled = "share/counterpoint";
constexpr const char* kTestData = "tests/simulator/scenarios/emergency_stop";
constexpr int kFaultColumn = 34;
constexpr int kPartyColumn = 17;
constexpr int kCauseColumn = 20;
constexpr int kTimeColumn = 12;

/// Folders of the shipped scenarios: in the working directory, else in the tree that the program was built in, else in
/// the package that it is installed in. [SRS_DEMO_005]
std::vector<fs::path> FindScenarios()
{
    std::error_code error;
    fs::path root;
    if (!fs::is_directory(kExamples))
    {
        root = fs::read_symlink("/proc/self/exe", error).parent_path();
        while (root.has_relative_path() && !fs::is_directory(root / kExamples))
        {
            if (fs::is_directory(root / kInstalled / kExamples))
            {
                return {root / kInstalled / kExamples};
            }
            root = root.parent_path();
        }
    }
    return {root / kExamples, root / kTestData};
}

/// Files NN_name.yaml in the order of their numbers; the others are what these extend.
std::vector<std::string> ListScenarios(const std::vector<fs::path>& folders)
{
    std::error_code error;
    std::vector<fs::path> paths;
    for (const fs::path& folder : folders)
    {
        for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
        {
            const std::string name = entry.path().filename().string();
            const bool is_numbered = name.size() > 3U && std::isdigit(static_cast<unsigned char>(name[0])) != 0 &&
                                     std::isdigit(static_cast<unsigned char>(name[1])) != 0 && name[2] == '_';
            if (is_numbered && entry.path().extension() == ".yaml")
            {
                paths.push_back(entry.path());
            }
        }
    }
    if (paths.empty())
    {
        throw cia306::InputError(folders.front().string(), {},
                                 {"no scenarios", "files such as 01_loss.yaml; --scenarios names their folder"});
    }
    std::sort(paths.begin(), paths.end(),
              [](const fs::path& left, const fs::path& right) { return left.filename() < right.filename(); });
    return {paths.begin(), paths.end()};
}

/// The expectation whose limit a row shows.
const simulator::Expectation* LimitedExpectation(const simulator::Run& run)
{
    for (const simulator::Expectation& expectation : run.Setting().expectations)
    {
        if (expectation.kind == simulator::ExpectationKind::kSafeWithin)
        {
            return &expectation;
        }
    }
    return nullptr;
}

class DemoCommand final : public Command
{
  public:
    void Describe(Options& options) override
    {
        options.Add("--html", &html_, "Page with all timing diagrams; a folder gets index.html")
            .ShowDefault()
            .Check(ProblemOfFileName);
        options.Add("--scenarios", &scenarios_, "Folder of the scenarios NN_name.yaml").Check(ProblemOfFileName);
        options.Add("--list", &list_, "List the scenarios and end").Excludes("--html");
        options.Add("--json", &json_, "Print one JSON document instead of the table").Excludes("--list");
        options_ = &options;
    }

    [[nodiscard]] ExitStatus Run(const Streams& streams) override
    {
        const std::vector<std::string> files =
            ListScenarios(scenarios_.empty() ? FindScenarios() : std::vector<fs::path>{scenarios_});
        return list_ ? List(files, streams) : Demonstrate(files, streams);
    }

  private:
    [[nodiscard]] static ExitStatus List(const std::vector<std::string>& files, const Streams& streams)
    {
        for (const std::string& file : files)
        {
            const simulator::Scenario scenario = simulator::ReadScenario(file);
            streams.out << std::left << std::setw(kFaultColumn) << scenario.title << " " << file << "\n";
        }
        return ExitStatus::kHolds;
    }

    [[nodiscard]] ExitStatus Demonstrate(const std::vector<std::string>& files, const Streams& streams) const
    {
        std::vector<std::unique_ptr<simulator::Run>> runs;
        for (const std::string& file : files) // All before the first line: bad input prints nothing else.
        {
            runs.push_back(std::make_unique<simulator::Run>(file, std::nullopt, std::nullopt, true));
        }
        const std::string page = RequirePage();
        return json_ ? DemonstrateToPrograms(runs, page, streams) : DemonstrateToPeople(runs, page, streams);
    }

    [[nodiscard]] static ExitStatus StatusOf(const std::vector<std::unique_ptr<simulator::Run>>& runs)
    {
        const bool holds = std::all_of(runs.begin(), runs.end(),
                                       [](const std::unique_ptr<simulator::Run>& run) { return run->Holds(); });
        return holds ? ExitStatus::kHolds : ExitStatus::kDoesNotHold;
    }

    /// What `simulate --json` says of each run in full. [SRS_DEMO_006]
    [[nodiscard]] static ExitStatus DemonstrateToPrograms(const std::vector<std::unique_ptr<simulator::Run>>& runs,
                                                          const std::string& page, const Streams& streams)
    {
        nlohmann::ordered_json rows = nlohmann::ordered_json::array();
        for (const std::unique_ptr<simulator::Run>& run : runs)
        {
            run->Simulate(nullptr);
            nlohmann::ordered_json row{
                {"title", run->Setting().title}, {"scenario", run->Setting().file}, {"holds", run->Holds()}};
            const simulator::Measurement* const measurement = run->FirstMeasurement();
            if (measurement != nullptr)
            {
                row["limit_ns"] = measurement->limit;
                row["elapsed_ns"] = measurement->elapsed;
                row["detected_by"] = simulator::Name(measurement->detection.party);
                row["detection_cause"] = measurement->detection.cause;
            }
            rows.push_back(row);
        }
        WritePage(runs, page);
        streams.out << runtime::JsonText({{"format", "counterpoint-demo-1"},
                                          {"holds", StatusOf(runs) == ExitStatus::kHolds},
                                          {"runs", rows},
                                          {"page", page}});
        return StatusOf(runs);
    }

    [[nodiscard]] static ExitStatus DemonstrateToPeople(const std::vector<std::unique_ptr<simulator::Run>>& runs,
                                                        const std::string& page, const Streams& streams)
    {
        streams.out << "Emergency-stop chain: sensor -> controller -> actuator, 500 kbit/s, cycle 1 ms. Each limit is "
                       "computed\n"
                       "from the device's configuration before its run; times are simulated, output time included.\n\n";
        const Cells titles{"Run", "Limit", "Time", "Detected by", "Cause", "Verdict"};
        PrintBegin(titles, streams.out);
        PrintEnd(titles, streams.out);
        for (const std::unique_ptr<simulator::Run>& run : runs)
        {
            DemonstrateOne(*run, streams.out);
        }
        const auto held = std::count_if(runs.begin(), runs.end(),
                                        [](const std::unique_ptr<simulator::Run>& run) { return run->Holds(); });
        streams.out << "\n" << held << " of " << runs.size() << " runs as expected\n";
        for (const std::unique_ptr<simulator::Run>& run : runs)
        {
            runtime::PrintLines(run->Findings(), streams.err);
            runtime::PrintLines(run->FaultsWithoutEffect(), streams.err);
            if (!run->Holds())
            {
                streams.out << "\n" << run->Setting().title << " (" << run->Setting().file << ")\n";
                simulator::WriteVerdicts(*run, streams.out);
            }
        }
        WritePage(runs, page);
        streams.out << "Timing diagrams: " << page << "\n";
        return StatusOf(runs);
    }

    using Cells = std::array<std::string, 6U>;

    /// The first two cells of a row, then the others: a row begins before its run.
    static void PrintBegin(const Cells& cells, std::ostream& out)
    {
        out << std::left << std::setw(kFaultColumn) << cells[0] << std::right << std::setw(kTimeColumn) << cells[1]
            << std::flush;
    }

    static void PrintEnd(const Cells& cells, std::ostream& out)
    {
        out << std::right << std::setw(kTimeColumn) << cells[2] << "  " << std::left << std::setw(kPartyColumn)
            << cells[3] << std::setw(kCauseColumn) << cells[4] << cells[5] << "\n";
    }

    static void DemonstrateOne(simulator::Run& run, std::ostream& out)
    {
        const simulator::Expectation* const limited = LimitedExpectation(run);
        Cells cells{run.Setting().title, "-", "-", "-", "-", ""};
        if (limited != nullptr)
        {
            // Before the run; what happens in it changes the limit only where the next normal frame still comes.
            cells[1] = simulator::LimitText(simulator::LimitOf(run.Setting(), *limited, run.ModelOf(limited->node)));
        }
        PrintBegin(cells, out);
        run.Simulate(nullptr);
        const simulator::Measurement* const measurement = run.FirstMeasurement();
        if (measurement != nullptr)
        {
            cells[2] = (measurement->elapsed < 0) ? "never" : runtime::MillisecondsText(measurement->elapsed);
            cells[3] = simulator::Words(simulator::Name(measurement->detection.party));
            cells[4] = simulator::Words(measurement->detection.cause);
        }
        cells[5] = run.Holds() ? ((limited != nullptr) ? "in time" : "as expected") : "FAILED";
        if (measurement != nullptr && simulator::LimitText(measurement->limit) != cells[1])
        {
            cells[5] += ", limit " + simulator::LimitText(measurement->limit) + ": the next normal frame came";
        }
        PrintEnd(cells, out);
        if (measurement != nullptr)
        {
            PrintTimes(run, *measurement, out);
        }
    }

    /// The time line of a fault in short; `counterpoint simulate` shows all of it.
    static void PrintTimes(const simulator::Run& run, const simulator::Measurement& measurement, std::ostream& out)
    {
        const std::string& node = run.NodeName(measurement.node);
        if (measurement.effect >= 0)
        {
            out << "    " << runtime::MillisecondsText(measurement.effect) << " "
                << run.Setting().faults[measurement.fault].name;
        }
        if (measurement.reference >= 0 && measurement.reference < measurement.effect)
        {
            out << " (last good pair " << runtime::MillisecondsText(measurement.reference) << ")";
        }
        if (measurement.detection.at >= 0)
        {
            out << ", " << runtime::MillisecondsText(measurement.detection.at) << " detected";
        }
        if (measurement.closed >= 0)
        {
            out << ", " << runtime::MillisecondsText(measurement.closed) << " " << node << " closes its output";
        }
        out << "\n";
    }

    /// The name of the page; its folder is there and can be written.
    [[nodiscard]] std::string RequirePage() const
    {
        const fs::path wanted(html_);
        const fs::path file = (wanted.extension() == ".html") ? wanted : wanted / "index.html";
        std::error_code error;
        if (file.has_parent_path())
        {
            fs::create_directories(file.parent_path(), error); // What fails here fails again below, with a message.
        }
        cia306::RequireWritable(file.string());
        return file.string();
    }

    static void WritePage(const std::vector<std::unique_ptr<simulator::Run>>& runs, const std::string& file)
    {
        std::vector<const simulator::Run*> pages;
        for (const std::unique_ptr<simulator::Run>& run : runs)
        {
            pages.push_back(run.get());
        }
        cia306::WriteTextFile(file, simulator::HtmlReport("Emergency-stop chain under faults", pages));
    }

    std::string html_{"build/demo"};
    std::string scenarios_;
    const Options* options_{nullptr};
    bool list_{false};
    bool json_{false};
};
} // namespace

std::unique_ptr<Command> MakeDemoCommand()
{
    return std::make_unique<DemoCommand>();
}
} // namespace counterpoint::tools
