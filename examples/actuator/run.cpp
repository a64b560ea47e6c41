// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Commands every 25 ms: go, stop from 300 to 400 ms, none from 500 to 600 ms. A person acknowledges at 150 and at 750
// ms.
#include "examples/host/run.hpp"
#include "channel_a/channel.hpp"
#include "channel_b/channel.hpp"
#include "examples/actuator/actuator.hpp"
#include "examples/host/bench.hpp"

namespace counterpoint::examples
{

std::string RunActuator()
{
    host::VirtualBus bus{host::BitRate::k500k};
    Board board{bus, InstantPair{{123456U}, {0U}}};
    OtherNode controller{bus, 0x103U, 0x105U};
    channel_a::StorageFor<1U> storage_a{};
    channel_b::StorageFor<1U> storage_b{};
    channel_a::Channel a{storage_a.Handle()};
    channel_b::Channel b{storage_b.Handle()};
    Actuator actuator{};
    Kernel kernel{KernelParts{a, b, board.can, board.output, board.watchdog, actuator}};
    board.kernel = &kernel;
    if (kernel.Start(actuator.Describe(), FlowCallback::kOff) != StartResult::kStarted)
    {
        return "start refused\n";
    }
    if (Actuator::Configure(kernel) != AbortCode::kNone)
    {
        return "configuration refused\n";
    }
    board.PowerOn();
    TimeLine line{};
    for (unsigned ms = 1U; ms <= 1000U; ++ms)
    {
        if (ms == 10U)
        {
            kernel.SetNmtState(NmtState::kOperational);
        }
        if (((ms % 25U) == 0U) && ((ms < 500U) || (ms >= 600U)))
        {
            const std::uint8_t command = ((ms >= 300U) && (ms < 400U)) ? 0U : 1U;
            controller.Send(TwoBytes{command, command});
        }
        bus.Advance(ms * host::kMillisecond);
        const bool is_pressed = ((ms >= 150U) && (ms < 200U)) || ((ms >= 750U) && (ms < 800U));
        const SrdoMask acknowledge = is_pressed ? 1U : 0U;
        kernel.Cycle(CycleCall{board.clocks.Now(), acknowledge, acknowledge});
        const SrdoMask open = board.output.Open();
        line.Note(ms, std::string{NameOf(kernel.GetState(CommunicationIndex{kFirstCommunication}).state)} + ", gate " +
                          ((open != 0U) ? "open" : "closed") + ", drive " +
                          (actuator.MayMove(open) ? "moves" : "stands"));
    }
    return line.Text() + NameOf(kernel.DeviceState()) + "\n";
}

} // namespace counterpoint::examples
