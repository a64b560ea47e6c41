// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The contract test on the host layer as it is, and on ports with one planted defect each.
#include "tests/hal/contract_test/host_bench.hpp"
#include "tests/hal/contract_test/report.hpp"
#include "verification/trace/ids/hal.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace counterpoint::hal::contract
{
namespace
{

TEST(ContractTest, HostKeepsTheContract)
{
    Verifies(req::SRS_HAL_030);
    Verifies(req::SRS_HAL_031);
    // Given the host's layer with one controller, then every check holds, and the count says so
    HostBench bench{Defect::kNone};
    const ContractCount count = RunContractTest(bench.Table());
    EXPECT_EQ(LinesWith(bench.Text(), ": broken: "), std::vector<std::string>{});
    EXPECT_EQ(LinesWith(bench.Text(), ": not shown: "), std::vector<std::string>{});
    EXPECT_EQ(count.held, 37U);
    EXPECT_EQ(count.broken, 0U);
    EXPECT_EQ(LinesWith(bench.Text(), " held, "), std::vector<std::string>{"37 held, 0 broken, 0 not shown"});
}

TEST(ContractTest, BothControllersKeepTheContract)
{
    Verifies(req::SRS_HAL_030);
    // Given the inverse data on the second controller, then only the refusal of an absent one cannot be shown
    HostBench bench{Defect::kNone, 2U};
    static_cast<void>(RunContractTest(bench.Table()));
    EXPECT_EQ(LinesWith(bench.Text(), ": broken: "), std::vector<std::string>{});
    EXPECT_EQ(LinesWith(bench.Text(), ": not shown: "),
              std::vector<std::string>{
                  "transmission: absent controller is refused: not shown: the port has both controllers"});
}

TEST(ContractTest, MissingCallsOfTheTableAreNotShown)
{
    Verifies(req::SRS_HAL_031);
    // Given a bench that can hold nothing and sees nothing, then what needs it is told, and not counted as held
    HostBench bench{Defect::kNone};
    PortUnderTest port = bench.Table();
    port.bench.hold_bus = nullptr;
    port.bench.hold_counter = nullptr;
    port.bench.hold_pin = nullptr;
    port.bench.is_alive = nullptr;
    const ContractCount count = RunContractTest(port);
    EXPECT_EQ(count.broken, 0U);
    EXPECT_EQ(count.not_shown, 13U);
    EXPECT_EQ(
        LinesWith(bench.Text(), "stamps of both counters"),
        std::vector<std::string>{"reception: stamps of both counters at the end of the frame: not shown: the counters "
                                 "are too close to each other to be told apart"});
}

TEST(ContractTest, TableWithoutWhatIsNeededIsBroken)
{
    Verifies(req::SRS_HAL_031);
    // Given a table without a second node, then nothing is called and the table is named
    HostBench bench{Defect::kNone};
    PortUnderTest port = bench.Table();
    port.bench.peer_send = nullptr;
    static_cast<void>(RunContractTest(port));
    EXPECT_EQ(bench.Text(),
              "table: complete: broken: calls that are needed, cycle and frame not 0, rooms as the header says: "
              "expected 1, got 0\n0 held, 1 broken, 0 not shown\n");
}

/// A defect and the checks that must name it, no others.
struct DefectRow
{
    Defect defect;
    std::vector<std::string> broken;
};

class PlantedDefect : public ::testing::TestWithParam<DefectRow>
{
};

TEST_P(PlantedDefect, IsNamed)
{
    Verifies(req::SRS_HAL_032);
    HostBench bench{GetParam().defect};
    const ContractCount count = RunContractTest(bench.Table());
    EXPECT_EQ(NamesOfBroken(bench.Text()), GetParam().broken) << bench.Text();
    EXPECT_EQ(count.broken, GetParam().broken.size());
}

const DefectRow kDefects[] = {
    {Defect::kFramesReordered, {}},
    {Defect::kStampsSwapped, {}},
    {Defect::kStampedWhenTaken, {}},
    {Defect::kBytesSwapped, {}},
    {Defect::kForeignDelivered, {}},
    {Defect::kRemoteAsData, {}},
    {Defect::kLossNotTold, {}},
    {Defect::kConfirmedTwice, {}},
    {Defect::kConfirmedOther, {}},
    {Defect::kConfirmedAtOnce, {}},
    {Defect::kOwnFrameReceived, {}},
    {Defect::kRefusalSwallowed, {}},
    {Defect::kOneGuaranteeAbsent, {}},
    {Defect::kAbsentControllerTaken, {}},
    {Defect::kTransmitWaits, {}},
    {Defect::kOneSourceForBoth, {}},
    {Defect::kCounterGoesBack, {}},
    {Defect::kCounterWrapsEarly, {}},
    {Defect::kCounterBSlow, {}},
    {Defect::kQuestionStays, {}},
    {Defect::kEarlyAnswerTaken, {}},
    {Defect::kMissingAnswerTaken, {}},
    {Defect::kWrongAnswerTaken, {}},
    {Defect::kRevivedAfterTrip, {}},
    {Defect::kImpossibleRegionTaken, {}},
    {Defect::kEraseTakesBoth, {}},
    {Defect::kProgramsNothing, {}},
    {Defect::kChallengeStays, {}},
    {Defect::kOpenAfterStart, {}},
    {Defect::kNeverOpens, {}},
    {Defect::kOnePermitNotLookedAt, {}},
    {Defect::kNeverCloses, {}},
    {Defect::kOpenAfterTrip, {}},
    {Defect::kNotReadBack, {}},
    {Defect::kCutOffForgotten, {}},
};

INSTANTIATE_TEST_SUITE_P(Ports, PlantedDefect, ::testing::ValuesIn(kDefects));

} // namespace
} // namespace counterpoint::hal::contract
