// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_CROSSLINK_OWN_SENDING_HPP
#define SAFETY_CORE_CROSSLINK_OWN_SENDING_HPP

#include "safety_core/contract/channel.hpp"
#include "safety_core/crosslink/armed_frames.hpp"

#include <cstdint>

namespace counterpoint
{

/// What the own channel prepares to send, in step with the other CPU: the leader is due and tells it, the follower
/// prepares what the leader is due for and arms it. [SRS_TWO_010, SRS_TWO_011, SRS_TWO_012, SRS_TWO_212,
/// SRS_TWO_213]
class OwnSending
{
  public:
    OwnSending(Channel& channel, PeerRole role) noexcept;

    /// @brief Nothing is due, stands still or is armed; there was no message.
    void Restart() noexcept;
    /// @brief Whether this CPU runs channel B.
    [[nodiscard]] bool IsFollower() const noexcept
    {
        return role_ == PeerRole::kB;
    }
    /// @brief Due slots of the leader that the follower still has to prepare.
    [[nodiscard]] SrdoMask Wanted() const noexcept
    {
        return peer_due_ & ~armed_.Slots();
    }
    /// @brief Slots whose schedule stands in the next cycle; none in the leader.
    [[nodiscard]] SrdoMask Standing() const noexcept
    {
        return standing_ | armed_.Slots();
    }
    /// @brief Takes the channel's due slots of this cycle; returns those that the kernel is shown.
    [[nodiscard]] SrdoMask Show(SrdoMask due, Instant now) noexcept;
    /// @brief Due slots that are not prepared yet.
    [[nodiscard]] SrdoMask Due() const noexcept
    {
        return due_;
    }
    /// @brief Prepare as the kernel calls it, of a slot that Show has shown. The leader prepares now; the follower has
    /// prepared already and gives no frame, only how that ended.
    [[nodiscard]] PreparedPair Prepare(SlotIndex slot) noexcept;
    /// @brief The follower's Prepare, called by the remote voice, which the kernel asks first.
    [[nodiscard]] PreparedPair PrepareAhead(SlotIndex slot) noexcept;
    /// @brief What the channel answered to the last Prepare.
    [[nodiscard]] PrepareStatus Status() const noexcept
    {
        return status_;
    }
    /// @brief A message was taken that tells these slots due, composed within this window.
    void TakeDue(SrdoMask due, const Window& composed) noexcept;
    /// @brief The leader gave up what was armed: the channel gives it up for the same cause.
    void TakeRefusal(const Refusal& refusal, Instant at) noexcept;
    /// @brief What the follower has prepared and awaits from the leader; nothing in the leader.
    [[nodiscard]] ArmedFrames& Armed() noexcept
    {
        return armed_;
    }

  private:
    Channel& channel_;
    ArmedFrames armed_{};
    SrdoMask due_{0U};
    SrdoMask peer_due_{0U};
    SrdoMask contact_{0U}; ///< All bits once a message was taken.
    SrdoMask standing_{0U};
    Instant now_{0U}; ///< Of the last cycle.
    PrepareStatus status_{PrepareStatus::kInvalid};
    PeerRole role_;
};

} // namespace counterpoint

#endif
