// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_CONSUMER_HPP
#define CHANNEL_A_CONSUMER_HPP

#include "channel_a/voice.hpp"
#include "safety_core/contract/can_frame.hpp"
#include "safety_core/contract/time.hpp"

#include <cstddef>
#include <cstdint>

// Frames of consumers, the pairs that come of them, and what a cycle does with these.
namespace counterpoint::channel_a
{

/// @brief A frame from the bus, whatever it is. [SRS_CONS_001]
void TakeFrame(Voice& voice, const CanFrame& frame, Instant stamp) noexcept;
/// @brief A consumer in a cycle: limits, other causes, then report or release. Returns what else is to be signalled.
[[nodiscard]] std::uint32_t ServeConsumer(Voice& voice, std::size_t slot) noexcept;
/// @brief The other channel has reported a fault. [SRS_REL_006]
void DemoteConsumer(Voice& voice, std::size_t slot) noexcept;

} // namespace counterpoint::channel_a

#endif
