// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/networks/bus.hpp"

#include "hal/host/virtual/frame_bits.hpp"

#include <algorithm>
#include <limits>

namespace counterpoint::simulator
{
namespace
{
constexpr std::uint64_t kNsPerSecond = 1000000000U;
constexpr std::size_t kMostReceived = 4096U;
} // namespace

SimulatedPort::SimulatedPort(SimulatedBus& bus, const std::size_t owner) : bus_(bus), owner_(owner)
{
    bus_.ports_.push_back(this);
}

SimulatedPort::~SimulatedPort()
{
    bus_.ports_.erase(std::remove(bus_.ports_.begin(), bus_.ports_.end(), this), bus_.ports_.end());
    bus_.sender_ = (bus_.sender_ == this) ? nullptr : bus_.sender_;
}

host::SendResult SimulatedPort::Send(const host::LiveFrame& frame)
{
    host::SendResult result = host::SendResult::kSent;
    if (!host::IsSendable(frame))
    {
        result = host::SendResult::kRefused;
    }
    else if (waiting_.size() >= host::kLiveQueueFrames)
    {
        result = host::SendResult::kQueueFull;
    }
    else
    {
        waiting_.push_back(frame);
        bus_.Begin();
    }
    return result;
}

bool SimulatedPort::Receive(host::LiveFrame& frame)
{
    const bool has_one = !received_.empty();
    if (has_one)
    {
        frame = received_.front();
        received_.pop_front();
    }
    return has_one;
}

int SimulatedPort::Descriptor() const
{
    return -1;
}

host::BusHealth SimulatedPort::Health() const
{
    host::BusHealth health;
    health.state = host::BusState::kActive;
    return health;
}

std::string SimulatedPort::Name() const
{
    return "simulated";
}

bool SimulatedPort::Restart()
{
    return false;
}

SimulatedBus::SimulatedBus(const std::uint32_t bits_per_second) : bit_ns_(kNsPerSecond / bits_per_second)
{
}

std::uint64_t SimulatedBus::NextNs() const noexcept
{
    return is_busy_ ? end_ns_ : std::numeric_limits<std::uint64_t>::max();
}

/// Arbitration, if nobody sends.
void SimulatedBus::Begin()
{
    SimulatedPort* winner = nullptr;
    for (SimulatedPort* const port : ports_)
    {
        const bool wins = !port->waiting_.empty() && (winner == nullptr || port->waiting_.front().identifier <
                                                                               winner->waiting_.front().identifier);
        winner = wins ? port : winner;
    }
    if (!is_busy_ && winner != nullptr)
    {
        current_ = winner->waiting_.front();
        winner->waiting_.pop_front();
        sender_ = winner;
        owner_ = winner->owner_;
        begin_ns_ = now_ns_;
        is_busy_ = true;
        const host::FrameBits bits = host::MeasureFrame(host::ToCanFrame(current_, CanPortId::kFirst));
        end_ns_ = now_ns_ + bits.WithIntermission() * bit_ns_;
    }
}

void SimulatedBus::Advance(const std::uint64_t now_ns)
{
    now_ns_ = now_ns;
    if (is_busy_ && now_ns >= end_ns_)
    {
        is_busy_ = false;
        current_.time_ns = now_ns;
        if (tell_)
        {
            tell_(current_, begin_ns_, owner_);
        }
        for (SimulatedPort* const port : ports_)
        {
            if (port->received_.size() < kMostReceived)
            {
                port->received_.push_back(current_);
                port->received_.back().own = (port == sender_);
            }
        }
        sender_ = nullptr;
        Begin();
    }
}
} // namespace counterpoint::simulator
