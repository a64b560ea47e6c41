// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Commands every 25 ms: go, stop from 300 to 400 ms, none from 500 to 600 ms. A person acknowledges at 150 and at 750
// ms.
#include "examples/host/run.hpp"
#include "examples/actuator/actuator.hpp"
#include "examples/host/bench.hpp"

namespace counterpoint::examples
{

std::string RunActuator()
{
    host::VirtualBus bus{host::BitRate::k500k};
    BenchDevice<Actuator, 1U> actuator{bus, InstantPair{{123456U}, {0U}}};
    OtherNode controller{bus, 0x103U, 0x105U};
    if (!actuator.board.PowerOn())
    {
        return actuator.Refusal();
    }
    TimeLine line{};
    for (unsigned ms = 1U; ms <= 1000U; ++ms)
    {
        if (ms == 9U)
        {
            controller.StartAll();
        }
        if (((ms % 25U) == 0U) && ((ms < 500U) || (ms >= 600U)))
        {
            const std::uint8_t command = ((ms >= 300U) && (ms < 400U)) ? 0U : 1U;
            controller.Send(TwoBytes{command, command});
        }
        bus.Advance(ms * host::kMillisecond);
        const bool is_pressed = ((ms >= 150U) && (ms < 200U)) || ((ms >= 750U) && (ms < 800U));
        // A button of two contacts, one for each channel: one closes when it is pressed, one opens.
        const bool make_contact = is_pressed;
        const bool break_contact = !is_pressed;
        actuator.Cycle(make_contact ? 1U : 0U, break_contact ? 0U : 1U);
        const SrdoMask open = actuator.board.output.Open();
        line.Note(ms, std::string{NameOf(actuator.kernel.GetState(CommunicationIndex{kFirstCommunication}).state)} +
                          ", gate " + ((open != 0U) ? "open" : "closed") + ", drive " +
                          (actuator.application.MayMove(open) ? "moves" : "stands"));
    }
    return line.Text() + NameOf(actuator.kernel.DeviceState()) + "\n";
}

} // namespace counterpoint::examples
