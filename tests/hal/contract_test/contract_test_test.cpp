// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The contract test on the host layer as it is, and on ports with one planted defect each.
#include "tests/hal/contract_test/host_bench.hpp"
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

TEST(ContractTest, HostKeepsTheContract)
{
    Verifies(req::SRS_HAL_030);
    Verifies(req::SRS_HAL_031);
    Verifies(req::SRS_HAL_340);
    // Given the host's layer with one controller, then every check holds, and the count says so
    HostBench bench{Defect::kNone};
    const ContractCount count = RunContractTest(bench.Table());
    EXPECT_EQ(LinesWith(bench.Text(), ": broken: "), std::vector<std::string>{});
    EXPECT_EQ(LinesWith(bench.Text(), ": not shown: "), std::vector<std::string>{});
    EXPECT_EQ(count.held, 44U);
    EXPECT_EQ(count.broken, 0U);
    EXPECT_EQ(LinesWith(bench.Text(), " held, "), std::vector<std::string>{"44 held, 0 broken, 0 not shown"});
}

TEST(ContractTest, BothControllersKeepTheContract)
{
    Verifies(req::SRS_HAL_030);
    Verifies(req::SRS_HAL_340);
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
    EXPECT_EQ(count.not_shown, 14U);
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

/// What a port is called for, and what was written before.
class WatchedPort final : public Clocks
{
  public:
    [[nodiscard]] PortUnderTest Table()
    {
        inner_ = bench.Table();
        PortUnderTest port = inner_;
        port.parts.clocks = this;
        port.bench = PortBench{};
        port.bench.bench = this;
        port.bench.write = [](void* self, const char* text) { Of(self).inner_.bench.write(&Of(self).bench, text); };
        port.bench.next = [](void* self) { return Of(self).Called().next(&Of(self).bench); };
        port.bench.pass = [](void* self, const std::uint32_t us) { Of(self).Called().pass(&Of(self).bench, us); };
        port.bench.restart = [](void* self) { Of(self).Called().restart(&Of(self).bench); };
        port.bench.peer_send = [](void* self, const CanFrame& frame)
        { return Of(self).Called().peer_send(&Of(self).bench, frame); };
        port.bench.pins = [](void* self) { return Of(self).Called().pins(&Of(self).bench); };
        return port;
    }
    [[nodiscard]] InstantPair Now() noexcept override
    {
        static_cast<void>(Called());
        return bench.Now();
    }

    HostBench bench{Defect::kNone};
    std::uint32_t calls{0U};
    std::set<std::string> unannounced{}; ///< What was written last where no check was begun.

  private:
    [[nodiscard]] static WatchedPort& Of(void* const self)
    {
        return *static_cast<WatchedPort*>(self);
    }
    /// A begun line ends with the colon behind its name, or with what it has found so far.
    [[nodiscard]] const PortBench& Called()
    {
        ++calls;
        const std::string& text = bench.Text();
        if (text.empty() || (text.back() == '\n'))
        {
            static_cast<void>(unannounced.insert(text));
        }
        return inner_.bench;
    }

    PortUnderTest inner_{};
};

TEST(ContractTest, EachCallIsBehindTheNameOfItsCheck)
{
    Verifies(req::SRS_HAL_031);
    WatchedPort port;
    static_cast<void>(RunContractTest(port.Table()));
    EXPECT_GT(port.calls, 1000U);
    EXPECT_EQ(port.unannounced, std::set<std::string>{});
    EXPECT_EQ(LinesWith(port.bench.Text(), ": broken: "), std::vector<std::string>{});
}

/// A defect and the checks that must name it, no others.
struct DefectRow
{
    const char* name;
    Defect defect;
    std::vector<std::string> broken;
};

class PlantedDefect : public ::testing::TestWithParam<DefectRow>
{
};

TEST_P(PlantedDefect, IsNamed)
{
    Verifies(req::SRS_HAL_032);
    Verifies(req::SRS_HAL_037);
    Verifies(req::SRS_HAL_341);
    HostBench bench{GetParam().defect};
    const ContractCount count = RunContractTest(bench.Table());
    EXPECT_EQ(NamesOfBroken(bench.Text()), GetParam().broken) << bench.Text();
    EXPECT_EQ(count.broken, GetParam().broken.size());
}

const DefectRow kDefects[] = {
    {"FramesReordered",
     Defect::kFramesReordered,
     {"reception: order of the bus", "reception: late interrupt: order of the bus, or a loss",
      "reception: stamps as far apart as frames"}},
    {"StampsSwapped",
     Defect::kStampsSwapped,
     {"reception: stamps of both counters at the end of the frame", "transmission: confirmation has both stamps",
      "transmission: not confirmed before it was on the bus"}},
    {"StampedWhenTaken",
     Defect::kStampedWhenTaken,
     {"reception: stamps of both counters at the end of the frame", "reception: stamps as far apart as frames",
      "transmission: confirmation has both stamps"}},
    {"BytesSwapped", Defect::kBytesSwapped, {"reception: content as sent"}},
    {"ForeignDelivered", Defect::kForeignDelivered, {"reception: foreign identifiers stay away"}},
    {"RemoteAsData", Defect::kRemoteAsData, {"reception: other kinds are no data frames"}},
    {"FirstBitsAsData", Defect::kFirstBitsAsData, {"reception: other kinds are no data frames"}},
    {"LastBitsAsData", Defect::kLastBitsAsData, {"reception: other kinds are no data frames"}},
    {"LossNotTold", Defect::kLossNotTold, {"reception: loss is told", "reception: loss in the controller is told"}},
    {"LossInControllerNotTold", Defect::kLossInControllerNotTold, {"reception: loss in the controller is told"}},
    {"ConfirmedTwice",
     Defect::kConfirmedTwice,
     {"transmission: confirmed once, as sent", "transmission: not confirmed before it was on the bus",
      "transmission: normal data leave before inverse data", "transmission: refuses when full",
      "transmission: waiting frames leave in order", "transmission: own and foreign frames in order",
      "transmission: late interrupt: own frames in order, or a loss",
      "transmission: nothing old leaves after bus-off"}},
    {"ConfirmedOther", Defect::kConfirmedOther, {"transmission: confirmed once, as sent"}},
    {"ConfirmedAtOnce",
     Defect::kConfirmedAtOnce,
     {"transmission: not confirmed before it was on the bus", "transmission: own and foreign frames in order",
      "transmission: late interrupt: own frames in order, or a loss",
      "transmission: nothing old leaves after bus-off"}},
    {"OwnFrameReceived",
     Defect::kOwnFrameReceived,
     {"transmission: confirmed once, as sent", "transmission: normal data leave before inverse data",
      "transmission: own and foreign frames in order", "transmission: late interrupt: own frames in order, or a loss"}},
    {"StampedAtRequest", Defect::kStampedAtRequest, {"transmission: not confirmed before it was on the bus"}},
    {"InverseOvertakes",
     Defect::kInverseOvertakes,
     {"transmission: normal data leave before inverse data", "transmission: waiting frames leave in order"}},
    {"OtherOnTheBus",
     Defect::kOtherOnTheBus,
     {"transmission: on the bus as handed over", "transmission: nothing old leaves after bus-off"}},
    {"OtherLengthOnTheBus", Defect::kOtherLengthOnTheBus, {"transmission: on the bus as handed over"}},
    {"LaterOvertakes", Defect::kLaterOvertakes, {"transmission: waiting frames leave in order"}},
    {"OwnAfterForeign", Defect::kOwnAfterForeign, {"transmission: late interrupt: own frames in order, or a loss"}},
    {"OwnMissingWhenLate",
     Defect::kOwnMissingWhenLate,
     {"transmission: late interrupt: own frames in order, or a loss"}},
    {"OldAfterBusOff", Defect::kOldAfterBusOff, {"transmission: nothing old leaves after bus-off"}},
    {"RefusalSwallowed",
     Defect::kRefusalSwallowed,
     {"transmission: refuses when full", "transmission: nothing old leaves after bus-off"}},
    {"OneGuaranteeAbsent", Defect::kOneGuaranteeAbsent, {"can: all three guarantees"}},
    {"AbsentControllerTaken", Defect::kAbsentControllerTaken, {"transmission: absent controller is refused"}},
    {"TransmitWaits",
     Defect::kTransmitWaits,
     {"transmission: confirmation has both stamps", "transmission: calls come back"}},
    {"OneSourceForBoth",
     Defect::kOneSourceForBoth,
     {"clocks: each counter goes on without the other", "reception: stamps of both counters at the end of the frame",
      "transmission: confirmation has both stamps", "transmission: not confirmed before it was on the bus"}},
    {"CounterGoesBack", Defect::kCounterGoesBack, {"clocks: counters never go back"}},
    {"CounterWrapsEarly",
     Defect::kCounterWrapsEarly,
     {"clocks: no wrap before 2^32 us", "reception: stamps of both counters at the end of the frame",
      "transmission: confirmation has both stamps", "transmission: not confirmed before it was on the bus"}},
    {"CounterBSlow",
     Defect::kCounterBSlow,
     {"clocks: both counters go on", "clocks: each counter goes on without the other", "clocks: no wrap before 2^32 us",
      "reception: stamps of both counters at the end of the frame", "transmission: confirmation has both stamps",
      "transmission: not confirmed before it was on the bus"}},
    {"QuestionStays", Defect::kQuestionStays, {"watchdog: question changes"}},
    {"EarlyAnswerTaken", Defect::kEarlyAnswerTaken, {"watchdog: early answer trips"}},
    {"MissingAnswerTaken",
     Defect::kMissingAnswerTaken,
     {"watchdog: early answer trips", "watchdog: missing answer trips", "watchdog: wrong answer trips",
      "watchdog: tripped stays tripped"}},
    {"WrongAnswerTaken", Defect::kWrongAnswerTaken, {"watchdog: wrong answer trips"}},
    {"RevivedAfterTrip",
     Defect::kRevivedAfterTrip,
     {"watchdog: tripped stays tripped", "output: closed once the watchdog has tripped"}},
    {"ImpossibleRegionTaken", Defect::kImpossibleRegionTaken, {"protection: impossible region is refused"}},
    {"EraseTakesBoth",
     Defect::kEraseTakesBoth,
     {"parameters: programmed bytes are read", "parameters: erase touches one bank"}},
    {"ProgramsNothing",
     Defect::kProgramsNothing,
     {"parameters: programmed bytes are read", "parameters: erase touches one bank"}},
    {"ChallengeStays",
     Defect::kChallengeStays,
     {"output: challenges differ", "output: opens by three right permits", "output: a wrong permit closes",
      "output: interrupted, stays closed", "output: closes by itself", "output: closed once the watchdog has tripped",
      "cut-off: low, and stays low"}},
    {"OpenAfterStart", Defect::kOpenAfterStart, {"output: closed after start"}},
    {"NeverOpens",
     Defect::kNeverOpens,
     {"output: opens by three right permits", "output: a wrong permit closes", "output: interrupted, stays closed",
      "output: closes by itself", "output: closed once the watchdog has tripped", "cut-off: low, and stays low"}},
    {"OnePermitNotLookedAt", Defect::kOnePermitNotLookedAt, {"output: a wrong permit closes"}},
    {"ForgetsInterruption", Defect::kForgetsInterruption, {"output: interrupted, stays closed"}},
    {"NeverCloses", Defect::kNeverCloses, {"output: closes by itself"}},
    {"ClosesLate", Defect::kClosesLate, {"output: closes by itself"}},
    {"OpenAfterTrip", Defect::kOpenAfterTrip, {"output: closed once the watchdog has tripped"}},
    {"NotReadBack", Defect::kNotReadBack, {"cut-off: pins are read back"}},
    {"CutOffForgotten", Defect::kCutOffForgotten, {"cut-off: low, and stays low"}},
};

INSTANTIATE_TEST_SUITE_P(Ports, PlantedDefect, ::testing::ValuesIn(kDefects),
                         [](const ::testing::TestParamInfo<DefectRow>& row) { return std::string{row.param.name}; });

TEST(ContractTest, EveryCheckNamesSomeDefect)
{
    Verifies(req::SRS_HAL_032);
    std::set<std::string> named;
    for (const DefectRow& row : kDefects)
    {
        named.insert(row.broken.begin(), row.broken.end());
    }
    HostBench bench{Defect::kNone};
    static_cast<void>(RunContractTest(bench.Table()));
    std::vector<std::string> unnamed;
    for (const std::string& line : LinesWith(bench.Text(), ": held"))
    {
        const std::string name = line.substr(0U, line.find(": held"));
        if (named.count(name) == 0U)
        {
            unnamed.push_back(name);
        }
    }
    EXPECT_EQ(unnamed, std::vector<std::string>{"table: complete"});
}

} // namespace
} // namespace counterpoint::hal::contract
