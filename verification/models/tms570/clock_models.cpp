// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/models/tms570/clock_models.hpp"

#include "hal/tms570/chip/system_registers.hpp"
#include "hal/tms570/time/clock_comparator.hpp"

namespace counterpoint::tms570::model
{

namespace
{

constexpr std::uint32_t kComparatorChannel = 30U;
constexpr std::uint64_t kNsPerUs = 1000U;
constexpr std::uint64_t kLockNs = 400'000U;
constexpr std::uint64_t kInitNs = 20'000U;

} // namespace

DccModel::DccModel(const FaultSet& faults, EsmModel& esm, const ClockTree& clocks)
    : Peripheral(faults), esm_(esm), clocks_(clocks)
{
}

std::uint32_t DccModel::Read(const std::uint32_t offset)
{
    return ((offset == dcc::kControl) && Has(Fault::kDccTurnedOff)) ? dcc::kOff : Kept(offset);
}

void DccModel::Write(const std::uint32_t offset, const std::uint32_t value)
{
    if (offset == dcc::kStatus)
    {
        Kept(offset) &= ~value;
        return;
    }
    Kept(offset) = value;
    if (offset == dcc::kControl)
    {
        left_ns_ = (value == dcc::kOff) ? 0U : ((dcc::kCycles * kNsPerUs) / clocks_.oscillator_mhz);
    }
}

void DccModel::Compare()
{
    const std::uint64_t first = Kept(dcc::kSeed0);
    const std::uint64_t last = first + Kept(dcc::kValid0);
    const bool is_wrong = Has(Fault::kDccWrongClock) || Has(Fault::kDccClockDrifts);
    const std::uint64_t real_mhz10 = clocks_.processor_mhz * (is_wrong ? 9U : 10U);
    // Cycles of the oscillator when counter 1 has run down.
    const std::uint64_t cycles =
        (static_cast<std::uint64_t>(Kept(dcc::kSeed1)) * clocks_.oscillator_mhz * 10U) / real_mhz10;
    const bool is_good = (cycles >= first) && (cycles <= last);
    Kept(dcc::kStatus) |= is_good ? dcc::kDone : dcc::kError;
    if (!is_good)
    {
        esm_.Raise(1U, kComparatorChannel);
    }
}

void DccModel::Advance(const std::uint64_t ns)
{
    if ((left_ns_ == 0U) || Has(Fault::kDccEndless))
    {
        return;
    }
    left_ns_ -= (ns < left_ns_) ? ns : left_ns_;
    if (left_ns_ == 0U)
    {
        Compare();
        const bool goes_on = Kept(dcc::kControl) == dcc::kForEver;
        left_ns_ = goes_on ? ((dcc::kCycles * kNsPerUs) / clocks_.oscillator_mhz) : 0U;
    }
}

using namespace system_module;

constexpr std::uint32_t kSourcesOffAfterReset = 0xCAU;

SystemModel::SystemModel(const FaultSet& faults, const SystemBits& bits) : Peripheral(faults), bits_(bits)
{
    Kept(kSourcesOff) = kSourcesOffAfterReset | bits_.sources_always_off;
    Kept(kResetStatus) = kResetPowerOn;
}

void SystemModel::SetReset(const std::uint32_t bits)
{
    Kept(kResetStatus) |= bits;
}

void SystemModel::EndMemoryTest()
{
    Kept(kTestStatus) |= kTestDone;
}

std::uint32_t SystemModel::Read(const std::uint32_t offset)
{
    if (offset == kSourcesValid)
    {
        const bool is_locked = (lock_left_ns_ == 0U) && !Has(Fault::kPllNeverLocks);
        const std::uint32_t running = ~Kept(kSourcesOff) & 0xFFU;
        const std::uint32_t invalid = (is_locked ? 0U : kPllBit) | (Has(Fault::kOscillatorFails) ? kOscillatorBit : 0U);
        return running & ~invalid;
    }
    if (offset == kGlobalStatus)
    {
        return Kept(offset) | (Has(Fault::kPllSlips) ? 0x100U : 0U);
    }
    return Kept(offset);
}

void SystemModel::Write(const std::uint32_t offset, const std::uint32_t value)
{
    switch (offset)
    {
    case kSourcesOffSet:
        Kept(kSourcesOff) |= value;
        break;
    case kSourcesOff:
        lock_left_ns_ = kLockNs;
        Kept(offset) = value | bits_.sources_always_off;
        break;
    case kRtiSource:
        Kept(offset) = value & bits_.rti_source_kept;
        break;
    case kResetStatus:
    case kGlobalStatus:
    case kTestStatus:
        Kept(offset) &= ~value;
        break;
    case kInitEnable:
        init_left_ns_ = (Kept(kInitControl) == kKeyOn) ? kInitNs : 0U;
        Kept(offset) = value;
        break;
    case kMainSource:
        Kept(offset) = Has(Fault::kClockWriteLost) ? 0U : value;
        break;
    default:
        Kept(offset) = value;
        break;
    }
}

void SystemModel::Advance(const std::uint64_t ns)
{
    lock_left_ns_ -= (ns < lock_left_ns_) ? ns : lock_left_ns_;
    if ((init_left_ns_ == 0U) || Has(Fault::kMemoryInitEndless))
    {
        return;
    }
    init_left_ns_ -= (ns < init_left_ns_) ? ns : init_left_ns_;
    if (init_left_ns_ == 0U)
    {
        Kept(kTestStatus) |= kInitDone;
    }
}

} // namespace counterpoint::tms570::model
