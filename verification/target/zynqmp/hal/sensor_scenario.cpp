// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The sensor is heard by another node: boot-up message, pairs once it is OPERATIONAL, none while its contacts
// contradict, pairs again.
#include "verification/target/zynqmp/hal/checks.hpp"
#include "verification/target/zynqmp/hal/stage.hpp"

namespace counterpoint::target
{
namespace
{

using zynqmp::QueuedFrame;
using zynqmp::QueuedKind;

constexpr std::uint16_t kHeard[]{0x701U, 0x101U, 0x102U};

std::uint32_t boot_ups = 0U;
std::uint32_t pairs = 0U;
std::uint32_t wrong = 0U;
std::uint32_t told = 0U;
CanFrame normal{};
InstantPair normal_at{};
bool is_half{false};

void Hear(const QueuedFrame& queued) noexcept
{
    const CanFrame& frame = queued.frame.frame;
    if (queued.kind != QueuedKind::kReceived)
    {
        ++wrong;
    }
    else if (frame.identifier == 0x701U)
    {
        ++boot_ups;
    }
    else if (frame.identifier == 0x101U)
    {
        wrong += is_half ? 1U : 0U;
        normal = frame;
        normal_at = queued.frame.stamp;
        is_half = true;
    }
    else
    {
        const bool is_inverse = ((frame.data[0U] ^ normal.data[0U]) & (frame.data[1U] ^ normal.data[1U])) == 0xFFU;
        const bool is_near = (queued.frame.stamp.a.us - normal_at.a.us) <= 5000U;
        const bool is_pair = is_half && is_inverse && is_near && (frame.length_bytes == 2U);
        pairs += is_pair ? 1U : 0U;
        wrong += is_pair ? 0U : 1U;
        is_half = false;
    }
}

void Judge(const Stage& stage) noexcept
{
    switch (stage.cycle)
    {
    case 4U:
        CheckEqual(boot_ups, 1U, "sensor: one boot-up message was on the bus");
        CheckEqual(pairs, 0U, "sensor: no pair before OPERATIONAL");
        break;
    case 120U:
        Check((pairs >= 4U) && (pairs <= 6U), "sensor: a pair each 25 ms");
        Check((normal.data[0U] == 1U) && (normal.data[1U] == 1U), "sensor: both buttons are let go");
        break;
    case 200U:
        Check((normal.data[0U] == 0U) && (normal.data[1U] == 1U), "sensor: button 1 is pressed");
        break;
    case 240U:
        told = pairs;
        break;
    case 330U:
        CheckEqual(pairs, told, "sensor: no pair while contacts contradict");
        break;
    case 450U:
        Check(pairs >= (told + 3U), "sensor: pairs again");
        CheckEqual(wrong, 0U, "sensor: every pair was whole, in order, inverse and within 5 ms; no frame was lost");
        Check(stage.driven.kernel.DeviceState().fault == DeviceFault::kNone, "sensor: no device fault");
        Check(stage.board.Fault() == zynqmp::BoardFault::kNone, "sensor: no fault of a driver");
        Check(stage.watchdog.IsAlive(), "sensor: the watchdog was answered in its window in each cycle");
        break;
    default:
        break;
    }
}

void Step(Stage& stage) noexcept
{
    static_cast<void>(stage.peer.Look());
    static_cast<void>(stage.peer.OnCycle());
    QueuedFrame queued = stage.peer.Next();
    for (std::uint32_t frame = 0U; (frame < 64U) && (queued.kind != QueuedKind::kNothing); ++frame)
    {
        Hear(queued);
        queued = stage.peer.Next();
    }
    const bool is_operational = stage.cycle == 5U;
    if (is_operational)
    {
        SendPast(zynqmp::canps::kCan1, OtherFrame{0U, 2U, {1U, 0U}});
    }
    const bool is_pressed = (stage.cycle >= 130U) && (stage.cycle < 210U);
    const bool is_broken = (stage.cycle >= 210U) && (stage.cycle < 330U);
    stage.output.inputs = is_broken ? 2U : (is_pressed ? 6U : 5U);
    Judge(stage);
}

constexpr Scenario kScenario{{&kHeard[0], 3U}, 450U, Step};

} // namespace

const Scenario& TheScenario() noexcept
{
    return kScenario;
}

} // namespace counterpoint::target
