// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The drive gets its pairs over the emulated bus; then one fault of the bus or of the controller after the other, each
// of which must stop it, and near misses that must not.
#include "verification/target/zynqmp/hal/checks.hpp"
#include "verification/target/zynqmp/hal/stage.hpp"

namespace counterpoint::target
{
namespace
{

using zynqmp::canps::kCan1;

constexpr std::uint16_t kHeard[]{0x721U};
constexpr std::uint32_t kChapter = 100U; ///< Cycles of one fault, from its first pair to its end.
constexpr std::uint32_t kChapters = 8U;

void Send(const std::uint32_t identifier, const std::uint8_t byte) noexcept
{
    SendPast(kCan1, OtherFrame{identifier, 2U, {byte, byte}});
}

/// What goes wrong in cycle 55 of a chapter. The output is judged three cycles later.
void Disturb(Stage& stage, const std::uint32_t chapter) noexcept
{
    switch (chapter)
    {
    case 0U: // A frame of another device, as many as the FIFO would not hold.
        for (std::uint32_t frame = 0U; frame < 70U; ++frame)
        {
            Send(0x105U, 1U);
        }
        break;
    case 1U: // Not inverse.
        Send(0x103U, 1U);
        Send(0x104U, 0xFFU);
        break;
    case 2U: // Inverse frame without its normal one.
        Send(0x104U, 0xFEU);
        break;
    case 3U: // The global fail-safe command.
        SendPast(kCan1, OtherFrame{1U, 0U, {0U, 0U}});
        break;
    case 4U: // More frames than the FIFO holds: right ones, for the newest pair would be whole.
        for (std::uint32_t frame = 0U; frame < 34U; ++frame)
        {
            Send(0x103U, 1U);
            Send(0x104U, 0xFEU);
        }
        break;
    case 5U: // A long frame.
        SendPast(kCan1, OtherFrame{0x103U, 3U, {1U, 1U}});
        break;
    case 6U: // A frame with a wrong number, near miss.
        Send(0x113U, 1U);
        break;
    default: // The controller is reset behind the driver's back.
        zynqmp::Write(zynqmp::At(zynqmp::canps::kCan0, zynqmp::canps::kReset), zynqmp::canps::kResetNow);
        break;
    }
    static_cast<void>(stage);
}

constexpr const char* kNames[kChapters]{
    "actuator: 70 frames of other devices do not disturb it",
    "actuator: a pair that is not inverse stops it",
    "actuator: an inverse frame alone stops it",
    "actuator: the global fail-safe command stops it",
    "actuator: an overflow of the FIFO stops it, although what came is right",
    "actuator: a frame of another length stops it",
    "actuator: a frame of another identifier does not disturb it",
    "actuator: a controller that was reset stops it",
};
constexpr std::uint32_t kStillOn = 0x41U; ///< Chapters 0 and 6.

void Step(Stage& stage) noexcept
{
    static_cast<void>(stage.peer.Look());
    static_cast<void>(stage.peer.OnCycle());
    static_cast<void>(stage.peer.Next());
    if (stage.cycle == 5U)
    {
        SendPast(kCan1, OtherFrame{0U, 2U, {1U, 0U}});
    }
    const std::uint32_t chapter = stage.cycle / kChapter;
    const std::uint32_t at = stage.cycle % kChapter;
    const bool is_pair = (at == 20U) || (at == 45U) || (at == 70U);
    if (is_pair && (chapter < kChapters))
    {
        Send(0x103U, 1U);
        Send(0x104U, 0xFEU);
    }
    stage.output.inputs = ((at >= 24U) && (at < 28U)) ? 1U : 0U;
    if (chapter >= kChapters)
    {
        return;
    }
    const bool stays_on = ((kStillOn >> chapter) & 1U) != 0U;
    if (at == 50U)
    {
        CheckEqual(stage.output.outputs, 1U, "actuator: released by pair and acknowledge, it moves");
    }
    if (at == 55U)
    {
        Disturb(stage, chapter);
    }
    if (at == 58U)
    {
        CheckEqual(stage.output.outputs, stays_on ? 1U : 0U, kNames[chapter]);
    }
    if (at == 80U)
    {
        CheckEqual(stage.output.outputs, stays_on ? 1U : 0U, "actuator: the next pair alone does not release it");
    }
    if ((at == 99U) && (chapter == 0U))
    {
        CheckEqual(stage.board.Can().Controller(CanPortId::kFirst).Foreign(), 0U,
                   "actuator: its filters let no foreign frame pass");
    }
    if (stage.cycle == ((kChapter * (kChapters - 1U)) + 50U))
    {
        Check(stage.driven.kernel.DeviceState().fault == DeviceFault::kNone, "actuator: none of it was a device fault");
        Check(stage.watchdog.IsAlive(), "actuator: the watchdog was answered in its window in each cycle");
    }
    if ((chapter == (kChapters - 1U)) && (at == 90U))
    {
        Check(stage.board.Fault() == zynqmp::BoardFault::kCan, "actuator: which is told as a fault of the driver");
        Check(stage.watchdog.Examine() == zynqmp::Outcome::kFailed, "actuator: nobody serves the watchdog any more");
    }
}

constexpr Scenario kScenario{{&kHeard[0], 1U}, (kChapter * kChapters), Step};

} // namespace

const Scenario& TheScenario() noexcept
{
    return kScenario;
}

} // namespace counterpoint::target
