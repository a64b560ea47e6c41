// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The skeleton as somebody meets it who has just copied it.
#include "tests/hal/contract_test/program.hpp"
#include "tests/hal/contract_test/report.hpp"
#include "verification/trace/ids/hal.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace counterpoint::hal::contract
{
namespace
{

TEST(PortSkeleton, DeviceDoesNotStartAndTellsEachMissingPart)
{
    Verifies(req::SRS_HAL_034);
    Verifies(req::SRS_HAL_033);
    const ProgramRun run = RunProgram(PORT_SKELETON_DEVICE, "");
    EXPECT_EQ(run.status, 1);
    EXPECT_EQ(run.text, "missing: start-up\n"
                        "missing: exceptions\n"
                        "missing: clocks\n"
                        "missing: CAN ports\n"
                        "missing: reception\n"
                        "missing: output\n"
                        "missing: cut-off\n"
                        "missing: watchdog\n"
                        "missing: interrupt lock\n"
                        "missing: memory protection (or say that the device does without)\n"
                        "missing: parameter memory (or say that the device does without)\n"
                        "missing: cross link (or say that the device does without)\n"
                        "not started: 12 parts are missing\n"
                        "the kernel alone would answer: bus_order\n");
}

TEST(PortSkeleton, ContractTestNamesEachPart)
{
    Verifies(req::SRS_HAL_034);
    const ProgramRun run = RunProgram(PORT_SKELETON_DEVICE, "contract");
    EXPECT_EQ(run.status, 1);
    std::set<std::string> parts;
    for (const std::string& name : NamesOfBroken(run.text))
    {
        parts.insert(name.substr(0U, name.find(": ")));
    }
    EXPECT_EQ(parts,
              (std::set<std::string>{"can", "clocks", "cut-off", "output", "reception", "transmission", "watchdog"}))
        << run.text;
    // What the skeleton refuses as its contract says is held, and what it says to have not at all is not shown.
    EXPECT_EQ(LinesWith(run.text, "protection: "),
              std::vector<std::string>{"protection: impossible region is refused: held"});
    EXPECT_EQ(
        LinesWith(run.text, "programmed bytes"),
        std::vector<std::string>{"parameters: programmed bytes are read: not shown: the port has no parameter memory"});
}

} // namespace
} // namespace counterpoint::hal::contract
