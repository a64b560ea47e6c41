// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_PRODUCER_HPP
#define CHANNEL_A_PRODUCER_HPP

#include "channel_a/voice.hpp"
#include "safety_core/contract/can_frame.hpp"
#include "safety_core/contract/channel.hpp"
#include "safety_core/contract/srdo.hpp"
#include "safety_core/contract/time.hpp"

#include <cstddef>

// Pairs of producers: when they are due, what is sent, and what became of it.
namespace counterpoint::channel_a
{

/// Active producers of which the OnCycle that runs says something.
struct Asked
{
    SrdoMask requested; ///< [SRS_PROD_003]
    SrdoMask standing;  ///< [SRS_PROD_012]
};

/// @brief A producer in a cycle: confirmation, refresh, request, acknowledge.
void ServeProducer(Voice& voice, std::size_t slot, const Asked& asked) noexcept;
[[nodiscard]] PreparedPair PreparePair(Voice& voice, std::size_t slot) noexcept;
/// @brief The inverse of what was read while its confirmation is awaited, else an empty frame. [SRS_PROD_006]
[[nodiscard]] CanFrame InverseOf(const Voice& voice, std::size_t slot) noexcept;
[[nodiscard]] Confirmation ConfirmFrame(Voice& voice, const CanFrame& frame, Instant stamp) noexcept;
/// @brief A fault that gives up the pair in flight; nothing where there is none. [SRS_PROD_009]
void GiveUp(Voice& voice, std::size_t slot, SrdoCause cause) noexcept;

} // namespace counterpoint::channel_a

#endif
