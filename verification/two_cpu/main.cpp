// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Two CPUs in one process: --runs breaks something at a random moment and judges each run against its limit; --seconds
// lets them run undisturbed. Exit status: 0 it holds, 1 it does not, 2 bad input.
#include "verification/two_cpu/campaign.hpp"

#include <CLI/CLI.hpp>

#include <cinttypes>
#include <cstdio>
#include <exception>

namespace
{
using namespace counterpoint;

void Print(const two_cpu::CampaignResult& result)
{
    for (std::size_t kind = 0U; kind < two_cpu::kBreakages; ++kind)
    {
        const two_cpu::Score& score = result.scores[kind];
        const std::uint32_t judged = score.runs - score.not_open;
        std::printf("%-22s runs=%" PRIu32 " late=%" PRIu32 " not_open=%" PRIu32
                    " limit=%.1f ms longest=%.1f ms mean=%.1f ms\n",
                    two_cpu::NameOf(static_cast<two_cpu::Breakage>(kind)), score.runs, score.late, score.not_open,
                    score.limit_us / 1000.0, score.longest_us / 1000.0,
                    (judged == 0U) ? 0.0 : (score.sum_us / judged / 1000.0));
    }
    if (result.first_bad_seed != 0U)
    {
        std::printf("first bad run: seed %" PRIu64 "\n", result.first_bad_seed);
    }
}

void Print(const two_cpu::SoakResult& result)
{
    for (std::size_t cpu = 0U; cpu < 2U; ++cpu)
    {
        const LinkCounts& counts = result.counts[cpu];
        std::printf("cpu %c device_fault=%u taken=%" PRIu32 " lost=%" PRIu32 " repeated=%" PRIu32 " old=%" PRIu32
                    " late=%" PRIu32 " corrupt=%" PRIu32 " released=%" PRIu64 " sent=%" PRIu64
                    " consumer_errors=%" PRIu64 " producer_errors=%" PRIu64 " demotions=%u\n",
                    (cpu == 0U) ? 'A' : 'B', static_cast<unsigned>(result.faults[cpu].fault), counts.taken, counts.lost,
                    counts.repeated, counts.old, counts.late, counts.corrupt, result.released[cpu], result.sent[cpu],
                    result.consumer_errors[cpu], result.producer_errors[cpu],
                    static_cast<unsigned>(result.demotions[cpu]));
    }
    std::printf("pairs_heard=%" PRIu64 " pairs_bad=%" PRIu64 " sensor_faults=%" PRIu64 " output=%s\n",
                result.pairs_heard, result.pairs_bad, result.sensor_faults, result.is_open ? "open" : "closed");
}
} // namespace

int main(int argc, char** argv)
{
    CLI::App app{"Two CPUs over a cross link: random losses against the computed limits, and undisturbed running"};
    std::uint32_t runs = 0U;
    std::uint32_t seconds = 0U;
    std::uint32_t sensor_faults_ppm = 0U;
    std::uint64_t seed = 1U;
    app.add_option("--runs", runs, "Runs in which something breaks, nine kinds in turn");
    app.add_option("--seconds", seconds, "Simulated seconds of undisturbed running")
        ->check(CLI::Range(0U, 10'000'000U));
    app.add_option("--sensor-faults-ppm", sensor_faults_ppm, "Pairs in a million that the sensor gets wrong meanwhile")
        ->check(CLI::Range(0U, 1'000'000U));
    app.add_option("--seed", seed, "The same numbers give the same runs");
    try
    {
        app.parse(argc, argv);
        if ((runs == 0U) && (seconds < 2U))
        {
            std::fprintf(stderr, "two_cpu: nothing to do, expected --runs N or --seconds N with N >= 2\n");
            return 2;
        }
        bool holds = true;
        if (runs != 0U)
        {
            const two_cpu::CampaignResult result = two_cpu::RunCampaign(runs, seed);
            Print(result);
            holds = holds && result.Holds();
            std::printf("campaign runs=%" PRIu32 " seed=%" PRIu64 ": %s\n", runs, seed,
                        result.Holds() ? "pass" : "FAIL");
        }
        if (seconds != 0U)
        {
            const two_cpu::SoakResult result = two_cpu::RunSoak(seconds, seed, sensor_faults_ppm);
            Print(result);
            holds = holds && result.Holds();
            std::printf("undisturbed seconds=%" PRIu32 " seed=%" PRIu64 ": %s\n", seconds, seed,
                        result.Holds() ? "pass" : "FAIL");
        }
        return holds ? 0 : 1;
    }
    catch (const CLI::ParseError& error)
    {
        const int status = app.exit(error);
        return (status == 0) ? 0 : 2;
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
