// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/world/node.hpp"

// Which parts a node has, and what it does as one CPU of two. [SRS_SIM_056]
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

bool Node::IsTapped() const noexcept
{
    return place_.insight == Insight::kTapped;
}

Channel& Node::RealChannel(const runtime::Letter letter) noexcept
{
    if (IsTapped())
    {
        return (letter == runtime::Letter::kA) ? tap_a_ : tap_b_;
    }
    return (letter == runtime::Letter::kA) ? channel_a_->Voice() : channel_b_->Voice();
}

Channel& Node::VoiceOf(const runtime::Letter letter) noexcept
{
    if (peer_ == nullptr)
    {
        return RealChannel(letter);
    }
    return (letter == runtime::Letter::kA) ? peer_->VoiceA() : peer_->VoiceB();
}

hal::SafetyOutput& Node::Output() noexcept
{
    return IsTapped() ? static_cast<hal::SafetyOutput&>(output_tap_) : output_;
}

hal::Watchdog& Node::Supervision() noexcept
{
    return IsTapped() ? static_cast<hal::Watchdog&>(watchdog_tap_) : watchdog_;
}

void Node::Join(LinkWire& wire) noexcept
{
    wire_ = &wire;
}

// A CPU of two has one counter: the second one is the other CPU's.
InstantPair Node::Instants() noexcept
{
    const InstantPair now = clocks_.Now();
    return (peer_ == nullptr) ? now : InstantPair{now.a, now.a};
}

StampedFrame Node::Stamped(const StampedFrame& frame) const noexcept
{
    StampedFrame stamped = frame;
    stamped.stamp.b = (peer_ == nullptr) ? frame.stamp.b : frame.stamp.a;
    return stamped;
}

void Node::TakeMessage(const hal::LinkFrame& frame)
{
    if (is_hung_ || !is_on_)
    {
        return;
    }
    Guarded(
        [this, &frame]()
        {
            RequireSound();
            peer_->OnMessage(frame, Instants().a);
        });
}

// As the contract of Peer has it; messages and frames came before.
void Node::RunKernel(const CycleCall& call)
{
    if (peer_ != nullptr && peer_->Examine(call.now.a) != LinkFinding::kNone)
    {
        assembly_.Core().OnCrossLinkFault();
    }
    assembly_.Device().Cycle(call);
    if (peer_ != nullptr)
    {
        RequireSound();
        hal::LinkFrame message{};
        peer_->Compose({call.now.a, assembly_.Core().DeviceState().fault}, message);
        wire_->Send(place_.index, message, Now());
    }
}

void Node::TellLink()
{
    if (peer_ == nullptr || peer_->Link().State() == shown_link_)
    {
        return;
    }
    shown_link_ = peer_->Link().State();
    journal_.Tell({Now(), EventKind::kLink, place_.index, 0U, static_cast<std::uint64_t>(shown_link_),
                   static_cast<std::uint64_t>(peer_->Link().Finding())});
}
} // namespace counterpoint::simulator
