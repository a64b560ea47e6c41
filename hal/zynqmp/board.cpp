// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/zynqmp/board.hpp"

#include "hal/zynqmp/output/cut_off.hpp"

namespace counterpoint::zynqmp
{

Board::Board(const BoardParts& parts) noexcept : parts_(parts), can_(parts.counters)
{
}

StartReport Board::Start(const BoardSetup& setup) noexcept
{
    StartReport report{Outcome::kDone, StartStep::kCounters};
    fault_ = BoardFault::kInvalid;
    is_watched_ = false;
    for (std::uint8_t number = 0U; (number < kStartSteps) && (report.outcome == Outcome::kDone); ++number)
    {
        report.last = static_cast<StartStep>(number);
        report.outcome = Do(report.last, setup);
    }
    if (report.outcome == Outcome::kDone)
    {
        fault_ = BoardFault::kNone;
    }
    else
    {
        EnterSafeState(BoardFault::kStart);
    }
    return report;
}

Outcome Board::Do(const StartStep step, const BoardSetup& setup) noexcept
{
    switch (step)
    {
    case StartStep::kCounters:
        return parts_.counters.Start(setup.counters);
    case StartStep::kPins:
        return parts_.output.Start();
    case StartStep::kProtection:
        return mpu_.Start(setup.protection);
    case StartStep::kCan:
        return (can_.Start(setup.can) == CanFault::kNone) ? Outcome::kDone : Outcome::kFailed;
    }
    return Outcome::kFailed;
}

Outcome Board::StartWatchdog() noexcept
{
    const bool may_start = fault_ == BoardFault::kNone;
    const Outcome outcome = may_start ? parts_.watchdog.Start() : Outcome::kFailed;
    is_watched_ = outcome == Outcome::kDone;
    Note(outcome, BoardFault::kWatchdog);
    return outcome;
}

BoardFault Board::BeginCycle() noexcept
{
    if (fault_ == BoardFault::kNone)
    {
        Note(parts_.counters.Examine(), BoardFault::kCounters);
        static_cast<void>(can_.Look());
        Note((can_.OnCycle() == CanFault::kNone) ? Outcome::kDone : Outcome::kFailed, BoardFault::kCan);
        Note(parts_.output.Examine(), BoardFault::kPins);
        Note(mpu_.Examine(), BoardFault::kProtection);
        Note(is_watched_ ? parts_.watchdog.Examine() : Outcome::kDone, BoardFault::kWatchdog);
    }
    return fault_;
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
    parts_.output.CutOff();
    can_.Stop();
    CutOffEverything();
    const bool is_first = (fault_ == BoardFault::kNone) || (fault_ == BoardFault::kInvalid);
    fault_ = is_first ? fault : fault_;
}

} // namespace counterpoint::zynqmp
