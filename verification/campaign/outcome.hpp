// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_OUTCOME_HPP
#define VERIFICATION_CAMPAIGN_OUTCOME_HPP

#include "safety_core/contract/device_fault.hpp"
#include "safety_core/contract/srdo.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace counterpoint::campaign
{
/// What became of one fault. [SRS_CMG_006]
enum class Class : std::uint8_t
{
    kOpen = 0U,     ///< Not tried yet.
    kMasked = 1U,   ///< The device is again as if nothing had happened, and did nothing else than without the fault.
    kBenign = 2U,   ///< Its memory differs until the end; it did nothing else than without the fault, or nothing wrong.
    kDetected = 3U, ///< By a mechanism of the kernel or the channels: the output closed, or the device is safe.
    kSafeOther = 4U, ///< Safe by somebody else: exception, output that closes by time, application, receivers.
    kSilent = 5U,    ///< Something that must not happen, and nobody noticed before.
    kListed = 6U,    ///< Open by a complete stale or forged pair: the limit that the safety manual lists. [SRS_CMG_021]
    kExposed = 7U,   ///< Open with wrong data until the self test found it, within the limit; or old data sent until
                     ///< any mechanism did. [SRS_CMG_151, SRS_CMG_812]
};
constexpr std::size_t kClassCount = 8U;

/// Who found it first.
enum class Detector : std::uint8_t
{
    kNobody = 0U,
    kComparator = 1U,
    kFlowMonitor = 2U,
    kGuard = 3U,
    kSeal = 4U,     ///< The kernel's seal over the addresses of its parts.
    kClocks = 5U,   ///< Clock supervision: counters, late calls, order of frames.
    kChannels = 6U, ///< A cause of an SRDO: SCT, SRVT and the others.
    kPermits = 7U,  ///< The output gate, for want of three right permits.
    kWatchdog = 8U,
    kLatch = 9U,      ///< The latch of the safe state, which is changed itself.
    kPairCheck = 10U, ///< The application's check of the released pair.
    kReceivers = 11U, ///< Who consumes what the device sends.
    kException = 12U, ///< The processor.
    kTime = 13U,      ///< A call that does not return: output and watchdog.
    kPins = 14U,      ///< The safety pins' look at themselves.
    kSelfTest = 15U,  ///< The shipped self tests.
    kCrossLink = 16U, ///< What one CPU of two finds of the other one or of the link.
};
constexpr std::size_t kDetectorCount = 17U;

/// One experiment's outcome.
struct Outcome
{
    Class result{Class::kOpen};
    Detector detector{Detector::kNobody};
    std::uint8_t detail{0U}; ///< kSilent: Wrong; else DeviceFault or SrdoCause, by the detector.
    std::uint8_t marks{0U};  ///< Bits of the marks below.
    std::uint32_t us{0U};    ///< From the fault to the closed output (to the device fault, where none was open).
};

constexpr std::uint8_t kMarkLate = 1U;    ///< Above the limit, counted from what the device did first. [SRS_CMG_060]
constexpr std::uint8_t kMarkSaidByA = 2U; ///< Of kChannels: channel A reported this cause by itself.
constexpr std::uint8_t kMarkSaidByB = 4U;
constexpr std::uint8_t kMarkLatent = 8U; ///< Lay longer than the limit where the device did nothing else. [SRS_CMG_155]
constexpr std::uint8_t kMarkOldPair = 16U; ///< Of kExposed: what was wrong is what the device sent. [SRS_CMG_812]

[[nodiscard]] constexpr bool IsLate(const Outcome& outcome)
{
    return (outcome.marks & kMarkLate) != 0U;
}

[[nodiscard]] constexpr bool IsLatent(const Outcome& outcome)
{
    return (outcome.marks & kMarkLatent) != 0U;
}

[[nodiscard]] const char* WordOf(Class result);
[[nodiscard]] const char* WordOf(Detector detector);
/// @brief Whether the device did something that must not happen: for good, or until somebody found it.
[[nodiscard]] constexpr bool IsDangerous(const Class result)
{
    return result == Class::kSilent || result == Class::kExposed;
}
/// @brief Whether the fault changed what the device does: of these alone a share is said.
[[nodiscard]] constexpr bool IsEffective(const Class result)
{
    return result == Class::kDetected || result == Class::kSafeOther || IsDangerous(result);
}
/// @brief Which mechanism a device fault is of.
[[nodiscard]] Detector DetectorOf(DeviceFault fault);
/// @brief Found by what is done within an interval of the configuration. A test that is hit itself may have lost its
/// place. [SRS_CMG_154]
[[nodiscard]] bool IsOfTest(const Outcome& found, const std::string& member);
/// @brief An outcome as a sentence.
[[nodiscard]] std::string OutcomeText(const Outcome& outcome);
/// @brief Microseconds as 1.234.
[[nodiscard]] std::string MsText(std::uint32_t us);
/// @brief Why an outcome is what it is, for people.
[[nodiscard]] std::string ReasonOf(const Outcome& outcome);

/// What of an outcome no campaign writes, and what it writes instead.
struct Strange
{
    std::string wrong; ///< Empty: nothing.
    std::string expected;
};
/// @brief Of the outcome of a fault of a device, as a file has it: a class, detector or reason that no report knows.
/// [SRS_CMG_802]
[[nodiscard]] Strange StrangeIn(const Outcome& outcome);
/// @brief The same for a number, of which there are `count`; empty where it is one of them.
[[nodiscard]] Strange StrangeNumber(const char* what, std::size_t number, std::size_t count);
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_OUTCOME_HPP
