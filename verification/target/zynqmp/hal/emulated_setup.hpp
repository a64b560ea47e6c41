// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TARGET_ZYNQMP_HAL_EMULATED_SETUP_HPP
#define VERIFICATION_TARGET_ZYNQMP_HAL_EMULATED_SETUP_HPP

#include "hal/zynqmp/can/can_ports.hpp"
#include "hal/zynqmp/time/counters.hpp"
#include "hal/zynqmp/time/ttc_registers.hpp"

/// What differs between a board and the emulator's machine, as numbers of the setup: hal/zynqmp/DESIGN.md has the list.
namespace counterpoint::target
{

/// The emulator's timers count 133 MHz, have 16 bits and may not roll over; its cycle counter counts nanoseconds.
inline constexpr zynqmp::CountersSetup kEmulatedCounters{zynqmp::ttc::kTtc0,
                                                         7U,
                                                         zynqmp::CounterRate{1039062U, 16U},
                                                         0x8000U,
                                                         zynqmp::CounterRate{1000000000U, 32U},
                                                         50U,
                                                         20000U};

/// 24 MHz: 16 quanta a bit of 500 kbit/s, sampled after 13 of them.
inline constexpr std::uint32_t kCanReferenceMhz = 24U;
inline constexpr std::uint32_t kCanPrescaler = 2U;
inline constexpr std::uint32_t kCanBitTiming = zynqmp::canps::BitTiming(12U, 3U, 3U);
inline constexpr std::uint32_t kLatestLookUs = 1500U;
inline constexpr std::uint16_t kUrgentBelow = 0x80U;

[[nodiscard]] constexpr zynqmp::CanpsSetup EmulatedCan(const zynqmp::RegisterBase base,
                                                       const zynqmp::IdentifierList& received) noexcept
{
    return zynqmp::CanpsSetup{
        base, kCanPrescaler, kCanBitTiming, kCanReferenceMhz, received, kLatestLookUs, kUrgentBelow, 3U, 2U};
}

} // namespace counterpoint::target

#endif
