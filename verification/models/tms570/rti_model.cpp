// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/models/tms570/rti_model.hpp"

#include "hal/tms570/time/rti_registers.hpp"

namespace counterpoint::tms570::model
{

namespace
{

using namespace rti;

constexpr std::uint32_t kWatchdogChannel = 24U;
constexpr std::uint64_t kNsPerUs = 1000U;

} // namespace

RtiModel::RtiModel(const FaultSet& faults, EsmModel& esm, const std::uint32_t mhz)
    : Peripheral(faults), esm_(esm), mhz_(mhz)
{
}

void RtiModel::Count(Counter& counter, const std::uint64_t cycles, const std::uint32_t compare)
{
    const std::uint64_t sum = counter.rest + cycles;
    counter.free += static_cast<std::uint32_t>(sum / (compare + 1U));
    counter.rest = sum % (compare + 1U);
}

void RtiModel::Advance(const std::uint64_t ns)
{
    rest_ += ns * mhz_;
    const std::uint64_t cycles = rest_ / kNsPerUs;
    rest_ %= kNsPerUs;
    const bool a_stands = Has(Fault::kCounterAStoppedAtStart) || Has(Fault::kCounterAStops);
    if (((Kept(kGlobalControl) & kCounter0On) != 0U) && !a_stands)
    {
        Count(counters_[0], cycles, Kept(kCompareUp0));
    }
    if (((Kept(kGlobalControl) & kCounter1On) != 0U) && !Has(Fault::kCounterBStoppedAtStart))
    {
        Count(counters_[1], Has(Fault::kCounterBFast) ? (2U * cycles) : cycles, Kept(kCompareUp1));
    }
    if (IsWatching() && !has_bitten_)
    {
        watched_cycles_ += cycles;
        if (watched_cycles_ > PeriodCycles())
        {
            Bite();
        }
    }
}

bool RtiModel::IsWatching()
{
    return Kept(kWatchdogControl) == kWatchdogOn;
}

std::uint64_t RtiModel::PeriodCycles()
{
    return (static_cast<std::uint64_t>(Kept(kWatchdogPreload)) + 1U) * kPreloadCycles;
}

void RtiModel::Bite()
{
    if (Kept(kWatchdogReaction) != kReactionInterrupt)
    {
        has_bitten_ = true;
    }
    else
    {
        esm_.Raise(2U, kWatchdogChannel);
    }
}

void RtiModel::TakeKey(const std::uint32_t key)
{
    if (!IsWatching())
    {
        return;
    }
    const std::uint32_t expected = first_key_seen_ ? kKeySecond : kKeyFirst;
    if (key != expected)
    {
        Bite();
        return;
    }
    first_key_seen_ = !first_key_seen_;
    if (first_key_seen_)
    {
        return;
    }
    std::uint32_t size = 0U;
    const bool has_window = Kept(kWatchdogWindow) != 0U;
    while (has_window && (size < kWindowSizes) && ((kWindowFull << (kWindowStepBits * size)) != Kept(kWatchdogWindow)))
    {
        ++size;
    }
    const std::uint64_t closed = PeriodCycles() - (PeriodCycles() >> size);
    if (watched_cycles_ < closed)
    {
        Bite();
    }
    watched_cycles_ = 0U;
}

std::uint32_t RtiModel::Read(const std::uint32_t offset)
{
    switch (offset)
    {
    case kFreeCounter0:
        return counters_[0].free;
    case kFreeCounter1:
        return counters_[1].free;
    case kCompareUp1:
        return Kept(offset) ^ (Has(Fault::kCounterSetUpChanged) ? 1U : 0U);
    case kWatchdogControl:
        return Has(Fault::kWatchdogOff) ? 0U : Kept(offset);
    default:
        return Kept(offset);
    }
}

void RtiModel::Write(const std::uint32_t offset, const std::uint32_t value)
{
    switch (offset)
    {
    case kFreeCounter0:
        counters_[0] = Counter{0U, value};
        break;
    case kFreeCounter1:
        counters_[1] = Counter{0U, value};
        break;
    case kWatchdogKey:
        last_key_ = value;
        TakeKey(value);
        break;
    case kWatchdogControl:
        // Once on, only a reset turns it off.
        if (!IsWatching() && !Has(Fault::kWatchdogNotEnabled))
        {
            Kept(offset) = value;
            watched_cycles_ = 0U;
        }
        break;
    case kWatchdogPreload:
        Kept(offset) = Has(Fault::kWatchdogPeriodLost) ? kMostPreload : value;
        break;
    case kWatchdogReaction:
        Kept(offset) = Has(Fault::kWatchdogReactionLost) ? kReactionInterrupt : value;
        break;
    case kWatchdogWindow:
        Kept(offset) = Has(Fault::kWatchdogWindowLost) ? kWindowFull : value;
        break;
    default:
        Kept(offset) = value;
        break;
    }
}

} // namespace counterpoint::tms570::model
