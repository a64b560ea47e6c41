// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The differential run on the host: channel A and channel B of the product against each other.
#include "channel_a/channel.hpp"
#include "channel_b/channel.hpp"
#include "verification/differential/differential.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cinttypes>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <memory>
#include <string>
#include <unistd.h>

namespace counterpoint::differential
{
namespace
{

/// Prints what it hears.
class Printer final : public Observer
{
  public:
    void OnStep(const StepRecord& record) noexcept override
    {
        std::printf("  %4u  slot %3d  %s: 0x%" PRIX64 ", 0x%" PRIX64 ", 0x%" PRIX64 "\n", record.step,
                    (record.slot == kNoSlot) ? -1 : static_cast<int>(record.slot), record.name, record.x, record.y,
                    record.z);
    }

    void OnDifference(const Difference& difference) noexcept override
    {
        std::printf("difference: seed %u, sequence %u, step %u, slot %d: %s: A 0x%" PRIX64 ", B 0x%" PRIX64 "\n",
                    difference.seed, difference.sequence, difference.step,
                    (difference.slot == kNoSlot) ? -1 : static_cast<int>(difference.slot), difference.field,
                    difference.a, difference.b);
        last = difference;
    }

    Difference last{};
};

struct Options
{
    std::uint32_t sequences{100000U};
    std::uint32_t seed{1U};
    std::uint32_t first{0U};
    std::string json{};
    bool steps{false};
};

constexpr std::uint32_t kChunk = 2000U;
constexpr int kBarWidth = 40;

/// Only on a terminal, so that a log stays readable.
void ShowProgress(std::uint32_t done, std::uint32_t all)
{
    if (isatty(STDERR_FILENO) == 0)
    {
        return;
    }
    const int filled = static_cast<int>((static_cast<std::uint64_t>(done) * kBarWidth) / all);
    std::fprintf(stderr, "\r[%-*.*s] %u of %u sequences", kBarWidth, filled, "########################################",
                 done, all);
    if (done == all)
    {
        std::fputc('\n', stderr);
    }
    std::fflush(stderr);
}

void PrintSteps(Differential& run, const Printer& printer)
{
    std::printf("steps of sequence %u of seed %u:\n", printer.last.sequence, printer.last.seed);
    run.Tell(true);
    static_cast<void>(run.RunSequence(printer.last.seed, printer.last.sequence));
    run.Tell(false);
}

DifferentialResult RunAll(Differential& run, Printer& printer, const Options& options)
{
    std::uint32_t done = 0U;
    while ((done < options.sequences) && (run.Result().failures == 0U))
    {
        const std::uint32_t chunk = ((options.sequences - done) < kChunk) ? (options.sequences - done) : kChunk;
        static_cast<void>(RunDifferential(run, options.seed, options.first + done, chunk, 1U));
        done += chunk;
        ShowProgress(done, options.sequences);
    }
    const DifferentialResult result = run.Result();
    if (result.failures != 0U)
    {
        PrintSteps(run, printer);
    }
    return result;
}

void WriteJson(const Options& options, const DifferentialResult& result, const Reached& reached)
{
    nlohmann::ordered_json counts;
    for (std::uint8_t i = 0U; i < kItemCount; ++i)
    {
        counts[NameOf(static_cast<Item>(i))] = reached.Count(static_cast<Item>(i));
    }
    const nlohmann::ordered_json document = {
        {"seed", options.seed},
        {"first", options.first},
        {"sequences", result.sequences},
        {"steps", result.steps},
        {"differences", result.failures},
        {"hash", result.hash},
        {"missing", reached.Missing()},
        {"reached", counts},
        {"pass", (result.failures == 0U) && (reached.Missing() == 0U)},
    };
    std::ofstream file(options.json);
    file << document.dump(2) << '\n';
    if (!file)
    {
        std::fprintf(stderr, "%s: cannot be written, expected a file in an existing folder\n", options.json.c_str());
        std::exit(2);
    }
}

int Report(const DifferentialResult& result, const Reached& reached)
{
    for (std::uint8_t i = 0U; i < kItemCount; ++i)
    {
        const Item item = static_cast<Item>(i);
        std::printf("%-32s %12" PRIu64 "%s\n", NameOf(item), reached.Count(item),
                    (reached.Count(item) == 0U) ? "  never reached" : "");
    }
    const bool passes = (result.failures == 0U) && (reached.Missing() == 0U);
    std::printf("run=differential sequences=%u steps=%" PRIu64 " differences=%u missing=%u hash=%08x: %s\n",
                result.sequences, result.steps, result.failures, reached.Missing(), result.hash,
                passes ? "pass" : "FAIL");
    return passes ? 0 : 1;
}

int Main(const Options& options)
{
    const auto storage_a = std::make_unique<channel_a::StorageFor<kMaxSrdoCount, kMaxMapEntries>>();
    const auto storage_b = std::make_unique<channel_b::StorageFor<kMaxSrdoCount, kMaxMapEntries>>();
    channel_a::Channel a{storage_a->Handle()};
    channel_b::Channel b{storage_b->Handle()};
    Printer printer;
    const auto run = std::make_unique<Differential>(a, b, printer);
    if (options.steps)
    {
        run->Tell(true);
        static_cast<void>(run->RunSequence(options.seed, options.first));
        return (run->Result().failures == 0U) ? 0 : 1;
    }
    const DifferentialResult result = RunAll(*run, printer, options);
    if (!options.json.empty())
    {
        WriteJson(options, result, run->Seen());
    }
    return Report(result, run->Seen());
}

} // namespace
} // namespace counterpoint::differential

int main(int argc, char** argv)
{
    counterpoint::differential::Options options;
    CLI::App app{
        "Feeds random devices and sequences to both channels and compares them after every step. Exit status 0: no "
        "difference and everything reached; 1: otherwise; 2: bad arguments."};
    app.add_option("--sequences", options.sequences, "Number of sequences")
        ->check(CLI::Range(1U, 100000000U))
        ->capture_default_str();
    app.add_option("--seed", options.seed, "Seed of the run")->capture_default_str();
    app.add_option("--first", options.first, "Number of the first sequence")->capture_default_str();
    app.add_option("--json", options.json, "Writes result and counts to this file");
    app.add_flag("--steps", options.steps, "Only prints and runs the steps of the sequence --first");
    try
    {
        app.parse(argc, argv);
    }
    catch (const CLI::ParseError& error)
    {
        const int status = app.exit(error);
        return (status == 0) ? 0 : 2;
    }
    return counterpoint::differential::Main(options);
}
