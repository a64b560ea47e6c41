// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TARGET_ZYNQMP_TWO_CPU_TIMES_HPP
#define VERIFICATION_TARGET_ZYNQMP_TWO_CPU_TIMES_HPP

#include <cstdint>

/// Times of the device with two processors, in the time of the emulator: 8 ns an instruction of either processor.
namespace counterpoint::two_cpu
{

constexpr std::uint32_t kCycleUs = 6000U;
constexpr std::uint32_t kToleranceUs = 3000U; ///< By which a cycle may be late.
constexpr std::uint32_t kGateUs = kCycleUs + kToleranceUs;
constexpr std::uint32_t kLinkTimeoutUs = 75000U;
constexpr std::uint32_t kDiscrepancyUs = 100000U;
constexpr std::uint32_t kRefreshUs = 30000U;
constexpr std::uint16_t kSctMs = 100U;
constexpr std::uint8_t kSrvtMs = 60U;
/// From a frame to what answers it. On a bus that is 94 us at the least, the shortest frame at 500 kbit/s; on the
/// emulator no frame takes any time, and processors that run at once have no common time.
constexpr std::uint32_t kFrameUs = 900U;
/// The two processors look at their bus in turns.
constexpr std::uint32_t kStampToleranceUs = 2000U;
/// What the counters of one processor may be apart, because the other one had its turn between the two readings.
constexpr std::uint32_t kTurnUs = 1500U;
constexpr std::uint32_t kCompareUs = 150000U;

} // namespace counterpoint::two_cpu

#endif
