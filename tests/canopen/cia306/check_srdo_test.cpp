// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/cia306/check_text.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace counterpoint::cia306
{
namespace
{
using test::CheckRow;

constexpr const char* kValue = "ParameterValue";

TEST(CheckSrdo, TheExamplesHaveNoFinding)
{
    Verifies(req::SRS_CLI_019);
    for (const char* name : {"sensor", "controller", "actuator"})
    {
        EXPECT_EQ(test::FindingsOf(test::ExampleText(name), {}), std::vector<std::string>{}) << name;
    }
}

TEST(CheckSrdo, DirectionTypeAndNumberOfParameters)
{
    Verifies(req::SRS_CLI_010);
    const std::vector<CheckRow> rows = {
        {{{"1302sub1", kValue, "3"}},
         {"error: 0x1302:01: direction 3, expected 0 (off), 1 (producer) or 2 (consumer)"}},
        {{{"1302sub4", kValue, "253"}}, {"error: 0x1302:04: transmission type 253, expected 254"}},
        {{{"1302sub4", kValue, "0"}}, {"error: 0x1302:04: transmission type 0, expected 254"}},
        {{{"1302sub4", kValue, "255"}},
         {"warning: 0x1302:04: transmission type 255, expected 254; devices with 255 exist, this kernel refuses it"}},
        {{{"1302sub4", kValue, "0xFE"}}, {}},
        {{{"1302sub0", kValue, "5"}}, {"error: 0x1302:00: highest sub-index 5, expected 6"}},
        {{{"1302sub0", kValue, "7"}}, {"error: 0x1302:00: highest sub-index 7, expected 6"}},
    };
    test::ExpectRows("controller", rows, {});
}

TEST(CheckSrdo, CobIds)
{
    Verifies(req::SRS_CLI_010);
    const std::vector<CheckRow> rows = {
        {{{"1302sub5", kValue, "0x80000103"}},
         {"error: 0x1302:05: COB-ID 0x80000103 has reserved bits set, expected bits 11 to 31 to be 0"}},
        {{{"1302sub6", kValue, "0x904"}},
         {"error: 0x1302:06: COB-ID 0x904 has reserved bits set, expected bits 11 to 31 to be 0"}},
        {{{"1302sub5", kValue, "0x0FF"}, {"1302sub6", kValue, "0x100"}},
         {"error: 0x1302:05: COB-ID 0x0FF, expected a COB-ID from 0x101 to 0x180",
          "error: 0x1302:06: COB-ID 0x100, expected a COB-ID from 0x101 to 0x180"}},
        {{{"1302sub5", kValue, "0x17F"}, {"1302sub6", kValue, "0x180"}}, {}},
        {{{"1302sub5", kValue, "0x181"}, {"1302sub6", kValue, "0x182"}},
         {"error: 0x1302:05: COB-ID 0x181, expected a COB-ID from 0x101 to 0x180",
          "error: 0x1302:06: COB-ID 0x182, expected a COB-ID from 0x101 to 0x180"}},
        {{{"1302sub5", kValue, "0x104"}, {"1302sub6", kValue, "0x105"}},
         {"error: 0x1302:05: COB-ID 0x104 is even, expected an odd one for normal data",
          "error: 0x1302:06: COB-ID 0x105 is odd, expected an even one for inverse data"}},
        {{{"1302sub6", kValue, "0x106"}}, {"error: 0x1302:06: COB-ID 2 0x106, expected 0x104 (COB-ID 1 + 1)"}},
        {{{"1302sub5", kValue, "0x105"}}, {"error: 0x1302:06: COB-ID 2 0x104, expected 0x106 (COB-ID 1 + 1)"}},
        {{{"1302sub5", kValue, "0x105"}, {"1302sub6", kValue, "0x106"}}, {}},
        {{{"1302sub5", kValue, "0"}, {"1302sub6", kValue, "0"}},
         {"error: 0x1302:05: COB-ID 0x000, expected a COB-ID from 0x101 to 0x180",
          "error: 0x1302:06: COB-ID 0x000, expected a COB-ID from 0x101 to 0x180"}},
        {{{"1302sub5", kValue, "0"}, {"1302sub6", kValue, "0"}, {"1302sub1", kValue, "0"}}, {}},
        {{{"1302sub5", kValue, "0x90"}, {"1302sub6", kValue, "0x91"}, {"1302sub1", kValue, "0"}},
         {"error: 0x1302:05: COB-ID 0x090, expected a COB-ID from 0x101 to 0x180",
          "error: 0x1302:06: COB-ID 0x091, expected a COB-ID from 0x101 to 0x180"}},
    };
    test::ExpectRows("controller", rows, {});
}

TEST(CheckSrdo, IdentifiersInUse)
{
    Verifies(req::SRS_CLI_010);
    const std::vector<CheckRow> rows = {
        {{{"1302sub5", kValue, "0x101"}, {"1302sub6", kValue, "0x102"}},
         {"error: 0x1302:05: COB-ID 0x101 is in use by SRDO 1, expected an identifier of its own",
          "error: 0x1302:06: COB-ID 0x102 is in use by SRDO 1, expected an identifier of its own"}},
        {{{"1302sub6", kValue, "0x102"}},
         {"error: 0x1302:06: COB-ID 2 0x102, expected 0x104 (COB-ID 1 + 1)",
          "error: 0x1302:06: COB-ID 0x102 is in use by SRDO 1, expected an identifier of its own"}},
        {{{"1302sub5", kValue, "0x101"}, {"1302sub6", kValue, "0x102"}, {"1302sub1", kValue, "0"}},
         {"error: 0x1302:05: COB-ID 0x101 is in use by SRDO 1, expected an identifier of its own",
          "error: 0x1302:06: COB-ID 0x102 is in use by SRDO 1, expected an identifier of its own"}},
        {{{"1302sub5", kValue, "0x101"},
          {"1302sub6", kValue, "0x102"},
          {"1302sub1", kValue, "0"},
          {"1301sub1", kValue, "0"}},
         {"warning: 0x1302:05: COB-ID 0x101 is in use by SRDO 1, both are off, expected an identifier of its own",
          "warning: 0x1302:06: COB-ID 0x102 is in use by SRDO 1, both are off, expected an identifier of its own"}},
    };
    test::ExpectRows("controller", rows, {});
}

TEST(CheckSrdo, TimesOfAConsumer)
{
    Verifies(req::SRS_CLI_011);
    const std::vector<CheckRow> rows = {
        {{{"1301sub3", kValue, "0"}}, {"error: 0x1301:03: SRVT 0 ms of a consumer, expected 1 ms or more"}},
        {{{"1301sub3", kValue, "1"}}, {}},
        {{{"1301sub3", kValue, "49"}}, {}},
        {{{"1301sub3", kValue, "50"}}, {"error: 0x1301:03: SRVT 50 ms, expected less than the SCT of 50 ms"}},
        {{{"1301sub2", kValue, "2"}, {"1301sub3", kValue, "1"}}, {}},
        {{{"1301sub2", kValue, "65535"}, {"1301sub3", kValue, "255"}}, {}},
        {{{"1301sub2", kValue, "0"}}, {"error: 0x1301:03: SRVT 20 ms, expected less than the SCT of 0 ms"}},
    };
    test::ExpectRows("controller", rows, {});
}

TEST(CheckSrdo, TimesOfAProducer)
{
    Verifies(req::SRS_CLI_011);
    const std::vector<CheckRow> rows = {
        {{{"1302sub2", kValue, "1"}, {"1302sub3", kValue, "1"}},
         {"warning: 0x1302:03: SRVT 1 ms, expected less than the refresh time of 1 ms"}},
        {{{"1302sub2", kValue, "1"}, {"1302sub3", kValue, "1"}, {"5F00sub1", kValue, "1001"}},
         {"error: 0x1302:02: refresh time 1 ms, expected at least one cycle of 1001 us (0x5F00:01)",
          "warning: 0x1302:03: SRVT 1 ms, expected less than the refresh time of 1 ms"}},
        {{{"1302sub2", kValue, "0"}, {"1302sub3", kValue, "1"}},
         {"error: 0x1302:02: refresh time 0 ms, expected at least one cycle of 1000 us (0x5F00:01)",
          "warning: 0x1302:03: SRVT 1 ms, expected less than the refresh time of 0 ms"}},
        {{{"1302sub3", kValue, "24"}}, {}},
        {{{"1302sub3", kValue, "25"}},
         {"warning: 0x1302:03: SRVT 25 ms, expected less than the refresh time of 25 ms"}},
        {{{"1302sub3", kValue, "0"}},
         {"warning: 0x1302:03: SRVT 0 ms of a producer: no confirmation comes in time, expected 1 ms or more"}},
    };
    test::ExpectRows("controller", rows, {});
}

TEST(CheckSrdo, AnSrdoThatIsOffHasNoTimingRule)
{
    Verifies(req::SRS_CLI_011);
    const std::vector<CheckRow> rows = {
        {{{"1301sub1", kValue, "0"}, {"1301sub2", kValue, "0"}, {"1301sub3", kValue, "0"}}, {}},
        {{{"1301sub1", kValue, "0"}, {"1301sub2", kValue, "5"}, {"1301sub3", kValue, "9"}}, {}},
    };
    test::ExpectRows("controller", rows, {});
}

TEST(CheckSrdo, DefaultCobIdsOfTheFirstSrdo)
{
    Verifies(req::SRS_CLI_017);
    CheckOptions options;
    options.node_id = std::uint8_t{3U};
    const std::vector<CheckRow> rows = {
        {{{"1301sub5", "DefaultValue", "0x105"}, {"1301sub6", "DefaultValue", "$NODEID+0x103"}}, {}},
        {{{"1301sub5", "DefaultValue", "0x103"}},
         {"warning: 0x1301:05: default COB-ID 0x103, expected 0x105 for node-ID 3 (pre-defined connection set)",
          "warning: 0x1301:06: default COB-ID 0x104, expected 0x106 for node-ID 3 (pre-defined connection set)"}},
    };
    test::ExpectRows("controller", rows, options);
    options.node_id = std::uint8_t{64U};
    const std::vector<CheckRow> last = {
        {{{"1301sub5", "DefaultValue", "0x17F"}, {"1301sub6", "DefaultValue", "0x180"}}, {}}};
    test::ExpectRows("controller", last, options);
    options.node_id = std::uint8_t{65U};
    const std::vector<CheckRow> none = {
        {{{"1301sub5", "DefaultValue", "0x101"}, {"1301sub5", kValue, ""}},
         {"warning: 0x1301:05: default COB-ID with node-ID 65, expected a ParameterValue: there is no default COB-ID "
          "above node-ID 64"}}};
    test::ExpectRows("controller", none, options);
}
} // namespace
} // namespace counterpoint::cia306
