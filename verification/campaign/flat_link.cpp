// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/flat_link.hpp"

#include "verification/campaign/variants.hpp"

#include <algorithm>

namespace counterpoint::campaign
{
void FlatLink::Send(const std::size_t from, const hal::LinkFrame& message, const std::int64_t now,
                    const Experiment* const fault, const std::size_t turn) noexcept
{
    Way& way = ways_.at(from);
    const std::int64_t at = now + delay_ns;
    if (fault == nullptr)
    {
        Depart(way, message, at);
        return;
    }
    const std::int64_t later = at + (kGrid * (std::int64_t{fault->variant} + 1));
    hal::LinkFrame changed = message;
    if (fault->kind == FaultKind::kLost && fault->variant != kLosesLink && turn > fault->variant)
    {
        Depart(way, message, at);
    }
    else if (fault->kind == FaultKind::kRepeated || fault->kind == FaultKind::kDelayed)
    {
        const bool is_now = fault->kind == FaultKind::kRepeated || turn != 0U;
        if (is_now)
        {
            Depart(way, message, at);
        }
        if (turn == 0U)
        {
            Depart(way, message, later);
        }
    }
    else if (fault->kind == FaultKind::kWrongOrder)
    {
        SendBehind(way, message, at, {turn, fault->variant});
    }
    else if (fault->kind == FaultKind::kCorrupted)
    {
        if (turn == 0U && fault->variant / 8U < message.length)
        {
            std::uint8_t& byte = changed.bytes[fault->variant / 8U];
            byte = static_cast<std::uint8_t>(byte ^ (1U << (fault->variant % 8U)));
        }
        Depart(way, changed, at);
    }
    else
    {
        // It is lost.
    }
}

/// The first one waits until so many others went.
void FlatLink::SendBehind(Way& way, const hal::LinkFrame& message, const std::int64_t at, const Wait& wait) noexcept
{
    if (wait.turn == 0U)
    {
        way.held = message;
        way.has_held = true;
        return;
    }
    Depart(way, message, at);
    if (way.has_held && wait.turn > wait.others)
    {
        Depart(way, way.held, at);
        way.held = {};
        way.has_held = false;
    }
}

void FlatLink::Depart(Way& way, const hal::LinkFrame& message, const std::int64_t at) noexcept
{
    if (way.count == kMostFlights)
    {
        return; // A wire that is full loses it.
    }
    auto* const end = way.flights.begin() + way.count;
    auto* const place = std::upper_bound(way.flights.begin(), end, at,
                                         [](const std::int64_t time, const Flight& each) { return time < each.at; });
    std::copy_backward(place, end, end + 1);
    *place = Flight{at, message};
    ++way.count;
}

const Flight* FlatLink::Next(const std::size_t to, const std::int64_t until) const noexcept
{
    const Way& way = ways_.at(1U - to);
    return (way.count != 0U && way.flights.front().at <= until) ? &way.flights.front() : nullptr;
}

void FlatLink::Drop(const std::size_t to) noexcept
{
    Way& way = ways_.at(1U - to);
    std::copy(way.flights.begin() + 1, way.flights.begin() + way.count, way.flights.begin());
    --way.count;
    way.flights.at(way.count) = {};
}
} // namespace counterpoint::campaign
