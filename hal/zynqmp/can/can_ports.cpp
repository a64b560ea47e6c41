// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Each receive FIFO is in the order of the bus. Between two controllers the stamps decide: the shortest frame takes 47
// bit times, more than what a stamp is wrong by. A frame that came after the look had begun waits for the next one, or
// an earlier frame of the other controller would come behind it. [SRS_ZYN_047]
#include "hal/zynqmp/can/can_ports.hpp"

namespace counterpoint::zynqmp
{

CanPorts::CanPorts(hal::Clocks& clocks) noexcept : clocks_(clocks)
{
}

CanFault CanPorts::Start(const CanPortsSetup& setup) noexcept
{
    layout_ = setup.layout;
    queue_.Clear();
    looked_ = clocks_.Now();
    const bool is_layout = (setup.layout == BusLayout::kOneController) || HasSecond();
    if (!is_layout)
    {
        return CanFault::kSetup;
    }
    const CanFault first = first_.Start(setup.first, clocks_);
    const CanFault second = HasSecond() ? second_.Start(setup.second, clocks_) : CanFault::kNone;
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

InstantPair CanPorts::Look() noexcept
{
    const InstantPair begun = clocks_.Now();
    first_.Look(clocks_, queue_, CanPortId::kFirst);
    if (HasSecond())
    {
        second_.Look(clocks_, queue_, CanPortId::kSecond);
    }
    looked_ = begun;
    return begun;
}

QueuedFrame CanPorts::Next() noexcept
{
    return queue_.Take(looked_.a);
}

CanFault CanPorts::OnCycle() noexcept
{
    first_.OnCycle(clocks_, queue_, CanPortId::kFirst);
    if (HasSecond())
    {
        second_.OnCycle(clocks_, queue_, CanPortId::kSecond);
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

} // namespace counterpoint::zynqmp
