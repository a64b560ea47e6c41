// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Which side of a mapping an object may stand on.
#include "tests/canopen/cia306/check_text.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::cia306
{
namespace
{
using test::CheckRow;
constexpr const char* kWritten = "ParameterValue";

TEST(CheckSides, NormalDataStandsNotInThePlaceOfInverseData)
{
    Verifies(req::SRS_CLI_550);
    const test::Set first{"1381sub2", kWritten, "0x20000208"};
    const test::Set count{"1381sub0", kWritten, "2"};
    const test::Set unnamed{"2000sub1", "InvertedSRAD", ""};
    const std::string found = "0x1381:02: inverse entry 0x2000:02 has an InvertedSRAD of its own (line 365), as normal "
                              "data has, expected inverse data of 0x2000:01";
    const std::vector<CheckRow> rows = {
        {{first, count, unnamed}, {"error: " + found}},
        {{first, count, unnamed, {"1301sub1", kWritten, "0"}, {"13FE", kWritten, "0"}},
         {"warning: " + found, "warning: 0x13FE:00: 0x00: the SRDOs stay off, expected 0xA5 to set them going"}},
        // One that names the normal entry makes it inverse data
        {{first, count, unnamed, {"2000sub2", "InvertedSRAD", "0x200001"}},
         {"error: 0x1381:01: normal entry 0x2000:01 is the InvertedSRAD of 0x2000:02 (line 365), expected normal data "
          "here and 0x2000:01 behind it"}},
        // The normal object has the last word on what its inverse is
        {{first, count, {"2000sub1", "InvertedSRAD", "0x200002"}}, {}},
        {{first, count, unnamed, {"2000sub2", "InvertedSRAD", ""}}, {}},
        {{first, count},
         {"error: 0x1381:02: inverse entry 0x2000:02, expected 0x2100:01, the InvertedSRAD of 0x2000:01 "
          "(line 355)"}},
    };
    test::ExpectRows("sensor", rows, {});
}

// An entry that cannot be read is no part of a pair
TEST(CheckSides, APairHasTwoEntries)
{
    Verifies(req::SRS_CLI_550);
    const std::vector<CheckRow> rows = {
        {{{"1381sub1", kWritten, "x"}},
         {"error: 0x1381:01: value 'x', expected a number from 0 to 4294967295 (UNSIGNED32), or $NODEID+number"}},
        {{{"1381sub3", kWritten, "x"}},
         {"error: 0x1381:03: value 'x', expected a number from 0 to 4294967295 (UNSIGNED32), or $NODEID+number"}},
    };
    test::ExpectRows("sensor", rows, {});
}
} // namespace
} // namespace counterpoint::cia306
