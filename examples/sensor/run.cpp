// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Button 1 is pressed from 200 to 300 ms; from 500 to 600 ms contact B of button 2 does not move.
#include "examples/host/run.hpp"
#include "examples/host/bench.hpp"
#include "examples/sensor/sensor.hpp"

namespace counterpoint::examples
{

std::string RunSensor()
{
    host::VirtualBus bus{host::BitRate::k500k};
    BenchDevice<Sensor, 1U> sensor{bus, InstantPair{{1000U}, {70000U}}};
    OtherNode controller{bus, 0x103U, 0x101U};
    if (!sensor.board.PowerOn())
    {
        return sensor.Refusal();
    }
    TimeLine line{};
    SrdoCause cause = SrdoCause::kNone;
    for (unsigned ms = 1U; ms <= 1000U; ++ms)
    {
        if (ms == 9U)
        {
            controller.StartAll();
        }
        const bool is_pressed = (ms >= 200U) && (ms < 300U);
        const bool is_broken = (ms >= 500U) && (ms < 600U);
        sensor.application.Sense(0U, is_pressed ? Contacts{0U, 1U} : Contacts{1U, 0U});
        sensor.application.Sense(1U, is_broken ? Contacts{0U, 0U} : Contacts{1U, 0U});
        bus.Advance(ms * host::kMillisecond);
        sensor.Cycle(0U, 0U);
        const SrdoCause error = sensor.application.TakeError();
        cause = (error == SrdoCause::kNone) ? cause : error;
        if ((ms % 100U) == 0U)
        {
            line.Note(ms, "pairs " + std::to_string(controller.pairs) + ", buttons " +
                              std::to_string(controller.heard.first) + " " + std::to_string(controller.heard.second) +
                              ((cause == SrdoCause::kNone) ? std::string{} : std::string{", cause "} + NameOf(cause)));
            cause = SrdoCause::kNone;
        }
    }
    return line.Text() + NameOf(sensor.kernel.DeviceState()) + ", wrong pairs " + std::to_string(controller.wrong) +
           "\n";
}

} // namespace counterpoint::examples
