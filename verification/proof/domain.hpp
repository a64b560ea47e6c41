// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_PROOF_DOMAIN_HPP
#define VERIFICATION_PROOF_DOMAIN_HPP

#include "safety_core/contract/channel.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::proof
{

/// Times of the consumer that is explored: SRVT is one cycle, SCT two, so that stamps on the call and a microsecond
/// behind it, and calls on time and a microsecond late, lie on and beside both limits.
constexpr std::uint32_t kCycleUs = 1000U;
constexpr std::uint32_t kToleranceUs = 1U;
constexpr std::uint32_t kSrvtUs = 1000U;
constexpr std::uint32_t kSctUs = 2000U;
constexpr std::uint32_t kWindowUs = 1000U; ///< Of the acknowledge.
constexpr std::uint8_t kSafe = 0xA5U;

/// How the consumer is set up.
struct ConsumerSetup
{
    ReleasePolicy policy;
    SrvtDetection detection;
};

enum class Act : std::uint8_t
{
    kNormal,
    kInverse,
    kGfc,
    kCall,
};

/// One input. A frame comes `after_us` behind the last call, a call so long behind the last one.
struct Letter
{
    std::string text;
    Act act;
    std::uint32_t after_us;
    // Of a frame.
    std::uint8_t value; ///< The pair's; the inverse frame carries its complement.
    std::uint8_t length;
    FrameKind kind;
    // Of a call.
    bool is_acknowledged;
    bool is_operational;
    bool is_intact;
    bool is_demoted; ///< By the kernel, between the channels' call and their writing.
};

/// A set of letters, all sequences of which are looked at.
struct Domain
{
    std::string name;
    std::vector<Letter> letters;
};

/// @brief "timing", "frames", "calls" and "all".
[[nodiscard]] std::vector<Domain> MakeDomains();

} // namespace counterpoint::proof

#endif
