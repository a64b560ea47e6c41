// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/command.hpp"

#include "canopen/cia306/text/input_error.hpp"
#include "canopen/cia306/text/text_file.hpp"
#include "runtime/console/output_files.hpp"
#include "simulator/scenario/reader.hpp"
#include "tools/campaign/order.hpp"
#include "verification/campaign/crew.hpp"
#include "verification/campaign/managed/command.hpp"
#include "verification/campaign/managed/plan.hpp"
#include "verification/campaign/progress.hpp"
#include "verification/campaign/replay.hpp"
#include "verification/campaign/session.hpp"

#include <algorithm>
#include <charconv>
#include <ostream>
#include <stdexcept>
#include <thread>
#include <utility>

namespace counterpoint::campaign
{
namespace
{
using tools::ExitStatus;
using tools::Streams;

constexpr const char* kMerge = "merge";

[[nodiscard]] Shard ParseShard(const std::string& text)
{
    Shard shard;
    const char* const end = text.data() + text.size();
    const auto number = std::from_chars(text.data(), end, shard.number);
    const bool has_slash = number.ec == std::errc() && number.ptr != end && *number.ptr == '/';
    const auto count = has_slash ? std::from_chars(number.ptr + 1, end, shard.count) : number;
    const bool is_right = has_slash && count.ec == std::errc() && count.ptr == end && shard.number >= 1U &&
                          shard.number <= shard.count && shard.count <= 1000000U;
    if (!is_right)
    {
        throw runtime::YamlError("--shard", {}, runtime::Shown(text), "K/N with K from 1 to N, as 2/8");
    }
    return shard;
}

class CampaignRun final : public tools::Command
{
  public:
    void Describe(tools::Options& options) override
    {
        tools::DescribeCampaign(options, order_);
    }

    [[nodiscard]] ExitStatus Run(const Streams& streams) override
    {
        try
        {
            const bool merges = order_.files.front() == kMerge;
            RequireFiles(merges);
            if (managed::IsManagedPlan(order_.files[merges ? 1U : 0U]))
            {
                return RunManaged(merges, streams);
            }
            if (!order_.replay.empty())
            {
                return ShowAgain(streams);
            }
            return merges ? Merge(streams) : Try(streams);
        }
        catch (const runtime::YamlError&)
        {
            throw;
        }
        catch (const cia306::InputError&)
        {
            throw;
        }
        catch (const NotWell& error)
        {
            streams.out << "not well: " << error.what() << "\nverdict: does not hold\n";
            return ExitStatus::kDoesNotHold;
        }
        catch (const std::runtime_error& error)
        {
            streams.err << "counterpoint campaign: error: " << error.what() << "\n";
            return ExitStatus::kBadInput;
        }
    }

  private:
    /// A network with managers. [SRS_CMG_070]
    [[nodiscard]] ExitStatus RunManaged(const bool merges, const Streams& streams) const
    {
        if (!order_.replay.empty())
        {
            return managed::ShowAgain(order_, streams);
        }
        return merges ? managed::Merge(order_, streams) : managed::Try(order_, ParseShard(order_.shard), streams);
    }

    void RequireFiles(const bool merges) const
    {
        if (!merges && order_.files.size() != 1U)
        {
            throw runtime::YamlError(order_.files[1U], {}, "a second file", "one PLAN, or: merge PLAN RESULTS ...");
        }
        if (merges && order_.files.size() < 3U)
        {
            throw runtime::YamlError(kMerge, {}, "no results to join", "merge PLAN RESULTS ...");
        }
        if (merges)
        {
            RequireNothingToTry();
        }
        RequireOutputs(merges ? 1U : 0U);
    }

    /// A merge tries nothing. [SRS_CMG_048]
    void RequireNothingToTry() const
    {
        const tools::CampaignOrder usual;
        for (const auto& [option, is_given] : {std::pair("--replay", order_.replay != usual.replay),
                                               {"--shard", order_.shard != usual.shard},
                                               {"--jobs", order_.jobs != usual.jobs}})
        {
            if (is_given)
            {
                throw runtime::YamlError(option, {}, "beside merge, which tries nothing", "it without merge");
            }
        }
    }

    /// Before anything is tried. [SRS_CMG_049]
    void RequireOutputs(const std::size_t plan) const
    {
        runtime::OutputFiles files;
        for (std::size_t index = plan; index < order_.files.size(); ++index)
        {
            files.Read(order_.files[index]);
        }
        const std::string& name = order_.files[plan];
        for (const std::string& file : managed::IsManagedPlan(name)
                                           ? managed::FilesOf(name)
                                           : simulator::FilesOf(simulator::LoadScenario(ReadPlan(name).scenario)))
        {
            files.Read(file);
        }
        files.Read(order_.out); // What is in it is gone on with.
        files.Write("--html", order_.html);
        files.Write("--csv", order_.csv);
        files.Write("--json", order_.json);
    }

    [[nodiscard]] ExitStatus Try(const Streams& streams) const
    {
        const Shard shard = ParseShard(order_.shard);
        Session session(order_.files.front());
        Results results(order_.out, session.Identity(shard));
        TellEmpty(results, order_.out, streams.err);
        const std::uint64_t begun = results.Size() - results.OpenCount();
        const std::uint32_t jobs = (order_.jobs == 0) ? std::max(1U, std::thread::hardware_concurrency())
                                                      : static_cast<std::uint32_t>(order_.jobs);
        {
            Progress progress(streams.err, results.Size(), begun);
            Crew crew(session.Runs(), session.Faults(), results, jobs);
            crew.Work([&progress](const std::uint64_t done) { progress.Show(done); });
        }
        results.RequireKept();
        return Report(session, results, streams);
    }

    [[nodiscard]] ExitStatus ShowAgain(const Streams& streams) const
    {
        Session session(order_.files.front());
        std::uint64_t number = 0U;
        const char* const end = order_.replay.data() + order_.replay.size();
        const auto [stop, error] = std::from_chars(order_.replay.data(), end, number);
        if (error != std::errc() || stop != end || number >= session.Faults().Size())
        {
            throw runtime::YamlError("--replay", {}, runtime::Shown(order_.replay),
                                     "the number of an experiment, 0 to " +
                                         std::to_string(session.Faults().Size() - 1U));
        }
        const Replay replay(session, number);
        if (!order_.html.empty())
        {
            cia306::WriteTextFile(order_.html, replay.Page());
        }
        streams.out << replay.Text();
        return IsDangerous(replay.Found().result) ? ExitStatus::kDoesNotHold : ExitStatus::kHolds;
    }

    [[nodiscard]] ExitStatus Merge(const Streams& streams) const
    {
        const Session session(order_.files[1U]);
        Results all(order_.out, session.Identity(Shard{}));
        TellEmpty(all, order_.out, streams.err);
        for (std::size_t index = 2U; index < order_.files.size(); ++index)
        {
            all.Merge(order_.files[index]);
        }
        all.RequireKept();
        return Report(session, all, streams);
    }

    [[nodiscard]] ExitStatus Report(const Session& session, const Results& results, const Streams& streams) const
    {
        const Campaign campaign = session.Parts();
        const Summary summary = Summarise(campaign, results);
        if (!order_.html.empty())
        {
            cia306::WriteTextFile(order_.html, HtmlReport(campaign, summary));
        }
        if (!order_.json.empty())
        {
            cia306::WriteTextInPieces(order_.json, [&campaign, &summary](const cia306::TextPiece& write)
                                      { JsonReport(campaign, summary, write); });
        }
        if (!order_.csv.empty())
        {
            cia306::WriteTextInPieces(order_.csv, [&campaign, &results](const cia306::TextPiece& write)
                                      { CsvReport(campaign, results, write); });
        }
        streams.out << TextReport(campaign, summary);
        return (summary.Holds() && summary.open == 0U) ? ExitStatus::kHolds : ExitStatus::kDoesNotHold;
    }

    tools::CampaignOrder order_;
};
} // namespace

std::unique_ptr<tools::Command> MakeCampaign()
{
    return std::make_unique<CampaignRun>();
}
} // namespace counterpoint::campaign
