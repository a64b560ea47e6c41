// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/target/zynqmp/two_cpu/board.hpp"

#include "hal/zynqmp/link/shared_link.hpp"
#include "hal/zynqmp/output/safety_pins.hpp"
#include "hal/zynqmp/start/memory_map.hpp"
#include "hal/zynqmp/time/system_watchdog.hpp"
#include "verification/target/zynqmp/hal/emulated_setup.hpp"
#include "verification/target/zynqmp/two_cpu/times.hpp"

extern "C"
{
    // Symbols of the linker: the number of this processor plus 1, and the two directions of the link in the OCM.
    extern const std::uint8_t image_core[];
    extern counterpoint::zynqmp::LinkMailbox image_link_0[];
    extern counterpoint::zynqmp::LinkMailbox image_link_1[];
}

namespace counterpoint::two_cpu
{
namespace
{

/// What this device hears: the sensor's pair and its own.
constexpr std::uint16_t kIdentifiers[]{0x101U, 0x102U, 0x103U, 0x104U};
constexpr std::uint32_t kGateBank = 0U;
constexpr std::uint32_t kConsumerPin = 1U; // The slot of SRDO 1, too.
constexpr zynqmp::SafetyPinsSetup kPins{kGateBank, {kConsumerPin}, 1U, 1U, hal::GateLimit{kGateUs}};
constexpr zynqmp::SystemWatchdogSetup kWatchdog{hal::WatchdogWindow{kCycleUs / 8U, (2U * kCycleUs) + kToleranceUs},
                                                100000U};

bool IsFirst() noexcept
{
    return reinterpret_cast<std::uintptr_t>(image_core) == 1U;
}

/// The drivers are built in the order of their members.
struct Drivers
{
    zynqmp::Counters counters{};
    zynqmp::SafetyPins pins{counters, kPins};
    zynqmp::SystemWatchdog watchdog{counters};
    zynqmp::Board board{zynqmp::BoardParts{counters, pins, watchdog}};
};

Drivers& Own() noexcept
{
    static Drivers drivers;
    return drivers;
}

zynqmp::RegisterBase Timer() noexcept
{
    return IsFirst() ? zynqmp::ttc::kTtc0 : zynqmp::ttc::kTtc1;
}

/// Each processor has a timer and a controller of its own. They take turns on the emulator: a processor that is
/// interrupted between the readings of its two counters finds them further apart than on a board.
zynqmp::BoardSetup SetupOfThis() noexcept
{
    zynqmp::CountersSetup counters = target::kEmulatedCounters;
    counters.timer = Timer();
    counters.most_apart_us = kTurnUs;
    counters.compare_us = kCompareUs;
    const zynqmp::CanpsSetup can = target::EmulatedCan(IsFirst() ? zynqmp::canps::kCan0 : zynqmp::canps::kCan1,
                                                       zynqmp::IdentifierList{&kIdentifiers[0], 4U});
    return zynqmp::BoardSetup{zynqmp::CanPortsSetup{can, can, zynqmp::BusLayout::kOneController}, counters,
                              zynqmp::FixedRegions()};
}

} // namespace

zynqmp::Board& OwnBoard() noexcept
{
    return Own().board;
}

bool StartBoard() noexcept
{
    const bool is_planned = Own().watchdog.Plan(kWatchdog) == zynqmp::Outcome::kDone;
    return is_planned && (OwnBoard().Start(SetupOfThis()).outcome == zynqmp::Outcome::kDone);
}

std::uint32_t WatchdogPeriodUs() noexcept
{
    return Own().watchdog.PeriodUs();
}

bool IsPinHigh() noexcept
{
    return (zynqmp::Read(zynqmp::gpio::Input(kGateBank)) & kConsumerPin) != 0U;
}

void StopTimer() noexcept
{
    zynqmp::Write(At(Timer(), zynqmp::ttc::kCounterControl), zynqmp::ttc::kWaveformOff | zynqmp::ttc::kStopped);
}

hal::CrossLink& Link() noexcept
{
    static zynqmp::SharedLink link{IsFirst() ? image_link_0[0] : image_link_1[0],
                                   IsFirst() ? image_link_1[0] : image_link_0[0]};
    return link;
}

void LetOthersRun() noexcept
{
    asm volatile("wfe");
}

} // namespace counterpoint::two_cpu
