// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/safe_state_latch.hpp"

namespace counterpoint
{
namespace
{

constexpr std::uint16_t kMostFaults = 65535U;

} // namespace

void SafeStateLatch::Arm() noexcept
{
    Disarm();
    word_ = kRunning;
    inverse_ = ~kRunning;
    report_.fault = DeviceFault::kNone;
}

void SafeStateLatch::Enter(const DeviceFault fault, const SlotIndex slot) noexcept
{
    if (fault == DeviceFault::kNone)
    {
        return;
    }
    if (IsRunning() || (report_.fault == DeviceFault::kNone))
    {
        report_.fault = fault;
        report_.slot = slot;
    }
    if (report_.count != kMostFaults)
    {
        ++report_.count;
    }
    word_ = kSafe;
    inverse_ = kSafe;
}

DeviceFaultReport SafeStateLatch::Report() const noexcept
{
    DeviceFaultReport report = report_;
    if (SaysRunning())
    {
        report.fault = DeviceFault::kNone; // Whatever the record says, nobody entered the safe state.
    }
    else if (report.fault == DeviceFault::kNone)
    {
        report.fault = DeviceFault::kInvalid; // Nor here: the latch itself is corrupted.
    }
    else
    {
        // The first fault.
    }
    return report;
}

} // namespace counterpoint
