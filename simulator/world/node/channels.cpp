// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/world/node/channels.hpp"

namespace counterpoint::simulator
{
namespace
{
std::uint32_t Microseconds(const Nanoseconds time)
{
    return static_cast<std::uint32_t>(time / kNanosecondsPerMicrosecond);
}
} // namespace

LinkConfig LinkConfigOf(const NodeSetup& setup)
{
    const LinkSetup& link = setup.link;
    return {(setup.role == runtime::CpuRole::kA) ? PeerRole::kA : PeerRole::kB, Microseconds(link.timeout),
            Microseconds(link.clock_tolerance), Microseconds(link.clock_interval), Microseconds(link.stamp_tolerance)};
}

NodeChannels::NodeChannels(const NodeSetup& setup, const runtime::DeviceModel& model, const ChannelTaps& taps,
                           hal::Watchdog& watchdog)
    : watchdog_(watchdog), channel_a_(runtime::MakeChannel(runtime::Letter::kA, runtime::RoomOf(model.Config()))),
      channel_b_(runtime::MakeChannel(runtime::Letter::kB, runtime::RoomOf(model.Config()))),
      tap_a_(channel_a_->Voice(), Part::kChannelA, taps.faults, taps.witness),
      tap_b_(channel_b_->Voice(), Part::kChannelB, taps.faults, taps.witness), is_tapped_(taps.witness != nullptr)
{
    if (setup.role != runtime::CpuRole::kWhole)
    {
        const runtime::Letter own = (setup.role == runtime::CpuRole::kA) ? runtime::Letter::kA : runtime::Letter::kB;
        peer_ = std::make_unique<counterpoint::Peer>(Real(own), watchdog, LinkConfigOf(setup));
    }
}

runtime::OwnedChannel& NodeChannels::Owned(const runtime::Letter letter) noexcept
{
    return (letter == runtime::Letter::kA) ? *channel_a_ : *channel_b_;
}

Channel& NodeChannels::Real(const runtime::Letter letter) noexcept
{
    if (is_tapped_)
    {
        return (letter == runtime::Letter::kA) ? tap_a_ : tap_b_;
    }
    return Owned(letter).Voice();
}

Channel& NodeChannels::Voice(const runtime::Letter letter) noexcept
{
    if (peer_ == nullptr)
    {
        return Real(letter);
    }
    return (letter == runtime::Letter::kA) ? peer_->VoiceA() : peer_->VoiceB();
}

hal::Watchdog& NodeChannels::Supervision() noexcept
{
    return (peer_ == nullptr) ? watchdog_ : peer_->Watchdog();
}
} // namespace counterpoint::simulator
