// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_CROSSLINK_OWN_VOICE_HPP
#define SAFETY_CORE_CROSSLINK_OWN_VOICE_HPP

#include "safety_core/contract/channel.hpp"
#include "safety_core/crosslink/armed_frames.hpp"
#include "safety_core/crosslink/link_message.hpp"
#include "safety_core/crosslink/link_supervisor.hpp"

#include <cstdint>

namespace counterpoint
{

/// Stands between kernel and the one real channel of a CPU: passes every call on, notes what the peer has to be told,
/// and names pairs by the moment of their inverse frame on the bus. [SRS_TWO_001, -002, -004]
///
/// Invariant: while a channel holds a pair, that pair's inverse frame is the newest frame with the slot's COB-ID 2 as
/// of the OnCycle that first showed it fresh: any other frame with that identifier would have been a fault.
class OwnVoice final : public Channel
{
  public:
    OwnVoice(Channel& channel, PeerRole role) noexcept;

    void Restart(const DeviceConfig& config) noexcept override;
    void Store(const ConfigItem& item) noexcept override;
    [[nodiscard]] ConfigItem Load(const ConfigAddress& address) const noexcept override;
    [[nodiscard]] ChannelRoom Room() const noexcept override;
    void SetFields(SlotIndex slot, const StaticFields& fields) noexcept override;
    [[nodiscard]] DeviceDigest Digest(SlotIndex slot, DeviceDigest before) const noexcept override;
    [[nodiscard]] CheckResult Validate(SlotIndex slot) noexcept override;
    [[nodiscard]] CheckResult Recheck(SlotIndex slot) noexcept override;
    void OnFrame(const CanFrame& frame, Instant stamp) noexcept override;
    [[nodiscard]] CycleOutcome OnCycle(const CycleInput& input) noexcept override;
    [[nodiscard]] HeldPair Held(SlotIndex slot) const noexcept override;
    [[nodiscard]] SrdoView View(SlotIndex slot) const noexcept override;
    void Demote(SlotIndex slot) noexcept override;
    void Commit(const Agreement& agreement) noexcept override;
    [[nodiscard]] Permit Answer(std::uint32_t challenge) const noexcept override;
    [[nodiscard]] PreparedPair Prepare(SlotIndex slot) noexcept override;
    [[nodiscard]] Confirmation OnConfirm(const CanFrame& frame, Instant stamp) noexcept override;
    [[nodiscard]] CanFrame InverseFrame(SlotIndex slot) noexcept override;
    void OnTransmitFault(SlotIndex slot, const TransmitFault& fault) noexcept override;

    /// @brief The follower's Prepare, called by the remote voice, which the kernel asks first. [SRS_TWO_011]
    [[nodiscard]] PreparedPair PrepareAhead(SlotIndex slot) noexcept;
    /// @brief What the channel answered to the last Prepare.
    [[nodiscard]] const PreparedPair& Prepared() const noexcept
    {
        return prepared_;
    }
    /// @brief A message was taken that tells these slots due, composed within this window.
    void TakeDue(SrdoMask due, const Window& composed) noexcept;
    /// @brief The leader gave up what was armed: the channel gives it up for the same cause. [SRS_TWO_012]
    void TakeRefusal(const Refusal& refusal, Instant at) noexcept;
    /// @brief Due slots of the leader that the follower still has to prepare.
    [[nodiscard]] SrdoMask Wanted() const noexcept
    {
        return peer_due_ & ~armed_.Slots();
    }
    [[nodiscard]] ArmedFrames& Armed() noexcept
    {
        return armed_;
    }

    /// @brief What the channel said in the last OnCycle, prepared slots no longer due.
    [[nodiscard]] const CycleOutcome& Outcome() const noexcept
    {
        return outcome_;
    }
    [[nodiscard]] Statement Said() const noexcept;
    [[nodiscard]] const DeviceConfig& Config() const noexcept
    {
        return *config_;
    }
    [[nodiscard]] SrdoMask Consumers() const noexcept
    {
        return outcome_.released | outcome_.faulted | outcome_.waiting;
    }
    /// @brief Consumers with a new pair or a discard since the last call.
    [[nodiscard]] SrdoMask TakeNews() noexcept;
    /// @brief New faults since the last call.
    [[nodiscard]] SrdoMask TakeFaults() noexcept;
    /// @brief What the peer is told of an active consumer.
    [[nodiscard]] SlotReport Report(SlotIndex slot, Instant now) const noexcept;
    [[nodiscard]] const SlotCheck& LastCheck() const noexcept
    {
        return check_;
    }
    [[nodiscard]] DeviceDigest LastDigest() const noexcept
    {
        return digest_;
    }
    /// @brief Whether the held pair, and no other, lies in the window. [SRS_TWO_002]
    [[nodiscard]] bool IsPair(SlotIndex slot, const Window& window) const noexcept;
    /// @brief Moment of the held pair's inverse frame, and of the last discard.
    [[nodiscard]] Instant PairAt(SlotIndex slot) const noexcept;
    [[nodiscard]] Instant DiscardedAt(SlotIndex slot) const noexcept;
    /// @brief Slot of an active producer or consumer with this identifier; kNoSlot if there is none.
    [[nodiscard]] SlotIndex SlotOfFrame(const CanFrame& frame) const noexcept;

  private:
    struct Moments
    {
        Instant newest; ///< Newest inverse frame on the bus.
        Instant former; ///< The one before it.
        Instant pair;   ///< Both as of the held pair.
        Instant before;
        Instant discarded; ///< Nothing that was complete then is held.
    };

    void Register(SlotIndex slot) noexcept;
    void Discard(SrdoMask slots, Instant at) noexcept;
    void Sweep(Instant now) noexcept;
    void NoteOutcome(const CycleOutcome& outcome, Instant now) noexcept;
    [[nodiscard]] bool IsFollower() const noexcept
    {
        return role_ == PeerRole::kB;
    }

    Channel& channel_;
    const DeviceConfig* config_;
    ArmedFrames armed_{};
    CycleOutcome outcome_{};
    PreparedPair prepared_{};
    SrdoMask news_{0U};
    SrdoMask faults_{0U};
    SrdoMask peer_due_{0U};
    SrdoMask contact_{0U}; ///< All bits once a message was taken.
    SrdoMask standing_{0U};
    Instant now_{0U};
    SlotCheck check_{kNoSlot, {ConfigFault::kInvalid, 0U}};
    DeviceDigest digest_{0U};  ///< Of the last whole sweep.
    DeviceDigest running_{0U}; ///< Of the slots below swept_.
    PeerRole role_;
    SlotIndex swept_{0U};
    Moments moments_[kMaxSrdoCount]{};   // MISRA D-001
    SlotIndex slot_of_[kMaxSrdoCount]{}; // MISRA D-001
};

} // namespace counterpoint

#endif
