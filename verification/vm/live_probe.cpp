// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// live_probe CHECK BUS...: one check of live buses on this machine's CAN stack. Run by verification/vm/checks.
#include "verification/vm/probe_checks.hpp"

#include <exception>
#include <iostream>
#include <map>

namespace
{

using Check = void (*)(const counterpoint::vm::Names& buses);

struct Row
{
    Check check;
    std::size_t bus_count;
};

std::map<std::string, Row> Checks()
{
    namespace vm = counterpoint::vm;
    return {
        {"exchange", {&vm::CheckExchange, 2U}},
        {"own", {&vm::CheckOwn, 1U}},
        {"filters", {&vm::CheckFilters, 1U}},
        {"lost-frames", {&vm::CheckLostFrames, 1U}},
        {"absent", {&vm::CheckAbsent, 2U}},
        {"error-frames", {&vm::CheckErrorFrames, 1U}},
        {"two-interfaces", {&vm::CheckTwoInterfaces, 2U}},
        {"down-and-up", {&vm::CheckDownAndUp, 1U}},
        {"remade", {&vm::CheckRemade, 1U}},
        {"full-queue", {&vm::CheckFullQueue, 1U}},
        {"manual-restart", {&vm::CheckManualRestart, 1U}},
        {"timed-restart", {&vm::CheckTimedRestart, 1U}},
        {"kernel-restart", {&vm::CheckKernelRestart, 1U}},
        {"restart-by-switch", {&vm::CheckRestartBySwitch, 1U}},
        {"states", {&vm::CheckStates, 1U}},
        {"unplugged", {&vm::CheckUnplugged, 1U}},
    };
}

} // namespace

int main(const int count, char** const arguments)
{
    const counterpoint::vm::Names all(arguments + 1, arguments + count);
    const std::map<std::string, Row> checks = Checks();
    const auto found = all.empty() ? checks.end() : checks.find(all.front());
    if ((found == checks.end()) || (all.size() != found->second.bus_count + 1U))
    {
        std::cerr << "live_probe: expected a check and its buses, one of:";
        for (const auto& [name, row] : checks)
        {
            std::cerr << ' ' << name << '/' << row.bus_count;
        }
        std::cerr << '\n';
        return 2;
    }
    try
    {
        found->second.check(counterpoint::vm::Names(all.begin() + 1, all.end()));
    }
    catch (const std::exception& problem)
    {
        std::cerr << all.front() << ": " << problem.what() << '\n';
        return 1;
    }
    return 0;
}
