// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_COMPARATOR_COMPARATOR_HPP
#define SAFETY_CORE_COMPARATOR_COMPARATOR_HPP

#include "safety_core/comparator/slot_mask.hpp"
#include "safety_core/contract/channel.hpp"
#include "safety_core/contract/device_fault.hpp"

#include <cstdint>

namespace counterpoint
{

/// What one comparison looks at: what both voices say in one cycle. Everything is kept for the length of the call only.
struct Comparison
{
    const CycleOutcome* outcome_a;
    const CycleOutcome* outcome_b;
    const Channel* channel_a; ///< Asked for details only of slots that need a look.
    const Channel* channel_b;
    Instant now;         ///< The discrepancy time runs by counter A.
    std::uint32_t cycle; ///< What both outcomes must give as their cycle.
    std::uint32_t challenge;
};

/// What follows from one comparison. Zero-filled memory grants nothing.
struct Verdict
{
    Agreement agreement;
    SrdoMask demote;        ///< Slots that only one channel calls faulted: the kernel calls Demote in both channels.
    SrdoMask start;         ///< Producers that both channels call due.
    SrdoMask newly_matched; ///< Consumers whose new pair matched in this cycle.
    std::uint32_t echo;     ///< The challenge of the comparison. [SRS_CMP_001]
    DeviceFault fault;
    SlotIndex slot;
};

/// What follows from the two prepared pairs of one producer. Zero-filled memory is no permission. [SRS_CMP_010]
enum class PreparedVerdict : std::uint8_t
{
    kInvalid = 0U,
    kEqual = 0x69U,     ///< Same status, same frame.
    kNotInverse = 1U,   ///< The frames differ in their data alone: the objects of the two sides are not inverse.
    kDisagreement = 2U, ///< The channels differ in anything else.
};

/// How long the channels may differ, and how many slots there are. Both are checked by Kernel::Start.
struct ComparatorSetup
{
    std::uint32_t discrepancy_us; ///< Discrepancy time; at most 2^30 - 1 us.
    std::uint8_t slot_count;      ///< 1 to 64.
};

/// Decides whether the two channels say the same. Owns the discrepancy time: for each slot since when it is unmatched.
/// Invariant: bit n of `watched_` is set exactly while slot n needs a look in the next comparison; `since_[n]` has a
/// meaning only then: the comparison before the first one that looked, since the difference may be as old as that.
class Comparator
{
  public:
    /// @brief Forgets every difference that was seen. Call it at each start of the kernel, before the first Compare.
    /// O(1)
    void Restart(const ComparatorSetup& setup) noexcept;
    /// @brief Compares both voices; call once a cycle. O(1) when nothing is new, else O(slots that need a look).
    /// [SRS_CMP_001, SRS_CMP_002, SRS_CMP_003, SRS_CMP_004, SRS_CMP_005, SRS_CMP_006, SRS_CMP_007, SRS_CMP_008]
    [[nodiscard]] Verdict Compare(const Comparison& comparison) noexcept;
    /// @brief Compares status and every member of the frame. [SRS_CMP_010]
    [[nodiscard]] static PreparedVerdict ComparePrepared(const PreparedPair& a, const PreparedPair& b) noexcept;

  private:
    void Look(const Comparison& comparison, SlotSet only, Verdict& verdict) noexcept;

    SrdoMask watched_{0U};
    SrdoMask known_{0U};     ///< What was watched before this comparison.
    SrdoMask fresh_{0U};     ///< Watched slots of which a channel has a new pair that was not matched yet.
    SrdoMask one_sided_{0U}; ///< Released or due in one channel alone, in this comparison.
    SrdoMask slots_{0U};     ///< Those that exist: nothing else is ever looked at.
    std::uint32_t discrepancy_us_{0U};
    Instant previous_{0U};           ///< `now` of the comparison before.
    Instant since_[kMaxSrdoCount]{}; // MISRA D-001
};

} // namespace counterpoint

#endif
