// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/faults/foreign_controller.hpp"

namespace counterpoint::simulator
{
namespace
{
constexpr std::size_t kQueueCapacity = 64U;
} // namespace

ForeignController::ForeignController(host::VirtualBus& bus)
    : bus_(bus), node_(bus.Attach(*this, host::NodeSetup{CanPortId::kFirst, kQueueCapacity}))
{
}

void ForeignController::Babble(const CanFrame& frame)
{
    frame_ = frame;
    is_babbling_ = true;
    if (bus_.Pending(node_) == 0U)
    {
        static_cast<void>(bus_.Submit(node_, frame_)); // A controller that went bus-off is quiet for good.
    }
}

void ForeignController::Stop() noexcept
{
    is_babbling_ = false;
    bus_.AbortAll(node_);
}

void ForeignController::OnReceived(const CanFrame& frame, const host::BusTime /*at*/)
{
    static_cast<void>(bus_.Submit(node_, frame));
}

void ForeignController::OnConfirmed(const CanFrame& /*frame*/, const host::BusTime /*at*/)
{
    if (is_babbling_)
    {
        static_cast<void>(bus_.Submit(node_, frame_));
    }
}
} // namespace counterpoint::simulator
