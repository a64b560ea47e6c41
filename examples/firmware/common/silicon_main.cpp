// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// A firmware example on a TMS570: start of the board with every self test, then the device, cycle by cycle. A start
// that is refused stays in the safe state: outputs closed, nERROR low, nobody serves the watchdog.
#include "examples/firmware/common/device.hpp"
#include "examples/firmware/common/executive.hpp"
#include "hal/tms570/chip/processor.hpp"
#include "hal/tms570/start/exceptions.hpp"
#include "hal/tms570/start/memory_map.hpp"

namespace
{

using namespace counterpoint;
using namespace counterpoint::tms570;

// A cycle of 1 ms with a tolerance of 0.5 ms, as SetCommonConfig has it.
constexpr hal::GateLimit kGateLimit{1500U};
constexpr hal::WatchdogWindow kWatchdogWindow{500U, 1600U};
constexpr std::uint32_t kLatestOpenUs = 900U;
constexpr std::uint8_t kBusOffPauseCycles = 100U;
constexpr std::uint8_t kMostReturns = 5U;
constexpr std::uint8_t kQuanta = 5U; ///< 500 kbit/s: 10 quanta a bit, 2 of VCLK's MHz for each.
constexpr std::uint32_t kInterruptsOn = 0x1FU;

Board board{};
/// For a debugger, and for whatever of CANopen the device reports them by: every step of the start, and the exception
/// that ended the run before, if one did.
StartReport start_report{};
hal::ExceptionRecord last_exception{};
/// Memory whose ECC the start test breaks and repairs.
alignas(kEccTestBytes) std::uint8_t ecc_place[kEccTestBytes];

[[nodiscard]] DcanSetup CanSetup(const firmware::BoardNeeds& needs, const Variant& variant) noexcept
{
    const std::uint32_t prescaler = std::uint32_t{variant.clocks.rti_mhz} / kQuanta;
    return DcanSetup{variant.dcan[0],     dcan::BitTiming(prescaler, 7U, 2U, 2U),
                     needs.objects,       needs.object_count,
                     variant.can_objects, kBusOffPauseCycles,
                     kMostReturns};
}

[[nodiscard]] BoardSetup SetupOf(const firmware::BoardNeeds& needs) noexcept
{
    const Variant& variant = firmware::TheVariant();
    SafetyPinsSetup pins{gio::kPortA, {}, kGateLimit};
    for (std::uint32_t pin = 0U; pin < gio::kPins; ++pin)
    {
        pins.pins[pin] = SafetyPin{needs.gate_pins[pin]};
    }
    const auto ecc = static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(&ecc_place[0]));
    const DcanSetup can = CanSetup(needs, variant);
    return BoardSetup{variant,
                      CanPortsSetup{can, can, BusLayout::kOneController},
                      pins,
                      FixedRegions(),
                      kWatchdogWindow,
                      kLatestOpenUs,
                      EccTestPlace{ecc}};
}

/// When the start is done, whose logic test resets the processor twice: what was taken before would be lost.
void TakeRecord() noexcept
{
    hal::ExceptionMemory memory = LastException();
    last_exception = memory.Read();
    memory.Clear();
}

} // namespace

extern "C" void FirmwareInterrupt() noexcept
{
    board.OnInterrupt();
}

extern "C" void FirmwareFastInterrupt() noexcept
{
    board.OnFastInterrupt();
}

extern "C" void FirmwareMain() noexcept
{
    const firmware::BoardNeeds needs = firmware::DescribeNeeds();
    start_report = board.Start(SetupOf(needs));
    if (start_report.answer != StartAnswer::kStarted)
    {
        HardwareStop();
    }
    TakeRecord();
    UnlockInterrupts(kInterruptsOn);
    const firmware::DrivenDevice driven =
        firmware::BuildDevice(firmware::Hardware{board.Can(), board.Output(), board.Watchdog(), board.Protection()});
    const bool is_up =
        driven.is_protected && driven.device.PowerOn(board.Clocks().Now().a) == device::LoadResult::kLoaded;
    if ((!is_up) || (board.StartWatchdog() != Outcome::kDone))
    {
        HardwareCutOff();
        HardwareStop();
    }
    firmware::Executive executive{board, driven, needs};
    executive.Start();
    for (;;)
    {
        executive.Cycle();
    }
}
