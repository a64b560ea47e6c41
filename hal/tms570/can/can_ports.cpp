// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The order of frames in different message objects is nowhere in the hardware. It is known as long as every look finds
// one object pending: the shortest frame takes 47 bit times, so the interrupt must come within that. Where it did not,
// the loss is told, and all consumers of the kernel become safe. [SRS_TMS_012]
#include "hal/tms570/can/can_ports.hpp"

namespace counterpoint::tms570
{

namespace
{

/// One interrupt serves at most this many requests; what is left raises the next one.
constexpr std::uint32_t kMostRequests = 8U;

} // namespace

CanPorts::CanPorts(hal::Clocks& clocks) noexcept : clocks_(clocks)
{
}

CanFault CanPorts::Start(const CanPortsSetup& setup) noexcept
{
    layout_ = setup.layout;
    queue_.Clear();
    const bool is_layout = (setup.layout == BusLayout::kOneController) || HasSecond();
    if (!is_layout)
    {
        return CanFault::kSetup;
    }
    const CanFault first = first_.Start(setup.first);
    const CanFault second = HasSecond() ? second_.Start(setup.second) : CanFault::kNone;
    return (first == CanFault::kNone) ? second : first;
}

hal::CanGuarantees CanPorts::Guarantees() const noexcept
{
    const hal::Guarantee all = (FirstFault() == CanFault::kNone) ? hal::Guarantee::kGiven : hal::Guarantee::kAbsent;
    return hal::CanGuarantees{all, all, all};
}

CanFault CanPorts::FirstFault() const noexcept
{
    if (layout_ == BusLayout::kInvalid)
    {
        return CanFault::kSetup;
    }
    const bool is_first = (first_.Fault() != CanFault::kNone) || !HasSecond();
    return is_first ? first_.Fault() : second_.Fault();
}

bool CanPorts::IsOrderKnown() const noexcept
{
    const PendingCount first = first_.Pending();
    const PendingCount second = HasSecond() ? second_.Pending() : PendingCount::kNone;
    const bool is_many = (first == PendingCount::kMany) || (second == PendingCount::kMany);
    const bool is_both = (first != PendingCount::kNone) && (second != PendingCount::kNone);
    const bool is_clash = is_both && (layout_ != BusLayout::kTwoBuses);
    return !is_many && !is_clash;
}

void CanPorts::OnInterrupt() noexcept
{
    for (std::uint32_t request = 0U; request < kMostRequests; ++request)
    {
        const bool first_asks = first_.IsAsking();
        const bool second_asks = HasSecond() && second_.IsAsking();
        if (!first_asks && !second_asks)
        {
            return;
        }
        const InstantPair stamp = clocks_.Now();
        if (!IsOrderKnown())
        {
            queue_.PutLoss();
        }
        if (first_asks)
        {
            Serve(first_, CanPortId::kFirst, stamp);
        }
        if (second_asks)
        {
            Serve(second_, CanPortId::kSecond, stamp);
        }
    }
}

void CanPorts::Serve(Dcan& controller, const CanPortId port, const InstantPair& stamp) noexcept
{
    DcanEvent event = controller.Take();
    event.frame.port = port;
    switch (event.kind)
    {
    case DcanEventKind::kReceivedAfterLoss:
        queue_.PutLoss();
        queue_.Put(QueuedFrame{QueuedKind::kReceived, StampedFrame{event.frame, stamp}});
        break;
    case DcanEventKind::kReceived:
        queue_.Put(QueuedFrame{QueuedKind::kReceived, StampedFrame{event.frame, stamp}});
        break;
    case DcanEventKind::kConfirmed:
        queue_.Put(QueuedFrame{QueuedKind::kConfirmed, StampedFrame{event.frame, stamp}});
        break;
    case DcanEventKind::kInvalid:
    case DcanEventKind::kNothing:
    case DcanEventKind::kStatus:
        break;
    }
}

QueuedFrame CanPorts::Next() noexcept
{
    return queue_.Take();
}

CanFault CanPorts::OnCycle() noexcept
{
    first_.OnCycle();
    if (HasSecond())
    {
        second_.OnCycle();
    }
    return FirstFault();
}

void CanPorts::Stop() noexcept
{
    first_.Stop(CanFault::kInvalid);
    if (HasSecond())
    {
        second_.Stop(CanFault::kInvalid);
    }
    layout_ = BusLayout::kInvalid;
}

hal::TransmitStatus CanPorts::DoTransmit(const CanFrame& frame) noexcept
{
    if (frame.port == CanPortId::kFirst)
    {
        return first_.Send(frame);
    }
    return HasSecond() ? second_.Send(frame) : hal::TransmitStatus::kRefused;
}

} // namespace counterpoint::tms570
