// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/integration/scenario_run.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace counterpoint::simulator
{
namespace
{
std::string Refusal(const std::string& file)
{
    try
    {
        const simulator::Run run(file, std::nullopt, std::nullopt, false);
    }
    catch (const YamlError& error)
    {
        return error.what();
    }
    return "";
}

TEST(ImpossibleFault, IsRefusedAtTheValueThatCannotBe)
{
    Verifies(req::SRS_SIM_014);
    Verifies(req::SRS_SIM_012);
    struct Case
    {
        const char* fault;
        const char* message; ///< Its beginning, with line and column.
    };
    for (const Case& impossible : {
             Case{"insertion, at: 1 s, identifier: 1, times: 1000, every: 10000000 s",
                  "3:68: '10000000 s', expected a time that fits 1000 times into 10000000 s"},
             Case{"insertion, at: 1 s, identifier: 1, times: 2, every: 0 s", "3:65: '0 s', expected a time above 0"},
             Case{"repetition, frames: {identifier: 0x103}, times: 16", "3:61: '16', expected a number from 1 to 15"},
             Case{"delay, frames: {identifier: 0x103}, by: 0 ms", "3:53: '0 ms', expected a time above 0"},
             Case{"cycle, node: actuator, late: 0 s, at: 5 ms", "3:42: '0 s', expected a time above 0"},
             Case{"cycle, node: actuator, late: 1 ms, at: 5 ms, count: 5", "3:58: unknown key 'count' in a fault"},
             Case{"clock, node: actuator, counter: a, stopped: maybe, at: 5 ms",
                  "3:57: 'maybe', expected one of true, false"},
             Case{"not_inverse, node: controller, object: 0x2000:01, bits: [], at: 5 ms", "3:69: an empty list"},
         })
    {
        // Given a fault with one value that the simulator could not do as it is written
        const std::string file =
            TextFile("extends: " + Examples() + "chain.yaml\nfaults:\n  - {fault: " + impossible.fault + "}\n");
        // When it is read, then the line names the value
        const std::string refusal = Refusal(file);
        EXPECT_EQ(refusal.rfind(file + ":" + impossible.message, 0U), 0U) << refusal;
    }
}

TEST(ImpossibleFault, NodeIsNotCalledBus)
{
    Verifies(req::SRS_SIM_014);
    const std::string file = TextFile("duration: 1 s\nnodes:\n  bus: {dcf: sensor.dcf}\n");
    EXPECT_EQ(Refusal(file), file + ":3:3: node name 'bus', expected a name other than 'all' and 'bus'");
}

TEST(ScenarioFileName, IsShownInOnePrintableLineWithTheReason)
{
    Verifies(req::SRS_SIM_010);
    EXPECT_EQ(Refusal("no\nsuch\x1B.yaml"), "no\\x0Asuch\\x1B.yaml: no such file, expected a scenario");
    const std::string loop = ::testing::TempDir() + "counterpoint_loop.yaml";
    std::filesystem::remove(loop);
    std::filesystem::create_symlink(loop, loop);
    EXPECT_EQ(Refusal(loop), loop + ": cannot be opened (Too many levels of symbolic links), expected a readable file");
    std::filesystem::remove(loop);
}

TEST(FaultWithoutEffect, IsOneThatLeavesTheFrameAsItIs)
{
    Verifies(req::SRS_SIM_015);
    // Given faults that change nothing: a bit behind the last byte, a bit flipped twice, the identifier it has anyway
    for (const char* const fault : {"corruption, frames: {identifier: 0x103}, bits: [63]",
                                    "corruption, frames: {identifier: 0x103}, bits: [0, 0]",
                                    "addressing, frames: {identifier: 0x103}, as: 0x103"})
    {
        // When somebody expects that nobody notices it
        const auto run = RunChain("faults:\n  - {fault: " + std::string(fault) +
                                  "}\nexpect:\n  - {that: detected_by, node: actuator, by: nobody}\n");
        // Then that does not hold, and the fault is told
        const std::string kind = std::string(fault).substr(0U, std::string(fault).find(','));
        EXPECT_EQ(Failures(*run), "detected at actuator by nobody: the fault never happened\nfault '" + kind +
                                      "' happens: never happened\n")
            << fault;
        EXPECT_EQ(run->FaultsWithoutEffect().size(), 1U) << fault;
    }
    // And a fault that came is not
    EXPECT_TRUE(RunChain("faults:\n  - {fault: loss, frames: {identifier: 0x103}}\n")->FaultsWithoutEffect().empty());
}
} // namespace
} // namespace counterpoint::simulator
