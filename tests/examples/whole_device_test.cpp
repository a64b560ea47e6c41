// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The device with all services: what it prints, and that its document shows the same.
#include "tests/hal/contract_test/program.hpp"
#include "verification/trace/ids/generate.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

namespace counterpoint
{
namespace
{

using hal::contract::ProgramRun;
using hal::contract::RunProgram;

TEST(WholeDevice, ServesSavesRunsAndKeepsWhatWasSaved)
{
    Verifies(req::SRS_GEN_660);
    const std::string expected = "   0 ms: NMT state 0\n"
                                 "   1 ms: NMT state 127\n"
                                 "  10 ms: SDO 1018h:02 is 3\n"
                                 "  20 ms: SDO 2012h:00 is 10\n"
                                 "  30 ms: SDO 2012h:00 written\n"
                                 "  90 ms: SDO 1010h:01 written\n"
                                 " 190 ms: SDO 1301h:02 refused, abort code 08000022h\n"
                                 " 201 ms: NMT state 5\n"
                                 " 302 ms: speed 20 by PDO\n"
                                 " 312 ms: speed 200 by PDO\n"
                                 " 550 ms: emergency 8250h\n"
                                 " 552 ms: speed 0 by PDO\n"
                                 " 600 ms: power off and on\n"
                                 " 600 ms: NMT state 0\n"
                                 " 601 ms: NMT state 127\n"
                                 " 700 ms: SDO 2012h:00 is 20\n"
                                 "device running\n";
    const ProgramRun run = RunProgram(WHOLE_DEVICE, "");
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.text, expected);
    // When it runs again, beside the store of the run before, then nothing differs
    EXPECT_EQ(RunProgram(WHOLE_DEVICE, "").text, expected);
    // And its document shows it
    std::ifstream document{std::string{COUNTERPOINT_SOURCE_FOLDER} + "/examples/whole_device/README.md"};
    const std::string text{std::istreambuf_iterator<char>{document}, {}};
    EXPECT_NE(text.find("```text\n" + expected + "```\n"), std::string::npos);
}

} // namespace
} // namespace counterpoint
