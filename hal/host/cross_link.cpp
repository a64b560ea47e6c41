// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/cross_link.hpp"

#include <algorithm>

namespace counterpoint::host
{
namespace
{
constexpr std::uint32_t kMillion = 1'000'000U;
} // namespace

HostWire::HostWire(const std::uint64_t seed) : random_{seed}
{
    for (Side& side : ends_)
    {
        side.wire = this;
        side.incoming.reserve(16U);
    }
    ends_[0U].other = &ends_[1U];
    ends_[1U].other = &ends_[0U];
}

// SplitMix64.
std::uint32_t HostWire::Below(const std::uint32_t end) noexcept
{
    random_ += 0x9E3779B97F4A7C15U;
    std::uint64_t value = random_;
    value = (value ^ (value >> 30U)) * 0xBF58476D1CE4E5B9U;
    value = (value ^ (value >> 27U)) * 0x94D049BB133111EBU;
    value ^= value >> 31U;
    return static_cast<std::uint32_t>(((value >> 32U) * end) >> 32U);
}

bool HostWire::Happens(const std::uint32_t ppm) noexcept
{
    return (ppm != 0U) && (Below(kMillion) < ppm);
}

void HostWire::Carry(Side& from, const hal::LinkFrame& frame)
{
    const WireFaults& faults = from.faults;
    Flight flight{now_ + faults.shortest_us + Below((faults.longest_us - faults.shortest_us) + 1U), frame};
    if (Happens(faults.flip_ppm))
    {
        const std::uint32_t bits = 1U + Below(3U);
        for (std::uint32_t bit = 0U; bit < bits; ++bit)
        {
            const std::uint32_t place = Below(static_cast<std::uint32_t>(frame.length) * 8U);
            flight.frame.bytes[place / 8U] ^= static_cast<std::uint8_t>(1U << (place % 8U));
        }
    }
    std::vector<Flight>& incoming = from.other->incoming;
    const auto behind = std::upper_bound(incoming.begin(), incoming.end(), flight.arrives,
                                         [](LinkInstant at, const Flight& other) { return at < other.arrives; });
    incoming.insert(behind, flight);
}

hal::LinkStatus HostWire::Side::Send(const hal::LinkFrame& frame) noexcept
{
    if ((frame.length == 0U) || (frame.length > hal::kLinkFrameBytes))
    {
        return hal::LinkStatus::kNothing;
    }
    const bool may_lose = lost_in_a_row < faults.most_lost_in_a_row;
    if (faults.is_cut || (may_lose && wire->Happens(faults.loss_ppm)))
    {
        ++lost_in_a_row;
        return hal::LinkStatus::kDone;
    }
    lost_in_a_row = 0U;
    wire->Carry(*this, frame);
    if (wire->Happens(faults.repeat_ppm))
    {
        wire->Carry(*this, frame);
    }
    return hal::LinkStatus::kDone;
}

hal::LinkStatus HostWire::Side::Receive(hal::LinkFrame& frame) noexcept
{
    if (incoming.empty() || (incoming.front().arrives > wire->now_))
    {
        return hal::LinkStatus::kNothing;
    }
    frame = incoming.front().frame;
    arrived_at = incoming.front().arrives;
    incoming.erase(incoming.begin());
    return hal::LinkStatus::kDone;
}

} // namespace counterpoint::host
