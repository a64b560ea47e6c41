// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/world/link_wire.hpp"

#include <algorithm>

namespace counterpoint::simulator
{
namespace
{
constexpr std::uint64_t kWireSalt = 0x11CE0000U; ///< Far apart from the numbers of other faults.
constexpr std::uint32_t kMillion = 1000000U;
constexpr std::size_t kRemembered = 64U;
constexpr std::uint32_t kByteValues = 256U;
} // namespace

LinkWire::LinkWire(const Scenario& scenario, const NodeIndex first, Journal& journal)
    : scenario_(scenario), first_(first), teller_(journal, EventKind::kLinkMessage),
      random_(scenario.seed + kWireSalt + first)
{
    for (std::size_t index = 0U; index < scenario.faults.size(); ++index)
    {
        const FaultSetup& fault = scenario.faults[index];
        const LinkFault* const kind = std::get_if<LinkFault>(&fault.kind);
        if (kind != nullptr && *kind != LinkFault::kInsertion && fault.node == first)
        {
            choosers_.push_back({index, first, {}});
            choosers_.push_back({index, first + 1U, {}});
        }
    }
}

NodeIndex LinkWire::Other(const NodeIndex node) const noexcept
{
    return (node == first_) ? first_ + 1U : first_;
}

LinkWire::Way& LinkWire::WayFrom(const NodeIndex sender) noexcept
{
    return ways_.at(sender - first_);
}

Nanoseconds LinkWire::Delay() noexcept
{
    const LinkSetup& link = scenario_.nodes[first_].link;
    // Drawn in any case, so that a fault does not shift the luck of what follows.
    const auto jitter_us = static_cast<std::uint32_t>(link.jitter / kNanosecondsPerMicrosecond);
    return link.delay + Nanoseconds{random_.Below(jitter_us + 1U)} * kNanosecondsPerMicrosecond;
}

bool LinkWire::Hits(Chooser& chooser, const Nanoseconds now)
{
    const FaultSetup& fault = scenario_.faults[chooser.fault];
    const FrameChoice& choice = fault.frames;
    const bool is_lucky = random_.Below(kMillion) < choice.probability_ppm;
    const bool is_sender = (chooser.sender == first_) ? fault.hits_from_a : fault.hits_from_b;
    const bool is_in_time = now >= fault.at && now < fault.until;
    return is_sender && is_in_time && IsOn(now, fault.at, fault.on, fault.off) && chooser.turns.Take(choice, is_lucky);
}

void LinkWire::Change(const FaultSetup& fault, const NodeIndex sender, std::vector<Flight>& flights)
{
    const std::vector<Flight> before = flights;
    switch (std::get<LinkFault>(fault.kind))
    {
    case LinkFault::kDelay:
        for (Flight& flight : flights)
        {
            flight.at += fault.by;
        }
        return;
    case LinkFault::kRepetition:
        for (std::uint32_t copy = 1U; copy <= fault.times && !before.empty(); ++copy)
        {
            flights.push_back({before.front().at + fault.by * copy, before.front().arrival});
        }
        return;
    case LinkFault::kCorruption:
        for (Flight& flight : flights)
        {
            for (const std::uint32_t bit : fault.message_bits)
            {
                std::uint8_t& byte = flight.arrival.frame.bytes[bit / 8U];
                byte = static_cast<std::uint8_t>(byte ^ (1U << (bit % 8U)));
            }
        }
        return;
    case LinkFault::kReordering:
        // With one that waits, this is the one that it comes after.
        if (WayFrom(sender).held.empty() && !flights.empty())
        {
            WayFrom(sender).held.push_back(flights.front().arrival);
            flights.clear();
        }
        return;
    case LinkFault::kLoss:
    case LinkFault::kCut:
        flights.clear();
        return;
    case LinkFault::kInsertion:
        return; // Changes no message; see Insert.
    }
}

void LinkWire::Depart(const Flight& flight)
{
    const auto behind = std::upper_bound(flights_.begin(), flights_.end(), flight.at,
                                         [](const Nanoseconds at, const Flight& other) { return at < other.at; });
    flights_.insert(behind, flight);
}

void LinkWire::Send(const NodeIndex sender, const hal::LinkFrame& frame, const Nanoseconds now)
{
    Way& way = WayFrom(sender);
    way.sent.push_front(frame);
    if (way.sent.size() > kRemembered)
    {
        way.sent.pop_back();
    }
    const std::vector<LinkArrival> waiting = way.held;
    const NodeIndex receiver = Other(sender);
    std::vector<Flight> flights{{now + Delay(), {receiver, frame}}};
    for (Chooser& chooser : choosers_)
    {
        if (chooser.sender == sender && Hits(chooser, now))
        {
            Change(scenario_.faults[chooser.fault], sender, flights);
            teller_.Tell(chooser.fault, receiver, 0U, now);
        }
    }
    if (flights.empty())
    {
        return;
    }
    for (const LinkArrival& late : waiting)
    {
        flights.push_back({flights.front().at, late});
    }
    way.held.erase(way.held.begin(), way.held.begin() + static_cast<std::ptrdiff_t>(waiting.size()));
    for (const Flight& flight : flights)
    {
        Depart(flight);
    }
}

void LinkWire::Insert(const std::size_t fault, const Nanoseconds now)
{
    const FaultSetup& setup = scenario_.faults[fault];
    for (const NodeIndex sender : {first_, first_ + 1U})
    {
        const bool is_meant = (sender == first_) ? setup.hits_from_a : setup.hits_from_b;
        const std::deque<hal::LinkFrame>& sent = WayFrom(sender).sent;
        if (!is_meant || (setup.back != 0U && sent.size() < setup.back))
        {
            continue;
        }
        LinkArrival arrival{Other(sender), {}};
        arrival.frame.length = hal::kLinkFrameBytes;
        for (std::uint8_t& byte : arrival.frame.bytes)
        {
            byte = static_cast<std::uint8_t>(random_.Below(kByteValues));
        }
        if (setup.back != 0U)
        {
            arrival.frame = sent[setup.back - 1U];
        }
        Depart({now, arrival});
        teller_.Tell(fault, arrival.receiver, 0U, now);
    }
}

Nanoseconds LinkWire::NextArrival() const noexcept
{
    return flights_.empty() ? kNever : flights_.front().at;
}

std::optional<LinkArrival> LinkWire::Take(const Nanoseconds now)
{
    if (NextArrival() > now)
    {
        return std::nullopt;
    }
    const LinkArrival arrival = flights_.front().arrival;
    flights_.pop_front();
    return arrival;
}
} // namespace counterpoint::simulator
