// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// One shard of a campaign. run.py starts it, and says what its lines mean.
#include "verification/injection/campaign.hpp"
#include "verification/injection/controls.hpp"
#include "verification/injection/space.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <map>
#include <string>

namespace
{

using namespace counterpoint::injection;

constexpr const char* kFaults[] = {"none", "skip", "invert", "register", "opcode", "memory", "stuck", "flash"};

constexpr std::uint64_t kEachAnew = 1000U;

using Options = std::map<std::string, std::string>;

const char* NameOfFault(const FaultKind kind)
{
    return kFaults[static_cast<std::size_t>(kind)];
}

void PrintSeen(const char* const name, const std::size_t step, const std::string& scene, const Seen& seen)
{
    std::printf("%s\t%zu\t%s\tpins=%x\tfault=%x\tobjects=%08x %08x %08x %08x\tsent=%zu", name, step, scene.c_str(),
                seen.pins, seen.device_fault, seen.objects[0].normal, seen.objects[0].inverse, seen.objects[1].normal,
                seen.objects[1].inverse, seen.sent.size());
    for (const std::uint32_t event : seen.events)
    {
        std::printf(" %x", event);
    }
    std::printf("\n");
}

// The undisturbed run, and each address of code that it executes.
void PrintGolden(const Campaign& campaign, const std::vector<ScriptStep>& script)
{
    std::map<std::uint32_t, std::uint64_t> executed;
    for (std::size_t step = 0U; step < script.size(); ++step)
    {
        PrintSeen("golden", step, script[step].scene, campaign.Golden()[step]);
        for (const std::uint32_t address : campaign.Traces()[step])
        {
            ++executed[address];
        }
    }
    for (const auto& [address, count] : executed)
    {
        std::printf("executed\t%u\t%llu\n", address, static_cast<unsigned long long>(count));
    }
}

bool PrintControls(const std::vector<Control>& controls)
{
    bool is_good = true;
    for (const Control& control : controls)
    {
        std::printf("control\t%s\t%s\t%s\t%s\n", control.name.c_str(), NameOf(control.told.kind),
                    control.told.what.c_str(), control.IsGood() ? "told" : "NOT TOLD");
        is_good = is_good && control.IsGood();
    }
    return is_good;
}

bool AreEqual(const Verdict& first, const Verdict& second)
{
    return (first.kind == second.kind) && (first.what == second.what) && (first.steps == second.steps);
}

/// What is known of the first run of each thousand, otherwise by a step where run.py asks whether that is told.
/// [SRS_VER_347]
bool IsOtherAnew(Campaign& campaign, const Experiment& experiment, const Verdict& verdict, const bool is_mistaken)
{
    Verdict known = verdict;
    known.steps += is_mistaken ? 1U : 0U;
    return !AreEqual(known, campaign.RunAnew(experiment));
}

void RunAll(Campaign& campaign, const std::vector<ScriptStep>& script, const std::vector<Drawn>& experiments,
            const bool is_mistaken)
{
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    std::uint64_t done = 0U;
    std::uint64_t different = 0U;
    for (const Drawn& drawn : experiments)
    {
        const Experiment& experiment = drawn.experiment;
        const Verdict verdict = campaign.Run(experiment);
        std::printf("row\t%zu\t%s\t%u\t%s\t%u\t%u\t%u\t%s\t%s\t%u\n", drawn.number, NameOfFault(experiment.fault.kind),
                    experiment.step, script[experiment.step].scene.c_str(), experiment.fault.count,
                    experiment.fault.address, experiment.fault.number, NameOf(verdict.kind), verdict.what.c_str(),
                    verdict.steps);
        const bool is_anew = (done % kEachAnew) == 0U;
        different += (is_anew && IsOtherAnew(campaign, experiment, verdict, is_mistaken)) ? 1U : 0U;
        ++done;
        if ((done % 2000U) == 0U)
        {
            const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
            std::fprintf(stderr, "progress\t%llu\t%zu\t%.0f\n", static_cast<unsigned long long>(done),
                         experiments.size(), static_cast<double>(done) / seconds);
        }
    }
    // What a fault left behind in the emulator would be told as detection of the next ones.
    const Verdict clean = campaign.Run(Experiment{0U, Fault{}});
    std::printf("control\tnothing, behind all faults\t%s\t%s\t%s\n", NameOf(clean.kind), clean.what.c_str(),
                (clean.kind == Class::kMasked) ? "told" : "NOT TOLD");
    std::printf("control\teach %lluth run anew\t%llu differ\t\t%s\n", static_cast<unsigned long long>(kEachAnew),
                static_cast<unsigned long long>(different), (different == 0U) ? "told" : "NOT TOLD");
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    std::printf("end\t%llu\t%.1f\t%.1f\n", static_cast<unsigned long long>(done), seconds,
                static_cast<double>(std::clock()) / CLOCKS_PER_SEC);
}

std::uint32_t NumberOf(const std::string& text)
{
    return static_cast<std::uint32_t>(std::strtoul(text.c_str(), nullptr, 0));
}

Options OptionsOf(const int count, char** const arguments)
{
    Options options{};
    for (int i = 3; i < count; ++i)
    {
        const std::string text{arguments[i]};
        const std::size_t sign = text.find('=');
        options[text.substr(0U, sign)] = (sign == std::string::npos) ? "" : text.substr(sign + 1U);
    }
    return options;
}

Plan PlanOf(Options& options)
{
    Plan plan{};
    const std::uint32_t code = NumberOf(options["code"]);
    plan.skips = (code & 1U) != 0U;
    plan.inversions = (code & 2U) != 0U;
    plan.each = NumberOf(options["each"]);
    plan.sample = NumberOf(options["sample"]);
    plan.registers = NumberOf(options["registers"]);
    plan.opcodes = NumberOf(options["opcodes"]);
    plan.flash = NumberOf(options["flash"]);
    plan.memory = NumberOf(options["memory"]);
    plan.stuck = NumberOf(options["stuck"]);
    plan.first = NumberOf(options["first"]);
    plan.last = (options.count("last") == 0U) ? plan.last : NumberOf(options["last"]);
    plan.seed = NumberOf(options["seed"]);
    plan.shard = NumberOf(options["shard"]);
    plan.shards = NumberOf(options["shards"]);
    return plan;
}

/// One scene that shows an event that there is not, where run.py asks whether that is found.
void Misname(std::vector<ScriptStep>& script, Options& options)
{
    if (options.count("misnamed") != 0U)
    {
        script.at(NumberOf(options["misnamed"])).shown.event = 0xFFFFFFFFU;
    }
}

/// Each step of the run with one fault, and its verdict.
void ShowOne(Campaign& campaign, const std::vector<ScriptStep>& script, Options& options)
{
    std::uint32_t kind = 1U;
    while ((kind < 7U) && (options["fault"] != kFaults[kind]))
    {
        ++kind;
    }
    const Experiment experiment{NumberOf(options["step"]),
                                {static_cast<FaultKind>(kind), NumberOf(options["instruction"]),
                                 NumberOf(options["address"]), NumberOf(options["number"])}};
    const Verdict verdict = campaign.Show(experiment, [&script](const std::size_t step, const Seen& seen)
                                          { PrintSeen("step", step, script[step].scene, seen); });
    std::printf("verdict\t%s\t%s\t%u\n", NameOf(verdict.kind), verdict.what.c_str(), verdict.steps);
}

} // namespace

int main(int count, char** arguments)
{
    if (count < 4)
    {
        std::fprintf(stderr,
                     "counterpoint_injector IMAGE DESCRIPTION KEY=NUMBER...\n"
                     "code (1 skips, 2 inversions, 3 both), each, sample, registers, opcodes, flash, memory, "
                     "stuck, seed, first, last, shard, shards, misnamed, mistaken;\none run: step, fault, instruction, "
                     "address, number. run.py "
                     "builds what it needs and starts it.\n");
        return 2;
    }
    try
    {
        const Program program{arguments[1], arguments[2]};
        Options options = OptionsOf(count, arguments);
        std::vector<ScriptStep> script = MakeScript();
        Misname(script, options);
        Machine machine{program};
        Campaign campaign{machine, program, script};
        const Space space{program, campaign.Traces()};
        PrintGolden(campaign, script);
        if (options.count("fault") != 0U)
        {
            ShowOne(campaign, script, options);
            return 0;
        }
        if (!PrintControls(RunControls(campaign, space, script)))
        {
            return 1;
        }
        std::size_t all = 0U;
        const std::vector<Drawn> experiments = space.Draw(PlanOf(options), all);
        std::printf("drawn\t%zu\n", all);
        RunAll(campaign, script, experiments, options.count("mistaken") != 0U);
    }
    catch (const std::exception& problem)
    {
        std::fprintf(stderr, "counterpoint_injector: %s\n", problem.what());
        return 2;
    }
    return 0;
}
