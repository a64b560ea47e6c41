// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Button 1 is pressed from 200 to 300 ms; from 500 to 600 ms contact B of button 2 does not move.
#include "examples/host/run.hpp"
#include "channel_a/channel.hpp"
#include "channel_b/channel.hpp"
#include "examples/host/bench.hpp"
#include "examples/sensor/sensor.hpp"

namespace counterpoint::examples
{

std::string RunSensor()
{
    host::VirtualBus bus{host::BitRate::k500k};
    Board board{bus, InstantPair{{1000U}, {70000U}}};
    OtherNode controller{bus, 0x103U, 0x101U};
    channel_a::StorageFor<1U> storage_a{};
    channel_b::StorageFor<1U> storage_b{};
    channel_a::Channel a{storage_a.Handle()};
    channel_b::Channel b{storage_b.Handle()};
    Sensor sensor{};
    Kernel kernel{KernelParts{a, b, board.can, board.output, board.watchdog, sensor}};
    board.kernel = &kernel;
    if (kernel.Start(sensor.Describe(), FlowCallback::kOff) != StartResult::kStarted)
    {
        return "start refused\n";
    }
    if (Sensor::Configure(kernel) != AbortCode::kNone)
    {
        return "configuration refused\n";
    }
    board.PowerOn();
    TimeLine line{};
    SrdoCause cause = SrdoCause::kNone;
    for (unsigned ms = 1U; ms <= 1000U; ++ms)
    {
        if (ms == 10U)
        {
            kernel.SetNmtState(NmtState::kOperational);
        }
        const bool is_pressed = (ms >= 200U) && (ms < 300U);
        const bool is_broken = (ms >= 500U) && (ms < 600U);
        sensor.Sense(0U, is_pressed ? Contacts{0U, 1U} : Contacts{1U, 0U});
        sensor.Sense(1U, is_broken ? Contacts{0U, 0U} : Contacts{1U, 0U});
        bus.Advance(ms * host::kMillisecond);
        kernel.Cycle(CycleCall{board.clocks.Now(), 0U, 0U});
        const SrdoCause error = sensor.TakeError();
        cause = (error == SrdoCause::kNone) ? cause : error;
        if ((ms % 100U) == 0U)
        {
            line.Note(ms,
                      "pairs " + std::to_string(controller.pairs) + ", buttons " +
                          std::to_string(controller.heard.first) + " " + std::to_string(controller.heard.second) +
                          ((cause == SrdoCause::kNone) ? std::string{}
                                                       : ", cause " + std::to_string(static_cast<unsigned>(cause))));
            cause = SrdoCause::kNone;
        }
    }
    return line.Text() + NameOf(kernel.DeviceState()) + ", wrong pairs " + std::to_string(controller.wrong) + "\n";
}

} // namespace counterpoint::examples
