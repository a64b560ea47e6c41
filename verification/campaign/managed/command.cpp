// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/managed/command.hpp"

#include "canopen/cia306/text/input_error.hpp"
#include "canopen/cia306/text/text_file.hpp"
#include "runtime/device/time_text.hpp"
#include "runtime/network_files/file.hpp"
#include "simulator/scenario/reader.hpp"
#include "verification/campaign/html.hpp"
#include "verification/campaign/managed/crew.hpp"
#include "verification/campaign/managed/report.hpp"
#include "verification/campaign/progress.hpp"
#include "verification/campaign/runner.hpp"
#include "version/version.hpp"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <ostream>
#include <thread>

namespace counterpoint::campaign::managed
{
namespace
{
using tools::CampaignOrder;
using tools::ExitStatus;
using tools::Streams;

/// The run without fault, and nothing that it must not do.
[[nodiscard]] Reference Sound(const Plan& plan)
{
    Course course(plan);
    Reference reference = course.RunWithout();
    if (course.Judge().Found() != Wrong::kNothing)
    {
        throw NotWell(
            "without a fault, after " +
            MsText(static_cast<std::uint32_t>(course.Judge().FoundAt() / runtime::kNanosecondsPerMicrosecond)) +
            " ms: " + TextOf(course.Judge().Found()));
    }
    return reference;
}

/// What a network file names in turn. Whether it is one, and right, is said when the run reads it. [SRS_CMG_805]
void AddFilesOf(const std::string& network, std::vector<std::string>& files)
{
    const auto add = [&files](const std::string& file)
    {
        if (!file.empty())
        {
            files.push_back(file);
        }
    };
    try
    {
        const network_plan::NetworkPlan plan = runtime::ReadNetworkFile(network, 0U);
        add(plan.manager.dcf);
        for (const network_plan::SlavePlan& slave : plan.slaves)
        {
            add(slave.dcf);
            add(slave.software ? slave.software->program : "");
        }
    }
    catch (const runtime::YamlError&)
    {
    }
    catch (const cia306::InputError&)
    {
    }
}

/// Everything that a plan needs, from its file on.
struct Session
{
    explicit Session(const std::string& file)
        : plan(ReadManagedPlan(file)), reference(Sound(plan)), course(plan), space(plan, course.World(), reference)
    {
    }

    /// Of the text of the plan, of all files that the network is made of, of what is on the bus without fault, and of
    /// the program. [SRS_CMG_800]
    [[nodiscard]] ResultsOf Identity(const Shard& shard) const
    {
        std::uint64_t digest = WithFiles(kNoDigest, FilesOf(plan.file));
        for (const auto& [sender, hash] : reference.hashes)
        {
            digest = With(digest, hash);
        }
        for (const ManagerMember& member : reference.memory)
        {
            digest = With(digest, member.size_bytes);
        }
        return {plan.digest, space.Size(), shard, digest, OfProgram(kNoDigest, CounterpointVersion), &StrangeIn};
    }

    Plan plan;
    Reference reference;
    Course course; ///< At its begin.
    Space space;
};

[[nodiscard]] ExitStatus Report(const CampaignOrder& order, const Session& session, const Results& results,
                                const Streams& streams)
{
    const Campaign campaign{session.plan, session.space, results};
    const Summary summary = Summarise(campaign);
    if (!order.html.empty())
    {
        cia306::WriteTextFile(order.html, HtmlReport(campaign, summary));
    }
    if (!order.json.empty())
    {
        cia306::WriteTextInPieces(order.json, [&campaign, &summary](const cia306::TextPiece& write)
                                  { JsonReport(campaign, summary, write); });
    }
    if (!order.csv.empty())
    {
        cia306::WriteTextInPieces(order.csv,
                                  [&campaign](const cia306::TextPiece& write) { CsvReport(campaign, write); });
    }
    streams.out << TextReport(campaign, summary);
    return (summary.Holds() && summary.open == 0U) ? ExitStatus::kHolds : ExitStatus::kDoesNotHold;
}

/// A line of the time line.
struct Line
{
    Nanoseconds at{0};
    std::string text;
};

[[nodiscard]] std::string MsOf(const Nanoseconds at)
{
    constexpr std::size_t kWidth = 11U;
    return runtime::MillisecondsColumn(at, kWidth) + "  ";
}

/// Frames around the fault, and of each sender the first ones that are not those of the run without it.
void AddFrames(const Trial& trial, const Reference& reference, Course& course, std::vector<Line>& lines)
{
    constexpr Nanoseconds kBefore = 2 * runtime::kNanosecondsPerMillisecond;
    constexpr Nanoseconds kBehind = 3 * runtime::kNanosecondsPerMillisecond;
    constexpr std::size_t kMostFrames = 90U;
    std::size_t shown = 0U;
    std::map<std::uint32_t, std::size_t> counts;
    for (const RecordedFrame& frame : course.Judge().Frames())
    {
        const auto is_around = [&frame](const Nanoseconds at)
        { return frame.start >= at - kBefore && frame.start <= at + kBehind; };
        const bool is_near = is_around(trial.at) || is_around(IsOfFrames(trial.target) ? EndOf(trial.hit) : trial.at);
        const bool is_command = frame.frame.identifier < 0x80U && frame.start >= trial.at;
        if ((!is_near && !is_command) || shown >= kMostFrames)
        {
            continue;
        }
        ++shown;
        char text[64] = {};
        int length = std::snprintf(text, sizeof(text), "%03X#", static_cast<unsigned>(frame.frame.identifier));
        for (std::uint8_t byte = 0U; byte < frame.frame.length_bytes; ++byte)
        {
            length += std::snprintf(text + length, sizeof(text) - static_cast<std::size_t>(length), "%02X",
                                    static_cast<unsigned>(frame.frame.data[byte]));
        }
        const bool is_known = std::any_of(reference.frames.begin(), reference.frames.end(),
                                          [&frame](const RecordedFrame& each) { return each.start == frame.start; });
        lines.push_back({frame.start, course.World().NameOf(frame.sender) + " sends " + text +
                                          (is_known ? "" : "  (not then without the fault)")});
    }
}

[[nodiscard]] std::string TimeLine(const Session& session, const std::uint64_t number, Course& course, Outcome& outcome)
{
    const Trial trial = session.space.At(number);
    course.AdvanceTo(trial.at);
    outcome = course.Try(trial, session.space, session.reference);
    std::vector<Line> lines;
    AddFrames(trial, session.reference, course, lines);
    lines.push_back({trial.at, "FAULT: " + session.space.PlaceText(trial)});
    for (const Telling& telling : course.News(session.reference, trial.at))
    {
        lines.push_back({telling.at, std::string("told by ") + WordOf(telling.teller) + ": " +
                                         telling.key.substr(0U, telling.key.find(' ', telling.key.find(' ') + 1U)) +
                                         ": " + telling.text});
    }
    if (course.Judge().Found() != Wrong::kNothing)
    {
        lines.push_back({course.Judge().FoundAt(), std::string("WRONG: ") + TextOf(course.Judge().Found())});
    }
    std::stable_sort(lines.begin(), lines.end(),
                     [](const Line& left, const Line& right) { return left.at < right.at; });
    std::string text = session.plan.title + ", experiment " + std::to_string(number) + "\n";
    for (const Line& line : lines)
    {
        text += MsOf(line.at) + line.text + "\n";
    }
    return text + SentenceOf(outcome) + "\n";
}
} // namespace

std::vector<std::string> FilesOf(const std::string& plan)
{
    const std::vector<simulator::ScenarioDocument> documents = simulator::LoadScenario(ReadManagedPlan(plan).scenario);
    std::vector<std::string> files = simulator::FilesOf(documents);
    for (const std::string& network : simulator::NetworkFilesOf(documents))
    {
        files.push_back(network);
        AddFilesOf(network, files);
    }
    return files;
}

ExitStatus Try(const CampaignOrder& order, const Shard& shard, const Streams& streams)
{
    Session session(order.files.front());
    Results results(order.out, session.Identity(shard));
    TellEmpty(results, order.out, streams.err);
    const std::uint64_t begun = results.Size() - results.OpenCount();
    const std::uint32_t jobs =
        (order.jobs == 0) ? std::max(1U, std::thread::hardware_concurrency()) : static_cast<std::uint32_t>(order.jobs);
    {
        Progress progress(streams.err, results.Size(), begun);
        Crew crew(session.course, session.space, session.reference, results, jobs);
        crew.Work([&progress](const std::uint64_t done) { progress.Show(done); });
    }
    results.RequireKept();
    return Report(order, session, results, streams);
}

ExitStatus Merge(const CampaignOrder& order, const Streams& streams)
{
    const Session session(order.files[1U]);
    Results all(order.out, session.Identity(Shard{}));
    TellEmpty(all, order.out, streams.err);
    for (std::size_t index = 2U; index < order.files.size(); ++index)
    {
        all.Merge(order.files[index]);
    }
    all.RequireKept();
    return Report(order, session, all, streams);
}

ExitStatus ShowAgain(const CampaignOrder& order, const Streams& streams)
{
    Session session(order.files.front());
    std::uint64_t number = 0U;
    const char* const end = order.replay.data() + order.replay.size();
    const auto [stop, error] = std::from_chars(order.replay.data(), end, number);
    if (error != std::errc() || stop != end || number >= session.space.Size())
    {
        throw runtime::YamlError("--replay", {}, runtime::Shown(order.replay),
                                 "the number of an experiment, 0 to " + std::to_string(session.space.Size() - 1U));
    }
    Outcome outcome{};
    const std::string text = TimeLine(session, number, session.course, outcome);
    if (!order.html.empty())
    {
        cia306::WriteTextFile(order.html, html::Head(session.plan.title + ", experiment " + std::to_string(number)) +
                                              "<pre>" + html::Escaped(text) + "</pre></body></html>\n");
    }
    streams.out << text;
    return (outcome.result == Class::kSilent) ? ExitStatus::kDoesNotHold : ExitStatus::kHolds;
}
} // namespace counterpoint::campaign::managed
