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
    HeldPair turned; ///< Bits of what channel B holds that the comparator's own test turns round; else all 0.
};

/// What follows from one comparison. Zero-filled memory grants nothing.
struct Verdict
{
    Agreement agreement;
    SrdoMask demote;        ///< Slots that the kernel demotes in both channels. [SRS_CMP_004, SRS_CMP_008, SRS_CMP_340]
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

/// How long the channels may differ, and how many slots there are. All of it is checked by Kernel::Start.
struct ComparatorSetup
{
    std::uint32_t discrepancy_us; ///< Discrepancy time; at most 2^30 - 1 us.
    std::uint32_t
        acknowledge_window_us; ///< How far apart both channels' acknowledge edges may be; at most 2^30 - 1 us.
    std::uint8_t slot_count;   ///< 1 to 64.
};

/// In which slots the channels differ in one respect, and since when. Invariant: `since_[n]` has a meaning only while
/// bit n of `open_` or `known_` is set.
class Differences
{
  public:
    /// @brief No slot differs. `limit_us` is at most 2^30 - 1; Kernel::Start has checked it.
    void Restart(const std::uint32_t limit_us) noexcept
    {
        limit_us_ = limit_us;
        open_ = 0U;
        known_ = 0U;
    }
    /// @brief A comparison begins: the slots that differed in the one before; none does yet in this one.
    [[nodiscard]] SrdoMask Renew() noexcept
    {
        known_ = open_;
        open_ = 0U;
        return known_;
    }
    /// @brief Slots that differ in this comparison.
    void Open(const SrdoMask slots) noexcept
    {
        open_ |= slots;
    }
    /// @brief These were dealt with: they no longer count as different.
    void Close(const SrdoMask slots) noexcept
    {
        open_ &= ~slots;
    }
    /// @brief Slots that differ, as far as this comparison has got.
    [[nodiscard]] SrdoMask Slots() const noexcept
    {
        return open_;
    }
    /// @brief Whether a difference that began at `begun`, if it is a new one, is older than the limit.
    [[nodiscard]] bool IsOver(const SlotSet only, const Instant begun, const Instant now) noexcept
    {
        const SlotIndex slot = LowestOf(only);
        if ((known_ & only.mask) == 0U)
        {
            since_[slot] = begun; // MISRA D-002
        }
        return (now.us - since_[slot].us) > limit_us_; // MISRA D-002
    }

  private:
    SrdoMask open_{0U};
    SrdoMask known_{0U}; ///< What was open in the comparison before.
    std::uint32_t limit_us_{0U};
    Instant since_[kMaxSrdoCount]{}; // MISRA D-001
};

/// Decides whether the two channels say the same, and for how long they may not. A pair, or a due mark, of one channel
/// alone has the discrepancy time; a release of one alone the acknowledge window, each with a start of its own.
class Comparator
{
  public:
    /// @brief Forgets every difference that was seen. Call it at each start of the kernel, before the first Compare.
    /// O(1)
    void Restart(const ComparatorSetup& setup) noexcept;
    /// @brief Compares both voices; call once a cycle. O(1) when nothing is new, else O(slots that need a look).
    /// [SRS_CMP_001, SRS_CMP_002, SRS_CMP_003, SRS_CMP_004, SRS_CMP_005, SRS_CMP_006, SRS_CMP_007, SRS_CMP_008,
    /// SRS_CMP_150, SRS_CMP_214, SRS_CMP_215, SRS_CMP_216, SRS_CMP_217, SRS_CMP_250, SRS_CMP_251, SRS_CMP_341]
    [[nodiscard]] Verdict Compare(const Comparison& comparison) noexcept;
    /// @brief A comparison that counts for nothing: what differs, and since when, stays as it was. [SRS_CMP_212]
    [[nodiscard]] Verdict Try(const Comparison& comparison) const noexcept
    {
        Comparator copy{*this};
        return copy.Compare(comparison);
    }
    /// @brief Slots whose release the last Compare found agreed, none of them one that it demotes; none where it found
    /// what both voices must say alike to be unequal. [SRS_CMP_360]
    [[nodiscard]] SrdoMask Agreed() const noexcept
    {
        return agreed_;
    }
    /// @brief Slots in which the last Compare left nothing different: what its verdict calls matched, from the
    /// differences themselves. [SRS_CMP_011]
    [[nodiscard]] SrdoMask Matched() const noexcept
    {
        return ~(pairs_.Slots() | releases_.Slots());
    }
    /// @brief Compares status and every member of the frame; prepared pairs and inverse frames alike. [SRS_CMP_010,
    /// SRS_KRN_014]
    [[nodiscard]] static PreparedVerdict ComparePrepared(const PreparedPair& a, const PreparedPair& b) noexcept;

  private:
    /// @brief One slot that may differ: in what it holds, its due mark, its release, which is `is_pending` where it is
    /// one channel's alone, in this comparison or until then. Faults and what is demoted go into the verdict.
    void Look(const Comparison& comparison, SlotSet only, bool is_pending, Verdict& verdict) noexcept;

    Differences pairs_{};    ///< Ordinals, the fact of holding a pair, or due marks differ.
    Differences releases_{}; ///< Released or faulted in one channel alone.
    SrdoMask agreed_{0U};    ///< By the last comparison.
    SrdoMask fresh_{0U};     ///< Slots of which a channel has a new pair that was not matched yet.
    SrdoMask slots_{0U};     ///< Those that exist: nothing else is ever looked at.
    Instant previous_{0U};   ///< `now` of the comparison before.
};

} // namespace counterpoint

#endif
