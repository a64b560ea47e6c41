// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Counters of the RTI (reference manual, chapter RTI, "Counter operation"; facts/tms570 2, 4).
#include "hal/tms570/time/rti.hpp"

#include "hal/tms570/time/rti_registers.hpp"

namespace counterpoint::tms570
{

namespace
{

using namespace rti;

constexpr std::uint32_t kBothOn = kCounter0On | kCounter1On;
/// A look at a register takes some cycles of the bus; a microsecond has passed long before.
constexpr std::uint32_t kAdvanceLooks = 1000U;
/// What both must have advanced by, and how far apart they may be: started together, read one after the other.
constexpr std::uint32_t kAdvanceUs = 3U;
constexpr std::uint32_t kMostApartUs = 2U;

} // namespace

Outcome Rti::Start(const RtiClock clock) noexcept
{
    if (clock.mhz == 0U)
    {
        return Outcome::kFailed;
    }
    prescale_ = std::uint32_t{clock.mhz} - 1U;
    Outcome outcome = WriteChecked(At(kBase, kGlobalControl), 0U, kWholeWord);
    Write(At(kBase, kClearInterrupts), kAllInterrupts);
    outcome = Both(outcome, WriteChecked(At(kBase, kTimebaseControl), 0U, kWholeWord));
    outcome = Both(outcome, WriteChecked(At(kBase, kUpCounter0), 0U, kWholeWord));
    outcome = Both(outcome, WriteChecked(At(kBase, kUpCounter1), 0U, kWholeWord));
    outcome = Both(outcome, WriteChecked(At(kBase, kFreeCounter0), 0U, kWholeWord));
    outcome = Both(outcome, WriteChecked(At(kBase, kFreeCounter1), 0U, kWholeWord));
    outcome = Both(outcome, WriteChecked(At(kBase, kCompareUp0), prescale_, kWholeWord));
    outcome = Both(outcome, WriteChecked(At(kBase, kCompareUp1), prescale_, kWholeWord));
    outcome = Both(outcome, WriteChecked(At(kBase, kGlobalControl), kBothOn, kWholeWord));
    if (outcome != Outcome::kDone)
    {
        return Outcome::kFailed;
    }
    InstantPair now = Now();
    for (std::uint32_t look = 0U; (look < kAdvanceLooks) && ((now.a.us < kAdvanceUs) || (now.b.us < kAdvanceUs));
         ++look)
    {
        now = Now();
    }
    const bool both_run = (now.a.us >= kAdvanceUs) && (now.b.us >= kAdvanceUs);
    const std::uint32_t ahead = now.b.us - now.a.us;
    const bool are_together = (ahead + kMostApartUs) <= (2U * kMostApartUs);
    return (both_run && are_together) ? Outcome::kDone : Outcome::kFailed;
}

InstantPair Rti::Now() noexcept
{
    const std::uint32_t a = Read(At(kBase, kFreeCounter0));
    const std::uint32_t b = Read(At(kBase, kFreeCounter1));
    return InstantPair{Instant{a}, Instant{b}};
}

Outcome Rti::Examine() const noexcept
{
    const bool is_on = Read(At(kBase, kGlobalControl)) == kBothOn;
    const bool same_0 = Read(At(kBase, kCompareUp0)) == prescale_;
    const bool same_1 = Read(At(kBase, kCompareUp1)) == prescale_;
    return (is_on && same_0 && same_1) ? Outcome::kDone : Outcome::kFailed;
}

} // namespace counterpoint::tms570
