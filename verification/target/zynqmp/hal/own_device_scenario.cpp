// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The device with four SRDOs: with one controller, and with two, of which one has the normal and one the inverse
// frames. What another node sends to a controller goes out by the other one.
#include "examples/firmware/zynqmp/board_needs.hpp"
#include "verification/target/zynqmp/hal/checks.hpp"
#include "verification/target/zynqmp/hal/stage.hpp"

namespace counterpoint::target
{
namespace
{

using namespace zynqmp;

constexpr std::uint16_t kHeard[]{0x121U, 0x122U, 0x123U, 0x124U};

bool has_two = false;
std::uint32_t heard = 0U;

/// A frame of one byte takes no less on a bus of 500 kbit/s; on the emulated one it takes no time.
void PassFrameTime(Stage& stage) noexcept
{
    const std::uint32_t begun = stage.board.Clocks().Now().a.us;
    for (std::uint32_t look = 0U; (look < 10000U) && ((stage.board.Clocks().Now().a.us - begun) < 100U); ++look)
    {
    }
}

void SendNormal(const std::uint32_t identifier, const std::uint8_t byte) noexcept
{
    SendPast(canps::kCan1, OtherFrame{identifier, 1U, {byte, 0U}});
}

void SendInverse(const std::uint32_t identifier, const std::uint8_t byte) noexcept
{
    SendPast(has_two ? canps::kCan0 : canps::kCan1, OtherFrame{identifier, 1U, {byte, 0U}});
}

void SendPairs(Stage& stage, const std::uint8_t last) noexcept
{
    SendNormal(0x111U, 1U);
    PassFrameTime(stage);
    SendInverse(0x112U, 0xFEU);
    PassFrameTime(stage);
    SendNormal(0x113U, 1U);
    PassFrameTime(stage);
    SendInverse(0x114U, last);
}

void Judge(Stage& stage) noexcept
{
    switch (stage.cycle)
    {
    case 40U:
        CheckEqual(stage.output.outputs, 0U, "own device: closed before the first pair");
        Check(StateOf(stage, 1U) == SrdoState::kProducer, "own device: SRDO 1 is a producer");
        break;
    case 60U:
        Check(StateOf(stage, 3U) == SrdoState::kReleased, "own device: SRDO 3 is released");
        CheckEqual(stage.output.outputs, 3U, "own device: both outputs are on");
        break;
    case 73U:
        CheckEqual(stage.output.outputs, 3U, "own device: and stay on");
        break;
    case 80U:
        SendPairs(stage, 0xFFU);
        break;
    case 83U:
        Check(StateOf(stage, 4U) == SrdoState::kFaulted, "own device: a pair that is not inverse stops SRDO 4");
        CheckEqual(stage.output.outputs, 1U, "own device: and its output alone");
        break;
    case 95U:
        SendNormal(0x111U, 1U);
        PassFrameTime(stage);
        // Its inverse frame goes where only the other controller hears it.
        SendPast(has_two ? canps::kCan1 : canps::kCan0, OtherFrame{0x112U, 1U, {0xFEU, 0U}});
        break;
    case 117U:
        Check(StateOf(stage, 3U) == SrdoState::kFaulted,
              "own device: an inverse frame that its controller does not hear is none");
        CheckEqual(stage.output.outputs, 0U, "own device: the other output is closed, too");
        break;
    case 130U:
        Check(stage.driven.kernel.DeviceState().fault == DeviceFault::kNone, "own device: no device fault");
        Check(stage.board.Fault() == BoardFault::kNone, "own device: no fault of a driver");
        Check(stage.watchdog.IsAlive(), "own device: the watchdog was answered in its window in each cycle");
        Check(has_two || (heard >= 12U), "own device: both pairs were heard, again and again");
        break;
    case 140U:
        Write(At(canps::kCan1, canps::kReset), 0U);
        break;
    case 145U:
        Check((stage.board.Fault() == BoardFault::kCan) == has_two,
              "own device: the loss of the second controller is a fault where the device has it");
        break;
    default:
        break;
    }
}

void Step(Stage& stage) noexcept
{
    has_two = firmware::DescribeZynqmpNeeds().layout == BusLayout::kOneBus;
    if (!has_two)
    {
        static_cast<void>(stage.peer.Look());
        static_cast<void>(stage.peer.OnCycle());
        for (std::uint32_t frame = 0U; (frame < 64U) && (stage.peer.Next().kind == QueuedKind::kReceived); ++frame)
        {
            ++heard;
        }
    }
    if (stage.cycle == 5U)
    {
        SendPast(canps::kCan1, OtherFrame{0U, 2U, {1U, 0U}});
    }
    if ((stage.cycle == 45U) || (stage.cycle == 65U))
    {
        SendPairs(stage, 0xFEU);
    }
    const bool is_acknowledged = (stage.cycle >= 48U) && (stage.cycle < 52U);
    stage.output.inputs = is_acknowledged ? 0x35U : 0x05U;
    Judge(stage);
}

} // namespace

const Scenario& TheScenario() noexcept
{
    static constexpr Scenario kOne{{&kHeard[0], 4U}, 150U, Step};
    static constexpr Scenario kTwo{{nullptr, 0U}, 150U, Step};
    return (firmware::DescribeZynqmpNeeds().layout == BusLayout::kOneBus) ? kTwo : kOne;
}

} // namespace counterpoint::target
