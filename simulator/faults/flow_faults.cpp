// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/faults/flow_faults.hpp"

#include "simulator/faults/told.hpp"

namespace counterpoint::simulator
{
FlowFaults::FlowFaults(PartFaults& faults) noexcept : faults_(faults)
{
}

bool FlowFaults::Runs() noexcept
{
    return EffectiveAnswerOf(faults_, Part::kFlowMonitor) == PartAnswer::kOwn;
}

void FlowFaults::Begin() noexcept
{
    if (Runs())
    {
        monitor_.Begin();
    }
}

void FlowFaults::Mark(const FlowStep step, const FlowEvidence& evidence) noexcept
{
    if (Runs())
    {
        monitor_.Mark(step, evidence);
    }
}

hal::WatchdogAnswer FlowFaults::End(const hal::WatchdogQuestion& question) noexcept
{
    return Told(
        EffectiveAnswerOf(faults_, Part::kFlowMonitor), answer_, [&]() { return monitor_.End(question); },
        [&question]() { return hal::WatchdogAnswer{(hal::kFlowReference + question.value) * hal::kWatchdogConstant}; });
}

DeviceFault FlowFaults::Finding() const noexcept
{
    return monitor_.Finding();
}
} // namespace counterpoint::simulator
