// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// A firmware example on a board with a Zynq UltraScale+: start of the drivers, then the device, cycle by cycle. Clocks,
// pins and resets of the peripherals are the boot loader's; the numbers below are those of its usual set-up. A start
// that is refused stays in the safe state: outputs closed, nobody serves the watchdog. Seen to be linked, not to run.
#include "examples/firmware/common/device.hpp"
#include "examples/firmware/zynqmp/board_needs.hpp"
#include "examples/firmware/zynqmp/executive.hpp"
#include "hal/zynqmp/output/safety_pins.hpp"
#include "hal/zynqmp/start/exceptions.hpp"
#include "hal/zynqmp/start/memory_map.hpp"
#include "hal/zynqmp/time/system_watchdog.hpp"
#include "hal/zynqmp/time/ttc_registers.hpp"

namespace
{

using namespace counterpoint;
using namespace counterpoint::zynqmp;

// LPD_LSBUS_CLK and CAN_REF_CLK 100 MHz, the processor 500 MHz.
constexpr CountersSetup kCounters{ttc::kTtc0, 2U,    CounterRate{25000000U, 32U}, 0U, CounterRate{500000000U, 32U},
                                  50U,        20000U};
constexpr std::uint32_t kLowSpeedBusKhz = 100000U;
constexpr std::uint32_t kCanReferenceMhz = 24U;
constexpr std::uint32_t kCanPrescaler = 2U; ///< 500 kbit/s: 16 quanta a bit.
constexpr std::uint32_t kLatestLookUs = 1500U;
constexpr std::uint16_t kUrgentBelow = 0x80U;
constexpr std::uint8_t kBusOffPauseCycles = 100U;
constexpr std::uint8_t kMostReturns = 5U;
// A cycle of 1 ms with a tolerance of 0.5 ms, as SetCommonConfig has it.
constexpr hal::GateLimit kGateLimit{1500U};
constexpr hal::WatchdogWindow kWatchdogWindow{500U, 1600U};

[[nodiscard]] CanpsSetup CanSetup(const RegisterBase base, const IdentifierList& received) noexcept
{
    return CanpsSetup{base,
                      kCanPrescaler,
                      canps::BitTiming(12U, 3U, 3U),
                      kCanReferenceMhz,
                      received,
                      kLatestLookUs,
                      kUrgentBelow,
                      kBusOffPauseCycles,
                      kMostReturns};
}

[[nodiscard]] SafetyPinsSetup PinsOf(const firmware::ZynqmpNeeds& needs) noexcept
{
    SafetyPinsSetup pins{0U, {}, 1U, needs.outputs, kGateLimit};
    for (std::uint32_t pin = 0U; pin < gpio::kPins; ++pin)
    {
        pins.slots[pin] = needs.gates[pin];
    }
    return pins;
}

const firmware::ZynqmpNeeds needs = firmware::DescribeZynqmpNeeds();
Counters counters{};
SafetyPins pins{counters, PinsOf(needs)};
SystemWatchdog watchdog{counters};
Board board{BoardParts{counters, pins, watchdog}};
/// For a debugger, and for whatever of CANopen the device reports them by.
StartReport start_report{};
hal::ExceptionRecord last_exception{};

void TakeRecord() noexcept
{
    hal::ExceptionMemory memory = LastException();
    last_exception = memory.Read();
    memory.Clear();
}

} // namespace

extern "C" void FirmwareInterrupt() noexcept
{
    HardwareCutOff(); // Nobody asked for one.
    HardwareStop();
}

extern "C" void FirmwareFastInterrupt() noexcept
{
    FirmwareInterrupt();
}

extern "C" void FirmwareMain() noexcept
{
    TakeRecord();
    const CanPortsSetup can{CanSetup(canps::kCan0, needs.first), CanSetup(canps::kCan1, needs.second), needs.layout};
    start_report = board.Start(BoardSetup{can, kCounters, FixedRegions()});
    const bool is_planned = watchdog.Plan(SystemWatchdogSetup{kWatchdogWindow, kLowSpeedBusKhz}) == Outcome::kDone;
    if ((start_report.outcome != Outcome::kDone) || !is_planned)
    {
        HardwareCutOff();
        HardwareStop();
    }
    const firmware::DrivenDevice driven =
        firmware::BuildDevice(firmware::Hardware{board.Can(), board.Output(), board.Watchdog(), board.Protection()});
    const bool is_up =
        driven.is_protected && driven.device.PowerOn(board.Clocks().Now().a) == device::LoadResult::kLoaded;
    if ((!is_up) || (board.StartWatchdog() != Outcome::kDone))
    {
        HardwareCutOff();
        HardwareStop();
    }
    firmware::PolledExecutive executive{board, driven};
    executive.Start();
    for (;;)
    {
        executive.Cycle();
    }
}
