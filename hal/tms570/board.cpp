// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/tms570/board.hpp"

#include "hal/tms570/diagnosis/lockstep.hpp"
#include "hal/tms570/output/cut_off.hpp"
#include "hal/tms570/time/clock_comparator.hpp"

namespace counterpoint::tms570
{

namespace
{

/// Requests that one interrupt serves; what is left raises the next one.
constexpr std::uint32_t kMostRequests = 4U;
/// Drivers whose set-up is compared in turn, one a cycle.
constexpr std::uint32_t kTurns = 8U;

[[nodiscard]] StepResult ResultOf(const Outcome outcome) noexcept
{
    return (outcome == Outcome::kDone) ? StepResult::kPassed : StepResult::kFailed;
}

[[nodiscard]] bool IsThere(const Presence presence) noexcept
{
    return presence == Presence::kPresent;
}

} // namespace

Board::Board() noexcept : can_(rti_), pins_(rti_)
{
}

StartReport Board::Start(const BoardSetup& setup) noexcept
{
    StartReport report{};
    fault_.Store(BoardFault::kInvalid);
    is_watched_ = false;
    turn_ = 0U;
    has_comparator_ = setup.variant.clock_comparator;
    table_check_ = setup.variant.table_check;
    comparators_ = setup.variant.comparators;
    rti_source_ = setup.variant.system.rti_source;
    report.answer = StartAnswer::kStarted;
    report.reason = ReadResetReason();
    for (std::uint8_t number = 0U; (number < kStartSteps) && (report.answer == StartAnswer::kStarted); ++number)
    {
        report.last = static_cast<StartStep>(number);
        const StepResult result = Do(report.last, setup);
        report.steps[number] = result;
        const bool is_good = (result == StepResult::kPassed) || (result == StepResult::kAbsent);
        const StartAnswer other =
            (result == StepResult::kResetComes) ? StartAnswer::kResetComes : StartAnswer::kRefused;
        report.answer = is_good ? StartAnswer::kStarted : other;
    }
    report.logic_test = static_cast<std::uint8_t>(logic_test_);
    if (report.answer == StartAnswer::kStarted)
    {
        fault_.Store(BoardFault::kNone);
    }
    else
    {
        EnterSafeState(BoardFault::kStart);
        can_.Stop();
        CutOffEverything();
    }
    if (report.answer != StartAnswer::kResetComes)
    {
        ClearResetReason(report.reason);
    }
    return report;
}

StepResult Board::Do(const StartStep step, const BoardSetup& setup) noexcept
{
    const Variant& variant = setup.variant;
    switch (step)
    {
    case StartStep::kColdErrors:
        return ResultOf(esm_.ExamineCold());
    case StartStep::kClocks:
        return ResultOf(StartClocks(variant.clocks, variant.system));
    case StartStep::kLogicTest:
        return DoLogicTest();
    case StartStep::kLockstep:
        return ResultOf(Lockstep::Test(comparators_));
    case StartStep::kMemoryTest:
        return ResultOf(TestMemories(variant.memories));
    case StartStep::kMemoryInit:
        return ResultOf(InitialiseMemories(variant.memories));
    case StartStep::kRamEcc:
        return TestRam(setup);
    case StartStep::kFlashEcc:
        return IsThere(variant.flash_diagnosis) ? ResultOf(TestFlashEcc()) : StepResult::kAbsent;
    case StartStep::kTableParity:
        return ResultOf(Interrupts::TestTable(table_check_));
    case StartStep::kErrorPin:
        return ResultOf(esm_.TestErrorPin());
    case StartStep::kClockComparator:
        return IsThere(has_comparator_) ? ResultOf(ClockComparator::Start(variant.clocks)) : StepResult::kAbsent;
    case StartStep::kCounters:
        return ResultOf(rti_.Start(RtiClock{variant.clocks.rti_mhz}));
    case StartStep::kPins:
        return ResultOf(pins_.Start(setup.pins));
    case StartStep::kProtection:
        return ResultOf(mpu_.Start(setup.protection));
    case StartStep::kInterrupts:
        return ResultOf(Interrupts::Start(table_check_));
    case StartStep::kEsm:
        return ResultOf(esm_.Start());
    case StartStep::kWatchdogPlan:
        return PlanTheWatchdog(setup);
    case StartStep::kCan:
        return StartCan(setup);
    }
    return StepResult::kFailed;
}

StepResult Board::TestRam(const BoardSetup& setup) noexcept
{
    if (IsThere(setup.variant.tcram_test))
    {
        return ResultOf(TestRamEcc(setup.ecc_place));
    }
    return IsThere(setup.variant.level_2_ram) ? ResultOf(TestLevel2Ram()) : StepResult::kAbsent;
}

StepResult Board::DoLogicTest() noexcept
{
    logic_test_ = ContinueLogicTest(ReadResetReason());
    if (logic_test_ == LogicTest::kResetComes)
    {
        return StepResult::kResetComes;
    }
    return (logic_test_ == LogicTest::kPassed) ? StepResult::kPassed : StepResult::kFailed;
}

StepResult Board::PlanTheWatchdog(const BoardSetup& setup) noexcept
{
    watchdog_plan_ = PlanWatchdog(setup.watchdog, RtiClock{setup.variant.clocks.rti_mhz}, setup.latest_open_us);
    watchdog_plan_.has_window = setup.variant.windowed_watchdog;
    return ResultOf(watchdog_plan_.outcome);
}

StepResult Board::StartCan(const BoardSetup& setup) noexcept
{
    CanPortsSetup can = setup.can;
    can.first.base = setup.variant.dcan[0U];
    can.second.base = setup.variant.dcan[1U];
    can.first.object_room = setup.variant.can_objects;
    can.second.object_room = setup.variant.can_objects;
    return (can_.Start(can) == CanFault::kNone) ? StepResult::kPassed : StepResult::kFailed;
}

Outcome Board::StartWatchdog() noexcept
{
    const bool may_start = Fault() == BoardFault::kNone;
    const Outcome outcome = may_start ? watchdog_.Start(watchdog_plan_) : Outcome::kFailed;
    is_watched_ = outcome == Outcome::kDone;
    Note(outcome, BoardFault::kWatchdog);
    return outcome;
}

BoardFault Board::BeginCycle() noexcept
{
    if (Fault() != BoardFault::kNone)
    {
        can_.Stop();
        return Fault();
    }
    Note(esm_.Serve(), BoardFault::kEsm);
    Note((can_.OnCycle() == CanFault::kNone) ? Outcome::kDone : Outcome::kFailed, BoardFault::kCan);
    Note(pins_.Examine(), BoardFault::kPins);
    ExamineInTurn();
    if (Fault() != BoardFault::kNone)
    {
        can_.Stop();
    }
    return Fault();
}

void Board::ExamineInTurn() noexcept
{
    turn_ = (turn_ + 1U) % kTurns;
    switch (turn_)
    {
    case 0U:
        Note(Lockstep::Examine(comparators_), BoardFault::kLockstep);
        break;
    case 1U:
        Note(Interrupts::Examine(table_check_), BoardFault::kInterrupts);
        break;
    case 2U:
        Note(ExamineClocks(rti_source_), BoardFault::kClocks);
        break;
    case 3U:
        Note(IsThere(has_comparator_) ? ClockComparator::Examine() : Outcome::kDone, BoardFault::kClockComparator);
        break;
    case 4U:
        Note(rti_.Examine(), BoardFault::kCounters);
        break;
    case 5U:
        Note(is_watched_ ? watchdog_.Examine() : Outcome::kDone, BoardFault::kWatchdog);
        break;
    case 6U:
        Note(esm_.Examine(), BoardFault::kEsm);
        break;
    default:
        Note(mpu_.Examine(), BoardFault::kProtection);
        break;
    }
}

void Board::OnInterrupt() noexcept
{
    for (std::uint32_t request = 0U; request < kMostRequests; ++request)
    {
        switch (Interrupts::Next())
        {
        case InterruptRequest::kNone:
            return;
        case InterruptRequest::kDcan1:
        case InterruptRequest::kDcan2:
            can_.OnInterrupt();
            break;
        case InterruptRequest::kEsmLow:
            Note(esm_.Serve(), BoardFault::kEsm);
            break;
        case InterruptRequest::kEsmHigh:
        case InterruptRequest::kUnknown:
            EnterSafeState(BoardFault::kInterrupts);
            Interrupts::MaskAll();
            return;
        }
    }
}

void Board::OnFastInterrupt() noexcept
{
    // Whatever it is: the only fast request is an error with reaction safe state.
    const InterruptRequest request = Interrupts::NextFast();
    const Outcome served = esm_.Serve();
    EnterSafeState(((request == InterruptRequest::kEsmHigh) && (served == Outcome::kFailed)) ? BoardFault::kEsm
                                                                                             : BoardFault::kInterrupts);
}

void Board::Note(const Outcome outcome, const BoardFault fault) noexcept
{
    if (outcome != Outcome::kDone)
    {
        EnterSafeState(fault);
    }
}

void Board::EnterSafeState(const BoardFault fault) noexcept
{
    pins_.CutOff();
    ForceErrorPin();
    const BoardFault before = Fault();
    const bool is_first = (before == BoardFault::kNone) || (before == BoardFault::kInvalid);
    if (is_first)
    {
        fault_.Store(fault);
    }
}

} // namespace counterpoint::tms570
