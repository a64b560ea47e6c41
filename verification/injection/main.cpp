// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// One shard of a campaign. run.py starts it, and says what its lines mean.
#include "verification/injection/campaign.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <string>

namespace
{

using namespace counterpoint::injection;

const char* NameOfFault(const FaultKind kind)
{
    constexpr const char* kNames[] = {"none", "skip", "invert", "register", "memory"};
    return kNames[static_cast<std::size_t>(kind)];
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

void PrintGolden(const Campaign& campaign, const std::vector<ScriptStep>& script)
{
    for (std::size_t step = 0U; step < script.size(); ++step)
    {
        PrintSeen("golden", step, script[step].scene, campaign.Golden()[step]);
    }
}

// The step of this scene.
std::uint32_t StepOf(const std::vector<ScriptStep>& script, const std::string& scene)
{
    std::uint32_t step = 0U;
    while ((step < script.size()) && (script[step].scene != scene))
    {
        ++step;
    }
    return step;
}

/// Faults that nobody can see: they must be told as silent. [SRS_VER_042]
bool RunControls(Campaign& campaign, const std::vector<ScriptStep>& script)
{
    const auto no_mail = [](Mailbox&, std::uint32_t) {};
    const auto no_memory = [](Machine&, std::uint32_t) {};
    const auto forged = [](Mailbox& mail, const std::uint32_t step)
    {
        if (step == 0U)
        {
            mail.frame_count = 0U;
            AddPair(mail, 0U, 0x0BADF00DU);
        }
    };
    const auto changed = [](Machine& machine, std::uint32_t)
    { machine.WriteObjects(0U, ObjectPair{0x0BADF00DU, ~0x0BADF00DU}); };
    const auto acknowledged = [](Mailbox& mail, const std::uint32_t step)
    {
        mail.acknowledge_a |= (step < 3U) ? 1U : 0U;
        mail.acknowledge_b |= (step < 3U) ? 1U : 0U;
    };
    const Experiment skipped =
        campaign.SkippedCall(StepOf(script, "GFC"), "_ZN12counterpoint6Kernel7OnFrameERKNS_12StampedFrameE");
    const std::uint32_t pair = StepOf(script, "pair");
    const std::uint32_t expiry = StepOf(script, "SCT expiry, pair without acknowledge") - 1U;
    const Verdict verdicts[] = {campaign.RunControl(pair, forged, no_memory),
                                campaign.RunControl(pair, no_mail, changed),
                                campaign.RunControl(expiry, acknowledged, no_memory), campaign.Run(skipped),
                                campaign.RunControl(pair, no_mail, no_memory)};
    constexpr const char* kNames[] = {"forged pair", "both variables changed", "foreign acknowledge",
                                      "GFC that is not handed over", "nothing"};
    bool is_good = true;
    for (std::size_t i = 0U; i < 5U; ++i)
    {
        const bool is_silent = verdicts[i].kind == Class::kSilent;
        std::printf("control\t%s\t%s\t%s\n", kNames[i], NameOf(verdicts[i].kind), verdicts[i].what.c_str());
        is_good = is_good && (is_silent == (i != 4U));
    }
    return is_good;
}

void RunAll(Campaign& campaign, const std::vector<ScriptStep>& script, const std::vector<Experiment>& experiments)
{
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    std::map<std::string, std::uint64_t> counts;
    std::uint64_t done = 0U;
    for (const Experiment& experiment : experiments)
    {
        const Verdict verdict = campaign.Run(experiment);
        const std::string kind = NameOfFault(experiment.fault.kind);
        ++counts[kind + "\t" + NameOf(verdict.kind) + "\t" + verdict.what + "\t" + std::to_string(verdict.steps)];
        if (verdict.kind == Class::kSilent)
        {
            std::printf("silent\t%s\t%u\t%s\t%u\t%u\t%u\t%s\t%u\n", kind.c_str(), experiment.step,
                        script[experiment.step].scene.c_str(), experiment.fault.address, experiment.fault.count,
                        experiment.fault.number, verdict.what.c_str(), verdict.steps);
            std::fflush(stdout);
        }
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
    std::printf("control\tnothing, behind all faults\t%s\t%s\n", NameOf(clean.kind), clean.what.c_str());
    for (const auto& [name, count] : counts)
    {
        std::printf("count\t%s\t%llu\n", name.c_str(), static_cast<unsigned long long>(count));
    }
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    std::printf("end\t%llu\t%.1f\n", static_cast<unsigned long long>(done), seconds);
}

std::uint32_t NumberOf(const char* const text)
{
    return static_cast<std::uint32_t>(std::strtoul(text, nullptr, 0));
}

/// Each step of the run with one fault, and its verdict.
void ShowOne(Campaign& campaign, const std::vector<ScriptStep>& script, char** const arguments)
{
    Experiment experiment{};
    experiment.step = NumberOf(arguments[0]);
    std::uint32_t kind = 1U;
    while ((kind < 4U) && (arguments[1] != std::string{NameOfFault(static_cast<FaultKind>(kind))}))
    {
        ++kind;
    }
    experiment.fault = {static_cast<FaultKind>(kind), NumberOf(arguments[2]), NumberOf(arguments[3]),
                        NumberOf(arguments[4])};
    const Verdict verdict = campaign.Run(experiment, [&script](const std::size_t step, const Seen& seen)
                                         { PrintSeen("step", step, script[step].scene, seen); });
    std::printf("verdict\t%s\t%s\t%u\n", NameOf(verdict.kind), verdict.what.c_str(), verdict.steps);
}

} // namespace

int main(int count, char** arguments)
{
    if ((count != 11) && (count != 16))
    {
        std::fprintf(stderr, "counterpoint_injector IMAGE DESCRIPTION CODE REGISTERS MEMORY SEED SHARD SHARDS EACH "
                             "SAMPLE [STEP FAULT INSTRUCTION ADDRESS NUMBER]\n"
                             "CODE: 1 skips, 2 inversions, 3 both. run.py builds what it needs and starts it.\n");
        return 2;
    }
    try
    {
        const Program program{arguments[1], arguments[2]};
        const std::vector<ScriptStep> script = MakeScript();
        Machine machine{program};
        Campaign campaign{machine, program, script};
        const std::uint32_t code = NumberOf(arguments[3]);
        Plan plan{};
        plan.skips = (code & 1U) != 0U;
        plan.inversions = (code & 2U) != 0U;
        plan.registers = NumberOf(arguments[4]);
        plan.memory = NumberOf(arguments[5]);
        plan.seed = NumberOf(arguments[6]);
        plan.shard = NumberOf(arguments[7]);
        plan.shards = NumberOf(arguments[8]);
        plan.each = NumberOf(arguments[9]);
        plan.sample = NumberOf(arguments[10]);
        PrintGolden(campaign, script);
        if (count == 16)
        {
            ShowOne(campaign, script, &arguments[11]);
            return 0;
        }
        if (!RunControls(campaign, script))
        {
            return 1;
        }
        const std::vector<Experiment> experiments = campaign.Draw(plan);
        std::printf("drawn\t%zu\t%llu\n", experiments.size(), static_cast<unsigned long long>(campaign.Instructions()));
        RunAll(campaign, script, experiments);
    }
    catch (const std::exception& problem)
    {
        std::fprintf(stderr, "counterpoint_injector: %s\n", problem.what());
        return 2;
    }
    return 0;
}
