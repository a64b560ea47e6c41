// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_CROSSLINK_OFFERED_FRAMES_HPP
#define SAFETY_CORE_CROSSLINK_OFFERED_FRAMES_HPP

#include "safety_core/crosslink/link_message.hpp"

#include <cstdint>

namespace counterpoint
{

/// What the follower has armed, as the message taken last tells the leader, and what became of it here.
/// [SRS_TWO_214, SRS_TWO_215]
class OfferedFrames
{
  public:
    /// @brief Nothing is offered, used or refused.
    void Restart() noexcept;
    /// @brief What a message offers that the supervisor has taken: all of it in place of what was offered before. What
    /// was used stays used. The slots are looked at by Due.
    void Take(const LinkMessage& message) noexcept;
    /// @brief Slots with a frame that was not used.
    [[nodiscard]] SrdoMask Due() const noexcept;
    /// @brief The frame of this slot, used from now on; all 0 if there is none.
    [[nodiscard]] CanFrame Use(SlotIndex slot) noexcept;
    /// @brief The frame that this slot offers is refused for this cause, from the next message on; no effect if it
    /// offers none.
    void GiveUp(SlotIndex slot, SrdoCause cause) noexcept;
    /// @brief What the message tells of the armed frame given up last.
    [[nodiscard]] const Refusal& Refused() const noexcept
    {
        return refusal_;
    }

  private:
    struct Place
    {
        ArmedFrame armed;
        std::uint8_t used; ///< Number of the frame that was used last from here; 0: none.
    };

    Place places_[kArmedCount]{}; // MISRA D-001
    Refusal refusal_{0U, SrdoCause::kNone};
};

} // namespace counterpoint

#endif
