// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_DIFFERENTIAL_REACHED_HPP
#define VERIFICATION_DIFFERENTIAL_REACHED_HPP

#include "safety_core/contract/channel.hpp"

#include <cstdint>

namespace counterpoint::differential
{

/// Everything of which a run must have seen at least one. [SRS_CNF_011]
enum class Item : std::uint8_t
{
    kAcceptedPair,
    kCommittedPair,
    kAutomaticRecovery,
    kInterlockRecovery,
    kAcknowledgedCause,
    kHeldPair,
    kConfirmedNormal,
    kInverseFrame,
    kSentPair,
    kPreparedReady,
    kPreparedUnequal,
    kPreparedNotProducer,
    kGuardConfigured,
    kGuardUnconfigured,
    kGuardStale,
    kStateOff,
    kStateWaiting,
    kStateFaulted,
    kStateProducer,
    kStateReleased,
    kCauseLength,
    kCauseInverseFirst,
    kCauseNormalTwice,
    kCauseNotInverse,
    kCauseSrvt,
    kCauseSct,
    kCauseIdentifier,
    kCauseQueueOverflow,
    kCauseLateCall,
    kCauseNotOperational,
    kCauseGfc,
    kCauseDemoted,
    kProducerNotInverse,
    kProducerTransmitQueue,
    kProducerBusOff,
    kProducerNoConfirmation,
    kProducerRefreshMissed,
    kProducerWrongEcho,
    kWaitingPastSct,
    kFaultDirection,
    kFaultTransmissionType,
    kFaultIdentifier,
    kFaultIdentifierInUse,
    kFaultTiming,
    kFaultMapping,
    kFaultLengthExceeded,
    kFaultSignature,
    kFaultTable,
    kFaultNone,
    kFaultDummy,
    kFaultShared,
    kSharedBySenders,
    kFaultFields,
    kLateSrvt,
    kLateSct,
    kLateReleased,
    kUnusedBit,
    kAcceptedBits,
    kAcceptedDummies,
    kAcceptedStatic,
    kAcceptedManyEntries,
    kSentBits,
    kSentStatic,
    kSentManyEntries,
    kDigest,
    kRefreshWaits,
    kRefreshInFlight,
    kCount, ///< Number of the items before.
};

constexpr std::uint8_t kItemCount = static_cast<std::uint8_t>(Item::kCount);

[[nodiscard]] const char* NameOf(Item item) noexcept;

class Reached
{
  public:
    void Add(Item item, std::uint32_t times = 1U) noexcept
    {
        counts_[static_cast<std::uint8_t>(item)] += times;
    }
    [[nodiscard]] std::uint64_t Count(Item item) const noexcept
    {
        return counts_[static_cast<std::uint8_t>(item)];
    }
    void AddState(SrdoState state) noexcept;
    void AddFault(ConfigFault fault) noexcept;
    void AddGuard(GuardView guard) noexcept;
    /// @brief Causes of one slot by the bits of SrdoView::signals.
    void AddSignals(std::uint32_t signals, bool is_producer) noexcept;
    /// @brief Items that were never reached.
    [[nodiscard]] std::uint32_t Missing() const noexcept;

  private:
    std::uint64_t counts_[kItemCount]{};
};

} // namespace counterpoint::differential

#endif
