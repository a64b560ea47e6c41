// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/world/storm.hpp"

#include <algorithm>

namespace counterpoint::simulator
{
namespace
{
constexpr std::size_t kQueueCapacity = 64U;
constexpr std::uint32_t kEmergencies = 0x80U;

/// An emergency of somebody, eight zeros, or what is to be sent.
CanFrame FrameOf(const Action& action)
{
    CanFrame frame{};
    frame.kind = FrameKind::kData;
    frame.port = CanPortId::kFirst;
    frame.identifier = action.identifier;
    frame.length_bytes = kMaxPayloadBytes;
    if (action.kind == ActionKind::kEmcyStorm)
    {
        frame.identifier = kEmergencies + action.node_id;
        frame.data[0] = static_cast<std::uint8_t>(action.code & 0xFFU);
        frame.data[1] = static_cast<std::uint8_t>(action.code >> 8U);
        frame.data[2] = 1U;
    }
    if (action.kind == ActionKind::kSend)
    {
        frame.length_bytes = static_cast<std::uint8_t>(action.data.size());
        std::copy(action.data.begin(), action.data.end(), frame.data);
    }
    return frame;
}
} // namespace

Storm::Storm(const Action& action, host::VirtualBus& bus)
    : action_(action), bus_(bus), node_(bus.Attach(*this, host::NodeSetup{CanPortId::kFirst, kQueueCapacity})),
      next_(action.at)
{
    bus_.Disconnect(node_);
}

void Storm::Run(const Nanoseconds now)
{
    bus_.Connect(node_);
    static_cast<void>(bus_.Submit(node_, FrameOf(action_))); // A full queue, or one that is bus-off, drops it.
    const Nanoseconds next = now + action_.every;
    next_ = (next > action_.until) ? kNever : next;
}

void Storm::OnReceived(const CanFrame& /*frame*/, const host::BusTime /*at*/)
{
}

void Storm::OnConfirmed(const CanFrame& /*frame*/, const host::BusTime /*at*/)
{
}
} // namespace counterpoint::simulator
