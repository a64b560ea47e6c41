// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Elections of flying masters in their thousands, and what was counted.
#include "verification/elections/failover_record.hpp"
#include "verification/elections/series.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <iostream>
#include <string>
#include <unistd.h>

namespace counterpoint::elections
{
namespace
{

struct Options
{
    std::uint32_t runs{5'000U}; ///< Of each preset.
    std::uint32_t seed{1U};
    std::uint32_t first{0U};
    std::uint32_t greatest{127U};
    bool up_to{false};
    bool whole{false};
    bool seeded_only{false};
    std::string preset{"both"};
    std::string failovers{}; ///< File for these alone.
};

constexpr std::size_t kDrawnFailovers = 1000U; ///< Of each preset.
constexpr std::uint32_t kOwnClocksEach = 10U;  ///< One of so many seeded runs is done with own clocks too.

std::uint64_t Print(const std::string& name, const Tally& tally)
{
    std::printf("%-44s %9" PRIu64 " runs, %9" PRIu64 " with a lost frame, %10" PRIu64 " frames, %4" PRIu64
                " collisions, %3" PRIu64 " bus-off; rest after %5.3f s, with loss %5.3f s, at least %5.3f s before the "
                "bound; two masters %5.3f s; %" PRIu64 " failed\n",
                name.c_str(), tally.runs, tally.with_loss, tally.frames, tally.collisions, tally.bus_offs,
                static_cast<double>(tally.longest) / kSecond, static_cast<double>(tally.longest_with_loss) / kSecond,
                static_cast<double>(tally.least_left) / kSecond, static_cast<double>(tally.longest_two) / kSecond,
                tally.failures);
    if (tally.failures > 0U)
    {
        std::printf("  first failure: %s\n", tally.first_failure.c_str());
    }
    std::fflush(stdout);
    return tally.failures;
}

/// Failovers: how much later than computed, in bins of 100 us.
void PrintHistogram(const Tally& tally)
{
    constexpr std::uint64_t kWidth = 50U;
    std::uint64_t greatest = 1U;
    for (const auto& [late, count] : tally.late_us)
    {
        greatest = std::max(greatest, count);
    }
    std::printf("  failover after the computed instant (heartbeat time + 1F90h:02 + 1F90h:01 + least waiting):\n");
    for (const auto& [late, count] : tally.late_us)
    {
        const std::string bar(static_cast<std::size_t>((count * kWidth) / greatest), '#');
        std::printf("  %5" PRId64 " us %6" PRIu64 " %s\n", late, count, bar.c_str());
    }
}

std::uint64_t RunSeeded(const Preset preset, const std::string& name, const Options& options, const Adapt& adapt)
{
    const Crowd crowd = options.up_to ? Crowd::kUpTo : Crowd::kExactly;
    constexpr std::uint32_t kChunk = 1000U;
    Tally tally{};
    const std::uint32_t runs = adapt ? std::max(1U, options.runs / kOwnClocksEach) : options.runs;
    for (std::uint32_t done = 0U; done < runs; done += kChunk)
    {
        const std::uint32_t count = std::min(kChunk, runs - done);
        tally.Add(Seeded(preset, options.seed, options.first + done, count, crowd, options.greatest, adapt));
        if (isatty(STDERR_FILENO) != 0)
        {
            std::fprintf(stderr, "\r%u of %u seeded runs", done + count, runs);
        }
    }
    return Print(name + ", seed " + std::to_string(options.seed) + (options.up_to ? ", up to " : ", ") +
                     std::to_string(options.greatest) + " masters" + (adapt ? ", own clocks" : ""),
                 tally);
}

std::string NameOf(const Preset preset)
{
    return (preset == Preset::kDefault) ? "default" : "so1114";
}

std::vector<FailoverSeries> FailoverSeriesOf(const Preset preset, const std::string& name)
{
    return {{name + ", failover", Failovers(preset)},
            {name + ", failover, drawn times", FailoversDrawn(preset, kDrawnFailovers)}};
}

std::uint64_t RunExhaustive(const Preset preset, const std::string& name, const bool whole)
{
    std::uint64_t failures = 0U;
    for (std::size_t count = 2U; count <= 4U; ++count)
    {
        const Losses losses = ((count < 4U) || whole) ? Losses::kForEachToo : Losses::kForAll;
        const Losses joined = ((count < 3U) || whole) ? Losses::kForEachToo : Losses::kForAll;
        const std::string masters = std::to_string(count) + " masters";
        failures +=
            Print(name + ", " + masters + ", all offsets", Combinations(preset, count, OffsetsOfTheText(), losses));
        failures += Print(name + ", " + masters + ", split and joined", Splits(preset, count, joined));
    }
    failures += Print(name + ", 2 masters, 10 ms steps", Combinations(preset, 2U, OffsetsInSlots(), Losses::kForAll));
    for (std::size_t count = 2U; count <= 3U; ++count)
    {
        const std::string masters = std::to_string(count) + " masters";
        failures += Print(name + ", " + masters + ", own clocks",
                          Combinations(preset, count, OffsetsOfTheText(), Losses::kForEachToo, GiveClocks));
        failures += Print(name + ", " + masters + ", node 127, 1, 126",
                          Combinations(preset, count, OffsetsOfTheText(), Losses::kForEachToo, GiveFarNodes));
    }
    failures += Print(name + ", variants", Variants(preset, Losses::kForAll));
    for (const FailoverSeries& series : FailoverSeriesOf(preset, name))
    {
        failures += Print(series.name, series.tally);
        PrintHistogram(series.tally);
    }
    return failures;
}

/// The failovers alone, recorded for the evidence.
int RecordFailovers(const Options& options)
{
    std::vector<FailoverSeries> all{};
    std::uint64_t failures = 0U;
    for (const Preset preset : {Preset::kDefault, Preset::kSo1114})
    {
        for (const FailoverSeries& series : FailoverSeriesOf(preset, NameOf(preset)))
        {
            failures += Print(series.name, series.tally);
            all.push_back(series);
        }
    }
    if (!WriteFailovers(options.failovers, all))
    {
        std::fprintf(stderr,
                     "counterpoint_elections: --failovers: cannot write '%s', expected a new or writable file\n",
                     options.failovers.c_str());
        return 2;
    }
    std::printf("failovers: %s\n", (failures == 0U) ? "each within one cycle of the computed time" : "FAILED");
    return (failures == 0U) ? 0 : 1;
}

int Run(const Options& options)
{
    std::uint64_t failures = 0U;
    for (const Preset preset : {Preset::kDefault, Preset::kSo1114})
    {
        const std::string name = NameOf(preset);
        if ((options.preset != name) && (options.preset != "both"))
        {
            continue;
        }
        failures += options.seeded_only ? 0U : RunExhaustive(preset, name, options.whole);
        failures += RunSeeded(preset, name, options, {});
        failures += RunSeeded(preset, name, options, GiveClocks);
    }
    std::printf("elections: %s\n", (failures == 0U) ? "every run ended in exactly one master" : "FAILED");
    return (failures == 0U) ? 0 : 1;
}

} // namespace
} // namespace counterpoint::elections

int main(int argc, char** argv)
{
    counterpoint::elections::Options options{};
    CLI::App app{"Elections of flying masters: all small cases, and seeded large ones"};
    app.add_option("--runs", options.runs, "Seeded runs of each preset")->check(CLI::Range(1U, 100'000'000U));
    app.add_option("--seed", options.seed, "Seed");
    app.add_option("--first", options.first, "Number of the first seeded run, to repeat one");
    app.add_option("--masters", options.greatest, "Number of masters in a seeded run")->check(CLI::Range(2U, 127U));
    app.add_flag("--up-to", options.up_to, "Seeded runs with 2 up to so many masters");
    app.add_option("--preset", options.preset, "default, so1114 or both")
        ->check(CLI::IsMember({"default", "so1114", "both"}));
    app.add_flag("--whole", options.whole, "3 and 4 masters with the loss of each frame for each receiver too");
    app.add_option("--failovers", options.failovers, "Failovers of both presets alone, recorded as JSON in this file");
    app.add_flag("--seeded-only", options.seeded_only, "No exhaustive series");
    try
    {
        app.parse(argc, argv);
    }
    catch (const CLI::ParseError& error)
    {
        const int status = app.exit(error);
        return (status == 0) ? 0 : 2;
    }
    return options.failovers.empty() ? counterpoint::elections::Run(options)
                                     : counterpoint::elections::RecordFailovers(options);
}
