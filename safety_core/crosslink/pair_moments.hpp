// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_CROSSLINK_PAIR_MOMENTS_HPP
#define SAFETY_CORE_CROSSLINK_PAIR_MOMENTS_HPP

#include "safety_core/crosslink/link_supervisor.hpp"

#include <cstdint>

namespace counterpoint
{

/// Names the pair that a consumer holds by the moment of its inverse frame on the bus, and tells when the consumer last
/// discarded one. [SRS_TWO_002, SRS_TWO_004]
///
/// Invariant: while a channel holds a pair, that pair's inverse frame is the newest frame with the slot's COB-ID 2 as
/// of the OnCycle that first showed it fresh: any other frame with that identifier would have been a fault.
class PairMoments
{
  public:
    /// @brief Forgets the identifiers.
    void Restart() noexcept;
    /// @brief From now on the slot has this COB-ID 1, and the next identifier as COB-ID 2.
    void Register(SlotIndex slot, std::uint32_t cob_id_1) noexcept;
    /// @brief Slot of an active producer or consumer with this identifier; kNoSlot if there is none.
    [[nodiscard]] SlotIndex SlotOfFrame(const CanFrame& frame) const noexcept;
    /// @brief A frame was on the bus at `stamp`.
    void OnFrame(const CanFrame& frame, Instant stamp) noexcept;
    /// @brief The held pairs of these slots are the ones whose inverse frame came last.
    void Complete(SrdoMask fresh) noexcept;
    /// @brief At `at` these slots discarded what they held.
    void Discard(SrdoMask slots, Instant at) noexcept;
    /// @brief Keeps an old discard old: without it the counter would come round and make it look new. [SRS_TWO_015]
    void LimitAge(SlotIndex slot, Instant now) noexcept;
    /// @brief Whether the held pair, and no other, lies in the window. [SRS_TWO_002]
    [[nodiscard]] bool IsPair(SlotIndex slot, const Window& window) const noexcept;
    /// @brief Moment of the held pair's inverse frame.
    [[nodiscard]] Instant PairAt(SlotIndex slot) const noexcept;
    /// @brief Moment of the last discard.
    [[nodiscard]] Instant DiscardedAt(SlotIndex slot) const noexcept;

  private:
    struct Moments
    {
        Instant newest; ///< Newest inverse frame on the bus.
        Instant former; ///< The one before it.
        Instant pair;   ///< Both as of the held pair.
        Instant before;
        Instant discarded; ///< Nothing that was complete then is held.
    };

    Moments moments_[kMaxSrdoCount]{};   // MISRA D-001
    SlotIndex slot_of_[kMaxSrdoCount]{}; // MISRA D-001
};

} // namespace counterpoint

#endif
