// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The drive moves when the oscillator of both counters stops: no driver has anything to tell, and no cycle comes any
// more. The wait for it has an end, behind which everything is closed.
#include "verification/target/zynqmp/hal/checks.hpp"
#include "verification/target/zynqmp/hal/stage.hpp"
#include "verification/target/zynqmp/hal/standing_time.hpp"

namespace counterpoint::target
{
namespace
{

using zynqmp::canps::kCan1;

constexpr std::uint16_t kHeard[]{0x721U};
constexpr std::uint32_t kLast = 55U; ///< Cycle behind which time stands.

void Send(const std::uint32_t identifier, const std::uint8_t byte) noexcept
{
    SendPast(kCan1, OtherFrame{identifier, 2U, {byte, byte}});
}

[[nodiscard]] bool IsOffBus(const zynqmp::RegisterBase base) noexcept
{
    return zynqmp::Read(zynqmp::At(base, zynqmp::canps::kReset)) == 0U;
}

void Step(Stage& stage) noexcept
{
    static_cast<void>(stage.peer.Look());
    static_cast<void>(stage.peer.OnCycle());
    static_cast<void>(stage.peer.Next());
    if (stage.cycle == 5U)
    {
        SendPast(kCan1, OtherFrame{0U, 2U, {1U, 0U}});
    }
    if ((stage.cycle == 20U) || (stage.cycle == 45U))
    {
        Send(0x103U, 1U);
        Send(0x104U, 0xFEU);
    }
    stage.output.inputs = ((stage.cycle >= 24U) && (stage.cycle < 28U)) ? 1U : 0U;
    if (stage.cycle == kLast)
    {
        CheckEqual(stage.output.outputs, 1U, "standing time: before, the drive moves");
        LetTimeStand();
    }
    if (stage.cycle == (kLast + 1U))
    {
        Check(stage.board.Fault() == zynqmp::BoardFault::kNone, "standing time: no driver has anything to tell");
        CheckEqual(stage.output.outputs, 0U, "standing time: the wait for the cycle ends, and the drive stops");
        Check(stage.output.Examine() == zynqmp::Outcome::kFailed, "standing time: its output is cut off");
        Check(IsOffBus(zynqmp::canps::kCan0) && IsOffBus(kCan1), "standing time: the controllers are off the bus");
    }
}

constexpr Scenario kScenario{{&kHeard[0], 1U}, kLast + 1U, Step};

} // namespace

const Scenario& TheScenario() noexcept
{
    return kScenario;
}

} // namespace counterpoint::target
