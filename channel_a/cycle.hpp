// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_CYCLE_HPP
#define CHANNEL_A_CYCLE_HPP

#include "channel_a/voice.hpp"
#include "safety_core/contract/channel.hpp"

#include <cstdint>

// One cycle, and after it what the comparator's verdict makes of it.
namespace counterpoint::channel_a
{

[[nodiscard]] CycleOutcome RunCycle(Voice& voice, const CycleInput& input) noexcept;
/// @brief Objects of the consumers by the agreement; then reads what it wrote and what is to be examined. The slots of
/// which an object holds something else. [SRS_REL_002, SRS_REL_011]
[[nodiscard]] SrdoMask CommitPairs(Voice& voice, const Agreement& agreement, SrdoMask examine) noexcept;
[[nodiscard]] Permit PermitFor(const Voice& voice, std::uint32_t challenge) noexcept;

} // namespace counterpoint::channel_a

#endif
