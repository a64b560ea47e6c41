// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/target/zynqmp/hal/board_faults.hpp"

#include "hal/tms570/chip/processor.hpp"
#include "hal/zynqmp/start/memory_map.hpp"
#include "hal/zynqmp/time/ttc_registers.hpp"
#include "verification/target/zynqmp/hal/checks.hpp"
#include "verification/target/zynqmp/hal/emulated_board.hpp"
#include "verification/target/zynqmp/hal/emulated_setup.hpp"

namespace counterpoint::target
{
namespace
{

using namespace zynqmp;

void Make(const BoardFault fault, Counters& counters, EmulatedOutput& output) noexcept
{
    using tms570::ProcessorRegister;
    constexpr std::uint32_t kProtectionOn = 1U;
    constexpr std::uint32_t kMostLooks = 100000U;
    const std::uint32_t begun = counters.Now().a.us;
    switch (fault)
    {
    case BoardFault::kCounters:
        Write(At(ttc::kTtc0, ttc::kCounterControl), ttc::kWaveformOff | ttc::kStopped);
        break;
    case BoardFault::kCan:
        Write(At(canps::kCan1, canps::kReset), canps::kResetNow);
        break;
    case BoardFault::kPins:
        output.CutOff();
        break;
    case BoardFault::kProtection:
        tms570::WriteProcessor(ProcessorRegister::kSystemControl,
                               tms570::ReadProcessor(ProcessorRegister::kSystemControl) & ~kProtectionOn);
        break;
    case BoardFault::kWatchdog:
        for (std::uint32_t look = 0U; (look < kMostLooks) && ((counters.Now().a.us - begun) < 2000U); ++look)
        {
        }
        break;
    case BoardFault::kInvalid:
    case BoardFault::kStart:
    case BoardFault::kNone:
        break;
    }
}

struct FaultCase
{
    BoardFault fault;
    const char* told;
};

} // namespace

void TestBoardFaults(Counters& counters, const CanPortsSetup& can) noexcept
{
    static EmulatedOutput output{counters};
    static EmulatedWatchdog watchdog{counters};
    static Board board{BoardParts{counters, output, watchdog}};
    constexpr FaultCase kCases[]{
        {BoardFault::kCounters, "board: a timer that stands is told, all is closed, and it stays"},
        {BoardFault::kCan, "board: so is a controller that was reset"},
        {BoardFault::kPins, "board: so are pins that are cut off"},
        {BoardFault::kProtection, "board: so is a protection that is off"},
        {BoardFault::kWatchdog, "board: so is a watchdog that was not served"},
    };
    constexpr CanFrame kFrame{0x121U, FrameKind::kData, CanPortId::kFirst, 1U, {}};
    for (const FaultCase& each : kCases)
    {
        const StartReport report = board.Start(BoardSetup{can, kEmulatedCounters, FixedRegions()});
        const bool is_watched = board.StartWatchdog() == Outcome::kDone;
        const bool is_up = (report.outcome == Outcome::kDone) && is_watched;
        const bool is_well = board.BeginCycle() == BoardFault::kNone;
        Make(each.fault, counters, output);
        const bool is_told = board.BeginCycle() == each.fault;
        const bool is_closed = output.Examine() == Outcome::kFailed;
        const bool is_refused = board.Can().Transmit(kFrame) == hal::TransmitStatus::kRefused;
        const bool is_off = (Read(At(canps::kCan0, canps::kReset)) | Read(At(canps::kCan1, canps::kReset))) == 0U;
        const bool stays = (board.BeginCycle() == each.fault) && (board.Fault() == each.fault);
        Check(is_up && is_well && is_told && is_closed && is_refused && is_off && stays, each.told);
    }
}

} // namespace counterpoint::target
