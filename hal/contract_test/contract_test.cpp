// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/contract_test/contract_test.hpp"

#include "hal/contract_test/checks.hpp"

namespace counterpoint::hal::contract
{

namespace
{

struct CheckRow
{
    const char* part;
    const char* name;
    CheckBody body;
};

/// The counters first: what comes after them is measured by them, and holding one brings them apart.
constexpr CheckRow kRows[]{
    // MISRA D-001
    {"clocks", "both counters go on", BothCountersGoOn},
    {"clocks", "counters never go back", CountersNeverGoBack},
    {"clocks", "each counter goes on without the other", CountersAreIndependent},
    {"clocks", "no wrap before 2^32 us", CountersDoNotWrapEarly},
    {"can", "all three guarantees", AllGuaranteesAreGiven},
    {"reception", "content as sent", ContentIsAsSent},
    {"reception", "order of the bus", OrderIsThatOfTheBus},
    {"reception", "late interrupt: order of the bus, or a loss", LateInterruptKeepsOrder},
    {"reception", "stamps of both counters at the end of the frame", StampsAreOfBothCounters},
    {"reception", "stamps as far apart as frames", StampsAreAsFarApartAsFrames},
    {"reception", "foreign identifiers stay away", ForeignFramesStayAway},
    {"reception", "other kinds are no data frames", OtherKindsAreNoData},
    {"reception", "loss is told", LossIsTold},
    {"reception", "loss in the controller is told", LossInControllerIsTold},
    {"transmission", "confirmed once, as sent", ConfirmedOnceAsSent},
    {"transmission", "confirmation has both stamps", ConfirmationHasBothStamps},
    {"transmission", "not confirmed before it was on the bus", NotConfirmedBeforeTheBus},
    {"transmission", "normal data leave before inverse data", NormalLeavesBeforeInverse},
    {"transmission", "refuses when full", FullIsRefused},
    {"transmission", "on the bus as handed over", OnTheBusAsHandedOver},
    {"transmission", "waiting frames leave in order", WaitingFramesKeepOrder},
    {"transmission", "own and foreign frames in order", OwnAndForeignInOrder},
    {"transmission", "late interrupt: own frames in order, or a loss", LateInterruptKeepsOwnFrames},
    {"transmission", "nothing old leaves after bus-off", NothingOldAfterBusOff},
    {"transmission", "absent controller is refused", AbsentControllerIsRefused},
    {"transmission", "calls come back", CallsComeBack},
    {"watchdog", "question changes", QuestionChanges},
    {"watchdog", "early answer trips", EarlyAnswerTrips},
    {"watchdog", "missing answer trips", MissingAnswerTrips},
    {"watchdog", "wrong answer trips", WrongAnswerTrips},
    {"watchdog", "tripped stays tripped", TrippedStaysTripped},
    {"protection", "impossible region is refused", ImpossibleRegionIsRefused},
    {"parameters", "programmed bytes are read", ProgrammedBytesAreRead},
    {"parameters", "erase touches one bank", EraseTouchesOneBank},
    {"output", "challenges differ", ChallengesDiffer},
    {"output", "closed after start", ClosedAfterStart},
    {"output", "opens by three right permits", OpensByThreePermits},
    {"output", "a wrong permit closes", WrongPermitCloses},
    {"output", "interrupted, stays closed", InterruptedStaysClosed},
    {"output", "closes by itself", ClosesByItself},
    {"output", "closed once the watchdog has tripped", ClosedOnceTripped},
    {"cut-off", "pins are read back", PinsAreReadBack},
    {"cut-off", "low, and stays low", CutOffIsFinal}};

/// Calls that no check can do without.
[[nodiscard]] bool HasBench(const PortBench& bench) noexcept
{
    const bool has_bus = (bench.next != nullptr) && (bench.peer_send != nullptr);
    const bool has_time = (bench.pass != nullptr) && (bench.restart != nullptr);
    return has_bus && has_time && (bench.pins != nullptr);
}

[[nodiscard]] bool HasNumbers(const PortNumbers& numbers) noexcept
{
    const bool has_times = (numbers.cycle_us != 0U) && (numbers.frame_us != 0U);
    return has_times && (numbers.receive_room < 1000U) && (numbers.transmit_room < 250U);
}

void WriteCount(const PortBench& bench, const std::uint32_t count, const char* const what) noexcept
{
    WriteNumber(bench, count);
    bench.write(bench.bench, what);
}

} // namespace

ContractCount RunContractTest(const PortUnderTest& port) noexcept
{
    ContractCount count{0U, 0U, 0U};
    const bool is_usable = HasBench(port.bench) && HasNumbers(port.numbers);
    Check table{port.bench, "table", "complete"};
    table.Equal("calls that are needed, cycle and frame not 0, rooms as the header says", 1U, is_usable ? 1U : 0U);
    table.End(count);
    if (is_usable)
    {
        for (const CheckRow& row : kRows)
        {
            Check check{port.bench, row.part, row.name};
            row.body(port, check);
            check.End(count);
        }
    }
    WriteCount(port.bench, count.held, " held, ");
    WriteCount(port.bench, count.broken, " broken, ");
    WriteCount(port.bench, count.not_shown, " not shown\n");
    return count;
}

} // namespace counterpoint::hal::contract
