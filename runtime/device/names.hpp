// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_DEVICE_NAMES_HPP
#define RUNTIME_DEVICE_NAMES_HPP

#include "runtime/device/logic_rule.hpp"
#include "runtime/yaml/value.hpp"

#include "safety_core/contract/channel.hpp"
#include "safety_core/contract/device_fault.hpp"
#include "safety_core/kernel/start_check.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace counterpoint::runtime
{
// The words of files and outputs for the enumerations of contract and kernel: one table for both ways.
inline constexpr Word<SrdoCause> kCauseWords[] = {
    {"none", SrdoCause::kNone},
    {"length", SrdoCause::kLength},
    {"inverse_first", SrdoCause::kInverseFirst},
    {"normal_twice", SrdoCause::kNormalTwice},
    {"not_inverse", SrdoCause::kNotInverse},
    {"srvt", SrdoCause::kSrvt},
    {"sct", SrdoCause::kSct},
    {"identifier", SrdoCause::kIdentifier},
    {"queue_overflow", SrdoCause::kQueueOverflow},
    {"late_call", SrdoCause::kLateCall},
    {"not_operational", SrdoCause::kNotOperational},
    {"gfc", SrdoCause::kGfc},
    {"demoted", SrdoCause::kDemoted},
    {"transmit_queue", SrdoCause::kTransmitQueue},
    {"bus_off", SrdoCause::kBusOff},
    {"no_confirmation", SrdoCause::kNoConfirmation},
    {"refresh_missed", SrdoCause::kRefreshMissed},
    {"wrong_echo", SrdoCause::kWrongEcho},
    {"waiting_past_sct", SrdoCause::kWaitingPastSct},
};

inline constexpr Word<DeviceFault> kDeviceFaultWords[] = {
    {"none", DeviceFault::kNone},
    {"disagreement", DeviceFault::kDisagreement},
    {"unmatched", DeviceFault::kUnmatched},
    {"guard", DeviceFault::kGuard},
    {"configuration", DeviceFault::kConfiguration},
    {"comparator", DeviceFault::kComparator},
    {"flow", DeviceFault::kFlow},
    {"clock", DeviceFault::kClock},
    {"late_call", DeviceFault::kLateCall},
    {"frame_order", DeviceFault::kFrameOrder},
    {"application", DeviceFault::kApplication},
    {"self_test", DeviceFault::kSelfTest},
    {"handshake", DeviceFault::kHandshake},
    {"cross_link", DeviceFault::kCrossLink},
    {"output", DeviceFault::kOutput},
    {"latch_corrupted", DeviceFault::kInvalid},
};

inline constexpr Word<SrdoState> kStateWords[] = {
    {"off", SrdoState::kOff},           {"waiting", SrdoState::kWaiting},   {"faulted", SrdoState::kFaulted},
    {"producer", SrdoState::kProducer}, {"released", SrdoState::kReleased},
};

inline constexpr Word<NmtState> kNmtWords[] = {
    {"initialising", NmtState::kInitialising},
    {"pre_operational", NmtState::kPreOperational},
    {"stopped", NmtState::kStopped},
    {"operational", NmtState::kOperational},
};

inline constexpr Word<LogicOperation> kOperationWords[] = {
    {"copy", LogicOperation::kCopy},
    {"and", LogicOperation::kAnd},
    {"or", LogicOperation::kOr},
    {"not", LogicOperation::kNot},
};

/// The word for `meaning`; `otherwise` where the table has none.
template <typename Meaning, std::size_t kCount>
[[nodiscard]] constexpr const char* NameOf(const Word<Meaning> (&words)[kCount], const Meaning meaning,
                                           const char* const otherwise = "invalid") noexcept
{
    for (const Word<Meaning>& word : words)
    {
        if (word.meaning == meaning)
        {
            return word.text;
        }
    }
    return otherwise;
}

/// The word of a cause in files and outputs; so are the two below.
[[nodiscard]] inline const char* Name(const SrdoCause cause) noexcept
{
    return NameOf(kCauseWords, cause);
}
[[nodiscard]] inline const char* Name(const DeviceFault fault) noexcept
{
    return NameOf(kDeviceFaultWords, fault);
}
[[nodiscard]] inline const char* Name(const NmtState state) noexcept
{
    return NameOf(kNmtWords, state);
}

/// An object as text: "0x2000:01".
[[nodiscard]] std::string ObjectText(const ObjectAddress& object);
/// An identifier as text: "0x101".
[[nodiscard]] std::string IdentifierText(std::uint32_t identifier);
/// A time as text: "12.345 ms", without trailing zeros.
[[nodiscard]] std::string MillisecondsText(Nanoseconds time);
/// Why the kernel did not start, in words. [SRS_EASE_007]
[[nodiscard]] std::string NoStartText(StartResult result);
/// @brief A name as people read it: without underscores.
[[nodiscard]] std::string Words(std::string name);
} // namespace counterpoint::runtime

#endif // RUNTIME_DEVICE_NAMES_HPP
