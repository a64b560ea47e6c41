// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_task.hpp"

#include "rtos.hpp"

namespace rtos_task
{

namespace
{

using namespace counterpoint;

constexpr rtos::Tick kPeriod = 1U;
/// More than the queue holds: the loop ends though the bus never pauses.
constexpr std::uint32_t kMostEvents = 32U;

/// Hands over what the interrupt brought. Look and time belong together: whatever comes after the look that found the
/// queue empty has a later stamp than the `now` of this cycle.
InstantPair TakeFrames(const Surroundings& around)
{
    if (around.queue.TakeLoss())
    {
        around.device.OnLoss();
    }
    InstantPair now{};
    bool has_event = true;
    for (std::uint32_t taken = 0U; has_event && (taken < kMostEvents); ++taken)
    {
        BusEvent event{};
        rtos::EnterCritical();
        has_event = around.queue.Take(event);
        now = around.clocks.Now();
        rtos::ExitCritical();
        if (has_event && event.is_confirmation)
        {
            around.device.OnConfirm(event.frame);
        }
        else if (has_event)
        {
            around.device.OnFrame(event.frame);
        }
    }
    return now;
}

} // namespace

void InterruptQueue::PutFromInterrupt(const BusEvent& event) noexcept
{
    const std::uint32_t put = put_.load();
    if ((put - taken_.load()) >= kRoom)
    {
        has_lost_.store(true);
        return;
    }
    ring_[put % kRoom] = event;
    put_.store(put + 1U);
}

bool InterruptQueue::Take(BusEvent& event) noexcept
{
    const std::uint32_t taken = taken_.load();
    if (taken == put_.load())
    {
        return false;
    }
    event = ring_[taken % kRoom];
    taken_.store(taken + 1U);
    return true;
}

bool InterruptQueue::TakeLoss() noexcept
{
    return has_lost_.exchange(false);
}

void SafetyTask(void* const parts)
{
    SafetyTaskParts& task = *static_cast<SafetyTaskParts*>(parts);
    const Surroundings& around = task.surroundings;
    task.record.is_started = around.device.PowerOn(around.clocks.Now().a) == device::LoadResult::kLoaded;
    if (task.record.is_started)
    {
        around.start_watchdog();
    }
    rtos::Tick last = rtos::TickCount();
    for (;;)
    {
        task.record.late += rtos::DelayUntil(last, kPeriod) ? 0U : 1U;
        if (task.record.is_started)
        {
            const InstantPair now = TakeFrames(around);
            around.device.Cycle(CycleCall{now, around.acknowledge_a(), around.acknowledge_b()});
            ++task.record.cycles;
        }
        around.cycle_done();
    }
}

} // namespace rtos_task
