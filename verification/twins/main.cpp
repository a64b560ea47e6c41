// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Drives the channel of one library alone and prints what it showed as one number behind each count of sequences.
// Started once for each mutant by twins.py, so that one that crashes or never ends takes nobody with it.
#include "verification/differential/differential.hpp"
#include "verification/twins/broken.hpp"
#include "verification/twins/listener.hpp"
#include "verification/twins/subject.hpp"
#include "verification/twins/unit.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <dlfcn.h>
#include <memory>
#include <string>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

// What a library with many mutants asks: the one that is active. [schemata.py]
extern "C" unsigned counterpoint_mutant;
unsigned counterpoint_mutant = 0U;
bool CounterpointWhileCompiling();
bool CounterpointWhileCompiling()
{
    return false;
}

namespace counterpoint::twins
{
namespace
{

struct Options
{
    std::string library{};
    std::string side{"a"};
    std::uint32_t seed{1U};
    std::vector<std::uint32_t> counts{3000U};
    std::int64_t rule{-1};
    std::uint32_t milliseconds{60000U};
    std::vector<std::uint32_t> mutants{};
    std::vector<std::uint32_t> without{};
    bool list{false};
    bool unit{false};
    bool each{false};
};

class Silent final : public differential::Observer
{
  public:
    void OnStep(const differential::StepRecord& /*record*/) noexcept override
    {
    }
    void OnDifference(const differential::Difference& /*difference*/) noexcept override
    {
    }
};

int ListRules(bool is_unit)
{
    std::uint32_t number = 0U;
    for (const UnitRule& rule : UnitRules())
    {
        if (is_unit)
        {
            std::printf("%u\tSRS_CFG_010\t%s\n", number, rule.how.c_str());
            ++number;
        }
    }
    if (is_unit)
    {
        return 0;
    }
    for (const Rule& rule : Rules())
    {
        std::printf("%u\t%s\t%s\n", number, rule.requirement, rule.how.c_str());
        ++number;
    }
    return 0;
}

int Drive(Channel& channel, const Options& options)
{
    const Side side = (options.side == "a") ? Side::kNormal : Side::kInverse;
    Trace trace;
    Answers answers;
    Silent silent;
    static const Rule kNoRule{};
    Broken broken{channel, (options.rule < 0) ? kNoRule : Rules().at(static_cast<std::size_t>(options.rule))};
    const auto first = std::make_unique<First>(broken, side, answers, trace);
    Second second{broken, side, answers};
    const auto run = std::make_unique<differential::Differential>(*first, second, silent);
    run->DriveOneAlone();
    first->LookAt(run->Driven());
    std::uint32_t number = 0U;
    for (const std::uint32_t count : options.counts)
    {
        for (; number < count; ++number)
        {
            if (std::binary_search(options.without.begin(), options.without.end(), number))
            {
                continue;
            }
            static_cast<void>(run->RunSequence(options.seed, number));
            if (options.each)
            {
                std::printf("%u %016" PRIX64 "\n", number, trace.Value());
                trace = Trace{};
            }
        }
        std::printf("%016" PRIX64 "\n", trace.Value());
    }
    return 0;
}

int DriveLibrary(const Options& options)
{
    // A mutant that never ends is stopped by its own processor time: a busy machine makes others wait, and that is no
    // verdict.
    const auto seconds = static_cast<time_t>(options.milliseconds / 1000U);
    const auto rest_us = static_cast<suseconds_t>((options.milliseconds % 1000U) * 1000U);
    const itimerval limit{{0, 0}, {seconds, rest_us}};
    static_cast<void>(setitimer(ITIMER_PROF, &limit, nullptr));
    void* const library = dlopen(options.library.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr)
    {
        std::fprintf(stderr, "%s\n", dlerror());
        return 2;
    }
    void* const entry = dlsym(library, options.unit ? "CounterpointSignature" : "CounterpointSubject");
    if (entry == nullptr)
    {
        std::fprintf(stderr, "%s: nothing to drive\n", options.library.c_str());
        return 2;
    }
    if (options.unit)
    {
        const std::vector<UnitRule> rules = UnitRules();
        const UnitRule* const rule = (options.rule < 0) ? nullptr : &rules.at(static_cast<std::size_t>(options.rule));
        for (const std::uint32_t count : options.counts)
        {
            std::printf("%016" PRIX64 "\n", DriveUnit(reinterpret_cast<decltype(&CounterpointSignature)>(entry),
                                                      options.seed, count, rule));
        }
        return 0;
    }
    const auto make = reinterpret_cast<decltype(&CounterpointSubject)>(entry);
    return Drive(*make(), options);
}

/// In a process of its own: what it printed, or nothing if it did not end well.
std::string DriveApart(std::uint32_t mutant, const Options& options)
{
    int ends[2];
    if (pipe(ends) != 0)
    {
        return "";
    }
    const pid_t child = fork();
    if (child == 0)
    {
        counterpoint_mutant = mutant;
        static_cast<void>(dup2(ends[1], STDOUT_FILENO));
        static_cast<void>(close(ends[0]));
        static_cast<void>(close(ends[1]));
        const int status = DriveLibrary(options);
        static_cast<void>(std::fflush(stdout));
        _exit(status);
    }
    static_cast<void>(close(ends[1]));
    std::string said;
    char part[64];
    for (ssize_t count = read(ends[0], part, sizeof(part)); count > 0; count = read(ends[0], part, sizeof(part)))
    {
        said.append(part, static_cast<std::size_t>(count));
    }
    static_cast<void>(close(ends[0]));
    int status = 0;
    static_cast<void>(waitpid(child, &status, 0));
    const bool is_good = WIFEXITED(status) && (WEXITSTATUS(status) == 0);
    return is_good ? said.substr(0U, said.find('\n')) : "";
}

int Main(int argc, char** argv)
{
    Options options;
    CLI::App app{"Drives one channel alone and prints what it showed, as one number."};
    app.add_option("--library", options.library, "library with CounterpointSubject()");
    app.add_option("--side", options.side, "objects of the channel")->check(CLI::IsMember({"a", "b"}));
    app.add_option("--seed", options.seed, "seed of all sequences");
    app.add_option("--sequences", options.counts,
                   "a number is printed behind each of these counts, in ascending order");
    app.add_option("--without", options.without, "sequences that are left out, in ascending order");
    app.add_option("--rule", options.rule, "break this rule in front of the channel");
    app.add_option("--mutants", options.mutants, "numbers of mutants of a library that holds many, each run by itself");
    app.add_option("--milliseconds", options.milliseconds, "processor time of a run at most");
    app.add_flag("--unit", options.unit, "the library has CounterpointSignature() alone");
    app.add_flag("--list-rules", options.list, "print all rules that can be broken");
    app.add_flag("--each", options.each, "a number for each sequence");
    CLI11_PARSE(app, argc, argv);
    if (options.list)
    {
        return ListRules(options.unit);
    }
    for (const std::uint32_t mutant : options.mutants)
    {
        const std::string said = DriveApart(mutant, options);
        std::printf("%u %s\n", mutant, said.empty() ? "stopped" : said.c_str());
        static_cast<void>(std::fflush(stdout));
    }
    return options.mutants.empty() ? DriveLibrary(options) : 0;
}

} // namespace
} // namespace counterpoint::twins

int main(int argc, char** argv)
{
    return counterpoint::twins::Main(argc, argv);
}
