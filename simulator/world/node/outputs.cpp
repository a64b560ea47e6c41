// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/world/node/outputs.hpp"

#include "runtime/device/assembly.hpp"

#include <algorithm>
#include <utility>

namespace counterpoint::simulator
{
NodeOutputs::NodeOutputs(const NodePlace& place, const runtime::DeviceModel& model, const NodePairs& pairs,
                         PartFaults& faults)
    : place_(place), model_(model), pairs_(pairs), watchdog_(place.bus),
      output_(place.bus, watchdog_, {model.Config().cycle_us + model.Config().cycle_tolerance_us}),
      output_tap_(output_, faults), watchdog_tap_(watchdog_, faults)
{
}

hal::SafetyOutput& NodeOutputs::Output() noexcept
{
    return place_.is_tapped ? static_cast<hal::SafetyOutput&>(output_tap_) : output_;
}

hal::Watchdog& NodeOutputs::Supervision() noexcept
{
    return place_.is_tapped ? static_cast<hal::Watchdog&>(watchdog_tap_) : watchdog_;
}

void NodeOutputs::Start()
{
    watchdog_.Start(runtime::WindowOf(model_.Config()));
    was_alive_ = true;
}

void NodeOutputs::Look(const Nanoseconds cycle_time)
{
    if (const SrdoMask open = output_.Open(); open != open_)
    {
        NoteOpen(open);
    }
    if (!place_.is_tapped)
    {
        return;
    }
    const Nanoseconds served = watchdog_tap_.Keep(place_.Now(), cycle_time);
    const bool is_alive = watchdog_.IsAlive();
    if (std::exchange(was_alive_, is_alive) && !is_alive)
    {
        place_.Note(EventKind::kWatchdog, 0U, 0U, 0U);
    }
    look_at_ = std::min({output_.ClosesAt(), watchdog_.TripsAt(), served});
}

void NodeOutputs::NoteOpen(const SrdoMask open)
{
    const SrdoMask changed = open ^ std::exchange(open_, open);
    for (SlotIndex slot = 0U; changed != 0U && slot < model_.Config().srdo_count; ++slot)
    {
        if (((changed >> slot) & 1U) != 0U)
        {
            const PairTimes& times = pairs_.TimesOf(slot);
            const std::uint64_t is_open = (open >> slot) & 1U;
            // What closes is no pair that came since the last cycle: it was not released.
            const Nanoseconds since = (is_open != 0U) ? times.last_good_normal : times.judged_normal;
            const BehindPair& behind = (is_open != 0U) ? times.behind_good : times.behind_judged;
            place_.journal.Note({place_.Now(), EventKind::kOutput, place_.index, model_.NumberOf(slot), is_open, 0U,
                                 since, behind.next_normal, behind.wrong_inverse});
        }
    }
}

void NodeOutputs::Close()
{
    NoteOpen(0U);
    look_at_ = kNever;
}

} // namespace counterpoint::simulator
