// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// A firmware example on the emulated Zynq UltraScale+: start-up, exceptions, MPU, unprivileged code, counters, CAN
// drivers, board and executive are those of a board; pins and watchdog, which the emulator has not, follow their rules
// in software. Other nodes send by the controllers themselves.
#include "examples/firmware/zynqmp/board_needs.hpp"
#include "examples/firmware/zynqmp/executive.hpp"
#include "hal/zynqmp/start/memory_map.hpp"
#include "verification/target/target.hpp"
#include "verification/target/zynqmp/hal/checks.hpp"
#include "verification/target/zynqmp/hal/emulated_setup.hpp"
#include "verification/target/zynqmp/hal/stage.hpp"

extern "C" std::uint32_t TargetMain() noexcept;

namespace counterpoint::target
{
namespace
{

using namespace zynqmp;

Counters counters{};
EmulatedOutput output{counters};
EmulatedWatchdog watchdog{counters};
Board board{BoardParts{counters, output, watchdog}};
CanPorts peer{counters};

[[nodiscard]] bool StartPeer(const Scenario& scenario) noexcept
{
    if (scenario.heard.count == 0U)
    {
        return true;
    }
    const CanpsSetup setup = EmulatedCan(canps::kCan1, scenario.heard);
    return peer.Start(CanPortsSetup{setup, setup, BusLayout::kOneController}) == CanFault::kNone;
}

std::uint32_t Run() noexcept
{
    const Scenario& scenario = TheScenario();
    const firmware::ZynqmpNeeds needs = firmware::DescribeZynqmpNeeds();
    const CanPortsSetup can{EmulatedCan(canps::kCan0, needs.first), EmulatedCan(canps::kCan1, needs.second),
                            needs.layout};
    const StartReport report = board.Start(BoardSetup{can, kEmulatedCounters, FixedRegions()});
    Check(report.outcome == Outcome::kDone, "board: started");
    Check(StartPeer(scenario), "the other node is on the bus");
    const firmware::DrivenDevice driven =
        firmware::BuildDevice(firmware::Hardware{board.Can(), board.Output(), board.Watchdog(), board.Protection()});
    Check(driven.is_protected, "the memory of both channels and of the core is protected");
    Check(driven.device.PowerOn(board.Clocks().Now().a) == device::LoadResult::kLoaded, "the device came up");
    Check(board.StartWatchdog() == Outcome::kDone, "the watchdog runs");
    firmware::PolledExecutive executive{board, driven};
    executive.Start();
    Stage stage{board, output, watchdog, driven, peer, 0U};
    DeviceFault told = DeviceFault::kNone;
    for (std::uint32_t cycle = 1U; cycle <= scenario.cycles; ++cycle)
    {
        executive.Cycle();
        stage.cycle = cycle;
        scenario.step(stage);
        const DeviceFault fault = driven.kernel.DeviceState().fault;
        if (fault != told)
        {
            told = fault;
            Write("cycle ");
            WriteNumber(cycle);
            Write(" device fault ");
            WriteNumber(static_cast<std::uint32_t>(fault));
            Write("\n");
        }
    }
    return EndChecks();
}

} // namespace

void SendPast(const RegisterBase base, const OtherFrame& frame) noexcept
{
    const bool has_confirmation = (Read(At(base, canps::kEvents)) & canps::kSent) != 0U;
    const std::uint32_t first = (std::uint32_t{frame.data[0U]} << 24U) | (std::uint32_t{frame.data[1U]} << 16U);
    Write(At(base, canps::kTransmit), frame.identifier << canps::kIdentifierShift);
    Write(At(base, canps::kTransmit + canps::kLengthWord), std::uint32_t{frame.length} << canps::kLengthShift);
    Write(At(base, canps::kTransmit + canps::kDataWord), first);
    Write(At(base, canps::kTransmit + canps::kLastDataWord), 0U);
    if (!has_confirmation)
    {
        Write(At(base, canps::kClearEvents), canps::kSent);
    }
}

SrdoState StateOf(const Stage& stage, const std::uint8_t srdo) noexcept
{
    return stage.driven.kernel
        .GetState(CommunicationIndex{static_cast<std::uint16_t>((kFirstCommunication - 1U) + srdo)})
        .state;
}

} // namespace counterpoint::target

std::uint32_t TargetMain() noexcept
{
    return counterpoint::target::Run();
}
