// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_CROSSLINK_REMOTE_VOICE_HPP
#define SAFETY_CORE_CROSSLINK_REMOTE_VOICE_HPP

#include "safety_core/contract/channel.hpp"
#include "safety_core/crosslink/link_message.hpp"
#include "safety_core/crosslink/link_supervisor.hpp"
#include "safety_core/crosslink/offered_frames.hpp"
#include "safety_core/crosslink/own_voice.hpp"

#include <cstdint>

namespace counterpoint
{

/// Since when two things differ.
struct Difference
{
    Instant since;
    std::uint32_t is_open; ///< 0: they do not.
};

/// The channel that runs on the other CPU, as far as its messages tell: takes the absent channel's place in the kernel.
/// It decides nothing. Without contact it shows what the own channel holds, and releases nothing. In contact it shows
/// what the other CPU told; a pair that both hold has the ordinal of the own channel. [SRS_TWO_003, SRS_TWO_004,
/// SRS_TWO_005, SRS_TWO_006, SRS_TWO_007, SRS_TWO_008, SRS_TWO_009, SRS_TWO_010, SRS_TWO_011, SRS_TWO_012, SRS_TWO_013,
/// SRS_TWO_210, SRS_TWO_211, SRS_TWO_216,
/// SRS_TWO_019, SRS_TWO_150, SRS_TWO_151]
class RemoteVoice final : public Channel
{
  public:
    RemoteVoice(OwnVoice& own, const LinkConfig& config) noexcept;

    // As Channel says: what the other CPU told, in place of a computation; the configuration is that of the own
    // channel.
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
    [[nodiscard]] SrdoMask Commit(const Agreement& agreement, SrdoMask examine) noexcept override;
    [[nodiscard]] Permit Answer(std::uint32_t challenge) const noexcept override;
    [[nodiscard]] PreparedPair Prepare(SlotIndex slot) noexcept override;
    [[nodiscard]] Confirmation OnConfirm(const CanFrame& frame, Instant stamp) noexcept override;
    [[nodiscard]] CanFrame InverseFrame(SlotIndex slot) const noexcept override;
    void OnTransmitFault(SlotIndex slot, const TransmitFault& fault) noexcept override;

    /// @brief An intact message of the peer, received at `received`.
    void OnMessage(const LinkMessage& message, Instant received) noexcept;
    /// @brief What the other CPU has armed, and which of it was refused last.
    [[nodiscard]] const OfferedFrames& Offered() const noexcept
    {
        return offered_;
    }
    /// @brief The link on which the messages come.
    [[nodiscard]] LinkSupervisor& Link() noexcept
    {
        return link_;
    }
    /// @brief The same.
    [[nodiscard]] const LinkSupervisor& Link() const noexcept
    {
        return link_;
    }

  private:
    /// Last report about one slot, its moment by the own clock.
    struct Told
    {
        Window moment;
        SlotReport report;
    };

    /// @brief When that was, by the own clock, which the message taken last tells to be so many microseconds old.
    [[nodiscard]] Window WindowOf(std::uint32_t age_us) const noexcept;
    /// @brief A report of a message that was taken; its slot is checked here.
    void Keep(const SlotReport& report) noexcept;
    /// @brief In contact, and both CPUs said last that they are OPERATIONAL.
    [[nodiscard]] bool IsOperational() const noexcept;
    /// @brief One CPU holds a pair in this slot and the other one none: whether a discard explains it.
    [[nodiscard]] bool IsExcused(const Told& told, const HeldPair& own, SlotIndex slot) const noexcept;
    /// @brief Since when statement and digest of the other CPU differ from the own ones. Once a cycle.
    void CompareStatements(Instant now) noexcept;
    /// @brief One more look at a difference; `differs` is 0 where there is none. A new one is dated back to the cycle
    /// before.
    void Follow(Difference& difference, std::uint32_t differs) const noexcept;

    OwnVoice& own_;
    LinkConfig config_;
    LinkSupervisor link_{};
    Statement statement_{};
    DeviceDigest digest_{0U};
    SrdoMask released_{0U};    ///< By the message taken last.
    SrdoMask holding_{0U};     ///< Slots for which the last report holds a pair.
    SrdoMask told_faults_{0U}; ///< By the message taken last.
    SrdoMask new_faults_{0U};  ///< Not yet shown to the kernel.
    SrdoMask fresh_{0U};
    SrdoMask shown_{0U}; ///< Released in the last outcome.
    SrdoMask committed_{0U};
    SrdoMask checked_{0U}; ///< Slots with a check of the peer.
    Difference statements_{{0U}, 0U};
    Difference digests_{{0U}, 0U};
    Instant previous_{0U}; ///< `now` of the OnCycle before.
    std::uint32_t cycle_{0U};
    OfferedFrames offered_{};
    CanFrame normal_{};                   ///< The normal frame of an own producer that was on the bus last.
    CheckResult checks_[kMaxSrdoCount]{}; // MISRA D-001
    Told told_[kMaxSrdoCount]{};          // MISRA D-001
};

} // namespace counterpoint

#endif
