// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/start_up/cia302/boot_reset.hpp"

#include "canopen/start_up/cia302/boot_configuration.hpp"
#include "canopen/start_up/cia302/boot_identity.hpp"

namespace counterpoint::cia302
{

BootFinding BootReset::Work(const BootJob& job) noexcept
{
    return (job.record.state == BootState::kResetDue) ? Send(job) : AwaitBootUp(job);
}

BootFinding BootReset::Send(const BootJob& job) noexcept
{
    const bool is_taken = (parts_.nmt.Request(NmtCommand::kResetNode, job.node, job.time.now) == NmtAnswer::kTaken);
    return Found(is_taken ? BootEvent::kDone : BootEvent::kNone);
}

/// What follows if the boot-up message does not come.
BootFinding BootReset::AwaitBootUp(const BootJob& job) noexcept
{
    const BootState state = job.record.state;
    const bool is_unasked = ((state == BootState::kStateReset) && IsStateUnasked(job)) ||
                            ((state == BootState::kRestored) && IsRestoreUnasked(job));
    BootFinding finding = Found(BootEvent::kNone);
    if (is_unasked)
    {
        finding = Found(BootEvent::kSkip);
    }
    else if ((state == BootState::kUnheard) || !IsSilent(job))
    {
        // It is still waited for.
    }
    else if (state == BootState::kResetSent)
    {
        const bool is_called_for = job.setup.Has(kMandatory) || job.setup.Has(kKeepAlive);
        finding = Found(is_called_for ? BeginOf(job.setup) : BootEvent::kSilence);
    }
    else if (state == BootState::kStateReset)
    {
        job.record.is_fresh = true; // It is not reset a second time.
        finding = Found(BootEvent::kSilence);
    }
    else
    {
        job.record.status.abort = SdoAbort::kTimeOut;
        finding = Failed('J');
    }
    return finding;
}

/// No boot-up message in its time, which begins when the reset has left. The message has the lowest priority on the
/// bus: behind the SDOs of all other slaves.
bool BootReset::IsSilent(const BootJob& job) noexcept
{
    if (parts_.nmt.Waiting() != 0U)
    {
        job.record.since_us = job.time.clock_us;
    }
    const std::uint64_t slow_us = std::uint64_t{kCrowdedTimeOuts} * parts_.sdo.TimeOutUs();
    const std::uint64_t crowded_us = (slow_us > kCrowdedUs) ? slow_us : kCrowdedUs;
    return job.IsOver(kResetUs) && (!parts_.sdo.IsBusy() || job.IsOver(crowded_us));
}

} // namespace counterpoint::cia302
