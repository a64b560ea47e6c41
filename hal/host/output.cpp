// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/output.hpp"

#include <algorithm>

namespace counterpoint::host
{

HostOutput::HostOutput(const VirtualBus& bus, HostWatchdog& watchdog, const hal::GateLimit& limit)
    : bus_(bus), watchdog_(watchdog), limit_(limit)
{
}

std::uint32_t HostOutput::Challenge() noexcept
{
    // It closes by itself in its time, whether somebody looks then or not.
    static_cast<void>(Open());
    return gate_.Challenge();
}

void HostOutput::Drive(const hal::PermitSet& permits) noexcept
{
    driven_us_ = bus_.Now() / kMicrosecond;
    watchdog_start_ = watchdog_.Starts();
    gate_.Drive(permits, Instant{static_cast<std::uint32_t>(driven_us_)});
}

hal::ProbeAnswer HostOutput::Probe(const hal::PermitSet& permits, const std::uint32_t challenge) const noexcept
{
    return hal::OutputGate::Probe(permits, challenge);
}

void HostOutput::CutOff() noexcept
{
    is_cut_off_ = true;
}

SrdoMask HostOutput::Open()
{
    const bool same_start = watchdog_.Starts() == watchdog_start_;
    if (!watchdog_.IsAlive() || !same_start || is_cut_off_)
    {
        gate_.Close();
    }
    return gate_.Open(Instant{static_cast<std::uint32_t>(bus_.Now() / kMicrosecond)}, limit_);
}

BusTime HostOutput::ClosesAt()
{
    if (Open() == 0U)
    {
        return kNever;
    }
    const BusTime gate_closes = (driven_us_ + limit_.us + 1) * kMicrosecond;
    return std::min(gate_closes, watchdog_.TripsAt());
}

} // namespace counterpoint::host
