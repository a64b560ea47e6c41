// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/tms570/time/clock_comparator.hpp"

namespace counterpoint::tms570
{

namespace
{

using namespace dcc;

/// 39 600 cycles of 16 MHz are 2.5 ms; a look takes 25 ns at the least.
constexpr Looks kCompareLooks{200000U};

} // namespace

Outcome ClockComparator::Start(const ClockTree& clocks) noexcept
{
    if (clocks.oscillator_mhz == 0U)
    {
        return Outcome::kFailed;
    }
    const std::uint32_t expected = (kCycles * clocks.processor_mhz) / clocks.oscillator_mhz;
    Write(At(kBase, kControl), kOff);
    Outcome outcome = WriteChecked(At(kBase, kSource0), kOscillator, kWholeWord);
    outcome = Both(outcome, WriteChecked(At(kBase, kSource1), kPll, kWholeWord));
    outcome = Both(outcome, WriteChecked(At(kBase, kSeed0), kCycles - (kTolerance / 2U), kWholeWord));
    outcome = Both(outcome, WriteChecked(At(kBase, kValid0), kTolerance, kWholeWord));
    outcome = Both(outcome, WriteChecked(At(kBase, kSeed1), expected, kWholeWord));
    Write(At(kBase, kStatus), kError | kDone);
    Write(At(kBase, kControl), kOnce);
    outcome = Both(outcome, WaitFor(At(kBase, kStatus), Bits{kError | kDone, kDone}, kCompareLooks));
    Write(At(kBase, kControl), kOff);
    Write(At(kBase, kStatus), kDone);
    Write(At(kBase, kControl), kForEver);
    return Both(outcome, Examine());
}

Outcome ClockComparator::Examine() noexcept
{
    const bool is_on = Read(At(kBase, kControl)) == kForEver;
    const bool is_good = (Read(At(kBase, kStatus)) & kError) == 0U;
    return (is_on && is_good) ? Outcome::kDone : Outcome::kFailed;
}

} // namespace counterpoint::tms570
